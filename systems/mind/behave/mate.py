"""Mating: the courtship of papers/004 in four phases, danced by the two, each for itself.

Looping: the male circles, rising and sinking, about the female, who hovers, bobs and watches. Circling: both follow
each other's tail about their middle. Spawning ascent: they rise swiftly side by side. Nuzzling: the male nudges her
belly from below. As in the thesis they swim after points that move along these paths. A phase ends when it has lasted
and the partner is in it too, or has gone on; who is left alone gives up.
"""

from math import sqrt
from typing import Final

from components.arrays import Float64s
from components.kernels import inlined, row
from components.mind import Courtship
from systems.mind.behave.chase_target import chase_target
from systems.mind.behave.pace import pace
from systems.mind.crowd import Crowd

NONE: Final = int(Courtship.NONE)
LOOPING: Final = int(Courtship.LOOPING)
CIRCLING: Final = int(Courtship.CIRCLING)
ASCENT: Final = int(Courtship.ASCENT)
NUZZLING: Final = int(Courtship.NUZZLING)

MATED: Final = 5
"""Returned in the place of a phase: it is done."""

JILTED: Final = 6
"""Returned in the place of a phase: the partner never came, or has left."""

LASTS: Final = (0, 420, 420, 300, 420)
"""[ticks] that each phase lasts at least."""

PATIENCE: Final = 900
"""[ticks] for which a fish courts one that does not answer, and twice as long swims after it."""

_MEET: Final = 3.0
_LOST: Final = 12.0
_SURFACED: Final = 90
_COSINE: Final = 0.64
_SINE: Final = 0.7684
_LOOP: Final = 1.4
_TILT: Final = 0.45
_CIRCLE: Final = 0.9
_STEEP: Final = 1.2
_ABREAST: Final = 0.6
_BELLY: Final = 0.25
_REACH: Final = 0.3
_NUDGE_TICKS: Final = 45
_NUDGE: Final = 0.35


@inlined
def _next_phase(phase: int, lasted: int, partner_phase: int, far: float, surfaced: bool) -> int:
    """Return the phase that follows, `MATED` or `JILTED`; `far`: the partner's distance [BL]."""
    if phase == NONE:
        if far < _MEET:
            return LOOPING
        return JILTED if lasted > 2 * PATIENCE else NONE
    if partner_phase == NONE:
        if phase == NUZZLING and lasted > _SURFACED:
            return MATED
        return JILTED if lasted > PATIENCE else phase
    if far > _LOST and phase < ASCENT:
        return NONE
    done = lasted >= LASTS[phase] or (phase == ASCENT and surfaced and lasted >= _SURFACED)
    if partner_phase == phase + 1 or (done and partner_phase >= phase):
        return phase + 1
    return phase


@inlined
def _swim_round(
    x: float, y: float, z: float, radius: float, tilt: float, way: float, out: Float64s
) -> None:
    """Write the offset to the next point on the circle about the offset (x, y, z), (3,), tilted along x."""
    size = sqrt(x * x + y * y) + 1e-9
    u, v = -x / size, -y / size
    u, v = _COSINE * u - way * _SINE * v, _COSINE * v + way * _SINE * u
    out[0], out[1], out[2] = x + radius * u, y + radius * v, z + tilt * radius * u


@inlined
def _nuzzle(
    crowd: Crowd,
    me: int,
    other: int,
    speeds: Float64s,
    now: int,
    x: float,
    y: float,
    z: float,
    out: Float64s,
) -> tuple[int, float, float]:
    """Nudge the belly of the one at the offset (x, y, z), and sink back, in turn."""
    length, hers = crowd.length[me], crowd.length[other]
    back = _NUDGE * hers * ((now // _NUDGE_TICKS) & 1)
    out[0] = x - _REACH * length * crowd.hx[me] - back * crowd.hx[me]
    out[1] = y - _REACH * length * crowd.hy[me] - back * crowd.hy[me]
    out[2] = z - _BELLY * hers - back
    gap = sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2])
    ahead = out[0] * crowd.hx[me] + out[1] * crowd.hy[me] + out[2] * crowd.hz[me]
    gear, throttle = pace(speeds, length, 2.5 * (ahead if gap < length else gap))
    out[0], out[1] = out[0] + 0.5 * x, out[1] + 0.5 * y
    return gear, 0.5, throttle


@inlined
def _rise(
    crowd: Crowd, me: int, other: int, x: float, y: float, z: float, out: Float64s
) -> tuple[int, float, float]:
    """Rise beside the one at the offset (x, y, z), as steeply as fishes swim, the way that the elder faces."""
    length = crowd.length[me]
    lead = me if crowd.id[me] < crowd.id[other] else other
    far = sqrt(x * x + y * y + z * z) + 1e-9
    ahead = (x * crowd.hx[lead] + y * crowd.hy[lead] + z * crowd.hz[lead]) / length
    pull = 0.0 if lead == me else (far - _ABREAST * length) / (far * length)
    out[0] = crowd.hx[lead] + pull * x
    out[1] = crowd.hy[lead] + pull * y
    level = sqrt(out[0] * out[0] + out[1] * out[1])
    out[2] = _STEEP * level + 0.6 * pull * z
    return 2, 0.7, min(max(1.0 + 0.5 * ahead, 0.3), 1.2)


@row
def mate(
    crowd: Crowd,
    me: int,
    other: int,
    male: bool,
    phase: int,
    since: int,
    partner_phase: int,
    speeds: Float64s,
    now: int,
    high: float,
    out: Float64s,
) -> tuple[int, float, float, int]:
    """Write the wanted direction, (3,); return gear, urgency, throttle and the phase from now on.

    `phase` began in the tick `since`; `partner_phase` is NONE where the partner at `other` courts somebody else or
    nobody; `high` [m]: highest z that the species likes. Instead of a phase come `MATED` or `JILTED` at the end.
    """
    length = crowd.length[me]
    x, y, z = (
        crowd.x[other] - crowd.x[me],
        crowd.y[other] - crowd.y[me],
        crowd.z[other] - crowd.z[me],
    )
    far = sqrt(x * x + y * y + z * z) / length
    surfaced = crowd.z[me] > high - length
    phase = _next_phase(phase, now - since, partner_phase, far, surfaced)
    way = 1.0 if (crowd.id[me] + crowd.id[other]) & 1 else -1.0
    if phase == ASCENT:
        gear, urgency, throttle = _rise(crowd, me, other, x, y, z, out)
    elif phase == CIRCLING:
        _swim_round(0.5 * x, 0.5 * y, 0.5 * z, _CIRCLE * length, 0.0, way, out)
        gear, throttle = pace(speeds, length, 0.8 * speeds[1] * length)
        urgency = 0.6
    elif phase == LOOPING and male:
        radius = _LOOP * 0.5 * (length + crowd.length[other])
        _swim_round(x, y, z, radius, _TILT, way, out)
        gear, throttle = pace(speeds, length, 0.9 * speeds[1] * length)
        urgency = 0.5
    elif phase == LOOPING:
        bob = 0.2 if (now // 40) & 1 else -0.2
        out[0], out[1], out[2] = x + 0.1 * crowd.hx[me], y + 0.1 * crowd.hy[me], bob * far * length
        gear, urgency, throttle = 0, 0.3, 0.1
    elif phase == NUZZLING and male:
        gear, urgency, throttle = _nuzzle(crowd, me, other, speeds, now, x, y, z, out)
    elif phase == NUZZLING:
        out[0], out[1], out[2] = crowd.hx[me], crowd.hy[me], 0.1
        gear, urgency, throttle = 0, 0.3, 0.1
    else:
        s = crowd.speed[other]
        gear, urgency, throttle = chase_target(
            crowd, me, speeds, x, y, z, s * crowd.hx[other], s * crowd.hy[other],
            s * crowd.hz[other], 0.4, out,
        )  # fmt: skip
    return gear, urgency, throttle, phase
