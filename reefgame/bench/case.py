"""One measured figure, and how two sides are timed in turn so that a drifting machine cannot favour one."""

from collections.abc import Callable
from dataclasses import asdict, dataclass
from statistics import median
from time import perf_counter


@dataclass(frozen=True)
class Case:
    """A figure and, where there is one, what it is measured against."""

    case: str
    "parameters, `fishes=1000 part=replay`"
    value: float
    unit: str
    baseline: float | None = None
    "the other side's figure, in the same unit"
    ratio: float | None = None
    "how many times better the value is than the baseline"
    bound: str = ""
    "the figure to hold, as its issue says"

    def record(self) -> dict[str, object]:
        """Return the case as `reefgame bench --json` writes it."""
        return {key: value for key, value in asdict(self).items() if key != "bound"}


def in_turn(
    sides: tuple[Callable[[], None], ...], rounds: int = 7, least: float = 0.0
) -> tuple[float, ...]:
    """Return the median seconds of each side over `rounds`, the sides run in turn as `seconds_in_turn` does."""
    return tuple(median(found) for found in seconds_in_turn(sides, rounds, least))


def seconds_in_turn(
    sides: tuple[Callable[[], None], ...], rounds: int = 7, least: float = 0.0
) -> list[list[float]]:
    """Return the seconds of each side in each of `rounds`, the sides run in turn after one warm-up.

    In its turn a side runs again and again for `least` seconds, lest a short one find caches as the other left them.
    """
    times: list[list[float]] = [[] for _ in sides]
    for side in sides:
        side()
    for _ in range(rounds):
        for side, found in zip(sides, times, strict=True):
            start, runs = perf_counter(), 0
            while runs == 0 or perf_counter() - start < least:
                side()
                runs += 1
            found.append((perf_counter() - start) / runs)
    return times


def times_faster(ours: list[float], theirs: list[float]) -> float:
    """Return how many times faster we are, the median over the rounds: a slow spell of the machine takes both sides."""
    return median(their / our for our, their in zip(ours, theirs, strict=True))
