"""Two-level retargeting as a whole: no flips, rigid fins, films (papers/003, section 5)."""

from dataclasses import replace

import numpy as np
import pytest

from tools.video.retarget.areas import signed_areas
from tools.video.retarget.choose import target_from
from tools.video.retarget.example import example_clip_motion, example_motion
from tools.video.retarget.film import frames, still
from tools.video.retarget.intermediate import intermediate
from tools.video.retarget.retarget import Placement, Retargeting
from tools.video.retarget.skeleton import BONES, HEAD, angle_of, nearest_turn
from tools.video.retarget.target import ModelError, Target


@pytest.fixture(scope="module")
def carp() -> Target:
    return target_from("carp")


def strains(play: Retargeting, frame: int) -> list[float]:
    """Return the largest change of an edge's length in each fin beyond its soft root."""
    target, moved = play.target, play.vertices(frame)
    edges = np.concatenate((target.triangles[:, :2], target.triangles[:, 1:]))
    found = []
    for fin, rigid in zip(target.fins, play.rig.fins, strict=True):
        assert fin is not None
        stiff = np.isin(edges, fin.vertices[fin.distance > rigid.band]).all(axis=1)
        ends = edges[stiff]
        rest = target.vertices[:, :2]
        before = np.sqrt(((rest[ends[:, 0]] - rest[ends[:, 1]]) ** 2).sum(axis=1))
        after = np.sqrt(((moved[ends[:, 0]] - moved[ends[:, 1]]) ** 2).sum(axis=1))
        assert len(before) > 20
        found.append(float(np.abs(after / before - 1.0).max()))
    return found


def test_no_triangle_flips_in_a_thousand_frames(carp: Target) -> None:
    motion = example_motion(1000, sweep=0.24, fin_sweep=0.9, rate=60.0)
    play = Retargeting(carp, motion)
    rest = signed_areas(carp.vertices[:, :2], carp.triangles)
    flips = sum(
        int((signed_areas(play.vertices(frame), carp.triangles) * rest <= 0.0).sum())
        for frame in range(1000)
    )
    assert flips == 0


def test_fins_are_rigid_in_ours_and_strained_in_the_papers_way(carp: Target) -> None:
    motion = example_motion(60)
    ours, paper = (Retargeting(carp, motion, mode) for mode in ("turn", "paper"))
    assert max(max(strains(ours, frame)) for frame in range(60)) < 0.01
    assert max(max(strains(paper, frame)) for frame in range(60)) > 0.1


@pytest.mark.parametrize("name", ["cartoon", "mermaid", "flower", "lobster"])
def test_the_other_models_do_not_flip_either(name: str) -> None:
    target = target_from(name)
    play = Retargeting(target, example_motion(60, sweep=0.2, fin_sweep=0.7))
    rest = signed_areas(target.vertices[:, :2], target.triangles)
    for frame in range(60):
        assert (signed_areas(play.vertices(frame), target.triangles) * rest > 0.0).all()


def test_the_rest_pose_stays_as_it_is_and_bones_follow_the_fish(carp: Target) -> None:
    play = Retargeting(carp, example_motion(30))
    assert np.allclose(play.rig.pose(carp.rest_angles), carp.vertices[:, :2], atol=1e-9)
    angles = play.motion.angles[7]
    controls = play.rig.controls(play.angles(7))
    assert np.isclose(nearest_turn(angle_of(controls[1] - controls[0]) - angles[0]), 0.0)
    assert np.isclose(nearest_turn(angle_of(controls[-1] - controls[-2]) - angles[BONES - 1]), 0.0)


def test_fins_swing_as_far_as_the_fishs(carp: Target) -> None:
    play = Retargeting(carp, example_motion(40, fin_sweep=0.5))
    fin = carp.fins[1]
    assert fin is not None
    for frame in range(0, 40, 7):
        tip, root = play.rig.tips(play.angles(frame))[1], play.rig.roots(play.angles(frame))[1]
        assert tip is not None
        rest = fin.tip - 0.5 * (fin.top + fin.bottom)
        swung = float(nearest_turn(angle_of(tip - root) - angle_of(rest)))
        meant = play.motion.angles[frame, BONES + 1] - play.motion.fin_rest[1]
        assert abs(swung - meant) < 0.02


def test_a_place_in_the_picture_and_back() -> None:
    place = Placement(np.array([300.0, 200.0]), 0.7, 2.5)
    points = np.array([[0.0, 1.0], [3.0, -2.0]])
    assert np.allclose(place.to_local(place.to_picture(points)), points)
    ahead, right = place.to_picture(np.array([[0.0, 1.0], [1.0, 0.0]])) - place.centre
    assert np.allclose(ahead, 2.5 * np.array([np.cos(0.7), -np.sin(0.7)]))
    assert np.allclose(right, 2.5 * np.array([np.sin(0.7), np.cos(0.7)]))


def test_a_model_from_the_side_keeps_its_back_up() -> None:
    right, left = (Placement(np.zeros(2), angle, 1.0, angle > 1.0) for angle in (0.0, np.pi))
    back = np.array([[-1.0, 0.0]])
    assert right.to_picture(back)[0, 1] < 0.0
    assert left.to_picture(back)[0, 1] < 0.0
    assert np.allclose(left.to_local(left.to_picture(back)), back)


def test_a_motion_at_another_rate_passes_through_its_frames() -> None:
    motion = example_motion(20, rate=20.0)
    finer = motion.at_rate(60.0)
    assert finer.frames == 58
    assert np.allclose(finer.angles[::3], motion.angles)
    assert np.allclose(
        finer.centre[1], motion.centre[0] + (motion.centre[1] - motion.centre[0]) / 3
    )


def test_a_clips_motion_holds_what_retargeting_needs() -> None:
    known, read = example_motion(10), intermediate(example_clip_motion(10))
    assert np.allclose(read.angles, known.angles)
    assert abs(read.length / known.length - 1.0) < 0.01


def test_a_film_shows_the_model_in_every_frame_on_its_way(carp: Target) -> None:
    motion = example_motion(4, rate=2.0)
    pictures = list(frames(Retargeting(carp, motion), 160, 120))
    assert [picture.shape for picture in pictures] == [(120, 160, 3)] * 4
    reds = [np.argwhere(p[..., 0].astype(int) - p[..., 2] > 60) for p in pictures]
    assert all(len(red) > 5 for red in reds)
    assert np.abs(reds[0].mean(axis=0) - reds[3].mean(axis=0)).max() > 3.0


def test_a_still_shows_the_head_up(carp: Target) -> None:
    picture = still(carp, 120, 160)
    red = np.argwhere(picture[..., 0].astype(int) - picture[..., 2] > 100)
    assert red[:, 0].mean() < 80.0
    assert carp.controls[HEAD, 1] > 0.0


def test_junctions_stay_on_the_body(carp: Target) -> None:
    play = Retargeting(carp, example_motion(30))
    rest = carp.vertices[:, :2]
    places = [point for fin in carp.fins if fin is not None for point in (fin.top, fin.bottom)]
    nearest = [int(np.argmin(((rest - point) ** 2).sum(axis=1))) for point in places]
    for frame in range(30):
        moved, junctions = play.rig.body(play.angles(frame))
        away = np.sqrt(((moved[nearest] - junctions) ** 2).sum(axis=1))
        before = np.sqrt(((rest[nearest] - np.array(places)) ** 2).sum(axis=1))
        assert np.abs(away - before).max() < 0.004 * carp.skeleton.body_length


def test_a_motion_of_one_frame_plays_and_one_of_other_bones_is_told(carp: Target) -> None:
    one = example_motion(1).at_rate(30.0)
    assert len(list(frames(Retargeting(carp, one), 64, 48))) == 1
    motion = example_clip_motion(3)
    with pytest.raises(ModelError, match="2 and 15 points"):
        intermediate(replace(motion, up_angle=motion.up_angle[:, :2]))
