"""A fish's mind: it perceives, feels, intends (Tu and Terzopoulos 1994; DESIGN 3)."""
