"""A whole world drawn: all its parts in order, whatever OpenGL was left like, and `reefgame shot`."""

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from pyglet import gl

from components.camera import Camera, camera_towards
from reefgame.cli import main
from reefgame.content import load, load_species
from reefgame.scene import QUALITIES, Scene
from reefgame.shot import portrait
from reefgame.world import World
from systems.view.target import Target, UInt8s, decode_png

SIZE = (160, 90)


@pytest.fixture(scope="module")
def world() -> World:
    """The first dive a few ticks in."""
    dive = World.build(load("first_dive"), 1)
    for _ in range(5):
        dive.tick()
    return dive


@pytest.fixture(scope="module")
def scene(world: World) -> Iterator[Scene]:
    drawn = Scene(world, "low")
    yield drawn
    drawn.delete()


@pytest.fixture
def camera(world: World) -> Camera:
    """From close by towards the middle of the fishes."""
    fish = world.population.fish
    middle = np.median(fish.position[: fish.count], axis=0)
    return camera_towards(middle + np.array([-2.0, -1.5, 0.4]), middle)


def drawn(scene: Scene, camera: Camera, alpha: float = 1.0, size: tuple[int, int] = SIZE) -> UInt8s:
    with Target(*size) as target:
        scene.draw(camera, alpha, *size, 2.0)
        return target.read()


def difference(first: UInt8s, second: UInt8s) -> UInt8s:
    away: UInt8s = np.abs(first.astype(np.int16) - second).max(axis=2).astype(np.uint8)
    return away


@pytest.mark.golden
def test_the_first_dive_looks_as_it_did(
    same_frame: Callable[[str, UInt8s], bool],
) -> None:
    # As it starts, before any fish has a mind of its own.
    start = World.build(load("first_dive"), 1)
    scene = Scene(start, "high")
    camera = camera_towards(np.array([-14.0, 0.0, -11.3]), np.array([-10.8, 0.8, -10.8]), 0.4663)
    picture = drawn(scene, camera, size=(320, 180))
    scene.delete()
    assert same_frame("first_dive", picture)


def test_the_fishes_are_in_the_picture(scene: Scene, world: World, camera: Camera) -> None:
    with_fishes = drawn(scene, camera)
    before = world.snapshot()
    for identity in world.population.fish.live("id").tolist():
        world.population.remove(int(identity))
    without = drawn(scene, camera)
    world.restore(before)
    away = difference(with_fishes, without)
    assert (away > 20).sum() > 20
    assert (away > 20).mean() < 0.5
    assert (drawn(scene, camera) == with_fishes).all()


def test_food_is_in_the_picture_while_it_is_in_the_water(scene: Scene, world: World) -> None:
    food, middle = world.food, world.patches.around[0]
    camera = camera_towards(middle + np.array([-1.5, 0.0, 0.0]), middle)
    before = world.snapshot()
    with_food = drawn(scene, camera)
    food.returns[: food.count] = world.clock.now + 1
    without = drawn(scene, camera)
    world.restore(before)
    changed = difference(with_food, without) > 8
    assert 20 < changed.sum() < 0.1 * changed.size


def test_an_open_mouth_changes_the_head_alone(scene: Scene, world: World) -> None:
    fish, mind = world.population.fish, world.population.mind
    forward, dorsal = fish.rotation[0, :, 0], fish.rotation[0, :, 1]
    nose = fish.position[0] + 0.05 * forward
    camera = camera_towards(nose + 0.35 * np.cross(forward, dorsal), nose)
    before = world.snapshot()
    shut = drawn(scene, camera)
    mind.gape[0] = 1.0
    wide = drawn(scene, camera)
    world.restore(before)
    changed = difference(wide, shut) > 20
    assert 10 < changed.sum() < 0.1 * changed.size
    assert (drawn(scene, camera) == shut).all()


def test_fishes_stand_between_two_ticks(scene: Scene, world: World, camera: Camera) -> None:
    before = world.snapshot()
    fish = world.population.fish
    fish.live("last_position")[:] = fish.live("position") - np.array([0.0, 0.4, 0.0])
    old, halfway, new = (drawn(scene, camera, alpha) for alpha in (0.0, 0.5, 1.0))
    world.restore(before)
    assert difference(old, new).any()
    assert difference(old, halfway).any()
    assert difference(halfway, new).any()


def test_a_picture_owes_nothing_to_what_was_drawn_before(scene: Scene, camera: Camera) -> None:
    clean = drawn(scene, camera)
    with Target(*SIZE) as target:
        gl.glEnable(gl.GL_BLEND)
        gl.glBlendFunc(gl.GL_ONE, gl.GL_ONE)
        gl.glEnable(gl.GL_SCISSOR_TEST)
        gl.glScissor(0, 0, 3, 3)
        gl.glDepthMask(False)
        gl.glDepthFunc(gl.GL_NEVER)
        gl.glEnable(gl.GL_CULL_FACE)
        scene.draw(camera, 1.0, *SIZE, 2.0)
        assert (target.read() == clean).all()
    assert not gl.glIsEnabled(gl.GL_DEPTH_TEST)
    assert not gl.glIsEnabled(gl.GL_BLEND)
    assert gl.glGetError() == gl.GL_NO_ERROR


def test_low_quality_shows_the_same_sea(scene: Scene, world: World, camera: Camera) -> None:
    fine = Scene(world, "high")
    high = drawn(fine, camera)
    fine.delete()
    low = drawn(scene, camera)
    assert QUALITIES["low"].samples == 0
    assert 0 < difference(low, high).mean() < 12
    assert low.mean() > 40


def test_shot_writes_the_picture_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "shot.png"
    where = ["--from=-20,0,-7", "--at=-10,0,-8"]
    assert (
        main(["shot", "first_dive", "--tick", "2", *where, "--size", "64x36", "-o", str(path)]) == 0
    )
    assert capsys.readouterr().out == f"{path}\n"
    picture = decode_png(path.read_bytes())
    assert picture.shape == (36, 64, 3)
    assert picture.std() > 15


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (["first_dive", "--size", "0x0"], "size '0x0'"),
        (["no_such_level"], "no_such_level"),
        (["first_dive", "--from", "1,2,3"], "--from needs --at as well"),
        (["first_dive", "-o", "missing/shot.png"], "cannot be written"),
    ],
)
def test_a_shot_that_cannot_be_taken_says_so_in_one_line_and_writes_nothing(
    arguments: list[str],
    complaint: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["shot", "-o", "shot.png", *arguments]) == 1
    said = capsys.readouterr()
    assert (said.out, said.err.count("\n")) == ("", 1)
    assert complaint in said.err
    assert list(tmp_path.iterdir()) == []


def test_a_portrait_has_the_fish_in_its_middle() -> None:
    picture = portrait(load_species("sardine"), 120, 80)
    column = picture[:, 118:].astype(np.int16).mean(axis=1, keepdims=True)
    away = np.abs(picture - column).max(axis=2) > 30
    rows, columns = np.nonzero(away)
    assert away[36:44, 40:80].mean() > 0.5
    assert abs(np.median(rows) - 40) < 8
    assert abs(np.median(columns) - 60) < 14
