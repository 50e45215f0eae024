"""What is wrong with content: problems with their places, collected so that one run names them all (DESIGN 6)."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from difflib import get_close_matches

from components.fault import FaultError


@dataclass(frozen=True, order=True)
class Problem:
    """One fault of one file; line and column count from 1, line 0 where no line is meant."""

    file: str
    line: int
    column: int
    message: str

    def __str__(self) -> str:
        """Return `file:line:column: message`, or `file: message` where there is no line."""
        place = f"{self.file}:{self.line}:{self.column}" if self.line else self.file
        return f"{printable(place)}: {self.message}"


class ContentError(FaultError):
    """Content is at fault: holds every problem found, its text is one line each."""

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems: tuple[Problem, ...] = tuple(sorted(set(problems)))
        super().__init__("\n".join(str(problem) for problem in self.problems))


def printable(text: str, longest: int = 400) -> str:
    """Return text fit for one line of a terminal: control characters escaped, cut to `longest`."""
    shown = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text[:longest])
    return shown if len(text) <= longest else shown + "..."


def quoted(value: object) -> str:
    """Return a value as messages show it: in quotes, on one line, not longer than 40 characters."""
    return f"'{printable(str(value), 40)}'"


def listed(names: Iterable[str]) -> str:
    """Return the names as a sentence lists them: `a, b or c`."""
    words = list(names)
    return " or ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def nearest(name: str, known: Sequence[str]) -> str | None:
    """Return the known name that `name` was most likely meant to be, or None."""
    found = get_close_matches(name.lower(), known, n=1, cutoff=0.6)
    return found[0] if found else None


def did_you_mean(name: str, known: Sequence[str]) -> str:
    """Return `; did you mean 'x'?`, or nothing where no known name is near."""
    found = nearest(name, known)
    return f"; did you mean '{found}'?" if found else ""
