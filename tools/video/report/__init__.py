"""The report of a clip: what was seen in each frame, and what motion it makes."""
