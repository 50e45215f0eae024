"""What a level file may say of the water's flow: sources, holes, whirlwinds and currents (papers/002, section 2).

Speeds are those in the centre. What moves or changes has a `track` of key frames; what swims along is `attached`.
"""

from itertools import pairwise
from typing import Annotated, Final, Literal, TypeAlias

from pydantic import Field, field_validator, model_validator
from pydantic_core import PydanticCustomError

from reefgame.content.schema.strict import Fraction, Place, Reference, Strict

Speed: TypeAlias = Annotated[float, Field(ge=-20.0, le=20.0)]
Reach: TypeAlias = Annotated[float, Field(ge=0.1, le=1000.0)]
Component: TypeAlias = Annotated[float, Field(ge=-1.0, le=1.0)]
Axis: TypeAlias = tuple[Component, Component, Component]

MOST_FRAMES: Final = 500
MOST_FLOWS: Final = 200


class KeyFrame(Strict):
    """Where a singularity is at a time, and how strong."""

    at_s: Annotated[float, Field(ge=0.0, le=36_000.0)]
    """Since the dive began."""
    at_m: Place | None = None
    """null: it stays where it is; all frames of a track have a place, or none."""
    strength: Annotated[float, Field(ge=-10.0, le=10.0)] = 1.0
    """Over that which the singularity has by itself; below 0 a source is a hole and a current runs back."""


class Track(Strict):
    """Key frames; before the first and after the last it stays as they say."""

    between: Literal["smooth", "linear"] = "smooth"
    """How it goes from frame to frame; neither passes beyond what the frames say."""
    loop: bool = False
    """Whether the last frame is the first of the next round."""
    frames: Annotated[tuple[KeyFrame, ...], Field(min_length=1, max_length=MOST_FRAMES)]

    @field_validator("frames")
    @classmethod
    def _in_order(cls, frames: tuple[KeyFrame, ...]) -> tuple[KeyFrame, ...]:
        for number, (before, after) in enumerate(pairwise(frames), start=1):
            if after.at_s <= before.at_s:
                text = "key frames must come in the order of time: frames[{number}] at {at} s follows {before} s"
                raise PydanticCustomError(
                    "track",
                    text,
                    {"number": number, "at": f"{after.at_s:g}", "before": f"{before.at_s:g}"},
                )
        if len({frame.at_m is None for frame in frames}) > 1:
            raise PydanticCustomError("track", "all frames of a track have an `at_m`, or none has")
        return frames

    @model_validator(mode="after")
    def _goes_round(self) -> "Track":
        if self.loop and len(self.frames) < 2:
            raise PydanticCustomError("track", "a loop needs two key frames or more")
        return self

    @property
    def moves(self) -> bool:
        """Whether the frames say where it is."""
        return self.frames[0].at_m is not None


class Carrier(Strict):
    """What carries a singularity: one of the three."""

    submarine: Literal[True] | None = None
    species: Reference | None = None
    """Its fish that has been there the longest."""
    rock: Annotated[int, Field(ge=0, le=399)] | None = None
    """Counted from 0 in the order of `rocks`."""
    offset_m: Place = (0.0, 0.0, 0.0)
    """Ahead, up and to the right of the carrier; a rock's as its yaw turns it: along its length, up, to the right."""

    @model_validator(mode="after")
    def _one(self) -> "Carrier":
        if sum(one is not None for one in (self.submarine, self.species, self.rock)) != 1:
            raise PydanticCustomError(
                "carrier", "say one of `submarine: true`, `species: NAME` and `rock: NUMBER`"
            )
        return self


class Wave(Strict):
    """How a current swells and slackens, in waves that travel along it."""

    length_m: Annotated[float, Field(ge=0.5, le=10_000.0)] | None = None
    """From crest to crest; null: it swells everywhere at once."""
    period_s: Annotated[float, Field(ge=0.2, le=36_000.0)] | None = None
    """From crest to crest at one place; null: the waves stand still."""
    amplitude: Annotated[float, Field(ge=0.0, le=20.0)] = 0.5
    """Over the current's own speed; above 1 it runs back for a while."""
    phase_turns: Fraction = 0.0
    """Where in a wave it begins, as a part of one."""


class _Flow(Strict):
    at_m: Place | None = None
    """Its centre."""
    attached: Carrier | None = None
    """What it goes with, instead of `at_m`."""
    reach_m: Reach | None = None
    """Beyond this nothing is felt, and to .7 of it the whole; null: it is felt everywhere."""
    track: Track | None = None

    @model_validator(mode="after")
    def _somewhere(self) -> "_Flow":
        moves = self.track is not None and self.track.moves
        given = [self.at_m is not None, self.attached is not None, moves]
        if sum(given) > 1:
            raise PydanticCustomError(
                "flow",
                "its place is said twice: say `at_m`, or `attached`, or `at_m` in its frames",
            )
        if not any(given) and (self._is_local or self.reach_m is not None):
            raise PydanticCustomError(
                "flow", "where is it? say `at_m`, or `attached`, or a `track`"
            )
        return self

    @property
    def _is_local(self) -> bool:
        return True


class _Vortex(_Flow):
    speed_m_per_s: Speed
    """In its centre."""
    core_m: Annotated[float, Field(ge=0.05, le=50.0)] = 0.5
    """How far from the centre the speed has fallen to a half."""
    softening_m: Annotated[float, Field(ge=0.001, le=50.0)] = 0.05
    """How near to the centre the direction fades out."""


def _unit(axis: Axis) -> Axis:
    if sum(part * part for part in axis) < 1e-4:
        raise PydanticCustomError("axis", "an axis needs a direction, such as [0, 0, 1] for up")
    return axis


class Source(_Vortex):
    """Water that wells up and pushes away, or is sucked in."""

    kind: Literal["source", "hole"]


class Whirlwind(_Vortex):
    """Water that turns about an axis."""

    kind: Literal["whirlwind"]
    axis: Axis = (0.0, 0.0, 1.0)
    """About which it turns: clockwise from above where it is [0, 0, 1]; if attached: ahead, up, right."""

    _directed = field_validator("axis")(_unit)


class Current(_Flow):
    """Water that flows one way: everywhere, or as a jet within its reach."""

    kind: Literal["current"]
    speed_m_per_s: Speed
    axis: Axis
    """The way it flows; if attached: ahead, up, right."""
    wave: Wave | None = None

    _directed = field_validator("axis")(_unit)

    @property
    def _is_local(self) -> bool:
        return False


AnyFlow: TypeAlias = Source | Whirlwind | Current
Flow: TypeAlias = Annotated[AnyFlow, Field(discriminator="kind")]
Flows: TypeAlias = Annotated[tuple[Flow, ...], Field(max_length=MOST_FLOWS)]


def carried_by(flow: AnyFlow, species: str) -> AnyFlow:
    """Return the same, carried by a species of this full name."""
    assert flow.attached is not None
    return flow.model_copy(
        update={"attached": flow.attached.model_copy(update={"species": species})}
    )


class Stirs(Strict):
    """What a fish is to anemones and weeds: those that it passes bend away from it, or reach for it."""

    kind: Literal["source", "hole", "none"]
    """source: it pushes them away; hole: it draws them; none: they do not mind it."""
    speed_m_per_s: Annotated[float, Field(ge=0.0, le=20.0)] = 1.2
    core_m: Annotated[float, Field(ge=0.05, le=5.0)] = 0.2
    """How far from the fish the speed has fallen to a half."""
    reach_m: Annotated[float, Field(ge=0.1, le=10.0)] = 1.0
    """Beyond this nothing is felt."""
