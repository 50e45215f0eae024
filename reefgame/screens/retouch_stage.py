"""What the retouch window works on: a motion, its model, a chosen frame and angle (papers/003, section 6)."""

from dataclasses import dataclass, field
from typing import Final

import numpy as np

from components.arrays import Float64s
from tools.video.images import Colour
from tools.video.retarget.film import TILT, View, draw, water
from tools.video.retarget.intermediate import IntermediateMotion
from tools.video.retarget.retarget import Placement, Retargeting
from tools.video.retarget.skeleton import BONES, HEAD, NAMES, angle_of, nearest_turn
from tools.video.retarget.target import Target
from tools.video.retouch.edit import Window, deviation, window_of
from tools.video.retouch.session import Session

_SHARE: Final = 0.66
"""Of the view that the fish's length takes."""
_AHEAD: Final = Placement(np.zeros(2), 0.0, 1.0)


@dataclass
class _Drag:
    """A handle that is being dragged."""

    column: int
    arm: float
    "angle from the fin's root to its tip as the drag began [rad]; 0 for bones"
    value: float
    "the fin's angle then, or the bone's now"
    course: Float64s | None = None
    "of the angle, as it would be if the drag ended here, (T,)"


@dataclass
class RetouchStage:
    """The state of the window; it draws nothing by itself and knows no mouse."""

    motion: IntermediateMotion
    target: Target
    frame: int = 0
    column: int = HEAD - 1
    playing: bool = False
    session: Session = field(init=False)
    _play: Retargeting = field(init=False)
    _time: float = field(init=False, default=0.0)
    _drag: _Drag | None = field(init=False, default=None)

    def __post_init__(self) -> None:
        """Begin with nothing edited."""
        self._play = Retargeting(self.target, self.motion)
        self.session = Session(
            self.motion.angles, self._play.motion_angles(self.target.rest_angles)
        )

    @property
    def _tilt(self) -> float:
        """How far off straight above the model is seen [rad]: fins on a fish's back have no width from there."""
        return TILT if self.target.solid else 0.0

    @property
    def frames(self) -> int:
        """Of the motion."""
        return self.motion.frames

    @property
    def handles(self) -> list[int]:
        """Columns that can be dragged: every bone, and the fins that the model has."""
        fins = [BONES + side for side, fin in enumerate(self.target.fins) if fin is not None]
        return [*range(BONES), *fins]

    def advance(self, seconds: float) -> None:
        """Play on by so much time, from the last frame to the first."""
        if self.playing:
            self._time += seconds * self.motion.rate
            steps, self._time = int(self._time), self._time % 1.0
            self.frame = (self.frame + steps) % self.frames

    def show(self, frame: int) -> None:
        """Go to a frame, the nearest there is, and stop playing."""
        self.frame, self.playing = min(max(frame, 0), self.frames - 1), False

    def angles(self) -> Float64s:
        """Return the motion's angles at the frame shown, with the drag in progress, (22,)."""
        angles: Float64s = self.session.angles[self.frame].copy()
        if self._drag is not None and self._drag.course is not None:
            angles[self._drag.column] = self._drag.course[self.frame]
        return angles

    def course(self) -> Float64s:
        """Return the chosen angle's way from rest over all frames [rad], with the drag in progress, (T,)."""
        values = self.session.angles[:, self.column]
        if self._drag is not None and self._drag.course is not None:
            values = self._drag.course
        return deviation(values, float(self.session.rest[self.column]))

    def original(self) -> Float64s:
        """Return the chosen angle's way from rest as it was captured [rad], (T,)."""
        return deviation(
            self.session.original[:, self.column], float(self.session.rest[self.column])
        )

    def window(self) -> Window:
        """Return the frames that an edit here would reach."""
        away = deviation(self.session.angles[:, self.column], float(self.session.rest[self.column]))
        return window_of(away, self.frame)

    def view(self, width: int, height: int) -> View:
        """Return how the local frame lies in a picture of width x height [px], the head to the right."""
        length = self.target.skeleton.body_length
        scale = min(_SHARE * width, 1.1 * height) / length
        ends = self.target.controls[[HEAD, -1], 1]
        return View(width, height, np.array([0.5 * float(ends.sum()), 0.0]), scale)

    def picture(self, width: int, height: int) -> Colour:
        """Return the model at the frame shown, its head to the right, (height, width, 3)."""
        picture = water(width, height)
        draw(picture, self._play, self._shown(), _AHEAD, self.view(width, height), self._tilt)
        return picture

    def places(self, width: int, height: int) -> dict[int, Float64s]:
        """Return where the handle of each column is in that picture [px], (2,) each."""
        local = self._points(self._shown())
        view = self.view(width, height)
        pivot = 0.5 * (height - 1.0)
        seen = {c: view.to_picture(_AHEAD.to_picture(p[None]))[0] for c, p in local.items()}
        flat = np.cos(self._tilt)
        return {
            c: np.array([x, pivot + (y - pivot) * flat - self._lift(c, view)])
            for c, (x, y) in seen.items()
        }

    def grab(self, column: int) -> None:
        """Begin to drag the handle of a column; playing stops."""
        self.playing, self.column = False, column
        shown = self._shown()
        arm = 0.0
        if column >= BONES:
            arm = float(angle_of(self._points(shown)[column] - self._root(shown, column)))
        self._drag = _Drag(column, arm, float(self.session.angles[self.frame, column]))

    def drag(self, place: Float64s, width: int, height: int) -> None:
        """Move the grabbed handle towards a place of the picture [px], (2,)."""
        drag = self._drag
        if drag is None:
            return
        view = self.view(width, height)
        middle = 0.5 * np.array([width - 1.0, height - 1.0])
        low = place + np.array([0.0, self._lift(drag.column, view)])
        upright = (low - middle) / np.array([1.0, np.cos(self._tilt)])
        local = _AHEAD.to_local((upright / view.scale + view.centre)[None])[0]
        shown = self._shown()
        pointed = float(angle_of(local - self._root(shown, drag.column)))
        value = pointed
        if drag.column >= BONES:
            value = drag.value + float(nearest_turn(np.array(pointed - drag.arm)))
        drag.course, _ = self.session.preview(self.frame, drag.column, value)

    def release(self) -> Window | None:
        """End the drag: it becomes an edit. Return the frames that it reached, None where nothing was moved."""
        drag, self._drag = self._drag, None
        if drag is None or drag.course is None:
            return None
        return self.session.edit(self.frame, drag.column, float(drag.course[self.frame]))

    def label(self) -> str:
        """Return the chosen angle's name and its way from rest at the frame shown."""
        degrees = float(np.degrees(self.course()[self.frame]))
        return f"{NAMES[self.column]}  {degrees:+.1f}\u00b0"

    def _lift(self, column: int, view: View) -> float:
        """Return how much higher a fin's tip stands in the picture than the plane of the axis [px]."""
        if column < BONES:
            return 0.0
        tip = self.target.vertices[self._play.rig.tip_vertex(column - BONES), 2]
        return float(tip * view.scale * np.sin(self._tilt))

    def _shown(self) -> Float64s:
        return self._play.target_angles(self.angles())

    def _points(self, shown: Float64s) -> dict[int, Float64s]:
        """Return the local place of each handle."""
        controls = self._play.rig.controls(shown)
        points = {column: controls[column + 1] for column in range(BONES)}
        for side, tip in enumerate(self._play.rig.tips(shown)):
            if tip is not None:
                points[BONES + side] = tip
        return points

    def _root(self, shown: Float64s, column: int) -> Float64s:
        """Return what a handle turns about, local."""
        if column < BONES:
            first = column in (0, HEAD)
            return np.asarray(self._play.rig.controls(shown)[0 if first else column])
        return self._play.rig.roots(shown)[column - BONES]
