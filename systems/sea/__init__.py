"""The water and what bends in it: flow fields, fibres and plankton (Aliaga and Larboulette 2009)."""
