"""How species, levels and mods come in: YAML with marks, strict checks, errors with a place (DESIGN 6)."""
