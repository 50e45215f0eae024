"""What each species is: body, senses, temper and colours, one row each (DESIGN 2).

Species never change during a dive; they are content, not state.
"""

from dataclasses import dataclass

from components.body import Body, Swim
from components.mind import Role
from components.repertoire import Repertoire
from components.skin import Skin


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
