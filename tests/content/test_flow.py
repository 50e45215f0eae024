"""The key `flow` of levels and `stirs` of species: what they may say, and each fault at its place."""

from collections.abc import Callable
from pathlib import Path

import pytest

from components.singularity import SingularityKind
from components.species import Stirs
from reefgame.content import load, load_species

Write = Callable[[str, str | bytes], Path]
Lines = Callable[[Callable[[], object]], list[str]]
LEVEL = """title: Pool
world: {radius_m: 20, depth_m: 12}
rocks: [{at_m: [6, 0], radii_m: [2, 1.5, 2.5]}]
submarine: {at_m: [-15, 0, -5]}
fishes: [{species: sardine, count: 1, around_m: [0, 0, -6], within_m: 1}]
objective: {photograph: {species: sardine, count: 1, within_m: 6}}
flow:
"""
TRACK = "{kind: source, speed_m_per_s: 1, track: {frames: [%s]}}"


@pytest.mark.parametrize(
    ("flow", "message"),
    [
        (TRACK % "{at_s: 2, at_m: [0, 0, -5]}, {at_s: 1, at_m: [0, 0, -5]}",
         "8:54: key frames must come in the order of time: frames[1] at 1 s follows 2 s"),
        (TRACK % "{at_s: 2, at_m: [0, 25, -5]}",
         "8:71: this lies outside of the world: 25.0 m from the middle, at most 20 m"),
        (TRACK % "{at_s: 2, at_m: [0, 2, 5]}",
         "8:71: this lies out of the water: z is 5, must be from -12 to 0"),
        (TRACK % "{at_s: 40000, at_m: [0, 2, -5]}", "'40000' is out of range: must be at most 36000"),
        (TRACK % "{at_s: 1, at_m: [0, 2, -5]}, {at_s: 2}",
         "all frames of a track have an `at_m`, or none has"),
        (TRACK % "{at_s: 1}", "where is it? say `at_m`, or `attached`, or a `track`"),
        ("{kind: source, speed_m_per_s: 1000000, at_m: [0, 0, -5]}",
         "8:35: '1000000' is out of range: must be at most 20"),
        ("{kind: source, speed_m_per_s: 1, at_m: [0, 0, -5], core_m: 0}",
         "8:64: '0' is out of range: must be at least 0.05"),
        ("{kind: hole, speed_m_per_s: 1, at_m: [0, 0, -5], reach_m: 0}",
         "8:63: '0' is out of range: must be at least 0.1"),
        ("{kind: swirl, speed_m_per_s: 1, at_m: [0, 0, -5]}", "'swirl' is not known: must be"),
        ("{speed_m_per_s: 1, at_m: [0, 0, -5]}", "key 'kind' is missing: it says which kind this is"),
        ("{kind: current, speed_m_per_s: 1}", "8:5: key 'axis' is missing"),
        ("{kind: current, speed_m_per_s: 1, axis: [0, 0, 0]}", "8:45: an axis needs a direction"),
        ("{kind: current, speed: 1, axis: [0, 0, 1]}", "8:21: unknown key 'speed'"),
        ("{kind: current, speed_m_per_s: 1, axis: [0, 0, 1], reach_m: 2}", "8:5: where is it?"),
        ("{kind: source, speed_m_per_s: 1, at_m: [0, 0, -5], attached: {submarine: true}}",
         "its place is said twice"),
        ("{kind: source, speed_m_per_s: 1, attached: {rock: 1}}",
         "8:55: there is no rock 1: the last is 0, counted from 0"),
        ("{kind: source, speed_m_per_s: 1, attached: {species: barracuda}}",
         "8:58: no group of `fishes` is of the species 'barracuda'"),
        ("{kind: source, speed_m_per_s: 1, attached: {species: baracuda}}",
         "8:58: there is no species 'baracuda'; did you mean 'barracuda'?"),
        ("{kind: source, speed_m_per_s: 1, attached: {species: sardine, rock: 0}}",
         "say one of `submarine: true`, `species: NAME` and `rock: NUMBER`"),
        ("{kind: current, speed_m_per_s: 1, axis: [1, 0, 0], wave: {length_m: 0}}",
         "'0' is out of range: must be at least 0.5"),
    ],
)  # fmt: skip
def test_a_fault_in_the_flow_is_one_line_at_its_place(
    write: Write, lines: Lines, flow: str, message: str
) -> None:
    write("pool.yaml", f"{LEVEL}  - {flow}\n")
    found = lines(lambda: load(Path("pool.yaml")))
    assert all(line.startswith("pool.yaml:8:") for line in found)
    assert any(message in line for line in found)


@pytest.mark.parametrize(
    ("number", "message"),
    [
        (300, "8:3: the list is too long: 300 values, at most 200"),
        (10_000, "the file holds too much: at most 50000 values are allowed"),
    ],
)
def test_singularities_without_number_are_too_many(
    write: Write, lines: Lines, number: int, message: str
) -> None:
    one = "  - {kind: current, speed_m_per_s: 1, axis: [1, 0, 0]}\n"
    write("pool.yaml", LEVEL + number * one)
    (line,) = lines(lambda: load(Path("pool.yaml")))
    assert message in line


def test_a_flow_changes_what_a_dive_depends_on_and_its_absence_does_not(write: Write) -> None:
    flow = "  - {kind: current, speed_m_per_s: %s, axis: [1, 0, 0]}\n"
    hashes = []
    for text in (
        LEVEL + flow % 1,
        LEVEL + flow % 2,
        LEVEL.replace("flow:\n", ""),
        LEVEL.replace("flow:", "flow: []"),
    ):
        write("pool.yaml", text)
        hashes.append(load(Path("pool.yaml")).hash)
    assert len(set(hashes)) == 3
    assert hashes[2] == hashes[3]


def test_what_a_fish_is_to_plants_is_one_short_key(write: Write) -> None:
    assert load_species("clownfish").stirs.kind == SingularityKind.SOURCE
    assert load_species("sardine").stirs == Stirs(SingularityKind.HOLE)
    path = write("ghost.yaml", "like: sardine\ntitle: Ghost\nstirs: {kind: none}\n")
    assert load_species(path).stirs.reach == 0.0
