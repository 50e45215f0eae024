"""Which segments a film gives: as cruise the steadiest of the usual bouts, much slower and faster ones, and turns."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple

from components.body import Body
from components.repertoire import Pattern, Segment
from tools.video.water.beats import STEADY, Bout
from tools.video.water.current import in_water
from tools.video.water.cycle import Cycle, cycle
from tools.video.water.film import Film
from tools.video.water.lattice import figures_of, loop_of
from tools.video.water.turns import turns_of, turns_within

SLOWER: Final = 0.75
FASTER: Final = 1.3
"""Beats a second over the cruise's from which a bout is another gear."""


@dataclass(frozen=True)
class Cut:
    """A segment that was cut out of a film."""

    segment: Segment
    figures: str
    "as one line for the provenance"
    first: int
    "frame of the film"
    stop: int
    "the frame after its last"
    faults: tuple[str, ...] = ()
    "what is unlike a living fish, a phrase each"


class Gaits(NamedTuple):
    """What a film gives."""

    cuts: list[Cut]
    cruise: Cycle
    refused: dict[int, str]
    "why turns that it shows were not taken, by the frame that they begin with"


def usual_bout(found: Sequence[Bout]) -> Bout:
    """Return the first of bouts, steadiest first, whose frequency is about the median of the steady ones."""
    steady = sorted(bout.frequency for bout in found if bout.steadiness >= STEADY)
    middle = steady[len(steady) // 2]
    return next(
        bout
        for bout in found
        if bout.steadiness >= STEADY and SLOWER * middle <= bout.frequency <= FASTER * middle
    )


def gaits_of(film: Film, found: Sequence[Bout], body: Body) -> Gaits:
    """Return the swims that bouts, steadiest first, give, and the turns between them."""
    usual = usual_bout(found)
    cruise = cycle(film, usual)
    cuts = [_cut(cruise, usual, body, Pattern.SWIM_MEDIUM)]
    # A turn bends a fish as one slow beat would.
    straight = [bout for bout in found if not turns_within(film, cruise.frequency, bout)]
    for pattern, lowest, highest in (
        (Pattern.SWIM_SLOW, 0.0, SLOWER * cruise.frequency),
        (Pattern.SWIM_FAST, FASTER * cruise.frequency, float("inf")),
    ):
        for bout in straight:
            if lowest < bout.frequency < highest and bout.steadiness >= STEADY:
                other = cycle(film, bout)
                if (other.speed < cruise.speed) == (pattern is Pattern.SWIM_SLOW):
                    cuts.append(_cut(other, bout, body, pattern))
                    break
    through = in_water(film, cruise, usual) if cruise.assumed else film
    turns = turns_of(through, cruise.frequency, body, cuts[0].segment)
    cuts += [Cut(segment, figures, at.first, at.stop) for segment, figures, at in turns.taken]
    return Gaits(cuts, cruise, turns.refused)


def _cut(swum: Cycle, bout: Bout, body: Body, pattern: Pattern) -> Cut:
    figures = figures_of(swum, body)
    text = f"{figures.text()}, wavelength {swum.wavelength():.2f} BL"
    faults = tuple(figures.faults())
    return Cut(loop_of(swum, body, pattern), text, bout.first, bout.stop, faults)
