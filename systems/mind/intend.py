"""The intention generator: which behaviour routine a fish runs now (papers/000 section 6; FINDINGS 2).

In order: collision danger with what stands still, then with who moves; else a schooler that sees its kind schools;
else wander. Dangers are taken up at once; what they interrupt comes back only when they have passed for a while, so
that a fish at a border of two intentions does not flicker.
"""

from typing import Final

from components.kernels import row
from components.mind import Intention

WANDER: Final = int(Intention.WANDER)
AVOID_OBSTACLE: Final = int(Intention.AVOID_OBSTACLE)
AVOID_FISH: Final = int(Intention.AVOID_FISH)
SCHOOL: Final = int(Intention.SCHOOL)

WATCHFUL: Final = 1.4
"""A fish that avoids an obstacle goes on until it is this much farther than where it began."""

AVOID_TICKS: Final = 20
"""[ticks] that a fish goes on avoiding another after the danger has passed."""

CALM_TICKS: Final = 40
"""[ticks] between schooling and wandering, either way."""


@row
def intend(
    now: int, previous: int, since: int, obstacle: float, threat: bool, company: bool
) -> int:
    """Return the intention of the tick `now`, after `previous`, begun in the tick `since`.

    `obstacle` is the distance to the nearest obstacle over the distance that alarms; `company` says
    whether a schooler sees its kind.
    """
    alarm = WATCHFUL if previous == AVOID_OBSTACLE else 1.0
    if obstacle < alarm:
        return AVOID_OBSTACLE
    if threat:
        return AVOID_FISH
    held = now - since
    if previous == AVOID_FISH and held < AVOID_TICKS:
        return AVOID_FISH
    wanted = SCHOOL if company else WANDER
    calm = previous in (WANDER, SCHOOL)
    if calm and wanted != previous and held < CALM_TICKS:
        return previous
    return wanted
