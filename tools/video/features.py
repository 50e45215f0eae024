"""All features of one frame, from its mask (papers/003, section 4, Table 1)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s
from tools.video.contour import POINTS as CONTOUR_POINTS
from tools.video.contour import coefficients, evenly, harmonics_needed, kept, rebuilt
from tools.video.faults import Fault, fault_of_axis
from tools.video.fins import without_fins
from tools.video.mask import Sighting
from tools.video.midline import medial_axis, whole_axis
from tools.video.orientation import continued, shape_of
from tools.video.pectorals import pectorals_of


@dataclass(frozen=True)
class Features:
    """What one frame shows, in pixels of the frame; nan where it shows nothing."""

    fault: Fault
    contrast: float = 0.0
    "mean difference from the plate inside the mask, over T"
    centre: Float64s | None = None
    "barycentre, (2,)"
    ahead: Float64s | None = None
    "unit vector of greatest spread towards the head, (2,)"
    evidence: float = 0.0
    "how much the mask speaks for its head lying ahead"
    spine: Float64s | None = None
    "stations of the axis between its ends, head first, (35, 2)"
    ends: Float64s | None = None
    "head, tail, mean of the tail's lobes (nan without a fork), (3, 2)"
    half_width: Float64s | None = None
    "of the body along the spine, (35,)"
    fins: Float64s | None = None
    "tips left and right, junctions top left, top right, bottom left, bottom right, (6, 2)"
    contour: NDArray[np.complex128] | None = None
    "Fourier coefficients of the finless contour, (2 S + 1,)"

    @property
    def harmonics(self) -> int:
        """S, how many harmonics its contour needed."""
        return 0 if self.contour is None else len(self.contour) // 2


def features_of(sighting: Sighting, before: Float64s | None) -> Features:
    """Return the features of a fish in one frame; `before` (2,) is where its head pointed, None if unknown."""
    shape = shape_of(sighting.outline)
    if shape.is_round:
        return Features(Fault.ROUND, sighting.contrast)
    likely = shape.axis if shape.lean >= 0.0 else -shape.axis
    ahead = likely if before is None else continued(shape.axis, before)
    finless = without_fins(sighting.mask, sighting.outline, shape.centre, ahead)
    length = 0.5 * len(finless.outline)
    fourier = coefficients(evenly(finless.outline, CONTOUR_POINTS, closed=True))
    low = kept(fourier, harmonics_needed(fourier, length))
    axis = medial_axis(finless, rebuilt(low), ahead)
    line = whole_axis(axis.head, axis.spine, axis.tail)
    fins = pectorals_of(finless, line)
    corner = np.array(sighting.corner, np.float64)
    low[0] += complex(*corner)
    return Features(
        fault=fault_of_axis(line, sighting.mask, finless.outline, ahead),
        contrast=sighting.contrast,
        centre=shape.centre + corner,
        ahead=ahead,
        evidence=shape.evidence(ahead),
        spine=axis.spine + corner,
        ends=np.stack((axis.head, axis.tail, axis.lobes)) + corner,
        half_width=axis.half_width,
        fins=np.concatenate((fins.tip, fins.junction)) + corner,
        contour=low,
    )
