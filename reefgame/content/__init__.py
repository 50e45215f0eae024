"""How species, levels and mods come in: YAML with marks, strict checks (DESIGN 6)."""
