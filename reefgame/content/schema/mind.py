"""What a species file may say of its mind: what it eats, how soon it hungers, what it fears and likes (papers/004)."""

from typing import Annotated, Literal

from pydantic import Field

from reefgame.content.schema.strict import Fraction, Reference, Strict


class Likes(Strict):
    """The water that it likes; null where it does not mind."""

    light: Literal["bright", "dark"] | None = None
    water: Literal["warm", "cold"] | None = None


class Mind(Strict):
    """Appetites and fears."""

    diet: Annotated[tuple[Reference, ...], Field(max_length=100)] = ()
    """Species that it eats, where they are there and at most a third as long as it is. Predators alone hunt."""
    grazes: bool | None = None
    """Whether it eats food that drifts in the water; null: unless it is a predator."""
    meal_g: Annotated[float, Field(gt=0.0, le=1_000_000.0)] | None = None
    """An average meal; null: a four-hundredth of its own weight."""
    appetite_meals: Annotated[float, Field(ge=0.5, le=1000.0)] = 4.0
    """Meals that fill it."""
    digests_min: Annotated[float, Field(ge=0.1, le=10_000.0)] = 25.0
    """Time in which a full stomach is empty again."""
    breeds_min: Annotated[float, Field(ge=0.1, le=10_000.0)] = 7.0
    """Time from mating until it would like to as much as ever again."""
    wariness_m: Annotated[float, Field(ge=0.0, le=20.0)] = 1.5
    """The nearness of a predator one metre long than which nothing frightens it more."""
    curiosity: Fraction = 0.3
    """How likely a pacifist is to come and look at something new."""
    likes: Likes = Likes()
    shelters: Literal["anemones"] | None = None
    """Where it flees to and is at home: anemones do not sting it; null: it has no such place."""
