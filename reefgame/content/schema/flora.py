"""What a flora file may say: a species of anemone, seagrass, kelp, sea fan or soft coral (papers/002, section 3).

All sizes are those of a plant of scale 1. A fibre's stiffness at a node is k = r^n K: `stiffness` is K, `exponent` n,
r the radius in metres.
"""

from typing import Annotated, Literal, TypeAlias

from pydantic import Field, ValidationInfo, field_validator, model_validator
from pydantic_core import PydanticCustomError

from reefgame.content.schema.strict import Colour, Fraction, Reference, Strict, Title

Length: TypeAlias = Annotated[float, Field(ge=0.5, le=2000.0)]
Radius: TypeAlias = Annotated[float, Field(ge=0.05, le=300.0)]
Angle: TypeAlias = Annotated[float, Field(ge=0.0, le=180.0)]
FORMS = ("anemone", "seagrass", "kelp", "sea_fan", "soft_coral")
MOST_FIBRES = 3000
"""Of one plant."""


class Painted(Strict):
    """What something is coloured like."""

    colours: tuple[Colour, Colour]
    """At the root and at the tip; of a disc: at the mouth and at the rim."""
    pattern: Literal["plain", "spots", "bands", "stripes", "mottle"] = "plain"
    """bands run around, stripes along."""
    pattern_colour: Colour = "#ffffff"
    marks: Annotated[float, Field(ge=1.0, le=100.0)] = 6.0
    """How many of the pattern from root to tip."""
    translucency: Fraction = 0.0
    """How much light shines through."""


class Fibres(Painted):
    """One kind of fibre: its shape, its colours, and how it bends."""

    nodes: Annotated[int, Field(ge=2, le=32)]
    """Joints, root included: more bend more smoothly and cost more time."""
    length_cm: tuple[Length, Length]
    """The shortest and the longest; of tentacles: those at the mouth and those at the rim."""
    radius_cm: Annotated[tuple[Radius, ...], Field(min_length=1, max_length=16)]
    """At even steps from root to tip; half the width of blades and fronds."""
    stiffness: Annotated[float, Field(gt=0.0, le=1e9)]
    """K: twice as much bends half as far."""
    exponent: Annotated[float, Field(ge=0.0, le=20.0)] = 2.0
    """n: 2 or 3; more leaves the root stiff and the tip soft."""
    curl_deg: Annotated[float, Field(ge=-360.0, le=360.0)] = 0.0
    """How far it curves outwards from root to tip in still water; below 0 inwards."""
    variety: Fraction = 0.25
    """How much single ones differ."""


class DiscLook(Painted):
    """The oral disc, on which tentacles stand around the mouth."""

    radius_cm: Annotated[float, Field(ge=1.0, le=200.0)]
    mouth_cm: Annotated[float, Field(ge=0.1, le=199.0)]
    """Radius of the mouth."""
    dome: Annotated[float, Field(ge=-1.0, le=1.0)] = 0.1
    """How far its middle stands above its rim, over its radius."""

    @field_validator("mouth_cm")
    @classmethod
    def _smaller(cls, mouth: float, info: ValidationInfo) -> float:
        radius = info.data.get("radius_cm")
        if radius is not None and mouth >= radius:
            raise PydanticCustomError("mouth", "the mouth is smaller than the disc")
        return mouth


class Tentacles(Fibres):
    """Tentacles in the order of a sunflower's seeds: each as near the mouth as those before it let it stand."""

    base_cm: Annotated[float, Field(ge=0.2, le=50.0)]
    """Radius of the ground that each takes on the disc: it decides how many there are."""
    splay_deg: tuple[Angle, Angle] = (15.0, 70.0)
    """How far those at the mouth and those at the rim lean from the axis."""


class AnemoneForm(Strict):
    """A sea anemone."""

    disc: DiscLook
    foot: Fibres
    tentacles: Tentacles
    stings: bool = True
    """Whether fishes that are not at home in it are stung."""
    holds_cm: Annotated[float, Field(ge=0.0, le=100.0)] = 0.0
    """Length of the largest fish that it holds and eats; 0: none."""

    @field_validator("tentacles")
    @classmethod
    def _fit(cls, tentacles: Tentacles, info: ValidationInfo) -> Tentacles:
        disc = info.data.get("disc")
        if disc is None:
            return tentacles
        ring = disc.radius_cm - disc.mouth_cm
        if 2.0 * tentacles.base_cm > ring:
            message = "no tentacle fits between mouth and rim: base_cm is at most {most}"
            raise PydanticCustomError("tentacles", message, {"most": f"{0.5 * ring:.3g}"})
        number = 0.75 * (disc.radius_cm**2 - disc.mouth_cm**2) / tentacles.base_cm**2
        if number > MOST_FIBRES:
            message = "about {number} tentacles would stand on this disc, at most {most}: a larger base_cm"
            context = {"number": round(number), "most": MOST_FIBRES}
            raise PydanticCustomError("tentacles", message, context)
        return tentacles


class SeagrassForm(Strict):
    """A patch of seagrass: one plant of a level is one patch."""

    blades: Annotated[int, Field(ge=1, le=MOST_FIBRES)]
    guides: Annotated[int, Field(ge=1, le=500)] = 12
    """Blades that bend by themselves; the others are interpolated, which costs little."""
    across_cm: Annotated[float, Field(ge=1.0, le=1000.0)]
    """Radius of the patch."""
    blade: Fibres
    lean_deg: Angle = 20.0
    """How far they lean at most."""


class Fronds(Fibres):
    """Blades along a stipe."""

    number: Annotated[int, Field(ge=0, le=200)]
    """Of each stipe."""
    rise_deg: Angle = 70.0
    """Between a frond and upright."""


class Bladder(Painted):
    """The gas bladder at each frond's root, which holds it up."""

    radius_cm: Annotated[float, Field(ge=0.1, le=20.0)]


class KelpForm(Strict):
    """A kelp."""

    stipes: Annotated[int, Field(ge=1, le=20)]
    across_cm: Annotated[float, Field(ge=0.0, le=300.0)] = 10.0
    """Radius of the holdfast."""
    stipe: Fibres
    """None is longer than the water above it is deep."""
    fronds: Fronds
    bladder: Bladder | None = None

    @field_validator("fronds")
    @classmethod
    def _few(cls, fronds: Fronds, info: ValidationInfo) -> Fronds:
        _limit(info.data.get("stipes", 1) * (1 + 2 * fronds.number), "kelp")
        return fronds


class Branches(Fibres):
    """The stem and its branches; lengths and radii are the stem's."""

    number: Annotated[int, Field(ge=1, le=20)]
    """Of each branch."""
    orders: Annotated[int, Field(ge=0, le=5)]
    """How often it branches."""
    spread_deg: Angle = 45.0
    """Between a branch and its parent."""
    shrink: Annotated[float, Field(ge=0.1, le=1.0)] = 0.6
    """Size of a branch over its parent's."""

    @field_validator("orders")
    @classmethod
    def _few(cls, orders: int, info: ValidationInfo) -> int:
        number = info.data.get("number", 1)
        _limit(sum(number**order for order in range(orders + 1)), "sea fan")
        return orders


class Polyps(Fibres):
    """The small flowers at the ends of the last branches."""

    number: Annotated[int, Field(ge=1, le=50)]
    """Of each end."""


class SeaFanForm(Strict):
    """A sea fan: branches in one plane."""

    branches: Branches


class SoftCoralForm(Strict):
    """A soft coral: branches all around, with polyps."""

    branches: Branches
    polyps: Polyps

    @field_validator("polyps")
    @classmethod
    def _few(cls, polyps: Polyps, info: ValidationInfo) -> Polyps:
        branches = info.data.get("branches")
        if branches is not None:
            _limit(branches.number**branches.orders * (polyps.number + 1), "soft coral")
        return polyps


def _limit(fibres: int, what: str) -> None:
    if fibres > MOST_FIBRES:
        message = "this {what} would have {fibres} fibres: at most {most}"
        context = {"what": what, "fibres": fibres, "most": MOST_FIBRES}
        raise PydanticCustomError("fibres", message, context)


class FloraFile(Strict):
    """A species of plant: `flora/NAME.yaml` of a mod. With `like:` only what differs needs to stand here."""

    title: Title
    """What players read."""
    like: Reference | None = None
    """A species of plant to start from: all that does not stand here is as there."""
    overrides: Reference | None = None
    """A species of another mod to change: what stands here replaces what stands there."""
    stands: Literal["sand", "rock", "any"] = "any"
    """Where it grows, unless a level says otherwise."""
    room_cm: Annotated[float, Field(ge=1.0, le=1000.0)]
    """Radius of the ground that it takes for itself."""
    anemone: AnemoneForm | None = None
    seagrass: SeagrassForm | None = None
    kelp: KelpForm | None = None
    sea_fan: SeaFanForm | None = None
    soft_coral: SoftCoralForm | None = None

    @model_validator(mode="after")
    def _one_form(self) -> "FloraFile":
        given = [form for form in FORMS if getattr(self, form) is not None]
        if len(given) != 1:
            message = "a plant has one form, of {forms}: this has {given}"
            context = {"forms": ", ".join(FORMS), "given": " and ".join(given) or "none"}
            raise PydanticCustomError("form", message, context)
        return self

    @property
    def form(self) -> str:
        """The name of its form, one of `FORMS`."""
        return next(form for form in FORMS if getattr(self, form) is not None)
