"""Bodies and swims that cannot be simulated, and what is likely at fault where a simulation blows up.

Content is checked against narrower limits before it comes here (reefgame/content/schema/species.py); this guards the
capture itself, which tuning and studies call with numbers of their own.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from math import inf, isfinite
from typing import Final

from components.body import Body, Swim
from systems.motor import controllers
from systems.motor.muscle_model import body_model
from tools.capture.record import BlewUpError, record

THINNEST: Final = 0.001
"""[BL] of half a width or height, and of the gap between two stations ..."""

WIDEST: Final = 1.0
"""[BL] ... and the most of half a width or height."""

_Far = tuple[float, float, float]

_PLAIN: Final = Body(
    station=(0.12, 0.29, 0.47, 0.65, 0.8),
    half_width=(0.042, 0.060, 0.056, 0.040, 0.018),
    half_height=(0.100, 0.150, 0.150, 0.110, 0.045),
    tail_span=0.12,
)
_CALM: Final = Swim(0.3, 0.5, 140.0, 2.5)


def check(body: Body, swim: Swim) -> None:
    """Raise ValueError, one line that names a number and what is allowed, where body or swim cannot be simulated."""
    for name, number, least, most in _limits(body, swim):
        if not (isfinite(number) and least <= number <= most):
            raise ValueError(f"{name} is {number:g}, allowed is {least:g} to {most:g}")
    for before, after in pairwise((0.0, *body.station, 1.0)):
        if not after - before >= THINNEST:
            raise ValueError(
                f"stations must rise from nose to tail: {after:g} does not follow {before:g}"
            )


def _limits(body: Body, swim: Swim) -> Iterator[tuple[str, float, float, float]]:
    """Yield each number's name, the number, and the least and most that it may be."""
    for ring in range(len(body.station)):
        yield f"station {ring + 1}", body.station[ring], 0.0, 1.0
        yield f"half_width {ring + 1}", body.half_width[ring], THINNEST, WIDEST
        yield f"half_height {ring + 1}", body.half_height[ring], THINNEST, WIDEST
    yield "tail_span", body.tail_span, THINNEST, WIDEST
    yield "stiffness", body.stiffness, 1e-3, 1e3
    yield "contraction_middle", swim.contraction_middle, 0.0, 1.0
    yield "contraction_rear", swim.contraction_rear, 0.0, 1.0
    yield "lag_deg", swim.lag_deg, -360.0, 360.0
    yield "frequency_hz", swim.frequency_hz, 0.1, 15.0


def suspect(body: Body, swim: Swim, frames: int) -> str:
    """Return what is likely at fault, in the words of a species file, where `frames` frames of the swim blow up.

    One thing after another, that farthest from what is ordinary first, is set to what is: the first that tames the
    swim is named.
    """
    for _, advice, tamer_body, tamer_swim in sorted(
        _tamer(body, swim), key=lambda tried: -tried[0]
    ):
        try:
            record(body_model(tamer_body, tamer_swim), controllers.swim(tamer_swim), frames)
        except BlewUpError:
            continue
        return advice
    return "body and swim are far from any fish, begin with those of a species that swims"


def _tamer(body: Body, swim: Swim) -> Iterator[tuple[float, str, Body, Swim]]:
    """Yield how extreme something is, advice on it, and body and swim that follow the advice."""
    for name, tamer in (
        ("half_width", replace(body, half_width=_PLAIN.half_width)),
        ("half_height", replace(body, half_height=_PLAIN.half_height)),
        ("tail_span", replace(body, tail_span=_PLAIN.tail_span)),
    ):
        far, size, usual = _farthest(getattr(body, name), getattr(_PLAIN, name))
        wrong = "thin, its mass too small" if size < usual else "large, its mass too great"
        yield far, f"{name} {size:g} is too {wrong}", tamer, swim
    gaps = [after - before for before, after in pairwise((0.0, *body.station, 1.0))]
    far = _extreme(min(gaps), 0.11)
    yield (
        far,
        f"stations {min(gaps):g} BL apart are too close",
        replace(body, station=_PLAIN.station),
        swim,
    )
    wrong = "stiff" if body.stiffness > 1.0 else "soft"
    far = _extreme(body.stiffness, 1.0)
    yield far, f"stiffness {body.stiffness:g} is too {wrong}", replace(body, stiffness=1.0), swim
    hz = swim.frequency_hz
    wrong = "high" if hz > _CALM.frequency_hz else "low"
    calm = replace(swim, frequency_hz=_CALM.frequency_hz)
    yield _extreme(hz, _CALM.frequency_hz), f"frequency_hz {hz:g} is too {wrong}", body, calm
    most = max(swim.contraction_middle, swim.contraction_rear)
    calm = replace(_CALM, lag_deg=swim.lag_deg, frequency_hz=hz)
    yield _extreme(most, _CALM.contraction_rear), f"contraction {most:g} is too large", body, calm


def _farthest(found: float | tuple[float, ...], usual: float | tuple[float, ...]) -> _Far:
    """Return how extreme the most extreme of some sizes is, that size, and what is usual there."""
    sizes = found if isinstance(found, tuple) else (found,)
    ordinary = usual if isinstance(usual, tuple) else (usual,)
    return max((_extreme(s, u), s, u) for s, u in zip(sizes, ordinary, strict=True))


def _extreme(found: float, usual: float) -> float:
    """Return how many times a number is what it usually is, or the other way about."""
    ratio = abs(found) / usual
    return max(ratio, 1.0 / ratio) if ratio > 0.0 else inf
