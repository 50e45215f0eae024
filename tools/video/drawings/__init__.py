"""Draws the models that ship with the game, by code: run `python -m tools.video.drawings DIR` (papers/003, fig. 7)."""
