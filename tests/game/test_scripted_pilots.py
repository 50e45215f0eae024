"""Scripted pilots win what can be won, from any seed."""

from typing import Any

import pytest

from reefgame.autopilot import Photographer, idle
from reefgame.testing import play

SEEDS: list[Any] = [1, 2, 3]
MORE_SEEDS = [pytest.param(seed, marks=pytest.mark.prove) for seed in range(4, 21)]


@pytest.mark.parametrize("seed", SEEDS + MORE_SEEDS)
def test_first_dive_can_be_won_from_any_seed(seed: int) -> None:
    dive = play("first_dive", Photographer(), seconds=120, seed=seed)
    assert dive.won
    assert dive.world.objective.score[0] > 0


@pytest.mark.parametrize("seed", SEEDS)
def test_nobody_wins_by_doing_nothing(seed: int) -> None:
    dive = play("first_dive", idle, seconds=20, seed=seed)
    assert not dive.won
    assert dive.ticks == 1200
    assert dive.world.objective.shots[0] == 0
