"""The report of a capture: what a species' repertoire looks like and how it stands beside living fishes."""
