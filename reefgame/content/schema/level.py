"""What a level file may say: the world, its rocks, plants and fishes, the submarine and what the player is to do.

Places are [x, y] or [x, y, z] in metres; z is up and 0 at the surface, so 5 m down is -5. Angles are in degrees; a
heading of 0 looks along x, 90 along y.
"""

from typing import Annotated, Literal, TypeAlias

from pydantic import (
    Field,
    StringConstraints,
    ValidationInfo,
    field_validator,
)
from pydantic_core import PydanticCustomError

from components.ground import STRAY
from reefgame.content.schema.flow import Flows
from reefgame.content.schema.plants import PlantPlace
from reefgame.content.schema.strict import (
    TITLE_PATTERN,
    Degrees,
    Fraction,
    Ground,
    Place,
    Reference,
    Strict,
    Title,
    Words,
)

Seconds: TypeAlias = Annotated[float, Field(ge=0.0, le=36_000.0)]
Current: TypeAlias = Annotated[float, Field(ge=-2.0, le=2.0)]
Drift: TypeAlias = tuple[Current, Current, Current]
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


class Home(Strict):
    """A place on the ground that a species keeps to."""

    at_m: Ground
    species: Reference
    within_m: Annotated[float, Field(ge=0.2, le=100.0)] = STRAY
    """How far about it they swim, and how high above it; a school travels about within it."""


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
    hunger: Annotated[float, Field(ge=-1.0, le=1.0)] | None = None
    """How hungry they come: 1 starved, 0 full, though food still tempts, -1 sated; null: fed at different times."""
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
    more_fishes: Annotated[tuple[Group, ...], Field(max_length=400)] = ()
    """With `overrides`: groups that come beside those that are there, whatever other mods add."""
    food: Annotated[tuple[FoodPatch, ...], Field(max_length=200)] = ()
    flow: Flows = ()
    """Sources, holes, whirlwinds and currents: they carry food and fishes, and bend anemones and weeds."""
    objective: Objective
    prompts: Annotated[tuple[Prompt, ...], Field(max_length=20)] = ()


class Level(LevelFile):
    """A level as the game plays it: species and flora are named in full."""

    name: str
    """`mod:name`, or `name` in the base game."""
