"""Painted skins: always the same, in the right places, and rich enough to tell species apart."""

import dataclasses

import numpy as np
import pytest

from components.body import Body
from components.skin import Eye, Gradient, Patch, Scales, Skin, Spots, Stripes
from components.species import Species
from systems.view.fish_fins import CAUDAL_BOX
from systems.view.fish_surface import BODY_BOX
from systems.view.skin_canvas import SIZE
from systems.view.skin_texture import Texels, paint_skin

RED, WHITE, BLACK = (0.8, 0.1, 0.1), (1.0, 1.0, 1.0), (0.0, 0.0, 0.0)
BODY = Body(
    (0.11, 0.28, 0.47, 0.66, 0.82),
    (0.036, 0.05, 0.047, 0.032, 0.013),
    (0.06, 0.088, 0.085, 0.058, 0.026),
    0.1,
)


def skin(*layers: Gradient | Stripes | Spots | Patch | Scales) -> Skin:
    """Return a red skin with layers over it and no gill cover."""
    return Skin((Gradient((RED, RED)), *layers), Eye(), RED, RED, gill_strength=0.0)


def at(picture: Texels, s: float, h: float) -> np.ndarray:
    """Return the colour at a place of the body, 0 to 1."""
    left, top, right, bottom = BODY_BOX
    x = left + s * (right - left)
    y = top + np.arccos(h) / np.pi * (bottom - top)
    return picture[int(y * SIZE), int(x * SIZE), :3] / 255.0


def test_a_skin_is_painted_the_same_every_time(sample: Species) -> None:
    first, second = (paint_skin(sample.skin, sample.body) for _ in range(2))
    assert first.shape == (SIZE, SIZE, 4)
    assert np.array_equal(first, second)


def test_a_gradient_runs_from_belly_to_back() -> None:
    picture = paint_skin(dataclasses.replace(skin(), layers=(Gradient((WHITE, BLACK)),)), BODY)
    tones = [at(picture, 0.5, h).mean() for h in (-0.8, 0.0, 0.8)]
    assert tones == sorted(tones, reverse=True)
    assert tones[0] - tones[2] > 0.6


def test_bars_stand_where_they_are_asked_for_with_their_rims() -> None:
    picture = paint_skin(skin(Stripes(WHITE, (0.5, 0.8), 0.08, 0.01, edge=BLACK)), BODY)
    for s in (0.5, 0.8):
        assert at(picture, s, 0.3) == pytest.approx(WHITE, abs=0.02)
        assert at(picture, s + 0.046, 0.3).max() < 0.15
        assert at(picture, s + 0.1, 0.3) == pytest.approx(RED, abs=0.1)


def test_lines_along_the_body_keep_to_their_reach() -> None:
    layer = Stripes(WHITE, (0.4,), 0.2, 0.02, along=True, reach=(0.3, 0.6))
    picture = paint_skin(skin(layer), BODY)
    assert at(picture, 0.45, 0.4) == pytest.approx(WHITE, abs=0.02)
    assert at(picture, 0.75, 0.4) == pytest.approx(RED, abs=0.1)


def test_a_patch_covers_its_place_and_a_ring_leaves_its_middle() -> None:
    full = paint_skin(skin(Patch(WHITE, (0.6, 0.0), (0.15, 0.6))), BODY)
    ring = paint_skin(skin(Patch(WHITE, (0.6, 0.0), (0.15, 0.6), hollow=0.7)), BODY)
    assert at(full, 0.6, 0.05) == pytest.approx(WHITE, abs=0.02)
    assert at(ring, 0.6, 0.05) == pytest.approx(RED, abs=0.1)
    assert at(ring, 0.73, 0.0).mean() > 0.8
    assert at(full, 0.85, 0.0) == pytest.approx(RED, abs=0.1)


def test_a_row_of_spots_is_spread_over_its_reach() -> None:
    layer = Spots(BLACK, 6, 0.02, seed=3, height=(0.3, 0.3), reach=(0.3, 0.9), in_row=True)
    picture = paint_skin(skin(layer), BODY)
    dark = np.array([at(picture, s, 0.3).max() < 0.3 for s in np.linspace(0.3, 0.9, 240)])
    assert (np.diff(dark.astype(int)) == 1).sum() + int(dark[0]) == 6
    assert at(picture, 0.1, 0.3) == pytest.approx(RED, abs=0.1)


def test_the_eye_is_dark_in_the_middle_and_round_it_the_iris() -> None:
    eye = Eye(at=(0.12, 0.2), radius=0.03, iris=(1.0, 0.9, 0.2), pupil=0.5)
    picture = paint_skin(dataclasses.replace(skin(), eye=eye), BODY)
    assert at(picture, 0.121, 0.17).max() < 0.15
    ring = at(picture, 0.12 + 0.022, 0.2)
    assert ring[0] > 0.45
    assert ring[2] < 0.35


def test_scales_and_gill_cover_are_lit_as_relief(sample: Species) -> None:
    relief = paint_skin(sample.skin, sample.body)[20:230, 60:480, 3]
    assert relief.std() > 2.0


def test_fins_let_light_through_between_rays_and_end_inside_their_box(sample: Species) -> None:
    picture = paint_skin(sample.skin, sample.body)
    left, top, right, bottom = (int(v * SIZE) for v in CAUDAL_BOX)
    fin = picture[top:bottom, left:right, 3]
    assert fin[10:-10, :10].min() > 200
    assert fin[:, -1].max() < 60
    middle = fin[40:-40, 150]
    assert middle.max() > middle.min()
    assert fin[128, 60:200].mean() > 120


def test_species_look_different(shoal_skins: list[Texels]) -> None:
    for i, one in enumerate(shoal_skins):
        for other in shoal_skins[:i]:
            assert np.abs(one[:240, :, :3].astype(int) - other[:240, :, :3]).mean() > 20
