"""Fine tuning: windows, influence, edits, undo and redo (papers/003, section 6, eqs. 18 to 21, Table 2)."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from tools.video.motion import rebuilt_axis
from tools.video.retarget.example import example_clip_motion
from tools.video.retarget.intermediate import intermediate
from tools.video.retarget.skeleton import ANGLES, NAMES
from tools.video.retouch.apply import retouched
from tools.video.retouch.edit import Window, deviation, edited, influence, window_of
from tools.video.retouch.session import Session

COURSE = arrays(np.float64, st.integers(1, 30), elements=st.floats(-1.4, 1.4))
REST = 1.6


@given(COURSE, st.data())
def test_a_window_holds_one_side_of_rest_and_no_more(away: np.ndarray, data: st.DataObject) -> None:
    frame = data.draw(st.integers(0, len(away) - 1))
    first, last = window_of(away, frame)
    assert first <= frame <= last
    assert (away[first : last + 1] * away[frame] >= 0.0).all()
    assert first == 0 or away[first - 1] * away[frame] < 0.0
    assert last == len(away) - 1 or away[last + 1] * away[frame] < 0.0


@given(st.integers(0, 20), st.integers(0, 20), st.integers(0, 50))
def test_influence_is_one_peak_of_parabolas(before: int, after: int, first: int) -> None:
    f = influence(first + before, Window(first, first + before + after))
    assert f[before] == 1.0
    assert (np.diff(f[: before + 1]) > 0.0).all()
    assert (np.diff(f[before:]) < 0.0).all()
    if before:
        assert f[0] == 0.0
        assert np.isclose(f[before - 1], 1.0 - 1.0 / before**2)
    if after:
        assert f[-1] == 0.0


@given(COURSE, st.floats(-1.4, 1.4), st.data())
def test_an_edit_takes_effect_on_its_frame_and_nowhere_outside(
    course: np.ndarray, wanted: float, data: st.DataObject
) -> None:
    frame = data.draw(st.integers(0, len(course) - 1))
    values = course + REST
    changed, (first, last) = edited(values, REST, frame, REST + wanted)
    # Whole turns count as nothing.
    assert abs((changed[frame] - REST - wanted + np.pi) % (2.0 * np.pi) - np.pi) < 1e-9
    outside = np.r_[0:first, last + 1 : len(course)]
    assert np.array_equal(changed[outside], values[outside])


@given(st.floats(0.05, 1.2), st.floats(0.05, 1.2))
def test_an_adjustment_blends_and_a_reversal_forgets(old: float, new: float) -> None:
    away = old * np.sin(np.linspace(0.0, np.pi, 21)[1:-1])
    f = influence(9, Window(0, 18))
    adjusted, _ = edited(REST + away, REST, 9, REST + new)
    assert np.allclose(adjusted - REST, (1.0 - f) * away + f * new)
    reversed_, _ = edited(REST + away, REST, 9, REST - new)
    assert np.allclose(reversed_ - REST, -f * new)


def test_eq_18_as_printed_is_ours_where_the_extent_is_adjusted() -> None:
    values = REST - np.array([0.1, 0.4, 0.7, 0.5, 0.2])
    changed, window = edited(values, REST, 2, 1.1)
    f = influence(2, window)
    assert np.allclose(changed, (1.0 - f) * values + f * 1.1)


TABLE_2 = (
    # name, r, p, q, M_0, M_r, M'
    ("up_axis_angle_2", 1042, 1040, 1049, 1.6589, 0.9704, 1.1062),
    ("up_axis_angle_3", 1042, 1039, 1050, 1.5965, 0.7586, 1.0261),
    ("head_angle", 1042, 1039, 1052, 1.4987, 0.5493, 0.8666),
    ("r_fin_angle", 1042, 1040, 1132, 5.5535, 4.1450, 5.2623),
)


@pytest.mark.parametrize(("name", "r", "p", "q", "rest", "before", "wanted"), TABLE_2)
def test_table_2_on_a_course_with_its_windows(
    name: str, r: int, p: int, q: int, rest: float, before: float, wanted: float
) -> None:
    away = np.full(1200, 0.3)
    away[p : r + 1] = np.linspace(0.5 * (before - rest), before - rest, r - p + 1)
    away[r : q + 1] = np.linspace(before - rest, 0.1 * (before - rest), q - r + 1)
    session = Session(np.zeros((1200, ANGLES)), np.full(ANGLES, 0.0))
    column = NAMES.index(name)
    session.rest[column] = rest
    session.original[:, column] = session.angles[:, column] = rest + away
    assert session.edit(r, column, wanted) == (p, q)
    after = session.angles[:, column]
    assert np.isclose(after[r], wanted)
    assert np.isclose(after[p], rest + away[p])
    assert np.isclose(after[q], rest + away[q])
    middle = (r + q) // 2
    f = 1.0 - (middle - r) ** 2 / (q - r) ** 2
    assert np.isclose(after[middle], (1.0 - f) * (rest + away[middle]) + f * wanted)


@given(
    st.lists(
        st.tuples(st.integers(0, 19), st.integers(0, ANGLES - 1), st.floats(-1.0, 1.0)), max_size=8
    )
)
def test_undo_and_redo_go_back_and_forth_exactly(edits: list[tuple[int, int, float]]) -> None:
    motion = intermediate(example_clip_motion(20))
    session = Session(motion.angles, np.median(motion.angles, axis=0))
    states = [session.angles.copy()]
    for frame, column, by in edits:
        session.edit(frame, column, float(session.angles[frame, column]) + by)
        states.append(session.angles.copy())
    for state in reversed(states[:-1]):
        assert session.undo()
        assert np.array_equal(session.angles, state)
    assert not session.undo()
    for state in states[1:]:
        assert session.redo()
        assert np.array_equal(session.angles, state)
    assert not session.redo()


def test_an_edit_after_undo_ends_redo_and_saved_is_known() -> None:
    motion = intermediate(example_clip_motion(12))
    session = Session(motion.angles, np.median(motion.angles, axis=0))
    session.edit(3, 4, 5.0)
    session.mark_saved()
    unsaved = [session.unsaved]
    session.undo()
    unsaved.append(session.unsaved)
    session.edit(3, 5, 5.0)
    unsaved.append(session.unsaved)
    assert unsaved == [False, True, True]
    assert not session.can_redo
    assert session.changed().max() > 0.0


def test_a_course_a_turn_away_is_read_as_near() -> None:
    away = deviation(np.array([6.4, 6.5, 6.2]), 0.1)
    assert np.abs(away).max() < 0.3


def test_the_fine_axis_moves_with_the_bones_and_keeps_its_detail() -> None:
    motion = example_clip_motion(10)
    angles = intermediate(motion).angles.copy()
    assert np.array_equal(retouched(motion, angles, 0).axis, motion.axis)
    angles[4, NAMES.index("tail_angle")] += 0.5
    fresh = retouched(motion, angles, 1)
    assert np.array_equal(np.delete(fresh.axis, 4, 0), np.delete(motion.axis, 4, 0))
    assert np.allclose(fresh.axis[4, :38], motion.axis[4, :38])
    moved = rebuilt_axis(fresh)[4, -1] - rebuilt_axis(motion)[4, -1]
    assert np.allclose(fresh.axis[4, -1] - motion.axis[4, -1], moved, atol=1e-3)
    assert fresh.provenance["retouched"] == "1"


def test_angles_of_the_wrong_shape_are_refused() -> None:
    with pytest.raises(ValueError, match="angles are"):
        Session(np.zeros((5, 3)), np.zeros(ANGLES))
