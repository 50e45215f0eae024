"""What a scene's file may say: a level without a player, moods, a duration, and what is measured and expected.

Water, rocks, plants, homes, flow and food are written as in a level's file, with the same units.
"""

from typing import Annotated, Any, Literal, TypeAlias

from pydantic import Field, ValidationInfo, field_validator, model_validator
from pydantic_core import PydanticCustomError

from reefgame.content.schema.flow import Flows
from reefgame.content.schema.level import (
    Bounds,
    Day,
    FoodPatch,
    Home,
    RockPlace,
    Seabed,
    Seconds,
    Start,
    Water,
)
from reefgame.content.schema.plants import PlantPlace
from reefgame.content.schema.strict import (
    Degrees,
    Fraction,
    Identifier,
    Place,
    Reference,
    Strict,
    Title,
    Words,
)

Expected: TypeAlias = float | None


class SceneGroup(Strict):
    """Fishes that come together, and how they then feel. Nobody replaces the eaten."""

    species: Reference
    name: Identifier | None = None
    """What expectations call the group; null: as its species."""
    count: Annotated[int, Field(ge=1, le=2000)] = 1
    around_m: Place
    within_m: Annotated[float, Field(gt=0.0, le=500.0)] = 0.5
    arrives_s: Seconds = 0.0
    heading_deg: Degrees | None = None
    """Where all of them face; null: as a level's groups do."""
    hunger: Annotated[float, Field(ge=-1.0, le=1.0)] = 0.0
    """1 - what is in the stomach over the appetite: 0 for who is full, whom food still tempts, -1 for the sated."""
    libido: Fraction = 0.0
    """Of a sated fish."""
    sexes: Literal["any", "both"] = "any"
    """both: at least one male and one female."""
    led_at: Identifier | None = None
    """A group at whose middle they are led, a model that has no will of its own, and on past it."""


class Vary(Strict):
    """The scene played once for each value of one of the `mind:` keys of a species."""

    species: Reference
    mind: Literal["wariness_m", "curiosity", "appetite_meals", "digests_min", "breeds_min"]
    values: Annotated[tuple[float, ...], Field(max_length=8)]


class Expectation(Strict):
    """A measure of one group, and the values that pass."""

    measure: Identifier
    """A key of `reefgame.testing.MEASURES`."""
    of: Identifier
    """The group that is measured."""
    to: Identifier | None = None
    """The group that it is measured against, where the measure asks for one."""
    after_s: Annotated[float, Field(ge=0.0, le=36_000.0)] = 0.0
    """What was before does not count: fishes need a while to settle."""
    at_least: Expected = None
    at_most: Expected = None
    rises_by: Annotated[float, Field(gt=1.0)] | None = None
    """At least so many times as much with each value of `vary` as with the one before."""

    @model_validator(mode="after")
    def _asks(self) -> "Expectation":
        if self.at_least is None and self.at_most is None and self.rises_by is None:
            raise PydanticCustomError(
                "expectation", "nothing is expected: say `at_least`, `at_most` or `rises_by`"
            )
        return self


class FibreExpectation(Strict):
    """A measure of how the fibres of some plants bend, and the values that pass."""

    measure: Identifier
    """A key of `reefgame.testing.FIBRE_MEASURES`."""
    of: Reference
    """The flora whose plants are measured, as `plants` name it."""
    to: Identifier | None = None
    """The group of fishes against which they are measured, where the measure asks for one."""
    at_least: Expected = None
    at_most: Expected = None

    @model_validator(mode="after")
    def _asks(self) -> "FibreExpectation":
        if self.at_least is None and self.at_most is None:
            raise PydanticCustomError(
                "expectation", "nothing is expected: say `at_least` or `at_most`"
            )
        return self


class Picture(Strict):
    """Whence and when a scene is looked at."""

    at_s: Seconds = 0.0
    eye_m: Place
    at_m: Place
    """What stands in the middle of the picture."""


class SceneFile(Strict):
    """A scene: a claim about behaviour, or about how plants bend, that holds or does not."""

    title: Title
    """The claim, in a few words."""
    why: Words = ""
    """Where it comes from, and how it is measured."""
    seconds: Annotated[float, Field(ge=1.0, le=36_000.0)]
    """How long it is watched."""
    world: Bounds = Bounds(radius_m=30.0, depth_m=12.0)
    seabed: Seabed = Seabed(relief_m=0.5)
    water: Water = Water()
    day: Day = Day()
    rocks: Annotated[tuple[RockPlace, ...], Field(max_length=400)] = ()
    plants: Annotated[tuple[PlantPlace, ...], Field(max_length=400)] = ()
    homes: Annotated[tuple[Home, ...], Field(max_length=200)] = ()
    flow: Flows = ()
    submarine: Start | None = None
    """Null: there is none."""
    fishes: Annotated[tuple[SceneGroup, ...], Field(max_length=100)]
    food: Annotated[tuple[FoodPatch, ...], Field(max_length=200)] = ()
    species: dict[Reference, dict[str, Any]] = Field(default_factory=dict)
    """What is other than in a species' own file, in that file's keys, such as `sardine: {mind: {wariness_m: 0}}`."""
    vary: Vary | None = None
    control: dict[str, Any] | None = None
    """Keys of the scene that are other in a control, which must fail: without the cause the claim does not hold."""
    expect: Annotated[tuple[Expectation, ...], Field(max_length=20)] = ()
    fibres: Annotated[tuple[FibreExpectation, ...], Field(max_length=20)] = ()
    """What is expected of the plants, bent as the game draws them."""
    picture: Picture | None = None
    """How docs and golden frames show it."""

    @field_validator("fishes")
    @classmethod
    def _some(cls, entries: tuple[Strict, ...]) -> tuple[Strict, ...]:
        if not entries:
            raise PydanticCustomError("scene", "there must be at least one")
        return entries

    @model_validator(mode="after")
    def _claims(self) -> "SceneFile":
        if not self.expect and not self.fibres:
            raise PydanticCustomError(
                "scene", "nothing is claimed: say what to `expect`, or of `fibres`"
            )
        return self

    @field_validator("expect")
    @classmethod
    def _varied(
        cls, expect: tuple[Expectation, ...], info: ValidationInfo
    ) -> tuple[Expectation, ...]:
        if info.data.get("vary") is None and any(one.rises_by for one in expect):
            raise PydanticCustomError("expectation", "`rises_by` needs `vary`")
        return expect
