"""The intermediate motion (papers/003, eq. 14, Algorithm 2) and its file."""

import io
import zipfile
from collections.abc import Callable
from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tools.video.follow import Followed, follow
from tools.video.motion import Motion, angle_of, fin_tips, lengths_of, rebuilt_axis, step_of
from tools.video.motion_file import MotionError, load, save
from tools.video.synthetic import SyntheticClip


@pytest.fixture(scope="module")
def followed(fish_film: Path) -> Followed:
    return follow(fish_film)


@pytest.fixture(scope="module")
def motion(followed: Followed) -> Motion:
    return followed.assembled.motion


@given(
    turn=st.lists(st.floats(-0.4, 0.4), min_size=2, max_size=40),
    heading=st.floats(-3, 3),
    length=st.floats(0.5, 100),
)
def test_angles_and_steps_undo_each_other(turn: list[float], heading: float, length: float) -> None:
    angle = 1.5 + np.cumsum(turn)[:, None] + np.array([0.0, 0.7, 4.0])
    direction = heading + np.linspace(0.0, 9.0, len(angle))
    step = step_of(angle, np.full(angle.shape, length), direction)
    again = angle_of(step, direction)
    assert np.allclose(np.hypot(step[..., 0], step[..., 1]), length)
    assert np.allclose(np.sin(again - angle), 0.0, atol=1e-9)
    assert (np.abs(np.diff(again, axis=0)) < pi).all()
    assert ((again[0] >= 0.0) & (again[0] < 2.0 * pi)).all()


def test_the_frame_of_a_fish_has_its_head_ahead_and_its_right_to_the_right() -> None:
    up = np.array([[[0.0, -5.0]]])
    assert angle_of(up, np.array([pi / 2]))[0, 0] == pytest.approx(pi / 2)
    # It heads down in the picture: what lies to the picture's left lies to its right.
    assert angle_of(np.array([[[-5.0, 0.0]]]), np.array([-pi / 2]))[0, 0] == pytest.approx(0.0)


def test_a_motion_rebuilds_the_axis_it_was_measured_on(motion: Motion) -> None:
    points = rebuilt_axis(motion)
    assert points.shape == (motion.count, 3 + 15 + 3, 2)
    assert np.abs(points[:, 0] - motion.axis[:, 0]).max() < 1e-3
    assert np.abs(points[:, -1] - motion.axis[:, -1]).max() < 1e-3
    away = np.sqrt(((points[:, :, None] - motion.axis[:, None]) ** 2).sum(axis=3)).min(axis=2)
    assert away.max() < motion.length / 40


def test_bones_of_a_fish_at_rest_point_along_it(motion: Motion) -> None:
    assert np.abs(np.median(motion.up_angle) - pi / 2) < 0.3
    assert np.abs(np.median(motion.low_angle) - 3 * pi / 2) < 0.3
    angles, lengths = motion.bones()
    assert angles.shape == lengths.shape == (motion.count, 20)
    assert np.median(lengths.sum(axis=1)) == pytest.approx(motion.length, rel=0.01)


def test_fins_stand_on_their_own_sides(motion: Motion) -> None:
    shown = ~motion.folded
    assert shown.mean(axis=0).min() > 0.3
    side = np.cos(motion.fin_angle)
    assert np.median(side[shown[:, 0], 0]) < 0.0 < np.median(side[shown[:, 1], 1])
    assert np.isfinite(fin_tips(motion)).all()
    assert np.isfinite(motion.junction).all()


def test_the_body_is_as_wide_as_it_was_drawn(
    motion: Motion, swim: Callable[..., SyntheticClip]
) -> None:
    clip = swim("sardine")
    drawn = clip._drawn.above @ clip.segment.shape[0].astype(np.float64)
    widest = 0.5 * np.ptp(drawn[:, 2]) * clip.setting.body_length
    assert motion.half_width.max(axis=1).mean() == pytest.approx(widest, rel=0.35)
    assert (motion.half_width[:, 0] == 0.0).all()


def test_confidence_is_nought_where_a_frame_is_bridged(motion: Motion) -> None:
    assert motion.good.all()
    assert (motion.confidence > 0.3).all()
    assert motion.length == pytest.approx(lengths_of(motion.axis.astype(float)).mean(), rel=0.02)


def test_a_file_gives_back_the_motion(motion: Motion, tmp_path: Path) -> None:
    path = tmp_path / "a.motion"
    save(path, motion)
    again = load(path)
    for name, value in vars(motion).items():
        assert np.array_equal(getattr(again, name), value), name
    other = tmp_path / "b.motion"
    save(other, again)
    assert path.read_bytes() == other.read_bytes()


def test_provenance_names_no_folder(motion: Motion, fish_film: Path) -> None:
    told = " ".join(motion.provenance.values())
    assert fish_film.name in told
    assert "/" not in told
    assert str(fish_film.parent.name) not in told


def _with_member(path: Path, name: str, make: Callable[[np.ndarray], np.ndarray]) -> None:
    with zipfile.ZipFile(path) as archive:
        held = {n: archive.read(n) for n in archive.namelist()}
    array = np.load(io.BytesIO(held[f"{name}.npy"]))
    file = io.BytesIO()
    np.save(file, make(array), allow_pickle=True)
    held[f"{name}.npy"] = file.getvalue()
    with zipfile.ZipFile(path, "w") as archive:
        for member, content in held.items():
            archive.writestr(member, content)


@pytest.mark.parametrize(
    ("name", "make", "told"),
    [
        ("version", lambda a: a + 1, "version 1 is expected"),
        ("rate", lambda a: -a, "rate -"),
        ("centre", lambda a: a * np.nan, "centre holds a number that is not finite"),
        ("axis", lambda a: a[:, :40], "axis has shape"),
        ("axis", lambda a: a.astype(np.float64), "axis holds <f8"),
        ("up_angle", lambda a: a[1:], "up_angle has shape"),
        ("confidence", lambda a: a + 2.0, "confidence is not from 0 to 1"),
        ("fault", lambda a: a + 99, "fault holds a number"),
        ("fault", lambda a: a + 1, "no frame is good"),
        ("folded", lambda a: a + 5, "folded holds"),
        ("head_length", lambda a: -a - 1.0, "head_length is negative"),
        ("provenance", lambda a: a[:-1], "provenance is damaged"),
        ("fault", lambda a: np.array([{}] * len(a), object), "pickled objects"),
        ("direction", lambda a: np.asfortranarray(np.stack((a, a))), "direction has shape|C order"),
    ],
)
def test_a_file_that_is_wrong_is_refused_in_one_line(
    motion: Motion,
    tmp_path: Path,
    name: str,
    make: Callable[[np.ndarray], np.ndarray],
    told: str,
) -> None:
    path = tmp_path / "bad.motion"
    save(path, motion)
    _with_member(path, name, make)
    with pytest.raises(MotionError, match=told) as error:
        load(path)
    assert str(error.value).startswith(f"{path}: no motion: ")
    assert "\n" not in str(error.value)


@given(at=st.floats(0.0, 0.999), length=st.integers(1, 400), value=st.integers(0, 255))
def test_a_damaged_file_never_ends_in_a_traceback(
    motion: Motion, tmp_path_factory: pytest.TempPathFactory, at: float, length: int, value: int
) -> None:
    path = tmp_path_factory.mktemp("damaged") / "bad.motion"
    save(path, replace(motion, axis=motion.axis))
    content = bytearray(path.read_bytes())
    begin = int(at * len(content))
    content[begin : begin + length] = bytes([value]) * len(content[begin : begin + length])
    path.write_bytes(bytes(content))
    told = ""
    try:
        again = load(path)
    except MotionError as error:
        told = str(error)
        again = motion
    assert again.count == motion.count
    assert "\n" not in told


def test_what_is_no_motion_at_all_is_refused(tmp_path: Path) -> None:
    (tmp_path / "text.motion").write_text("hello")
    with pytest.raises(MotionError, match="no npz archive"):
        load(tmp_path / "text.motion")
    with pytest.raises(MotionError, match="cannot be read"):
        load(tmp_path / "none.motion")
