"""Retargeting one frame to models of the paper's sizes, beside its Table 3 (papers/003, section 7)."""

from collections.abc import Iterator
from time import perf_counter
from typing import Final

import numpy as np

from reefgame.bench.case import Case

PAPER_MS: Final = {
    "carp": 1.11, "cartoon": 1.23, "whale": 7.78, "mermaid": 1.45, "flower": 2.08, "lobster": 2.02,
}  # fmt: skip
"""Motion retargeting of Table 3 [ms]."""
_FRAMES: Final = 120


def measure_retargeting() -> Iterator[Case]:
    """Yield the median time of one frame's retargeting for each model, the paper's as baseline."""
    from tools.video.retarget.choose import target_from
    from tools.video.retarget.example import example_motion
    from tools.video.retarget.retarget import Retargeting

    motion = example_motion(_FRAMES)
    for name, paper in PAPER_MS.items():
        play = Retargeting(target_from(name), motion)
        spent = np.empty(_FRAMES)
        for frame in range(_FRAMES):
            start = perf_counter()
            play.vertices(frame)
            spent[frame] = perf_counter() - start
        vertices = len(play.target.vertices)
        value = 1000.0 * float(np.median(spent))
        bound = "<= 0.3" if name == "carp" else ""
        case = f"part=retarget model={name} vertices={vertices} against=paper"
        yield Case(case, value, "ms", paper, paper / value, bound)
