"""Axes lifted to the lattice of 23 nodes, and cycles to segments that loop (papers/000, 4.1)."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from components.body import Body, rest_nodes
from components.segment import Pattern, Segment, heading_change, mean_speed
from tools.capture.measure import CLOSURE_LIMIT
from tools.video.water.beats import bouts
from tools.video.water.cycle import cycle
from tools.video.water.film import Film
from tools.video.water.lattice import TOLERANCE, figures_of, loop_length, loop_of, nodes_of

FilmOf = Callable[..., Film]


@given(heading=st.floats(-3.1, 3.1), x=st.floats(-5.0, 5.0))
def test_a_straight_axis_gives_the_body_at_rest(
    body: Callable[[str], Body], heading: float, x: float
) -> None:
    back = -np.linspace(0.0, 1.0, 41)
    line = np.stack((x + back * np.cos(heading), back * np.sin(heading)), axis=-1)
    rest = rest_nodes(body("blue_tang"))
    left, up = -rest[:, 2], rest[:, 1]
    wanted = np.stack(
        (
            x + rest[:, 0] * np.cos(heading) - left * np.sin(heading),
            rest[:, 0] * np.sin(heading) + left * np.cos(heading),
            up,
        ),
        axis=-1,
    )
    np.testing.assert_allclose(nodes_of(line[None], body("blue_tang"))[0], wanted, atol=1e-12)


@given(st.floats(0.4, 14.0))
def test_a_loop_keeps_the_frequency(frequency: float) -> None:
    beats, entries = loop_length(frequency)
    assert 1 <= beats <= 12
    assert beats * 60 / entries == pytest.approx(
        frequency, rel=max(TOLERANCE, 0.02 * frequency / 14)
    )


def test_common_frequencies_loop_in_one_beat() -> None:
    assert [loop_length(f) for f in (4.0, 3.0, 1.0, 4.002)] == [(1, 15), (1, 20), (1, 60), (1, 15)]


@pytest.mark.parametrize("name", ["sardine", "reef_shark"])
def test_a_loop_is_the_captured_swim_again(
    film: FilmOf,
    body: Callable[[str], Body],
    segments: Callable[[str], dict[Pattern, Segment]],
    name: str,
) -> None:
    swim, shown = segments(name)[Pattern.SWIM_MEDIUM], film(name)
    found = cycle(shown, bouts(shown)[0])
    loop = loop_of(found, body(name), Pattern.SWIM_MEDIUM)
    assert loop.loops
    assert len(loop.shape) == len(swim.shape)
    assert abs(heading_change(loop)) < 1e-9
    assert mean_speed(loop) == pytest.approx(found.speed, rel=0.01)
    # A body that muscles swim is a few hundredths shorter than at rest: places along it differ by so much.
    assert np.abs(loop.shape - swim.shape)[..., 1:].max() < 0.03
    assert np.abs(loop.shape - swim.shape).max() < 0.07


def test_figures_are_those_of_the_cycle(film: FilmOf, body: Callable[[str], Body]) -> None:
    shown = film("sardine", rate=50.0)
    found = cycle(shown, bouts(shown)[0])
    figures = figures_of(found, body("sardine"))
    assert figures.frequency == pytest.approx(4.0, rel=0.01)
    assert figures.speed == pytest.approx(found.speed)
    assert figures.sweep == pytest.approx(found.sweep(), rel=1e-3)
    assert figures.closure < CLOSURE_LIMIT
    assert figures.strouhal == pytest.approx(found.sweep() / found.stride, rel=0.01)
    assert figures.faults() == []
