"""Synthetic motion capture: a simulated fish swims and its clean cycles become a repertoire."""
