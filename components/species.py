"""What each species is: body, senses, temper and colours, one row each (DESIGN 2).

Species never change during a dive; they are content, not state.
"""

from dataclasses import dataclass

from components.body import Body, Swim
from components.mind import Role
from components.repertoire import Repertoire
from components.singularity import SingularityKind
from components.skin import Skin


@dataclass(frozen=True)
class Temper:
    """How the species feels and decides (papers/004; FINDINGS 2). All are content, not state."""

    diet: tuple[str, ...] = ()
    "names of the species that it eats"
    grazes: bool = True
    "whether it eats food that drifts in the water"
    meal: float = 1.0
    "[g] of an average meal"
    appetite: float = 4.0
    "a: meals that fill it"
    digestion: float = 1500.0
    "[s] until a full stomach is empty, 1 / p0"
    breeding: float = 400.0
    "[s] from mating until libido is full again, 1 / p1"
    wariness: float = 1.5
    "[m] D0: a predator of one metre this near is all that it can fear; 2.5 times as much in a coward"
    curiosity: float = 0.3
    "chance, 0 to 1, that a pacifist comes to look at what is new"
    bright: int = 0
    "1 where it likes light, -1 where it likes the dark, 0 where it does not mind"
    warm: int = 0
    "1 where it likes warmth, -1 where it likes the cold, 0 where it does not mind"
    at_home: bool = False
    "whether it shelters in anemones, which do not sting it"


@dataclass(frozen=True)
class Stirs:
    """What a passing fish is to anemones and weeds (papers/002, section 1)."""

    kind: SingularityKind = SingularityKind.HOLE
    "a source, that they bend away from, or a hole, that they reach for"
    speed: float = 1.2
    "[m/s] in its centre, Phi_max"
    core: float = 0.2
    "[m] from the centre at which that has fallen to a half"
    reach: float = 1.0
    "[m] beyond which nothing is felt; 0 where nothing is stirred"


@dataclass(frozen=True)
class Species:
    """One species, as content gives it."""

    name: str
    "`mod:name`, or `name` in the base game"
    title: str
    role: Role
    schooling: bool
    length: float
    "[m] of an adult"
    length_spread: float
    "largest deviation from it, as a fraction"
    sight: float
    "[m] how far it sees fishes of its own size in clear water"
    spacing: float
    "distance kept in a school [BL]"
    depth: tuple[float, float]
    "[m] shallowest and deepest that it likes"
    body: Body
    swim: Swim
    skin: Skin
    repertoire: Repertoire
    temper: Temper = Temper()
    stirs: Stirs = Stirs()
