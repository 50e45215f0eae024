"""What a species file may say: size, body, fins, swimming, mind and colours (FINDINGS 1b).

Lengths on the body are in body lengths (`_bl`): 0 at the nose, 1 at the tip of the tail.
"""

from itertools import pairwise
from typing import Annotated, Literal, TypeAlias

from pydantic import Field, ValidationInfo, field_validator
from pydantic_core import PydanticCustomError

from reefgame.content.schema.flow import Stirs
from reefgame.content.schema.mind import Mind
from reefgame.content.schema.skins import SkinLook
from reefgame.content.schema.strict import Fraction, Reference, Strict, Title

Station: TypeAlias = Annotated[float, Field(ge=0.01, le=0.97)]
Thickness: TypeAlias = Annotated[float, Field(ge=0.004, le=0.4)]


class School(Strict):
    """How the species keeps company with its own kind."""

    joins: bool
    """Whether it swims in schools."""
    spacing_bl: Annotated[float, Field(ge=0.3, le=10.0)] = 0.8
    """The distance that it keeps in a school."""


class BodyShape(Strict):
    """The body at five stations from the gills to the root of the tail."""

    at_bl: tuple[Station, Station, Station, Station, Station]
    """Where the five stations are, from the nose backwards."""
    half_width_bl: tuple[Thickness, Thickness, Thickness, Thickness, Thickness]
    """Half the width of the body at each."""
    half_height_bl: tuple[Thickness, Thickness, Thickness, Thickness, Thickness]
    """Half the height of the body at each."""
    stiffness: Annotated[float, Field(ge=0.2, le=5.0)] = 1.0
    """Scale of all springs: 1 for most fishes."""
    snout: Annotated[float, Field(ge=0.45, le=1.3)] = 0.6
    """How pointed the snout is: 0.5 is blunt, 1 a cone."""

    @field_validator("at_bl")
    @classmethod
    def _rises(cls, stations: tuple[float, ...]) -> tuple[float, ...]:
        for before, after in pairwise(stations):
            if after < before + 0.04:
                message = "stations must rise from nose to tail, each at least 0.04 behind the last"
                raise PydanticCustomError("stations", message)
        return stations


class MedianFin(Strict):
    """A fin on the back or on the belly."""

    from_bl: Fraction
    """Where its root begins."""
    to_bl: Fraction
    """Where its root ends."""
    height_bl: Annotated[float, Field(ge=0.0, le=0.5)]
    """How far it stands out."""
    lean_bl: Annotated[float, Field(ge=-0.2, le=0.3)] = 0.04
    """How far its tip leans back."""
    profile: Annotated[tuple[Fraction, ...], Field(max_length=40)] = ()
    """Its outline: heights at even steps from front to rear, 0 none to 1 height_bl; one of its own where left out."""

    @field_validator("to_bl")
    @classmethod
    def _behind(cls, end: float, info: ValidationInfo) -> float:
        if end <= info.data.get("from_bl", -1.0):
            raise PydanticCustomError(
                "fin", "a fin must end behind where it begins: to_bl > from_bl"
            )
        return end


class Pectoral(Strict):
    """The pair of fins behind the gills."""

    at_bl: Annotated[float, Field(ge=0.05, le=0.8)] = 0.28
    """Where they are rooted."""
    length_bl: Annotated[float, Field(ge=0.0, le=0.5)] = 0.12
    """How long they are."""
    height: Annotated[float, Field(ge=-1.0, le=1.0)] = -0.2
    """Where they are rooted, from -1 at the belly to 1 at the back."""
    held_out: bool = False
    """Held out like wings, as sharks do, instead of sculling."""


class Pelvic(Strict):
    """The pair of fins under the belly."""

    at_bl: Annotated[float, Field(ge=0.05, le=0.85)]
    """Where they are rooted."""
    length_bl: Annotated[float, Field(ge=0.0, le=0.5)]
    """How long they are."""


class Tail(Strict):
    """The caudal fin."""

    half_span_bl: Annotated[float, Field(ge=0.02, le=0.4)]
    """Half its height."""
    fork_bl: Annotated[float, Field(ge=-0.1, le=0.2)] = 0.06
    """How deeply it is forked; below 0 it is rounded."""
    upper: Annotated[float, Field(ge=0.3, le=2.0)] = 1.0
    """Height of the upper lobe, over half_span_bl: above 1 in sharks."""
    lower: Annotated[float, Field(ge=0.3, le=1.5)] = 1.0
    """Height and length of the lower lobe, over those of an even tail."""
    slender: Fraction = 0.0
    """0: broad lobes; 1: slender ones, a lyre or a crescent."""


class Fins(Strict):
    """All fins. Write `dorsal: null` where there is none."""

    tail: Tail
    dorsal: MedianFin | None = None
    anal: MedianFin | None = None
    pectoral: Pectoral = Pectoral()
    pelvic: Pelvic | None = None
    """Where null: behind the pectoral fins, two thirds as long."""


class SwimStyle(Strict):
    """What the muscles do at cruise; `reefgame capture` learns the motion from it."""

    contraction_middle: Annotated[float, Field(ge=0.0, le=0.8)]
    """How much the muscles of the middle shorten, as a fraction."""
    contraction_rear: Annotated[float, Field(ge=0.0, le=0.8)]
    """How much those of the rear shorten."""
    lag_deg: Annotated[float, Field(ge=0.0, le=180.0)]
    """How far the rear lags behind the middle, of 360 a beat."""
    frequency_hz: Annotated[float, Field(ge=0.5, le=6.0)]
    """Beats of the tail a second."""


class SpeciesFile(Strict):
    """A species: `species/NAME.yaml` of a mod. With `like:` only what differs needs to stand here."""

    title: Title
    """What players read."""
    like: Reference | None = None
    """A species to start from: all that does not stand here is as there."""
    overrides: Reference | None = None
    """A species of another mod to change: what stands here replaces what stands there."""
    role: Literal["prey", "predator", "pacifist"]
    size_cm: Annotated[float, Field(ge=1.0, le=2000.0)]
    """Length of an adult from nose to tail tip."""
    size_spread_percent: Annotated[float, Field(ge=0.0, le=50.0)] = 10.0
    """How much single fishes differ from it at most."""
    sight_m: Annotated[float, Field(ge=0.1, le=50.0)]
    """How far it sees fishes of its own size in clear water."""
    depth_m: tuple[
        Annotated[float, Field(ge=0.0, le=500.0)], Annotated[float, Field(ge=0.0, le=500.0)]
    ]
    """Shallowest and deepest that it likes."""
    school: School
    body: BodyShape
    fins: Fins
    swim: SwimStyle | None = None
    """May be missing until `reefgame capture --tune` has found it; only then the species swims."""
    mind: Mind = Mind()
    stirs: Stirs = Stirs(kind="hole")
    """What it is to anemones and weeds."""
    skin: SkinLook

    @field_validator("depth_m")
    @classmethod
    def _deeper(cls, depth: tuple[float, float]) -> tuple[float, float]:
        if depth[0] >= depth[1]:
            message = "the shallowest comes first, then the deepest, such as [2, 12]"
            raise PydanticCustomError("depth", message)
        return depth
