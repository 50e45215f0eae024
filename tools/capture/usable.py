"""Whether a repertoire serves a game: a lifelike cruise, turns that turn, a fast start (FINDINGS 3)."""

from typing import Final

from components.repertoire import Pattern, Repertoire, mean_speed

LEAST_SPEED: Final = 0.4
"""[BL/s] of the cruise."""

_NEEDED: Final = (
    Pattern.SWIM_MEDIUM,
    Pattern.TURN_LEFT,
    Pattern.TURN_SHARP_LEFT,
    Pattern.FAST_START_LEFT,
)


def unusable(repertoire: Repertoire) -> list[str]:
    """Return what keeps a captured repertoire from being usable, one short phrase each; none where it is.

    Its cruise must be faster than LEAST_SPEED and, as its turns and its fast start, be captured without a warning:
    Strouhal number, sweep, wave and closure within limits, angles and joints too. Slow and fast swims may be worse.
    """
    segments = {segment.pattern: segment for segment in repertoire.segments}
    found = [f"{_name(p)}: could not be captured" for p in _NEEDED if p not in segments]
    cruise = segments.get(Pattern.SWIM_MEDIUM)
    if cruise is not None and not mean_speed(cruise) >= LEAST_SPEED:
        found.append(f"{_name(Pattern.SWIM_MEDIUM)}: only {mean_speed(cruise):.2f} BL/s")
    names = {_name(pattern) for pattern in _NEEDED}
    warnings = repertoire.provenance["warnings"].split("; ")
    return found + [one for one in warnings if one.partition(":")[0] in names]


def _name(pattern: Pattern) -> str:
    return pattern.name.lower()
