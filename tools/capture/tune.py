"""Automatic tuning: from bodies alone, muscles that swim and the repertoires that they give (FINDINGS 1b).

For each body an optimiser looks for contractions, lag, frequency and stiffness; the best few are captured in full,
and the first whose repertoire is usable is taken; where none is, a second search
weighs turns too. All bodies' jobs share one farm, and every decision depends on
results alone, never on their order or place. What was computed is kept after each generation, so that a run which was
cut short goes on where it was.
"""

import hashlib
import json
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import Any, Final, NamedTuple

from components.body import Body
from components.kernels import sources_hash
from components.repertoire import Repertoire
from components.whole_file import write_whole
from tools.capture.capture import Progress, capture
from tools.capture.evolve import POPULATION, Search, optimiser_version
from tools.capture.farm import Farm
from tools.capture.search import FAILED, Aim, Candidate, aim_of, candidate, costs
from tools.capture.usable import unusable

ATTEMPTS: Final = 2
"""Searches of one body before it is given up."""

SHORTLIST: Final = 4
"""Candidates of a search that are captured in full, until one is usable."""

_SEARCHING: Final = 0.7
"""Part of the work that the first search is."""


class Subject(NamedTuple):
    """A species to be tuned."""

    title: str
    body: Body
    "its stiffness does not matter"
    length: float
    "[m] of an adult"


class Tuned(NamedTuple):
    """What tuning one subject came to."""

    number: int
    "of the subject, from 0"
    found: Candidate
    "the best that was captured"
    repertoire: Repertoire | None
    "None where nothing could be captured"
    faults: tuple[str, ...]
    "why it is not usable, one short phrase each; none where it is"


def tune(
    subjects: Sequence[Subject],
    seed: int,
    farm: Farm,
    folder: Path | None = None,
    progress: Progress | None = None,
) -> Iterator[Tuned]:
    """Yield each subject's outcome as it is ready, the same to the bit for one seed whatever the farm.

    `folder` keeps what was computed; where it cannot be written, nothing is kept. `progress` is told the part of all
    work that is done and what goes on. Raise FarmError, and MissingError where cma is not installed.
    """
    runs = [_Run(number, subject, seed, folder) for number, subject in enumerate(subjects)]
    waiting = iter(runs)
    for run in islice(waiting, farm.width):
        run.begin(farm, max(1, farm.width // len(runs)))
    for name, result in farm.results():
        run = runs[_number(name)]
        outcome = run.take(name, result, farm)
        if progress is not None:
            progress(sum(one.fraction for one in runs) / len(runs), run.doing)
        if outcome is not None:
            yield outcome
            for following in islice(waiting, 1):
                following.begin(farm, max(1, farm.width // len(runs)))


def most_jobs(subjects: int) -> int:
    """Return how many jobs of so many subjects can ever run at once."""
    return POPULATION * subjects


def _number(name: Any) -> int:
    return int(name[0])


class _Run:
    """One subject's way from searches over captures to its outcome."""

    def __init__(self, number: int, subject: Subject, seed: int, folder: Path | None) -> None:
        self.number, self.subject, self.seed = number, subject, seed
        self.aim = aim_of(subject.body, subject.length)
        self.kept = None if folder is None else folder / f"{_key(self.aim, seed)}.json"
        self.attempt = 0
        self.tried = 0
        self.search = Search(seed)
        self.best: Tuned | None = None
        self.parts: dict[int, list[float]] = {}
        self.chunks = 1
        self.told: list[list[list[float]]] = []

    def begin(self, farm: Farm, chunks: int) -> None:
        """Hand in the first jobs; a generation is cut into so many `chunks`."""
        self.chunks = min(chunks, POPULATION)
        self.told = _read(self.kept)
        self._resume()
        self._go_on(farm)

    def _resume(self) -> None:
        """Tell the present search what is known of it."""
        for generation in self.told[self.attempt] if self.attempt < len(self.told) else []:
            if not self.search.done:
                self.search.tell(generation)

    def _go_on(self, farm: Farm) -> None:
        """Hand in what comes next: a generation, or the capture of a candidate."""
        if self.search.done:
            found = candidate(self.aim, self.search.shortlist(SHORTLIST)[self.tried])
            farm.submit((self.number, "capture"), captured, self.aim, found)
            return
        places, step = self.search.places, -(-POPULATION // self.chunks)
        for first in range(0, POPULATION, step):
            name = (self.number, "costs", first)
            farm.submit(name, costs, self.aim, places[first : first + step])

    def take(self, name: Any, result: Any, farm: Farm) -> Tuned | None:
        """Take a job's result and hand in the next; return the outcome where that was the last."""
        if name[1] == "costs":
            self._take_costs(name[2], result, farm)
            return None
        outcome = Tuned(self.number, *result)
        if self.best is None or _rank(outcome) < _rank(self.best):
            self.best = outcome
        self.tried += 1
        if not outcome.faults or not self._another():
            return self.best
        self._go_on(farm)
        return None

    def _take_costs(self, first: int, result: list[float], farm: Farm) -> None:
        self.parts[first] = result
        if sum(map(len, self.parts.values())) < POPULATION:
            return
        self.search.tell([cost for _, part in sorted(self.parts.items()) for cost in part])
        self.parts = {}
        self.told[self.attempt :] = [self.search.history]
        _write(self.kept, self.told)
        self._go_on(farm)

    def _another(self) -> bool:
        """Turn to the next candidate, or to another search; return whether there is any."""
        if self.tried < len(self.search.shortlist(SHORTLIST)):
            return True
        self.attempt, self.tried = self.attempt + 1, 0
        if self.attempt == ATTEMPTS:
            return False
        self.search = Search(self.seed, self.attempt)
        self.aim = replace(self.aim, turning=True)
        self._resume()
        return True

    @property
    def fraction(self) -> float:
        """How much of the first search and capture is behind it."""
        if self.best is not None:
            return 1.0
        return _SEARCHING * self.search.fraction

    @property
    def doing(self) -> str:
        """What goes on, in words."""
        title = self.subject.title
        if self.search.done:
            return f"{title}: capture"
        return f"{title}: generation {len(self.search.history)}, cost {self.search.cost:.3f}"


def _rank(outcome: Tuned) -> tuple[bool, int]:
    return outcome.repertoire is None, len(outcome.faults)


def captured(aim: Aim, found: Candidate) -> tuple[Candidate, Repertoire | None, tuple[str, ...]]:
    """Return a candidate with its repertoire, and why that is not usable."""
    try:
        repertoire = capture(replace(aim.body, stiffness=found.stiffness), found.swim)
    except (ValueError, ArithmeticError) as error:
        return found, None, (str(error),)
    return found, repertoire, tuple(unusable(repertoire))


def _key(aim: Aim, seed: int) -> str:
    """Return 32 hex digits that change with what a search's costs follow from: body, aim, seed, code, optimiser."""
    body = replace(aim.body, stiffness=1.0)
    named = (body, aim.speed, seed, sources_hash(Path(__file__)), optimiser_version())
    return hashlib.blake2b(repr(named).encode(), digest_size=16).hexdigest()


def _read(path: Path | None) -> list[list[list[float]]]:
    """Return the costs told to each attempt so far; what is damaged counts for nothing."""
    if path is None:
        return []
    try:
        told = json.loads(path.read_text(encoding="ascii"))["costs"]
        sound = all(_is_generation(costs) for attempt in told for costs in attempt)
    except (OSError, ValueError, TypeError, KeyError, RecursionError):
        return []
    return told if sound and len(told) <= ATTEMPTS else []


def _is_generation(costs: Any) -> bool:
    return len(costs) == POPULATION and all(
        type(cost) is float and 0.0 <= cost <= FAILED for cost in costs
    )


def _write(path: Path | None, told: list[list[list[float]]]) -> None:
    """Keep the costs; a folder that cannot be written costs only the chance to go on."""
    if path is None:
        return
    with suppress(OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        write_whole(path, json.dumps({"costs": told}).encode())
