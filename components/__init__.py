"""What things are: plain arrays and dataclasses, and the small kernels that define them (DESIGN 1).

Nothing here knows a system, a window or a file of YAML. Systems read and write these tables;
`reefgame` builds them from content; snapshots, checksums and replays walk them.
"""
