"""How species, levels and mods come in: YAML with marks, strict checks, placed errors (DESIGN 6)."""
