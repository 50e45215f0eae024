"""Chance: named, counter-based and even."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from components import chance
from components.arrays import Float64s

words = st.integers(0, 2**62)

EXPECTED = (2391539541053276776, 15269700372269452719)

CRITICAL = 148.2
"""Chi-square of 99 degrees of freedom that one even stream in a thousand passes."""


def _draws(stream: int, seed: int = 1, ticks: int = 100, ids: int = 100) -> Float64s:
    return np.array([chance.uniform(seed, stream, t, i) for t in range(ticks) for i in range(ids)])


@given(words, words, words, words)
def test_a_draw_is_named_by_its_four_words_alone(
    seed: int, stream: int, tick: int, identity: int
) -> None:
    first = chance.uniform(seed, stream, tick, identity)
    chance.uniform(seed, stream, tick, identity + 1)
    assert chance.uniform(seed, stream, tick, identity) == first
    assert 0.0 <= first < 1.0
    others = {
        chance.uniform(seed ^ 1, stream, tick, identity),
        chance.uniform(seed, stream ^ 1, tick, identity),
        chance.uniform(seed, stream, tick ^ 1, identity),
        chance.uniform(seed, stream, tick, identity ^ 1),
    }
    assert first not in others


@pytest.mark.parametrize("stream", [chance.WANDER, chance.PLACE, chance.SEGMENT])
def test_draws_are_even(stream: int) -> None:
    counts = np.histogram(_draws(stream), bins=100, range=(0.0, 1.0))[0]
    assert ((counts - 100.0) ** 2 / 100.0).sum() < CRITICAL


def test_neighbours_in_tick_and_id_are_unrelated() -> None:
    table = _draws(chance.WANDER).reshape(100, 100) - 0.5
    for a, b in ((table[1:], table[:-1]), (table[:, 1:], table[:, :-1])):
        pairs = np.histogram2d(a.ravel(), b.ravel(), bins=10, range=[(-0.5, 0.5)] * 2)[0]
        assert ((pairs - 99.0) ** 2 / 99.0).sum() < CRITICAL


def test_every_stream_has_a_name_of_its_own() -> None:
    names = [name for name in vars(chance) if name.isupper()]
    values = {getattr(chance, name) for name in names}
    assert len(values) == len(names) >= 5
    assert abs(np.corrcoef(_draws(chance.WANDER), _draws(chance.PLACE))[0, 1]) < 0.04


def test_the_first_draws_are_the_ones_replays_were_made_with() -> None:
    assert int(chance.draw(0, 0, 0, 0)) == EXPECTED[0]
    assert int(chance.draw(7, chance.SEGMENT, 3, 100)) == EXPECTED[1]
