"""The inspector, driven by the events that a window reports; and the helm of a fish."""

from typing import Any

import numpy as np
import pytest

from components.mind import Intention, Why
from reefgame import recordings
from reefgame.explain import explain, reason_of
from reefgame.replay import read_replay, verify
from reefgame.world import World


def inspect(player: Any, ticks: int = 90) -> Any:
    """Dive for a while and open the inspector; return its screen."""
    player.press("RETURN")
    player.wait(ticks)
    player.press("I")
    player.wait(1)
    assert player.screen.name == "inspector"
    return player.screen


def test_b_becomes_a_fish_and_lets_go(player: Any) -> None:
    player.press("RETURN")
    dive = player.screen
    player.press("B")
    player.wait(2)
    assert dive.world.avatar.attached
    assert dive._message == "You are a sardine"
    at_fish = player.view.picture()
    player.press("V")
    player.wait(30)
    assert dive.world.avatar.behind[0] == 1
    assert (player.view.picture() != at_fish).mean() > 0.2
    row = dive.world.population.row(int(dive.world.avatar.fish[0]))
    player.dispatch("on_mouse_press", 10, 10, 4, 0)
    player.wait(2)
    assert dive.world.population.mind.gape[row] == 1.0
    player.dispatch("on_mouse_release", 10, 10, 4, 0)
    player.press("P")
    player.wait(3)
    assert dive.world.objective.shots[0] == 0
    player.press("B")
    player.wait(2)
    assert not dive.world.avatar.attached
    assert dive._message == "Back at the helm"


def test_a_lost_fish_is_told(player: Any) -> None:
    player.press("RETURN", "B")
    dive = player.screen
    player.wait(2)
    dive.world.spawn.lose(int(dive.world.avatar.fish[0]))
    player.wait(2)
    assert dive._message.startswith("You were eaten")


def test_the_inspector_holds_the_dive_and_explains_a_fish(player: Any) -> None:
    screen = inspect(player)
    world, at = screen.world, screen.world.clock.now
    player.wait(10)
    assert world.clock.now == at
    row = world.population.row(screen.chosen)
    told = explain(world, row)
    assert screen._card._title._text == told.title
    assert screen._card._reason._text == told.reason != ""
    assert player.view.picture().std() > 10


def test_fishes_are_cycled_and_clicked(player: Any) -> None:
    screen = inspect(player)
    first = screen.chosen
    player.press("TAB")
    assert screen.chosen != first
    player.press("UP")
    assert screen.chosen == first
    fish = screen.world.population.fish
    points, ahead = screen._lens.project(fish.position[: fish.count])
    shown = (ahead > 0.1) & (points[:, 1] > 60.0)
    clicks = [k for k in np.flatnonzero(shown) if fish.id[k] != first]
    other = next(k for k in clicks if screen._under(*points[k]) == fish.id[k])
    player.dispatch("on_mouse_press", *map(float, points[other]), 1, 0)
    assert screen.chosen == fish.id[other]


def test_time_is_stepped_slowed_and_hurried(player: Any) -> None:
    screen = inspect(player)
    at = screen.world.clock.now
    player.press("RIGHT", "RIGHT")
    assert screen.world.clock.now == at + 2
    player.press("LEFT")
    assert screen.world.clock.now == at + 1
    player.press("END", "SPACE", "PLUS", "PLUS", "PLUS")
    assert screen.rate == 8.0
    player.wait(10)
    assert abs(screen.world.clock.now - (at + 2 + 80)) <= 2
    player.press(*["MINUS"] * 4)
    now = screen.world.clock.now
    player.wait(20)
    assert screen.world.clock.now == pytest.approx(now + 10, abs=1)


def test_scrubbing_leaves_the_present_and_the_recording_as_they_were(player: Any) -> None:
    screen = inspect(player, 150)
    dive, world = screen.host, screen.world
    player.press("RIGHT")
    present = world.checksums()
    player.press("HOME")
    player.wait(1)
    assert world.clock.now == 0
    assert world.checksums() != present
    left, low, wide, tall = screen._bar.bar
    player.dispatch("on_mouse_press", left + 0.5 * wide, low + 0.5 * tall, 1, 0)
    assert world.clock.now == pytest.approx(75, abs=2)
    player.dispatch("on_mouse_drag", left + 0.8 * wide, low, 5, 0, 1, 0)
    assert world.clock.now == pytest.approx(121, abs=2)
    player.press("SPACE")
    player.wait(5)
    assert not screen.timeline.at_present
    player.press("ESCAPE")
    assert player.screen is dive
    assert world.checksums() == present
    player.wait(30)
    dive.recording.close()
    replay = read_replay(dive.recording.path)
    assert replay.ticks == world.clock.now
    assert verify(replay, World.build(player.game.load(player.game.chosen), 1)) is None


def test_the_fish_is_circled_by_dragging_and_neared_by_the_wheel(player: Any) -> None:
    screen = inspect(player)
    before = screen.camera()
    player.dispatch("on_mouse_drag", 400.0, 200.0, 80, 20, 1, 0)
    player.dispatch("on_mouse_scroll", 0, 0, 0.0, 3.0)
    after = screen.camera()
    assert before.forward @ after.forward < 0.95
    assert screen._away < 1.5


def test_a_fish_that_is_no_more_is_said_to_be_gone(player: Any) -> None:
    screen = inspect(player)
    screen.world.spawn.lose(screen.chosen)
    player.wait(2)
    assert screen._card._title._text == "No such fish now"
    player.press("TAB")
    player.wait(1)
    assert screen._card._title._text.startswith("Sardine")


def test_the_pause_leads_to_the_inspector(player: Any) -> None:
    player.press("RETURN", "ESCAPE", "DOWN", "DOWN", "RETURN")
    assert player.screen.name == "inspector"


@pytest.mark.parametrize(
    ("why", "value", "expected"),
    [
        (Why.FEAR_ESCAPE, 0.93, "fear 0.93 above 0.5; sardine 1, "),
        (Why.HUNGER, 0.4, "hunger 0.40 above 0.25; sardine 1, "),
        (Why.OBSTACLE, 0.5, "an obstacle ahead, at 0.50 of the distance that alarms"),
        (Why.COMPANY, 7.0, "sees 7 of its kind"),
        (Why.PERSISTENCE, 90.0, "stays with it for 1.5 s yet"),
        (Why.PLAYER, 0.0, "you steer it"),
    ],
)
def test_a_reason_names_its_numbers(player: Any, why: Why, value: float, expected: str) -> None:
    world = player.game.stage.world
    mind, row = world.population.mind, world.population.row(0)
    mind.intention[row], mind.focus[row] = Intention.ESCAPE, 1
    mind.why[row], mind.why_value[row], mind.danger[row] = why, value, 0.85
    assert reason_of(world, row).startswith(expected)
    for every in Why:
        mind.why[row] = every
        assert reason_of(world, row)


def test_a_replay_that_is_watched_is_inspected_too(player: Any) -> None:
    from reefgame.screens.watch import WatchScreen

    player.press("RETURN", "B")
    player.wait(60)
    player.press("ESCAPE", "UP", "RETURN")
    (path,) = recordings.kept()
    replay = read_replay(path)
    player.game.stack.replace(lambda: WatchScreen(player.game, replay))
    player.wait(40)
    watch, world = player.screen, player.game.stage.world
    assert world.avatar.attached
    player.press("I", "RIGHT")
    present = world.checksums()
    player.press("HOME")
    assert world.clock.now == 0
    player.press("ESCAPE")
    assert player.screen is watch
    assert world.checksums() == present
    player.wait(60)
    assert world.clock.now == replay.ticks
    assert world.checksums() == played(player, replay).checksums()


def played(player: Any, replay: Any) -> World:
    """Return a fresh world that has played the replay."""
    world = World.build(player.game.load(player.game.chosen), replay.seed)
    assert verify(replay, world) is None
    return world
