"""Pictures of a moving target: the frames of films and PNG sequences (papers/003, figs. 5 to 7)."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s
from tools.video.images import Colour
from tools.video.retarget.intermediate import IntermediateMotion
from tools.video.retarget.raster import paint
from tools.video.retarget.retarget import Placement, Retargeting
from tools.video.retarget.target import Target

WATER: Final = ((196, 226, 230), (120, 178, 194))
"""Ground of the pictures, above and below."""
TILT: Final = 0.6
"""[rad] from straight above that solid models are seen from, so that they show their backs and sides."""
_FINE: Final = 2
_MARGIN: Final = 0.3
"""[BL] of water round the motion."""
_SUN: Final = (-0.35, -0.45, 0.82)
"""Unit vector towards the sun: right and down in the picture, and up."""
_DARKEST: Final = 0.55


@dataclass(frozen=True)
class View:
    """What of the clip's plane a picture shows."""

    width: int
    height: int
    centre: Float64s
    "[px of the clip] at the picture's middle, (2,)"
    scale: float
    "pixels of the picture for one of the clip"

    def to_picture(self, points: Float64s) -> Float64s:
        """Return places of the clip, (n, 2), in the picture [px]."""
        return (points - self.centre) * self.scale + 0.5 * np.array(
            [self.width - 1.0, self.height - 1.0]
        )


def view_of(motion: IntermediateMotion, width: int, height: int) -> View:
    """Return the view of width x height [px] that holds the whole motion."""
    heading = np.stack((np.cos(motion.direction), -np.sin(motion.direction)), axis=1)
    reach = 0.5 * motion.length * heading
    ends = np.concatenate((motion.centre + reach, motion.centre - reach))
    low, high = ends.min(axis=0), ends.max(axis=0)
    span = high - low + 2.0 * _MARGIN * motion.length
    return View(width, height, 0.5 * (low + high), float(min(width / span[0], height / span[1])))


def water(width: int, height: int) -> Colour:
    """Return the ground of a picture, (height, width, 3)."""
    down = np.linspace(0.0, 1.0, height)[:, None, None]
    above, below = (np.array(colour, np.float64) for colour in WATER)
    return np.broadcast_to(above + down * (below - above), (height, width, 3)).astype(np.uint8)


def draw(
    picture: Colour,
    retargeting: Retargeting,
    angles: Float64s,
    placement: Placement,
    view: View,
    tilt: float = TILT,
) -> None:
    """Paint the target at these angles (22,) over a picture, in place.

    A solid one is seen from `tilt` [rad] off straight above.
    """
    target = retargeting.target
    plane = view.to_picture(placement.to_picture(retargeting.rig.pose(angles)))
    height = target.vertices[:, 2] * placement.scale * view.scale
    if not target.solid:
        paint(
            picture, plane, height, target.triangles, target.uv, np.ones(len(plane)), target.texture
        )
        return
    body = np.concatenate((plane, height[:, None]), axis=1)
    places = plane.copy()
    pivot = float(view.to_picture(placement.centre[None])[0, 1])
    places[:, 1] = pivot + (plane[:, 1] - pivot) * np.cos(tilt) - height * np.sin(tilt)
    # Towards the eye, which stands above and in front of the picture's lower edge.
    depth = height * np.cos(tilt) + (plane[:, 1] - pivot) * np.sin(tilt)
    paint(picture, places, depth, target.triangles, target.uv, _light(target, body), target.texture)


def _light(target: Target, places: Float64s) -> Float64s:
    """Return how bright each vertex is under a sun that stands high in the picture, (V,)."""
    a, b, c = (places[target.triangles[:, i]] for i in range(3))
    face = np.cross(b - a, c - a)
    normal = np.zeros_like(places)
    for corner in range(3):
        np.add.at(normal, target.triangles[:, corner], face)
    size = np.sqrt((normal**2).sum(axis=1))
    # Sheets have one winding and two sides: what is seen is turned to the eye.
    normal *= np.where(normal @ np.array([0.0, np.sin(TILT), np.cos(TILT)]) < 0.0, -1.0, 1.0)[
        :, None
    ]
    towards = normal @ np.array(_SUN) / np.maximum(size, 1e-12)
    return np.asarray(_DARKEST + (1.15 - _DARKEST) * (0.5 + 0.5 * towards))


def frames(
    retargeting: Retargeting, width: int, height: int, beside: bool = False
) -> Iterator[Colour]:
    """Yield a picture (height, width, 3) for each frame of the motion, drawn twice as fine for smooth edges.

    Where the model shows its side, `beside`, it is mirrored if it swims to the left more than to the right.
    """
    fine = _FINE * width, _FINE * height
    view = view_of(retargeting.motion, *fine)
    ground = water(*fine)
    mirrored = beside and float(np.median(np.cos(retargeting.motion.direction))) < 0.0
    for frame in range(retargeting.motion.frames):
        picture = ground.copy()
        place = replace(retargeting.placement(frame), mirrored=mirrored)
        draw(picture, retargeting, retargeting.angles(frame), place, view)
        yield np.asarray(
            cv2.resize(picture, (width, height), interpolation=cv2.INTER_AREA), np.uint8
        )


def still(target: Target, width: int, height: int) -> Colour:
    """Return the rest pose with its head up, filling a picture of width x height [px]."""
    low, high = target.vertices[:, :2].min(axis=0), target.vertices[:, :2].max(axis=0)
    angles = target.rest_angles
    one = np.zeros(1)
    motion = IntermediateMotion(
        np.zeros((1, 2)), one + 0.5 * np.pi, angles[None], target.skeleton.body_length, 1.0
    )
    span = high - low
    view = View(
        width,
        height,
        np.array([1.0, -1.0]) * 0.5 * (low + high),
        0.92 * float(min(width / span[0], height / span[1])),
    )
    picture = water(width, height)
    retargeting = Retargeting(target, motion)
    draw(picture, retargeting, angles, retargeting.placement(0), view)
    return picture
