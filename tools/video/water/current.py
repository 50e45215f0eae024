"""A fish that holds station, seen from the water: a steady current runs against it (FINDINGS 4, Into the water).

Where it cruises, its stride is assumed and the current is what takes that back. Where it turns, it is the same current
that carries it off: what the picture shows and the current together are its way through the water.
"""

from dataclasses import replace

import numpy as np

from tools.video.water.beats import Bout
from tools.video.water.cycle import Cycle
from tools.video.water.film import Film, angles, places, weights


def in_water(film: Film, cruise: Cycle, bout: Bout) -> Film:
    """Return the film as a camera that drifts with the current would have seen it; `cruise` is the bout's."""
    span = slice(bout.first, bout.stop)
    pointing = float((angles(film)[span] @ weights(film)).mean())
    seconds = np.arange(len(film.axis)) / film.rate
    shown = np.polyfit(seconds[span], places(film)[span], 1)[0]
    through = cruise.speed * np.array([np.cos(pointing), np.sin(pointing)])
    carried = film.length * seconds[:, None] * (through - shown)
    return replace(film, axis=film.axis + carried[:, None, :])
