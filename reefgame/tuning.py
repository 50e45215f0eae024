"""`reefgame capture --tune`: finds how species swim, and writes what was found into their files (FINDINGS 1b)."""

import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from platformdirs import user_cache_path

from components.repertoire import Repertoire
from reefgame.console import complain, progress_bar, say
from reefgame.content.anatomy import body_of
from reefgame.content.schema.species import SpeciesFile
from reefgame.content.tuned_values import Values, check_writable, write_values

if TYPE_CHECKING:
    from tools.capture.farm import Farm
    from tools.capture.search import Candidate
    from tools.capture.tune import Subject


class Tuning(NamedTuple):
    """How to tune."""

    seed: int = 0
    jobs: int | None = None
    "processes; as many as there are processors where None"
    scheduler: str | None = None
    "address of a Dask scheduler, whose workers do it instead"


def state_folder() -> Path:
    """Return where unfinished tuning is kept, one file a body and seed."""
    return user_cache_path("reefgame") / "tuning"


def tuned(
    files: Sequence[tuple[Path, SpeciesFile]], tuning: Tuning
) -> Iterator[tuple[Path, Repertoire]]:
    """Tune each species, write what was found into its file, and yield the file with its repertoire.

    A species that cannot be tuned is told in one line and left as it is. Raise InputError where a file cannot be
    written, FarmError or MissingError where the work cannot be done.
    """
    from tools.capture.tune import tune

    for path, _ in files:
        check_writable(path)
    subjects = [_subject(file) for _, file in files]
    with progress_bar("tuning") as report, _farm(tuning, subjects) as farm:
        for outcome in tune(subjects, tuning.seed, farm, state_folder(), report):
            path, file = files[outcome.number]
            if outcome.repertoire is None or outcome.faults:
                complain(
                    f"{path}: not tuned, no usable way to swim was found: {'; '.join(outcome.faults)}"
                )
                continue
            values = _values(outcome.found)
            write_values(path, values)
            say(f"{path}: {_changes(file, values)}")
            say(f"{path}: {outcome.repertoire.provenance['swim_medium']}")
            yield path, outcome.repertoire


def _subject(file: SpeciesFile) -> "Subject":
    from tools.capture.tune import Subject

    return Subject(file.title, body_of(file), file.size_cm / 100.0)


def _farm(tuning: Tuning, subjects: Sequence["Subject"]) -> "Farm":
    from tools.capture.farm import cluster, local
    from tools.capture.tune import most_jobs

    if tuning.scheduler is not None:
        return cluster(tuning.scheduler)
    return local(min(tuning.jobs or os.cpu_count() or 1, most_jobs(len(subjects))))


def _values(found: "Candidate") -> Values:
    swim = found.swim
    return {
        "body": {"stiffness": found.stiffness},
        "swim": {
            "contraction_middle": swim.contraction_middle,
            "contraction_rear": swim.contraction_rear,
            "lag_deg": swim.lag_deg,
            "frequency_hz": swim.frequency_hz,
        },
    }


def _changes(file: SpeciesFile, values: Values) -> str:
    """Return `key old -> new` of each value, `none` where there was no old one."""
    changes = []
    for section, numbers in values.items():
        old = getattr(file, section)
        for key, new in numbers.items():
            before = "none" if old is None else f"{getattr(old, key):g}"
            changes.append(f"{key} {before} -> {new:g}")
    return ", ".join(changes)
