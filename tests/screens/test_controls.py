"""Keys, mouse and gamepad become commands: whole numbers in range, nothing lost, nothing doubled."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from components.command import FULL, Command
from reefgame.controls import BINDINGS, SHUTTER_KEYS, STICKS, STOP_KEYS, Controls

NAMES = sorted({*BINDINGS, *SHUTTER_KEYS, *STOP_KEYS, "escape", "q"})
EVENTS = st.one_of(
    st.tuples(st.just("press"), st.sampled_from(NAMES)),
    st.tuples(st.just("release"), st.sampled_from(NAMES)),
    st.tuples(st.just("mouse"), st.integers(-4000, 4000), st.integers(-4000, 4000)),
    st.tuples(st.just("wheel"), st.floats(-50, 50)),
    st.tuples(st.just("stick"), st.sampled_from([*STICKS, "unknown"]), st.floats(-2, 2)),
    st.tuples(st.just("tick")),
)


def apply(controls: Controls, event: tuple[object, ...]) -> None:
    kind, *values = event
    deeds = {
        "press": controls.press,
        "release": controls.release,
        "mouse": controls.mouse_moved,
        "wheel": controls.wheel_turned,
        "stick": controls.stick_moved,
        "tick": controls.command,
    }
    deeds[str(kind)](*values)  # type: ignore[operator]  # each event carries its own arguments


@given(st.lists(EVENTS, max_size=40), st.floats(0.2, 3.0), st.booleans())
def test_every_command_is_whole_and_in_range(
    events: list[tuple[object, ...]], sensitivity: float, invert: bool
) -> None:
    controls = Controls(sensitivity, invert)
    for event in events:
        apply(controls, event)
        command = controls.command()
        assert all(type(value) is int for value in command)
        assert all(-FULL <= value <= FULL for value in command[:4])
        assert command.stop in (0, 1)
        assert command.photograph in (0, 1)


@pytest.mark.parametrize(("name", "meaning"), sorted(BINDINGS.items()))
def test_a_held_key_orders_every_tick_until_released(name: str, meaning: tuple[str, int]) -> None:
    axis, amount = meaning
    controls = Controls()
    controls.press(name)
    expected = Command()._replace(**{axis: amount})
    assert [controls.command(), controls.command()] == [expected, expected]
    controls.release(name)
    assert controls.command() == Command()


def test_opposite_keys_cancel() -> None:
    controls = Controls()
    controls.press("a")
    controls.press("d")
    assert controls.command().turn == 0


def test_a_key_tapped_between_ticks_counts_for_one() -> None:
    controls = Controls()
    for name in ("w", "x"):
        controls.press(name)
        controls.release(name)
    assert controls.command() == Command(throttle=FULL, stop=1)
    assert controls.command() == Command()


def test_each_shutter_press_is_one_rising_edge() -> None:
    controls = Controls()
    controls.press("enter")
    controls.press("mouse_left")
    assert [controls.command().photograph for _ in range(5)] == [1, 0, 1, 0, 0]


def test_all_of_a_mouse_motion_is_spent_over_the_ticks_that_follow() -> None:
    whole, halves = Controls(), Controls()
    whole.mouse_moved(-12, 6)
    halves.mouse_moved(-6, 3)
    halves.mouse_moved(-6, 3)
    spent = [whole.command() for _ in range(60)]
    again = [halves.command() for _ in range(60)]
    assert spent == again
    assert sum(command.turn for command in spent) == 12 * 14
    assert sum(command.pitch for command in spent) == 6 * 14
    assert spent[0].turn > spent[10].turn > 0
    assert spent[-1] == Command()


def test_sensitivity_scales_the_mouse_and_inversion_turns_pitch_round() -> None:
    plain, changed = Controls(), Controls(2.0, invert_pitch=True)
    for controls in (plain, changed):
        controls.mouse_moved(0, 5)
    rise = [sum(c.command().pitch for _ in range(60)) for c in (plain, changed)]
    assert rise == [70, -140]
    changed.press("up")
    assert changed.command().pitch == -FULL


def test_a_wild_fling_steers_for_a_moment_only() -> None:
    controls = Controls()
    for _ in range(100):
        controls.mouse_moved(5000, 0)
    turns = [controls.command().turn for _ in range(120)]
    assert turns[0] == -FULL
    assert turns[-1] == 0


def test_the_wheel_moves_the_throttle_and_comes_to_rest() -> None:
    controls = Controls()
    controls.wheel_turned(1)
    assert sum(controls.command().throttle for _ in range(120)) == 900


def test_a_stick_near_its_centre_is_still() -> None:
    controls = Controls()
    controls.stick_moved("leftx", 0.1)
    assert controls.command() == Command()
    controls.stick_moved("leftx", 1.0)
    assert controls.command().turn == -FULL


def test_looking_away_lets_go_of_everything() -> None:
    controls = Controls()
    controls.press("w")
    controls.press("enter")
    controls.mouse_moved(100, 100)
    controls.stick_moved("lefty", 1.0)
    controls.release_all()
    assert controls.command() == Command()
