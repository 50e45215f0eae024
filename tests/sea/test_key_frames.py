"""Key frames of singularities (papers/002, section 5.2): lines, eased curves, loops, and frames that make no track."""

from itertools import pairwise

import numpy as np
import pytest

from components.singularity import (
    FREE,
    SUBMARINE,
    SingularityTable,
    Track,
    key_frame,
    pack_tracks,
    play_tracks,
)

SECONDS = (0.0, 1.0, 3.0, 4.0)
PLACES = ((0.0, 0.0, 0.0), (2.0, 0.0, 1.0), (2.0, 4.0, 0.0), (0.0, 0.0, 0.0))
PHIS = (1.0, -2.0, 3.0, 1.0)


def _values(track: Track, seconds: float) -> tuple[float, float, float, float]:
    return key_frame(pack_tracks([track]), 0, seconds)


@pytest.mark.parametrize("smooth", [True, False])
@pytest.mark.parametrize("loop", [True, False])
def test_a_track_passes_through_its_frames(smooth: bool, loop: bool) -> None:
    track = Track(SECONDS, PLACES, PHIS, smooth, loop)
    for seconds, place, phi in zip(SECONDS[:-1], PLACES, PHIS, strict=False):
        assert _values(track, seconds) == pytest.approx((*place, phi), abs=1e-12)


def test_a_straight_track_goes_in_lines() -> None:
    track = Track(SECONDS, PLACES, PHIS, smooth=False)
    assert _values(track, 2.0) == pytest.approx((2.0, 2.0, 0.5, 0.5), abs=1e-12)


def test_a_track_is_held_at_its_ends_and_a_loop_goes_on() -> None:
    held, looped = Track(SECONDS, PLACES, PHIS), Track(SECONDS, PLACES, PHIS, loop=True)
    assert _values(held, -5.0) == _values(held, 0.0)
    assert _values(held, 99.0) == (*PLACES[-1], PHIS[-1])
    assert _values(looped, 2.5 + 4.0 * 7) == pytest.approx(_values(looped, 2.5), abs=1e-9)
    assert _values(looped, 2.5) != pytest.approx(_values(looped, 3.5))


@pytest.mark.parametrize("loop", [True, False])
def test_a_smooth_track_has_no_kink_and_never_passes_a_frame(loop: bool) -> None:
    track = Track(SECONDS, PLACES, PHIS, smooth=True, loop=loop)
    times = np.linspace(0.0, 3.999, 4_000)
    values = np.array([_values(track, t) for t in times])
    frames = np.concatenate([PLACES, np.array(PHIS)[:, None]], axis=1)
    for (begin, end), (a, b) in zip(pairwise(SECONDS), pairwise(frames), strict=True):
        here = values[(times >= begin) & (times <= end)]
        assert (here >= np.minimum(a, b) - 1e-12).all()
        assert (here <= np.maximum(a, b) + 1e-12).all()
    assert np.abs(np.diff(values, 2, axis=0)).max() < 1e-4


def test_one_frame_is_a_track() -> None:
    assert _values(Track([2.0], [(1.0, 2.0, 3.0)], [4.0]), 9.0) == (1.0, 2.0, 3.0, 4.0)


def test_tracks_move_what_is_free_and_charge_all() -> None:
    keys = pack_tracks([Track(SECONDS, PLACES, PHIS), Track([0.0], [(9.0, 9.0, 9.0)], [8.0])])
    table = SingularityTable(3)
    table.track[:3], table.attached[:3] = (0, 1, -1), (FREE, SUBMARINE, FREE)
    play_tracks(keys, table.track, table.attached, table.position, table.intensity, 3, 1.0)
    assert table.position[:3].tolist() == [[2.0, 0.0, 1.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]
    assert table.intensity[:3].tolist() == [-2.0, 8.0, 0.0]


@pytest.mark.parametrize(
    ("seconds", "places", "phis", "loop", "says"),
    [
        ((0.0, 2.0, 1.0), PLACES[:3], PHIS[:3], False, "key frame 3 at 1 s must come after 2 s"),
        ((0.0, 0.0), PLACES[:2], PHIS[:2], False, "key frame 2 at 0 s must come after 0 s"),
        ((), (), (), False, "in each key frame"),
        ((0.0, 1.0), PLACES[:1], PHIS[:2], False, "in each key frame"),
        ((0.0, np.inf), PLACES[:2], PHIS[:2], False, "finite"),
        ((0.0,), PLACES[:1], PHIS[:1], True, "a loop needs two key frames"),
    ],
)
def test_frames_that_make_no_track_are_refused(
    seconds: tuple[float, ...],
    places: tuple[tuple[float, float, float], ...],
    phis: tuple[float, ...],
    loop: bool,
    says: str,
) -> None:
    with pytest.raises(ValueError, match=says):
        Track(seconds, places, phis, loop=loop)
