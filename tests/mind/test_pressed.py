"""Two thousand fishes and twenty hunters: who is herded keeps room for its body, and schools stay schools."""

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from components.clock import TICKS_PER_SECOND
from reefgame.bench.minds import reef


def test_schools_that_are_hunted_for_two_minutes_are_neither_pressed_nor_one() -> None:
    world = reef(2000)
    sardine = [species.name for species in world.species].index("sardine")
    pressed, largest = [], []
    for second in range(120):
        for _ in range(TICKS_PER_SECOND):
            world.tick()
        if second < 90 or second % 5 != 4:
            continue
        fish, many = world.population.fish, world.population.count
        ours = fish.species[:many] == sardine
        place, length = fish.position[:many][ours], fish.length[:many][ours]
        tree = cKDTree(place)
        pressed.append(float((tree.query(place, 2)[0][:, 1] < 0.3 * length).mean()))
        largest.append(_largest(tree, 2.5 * float(length.mean())))
    assert np.median(pressed) < 0.02
    assert np.median(largest) < 0.6


def _largest(tree: cKDTree, within: float) -> float:
    """Return the share of places in the largest group whose members are within so many metres of another."""
    pairs = tree.query_pairs(within, output_type="ndarray")
    linked = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(tree.n, tree.n))
    return float(np.bincount(connected_components(linked)[1]).max() / tree.n)
