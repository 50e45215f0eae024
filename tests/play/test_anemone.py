"""Anemones at play: they sting strangers, shelter clownfish, hold and eat small fishes (papers/002, section 1)."""

from collections.abc import Callable, Sequence

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.anemone import AnemoneTable, Cap, anemone_table
from components.arrays import Float64s
from components.mind import Intention, Why
from reefgame.explain import explain
from reefgame.world import World
from systems.play.hold import DIGEST_TICKS, HOLD_TICKS, Hold
from systems.play.sting import STUNG_TICKS, Sting

Garden = Callable[..., World]
MIDDLE = np.array([0.0, 0.0, -9.0])
CAP = Cap((0.0, 0.0, -9.0), 0.8, stings=True, holds=0.15)
CLOWNS = "{species: clownfish, count: 3, around_m: [0, 0, -8.5], within_m: 1, restock_s: null}"
HUNTER = "{species: barracuda, count: 1, around_m: [5, 0, -8], within_m: 1, restock_s: null}"
SMALL = "{species: anthias, count: 4, around_m: [6, 3, -6], within_m: 1, restock_s: 5}"
ALL = f"{CLOWNS}, {HUNTER}, {SMALL}"


def by(x: float, y: float, z: float) -> Float64s:
    """Return a place [m] beside the anemone's middle."""
    return np.asarray(MIDDLE + np.array([x, y, z]))


def of(world: World, species: str) -> list[int]:
    """Return the ids of a species, rising."""
    kind = [one.name for one in world.species].index(species)
    fish = world.population.fish
    return sorted(fish.id[: fish.count][fish.species[: fish.count] == kind].tolist())


def put(world: World, identity: int, at: Float64s) -> int:
    """Let a fish be somewhere; return its row."""
    fish, row = world.population.fish, world.population.row(identity)
    fish.position[row] = fish.last_position[row] = at
    return row


def run(world: World, kind: type, times: int = 1) -> None:
    """Let one system alone work for some ticks."""
    system = next(one for one in world.systems if isinstance(one, kind))
    for _ in range(times):
        system()
        world.clock.tick[0] += 1


def test_a_hunter_among_tentacles_is_stung_drops_its_prey_and_flees(garden: Garden) -> None:
    world = garden(ALL)
    mind, motor = world.population.mind, world.population.motor
    row = put(world, of(world, "barracuda")[0], by(0.7, 0.0, 0.2))
    mind.intention[row], mind.focus[row], mind.gape[row] = (
        Intention.EAT,
        of(world, "clownfish")[0],
        1.0,
    )
    run(world, Sting)
    assert mind.stung_until[row] == STUNG_TICKS
    assert (mind.intention[row], mind.focus[row], mind.gape[row]) == (Intention.ESCAPE, -1, 0.0)
    assert (mind.fear[row], motor.gear[row]) == (1.0, 2)
    out = np.array([0.7, 0.0, 0.2]) / np.linalg.norm([0.7, 0.0, 0.2])
    np.testing.assert_allclose(motor.heading[row], out, atol=1e-9)
    assert "stung" in explain(world, row).reason


def test_the_nose_is_stung_before_the_body_is_there(garden: Garden) -> None:
    world = garden(HUNTER)
    fish = world.population.fish
    identity = of(world, "barracuda")[0]
    row = world.population.row(identity)
    ahead = float(world.senses.nose[0] * fish.length[row])
    fish.rotation[row] = [[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]
    for gap, stung in ((0.05, False), (-0.05, True)):
        put(world, identity, by(0.8 + ahead + gap, 0.0, 0.0))
        run(world, Sting)
        assert (world.population.mind.stung_until[row] > 0) == stung


def test_the_sting_is_felt_for_a_while_and_then_forgotten(garden: Garden) -> None:
    world = garden(HUNTER)
    mind, identity = world.population.mind, of(world, "barracuda")[0]
    row = put(world, identity, MIDDLE)
    run(world, Sting)
    put(world, identity, by(4.0, 0.0, 2.0))
    for tick in range(1, STUNG_TICKS + 10):
        mind.intention[row], mind.why[row] = Intention.WANDER, Why.CONTENT
        run(world, Sting)
        assert (mind.intention[row] == Intention.ESCAPE) == (tick < STUNG_TICKS)


@pytest.mark.parametrize("who", ["at home", "no sting", "outside", "the player's"])
def test_who_is_at_home_or_not_touched_is_not_moved(garden: Garden, who: str) -> None:
    cap = CAP._replace(stings=who != "no sting")
    world = garden(ALL, [cap])
    mind, motor = world.population.mind, world.population.motor
    species = "clownfish" if who == "at home" else "barracuda"
    place = by(0.0, 6.0, 3.0) if who == "outside" else by(0.1, 0.0, 0.1)
    row = put(world, of(world, species)[0], place)
    if who == "the player's":
        mind.intention[row] = Intention.OBEY
    before, heading = int(mind.intention[row]), motor.heading[row].copy()
    run(world, Sting)
    assert mind.intention[row] == before
    assert np.array_equal(motor.heading[row], heading)
    assert (mind.fear[row] == 1.0) == (who == "the player's")


def test_who_is_after_nobody_keeps_clear_and_who_hunts_does_not(garden: Garden) -> None:
    world = garden(HUNTER)
    mind, motor = world.population.mind, world.population.motor
    row = put(world, of(world, "barracuda")[0], by(1.7, 0.3, 0.0))
    for intention, focus, turns in (
        (Intention.WANDER, -1, True), (Intention.EAT, -1, True), (Intention.EAT, 7, False),
    ):  # fmt: skip
        world.population.fish.rotation[row] = np.eye(3)
        mind.intention[row], mind.focus[row] = intention, focus
        motor.heading[row] = (-1.0, 0.0, 0.0)
        run(world, Sting)
        assert (motor.heading[row, 1] != 0.0) == turns


def test_a_small_fish_that_touches_is_held_drawn_in_and_eaten_and_replaced(garden: Garden) -> None:
    world = garden(ALL)
    fish, anemones = world.population.fish, world.anemones
    victim, count = of(world, "anthias")[0], world.population.count
    put(world, victim, by(0.6, 0.0, 0.3))
    run(world, Hold)
    assert (anemones.prey[0], anemones.since[0]) == (victim, 0)
    gaps = []
    for _ in range(HOLD_TICKS):
        gaps.append(float(np.linalg.norm(fish.position[world.population.row(victim)] - MIDDLE)))
        run(world, Hold)
        if victim not in world.population:
            break
    assert world.clock.now == HOLD_TICKS + 1
    assert gaps[-1] < 0.1 < gaps[0]
    assert world.population.count == count - 1
    assert world.restocks.count == 1
    assert anemones.prey[0] == -1
    other = of(world, "anthias")[0]
    put(world, other, MIDDLE)
    run(world, Hold, 5)
    assert anemones.prey[0] == -1
    world.clock.tick[0] += DIGEST_TICKS
    run(world, Hold)
    assert anemones.prey[0] == other


@pytest.mark.parametrize("who", ["too large", "at home", "another's", "outside"])
def test_who_is_not_to_be_held_is_not(garden: Garden, who: str) -> None:
    world = garden(ALL)
    species = {"too large": "barracuda", "at home": "clownfish"}.get(who, "anthias")
    row = put(world, of(world, species)[0], by(0.9 if who == "outside" else 0.1, 0.0, 0.0))
    if who == "another's":
        world.population.mind.swallowed_by[row] = of(world, "barracuda")[0]
    run(world, Hold, 2)
    assert world.anemones.prey[0] == -1


def test_of_two_that_touch_the_lowest_id_is_held_and_by_one_anemone_alone(garden: Garden) -> None:
    world = garden(ALL, [CAP, CAP._replace(centre=(0.3, 0.0, -9.0))])
    first, second = of(world, "anthias")[:2]
    for identity in (first, second):
        put(world, identity, by(0.15, 0.0, 0.1))
    world.population.reorder(np.arange(world.population.count)[::-1].copy())
    run(world, Hold, 3)
    assert sorted(world.anemones.prey[:2].tolist()) == [first, second]
    world.spawn.remove(first)
    world.spawn.remove(second)
    run(world, Hold)
    assert world.anemones.prey[:2].tolist() == [-1, -1]


def test_anemones_are_homes_for_who_shelters_in_them_alone(garden: Garden) -> None:
    world = garden(ALL)
    names = [world.species[kind].name for kind in world.terrain.home_species]
    assert names == ["clownfish"]
    np.testing.assert_allclose(world.terrain.home[0, :3], MIDDLE)
    assert "anemones" in world.tables
    assert "anemones" not in garden(ALL, []).tables


def test_a_world_saved_with_a_held_fish_goes_on_with_the_same_bits(garden: Garden) -> None:
    world, other = garden(ALL), garden(ALL, seed=9)
    put(world, of(world, "anthias")[0], MIDDLE)
    for _ in range(30):
        world.tick()
    assert world.anemones.prey[0] >= 0
    other.restore(world.snapshot())
    for one in (world, other):
        for _ in range(HOLD_TICKS):
            one.tick()
    assert other.checksums() == world.checksums()
    assert world.anemones.sated_until[0] > 0


@given(
    st.lists(st.tuples(*[st.floats(-3.0, 3.0)] * 3), min_size=1, max_size=8), st.floats(0.05, 3.0)
)
@settings(max_examples=15)
def test_stings_follow_the_caps_wherever_they_stand(
    garden: Garden, centres: list[tuple[float, float, float]], radius: float
) -> None:
    world = garden(ALL, [Cap((x, y, -6.0 + z), radius) for x, y, z in centres])
    fish = world.population.fish
    nose = (
        fish.position
        + (world.senses.nose[fish.species] * fish.length)[:, None] * fish.rotation[:, :, 0]
    )
    run(world, Sting)
    for row in range(fish.count):
        gaps = [
            np.linalg.norm(at[row] - world.anemones.centre[: len(centres)], axis=1).min()
            for at in (fish.position, nose)
        ]
        if abs(min(gaps) - radius) > 1e-9:
            stranger = world.species[fish.species[row]].name != "clownfish"
            stung = world.population.mind.stung_until[row] > 0
            assert stung == (stranger and min(gaps) < radius)
        assert np.linalg.norm(world.population.motor.heading[row]) == pytest.approx(1.0)


def test_a_table_of_anemones_holds_what_the_caps_say() -> None:
    caps: Sequence[Cap] = [CAP, Cap((1.0, 2.0, -3.0), 0.5, stings=False)]
    table: AnemoneTable = anemone_table(caps)
    assert table.centre[:2].tolist() == [[0.0, 0.0, -9.0], [1.0, 2.0, -3.0]]
    assert table.stings[:2].tolist() == [1, 0]
    assert table.holds[:2].tolist() == [0.15, 0.0]
    assert table.prey[:2].tolist() == [-1, -1]
