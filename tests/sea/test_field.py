"""The flow of papers/002, eqs. 1-5: against the equations in numpy, where they break, and over all parameters."""

from types import ModuleType

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from components.arrays import Float64s
from components.field import field_of, flow, pack
from components.singularity import SingularityKind, SingularityTable
from systems.sea.fibres_numba import flow_at

PHI, MOST = 7.0, 3.0
CENTRE = np.array([0.3, -0.2, 1.1])
AXIS = np.array([0.6, 0.0, 0.8])
POINTS = np.random.default_rng(3).uniform(-4.0, 4.0, (200, 3))
LOCAL = [SingularityKind.SOURCE, SingularityKind.HOLE, SingularityKind.WHIRLWIND]


def _flow(table: SingularityTable, points: Float64s = POINTS, tick: int = 0) -> Float64s:
    return np.array([flow(field_of(table), tick, *map(float, point)) for point in points])


def _equations(kind: SingularityKind, points: Float64s = POINTS) -> Float64s:
    """Return eqs. 2-4 as the paper prints them, [m/s], (n, 3)."""
    q = points - CENTRE
    way = np.cross(q, AXIS) if kind == SingularityKind.WHIRLWIND else q
    way = way / np.linalg.norm(way, axis=1, keepdims=True)
    sign = -1.0 if kind == SingularityKind.HOLE else 1.0
    return np.asarray(sign * PHI / (PHI / MOST + (q**2).sum(1))[:, None] * way)


@pytest.mark.parametrize("kind", LOCAL)
@pytest.mark.parametrize("reach", [np.inf, 12.0])
def test_flow_is_the_papers_where_the_window_is_open(
    bed: ModuleType, kind: SingularityKind, reach: float
) -> None:
    table = bed.singularity(kind, CENTRE, PHI, MOST, reach, 0.0, AXIS)
    assert np.linalg.norm(POINTS - CENTRE, axis=1).max() < 12.0 * np.sqrt(0.5)
    assert np.abs(_flow(table) - _equations(kind)).max() < 1e-12


def test_a_current_goes_in_waves_of_space_and_time(bed: ModuleType) -> None:
    table = bed.singularity(SingularityKind.DIRECTIONAL, intensity=0.5, axis=AXIS)
    table.amplitude[0], table.wave_number[0] = 0.4, 0.25
    table.frequency[0], table.phase[0] = 0.5, 0.1
    for tick in (0, 37, 100_003):
        turns = (0.25 * POINTS @ AXIS + 0.1 - 0.5 * tick / 60.0) % 1.0
        wanted = 0.5 * (1.0 + 0.4 * np.sin(2.0 * np.pi * turns))[:, None] * AXIS
        assert np.abs(_flow(table, tick=tick) - wanted).max() < 1e-12
    assert np.abs(_flow(table, tick=120) - _flow(table)).max() < 1e-12


def test_the_middle_of_two_equal_sources_is_still(bed: ModuleType) -> None:
    table = bed.singularity(SingularityKind.SOURCE, (-1.0, 0.5, 2.0), PHI, MOST, softening=0.0)
    table.append(1)
    for name in table.columns:
        getattr(table, name)[1] = getattr(table, name)[0]
    table.position[1] = (3.0, 0.5, -1.0)
    assert flow(field_of(table), 0, 1.0, 0.5, 0.5) == (0.0, 0.0, 0.0)
    assert flow(field_of(table), 0, 1.0, 0.5, 0.7) != (0.0, 0.0, 0.0)


def test_a_source_with_its_sign_turned_is_a_hole(bed: ModuleType) -> None:
    hole = bed.singularity(SingularityKind.HOLE, CENTRE, PHI, MOST, 3.0, 0.1)
    turned = bed.singularity(SingularityKind.SOURCE, CENTRE, -PHI, MOST, 3.0, 0.1)
    assert np.array_equal(_flow(hole), _flow(turned))
    assert np.abs(_flow(hole)).max() > 0.1


def test_nothing_is_felt_from_the_reach_on_and_nothing_jumps(bed: ModuleType) -> None:
    table = bed.singularity(SingularityKind.SOURCE, (0.0, 0.0, 0.0), PHI, MOST, 2.0, 0.0)
    away = np.linspace(0.01, 3.0, 3_000)
    speed = _flow(table, np.stack([away, 0.0 * away, 0.0 * away], axis=1))[:, 0]
    open_speed = PHI / (PHI / MOST + away**2)
    assert (speed[away >= 2.0] == 0.0).all()
    assert np.abs(speed - open_speed)[away < 1.41].max() < 1e-12
    assert (speed[away < 2.0] > 0.0).all()
    assert np.abs(np.diff(speed)).max() < 1e-2


finite = st.floats(allow_nan=False, allow_infinity=False)


@given(
    st.sampled_from(SingularityKind),
    st.tuples(finite, finite, finite),
    finite,
    st.floats(0.0, 1e300),
    st.floats(0.0, allow_nan=False),
    st.floats(0.0, 1e150),
    st.tuples(st.floats(-1e3, 1e3), st.floats(-1e3, 1e3), st.floats(-1e3, 1e3)),
    st.integers(0, 10_000_000),
)
@example(SingularityKind.SOURCE, (0.0, 0.0, 0.0), 1e308, 1.0, np.inf, 0.0, (0.0, 0.0, 0.0), 0)
@example(SingularityKind.WHIRLWIND, (0.0, 0.0, 0.0), 5.0, 1.0, 1.0, 0.0, (0.0, 0.0, 0.1), 0)
@example(SingularityKind.HOLE, (0.0, 0.0, 0.0), 0.0, 0.0, 0.0, 0.0, (0.0, 0.0, 0.0), 0)
def test_flow_is_finite_whatever_the_singularity(
    bed: ModuleType,
    kind: SingularityKind,
    position: tuple[float, float, float],
    intensity: float,
    most: float,
    reach: float,
    softening: float,
    point: tuple[float, float, float],
    tick: int,
) -> None:
    table = bed.singularity(kind, position, intensity, most, reach, softening)
    assert np.isfinite(flow(field_of(table), tick, *point)).all()
    packed = pack(table, tick)
    assert np.isfinite(np.delete(packed, 3, 1)).all()
    near: list[float] = list(np.array(point, np.float32))
    assert np.isfinite(flow_at(packed, np.zeros(1, np.int32), 0, 1, *near)).all()


@pytest.mark.parametrize("broken", [np.nan, np.inf, -np.inf])
def test_what_is_not_finite_is_switched_off_for_fibres(bed: ModuleType, broken: float) -> None:
    for name in ("position", "intensity", "axis", "softening", "most"):
        table = bed.singularity(SingularityKind.SOURCE, intensity=1.0)
        getattr(table, name)[0] = broken
        packed = pack(table, 0)
        assert np.isfinite(np.delete(packed, 3, 1)).all()


def test_fibres_feel_the_flow_that_fishes_feel(bed: ModuleType) -> None:
    table = bed.water()
    packed, every = pack(table, 90), np.arange(table.count, dtype=np.int32)
    points = POINTS / 4.0
    single: list[list[float]] = [list(point) for point in points.astype(np.float32)]
    felt = [flow_at(packed, every, 0, len(every), *point)[:3] for point in single]
    assert np.abs(np.array(felt) - _flow(table, points, 90)).max() < 1e-4
