"""What is drawn, in order: plants, rocks, rubble, seabed, its shadows, open water, fishes, food, motes (DESIGN 3, 5).

The water fills only the pixels that nothing has covered yet, so its shader, the dearest, runs once
a pixel; fishes come after it because their fins are blended over what lies behind.
"""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

import numpy as np

from components.arrays import Float32s
from components.camera import Camera
from components.field import pack
from reefgame.bed import Bed, growth_of
from reefgame.content.schema.level import Level
from systems.sea.choose import Backend, choose
from systems.sea.pass_by import PassBy
from systems.view.context import ensure_context
from systems.view.cull import view_of
from systems.view.draw_contact import NO_FEET, DrawContact
from systems.view.draw_corals import DrawCorals, Head
from systems.view.draw_fish import DrawFish
from systems.view.draw_food import DrawFood
from systems.view.draw_ground import DrawGround
from systems.view.draw_motes import DrawMotes
from systems.view.draw_rocks import DrawRocks
from systems.view.draw_rubble import DrawRubble
from systems.view.draw_water import DrawWater
from systems.view.frame import FrameBlock, Look
from systems.view.target import start_drawing, stop_drawing

if TYPE_CHECKING:
    from reefgame.world import World


@dataclass(frozen=True)
class Quality:
    """How much work a picture is worth."""

    defines: tuple[str, ...]
    "of the shaders of the sea"
    motes: int
    detail: float
    "of fishes and plants: as if the target were so much higher"
    triangles: int
    "of plants at most"
    samples: int
    "of a target that shows this scene; 0 smooths no edges"
    height: int
    "[px] of the largest target worth drawing; a window shows it stretched"


QUALITIES: Final = {
    "low": Quality(("LOW",), motes=300, detail=0.45, triangles=20_000, samples=0, height=360),
    "high": Quality((), motes=900, detail=1.0, triangles=60_000, samples=4, height=2160),
}
"""By the name that settings give; low serves software OpenGL."""


def look_of(level: Level) -> Look:
    """Return what the level says of its water and sun, as the view wants it."""
    return Look(
        visibility=level.water.visibility_m,
        depth=level.world.depth_m,
        sun_elevation=level.sun.elevation_deg,
        sun_azimuth=level.sun.azimuth_deg,
    )


def heads_of(level: Level) -> dict[int, Head]:
    """Return how those of the level's rocks look that are coral heads, by index."""
    return {at: rock.look for at, rock in enumerate(level.rocks) if rock.look != "boulder"}


class Scene:
    """Draws one world. Reads its terrain, plants, flow and population; writes to the GPU only.

    `quality` is a key of QUALITIES, `fibres` what bends the plants. Raise NoOpenGLError where nothing can be drawn.
    """

    def __init__(self, world: "World", quality: str = "high", fibres: Backend = "numba") -> None:
        ensure_context()
        self.quality = QUALITIES[quality]
        self._world = world
        self._look = look_of(world.level)
        defines = self.quality.defines
        self._frame = FrameBlock(smooth=quality == "high")
        self._bed = self._grown(fibres) if world.plants else None
        self._passers = None if self._bed is None else self._passing(self._bed)
        self._ground = DrawGround(world.terrain, self._look.sun(), defines)
        heads = heads_of(world.level)
        boulders = [rock for rock in range(len(world.level.rocks)) if rock not in heads]
        self._rocks = DrawRocks(world.terrain, self._look.sun(), defines, boulders)
        self._corals = DrawCorals(world.terrain, self._look.sun(), heads, defines)
        feet = NO_FEET if self._bed is None else self._bed.feet()
        self._contact = DrawContact(world.terrain, self._look.sun(), feet)
        self._rubble = DrawRubble(world.terrain, self._look.sun(), defines)
        self._water = DrawWater(defines)
        self._fish = DrawFish(world.species, world.library)
        self._food = DrawFood()
        self._motes = DrawMotes(self.quality.motes)

    def draw(self, camera: Camera, alpha: float, width: int, height: int, seconds: float) -> None:
        """Draw into the bound framebuffer of width x height [px], all of it.

        Fishes stand `alpha` of the way from the last tick to this; water and motes move by `seconds`.
        """
        aspect = width / height
        start_drawing(width, height)
        look = replace(self._look, visibility=min(self._look.visibility, camera.sight))
        self._frame.update(camera, width, height, seconds, look)
        pixels = height * self.quality.detail
        if self._bed is not None:
            view = view_of(camera, pixels, aspect, look.visibility)
            self._bed.draw(view, self._flow(alpha), seconds)
        self._rocks.draw(camera, aspect, height)
        self._corals.draw(camera, aspect, height)
        self._rubble.draw(camera, aspect)
        self._ground.draw(camera, aspect)
        self._contact.draw(camera, aspect)
        self._water.draw()
        self._fish.draw(
            *(self._world.population, camera, alpha, seconds, pixels, look.visibility),
            aspect=aspect,
        )
        self._food.draw(self._world.food, camera, alpha, self._world.clock.now)
        self._motes.draw()
        stop_drawing()

    @property
    def note(self) -> str:
        """Return why something else bends the plants than was asked for, in one line; empty where nothing does."""
        return "" if self._bed is None else self._bed.bender.note

    def _flow(self, alpha: float) -> Float32s:
        """Return what stirs the plants: the level's singularities, and the fishes that pass."""
        world = self._world
        steady = pack(world.singularities, world.clock.now - 1 + alpha)
        return np.concatenate([steady, self._passers(alpha)]) if self._passers else steady

    def _grown(self, fibres: Backend) -> Bed:
        quality = self.quality
        return Bed(
            growth_of(self._world),
            self._world.terrain,
            self._look.sun(),
            choose(fibres),
            quality.triangles,
            quality.defines,
        )

    def _passing(self, bed: Bed) -> PassBy:
        world = self._world
        spheres = bed.garden.clump_sphere
        return PassBy(world.population, world.species, spheres, world.terrain.radius)

    def delete(self) -> None:
        """Free all that the scene holds on the GPU."""
        if self._bed is not None:
            self._bed.delete()
        for part in (
            *(
                self._frame,
                self._ground,
                self._rocks,
                self._corals,
                self._rubble,
                self._contact,
                self._water,
                self._fish,
                self._food,
                self._motes,
            ),
        ):
            part.delete()
