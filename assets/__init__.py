"""Species, repertoires and textures of the base game: data, read through importlib.resources."""
