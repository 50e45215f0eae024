"""The search for a way to swim: generations of candidates by CMA-ES, the kept optimiser (FINDINGS 1b, "Tuning").

A search is its seed and the costs told so far: told them again it stands where it stood, so it is kept as a few
hundred numbers, and whoever computes the costs, in whatever order, comes to the same bits.
"""

import warnings
from collections.abc import Sequence
from typing import Any, Final

import numpy as np

from components.fault import FaultError
from tools.capture.search import FAILED, START

POPULATION: Final = 10
GENERATIONS: Final = 20
"""At most."""

_STEP: Final = 0.2
"""Standard deviation of the first generation, in the unit cube."""

_PATIENCE: Final = 6
"""Generations without a gain of _GAIN after which a search ends ..."""

_GAIN: Final = 0.002
_GOOD: Final = 0.05
"""... where its best costs no more than this."""


_HOPE: Final = 5
"""Generations of which one must swim at all."""

_APART: Final = 0.08
"""How far apart candidates of a shortlist lie, in the unit cube."""

_DEAR: Final = 1.0
"""Cost beyond which a candidate is on no shortlist but as its first."""


class MissingError(FaultError):
    """A package that tuning needs is not installed. One line."""


def _optimiser() -> Any:
    """Return the module cma. Raise MissingError."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # it warns that it cannot plot, which nobody asks for
            import cma
    except ImportError:
        raise MissingError("--tune needs cma: pip install 'reefgame[capture]'") from None
    return cma


def optimiser_version() -> str:
    """Return which cma this is. Raise MissingError."""
    return str(_optimiser().__version__)


class Search:
    """One search, a generation at a time: compute the costs of `places`, then `tell` them."""

    def __init__(self, seed: int, attempt: int = 0) -> None:
        """Begin; `attempt` starts another search of the same seed. Raise MissingError."""
        draws = np.random.Generator(np.random.PCG64([seed, attempt]))
        options = {
            "bounds": [0.0, 1.0],
            "popsize": POPULATION,
            "seed": np.nan,  # numpy's own state is nobody's to touch: ours are drawn below
            "randn": lambda rows, columns: draws.standard_normal((rows, columns)),
            "verbose": -9,
        }
        self._strategy = _optimiser().CMAEvolutionStrategy(list(START), _STEP, options)
        self.history: list[list[float]] = []
        "the costs of each generation told"
        self._bests: list[float] = []
        self._tried: list[tuple[float, tuple[float, ...]]] = []
        self._ask()

    def _ask(self) -> None:
        self._asked = self._strategy.ask()
        self.places = [tuple(float(u) for u in place) for place in self._asked]
        "what is to be tried next"

    def tell(self, costs: Sequence[float]) -> None:
        """Take the cost of each of `places`, and choose the next ones."""
        if len(costs) != len(self.places):
            raise ValueError(f"{len(costs)} costs of {len(self.places)} places")
        self._bests.append(min([*costs, *self._bests[-1:]]))
        self._tried += zip(costs, self.places, strict=True)
        self.history.append(list(costs))
        self._strategy.tell(self._asked, list(costs))
        self._ask()

    def shortlist(self, most: int) -> list[tuple[float, ...]]:
        """Return the places that cost least, cheapest first, no two of them close together."""
        chosen: list[tuple[float, ...]] = []
        for cost, place in sorted(self._tried):
            far = all(
                max(abs(a - b) for a, b in zip(p, place, strict=True)) > _APART for p in chosen
            )
            if not chosen or (far and cost < _DEAR):
                chosen.append(place)
        return chosen[:most]

    @property
    def cost(self) -> float:
        """The least cost so far, infinite before the first generation."""
        return self._bests[-1] if self._bests else float("inf")

    @property
    def done(self) -> bool:
        """Whether another generation is not worth its time."""
        if len(self._bests) >= GENERATIONS:
            return True
        if len(self._bests) >= _HOPE and self.cost >= FAILED:
            return True
        if len(self._bests) <= _PATIENCE or self.cost > _GOOD:
            return False
        return self._bests[-1 - _PATIENCE] - self.cost < _GAIN

    @property
    def fraction(self) -> float:
        """How much of the most that a search may take is behind it."""
        return 1.0 if self.done else len(self._bests) / GENERATIONS
