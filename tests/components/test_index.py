"""The index from ids to rows: a dictionary's answers, in memory that depends on who lives alone."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from components.fish import Population
from components.index import row_of

STEPS = st.lists(st.tuples(st.sampled_from("+-r"), st.integers(0, 40)), max_size=30)


@given(STEPS)
def test_every_id_leads_to_its_row_whatever_comes_and_goes(steps: list[tuple[str, int]]) -> None:
    population, given_ids = Population(), 0
    for what, number in steps:
        if what == "+":
            population.append(np.arange(given_ids, given_ids + number))
            given_ids += number
        elif what == "-" and population.count:
            population.remove(int(population.fish.id[number % population.count]))
        elif what == "r":
            population.reorder(np.arange(population.count)[::-1].copy())
    living = {identity: row for row, identity in enumerate(population.fish.live("id").tolist())}
    places = population.index.places
    for identity in range(-3, given_ids + 3):
        assert row_of(places, identity) == living.get(identity, -1)
        assert (identity in population) == (identity in living)


def test_a_million_births_and_deaths_leave_no_larger_table() -> None:
    population = Population()
    population.append(np.arange(1000))
    size = len(population.index.places.id)
    for first in range(1000, 1_000_000, 1000):
        for identity in population.fish.live("id")[:3].tolist():
            population.remove(identity)
        population.append(np.arange(first, first + 3))
    assert population.count == 1000
    assert len(population.index.places.id) == size
    assert population.fish.capacity == 1000 + 24
