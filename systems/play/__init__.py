"""The game's rules in a tick: feeding, spawning and judging objectives (DESIGN 3)."""
