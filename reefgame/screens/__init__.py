"""What a player sees and presses: title, dive, pause, options and result (DESIGN 5)."""
