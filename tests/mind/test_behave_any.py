"""What every routine promises, wherever fishes are and even if they are all in one place."""

from types import ModuleType
from typing import TypeAlias

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from components.arrays import Float64s
from systems.mind.behave.avoid_fish import avoid_fish, avoid_submarine
from systems.mind.behave.avoid_static_obstacle import avoid_static_obstacle, choose_side
from systems.mind.behave.chase_target import chase_target
from systems.mind.behave.eat import eat
from systems.mind.behave.escape import escape
from systems.mind.behave.mate import JILTED, MATED, mate
from systems.mind.behave.pace import pace
from systems.mind.behave.school import heed, school
from systems.mind.behave.wander import visit

TANG = np.array([0.85, 1.64, 2.44])
Place: TypeAlias = tuple[float, float, float]
OFFSETS = st.one_of(
    st.just((0.0, 0.0, 0.0)),
    st.tuples(st.floats(-3.0, 3.0), st.floats(-3.0, 3.0), st.floats(-3.0, 3.0)),
)
WAYS = st.sampled_from([(1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (0.0, -0.8, 0.6), (0.6, 0.0, -0.8)])
SHARES = st.floats(0.0, 1.0, allow_subnormal=False)


def check(out: Float64s, demand: tuple[int, float, float]) -> None:
    gear, urgency, throttle = demand
    assert np.isfinite(out).all()
    assert gear in (0, 1, 2)
    assert 0.0 <= urgency <= 1.0
    assert -0.2 <= throttle <= 1.2


@given(OFFSETS, OFFSETS, WAYS, WAYS, SHARES, st.integers(0, 5), st.integers(0, 4000))
@settings(max_examples=60, deadline=None)
def test_demands_are_finite_and_in_range(
    tank: ModuleType, one: Place, two: Place, way: Place,
    other_way: Place, share: float, phase: int, now: int,
) -> None:  # fmt: skip
    scene = tank.Tank(
        np.array([(0.0, 0, 0), one, two]) - np.array([0, 0, 5.0]),
        np.array([way, other_way, way]),
        np.array([0.25, 0.3, 1.1]),
        np.array([TANG] * 3),
    )
    crowd, out = scene.crowd, scene.out
    crowd.speed[:] = (0.3 * share, 0.4, 2.0 * share)
    near, square = scene.nearest(0, np.arange(3))
    offset, (x, y, z) = np.array(one), one
    u, v, w = other_way
    check(out, chase_target(crowd, 0, TANG, x, y, z, u, v, w, share, out))
    for hunts in (False, True):
        gear, urgency, throttle, gape = eat(
            crowd, 0, TANG, x, y, z, u, v, w, 0.28, 0.35, share, hunts, now, out
        )
        check(out, (gear, urgency, throttle))
        assert 0.0 <= gape <= 1.0
    check(out, avoid_fish(crowd, 0, 1, 1.2 * share, out))
    check(out, avoid_submarine(crowd, 0, offset, 1.2 * share, out))
    side = choose_side(way[0], way[1], np.array(other_way), 0, 7)
    check(out, avoid_static_obstacle(way[0], way[1], way[2], np.array(other_way), share, side, out))
    check(out, visit(crowd, 0, TANG, offset, 3.5, now, out))
    shoal, danger = np.array([*one, *way]), np.zeros(7)
    check(
        out,
        escape(crowd, 0, near, 2, offset, share, np.array(two), phase > 2, shoal, 1.0, 3, now, out),
    )
    heed(two[0], two[1], two[2], share * u, share * v, share * w, 1.1, danger)
    check(
        out,
        school(
            crowd, 0, near, square, 2, shoal, 2.0, 0.3, 1.0, 1.0, -4.0, 1, share, danger,
            np.array(other_way), share, out,
        ),
    )  # fmt: skip
    for male in (False, True):
        gear, urgency, throttle, after = mate(
            crowd, 0, 1, male, min(phase, 4), 0, phase % 3, TANG, now, -1.0, out
        )
        check(out, (gear, urgency, throttle))
        assert after in (0, min(phase, 4), min(phase, 4) + 1, MATED, JILTED)


@given(st.floats(-3.0, 9.0), st.floats(0.05, 2.0))
@settings(deadline=None)
def test_pace_takes_the_lowest_gear_that_serves(wanted: float, length: float) -> None:
    gear, throttle = pace(TANG, length, wanted)
    assert -0.2 <= throttle <= 1.2
    if -0.2 < throttle < 1.2:
        assert np.isclose(throttle * TANG[gear] * length, wanted)
    assert gear == 0 or wanted > TANG[gear - 1] * length
