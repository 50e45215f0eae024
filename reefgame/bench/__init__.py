"""Benches, one file each, both sides of every ratio measured in one interleaved run (DESIGN 8)."""
