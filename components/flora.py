"""Flora: what a species of plant is, a plant of a level, and what grows of it (papers/002, section 3).

Anemones are animals; here whatever is rooted and bends is a plant. Static content: nothing of it is simulation state.
Lengths are those of a plant of scale 1. Angles are in degrees.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, Literal, NamedTuple, TypeAlias

from components.fibre import Tuft

Colour: TypeAlias = tuple[float, float, float]
"Linear red, green and blue, 0 to 1."

LookKind: TypeAlias = Literal["tentacle", "blade", "frond", "branch", "foot", "disc"]
Pattern: TypeAlias = Literal["plain", "spots", "bands", "stripes", "mottle"]
Stand: TypeAlias = Literal["sand", "rock", "any"]


class Look(NamedTuple):
    """How the fibres of a tuft, or an oral disc, are drawn."""

    kind: LookKind
    "the shape: round and tapering, flat and long, flat and wide, a thin tube, a wide column, a disc with a mouth"
    root: Colour
    "at the root; of a disc: around the mouth"
    tip: Colour
    "at the tip; of a disc: at its rim"
    pattern_colour: Colour
    pattern: Pattern = "plain"
    pattern_scale: float = 6.0
    "marks of the pattern from root to tip"
    translucency: float = 0.0
    "0 to 1: how much light shines through"


class Disc(NamedTuple):
    """An oral disc: rides on the last node of an anemone's foot, across its direction."""

    tuft: int
    "the foot's, index in `Growth.tufts`"
    fibre: int
    "of that tuft"
    radius: float
    "[m]"
    mouth: float
    "[m] radius"
    look: int
    "index in `Growth.looks`"


class Growth(NamedTuple):
    """All that grows in a level, for `components.garden.Garden`."""

    tufts: list[Tuft]
    "`plant` is the index of a plant, `look` of a look"
    looks: tuple[Look, ...]
    discs: tuple[Disc, ...]


class Limb(NamedTuple):
    """One kind of fibre: its shape and how it bends."""

    nodes: int
    "root included"
    length: tuple[float, float]
    "[m] from the shortest to the longest; of tentacles: at the mouth and at the rim"
    radii: tuple[float, ...]
    "[m] at even steps from root to tip, or one number for all"
    modulus: float
    "K of papers/002 eq. 11"
    exponent: float = 2.0
    "n of papers/002 eq. 11"
    curl: float = 0.0
    "[deg] by which it curves from root to tip at rest; outwards, or where it leans to"
    variety: float = 0.2
    "0 to 1: how much single ones differ"


@dataclass(frozen=True)
class Anemone:
    """A foot that carries tentacles in phyllotactic order around a mouth (papers/002, 3.1)."""

    radius: float
    "[m] of the oral disc"
    mouth: float
    "[m] radius of the mouth, which no tentacle stands in"
    base: float
    "[m] radius of the ground that each tentacle takes on the disc: b of FINDINGS 9"
    dome: float
    "height of the disc's middle over its rim, over its radius"
    foot: Limb
    tentacle: Limb
    splay: tuple[float, float]
    "[deg] from the axis at which tentacles stand at the mouth and at the rim"
    stings: bool = True
    "whether who is not at home in it is stung"
    holds: float = 0.0
    "[m] length of the largest fish that it holds and eats; 0: none"


@dataclass(frozen=True)
class Seagrass:
    """Blades from one patch of sand; a few bend, the others are interpolated (papers/002, 5.4)."""

    blades: int
    guides: int
    "blades that bend by themselves"
    across: float
    "[m] radius of the patch"
    blade: Limb
    lean: float
    "[deg] from upright, at most"


@dataclass(frozen=True)
class Kelp:
    """Stipes from a holdfast, with fronds along them; gas bladders at the fronds' roots hold them up."""

    stipes: int
    across: float
    "[m] radius of the holdfast"
    stipe: Limb
    fronds: int
    "of each stipe"
    frond: Limb
    rise: float
    "[deg] between a frond and its stipe"
    bladder: float
    "[m] radius; 0: none"


@dataclass(frozen=True)
class Coral:
    """A stem that branches and branches again: flat as a sea fan, or round and with polyps as a soft coral."""

    flat: bool
    stem: Limb
    branches: int
    "of each branch"
    orders: int
    "times that it branches"
    spread: float
    "[deg] between a branch and its parent"
    shrink: float
    "length and radius of a branch over its parent's"
    polyps: int
    "at the end of each last branch"
    polyp: Limb


Form: TypeAlias = Anemone | Seagrass | Kelp | Coral


@dataclass(frozen=True)
class Flora:
    """One species of plant."""

    name: str
    "`mod:name`, or `name` in the base game"
    title: str
    form: Form
    looks: Mapping[str, Look]
    "by part: tentacle, foot, disc | blade | stipe, frond, bladder | branch, polyp"
    room: float
    "[m] radius of the ground that it takes for itself"
    stands: Stand
    "where it grows"


class Plant(NamedTuple):
    """One plant of a level."""

    flora: str
    "name of its species"
    position: tuple[float, float, float]
    "[m] of its root, on the ground or on a rock"
    up: tuple[float, float, float]
    "unit normal of what it stands on"
    yaw: float
    "[deg] turn about `up`"
    scale: float
    seed: int
    "what its shape is grown from"


_TENTACLES: Final = 0.5


def tentacle_cap(plant: Plant, anemone: Anemone) -> tuple[tuple[float, float, float], float]:
    """Return centre [m] and radius [m] of the ball that an anemone's tentacles fill at rest.

    Play judges contact against this static ball, never against bent nodes: only + * / and no device decides.
    """
    longest = max(anemone.tentacle.length)
    above = plant.scale * (anemone.foot.length[1] + _TENTACLES * longest)
    x, y, z = plant.position
    a, b, c = plant.up
    centre = (x + above * a, y + above * b, z + above * c)
    return centre, plant.scale * (anemone.radius + _TENTACLES * longest)
