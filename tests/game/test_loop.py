"""The fixed step: whole ticks out of uneven frames."""

from hypothesis import given
from hypothesis import strategies as st

from components.clock import TICK_SECONDS
from reefgame.loop import MOST_TICKS_A_FRAME, FixedStep


@given(st.lists(st.floats(0.0, 0.05), max_size=200))
def test_frames_add_up_to_the_time_that_passed(frames: list[float]) -> None:
    step = FixedStep()
    ticks = sum(step.ticks(seconds) for seconds in frames)
    assert abs((ticks + step.alpha) * TICK_SECONDS - sum(frames)) < 1e-9


@given(st.floats(0.0, 1e6))
def test_a_slow_frame_never_takes_more_than_five_ticks(seconds: float) -> None:
    step = FixedStep()
    assert step.ticks(seconds) <= MOST_TICKS_A_FRAME
    assert 0.0 <= step.alpha < 1.0


def test_a_long_pause_is_forgotten_and_not_caught_up() -> None:
    step = FixedStep()
    assert step.ticks(10.0) == MOST_TICKS_A_FRAME
    assert step.ticks(TICK_SECONDS * 1.5) == 1


def test_time_that_runs_backwards_changes_nothing() -> None:
    step = FixedStep()
    step.ticks(TICK_SECONDS * 0.5)
    assert step.ticks(-5.0) == 0
    assert abs(step.alpha - 0.5) < 1e-12
