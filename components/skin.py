"""A species' colours as layers painted one over the other, in the order given (view only).

Places on the body: s from 0 at the nose to 1 at the tail's root along the body, h from -1 at the
belly to 1 at the back. Colours are linear steps of sRGB, three numbers from 0 to 1.
"""

from dataclasses import dataclass
from typing import Literal, TypeAlias

Colour: TypeAlias = tuple[float, float, float]


@dataclass(frozen=True)
class Gradient:
    """Colours from belly to back (or nose to tail); the first layer of most skins: countershading."""

    colours: tuple[Colour, ...]
    along: bool = False
    "False: belly to back; True: nose to tail"
    at: tuple[float, ...] = ()
    "place of each colour: h from -1 to 1, or s from 0 to 1; evenly spread where empty"


@dataclass(frozen=True)
class Stripes:
    """Bars across the body at the places `at` (s), or lines along it (h) where `along` is set."""

    colour: Colour
    at: tuple[float, ...]
    width: float
    softness: float = 0.02
    along: bool = False
    edge: Colour | None = None
    "colour of a thin rim"
    edge_width: float = 0.012
    "width of the rim"
    bow: float = 0.0
    "how far a bar's middle bulges towards the tail (s), or a line's middle towards the back (h)"
    reach: tuple[float, float] = (-1.0, 1.0)
    "the heights (h) between which bars are drawn, or the places (s) between which lines are"
    wobble: float = 0.0
    "unevenness of the borders"


@dataclass(frozen=True)
class Spots:
    """Round spots scattered by a seed between two heights h and two places s."""

    colour: Colour
    count: int
    size: float
    seed: int = 0
    height: tuple[float, float] = (-1.0, 1.0)
    reach: tuple[float, float] = (0.1, 0.95)
    in_row: bool = False
    "evenly spaced along the body instead of scattered"


@dataclass(frozen=True)
class Patch:
    """A soft ellipse of colour at (s, h), or a ring where `hollow` is set."""

    colour: Colour
    at: tuple[float, float]
    size: tuple[float, float]
    softness: float = 0.15
    hollow: float = 0.0
    "0 a full ellipse; 0.8 a thin ring"
    tilt_deg: float = 0.0
    "turn of the ellipse, tail end up"


@dataclass(frozen=True)
class Band:
    """A smooth band of colour through points (s, h), as wide as `width` says (s)."""

    colour: Colour
    points: tuple[tuple[float, float], ...]
    width: tuple[float, ...]
    "at evenly spaced points from the first to the last; one number for an even band"
    softness: float = 0.01
    edge: Colour | None = None
    "colour of a thin rim"
    edge_width: float = 0.008
    "width of the rim"


@dataclass(frozen=True)
class Hatch:
    """Many parallel lines at one angle, between two places s and two heights h."""

    colour: Colour
    spacing: float
    "from one line to the next (s)"
    width: float
    tilt_deg: float = 0.0
    "0 along the body; above 0 they rise towards the tail"
    bow: float = 0.0
    "how far their middle bulges upwards (s)"
    softness: float = 0.006
    reach: tuple[float, float] = (0.0, 1.0)
    "the places (s) between which they are drawn"
    height: tuple[float, float] = (-1.1, 1.1)
    "the heights (h) between which they are drawn"
    fade: float = 0.05
    "over how much of s they begin and end"
    wobble: float = 0.0
    "unevenness"


@dataclass(frozen=True)
class Scales:
    """A net of scales that darkens and glints, of `size` s and `strength` 0 to 1."""

    size: float = 0.02
    strength: float = 0.25
    rim: Colour | None = None
    "colour of each scale's rear border"


@dataclass(frozen=True)
class Eye:
    """The eye: place, radius in s, iris and pupil."""

    at: tuple[float, float] = (0.07, 0.25)
    radius: float = 0.022
    iris: Colour = (0.9, 0.8, 0.3)
    pupil: float = 0.5
    "pupil's radius over the eye's"


@dataclass(frozen=True)
class Mouth:
    """The slit of the mouth, from its front to its corner, both (s, h)."""

    front: tuple[float, float]
    corner: tuple[float, float]


FinName: TypeAlias = Literal["dorsal", "anal", "tail", "pectoral", "pelvic"]


@dataclass(frozen=True)
class FinPatch:
    """A soft ellipse on a fin. Places are (along, out): 0 front or upper end to 1, 0 root to 1 edge."""

    fin: FinName
    colour: Colour
    at: tuple[float, float]
    size: tuple[float, float]
    softness: float = 0.15


@dataclass(frozen=True)
class FinLines:
    """Lines along a fin, parallel to its edge, at distances from the root (0) to the edge (1)."""

    fin: FinName
    colour: Colour
    at: tuple[float, ...]
    width: float
    softness: float = 0.05


Layer: TypeAlias = Gradient | Stripes | Spots | Patch | Band | Hatch | Scales
FinMark: TypeAlias = FinPatch | FinLines


@dataclass(frozen=True)
class Skin:
    """Layers of the body, the eye and the fins' colours."""

    layers: tuple[Layer, ...]
    eye: Eye
    fin: Colour
    "colour of dorsal, anal and pectoral fins"
    tail: Colour
    "colour of the caudal fin"
    shine: float = 0.3
    "strength of the silvery glint"
    fin_edge: Colour | None = None
    "colour of the outer rim of dorsal and anal fins"
    tail_edge: Colour | None = None
    "colour of the caudal fin's upper and lower borders"
    fin_opacity: float = 0.8
    "how little shines through the fins' membranes, 0 to 1"
    pectoral: Colour | None = None
    "colour of the pectoral and pelvic fins; `fin` where none is given"
    gill_at: float = 0.21
    "where the gill cover ends (s)"
    gill_strength: float = 0.5
    "how dark the gill cover's line is, 0 to 1"
    gill_slits: int = 0
    "a shark's open slits, instead of a cover"
    mouth: Mouth | None = None
    "a small one at the snout's tip where none is given"
    dorsal: Colour | None = None
    "colour of the dorsal fin; `fin` where none is given"
    anal: Colour | None = None
    "colour of the anal fin; `fin` where none is given"
    pelvic: Colour | None = None
    "colour of the pelvic fins; that of the pectoral ones where none is given"
    fin_edge_width: float = 0.2
    "width of the outer rim, over the fin's height"
    fin_follow: float = 0.0
    "how far dorsal and anal fins go on with the colours of the body beside them, 0 to 1"
    fin_tip: Colour | None = None
    "colour of all fins' tips"
    fin_rays: float = 1.0
    "how much fin rays stand out, 0 none to 1"
    fin_marks: tuple[FinMark, ...] = ()
    "what is painted on fins"
