"""Painted skins: always the same, in the right places, and rich enough to tell species apart."""

import dataclasses

import numpy as np
import pytest

from components.body import Body, Fin
from components.skin import (
    Band,
    Eye,
    FinLines,
    FinPatch,
    Gradient,
    Hatch,
    Mouth,
    Patch,
    Scales,
    Skin,
    Spots,
    Stripes,
)
from components.species import Species
from systems.view.fish_fins import ANAL_BOX, CAUDAL_BOX, DORSAL_BOX, PECTORAL_BOX
from systems.view.fish_surface import BODY_BOX
from systems.view.skin_canvas import SIZE, Box
from systems.view.skin_texture import Texels, paint_skin

RED, WHITE, BLACK = (0.8, 0.1, 0.1), (1.0, 1.0, 1.0), (0.0, 0.0, 0.0)
BODY = Body(
    (0.11, 0.28, 0.47, 0.66, 0.82),
    (0.036, 0.05, 0.047, 0.032, 0.013),
    (0.06, 0.088, 0.085, 0.058, 0.026),
    0.1,
)


def skin(*layers: Gradient | Stripes | Spots | Patch | Band | Hatch | Scales) -> Skin:
    """Return a red skin with layers over it and no gill cover."""
    return Skin((Gradient((RED, RED)), *layers), Eye(), RED, RED, gill_strength=0.0)


def at(picture: Texels, s: float, h: float) -> np.ndarray:
    """Return the colour at a place of the body, 0 to 1."""
    left, top, right, bottom = BODY_BOX
    x = left + s * (right - left)
    y = top + np.arccos(h) / np.pi * (bottom - top)
    return picture[int(y * SIZE), int(x * SIZE), :3] / 255.0


def fin_at(picture: Texels, box: Box, along: float, out: float) -> np.ndarray:
    """Return colour and opacity of a median fin at a place of its strip, 0 to 1."""
    left, top, right, bottom = box
    x, y = left + along * (right - left), bottom - out * (bottom - top)
    place: np.ndarray = picture[int(y * SIZE), int(x * SIZE)] / 255.0
    return place


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


def test_a_band_passes_through_its_points_with_its_rim_and_widens_as_asked() -> None:
    band = Band(WHITE, ((0.3, 0.8), (0.5, 0.0), (0.7, 0.8)), (0.03, 0.08), edge=BLACK)
    picture = paint_skin(skin(band), BODY)
    for s, h in band.points:
        assert at(picture, s, h) == pytest.approx(WHITE, abs=0.03)
    assert at(picture, 0.5, 0.8) == pytest.approx(RED, abs=0.12)
    assert at(picture, 0.3, -0.2) == pytest.approx(RED, abs=0.1)
    wide = [(at(picture, s, h)[2] > 0.5) for s in np.linspace(0.6, 0.8, 90) for h in (0.8,)]
    thin = [(at(picture, s, h)[2] > 0.5) for s in np.linspace(0.2, 0.4, 90) for h in (0.8,)]
    assert sum(wide) > 1.5 * sum(thin) > 0
    assert min(at(picture, 0.5, h).max() for h in np.linspace(-0.6, 0.0, 40)) < 0.2


def test_hatching_draws_parallel_lines_within_its_reach() -> None:
    hatch = Hatch(WHITE, 0.05, 0.025, tilt_deg=90.0, reach=(0.3, 0.8), fade=0.01)
    picture = paint_skin(skin(hatch), BODY)
    light = np.array([at(picture, s, 0.0)[1] > 0.5 for s in np.linspace(0.2, 0.9, 350)])
    assert (np.diff(light.astype(int)) == 1).sum() == pytest.approx(10, abs=1)
    assert not light[:45].any()
    assert not light[-45:].any()


def test_scales_take_the_colour_of_their_borders() -> None:
    plain, rimmed = (
        paint_skin(skin(Scales(0.05, 0.0, rim)), BODY)[60:180, 180:400, :3] for rim in (None, WHITE)
    )
    assert plain[..., 1].mean() < 60
    assert 10 < (rimmed[..., 1] > 150).mean() * 100 < 60


def test_a_profile_cuts_a_fin_into_shape() -> None:
    body = dataclasses.replace(BODY, dorsal=Fin(0.3, 0.7, 0.1, 0.0, (1.0, 1.0, 0.0, 0.0, 0.5, 0.5)))
    picture = paint_skin(skin(), body)
    assert fin_at(picture, DORSAL_BOX, 0.1, 0.85)[3] > 0.6
    assert fin_at(picture, DORSAL_BOX, 0.5, 0.2)[3] < 0.05
    assert fin_at(picture, DORSAL_BOX, 0.9, 0.3)[3] > 0.6
    assert fin_at(picture, DORSAL_BOX, 0.9, 0.7)[3] < 0.05


def test_fins_have_colours_tips_and_marks_of_their_own() -> None:
    marks = (
        FinPatch("dorsal", WHITE, (0.5, 0.4), (0.1, 0.2)),
        FinLines("anal", WHITE, (0.4,), 0.2),
    )
    body = dataclasses.replace(BODY, dorsal=Fin(0.3, 0.7, 0.1), anal=Fin(0.5, 0.8, 0.1))
    look = dataclasses.replace(skin(), fin_marks=marks, anal=BLACK, fin_tip=BLACK, fin_rays=0.0)
    picture = paint_skin(look, body)
    assert fin_at(picture, DORSAL_BOX, 0.5, 0.4)[:3] == pytest.approx(WHITE, abs=0.02)
    assert fin_at(picture, DORSAL_BOX, 0.2, 0.4)[0] > 0.6
    assert fin_at(picture, DORSAL_BOX, 0.2, 0.85)[:3].max() < 0.05
    assert fin_at(picture, ANAL_BOX, 0.5, 0.4)[:3] == pytest.approx(WHITE, abs=0.02)
    assert fin_at(picture, ANAL_BOX, 0.5, 0.6)[:3].max() < 0.05
    assert fin_at(picture, PECTORAL_BOX, 0.9, 0.5)[:3].max() < 0.05


def test_fins_go_on_with_the_bars_beside_them() -> None:
    body = dataclasses.replace(BODY, dorsal=Fin(0.3, 0.7, 0.1))
    bar = Stripes(WHITE, (0.55,), 0.1)
    with_bar, without = (
        paint_skin(dataclasses.replace(skin(bar), fin_follow=follow), body) for follow in (1.0, 0.0)
    )
    along = (0.55 * 0.8956 - 0.3) / 0.4
    assert fin_at(with_bar, DORSAL_BOX, along, 0.5)[1] > 0.6
    assert fin_at(without, DORSAL_BOX, along, 0.5)[1] < 0.2
    assert fin_at(with_bar, DORSAL_BOX, 0.05, 0.5)[1] < 0.2


def test_a_shark_has_slits_and_its_mouth_below() -> None:
    look = dataclasses.replace(skin(), gill_strength=0.8, gill_at=0.26)
    cover = paint_skin(look, BODY)
    slits = paint_skin(dataclasses.replace(look, gill_slits=5), BODY)
    tone = np.array([at(slits, s, 0.0)[0] for s in np.linspace(0.19, 0.28, 160)])
    dark = tone < tone.max() - 0.15
    assert (np.diff(dark.astype(int)) == 1).sum() == 5
    assert not np.array_equal(cover, slits)
    low = paint_skin(dataclasses.replace(look, mouth=Mouth((0.05, -0.7), (0.10, -0.5))), BODY)
    rows = [at(low, 0.065, h)[0] for h in np.linspace(-0.9, -0.4, 60)]
    assert min(rows) < 0.5 * max(rows)
