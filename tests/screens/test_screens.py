"""The screens, driven by the events that a window reports: title, dive, pause, options, result."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from components.command import FULL
from reefgame.progress import Progress, Record
from reefgame.replay import read_replay, verify
from reefgame.settings import load as load_settings
from reefgame.world import World


def test_the_title_lists_every_level_and_dives_into_the_chosen(player: Any) -> None:
    labels = [item.label for item in player.screen.menu.items]
    assert labels[-3:] == ["Dive", "Options", "Quit"]
    assert {"Easy water", "First dive"} <= set(labels)
    player.press("RETURN")
    assert player.screen.name == "dive"
    assert player.screen.world.level.title == "Easy water"
    assert player.screen.world.clock.now == 0


def test_the_title_shows_a_sea_that_moves(player: Any) -> None:
    player.wait(2)
    before = player.view.picture()
    player.wait(40)
    after = player.view.picture()
    assert before.std() > 10
    assert np.abs(after.astype(int) - before).mean() > 0.3


def test_the_menu_is_moved_by_keys_and_by_pointer(player: Any) -> None:
    menu = player.screen.menu
    player.press("DOWN")
    assert menu.items[menu.focus].label == "Options"
    player.press("UP", "UP")
    left, top, _, height = menu._box
    row = height / len(menu.items)
    player.dispatch("on_mouse_motion", left + 10, top - height + 1.5 * row, 1, 1)
    assert menu.items[menu.focus].label == "Options"
    player.dispatch("on_mouse_press", left + 10, top - height + 1.5 * row, 1, 0)
    assert player.screen.name == "options"


def test_keys_held_steer_the_submarine(player: Any) -> None:
    player.press("RETURN")
    ship = player.screen.world.submarine
    start = ship.position[0].copy()
    for key in ("W", "A", "SPACE"):
        player.hold(key)
    player.wait(90)
    assert ship.throttle[0] > 0.9
    assert ship.yaw[0] > 0.3
    assert ship.position[0, 2] > start[2] + 0.3
    for key in ("W", "A", "SPACE"):
        player.release(key)
    player.press("X")
    player.wait(2)
    assert ship.throttle[0] == 0.0


def test_the_captured_mouse_steers_and_its_wheel_drives(player: Any) -> None:
    player.press("RETURN")
    player.wait(1)
    ship = player.screen.world.submarine
    player.dispatch("on_mouse_motion", 0, 0, 60, -30)
    player.dispatch("on_mouse_scroll", 0, 0, 0.0, 2.0)
    player.wait(30)
    assert ship.yaw[0] < -0.05
    assert ship.pitch[0] < -0.02
    assert ship.throttle[0] > 0.1


def test_the_gamepad_steers(player: Any) -> None:
    player.press("RETURN")
    player.view._gamepads.on_stick_motion(None, "leftstick", (1.0, 1.0))
    assert player.screen.controls.command()[:2] == (FULL, -FULL)
    player.view._gamepads.on_dpad_motion(None, (0.0, -1.0))
    player.view._gamepads.on_stick_motion(None, "leftstick", (0.0, 0.0))
    assert player.screen.controls.command().throttle == -FULL


def test_losing_the_focus_pauses_and_lets_go(player: Any) -> None:
    player.press("RETURN")
    player.hold("W")
    player.wait(5)
    world = player.screen.world
    assert player.view._captured
    player.dispatch("on_deactivate")
    assert player.screen.name == "pause"
    assert not player.view._captured
    at = world.clock.now
    player.wait(10)
    assert world.clock.now == at
    player.press("ESCAPE")
    assert player.screen.name == "dive"
    assert player.screen.controls.command().throttle == 0
    player.wait(5)
    assert world.clock.now == at + 5


def test_a_photograph_too_poor_says_what_lacks(player: Any) -> None:
    player.press("RETURN")
    dive = player.screen
    player.hold("A")
    player.wait(120)
    player.release("A")
    player.press("P")
    player.wait(2)
    assert dive.world.objective.shots[0] == 1
    assert "sardine" in dive._message
    assert dive.photograph is not None
    assert not dive.world.objective.done[0]


def test_a_win_is_saved_shown_and_recorded(player: Any, user_folders: Path) -> None:
    player.press("RETURN")
    player.wait(20)
    player.dispatch("on_mouse_press", 10, 10, 1, 0)
    player.wait(2)
    dive = player.screen
    assert dive.world.objective.done[0]
    saved = Progress().record(player.game.chosen)
    assert saved.wins == 1
    assert saved.score == dive.world.objective.score[0] > 0
    for _ in range(300):
        if player.screen.name == "result":
            break
        player.wait(1)
    assert player.screen.name == "result"
    player.wait(1)
    replay = read_replay(dive.recording.path)
    assert replay.ended
    assert verify(replay, World.build(player.game.load(player.game.chosen), 1)) is None
    player.press("ESCAPE")
    assert player.screen.name == "title"
    values = [item.value() for item in player.screen.menu.items if item.label == "Easy water"]
    assert values[0].startswith(f"{saved.score:,}")


def test_leaving_a_dive_keeps_its_best_photograph(player: Any) -> None:
    player.press("RETURN")
    player.hold("A")
    player.wait(120)
    player.release("A")
    player.press("P")
    player.wait(2)
    best = int(player.screen.world.objective.best[0])
    player.press("ESCAPE", "UP", "RETURN")
    assert player.screen.name == "title"
    assert Progress().record(player.game.chosen) == Record(0, None, best, 0)


def test_a_restart_begins_the_same_dive_anew(player: Any) -> None:
    player.press("RETURN")
    world = player.screen.world
    start = world.checksums()
    first = player.screen.recording.path
    player.hold("W")
    player.wait(60)
    player.release("W")
    assert world.checksums() != start
    player.press("ESCAPE", "DOWN", "RETURN")
    assert player.screen.name == "dive"
    assert world.checksums() == start
    assert player.screen.recording.path != first
    assert read_replay(first).ended


def test_options_take_effect_and_are_saved(player: Any) -> None:
    player.press("DOWN", "RETURN")
    assert player.screen.name == "options"
    player.press(
        "RIGHT", "RIGHT", "DOWN", "RETURN", "DOWN", "RIGHT", "DOWN", "LEFT", "DOWN", "RIGHT"
    )
    saved, wrong = load_settings()
    assert wrong == []
    assert saved == player.game.settings
    assert (saved.mouse_sensitivity, saved.invert_pitch) == (1.2, True)
    assert (saved.quality, saved.render_scale, saved.live_physics) == ("low", 75, 10)
    player.press("ESCAPE", "UP", "RETURN")
    player.wait(1)
    assert player.screen.world.live_fishes == 10
    assert player.screen.controls.invert_pitch
    assert player.view.picture().std() > 10


@pytest.mark.parametrize("size", [(200, 320), (480, 150), (333, 222)])
def test_every_screen_draws_at_any_size(
    player: Any, monkeypatch: pytest.MonkeyPatch, size: tuple[int, int]
) -> None:
    monkeypatch.setattr(player.view.window, "get_framebuffer_size", lambda: size)
    for keys in ([], ["RETURN"], ["H"], ["H", "ESCAPE"], ["DOWN", "DOWN", "RETURN"]):
        player.press(*keys)
        player.dispatch("on_resize", *size)
        player.wait(1)
        picture = player.view.picture()
        assert picture.shape == (size[1], size[0], 3)
        assert picture.std() > 5, player.screen.name


def test_f12_saves_pictures_under_names_of_their_own(player: Any, user_folders: Path) -> None:
    for _ in range(2):
        player.press("F12")
        player.wait(1)
    pictures = list((user_folders / "data").rglob("*.png"))
    assert len(pictures) == 2
    assert all(picture.read_bytes().startswith(b"\x89PNG") for picture in pictures)
    assert str(pictures[0].name) in " ".join(player.game.messages)


def test_a_folder_that_cannot_be_written_costs_messages_not_the_dive(
    player: Any, user_folders: Path
) -> None:
    (user_folders / "data").write_text("in the way")
    player.press("F12", "RETURN")
    player.wait(20)
    player.press("P")
    player.wait(5)
    assert player.screen.world.objective.done[0]
    told = " ".join(player.game.messages)
    assert "not recorded" in told
    assert "picture cannot be saved" in told
    assert told.count("progress cannot be") == 1


def test_prompts_follow_what_the_player_has_done(player: Any) -> None:
    player.press("RETURN")
    assert player.screen.briefing.prompt == "Drive on"
    player.hold("W")
    player.wait(60)
    assert player.screen.briefing.prompt == "Turn"
    player.hold("D")
    player.wait(40)
    assert player.screen.briefing.prompt == ""


def test_settings_with_mistakes_are_told_in_the_window(
    window: Any, user_folders: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from reefgame.settings import settings_path
    from reefgame.shelf import find_levels
    from reefgame.window import new_game

    settings_path().parent.mkdir(parents=True)
    settings_path().write_text(json.dumps({"quality": "ultra"}))
    game = new_game(find_levels("first_dive"), seed=1)
    assert len(game.messages) == 1
    assert game.messages[0].startswith(f"{settings_path()}:1:2: quality must be")
    assert game.messages[0] in capsys.readouterr().err


def test_a_replay_is_watched_to_its_end(player: Any) -> None:
    from reefgame.screens.watch import WatchScreen

    player.press("RETURN")
    player.hold("W")
    player.wait(30)
    world, path = player.screen.world, player.screen.recording.path
    player.press("ESCAPE")
    expected = world.checksums()
    player.game.to_title()
    replay = read_replay(path)
    player.game.stack.replace(lambda: WatchScreen(player.game, replay))
    player.press("SPACE")
    player.wait(10)
    assert world.clock.now == 0
    player.press("SPACE")
    player.wait(60)
    assert world.clock.now == replay.ticks == 30
    assert world.checksums() == expected
    assert player.view.picture().std() > 10


def test_keys_and_clicks_before_the_first_picture_are_not_heard(bare_view: Any) -> None:
    from pyglet.window import key

    bare_view.announce("compiling ...")
    for event, *values in (
        ("on_key_press", key.ENTER, 0),
        ("on_key_release", key.ENTER, 0),
        ("on_mouse_press", 5, 5, 1, 0),
        ("on_mouse_motion", 5, 5, 1, 1),
        ("on_mouse_scroll", 5, 5, 0, 1),
    ):
        bare_view.window.dispatch_event(event, *values)
        bare_view.window.dispatch_events()
    assert not bare_view.game.stack.open
    with pytest.raises(SystemExit) as stopped:
        bare_view.on_close()
    assert stopped.value.code == 0
