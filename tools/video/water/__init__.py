"""Into the water: from a fish's filmed motion to a species that can be played (papers/000, 9.1; FINDINGS 4).

The motion comes as a `Film` (film.py); what goes out is a repertoire (components/repertoire_file.py) and the text of a
species file. Nothing here opens a clip but colours.py.
"""
