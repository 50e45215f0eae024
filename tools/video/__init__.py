"""From a clip of a fish to its motion (Meng et al. 2018, papers/003): needs the [video] extra, never a world."""
