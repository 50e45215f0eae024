"""What a level file may say: the world, its rocks, plants and fishes, the submarine and what the player is to do.

Places are [x, y] or [x, y, z] in metres; z is up and 0 at the surface, so 5 m down is -5. Angles are in degrees; a
heading of 0 looks along x, 90 along y.
"""

from typing import Annotated, Literal, TypeAlias

from pydantic import (
    Field,
    StringConstraints,
    ValidationInfo,
    WithJsonSchema,
    field_validator,
    model_validator,
)
from pydantic_core import PydanticCustomError

from reefgame.content.schema.flow import Flows
from reefgame.content.schema.strict import (
    TITLE_PATTERN,
    Fraction,
    Ground,
    Place,
    Reference,
    Strict,
    Title,
    Words,
)

Degrees: TypeAlias = Annotated[float, Field(ge=-360.0, le=360.0)]
Seconds: TypeAlias = Annotated[float, Field(ge=0.0, le=36_000.0)]
Current: TypeAlias = Annotated[float, Field(ge=-2.0, le=2.0)]
Drift: TypeAlias = tuple[Current, Current, Current]
PlantScale: TypeAlias = Annotated[float, Field(ge=0.1, le=10.0)]
SemiAxis: TypeAlias = Annotated[float, Field(ge=0.1, le=50.0)]


class Bounds(Strict):
    """The cylinder of water."""

    radius_m: Annotated[float, Field(ge=10.0, le=500.0)]
    depth_m: Annotated[float, Field(ge=4.0, le=100.0)]
    """Of the deepest ground."""


class Seabed(Strict):
    """Sand in waves, grown from a seed."""

    seed: Annotated[int, Field(ge=0, le=1_000_000)] = 1
    relief_m: Annotated[float, Field(ge=0.0, le=50.0)] = 1.5
    """From the deepest to the highest ground."""
    feature_m: Annotated[float, Field(ge=2.0, le=200.0)] = 14.0
    """From one rise to the next."""


class Water(Strict):
    """The water."""

    visibility_m: Annotated[float, Field(ge=3.0, le=100.0)] = 22.0
    """How far things can be seen."""
    light_halves_m: Annotated[float, Field(ge=1.0, le=200.0)] = 12.0
    """Depth in which light falls to a half."""
    surface_c: Annotated[float, Field(ge=-2.0, le=40.0)] = 26.0
    """Temperature at the surface, the mean of a day."""
    bottom_c: Annotated[float, Field(ge=-2.0, le=40.0)] | None = None
    """Temperature at the deepest ground; null: two degrees colder than the surface."""
    swing_c: Annotated[float, Field(ge=0.0, le=10.0)] = 0.0
    """How much warmer than the mean the surface is at noon."""

    @field_validator("bottom_c")
    @classmethod
    def _colder(cls, bottom: float | None, info: ValidationInfo) -> float | None:
        if bottom is not None and bottom > info.data.get("surface_c", bottom):
            raise PydanticCustomError(
                "water", "the bottom cannot be warmer than the surface: bottom_c <= surface_c"
            )
        return bottom


class Sun(Strict):
    """Where the sun stands."""

    elevation_deg: Annotated[float, Field(ge=5.0, le=90.0)] = 55.0
    azimuth_deg: Degrees = 60.0


class Day(Strict):
    """The sun's way over the level: light and temperature, which fishes mind."""

    length_s: Annotated[float, Field(ge=60.0, le=86_400.0)] | None = None
    """From sunrise to sunrise; null: the sun stands still."""
    starts: Literal["sunrise", "morning", "noon", "afternoon", "sunset", "midnight"] = "noon"
    """When the dive begins."""
    night_light: Fraction = 0.1
    """Light at midnight over that at noon."""


class RockPlace(Strict):
    """A rock: an ellipsoid that stands in the ground."""

    at_m: Ground
    radii_m: tuple[SemiAxis, SemiAxis, SemiAxis]
    """Half its length, half its width, half its height."""
    yaw_deg: Degrees = 0.0
    buried: Annotated[float, Field(ge=0.0, le=0.95)] = 0.35
    """How much of its height lies below the ground."""
    look: Literal["boulder", "brain_coral", "lobed_coral"] = "boulder"
    """What it is to the eye; to whoever swims into it all are alike."""


_SCALE = {"type": "number", "minimum": 0.1, "maximum": 10.0}


class PlantPlace(Strict):
    """Plants: one at a place, or several scattered around one."""

    flora: Reference
    at_m: Ground | None = None
    """Where the one plant stands, on the ground or on the rock that is there."""
    yaw_deg: Degrees = 0.0
    """How that one is turned."""
    count: Annotated[int, Field(ge=1, le=3000)] = 1
    """How many are scattered around `around_m`."""
    around_m: Ground | None = None
    within_m: Annotated[float, Field(gt=0.0, le=500.0)] = 1.0
    scale: Annotated[
        tuple[PlantScale, PlantScale],
        WithJsonSchema(
            {"anyOf": [_SCALE, {"type": "array", "items": _SCALE, "minItems": 2, "maxItems": 2}]}
        ),
    ] = (1.0, 1.0)
    """Size over that of the flora's file: a number, or [smallest, largest]."""
    on: Literal["sand", "rock", "any"] | None = None
    """What scattered ones stand on; null: what the flora likes."""

    @field_validator("scale", mode="before")
    @classmethod
    def _both(cls, scale: object) -> object:
        return (scale, scale) if isinstance(scale, (int, float)) else scale

    @model_validator(mode="after")
    def _one_or_many(self) -> "PlantPlace":
        if (self.at_m is None) == (self.around_m is None):
            message = "a plant stands `at_m`, or several are scattered `around_m`: one of the two"
            raise PydanticCustomError("plants", message)
        alone, single = self.at_m is not None, {"count", "within_m", "on"}
        given = sorted(self.model_fields_set & (single if alone else {"yaw_deg"}))
        if given:
            message = "`{key}` goes with `{other}`"
            context = {"key": given[0], "other": "around_m" if alone else "at_m"}
            raise PydanticCustomError("plants", message, context)
        if self.scale[0] > self.scale[1]:
            raise PydanticCustomError("plants", "scale: the smallest comes first, then the largest")
        if alone and self.scale[0] != self.scale[1]:
            raise PydanticCustomError("plants", "the scale of one plant `at_m` is one number")
        return self


class Home(Strict):
    """A place on the ground that a species keeps to."""

    at_m: Ground
    species: Reference


class Start(Strict):
    """Where the submarine starts."""

    at_m: Place
    heading_deg: Degrees = 0.0


class Group(Strict):
    """Fishes that come together: they appear within a ball."""

    species: Reference
    count: Annotated[int, Field(ge=1, le=100_000)]
    around_m: Place
    within_m: Annotated[float, Field(gt=0.0, le=500.0)]
    arrives_s: Seconds = 0.0
    leaves_s: Seconds | None = None
    """null: they stay."""
    restock_s: Seconds | None = 120.0
    """How long after a fish was eaten another comes in its place; null: none ever does."""

    @field_validator("leaves_s")
    @classmethod
    def _after_arrival(cls, leaves: float | None, info: ValidationInfo) -> float | None:
        if leaves is not None and leaves <= info.data.get("arrives_s", -1.0):
            raise PydanticCustomError("leaves", "the group must leave after it arrives")
        return leaves


class FoodPatch(Strict):
    """Food that drifts in a ball of water: particles, each a small meal."""

    around_m: Place
    within_m: Annotated[float, Field(gt=0.0, le=100.0)]
    particles: Annotated[int, Field(ge=1, le=20_000)]
    meal_g: Annotated[float, Field(gt=0.0, le=10_000.0)] = 0.05
    """Of one particle."""
    drift_m_per_s: Drift = (0.0, 0.0, 0.0)
    """The way that the particles go; who leaves the ball comes back on its other side."""
    returns_s: Seconds | None = 60.0
    """How long after a particle was eaten there is another; null: never."""


class PhotographGoal(Strict):
    """So many fishes of a species in one frame."""

    species: Reference
    count: Annotated[int, Field(ge=1, le=1000)]
    within_m: Annotated[float, Field(ge=1.0, le=50.0)]
    """How near each must be."""


class Objective(Strict):
    """What the player is asked to do."""

    photograph: PhotographGoal
    par_s: Annotated[float, Field(ge=5.0, le=36_000.0)] = 120.0
    """A good time: faster dives score more."""


class Prompt(Strict):
    """A hint for newcomers; it stays until the player has done what it asks for."""

    text: Annotated[str, StringConstraints(pattern=TITLE_PATTERN, max_length=140)]
    until: Literal["moved", "turned", "rose", "framed", "enough", "photographed", "won"]
    """moved: throttle used; turned, rose: those controls used; framed: a wanted fish in the frame and near enough;
    enough: as many as wanted; photographed: a photograph taken; won: objective met."""


class LevelFile(Strict):
    """A level: `levels/NAME.yaml` of a mod."""

    title: Title
    """What players read."""
    brief: Words = ""
    """What the player is told before the dive."""
    overrides: Reference | None = None
    """A level of another mod to change: what stands here replaces what stands there."""
    world: Bounds
    seabed: Seabed = Seabed()
    water: Water = Water()
    sun: Sun = Sun()
    day: Day = Day()
    rocks: Annotated[tuple[RockPlace, ...], Field(max_length=400)] = ()
    plants: Annotated[tuple[PlantPlace, ...], Field(max_length=400)] = ()
    homes: Annotated[tuple[Home, ...], Field(max_length=200)] = ()
    submarine: Start
    fishes: Annotated[tuple[Group, ...], Field(max_length=400)] = ()
    food: Annotated[tuple[FoodPatch, ...], Field(max_length=200)] = ()
    flow: Flows = ()
    """Sources, holes, whirlwinds and currents: they carry food and fishes, and bend anemones and weeds."""
    objective: Objective
    prompts: Annotated[tuple[Prompt, ...], Field(max_length=20)] = ()


class Level(LevelFile):
    """A level as the game plays it: species and flora are named in full."""

    name: str
    """`mod:name`, or `name` in the base game."""
