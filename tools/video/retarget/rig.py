"""Two-level retargeting: the body first, then the fins by the junctions it carried (papers/003, section 5, fig. 5).

Algorithm 3 deforms the implicit model, junctions included; algorithm 4 the explicit one. In "turn" mode, ours, fins are
rigid and swing as far from their rest as the fish's fins do from theirs; "paper" is algorithm 4 as printed, with the
fish's fin angles as they are; "none" stops after the first level (fig. 5 c).
"""

from typing import Literal, TypeAlias

import numpy as np

from components.arrays import Float64s
from tools.video.retarget.fin import RigidFin
from tools.video.retarget.moving_least_squares import RigidDeformation
from tools.video.retarget.skeleton import BONES, nearest_turn, posed
from tools.video.retarget.target import Target

FinMode: TypeAlias = Literal["turn", "paper", "none"]


class Rig:
    """Poses a target by the angles of its skeleton."""

    def __init__(self, target: Target, fins: FinMode = "turn") -> None:
        self.target = target
        self._skeleton = target.skeleton
        self._rest = target.rest_angles
        self._flat = np.ascontiguousarray(target.vertices[:, :2])
        self._present = [(side, fin) for side, fin in enumerate(target.fins) if fin is not None]
        junctions = [point for _, fin in self._present for point in (fin.top, fin.bottom)]
        self._junctions = np.array(junctions).reshape(-1, 2)
        self._body = RigidDeformation(
            np.concatenate((self._flat, self._junctions)), target.controls
        )
        sheet = None if target.solid else target.triangles
        self.fins = [
            RigidFin(fin, self._flat, self._skeleton.body_length, sheet) for _, fin in self._present
        ]
        self._whole = self._with_fins() if fins == "paper" and self._present else None
        self._turns = fins == "turn"

    def _with_fins(self) -> RigidDeformation:
        tips = np.array([fin.tip for _, fin in self._present])
        return RigidDeformation(
            self._flat, np.concatenate((self.target.controls, self._junctions, tips))
        )

    def controls(self, angles: Float64s) -> Float64s:
        """Return the body's control points at these angles (22,) [rad], (21, 2)."""
        return posed(self._skeleton, angles[:BONES])

    def body(self, angles: Float64s) -> tuple[Float64s, Float64s]:
        """Return vertices (V, 2) and junctions (2 k, 2) after the first level (fig. 5 c)."""
        moved = self._body(self.controls(angles))
        return moved[: len(self._flat)], moved[len(self._flat) :]

    def pose(self, angles: Float64s) -> Float64s:
        """Return the vertices in the plane at these angles (22,) [rad], bones and fins in the local frame, (V, 2)."""
        moved, junctions = self.body(angles)
        if self._whole is not None:
            return self._whole(self._explicit(angles, junctions))
        if not self._turns:
            return moved
        for (side, _), fin, (top, bottom) in zip(
            self._present, self.fins, junctions.reshape(-1, 2, 2), strict=True
        ):
            turn = float(nearest_turn(angles[BONES + side] - self._rest[BONES + side]))
            moved[fin.vertices] = fin(moved[fin.vertices], top, bottom, turn)
        return moved

    def tip_vertex(self, side: int) -> int:
        """Return the vertex at the tip of the left (0) or right (1) fin. Raise ValueError where there is none."""
        fin = self.target.fins[side]
        if fin is None:
            raise ValueError(f"{self.target.name} has no fin on side {side}")
        near = self._flat[fin.vertices] - fin.tip
        return int(fin.vertices[int(np.argmin((near**2).sum(axis=1)))])

    def tips(self, angles: Float64s) -> list[Float64s | None]:
        """Return where the tip of each fin is, left and right, (2,) each; None where there is no fin."""
        pose = self.pose(angles)
        found: list[Float64s | None] = [None, None]
        for side, _ in self._present:
            found[side] = pose[self.tip_vertex(side)]
        return found

    def roots(self, angles: Float64s) -> list[Float64s]:
        """Return the middle of each fin's root, left and right, (2,); the centre where there is no fin."""
        found = [np.zeros(2), np.zeros(2)]
        _, junctions = self.body(angles)
        for (side, _), pair in zip(self._present, junctions.reshape(-1, 2, 2), strict=True):
            found[side] = pair.mean(axis=0)
        return found

    def _explicit(self, angles: Float64s, junctions: Float64s) -> Float64s:
        """Return all control points of the explicit model (algorithm 4, lines 1 to 4)."""
        tips = []
        for (side, fin), top in zip(self._present, junctions[::2], strict=True):
            reach = float(np.sqrt(((fin.tip - fin.top) ** 2).sum()))
            angle = angles[BONES + side]
            tips.append(top + reach * np.array([np.cos(angle), np.sin(angle)]))
        return np.concatenate((self.controls(angles), junctions, np.array(tips)))
