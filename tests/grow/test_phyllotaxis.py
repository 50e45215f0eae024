"""Tentacles stand as Fowler et al. 1992 let primordia stand: counts of FINDINGS 9, none overlap, all on the disc."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tools.grow.phyllotaxis import phyllotaxis


@pytest.mark.parametrize(
    ("mouth", "base", "count"), [(18, 2.0, 199), (12, 1.6, 377), (14, 2.0, 218), (16, 3.0, 89)]
)
def test_the_four_anemones_have_their_number_of_tentacles(
    mouth: float, base: float, count: int
) -> None:
    assert abs(len(phyllotaxis(40.0, float(mouth), base)) - count) <= 3


@settings(max_examples=40)
@given(
    st.floats(0.05, 2.0), st.floats(0.0, 0.95), st.floats(0.03, 0.6), st.sampled_from([1.0, 0.01])
)
def test_none_overlap_and_all_stand_between_mouth_and_rim(
    radius: float, mouth: float, base: float, unit: float
) -> None:
    R, m, b = radius * unit, mouth * radius * unit, base * radius * unit
    places = phyllotaxis(R, m, b)
    out = np.linalg.norm(places, axis=1)
    assert (out >= m + b - 1e-9).all()
    assert (out <= R - b + 1e-9).all()
    apart = np.linalg.norm(places[:, None] - places[None], axis=2)
    np.fill_diagonal(apart, np.inf)
    assert apart.min(initial=np.inf) >= 2.0 * b - 1e-9
    assert (len(places) > 0) == (m + 2.0 * b <= R)


def test_the_count_does_not_depend_on_the_unit() -> None:
    assert len(phyllotaxis(40.0, 18.0, 2.0)) == len(phyllotaxis(0.24, 0.108, 0.012))


def test_a_ring_too_narrow_holds_none() -> None:
    assert phyllotaxis(1.0, 0.9, 0.2).shape == (0, 2)
    assert phyllotaxis(1.0, 1.0, 0.2).shape == (0, 2)
