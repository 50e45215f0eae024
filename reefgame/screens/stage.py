"""The sea on show: a world that ticks at its fixed rate and the scene that draws it (DESIGN 3, 5).

Title and dive share one stage: a dive starts from the snapshot taken before the first tick, so it
is the same dive whatever swam behind the title.
"""

from collections.abc import Callable
from ctypes import c_int
from dataclasses import dataclass
from typing import Final

from pyglet import gl
from pyglet.gl import gl_info

from components.camera import Camera
from components.command import Command
from reefgame.console import complain
from reefgame.content import Content
from reefgame.loop import FixedStep
from reefgame.scene import QUALITIES, Scene
from reefgame.settings import Settings
from reefgame.world import World
from systems.sea.choose import Backend
from systems.view.target import Target

_SOFTWARE: Final = ("llvmpipe", "softpipe", "swrast", "swiftshader", "software")
"""What OpenGL calls itself where no graphics card draws."""


@dataclass(frozen=True)
class Drawing:
    """How the sea is drawn: the scene's quality, samples a pixel and the largest height [px]."""

    quality: str
    samples: int
    height: int


def drawing(quality: str, renderer: str) -> Drawing:
    """Return how to draw at a `quality` of the settings, on an OpenGL that names its renderer so."""
    if quality == "auto":
        software = any(name in renderer.lower() for name in _SOFTWARE)
        quality = "low" if software else "high"
    tier = QUALITIES["low" if quality == "low" else "high"]
    samples = tier.samples if quality == "high" else 0
    return Drawing("low" if quality == "low" else "high", samples, tier.height)


class Stage:
    """World, scene and the time between ticks."""

    def __init__(
        self,
        content: Content,
        seed: int,
        settings: Settings,
        live: int = 0,
        fibres: Backend = "auto",
    ) -> None:
        self.world = World.build(content, seed, live)
        self.seed = seed
        self.seconds = 0.0
        self._start = self.world.snapshot()
        self._step = FixedStep()
        self._scale = settings.render_scale
        self._drawing = drawing(settings.quality, gl_info.get_renderer())
        self._fibres = fibres
        self._noted = ""
        self._scene = Scene(self.world, self._drawing.quality, fibres)
        self._target: Target | None = None

    @property
    def alpha(self) -> float:
        """How far the picture stands between the last two ticks, 0 to 1."""
        return self._step.alpha

    def restart(self) -> None:
        """Bring the world back to before its first tick."""
        self.world.restore(self._start)
        self._step = FixedStep()

    def apply(self, settings: Settings) -> None:
        """Draw as the settings say from now on."""
        self._scale = settings.render_scale
        wanted = drawing(settings.quality, gl_info.get_renderer())
        if wanted.quality != self._drawing.quality:
            self._scene.delete()
            self._scene = Scene(self.world, wanted.quality, self._fibres)
        if wanted.samples != self._drawing.samples and self._target is not None:
            self._target.delete()
            self._target = None
        self._drawing = wanted

    def advance(
        self,
        seconds: float,
        pilot: Callable[[], Command],
        after: Callable[[Command], None] = lambda _: None,
    ) -> None:
        """Take the ticks due after a frame of `seconds`: ask the pilot, tick, tell `after`."""
        self.seconds += seconds
        for _ in range(self._step.ticks(seconds)):
            self.hop(pilot, after)

    def hop(self, pilot: Callable[[], Command], after: Callable[[Command], None]) -> None:
        """Take one tick, whatever time has passed."""
        command = pilot()
        self.world.tick(command)
        after(command)

    def draw(self, camera: Camera, width: int, height: int) -> None:
        """Draw the sea over the window's framebuffer, width x height [px]."""
        self._tell()
        tall = max(1, min(height, self._drawing.height) * self._scale // 100)
        if tall == height and not self._drawing.samples:
            self._scene.draw(camera, self.alpha, width, height, self.seconds)
            return
        window = c_int()
        gl.glGetIntegerv(gl.GL_DRAW_FRAMEBUFFER_BINDING, window)
        target = self._sized(max(1, width * tall // height), tall)
        target.bind()
        self._scene.draw(camera, self.alpha, target.width, target.height, self.seconds)
        target.show(window.value, width, height)
        gl.glViewport(0, 0, width, height)

    def _tell(self) -> None:
        """Say once why plants are bent by something else than was asked for: it may show late."""
        if self._scene.note != self._noted:
            self._noted = self._scene.note
            complain(self._noted)

    def delete(self) -> None:
        """Free what the GPU holds."""
        self._scene.delete()
        if self._target:
            self._target.delete()
        self._target = None

    def _sized(self, width: int, height: int) -> Target:
        target = self._target
        if target is None or (target.width, target.height) != (width, height):
            if target is not None:
                target.delete()
            target = self._target = Target(width, height, self._drawing.samples)
        return target
