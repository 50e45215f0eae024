"""The levels of the base game: data only, read through importlib.resources."""
