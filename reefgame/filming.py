"""Films a replay through the player's eyes, into an mp4 and the picture of its best moment."""

from collections.abc import Iterator
from pathlib import Path
from typing import Final

from components.camera import Camera
from components.clock import TICKS_PER_SECOND
from components.command import Command
from reefgame.console import Report, progress_bar, say
from reefgame.eyes import eyes
from reefgame.film import FRAMES_PER_SECOND, Film, check_film
from reefgame.output import replacing
from reefgame.replay import Replay
from reefgame.scene import Scene
from reefgame.world import World
from systems.view.target import Target, UInt8s, write_png

COCKPIT_SLOPE: Final = 0.4663
"""Tangent of half the field of view of films and pictures, 50 degrees: fishes look as near as they are."""
_STEP = TICKS_PER_SECOND // FRAMES_PER_SECOND


def film(
    record: Replay, world: World, video: Path | None, picture: Path | None, size: tuple[int, int]
) -> None:
    """Play `record` in its fresh `world` and write the film, the picture, or both.

    Raise NoFilmError, TargetError, NoOpenGLError or InputError; nothing half-written stays.
    """
    if video:
        check_film(*size)
    target = Target(*size)
    scene = Scene(world)
    reel = Film(video, *size) if video else None
    try:
        with progress_bar("filming") as report:
            best = _best_moment(record)
            for tick in _frames(record, world, report):
                if reel is not None:
                    reel.add(draw(scene, target, world))
                if picture and best <= tick < best + _STEP:
                    with replacing(picture) as fresh:
                        write_png(fresh, draw(scene, target, world))
        if reel is not None:
            reel.close()
    except BaseException:
        if reel is not None:
            reel.discard()
        raise
    if video:
        say(f"{video}")
    if picture:
        say(f"{picture}")


def cockpit(world: World, alpha: float = 1.0) -> Camera:
    """Return the player's camera, the submarine's or the fish's, `alpha` of the way from the last tick to this."""
    return eyes(world, alpha, COCKPIT_SLOPE)


def draw(scene: Scene, target: Target, world: World) -> UInt8s:
    """Return the picture of the world as it stands after its last tick, (height, width, 3)."""
    target.bind()
    seconds = world.clock.now / TICKS_PER_SECOND
    scene.draw(cockpit(world), 1.0, target.width, target.height, seconds)
    return target.read()


def _frames(record: Replay, world: World, report: Report) -> Iterator[int]:
    """Tick the world through the replay; yield the tick of every frame of the film."""
    for tick, command in enumerate(record.play()):
        world.tick(command)
        if tick % _STEP == 0:
            report(tick / max(record.ticks, 1), "filming")
            yield tick


def _best_moment(record: Replay) -> int:
    """Return the tick of the last photograph, or the middle of a dive without one."""
    shutter = Command._fields.index("photograph")
    photographs = [tick for tick, command in record.commands.items() if command[shutter]]
    moment = max(photographs, default=record.ticks // 2)
    return min(moment, max(record.ticks - 1, 0)) // _STEP * _STEP
