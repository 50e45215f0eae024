"""Rigid moving-least-squares deformation of the plane (Schaefer, McPhail and Warren 2006; papers/003, section 5.1).

As complex numbers the closed form is f = sum_i w_i conj(p_i - p*) q_i (v - p*), and v goes to q* + |v - p*| f / |f|.
What depends on the rest pose alone is folded into one matrix, so that a frame costs one product (FINDINGS 4).
"""

from typing import Final

import numpy as np

from components.arrays import Float64s

ALPHA: Final = 1.5
"""Exponent of the weights 1 / d^(2 alpha)."""
_NEAREST: Final = 1e-9
"""Square of a distance, over that of the points' extent, below which a vertex counts as lying on a control point."""


class RigidDeformation:
    """Carries vertices along with control points, turning and shifting but never stretching where it can."""

    def __init__(self, vertices: Float64s, controls: Float64s, alpha: float = ALPHA) -> None:
        """`vertices` (V, 2) and control points (N, 2) in the rest pose; any unit. N is at least 2."""
        offset = vertices[:, None, :] - controls[None, :, :]
        square = np.einsum("vnk,vnk->vn", offset, offset)
        extent = float(np.ptp(controls, axis=0).max()) ** 2
        weight = np.maximum(square, _NEAREST * extent) ** -alpha
        weight /= weight.sum(axis=1, keepdims=True)
        centre = weight @ controls
        arm = vertices - centre
        near = controls[None, :, :] - centre[:, None, :]
        # conj(p - p*) (v - p*), real and imaginary part.
        real = weight * np.einsum("vnk,vk->vn", near, arm)
        imaginary = weight * (near[..., 0] * arm[:, None, 1] - near[..., 1] * arm[:, None, 0])
        self._matrix = np.concatenate((weight, real, imaginary))
        self._reach = np.sqrt((arm**2).sum(axis=1))
        self._count = len(vertices)

    def __call__(self, controls: Float64s) -> Float64s:
        """Return where the vertices are when the control points are at `controls` (N, 2), (V, 2)."""
        n = self._count
        product = self._matrix @ controls
        real, imaginary = product[n : 2 * n], product[2 * n :]
        fx = real[:, 0] - imaginary[:, 1]
        fy = real[:, 1] + imaginary[:, 0]
        scale = self._reach / np.maximum(np.sqrt(fx * fx + fy * fy), 1e-300)
        moved = product[:n]
        moved[:, 0] += fx * scale
        moved[:, 1] += fy * scale
        return moved
