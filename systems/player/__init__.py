"""The player's part of a tick: the pilot's commands and the camera that follows (DESIGN 3)."""
