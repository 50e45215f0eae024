"""The inspector: any fish, what it sees, feels, wants and why; time held, stepped, slowed, hurried and turned back.

Looking back is looking only: the newest moment is kept and comes back as the inspector closes, and what is ordered
while it is open is recorded like the rest of the dive.
"""

from collections.abc import Callable
from math import cos, sin
from typing import Final, Protocol

import numpy as np

from components.arrays import Float64s
from components.camera import Camera, camera_towards
from components.clock import TICKS_PER_SECOND
from components.command import Command
from components.terrain import confine
from reefgame.explain import explain
from reefgame.eyes import eyes
from reefgame.screens.game import Game
from reefgame.screens.inspector_panel import MindCard, TimeBar
from reefgame.screens.screen import Screen, trace
from reefgame.screens.seen import Lens, draw_attention, place_of
from reefgame.screens.strokes import Strokes
from reefgame.screens.viewfinder import slope_for
from reefgame.timeline import Timeline

RATES: Final = (0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0)
_PLAIN: Final = RATES.index(1.0)
_JUMP: Final = 5 * TICKS_PER_SECOND
_TICKS_AT_ONCE: Final = 4.0 / TICKS_PER_SECOND
"""[s] of simulated time handed to the stage at once: it takes no more than five ticks."""
_PER_PIXEL: Final = 0.006
_STEEPEST: Final = 1.45
_NEAREST, _FARTHEST = 0.25, 25.0
_PICK: Final = 48.0
"""[units] from a click within which a fish is chosen."""
_BERTH: Final = 0.12
_SLOPE: Final = 0.45


class Host(Protocol):
    """The screen below: who drives while the inspector is open, and who writes down what happened."""

    timeline: Timeline

    def drive(self) -> Command:
        """Return the orders of the next tick."""

    def ticked(self, command: Command) -> None:
        """Take note of a tick that was played at the present."""


class InspectorScreen(Screen):
    """Opened over a dive, which waits."""

    name = "inspector"

    def __init__(self, game: Game, host: Host) -> None:
        super().__init__(game)
        self.host, self.stage, self.timeline = host, game.stage, host.timeline
        self.world = game.stage.world
        self.held = True
        self._rate = _PLAIN
        self._live = True
        self._sea, self._ink = Strokes(), Strokes()
        self._yaw, self._pitch, self._away = 0.6, 0.45, 2.0
        self._scrubbing = False
        self._at = np.zeros(3)
        self.chosen = -1
        self._size = (1, 1)
        self._deeds = self._keys()
        self.choose(self._first())

    @property
    def rate(self) -> float:
        """How fast time goes when it is not held."""
        return RATES[self._rate]

    def closed(self) -> None:
        """Come back to the present."""
        self.timeline.to_present()
        self._sea.delete()
        self._ink.delete()

    def layout(self) -> None:
        """Set up the card and the bar of time."""
        self._card = MindCard(self.canvas)
        self._bar = TimeBar(
            self.canvas,
            {
                "-5 s": lambda: self._by(-_JUMP),
                "-1": lambda: self._by(-1),
                "hold": self._toggle,
                "+1": self.step,
                "+5 s": lambda: self._by(_JUMP),
                "now": self._to_present,
                "slower": lambda: self._change_rate(-1),
                "faster": lambda: self._change_rate(1),
            },
        )
        self._show()

    def choose(self, identity: int) -> None:
        """Look at the fish `identity`."""
        if identity < 0 or identity == self.chosen:
            return
        self.chosen = identity
        row = self.world.population.row(identity)
        length = float(self.world.population.fish.length[row])
        self._away = min(max(5.0 * length + 1.2, _NEAREST), _FARTHEST)
        trace(f"chosen {explain(self.world, row).title}")

    def update(self, seconds: float) -> None:
        """Take the ticks that are due."""
        if not self.held:
            left = seconds * self.rate
            while left > 0.0:
                self.stage.advance(min(left, _TICKS_AT_ONCE), self._pilot, self._after)
                left -= _TICKS_AT_ONCE
        self._show()

    def step(self) -> None:
        """Take one tick."""
        self.held = True
        self.stage.hop(self._pilot, self._after)
        trace(f"tick {self.world.clock.now}")

    def seek(self, tick: int) -> None:
        """Go to a tick of the past, or to the present."""
        self.held = True
        self.timeline.seek(tick)
        trace(f"tick {self.world.clock.now}")

    def _to_present(self) -> None:
        self.timeline.to_present()
        trace(f"tick {self.world.clock.now}")

    def _toggle(self) -> None:
        self.held = not self.held

    def _change_rate(self, by: int) -> None:
        self._rate = min(max(self._rate + by, 0), len(RATES) - 1)

    def _pilot(self) -> Command:
        self._live = self.timeline.at_present
        return self.host.drive() if self._live else self.timeline.command(self.world.clock.now)

    def _after(self, command: Command) -> None:
        if self._live:
            self.host.ticked(command)
        else:
            self.timeline.catch_up()

    def _first(self) -> int:
        """Return the fish that the player is, else the one nearest the middle of what the player sees, -1 for none."""
        avatar, fish = self.world.avatar, self.world.population.fish
        if avatar.attached or not fish.count:
            return int(avatar.fish[0])
        camera = eyes(self.world, 1.0, _SLOPE)
        way = fish.position[: fish.count] - camera.eye
        ahead = way @ camera.forward
        far = np.linalg.norm(way, axis=1)
        return int(fish.id[int(np.argmax(ahead / (far + 1e-9) - 0.02 * far))])

    def _row(self) -> int | None:
        people = self.world.population
        return people.row(self.chosen) if self.chosen in people else None

    def _next(self, by: int) -> None:
        fish = self.world.population.fish
        ids = np.sort(fish.id[: fish.count])
        if len(ids):
            at = int(np.searchsorted(ids, self.chosen)) + (by if self.chosen in ids else 0)
            self.choose(int(ids[at % len(ids)]))

    def _show(self) -> None:
        row = self._row()
        self._card.show(None if row is None else explain(self.world, row))
        self._bar.show(self.timeline, self.world.clock.now, self.rate, self.held)

    def camera(self) -> Camera:
        """Return the camera that circles the chosen fish."""
        row = self._row()
        if row is not None:
            self._at = place_of(self.world, row, self.stage.alpha)
        level = cos(self._pitch)
        way = np.array(
            [cos(self._yaw) * level, sin(self._yaw) * level, sin(self._pitch)], np.float64
        )
        eye: Float64s = np.array([self._at + self._away * way])
        confine(self.world.terrain, eye, 0, _BERTH)
        return camera_towards(eye[0], self._at, min(slope_for(*self._size), 2 * _SLOPE))

    def draw_sea(self, width: int, height: int) -> None:
        """Draw the fish in its sea, and what it attends to."""
        self._size = (width, height)
        camera = self._beside(self.camera(), width, height)
        self._lens = Lens(camera, width, height)
        self.stage.draw(camera, width, height)
        row = self._row()
        if row is not None:
            alpha, unit = self.stage.alpha, self.canvas.unit
            draw_attention(self._sea, self._lens, self.world, row, alpha, unit)
        self._sea.draw(width, height)

    def _beside(self, camera: Camera, width: int, height: int) -> Camera:
        """Move the camera aside, so that the fish stands in the part of the window that the card leaves free."""
        left, _, wide, _ = self._card.box
        covered = (left + wide) / width
        if covered > 0.6:
            return camera
        aside = covered * self._away * camera.slope * width / height
        eye = camera.eye - aside * camera.right
        return Camera(eye, camera.forward, camera.right, camera.up, camera.slope)

    def draw(self) -> None:
        """Paint the instruments, and the curves on them."""
        self.canvas.draw()
        self._card.draw_curves(self._ink, self.timeline, self.chosen, self.world.clock.now)
        self._ink.draw(self.canvas.width, self.canvas.height)

    def _keys(self) -> dict[str, Callable[[], None]]:
        """Return what each key does."""
        deeds: tuple[tuple[Callable[[], None], tuple[str, ...]], ...] = (
            (self.game.stack.pop, ("i", "escape", "pad_b", "pad_start", "pad_back")),
            (lambda: self._next(1), ("tab", "down", "pad_dpdown")),
            (lambda: self._next(-1), ("up", "backspace", "pad_dpup")),
            (self._toggle, ("space", "pad_a")),
            (self.step, ("right", "period", "pad_dpright")),
            (lambda: self._by(-1), ("left", "comma", "pad_dpleft")),
            (lambda: self._by(-_JUMP), ("pageup", "pad_leftshoulder")),
            (lambda: self._by(_JUMP), ("pagedown", "pad_rightshoulder")),
            (lambda: self.seek(self.timeline.oldest), ("home",)),
            (self._to_present, ("end",)),
            (lambda: self._change_rate(1), ("plus", "equal", "num_add")),
            (lambda: self._change_rate(-1), ("minus", "num_subtract")),
        )
        return {name: deed for deed, names in deeds for name in names}

    def _by(self, ticks: int) -> None:
        self.seek(self.world.clock.now + ticks)

    def pressed(self, name: str) -> None:
        """Choose, hold, step, hurry, look back or leave."""
        deed = self._deeds.get(name)
        if deed is not None:
            deed()

    def clicked(self, x: float, y: float) -> None:
        """Choose the fish under the pointer, press a button, or go to a place on the bar of time."""
        self._scrubbing = self._bar.on_bar(x, y)
        if self._scrubbing:
            self.seek(self._bar.tick_at(x, self.timeline))
        elif not self._bar.click(x, y):
            self.choose(self._under(x, y))

    def _under(self, x: float, y: float) -> int:
        """Return the id of the fish nearest the pixel (x, y), -1 for none near enough."""
        fish = self.world.population.fish
        if not fish.count:
            return -1
        points, ahead = self._lens.project(fish.position[: fish.count])
        far = np.hypot(points[:, 0] - x, points[:, 1] - y) / self.canvas.unit
        far[ahead <= 0.0] = np.inf
        best = int(np.argmin(far))
        return int(fish.id[best]) if far[best] < _PICK else -1

    def dragged(self, x: float, _y: float, dx: float, dy: float) -> None:
        """Circle the fish, or go through time."""
        if self._scrubbing:
            self.seek(self._bar.tick_at(x, self.timeline))
            return
        self._yaw -= _PER_PIXEL * dx
        self._pitch = min(max(self._pitch - _PER_PIXEL * dy, -_STEEPEST), _STEEPEST)

    def wheel(self, notches: float) -> None:
        """Go nearer or farther."""
        self._away = min(max(self._away * 0.88**notches, _NEAREST), _FARTHEST)
