"""What is drawn and how: culling and the draw calls (DESIGN 5); the only systems that import pyglet."""
