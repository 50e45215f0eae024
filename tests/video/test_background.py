"""Clean plates, thresholds and models of the ground."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tools.video.background import MODELS, Plate, blur, clean_plate, model_of, otsu, threshold
from tools.video.images import Grey
from tools.video.median_plate import median_of
from tools.video.synthetic import SyntheticClip


@given(
    low=st.integers(0, 100),
    gap=st.integers(20, 120),
    many=st.integers(50, 500),
    few=st.integers(50, 500),
)
def test_otsu_parts_two_heaps(low: int, gap: int, many: int, few: int) -> None:
    counts = np.zeros(256)
    counts[low : low + 5] = many
    counts[low + gap : low + gap + 5] = few
    assert low + 4 <= otsu(counts) <= low + gap


def test_otsu_of_a_single_value_is_that_value() -> None:
    counts = np.zeros(256)
    counts[40] = 9
    assert otsu(counts) == 40.0


def test_the_median_plate_is_the_median_of_each_pixel() -> None:
    samples = np.random.default_rng(0).integers(0, 256, (25, 130, 7)).astype(np.uint8)
    assert (median_of(samples) == np.median(samples, axis=0)).all()


def test_a_fish_that_holds_station_is_painted_out(
    frames: list[Grey], swim: Callable[..., SyntheticClip]
) -> None:
    plate, painted = clean_plate(np.stack(frames[::2]))
    assert painted
    axis = swim("sardine").truth(0).round().astype(int)
    assert plate[axis[:, 1], axis[:, 0]].min() > 120
    assert blur(frames[0])[axis[5:30, 1], axis[5:30, 0]].max() < 100


def test_a_stone_beside_which_a_fish_passes_stays_in_the_plate() -> None:
    ground = np.full((240, 320), 190, np.uint8)
    ground[60:110, 60:120] = 40
    samples = []
    for k in range(20):
        frame = ground.copy()
        frame[150:175, 12 * k : 12 * k + 70] = 50
        samples.append(frame)
    plate, painted = clean_plate(np.stack(samples))
    assert not painted
    assert plate[80, 90] == 40
    assert plate[160, 100] == 190


def test_a_shadow_lies_below_the_threshold(swim: Callable[..., SyntheticClip]) -> None:
    from tools.video.synthetic import Setting

    clip = swim("parrotfish", Setting(width=480, height=300, body_length=180.0, travels=False))
    samples = np.stack(list(clip.frames(24)))
    gate = threshold(samples, clean_plate(samples)[0])
    assert 0.18 * 200.0 < gate < 140.0


def test_nothing_stands_out_where_nothing_moves() -> None:
    samples = np.full((5, 40, 60), 128, np.uint8)
    assert threshold(samples, samples[0]) == 0.0


@pytest.mark.parametrize("name", MODELS[1:])
def test_a_learning_model_sees_what_enters_a_clean_plate(name: str) -> None:
    plate = np.full((120, 160), 180, np.uint8)
    model = model_of(name, plate)
    entered = plate.copy()
    entered[40:60, 50:100] = 60
    seen = model.moving(entered)
    assert seen is not None
    assert seen[50, 75] == 255
    assert (seen[:30] == 0).mean() > 0.99


def test_the_sample_consensus_model_forgets_by_chance_that_is_the_same_each_time() -> None:
    plate = np.full((60, 80), 100, np.uint8)
    drift = [np.full((60, 80), 100 + k // 5, np.uint8) for k in range(200)]
    one, other = (model_of("vibe", plate) for _ in range(2))
    seen = [[np.asarray(model.moving(frame)) for frame in drift] for model in (one, other)]
    assert np.array_equal(seen[0], seen[1])
    assert (seen[0][-1] == 0).mean() > 0.5


def test_the_plate_adds_nothing_to_the_difference_from_itself() -> None:
    assert isinstance(model_of("median", np.zeros((4, 4), np.uint8)), Plate)
