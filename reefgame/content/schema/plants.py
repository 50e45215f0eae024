"""What a level file may say of plants: which stand where (papers/002, 5.3)."""

from typing import Annotated, Literal, TypeAlias

from pydantic import Field, WithJsonSchema, field_validator, model_validator
from pydantic_core import PydanticCustomError

from reefgame.content.schema.strict import Degrees, Ground, Reference, Strict

PlantScale: TypeAlias = Annotated[float, Field(ge=0.1, le=10.0)]

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
    stands: Literal["sand", "rock", "any"] | None = None
    """What scattered ones stand on; null: what the flora likes."""

    @field_validator("scale", mode="before")
    @classmethod
    def _both(cls, scale: object) -> object:
        if isinstance(scale, (int, float)):
            return scale, scale
        if not isinstance(scale, tuple):
            message = (
                "must be a number, such as 1.5, or the smallest and the largest, such as [0.8, 1.2]"
            )
            raise PydanticCustomError("scale", message)
        return scale

    @model_validator(mode="after")
    def _one_or_many(self) -> "PlantPlace":
        if (self.at_m is None) == (self.around_m is None):
            message = "a plant stands `at_m`, or several are scattered `around_m`: one of the two"
            raise PydanticCustomError("plants", message)
        alone, single = self.at_m is not None, {"count", "within_m", "stands"}
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
