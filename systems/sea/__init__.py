"""The water and what bends in it: fields, fibres, plankton (Aliaga and Larboulette 2009)."""
