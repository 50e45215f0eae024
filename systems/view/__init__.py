"""What is drawn and how: culling and draw calls (DESIGN 5); no other system imports pyglet."""
