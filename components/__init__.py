"""What things are: plain arrays and dataclasses, and the small kernels that define them (DESIGN 1)."""
