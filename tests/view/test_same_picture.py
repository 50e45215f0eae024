"""A picture is the same without a display and in a window on one (Xvfb)."""

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

DRAW = """
import sys
import numpy as np
from systems.view import context

windowed = sys.argv[1] == "window"
context.choose_options(headless=not windowed)
if windowed:
    from pyglet.window import Window
    window = Window(64, 64, visible=True, config=context.config())
else:
    context.ensure_context()

from pyglet.window import Window
from components.camera import camera_towards
from reefgame.content import load
from reefgame.scene import QUALITIES, Scene
from reefgame.world import World
from systems.view.target import Target

assert Window.__module__.endswith("headless") is not windowed
world = World.build(load("first_dive"), 3)
camera = camera_towards(np.array([-14.0, 0.0, -11.3]), np.array([-10.8, 0.8, -10.8]), 0.4663)
for quality in QUALITIES:
    scene = Scene(world, quality)
    with Target(320, 180, QUALITIES[quality].samples) as target:
        target.bind()
        scene.draw(camera, 1.0, 320, 180, 2.0)
        np.save(f"{sys.argv[2]}-{quality}.npy", target.read())
"""


@pytest.fixture
def display() -> Iterator[str]:
    """The name of a display without a screen."""
    read, write = os.pipe()
    command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "640x480x24", "-nolisten", "tcp"]
    server = subprocess.Popen(command, pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    with os.fdopen(read) as answer:
        yield f":{answer.readline().strip()}"
    server.terminate()
    server.wait(30)


def test_without_a_display_and_in_a_window_the_picture_is_the_same(
    display: str, tmp_path: Path, installed: Path
) -> None:
    bare = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    for kind, environment in (("headless", bare), ("window", bare | {"DISPLAY": display})):
        subprocess.run(
            [sys.executable, "-c", DRAW, kind, str(tmp_path / kind)],
            check=True,
            cwd=installed,
            env=environment,
            timeout=240,
        )
    for quality in ("low", "high"):
        headless, window = (
            np.load(tmp_path / f"{kind}-{quality}.npy").astype(np.int16)
            for kind in ("headless", "window")
        )
        assert headless.shape == (180, 320, 3)
        assert headless.std() > 20
        away = np.abs(headless - window)
        assert away.mean() < 0.5
        assert (away.max(axis=2) > 8).mean() < 0.002
