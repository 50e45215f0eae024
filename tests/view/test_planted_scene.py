"""A level with plants on show: drawn, bent by what was asked for; a twin that serves instead is told of."""

from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest

from components.camera import Camera, camera_towards
from reefgame.cli import main
from reefgame.content import Content, load
from reefgame.scene import Scene, heads_of
from reefgame.screens.stage import Stage
from reefgame.settings import Settings
from reefgame.world import World
from systems.sea.bend import NumbaBender
from systems.view.target import Target, UInt8s

PLANTS = """
plants:
  - {flora: actinia, at_m: [-22.6, -0.6]}
  - {flora: seagrass, at_m: [-22.2, -1.6]}
"""
NOTE = "fibres bend with numba: OpenCL fails its self-test (here it does)"


class Noted(NumbaBender):
    """A twin that serves for another."""

    note = NOTE


@pytest.fixture(scope="module")
def planted(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The file of the first dive with two plants before the bow, and one rock that is a brain coral."""
    text = (files("levels") / "first_dive.yaml").read_text(encoding="utf-8")
    text = text.replace("yaw_deg: 25, buried: 0.42}", "yaw_deg: 25, look: brain_coral}", 1)
    path = tmp_path_factory.mktemp("planted") / "planted.yaml"
    path.write_text(text + PLANTS, encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def content(planted: Path) -> Content:
    return load(str(planted))


@pytest.fixture(scope="module")
def world(content: Content) -> World:
    return World.build(content, 1)


@pytest.fixture(scope="module")
def camera(world: World) -> Camera:
    x, y, z = world.plants[0].position
    eye, at = np.array([x - 1.6, y + 0.2, z + 0.9]), np.array([x, y - 0.3, z + 0.2])
    return camera_towards(eye, at, 0.4663)


def drawn(scene: Scene, camera: Camera, seconds: float = 2.0) -> UInt8s:
    with Target(160, 90) as target:
        target.bind()
        scene.draw(camera, 1.0, 160, 90, seconds)
        return target.read()


def test_plants_are_in_the_picture_and_a_level_without_pays_nothing(
    world: World, camera: Camera, monkeypatch: pytest.MonkeyPatch
) -> None:
    scene = Scene(world, "low")
    green = drawn(scene, camera)
    scene.delete()
    with monkeypatch.context() as without:
        without.setattr(world, "plants", ())
        without.setattr("reefgame.scene.growth_of", lambda _: pytest.fail("it grows"))
        bare_scene = Scene(world, "low")
        bare = drawn(bare_scene, camera)
        bare_scene.delete()
    changed = np.abs(green.astype(np.int16) - bare).max(axis=2) > 24
    assert 0.05 < changed.mean() < 0.6


def test_pictures_of_a_garden_owe_nothing_to_chance(world: World, camera: Camera) -> None:
    pictures = []
    for _ in range(2):
        scene = Scene(world, "low")
        pictures.append(drawn(scene, camera))
        scene.delete()
    assert (pictures[0] == pictures[1]).all()


def test_a_pause_stops_the_sway(
    world: World, camera: Camera, monkeypatch: pytest.MonkeyPatch
) -> None:
    steps: list[float] = []

    class Counting(NumbaBender):
        def step(self, *arguments: object) -> None:
            steps.append(float(arguments[2]))  # type: ignore[arg-type]  # seconds

    monkeypatch.setattr("reefgame.scene.choose", lambda _: Counting())
    scene = Scene(world, "low")
    for seconds in (1.0, 1.0, 1.05, 1.05):
        drawn(scene, camera, seconds)
    scene.delete()
    assert steps[-1] == pytest.approx(0.05)
    assert steps[-2] == steps[0]


def test_the_player_is_told_once_that_the_twin_serves(
    content: Content,
    camera: Camera,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    asked: list[str] = []

    def choose(backend: str) -> NumbaBender:
        asked.append(backend)
        return Noted()

    monkeypatch.setattr("reefgame.scene.choose", choose)
    stage = Stage(content, 0, Settings(quality="low"), fibres="opencl")
    with Target(160, 90) as target:
        target.bind()
        for _ in range(3):
            stage.draw(camera, 160, 90)
    stage.delete()
    assert asked == ["opencl"]
    assert capsys.readouterr().err == f"{NOTE}\n"


@pytest.mark.parametrize("fibres", ["numba", "opencl"])
def test_a_shot_bends_its_plants_by_what_is_asked_for(
    planted: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fibres: str
) -> None:
    asked: list[str] = []

    def choose(backend: str) -> NumbaBender:
        asked.append(backend)
        return NumbaBender()

    monkeypatch.setattr("reefgame.scene.choose", choose)
    path = tmp_path / "shot.png"
    arguments = ["shot", str(planted), "--tick", "1", "--size", "64x36", "--fibres", fibres]
    assert main([*arguments, "-o", str(path)]) == 0
    assert asked == [fibres]
    assert path.stat().st_size > 1000


def test_what_bends_the_plants_must_be_one_of_two(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(["play", "--fibres", "steam"])
    assert left.value.code == 2
    assert "'opencl', 'numba'" in capsys.readouterr().err


def test_looks_of_rocks_are_the_eyes_affair_alone(
    content: Content, planted: Path, tmp_path: Path
) -> None:
    assert heads_of(content.level) == {0: "brain_coral"}
    plain = tmp_path / planted.name
    text = planted.read_text(encoding="utf-8").replace(", look: brain_coral", ", look: boulder")
    plain.write_text(text, encoding="utf-8")
    assert load(str(plain)).hash == content.hash
