"""What a species, a level and a mod may say: the pydantic models of each file kind (DESIGN 6)."""
