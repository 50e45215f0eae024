"""What a species file may say of its colours: layers on the body, the eye, the mouth and the fins (components/skin.py).

Places on the body are [s, h]: s from 0 at the nose to 1 at the tail's root, h from -1 at the belly to 1 at the back.
"""

from itertools import pairwise
from typing import Annotated, Literal, TypeAlias

from pydantic import Field, ValidationInfo, field_validator
from pydantic_core import PydanticCustomError

from reefgame.content.schema.strict import Colour, Fraction, Strict

BodyPlace: TypeAlias = tuple[Fraction, Annotated[float, Field(ge=-1.0, le=1.0)]]
"""s from 0 at the nose to 1 at the tail's root, h from -1 at the belly to 1 at the back."""
Height: TypeAlias = Annotated[float, Field(ge=-1.0, le=1.0)]
BeyondHeight: TypeAlias = Annotated[float, Field(ge=-1.5, le=1.5)]
BandPlace: TypeAlias = tuple[Annotated[float, Field(ge=-0.1, le=1.1)], BeyondHeight]
"""s and h; a band may run beyond the body's borders."""
Extent: TypeAlias = Annotated[float, Field(ge=0.005, le=2.0)]


class GradientLayer(Strict):
    """Colours that run into one another."""

    paint: Literal["gradient"]
    colours: Annotated[tuple[Colour, ...], Field(min_length=2, max_length=8)]
    """From belly to back, or from nose to tail."""
    at: Annotated[tuple[Height, ...], Field(max_length=8)] = ()
    """The place of each colour: h, or s where it runs from nose to tail; evenly spread where left out."""
    run: Literal["belly_to_back", "nose_to_tail"] = "belly_to_back"

    @field_validator("at")
    @classmethod
    def _one_each(cls, at: tuple[float, ...], info: ValidationInfo) -> tuple[float, ...]:
        colours = info.data.get("colours", ())
        if at and colours and len(at) != len(colours):
            text = "each colour needs one place: there are {places} places and {colours} colours"
            raise PydanticCustomError(
                "gradient", text, {"places": len(at), "colours": len(colours)}
            )
        if any(after <= before for before, after in pairwise(at)):
            raise PydanticCustomError("gradient", "places must rise from one colour to the next")
        return at


class StripesLayer(Strict):
    """Bars across the body, or lines along it."""

    paint: Literal["stripes"]
    colour: Colour
    at: Annotated[tuple[Height, ...], Field(min_length=1, max_length=8)]
    """Where: places s of bars (0 nose, 1 tail), heights h of lines (-1 belly, 1 back)."""
    width: Annotated[float, Field(ge=0.005, le=1.0)]
    softness: Annotated[float, Field(ge=0.0, le=0.5)] = 0.02
    run: Literal["bars", "lines"] = "bars"
    edge: Colour | None = None
    """Colour of a thin rim."""
    edge_width: Annotated[float, Field(ge=0.0, le=0.2)] = 0.012
    bow: Annotated[float, Field(ge=-0.5, le=0.5)] = 0.0
    """How far the middle bulges: of bars towards the tail, of lines towards the back."""
    reach: tuple[Height, Height] = (-1.0, 1.0)
    """The heights between which bars are drawn, or the places between which lines are."""
    wobble: Fraction = 0.0
    """Unevenness of the borders."""


class SpotsLayer(Strict):
    """Round spots, scattered by a seed or in a row."""

    paint: Literal["spots"]
    colour: Colour
    count: Annotated[int, Field(ge=1, le=400)]
    size: Annotated[float, Field(ge=0.002, le=0.3)]
    seed: Annotated[int, Field(ge=0, le=1_000_000)] = 0
    height: tuple[Height, Height] = (-1.0, 1.0)
    """Lowest and highest h."""
    reach: tuple[Fraction, Fraction] = (0.1, 0.95)
    """First and last s."""
    in_row: bool = False
    """Evenly spaced along the body instead of scattered."""


class PatchLayer(Strict):
    """A soft ellipse, or a ring where `hollow` is above 0."""

    paint: Literal["patch"]
    colour: Colour
    at: BodyPlace
    size: tuple[Extent, Extent]
    """Half the length (s) and half the height (h)."""
    softness: Fraction = 0.15
    hollow: Annotated[float, Field(ge=0.0, le=0.98)] = 0.0
    tilt_deg: Annotated[float, Field(ge=-90.0, le=90.0)] = 0.0
    """Turn of the ellipse, tail end up."""


class ScalesLayer(Strict):
    """A net of scales."""

    paint: Literal["scales"]
    size: Annotated[float, Field(ge=0.004, le=0.2)] = 0.02
    strength: Fraction = 0.25
    rim: Colour | None = None
    """Colour of each scale's rear border."""


class BandLayer(Strict):
    """A smooth band through points: masks, lines on a face, bars that bend."""

    paint: Literal["band"]
    colour: Colour
    points: Annotated[tuple[BandPlace, ...], Field(min_length=2, max_length=12)]
    """[s, h] each."""
    width: Annotated[
        tuple[Annotated[float, Field(ge=0.0, le=0.6)], ...], Field(min_length=1, max_length=12)
    ]
    """Along the band, evenly spaced (s): [0.02] is as wide everywhere."""
    softness: Fraction = 0.01
    edge: Colour | None = None
    """Colour of a thin rim."""
    edge_width: Annotated[float, Field(ge=0.0, le=0.2)] = 0.008


class HatchLayer(Strict):
    """Many fine parallel lines at one angle."""

    paint: Literal["hatch"]
    colour: Colour
    spacing: Annotated[float, Field(ge=0.008, le=0.5)]
    """From one line to the next (s)."""
    width: Annotated[float, Field(ge=0.002, le=0.5)]
    tilt_deg: Annotated[float, Field(ge=-90.0, le=90.0)] = 0.0
    """0 along the body; above 0 they rise towards the tail."""
    bow: Annotated[float, Field(ge=-0.5, le=0.5)] = 0.0
    """How far their middle bulges upwards (s)."""
    softness: Annotated[float, Field(ge=0.0, le=0.5)] = 0.006
    reach: tuple[Height, Height] = (0.0, 1.0)
    """The places s between which they are drawn."""
    height: tuple[BeyondHeight, BeyondHeight] = (-1.1, 1.1)
    """The heights h between which they are drawn."""
    fade: Annotated[float, Field(ge=0.001, le=0.5)] = 0.05
    """Over how much of s they begin and end."""
    wobble: Fraction = 0.0
    """Unevenness."""


SkinLayer: TypeAlias = Annotated[
    GradientLayer | StripesLayer | SpotsLayer | PatchLayer | BandLayer | HatchLayer | ScalesLayer,
    Field(discriminator="paint"),
]


class MouthLook(Strict):
    """The slit of the mouth."""

    front: BodyPlace
    """[s, h] of its front end."""
    corner: BodyPlace
    """[s, h] of its corner."""


FinName: TypeAlias = Literal["dorsal", "anal", "tail", "pectoral", "pelvic"]
FinPlace: TypeAlias = Annotated[float, Field(ge=-0.5, le=1.5)]


class FinPatchMark(Strict):
    """A soft ellipse on a fin. Places are [along, out]: 0 front (tail: upper border) to 1; 0 root to 1 edge."""

    paint: Literal["patch"]
    fin: FinName
    colour: Colour
    at: tuple[FinPlace, FinPlace]
    size: tuple[Extent, Extent]
    softness: Fraction = 0.15


class FinLinesMark(Strict):
    """Lines along a fin, parallel to its edge."""

    paint: Literal["lines"]
    fin: FinName
    colour: Colour
    at: Annotated[tuple[FinPlace, ...], Field(min_length=1, max_length=8)]
    """0 root to 1 edge."""
    width: Annotated[float, Field(ge=0.005, le=1.0)]
    softness: Fraction = 0.05


FinMark: TypeAlias = Annotated[FinPatchMark | FinLinesMark, Field(discriminator="paint")]


class EyeLook(Strict):
    """The eye."""

    at: BodyPlace = (0.07, 0.25)
    radius: Annotated[float, Field(ge=0.004, le=0.1)] = 0.022
    iris: Colour = "#e6cc4d"
    pupil: Fraction = 0.5
    """The pupil's radius over the eye's."""


class SkinLook(Strict):
    """Layers painted one over the other, the eye and the colours of the fins."""

    layers: Annotated[tuple[SkinLayer, ...], Field(min_length=1, max_length=24)]
    eye: EyeLook = EyeLook()
    fins: Colour
    """Colour of dorsal, anal and pectoral fins."""
    dorsal: Colour | None = None
    """Colour of the dorsal fin, where it differs from the others."""
    anal: Colour | None = None
    """Colour of the anal fin, where it differs from the others."""
    pelvic: Colour | None = None
    """Colour of the pelvic fins, where it differs from the pectoral ones'."""
    fins_edge: Colour | None = None
    """Colour of the outer rim of dorsal and anal fins."""
    fins_edge_width: Fraction = 0.2
    """Width of that rim, over the fin's height."""
    fins_follow: Fraction = 0.0
    """How far dorsal and anal fins go on with the colours of the body beside them."""
    fins_tip: Colour | None = None
    """Colour of all fins' tips."""
    fins_rays: Fraction = 1.0
    """How much fin rays stand out."""
    fin_marks: Annotated[tuple[FinMark, ...], Field(max_length=12)] = ()
    """Patches and lines on fins."""
    fins_opacity: Fraction = 0.8
    """How little shines through the fins."""
    pectoral: Colour | None = None
    """Colour of the pectoral fins, where they differ from the others."""
    tail: Colour
    """Colour of the caudal fin."""
    tail_edge: Colour | None = None
    """Colour of the caudal fin's upper and lower borders."""
    gill_at: Annotated[float, Field(ge=0.05, le=0.5)] = 0.21
    """Where the gill cover ends."""
    gill_strength: Fraction = 0.5
    """How dark the gill cover's line is."""
    gill_slits: Annotated[int, Field(ge=0, le=7)] = 0
    """A shark's open slits, instead of a cover; `gill_at` is the last one's place."""
    mouth: MouthLook | None = None
    """A small one at the snout's tip where left out."""
    shine: Fraction = 0.3
    """Strength of the silvery glint."""
