"""A motion under edit, with undo and redo (papers/003, eqs. 16, 17)."""

from dataclasses import dataclass, field

import numpy as np

from components.arrays import Float64s
from tools.video.retarget.skeleton import ANGLES
from tools.video.retouch.edit import Window, edited


@dataclass(frozen=True)
class _Step:
    """What one edit changed."""

    column: int
    before: Float64s
    after: Float64s


@dataclass
class Session:
    """N of eq. 17. Columns are those of skeleton.NAMES."""

    original: Float64s
    "M [rad], (T, 22)"
    rest: Float64s
    "M_0 of the model that is looked at [rad], (22,)"
    angles: Float64s = field(init=False)
    "N [rad], (T, 22)"
    _done: list[_Step] = field(init=False, default_factory=list)
    _undone: list[_Step] = field(init=False, default_factory=list)
    _saved: int = field(init=False, default=0)

    def __post_init__(self) -> None:
        """Begin with N = M. Raise ValueError where shapes do not fit."""
        if (
            self.original.ndim != 2
            or self.original.shape[1] != ANGLES
            or self.rest.shape != (ANGLES,)
        ):
            raise ValueError(f"angles are (T, {ANGLES}) and ({ANGLES},)")
        self.angles = self.original.copy()

    @property
    def edits(self) -> int:
        """How many edits the motion holds."""
        return len(self._done)

    @property
    def can_redo(self) -> bool:
        """Whether an edit was taken back and nothing was edited since."""
        return bool(self._undone)

    @property
    def unsaved(self) -> bool:
        """Whether there are edits that `mark_saved` has not seen."""
        return self._saved != len(self._done)

    def preview(self, frame: int, column: int, value: float) -> tuple[Float64s, Window]:
        """Return what `edit` would make of a column (T,), and the frames it would reach; nothing changes."""
        return edited(self.angles[:, column], float(self.rest[column]), frame, value)

    def edit(self, frame: int, column: int, value: float) -> Window:
        """Set an angle [rad] on one frame, its neighbours follow; return the frames that were reached."""
        after, window = self.preview(frame, column, value)
        self._undone.clear()
        if self._saved > len(self._done):
            self._saved = -1
        self._done.append(_Step(column, self.angles[:, column].copy(), after))
        self.angles[:, column] = after
        return window

    def undo(self) -> bool:
        """Take the last edit back; return whether there was one."""
        if not self._done:
            return False
        step = self._done.pop()
        self._undone.append(step)
        self.angles[:, step.column] = step.before
        return True

    def redo(self) -> bool:
        """Do the last edit taken back again; return whether there was one."""
        if not self._undone:
            return False
        step = self._undone.pop()
        self._done.append(step)
        self.angles[:, step.column] = step.after
        return True

    def mark_saved(self) -> None:
        """Note that the motion was written as it is now."""
        self._saved = len(self._done)

    def changed(self) -> Float64s:
        """Return how far each frame's angles are from the original's [rad], the largest, (T,)."""
        return np.asarray(np.abs(self.angles - self.original).max(axis=1))
