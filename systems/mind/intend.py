"""The intention generator: which routine a fish runs now, and why (papers/004; papers/000 section 6; FINDINGS 2).

In order: collision danger with what stands still, then with who moves; fear, to the school or away; what was
interrupted and is remembered; hunger and libido; the habits of light, warmth and company; else wander. Predators do
not flee, school, mate or leave; pacifists do not flee or school unless their species is hunted or likes company.
Dangers are taken up at once; what they interrupt comes back only when they have passed for a while, so that a fish at
a border of two intentions does not flicker.
"""

from typing import Final, NamedTuple

from components.kernels import inlined, row
from components.mind import Intention, Why

WANDER: Final = int(Intention.WANDER)
AVOID_OBSTACLE: Final = int(Intention.AVOID_OBSTACLE)
AVOID_FISH: Final = int(Intention.AVOID_FISH)
SCHOOL: Final = int(Intention.SCHOOL)
EAT: Final = int(Intention.EAT)
MATE: Final = int(Intention.MATE)
LEAVE: Final = int(Intention.LEAVE)
ESCAPE: Final = int(Intention.ESCAPE)
OBEY: Final = int(Intention.OBEY)

_CONTENT: Final = int(Why.CONTENT)
_OBSTACLE: Final = int(Why.OBSTACLE)
_COLLISION: Final = int(Why.COLLISION)
_FEAR_ESCAPE: Final = int(Why.FEAR_ESCAPE)
_FEAR_SCHOOL: Final = int(Why.FEAR_SCHOOL)
_HUNGER: Final = int(Why.HUNGER)
_LIBIDO: Final = int(Why.LIBIDO)
_RESUMED: Final = int(Why.RESUMED)
_COMPANY: Final = int(Why.COMPANY)
_HABITAT: Final = int(Why.HABITAT)
_CURIOSITY: Final = int(Why.CURIOSITY)
PERSISTENCE: Final = int(Why.PERSISTENCE)

AFRAID: Final = 0.5
"""f0: fear above which nothing else matters."""

PANICKED: Final = 0.8
"""f1: fear of one predator above which even a schooler flees alone."""

WANTING: Final = 0.25
"""r: hunger or libido above which a fish acts on it."""

RELENT: Final = 0.8
"""What a fish is about already takes only this much of a threshold to go on."""

WATCHFUL: Final = 1.4
"""A fish that avoids an obstacle goes on until it is this much farther than where it began."""

AVOID_TICKS: Final = 20
"""[ticks] that a fish goes on avoiding another after the danger has passed."""

ESCAPE_TICKS: Final = 45
"""[ticks] that a fish flees at least."""

CALM_TICKS: Final = 40
"""[ticks] between schooling and wandering, either way."""

CHASE_TICKS: Final = 600
"""[ticks] after which a hunter gives a chase up."""

REST_TICKS: Final = 300
"""[ticks] for which it then rests."""

UNEASY: Final = 0.3
"""Unease from which a fish leaves; it goes on to a third of it."""


class Held(NamedTuple):
    """What the fish was about before this thought."""

    intention: int
    why: int
    since: int
    "tick at which it began"
    memory: int
    "the interrupted intention that is remembered, -1 for none"


class Percept(NamedTuple):
    """What decides: the outcome of perceiving and feeling."""

    obstacle: float
    "distance of the nearest obstacle over the distance that alarms"
    collision: float
    "[s] until another fish, or the submarine, is too near, `NO_DANGER` for none"
    threat: bool
    "whether there is one"
    timid: bool
    "whether it is of a kind that flees"
    fear: float
    "F of all"
    danger: float
    "F_m of the most dangerous"
    company: int
    "how many of its kind a schooler sees, its shoal counting as one; 0 for who does not school"
    hunger: float
    libido: float
    food: bool
    "whether it perceives food or prey"
    mate: bool
    "whether it perceives a mate"
    hunter: bool
    "whether it is a predator, who searches where it sees no prey"
    chasing: bool
    "whether it is after a fish"
    unease: float
    "how little light and warmth suit it, 0 where there is nowhere to go"
    curious: float
    "[m] to the submarine that it comes to look at, 0 where it does not"
    whim: bool
    "a coin tossed for this tick"


@inlined
def _remembered(held: Held) -> int:
    """Return what is worth remembering when danger interrupts: the wants, not the dangers."""
    if held.intention in (EAT, MATE):
        return held.intention
    return held.memory


@inlined
def _want(held: Held, p: Percept) -> tuple[int, int, float]:
    """Return EAT or MATE, its reason and want, where one of them presses; else -1."""
    hungry = p.hunger > (WANTING * RELENT if held.intention == EAT else WANTING) and (
        p.food or p.hunter
    )
    fond = p.libido > (WANTING * RELENT if held.intention == MATE else WANTING) and p.mate
    if hungry and fond:
        if p.hunger == p.libido:
            hungry = held.intention == EAT or (held.intention != MATE and p.whim)
        else:
            hungry = p.hunger > p.libido
            if held.intention == MATE and p.hunger * RELENT <= p.libido:
                hungry = False
    if hungry:
        return EAT, _HUNGER, p.hunger
    if fond:
        return MATE, _LIBIDO, p.libido
    return -1, _CONTENT, 0.0


@inlined
def _at_leisure(now: int, held: Held, p: Percept) -> tuple[int, int, float]:
    """Return the intention of a fish without dangers and wants, its reason and what decided."""
    lasted = now - held.since
    if p.unease > (UNEASY / 3.0 if held.intention == LEAVE else UNEASY) and not p.hunter:
        return LEAVE, _HABITAT, p.unease
    wanted = SCHOOL if p.company > 0 else WANDER
    calm = held.intention in (WANDER, SCHOOL)
    if calm and wanted != held.intention and lasted < CALM_TICKS:
        return held.intention, PERSISTENCE, float(CALM_TICKS - lasted)
    if wanted == SCHOOL:
        return SCHOOL, _COMPANY, float(p.company)
    if p.curious > 0.0:
        return WANDER, _CURIOSITY, p.curious
    return WANDER, _CONTENT, max(p.hunger, p.libido)


@row
def intend(now: int, held: Held, p: Percept) -> tuple[int, int, float, int]:
    """Return the intention of the tick `now`, why, the input that decided, and what is remembered from now on."""
    lasted = now - held.since
    if p.obstacle < (WATCHFUL if held.intention == AVOID_OBSTACLE else 1.0):
        return AVOID_OBSTACLE, _OBSTACLE, p.obstacle, _remembered(held)
    if p.threat:
        return AVOID_FISH, _COLLISION, p.collision, _remembered(held)
    fleeing = held.intention == ESCAPE
    if p.timid and p.fear > (AFRAID * RELENT if fleeing else AFRAID):
        bold = p.danger < (PANICKED * RELENT if fleeing else PANICKED) and p.company > 0
        if bold and not (fleeing and lasted < ESCAPE_TICKS):
            return SCHOOL, _FEAR_SCHOOL, p.fear, _remembered(held)
        return ESCAPE, _FEAR_ESCAPE, p.fear, _remembered(held)
    if held.intention == ESCAPE and lasted < ESCAPE_TICKS:
        return ESCAPE, PERSISTENCE, float(ESCAPE_TICKS - lasted), held.memory
    if held.intention == AVOID_FISH and lasted < AVOID_TICKS:
        return AVOID_FISH, PERSISTENCE, float(AVOID_TICKS - lasted), held.memory
    if held.intention == EAT and p.chasing and lasted > CHASE_TICKS:
        return WANDER, PERSISTENCE, float(REST_TICKS), -1
    resting = held.intention == WANDER and held.why == PERSISTENCE and p.hunter
    if resting and lasted < REST_TICKS:
        return WANDER, PERSISTENCE, float(REST_TICKS - lasted), -1
    if held.memory == EAT and p.hunger > WANTING * RELENT and p.food:
        return EAT, _RESUMED, p.hunger, -1
    if held.memory == MATE and p.libido > WANTING * RELENT and p.mate:
        return MATE, _RESUMED, p.libido, -1
    wish, why, value = _want(held, p)
    if wish >= 0:
        return wish, why, value, -1
    wish, why, value = _at_leisure(now, held, p)
    return wish, why, value, -1
