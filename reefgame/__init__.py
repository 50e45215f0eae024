"""The game: content, world, schedule, loop, replay, screens and the command line (DESIGN 1)."""
