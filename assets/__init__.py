"""Species, repertoires and textures of the base game: data only, read through importlib.resources."""
