"""What a report is about: a species' body and repertoire."""

import re
from dataclasses import dataclass

from components.body import Body
from components.segment import Pattern, Repertoire, Segment


@dataclass(frozen=True)
class Subject:
    """A species with what was captured of it."""

    name: str
    "of its file, as `blue_tang`"
    title: str
    "as people call it"
    length: float
    "of an adult [m]"
    body: Body
    repertoire: Repertoire

    def segment(self, pattern: Pattern) -> Segment | None:
        """Return the segment of a pattern, or None where the body has none."""
        found = [s for s in self.repertoire.segments if s.pattern == pattern]
        return found[0] if found else None

    def noted(self, pattern: Pattern, what: str) -> float | None:
        """Return the number after the word `what` in a segment's captured figures, None where there is none."""
        text = self.repertoire.provenance.get(pattern.name.lower(), "")
        found = re.search(rf"\b{what} (-?[\d.]+(?:e[-+]?\d+)?)", text)
        return float(found[1]) if found else None

    def warnings(self) -> list[str]:
        """Return what the capture warned of."""
        return [w for w in self.repertoire.provenance.get("warnings", "").split("; ") if w]
