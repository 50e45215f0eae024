"""One edit of one angle on one frame, and how far its neighbours follow it (papers/003, eqs. 18 to 21).

Eq. 18 as printed, N = I (1 - f) M + f M', sends the edges of a reversed motion (I = 0) to an angle of 0, whatever the
rest pose is. Read from the rest pose M_0, as eqs. 19 and 20 are, it sends them there: N - M_0 = I (1 - f) (M - M_0) +
f (M' - M_0). For I = 1 the two are the same.
"""

from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s

_TURN: Final = 2.0 * np.pi


class Window(NamedTuple):
    """The frames that an edit reaches."""

    first: int
    "p"
    last: int
    "q, itself reached"


def deviation(values: Float64s, rest: float) -> Float64s:
    """Return how far an angle's course (T,) is from rest [rad], by whole turns as near to it as it can be."""
    away = values - rest
    return np.asarray(away - _TURN * np.round(np.median(away) / _TURN))


def window_of(away: Float64s, frame: int) -> Window:
    """Return p and q: between them `away` (T,) from rest stays on the side that it has at `frame` (eqs. 19, 20)."""
    other = away * away[frame] < 0.0
    before, after = np.flatnonzero(other[:frame]), np.flatnonzero(other[frame:])
    first = int(before[-1]) + 1 if len(before) else 0
    last = frame + int(after[0]) - 1 if len(after) else len(away) - 1
    return Window(first, last)


def influence(frame: int, window: Window) -> Float64s:
    """Return f of the window's frames: 1 at `frame`, falling to 0 at both ends by a parabola (eq. 21), (q - p + 1,)."""
    at = np.arange(window.first, window.last + 1, dtype=np.float64) - frame
    reach = np.where(at < 0.0, max(frame - window.first, 1), max(window.last - frame, 1))
    return np.asarray(1.0 - (at / reach) ** 2)


def edited(values: Float64s, rest: float, frame: int, value: float) -> tuple[Float64s, Window]:
    """Return an angle's course (T,) [rad] with `value` at `frame`, and the frames that followed.

    Where `value` lies on the other side of rest the motion is reversed, not adjusted: what it was no longer counts.
    """
    away = deviation(values, rest)
    window = window_of(away, frame)
    wanted = away[frame] + (value - values[frame] + np.pi) % _TURN - np.pi
    part = slice(window.first, window.last + 1)
    f = influence(frame, window)
    kept = 0.0 if wanted * away[frame] < 0.0 else 1.0
    changed = values.copy()
    changed[part] += kept * (1.0 - f) * away[part] + f * wanted - away[part]
    return changed, window
