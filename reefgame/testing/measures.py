"""Measures of behaviour, by name: each takes what was seen, a group and a second one or None, and returns a number.

They look at places, courses and what a fish does, never at a private constant of its mind, and return NaN, which meets
no expectation, where what they measure did not happen.
"""

from collections.abc import Callable
from typing import Final, TypeAlias

import numpy as np

from components.arrays import AnyArray, Float64s, Int64s
from components.clock import TICKS_PER_SECOND
from components.mind import Courtship, Intention
from reefgame.testing.bodies import overlapping
from reefgame.testing.observation import SAMPLE_EVERY, Observation

Measure: TypeAlias = Callable[[Observation, str, str | None], float]

NEIGHBOURS: Final = 8
"""The nearest fishes that make a pair with each."""

_RATE: Final = TICKS_PER_SECOND / SAMPLE_EVERY
_FLIGHT: Final = 0.8
"""Speed away from the predator, over that in fast gear, that is flight."""
_LINK_BL: Final = 4.0
"""[BL] between neighbours of one school."""
_WHOLE: Final = 0.9
"""Share of the fishes in its largest part from which a school is one."""
_PASSAGE_S: Final = 2.0
"""[s] before and after the closest approach of a predator in which a school may part."""


def fed_share(o: Observation, of: str, _: str | None) -> float:
    """Return the share of the group that ate."""
    return float((o.ate_at[:, o.of(of)].max(axis=0) > o.seconds[0] * TICKS_PER_SECOND).mean())


def survivors_share(o: Observation, of: str, _: str | None) -> float:
    """Return the share of the group that still lives."""
    return float(np.isfinite(o.position[-1, o.of(of), 0]).mean())


def flight_distance_m(o: Observation, of: str, to: str | None) -> float:
    """Return how near [m] the second group's nearest fish was when each began to flee; the median over the group.

    Flight is to swim away from it with four fifths of the speed of the fast gear, half a second long.
    """
    here, there = o.position[:, o.of(of)], o.position[:, o.of(_given(to))]
    way = here[:, :, None] - there[:, None]
    far = np.linalg.norm(way, axis=3)
    far = np.where(np.isnan(far), np.inf, far)
    nearest = far.argmin(axis=2)
    out = np.take_along_axis(way, nearest[:, :, None, None], axis=2)[:, :, 0]
    apart = np.take_along_axis(far, nearest[:, :, None], axis=2)[:, :, 0]
    velocity = np.diff(here, axis=0) * _RATE
    away = (velocity * out[:-1]).sum(axis=2) / apart[:-1]
    flees: AnyArray = _lasting(away > _FLIGHT * o.fast[o.of(of)], 5)
    began, fled = flees.argmax(axis=0), flees.sum(axis=0) > 0
    return float(np.median(apart[began, np.arange(here.shape[1])][fled])) if fled.any() else np.nan


def _lasting(true: AnyArray, samples: int) -> AnyArray:
    """Return where (T, N) begins to be true for so many samples."""
    out = np.zeros_like(true)
    last = len(true) - samples + 1
    if last > 0:
        out[:last] = np.all([true[k : k + last] for k in range(samples)], axis=0)
    return out


def nearest_neighbour_bl(o: Observation, of: str, _: str | None) -> float:
    """Return the distance from each fish to the nearest of its group [BL]; the median over fishes and time."""
    apart = _apart(o, of)
    return float(np.nanmedian(apart.min(axis=2) / o.length[o.of(of)]))


def polarisation(o: Observation, of: str, _: str | None) -> float:
    """Return the length of the group's mean heading, 0 to 1; the median over time."""
    heading = o.rotation[:, o.of(of)][:, :, :, 0]
    return float(np.median(np.linalg.norm(np.nanmean(heading, axis=1), axis=1)))


def largest_part(o: Observation, of: str, _: str | None) -> float:
    """Return the share of the group in its largest part, within four lengths of one another; the least over time."""
    return float(_largest_parts(o, of).min())


def parted_share(o: Observation, of: str, to: str | None) -> float:
    """Return how the group parts as the second one's fish comes through: the share on the side where fewer are.

    It is the best of the moments about the closest approach; 0.5 is even.
    """
    at, around = _passage(o, of, _given(to))
    predator = o.of(_given(to))[0]
    best = 0.0
    for t in range(*around):
        offset = o.position[t, o.of(of)] - o.position[t, predator]
        side = o.rotation[at, predator, :, 2]
        left = float((offset @ side > 0.0).mean())
        best = max(best, min(left, 1.0 - left))
    return best


def berth_m(o: Observation, of: str, to: str | None) -> float:
    """Return the radius [m] of the room that the group leaves round the second one's fish as it comes through.

    About its body's axis, a tenth of the group may be nearer; the mean over the second about the closest approach.
    """
    at, _ = _passage(o, of, _given(to))
    predator, mine = o.of(_given(to))[0], o.of(of)
    half = round(0.5 * _RATE)
    rooms = []
    for t in range(max(at - half, 0), min(at + half + 1, len(o.seconds))):
        offset = o.position[t, mine] - o.position[t, predator]
        axis = o.rotation[t, predator, :, 0]
        reach = o.box[predator, 0]
        along = np.clip(offset @ axis - o.middle[predator], -reach, reach) + o.middle[predator]
        rooms.append(np.nanpercentile(np.linalg.norm(offset - along[:, None] * axis, axis=1), 10))
    return float(np.mean(rooms))


def rejoined_s(o: Observation, of: str, to: str | None) -> float:
    """Return how long [s] after the closest approach of the second group's fish the group is one again, for good."""
    at, _ = _passage(o, of, _given(to))
    apart = np.flatnonzero(_largest_parts(o, of)[at:] < _WHOLE)
    if len(apart) == 0:
        return 0.0
    last = at + int(apart[-1])
    return float(o.seconds[last + 1] - o.seconds[at]) if last + 1 < len(o.seconds) else np.nan


def _passage(o: Observation, of: str, to: str) -> tuple[int, tuple[int, int]]:
    """Return the sample of the closest approach of a group's first fish to a group's middle, and those about it."""
    middle = np.nanmean(o.position[:, o.of(of)], axis=1)
    at = int(np.argmin(np.linalg.norm(middle - o.position[:, o.of(to)[0]], axis=1)))
    wide = round(_PASSAGE_S * _RATE)
    return at, (max(at - wide, 0), min(at + wide + 1, len(o.seconds)))


def _apart(o: Observation, of: str) -> Float64s:
    """Return the distances [m] within a group, (T, n, n), infinite to itself."""
    place = o.position[:, o.of(of)]
    apart = np.linalg.norm(place[:, :, None] - place[:, None], axis=3)
    apart[:, np.arange(place.shape[1]), np.arange(place.shape[1])] = np.inf
    return np.where(np.isnan(apart), np.inf, apart)


def _largest_parts(o: Observation, of: str) -> Float64s:
    """Return the share of the living of a group in its largest part, (T,)."""
    linked = _apart(o, of) < _LINK_BL * o.length[o.of(of)].mean()
    lives = np.isfinite(o.position[:, o.of(of), 0])
    return np.array([_largest(link, alive) for link, alive in zip(linked, lives, strict=True)])


def _largest(linked: AnyArray, lives: AnyArray) -> float:
    reached = linked | np.diag(lives)
    for _ in range(int(np.ceil(np.log2(max(len(lives), 2))))):
        reached = (reached.astype(np.float32) @ reached.astype(np.float32)) > 0.0
    return float(reached.sum(axis=1).max() / max(lives.sum(), 1))


def hunted_share(o: Observation, of: str, to: str | None) -> float:
    """Return the share of its hunt that the group spends on the second one and not on others; NaN without a hunt."""
    focus = o.focus[:, o.of(of)]
    hunts = (o.intention[:, o.of(of)] == Intention.EAT) & (focus >= 0)
    chosen = np.isin(focus, o.id[o.of(_given(to))])
    return float(chosen[hunts].mean()) if hunts.any() else np.nan


def phases_danced(o: Observation, of: str, _: str | None) -> float:
    """Return how many of the four phases of courtship two of the group dance together, in their order."""
    phase = o.courtship[:, o.of(of)]
    danced = 0
    began = 0
    for one in (Courtship.LOOPING, Courtship.CIRCLING, Courtship.ASCENT, Courtship.NUZZLING):
        together = np.flatnonzero((phase[began:] == one).sum(axis=1) >= 2)
        if len(together) == 0:
            break
        began += int(together[0])
        danced += 1
    return float(danced)


def mated_share(o: Observation, of: str, _: str | None) -> float:
    """Return the share of the group whose courtship came to its end."""
    danced = (o.courtship[:, o.of(of)] == Courtship.NUZZLING).any(axis=0)
    since = o.mated_at[:, o.of(of)]
    return float((danced & (since[-1] > since[0])).mean())


def rise_m(o: Observation, of: str, _: str | None) -> float:
    """Return how far [m] the group rises in the spawning ascent, the mean over its fishes; NaN without one."""
    rises = []
    for fish in o.of(of):
        high = o.position[o.courtship[:, fish] == Courtship.ASCENT, fish, 2]
        rises.append(high[-1] - high[0] if len(high) else np.nan)
    return float(np.mean(rises))


def submarine_m(o: Observation, of: str, _: str | None) -> float:
    """Return how near [m] to the submarine each of the group came; the median over its fishes."""
    return float(np.median(np.nanmin(_from_submarine(o, of), axis=0)))


def at_submarine_share(o: Observation, of: str, _: str | None) -> float:
    """Return the share of time for which a fish of the group is within six metres of the submarine."""
    return float((np.nanmin(_from_submarine(o, of), axis=1) < 6.0).mean())


def _from_submarine(o: Observation, of: str) -> Float64s:
    away: Float64s = np.linalg.norm(o.position[:, o.of(of)] - o.submarine[:, None], axis=2)
    return away


def stray_m(o: Observation, of: str, _: str | None) -> float:
    """Return how far [m] from the nearest home point the group is found, at most for 95 % of its time."""
    way = o.position[:, o.of(of), None] - o.terrain.home[None, None, :, :3]
    return float(np.nanpercentile(np.linalg.norm(way, axis=3).min(axis=2), 95))


def went_m(o: Observation, of: str, _: str | None) -> float:
    """Return how far [m] each of the group is in the end from where it was; the median over its fishes."""
    place = o.position[:, o.of(of)]
    return float(np.nanmedian(np.linalg.norm(place[-1] - place[0], axis=1)))


def turns_round(o: Observation, of: str, _: str | None) -> float:
    """Return how often each of the group went round the world's middle, against the clock from above; the median."""
    x, y = o.position[:, o.of(of), 0], o.position[:, o.of(of), 1]
    turns = np.unwrap(np.arctan2(y, x), axis=0) / (2.0 * np.pi)
    return float(np.nanmedian(turns[-1] - turns[0]))


def inside_m(o: Observation, of: str, _: str | None) -> float:
    """Return how deep [m] a fish's origin was in ground or rock, or out of the water, in any tick; 0 for never."""
    return max(0.0, -float(np.nanmin(o.clear[:, o.of(of)])))


def touching_share(o: Observation, of: str, _: str | None) -> float:
    """Return the share of the group's time spent held off ground, rocks, rim and surface by what is in its way.

    There its origin is within half its length of them, at most .9 m, nearer than which nobody comes.
    """
    room = np.minimum(0.5 * o.length[o.of(of)], 0.9) * 1.02
    clear = o.clear[:, o.of(of)]
    return float((clear < room)[np.isfinite(clear)].mean())


def overlap_share(o: Observation, of: str, _: str | None) -> float:
    """Return the share of pairs of neighbours whose bodies interpenetrate, once a second, the mean over time.

    Pairs: each fish of the group with its eight nearest, whatever their group. Bodies: boxes along the body's axes, as
    long as the fish and as high and wide as it is at its thickest, which is more than the body fills.
    """
    shares = []
    mine = set(o.of(of).tolist())
    for t in range(0, len(o.seconds), round(_RATE)):
        alive = np.flatnonzero(np.isfinite(o.position[t, :, 0]))
        pairs = [pair for pair in _pairs(o.position[t, alive]) if alive[pair[0]] in mine]
        first, second = (alive[list(side)] for side in zip(*pairs, strict=True))
        shares.append(overlapping(o, t, first, second).mean())
    return float(np.mean(shares))


def _pairs(place: Float64s) -> list[tuple[int, int]]:
    """Return each pair of fishes of which one is among the other's nearest, once."""
    apart = np.linalg.norm(place[:, None] - place[None], axis=2)
    near: Int64s = np.argsort(apart, axis=1, kind="stable")[:, 1 : NEIGHBOURS + 1]
    found = {(min(i, j), max(i, j)) for i, row in enumerate(near.tolist()) for j in row}
    return sorted(found)


def speed_bl(o: Observation, of: str, _: str | None) -> float:
    """Return the group's speed [BL/s], the median over fishes and time."""
    velocity = np.linalg.norm(np.diff(o.position[:, o.of(of)], axis=0), axis=2) * _RATE
    return float(np.nanmedian(velocity / o.length[o.of(of)]))


def _given(to: str | None) -> str:
    if to is None:
        raise ValueError("this measure needs a second group: say `to`")
    return to


MEASURES: Final[dict[str, Measure]] = {
    measure.__name__: measure
    for measure in (
        at_submarine_share, berth_m, fed_share, flight_distance_m, hunted_share, inside_m,
        largest_part, mated_share, nearest_neighbour_bl, overlap_share, parted_share,
        phases_danced, polarisation, rejoined_s, rise_m, speed_bl, stray_m, submarine_m,
        survivors_share, touching_share, turns_round, went_m,
    )
}  # fmt: skip
"""Every measure by its name, as scenes name it."""
