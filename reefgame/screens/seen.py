"""What the inspector draws into the sea: how far a fish sees, what it attends to, and where it wants to go."""

from math import cos, pi, radians, sin
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.camera import Camera
from reefgame.explain import focus_of
from reefgame.screens import theme
from reefgame.screens.strokes import Strokes
from reefgame.screens.theme import Colour, faded
from reefgame.world import World

CONE: Final = 300.0
"""[deg] that a fish sees (papers/004)."""
_ARC, _RINGS = 60, 10
_NEAR: Final = 0.06
_SEES: Final = (0.26, 0.06)
"""Opacity of the cone at the fish and at its rim."""
_RIM: Final = faded(theme.FOAM, 0.6)


class Lens:
    """Projects places [m] into a window of width x height [px]."""

    def __init__(self, camera: Camera, width: int, height: int) -> None:
        self._camera = camera
        self._middle = np.array([0.5 * width, 0.5 * height])
        self._scale = 0.5 * height / camera.slope

    def project(self, places: Float64s) -> tuple[Float64s, Float64s]:
        """Return pixels (n, 2) and how far ahead [m] (n,) places (n, 3) are; negative ones lie behind."""
        way = np.asarray(places, np.float64) - self._camera.eye
        ahead = way @ self._camera.forward
        across = np.stack((way @ self._camera.right, way @ self._camera.up), axis=1)
        return self._middle + self._scale * across / np.maximum(ahead, _NEAR)[:, None], ahead

    def path(self, strokes: Strokes, places: Float64s, colour: Colour, width: float) -> None:
        """Add the line through places [m] (n, 3), where it lies before the eye."""
        points, ahead = self.project(places)
        seen = (ahead[:-1] > _NEAR) & (ahead[1:] > _NEAR)
        strokes.lines(points[:-1][seen], points[1:][seen], colour, width)


def place_of(world: World, row: int, alpha: float) -> Float64s:
    """Return where the fish is drawn [m], (3,)."""
    fish = world.population.fish
    last = fish.last_position[row]
    return np.asarray(last + alpha * (fish.position[row] - last), np.float64)


def draw_attention(
    strokes: Strokes, lens: Lens, world: World, row: int, alpha: float, unit: float
) -> None:
    """Add the cone of the fish in `row`, the line to its focus and its wanted direction."""
    fish, at = world.population.fish, place_of(world, row, alpha)
    length, sight = float(fish.length[row]), float(world.senses.sight[fish.species[row]])
    ahead, up, right = (fish.rotation[row, :, axis] for axis in range(3))
    for side, alone in ((right, False), (up, True)):
        _sector(strokes, lens, at, ahead, side, sight, unit, alone)
    wanted = world.population.motor.heading[row]
    tip = at + (0.8 * length + 0.25) * wanted
    lens.path(strokes, np.array([at, tip]), theme.FOAM, 2.0 * unit)
    _dot(strokes, lens, tip, 3.5 * unit, theme.FOAM)
    focus = focus_of(world, row)
    if focus is not None:
        there = np.array(focus[1])
        lens.path(strokes, np.linspace(at, there, 12), theme.SUNLIT, 2.0 * unit)
        _dot(strokes, lens, there, 6.0 * unit, theme.SUNLIT)
    _ring(strokes, lens, at, max(0.75 * length, 0.08), theme.FOAM, 1.6 * unit)


def _sector(
    strokes: Strokes, lens: Lens, at: Float64s, ahead: Float64s, side: Float64s, reach: float,
    unit: float, outline: bool,
) -> None:  # fmt: skip
    """Add what is seen in one plane through the fish: a filled sector, or its rim only."""
    half = radians(0.5 * CONE)
    angles = np.linspace(-half, half, _ARC + 1)
    rim = at + reach * (np.cos(angles)[:, None] * ahead + np.sin(angles)[:, None] * side)
    lens.path(strokes, rim, _RIM if not outline else faded(_RIM, 0.4), 1.4 * unit)
    if outline:
        return
    for edge in (rim[0], rim[-1]):
        lens.path(
            strokes, at + np.linspace(0.0, 1.0, 40)[:, None] ** 2 * (edge - at), _RIM, 2 * unit
        )
    for metres in range(1, int(reach) + 1):
        around = at + metres / reach * (rim - at)
        lens.path(strokes, around, faded(_RIM, 0.5 if metres > 1 else 0.9), unit)
    grid = at + (np.linspace(0.0, 1.0, _RINGS + 1) ** 2)[:, None, None] * (rim - at)
    points, ahead_of = lens.project(grid.reshape(-1, 3))
    points = points.reshape(_RINGS + 1, _ARC + 1, 2)
    seen = ahead_of.reshape(_RINGS + 1, _ARC + 1) > _NEAR
    corners = (points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:])
    whole = seen[:-1, :-1] & seen[1:, :-1] & seen[1:, 1:] & seen[:-1, 1:]
    for ring in range(_RINGS):
        share = (ring + 0.5) / _RINGS
        colour = faded(theme.FOAM, _SEES[0] + share * (_SEES[1] - _SEES[0]))
        seen = whole[ring]
        for order in ((0, 1, 2), (0, 2, 3)):
            strokes.fill(np.stack([corners[k][ring][seen] for k in order], axis=1), colour)


def _dot(strokes: Strokes, lens: Lens, at: Float64s, radius: float, colour: Colour) -> None:
    points, ahead = lens.project(at[None])
    if ahead[0] > _NEAR:
        strokes.fill(disc(points[0], radius), colour)


def disc(at: Float64s, radius: float) -> Float64s:
    """Return triangles [px] of a disc round the point `at` (2,), (n, 3, 2)."""
    angles = np.linspace(0.0, 2.0 * pi, 17)
    rim = at + radius * np.stack((np.cos(angles), np.sin(angles)), axis=1)
    return np.stack((np.broadcast_to(at, (16, 2)), rim[:-1], rim[1:]), axis=1)


def _ring(
    strokes: Strokes, lens: Lens, at: Float64s, radius: float, colour: Colour, width: float
) -> None:
    """Add a circle that faces the viewer, of `radius` [m]."""
    points, ahead = lens.project(at[None])
    if ahead[0] <= _NEAR:
        return
    pixels = max(radius * lens._scale / float(ahead[0]), 9.0 * width)
    around = [2.0 * pi * k / 40 for k in range(41)]
    strokes.path(points[0] + pixels * np.array([(cos(a), sin(a)) for a in around]), colour, width)
