"""Files that cannot be read, and values that a schema refuses: each one line at its exact place."""

from collections.abc import Callable
from pathlib import Path

import pytest

from reefgame.content import load

Write = Callable[[str, str | bytes], Path]
Edit = Callable[[str, str, str], str]
Lines = Callable[[Callable[[], object]], list[str]]
Checked = Callable[..., list[str]]


def place(text: str, where: str) -> str:
    """Return line:column of the one `where` in the text."""
    assert text.count(where) == 1
    before = text[: text.index(where)]
    return f"{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}"


def test_a_missing_file_is_named(folder: Path, lines: Lines, checked: Checked) -> None:
    assert lines(lambda: load(Path("gone.yaml"))) == ["gone.yaml:1:1: there is no such file"]
    assert checked(folder / "gone.yaml") == ["gone.yaml:1:1: there is no such file"]


def test_a_folder_is_no_level(folder: Path, lines: Lines) -> None:
    (folder / "reef.yaml").mkdir()
    assert lines(lambda: load("reef.yaml")) == ["reef.yaml:1:1: this is not a file"]


def test_a_file_of_three_megabytes_is_not_read(write: Write, checked: Checked) -> None:
    path = write("big.yaml", b"a: " + b"x" * 3_000_000)
    message = "big.yaml:1:1: the file is too large: 3000003 bytes, at most 1000000"
    assert checked(path) == [message]


def test_an_empty_folder_is_said_to_be_empty(folder: Path, checked: Checked) -> None:
    (folder / "none").mkdir()
    assert checked(folder / "none") == ["none:1:1: there is no YAML file in this folder"]


def test_an_unknown_level_names_the_nearest(lines: Lines) -> None:
    message = "frist_dive: there is no level 'frist_dive'; did you mean 'first_dive'?"
    assert lines(lambda: load("frist_dive")) == [message]


def test_a_name_with_no_likeness_lists_the_levels(lines: Lines) -> None:
    message = "zzz: there is no level 'zzz'; there are anemone_garden, first_dive, nine_species or visitors"
    assert lines(lambda: load("zzz")) == [message]


SPECIES = {
    "wrong unit": (
        "size_cm: 20 ",
        "size_m: 0.2",
        [
            ("size_m: 0.2", 0, "unknown key 'size_m': give it in centimetres as 'size_cm'"),
            ("title: Sardine", 0, "key 'size_cm' is missing"),
        ],
    ),
    "misspelt key": (
        "sight_m: 6",
        "sight_m: 6\nshcool: 3",
        [
            (
                "shcool",
                0,
                (
                    "unknown key 'shcool'; did you mean 'school'?; allowed are title, like, overrides, "
                    "role, size_cm, size_spread_percent, sight_m, depth_m, school, body, fins, swim, "
                    "mind, stirs or skin"
                ),
            )
        ],
    ),
    "unknown role": (
        "prey ",
        "pray ",
        [
            (
                "pray ",
                0,
                "'pray' is not known: must be prey, predator or pacifist; did you mean 'prey'?",
            )
        ],
    ),
    "text for a number": (
        "sight_m: 6",
        "sight_m: far",
        [("sight_m: far", 9, "must be a number, such as 1.5, is the text 'far'")],
    ),
    "number with a unit": (
        "sight_m: 6",
        "sight_m: 6 m",
        [("6 m", 0, "'6 m' has a unit: write the number alone, the key says the unit")],
    ),
    "decimal comma": (
        "frequency_hz: 4.0",
        "frequency_hz: 4,5",
        [("4,5", 0, "'4,5' has a comma: write a decimal point")],
    ),
    "number in quotes": (
        "frequency_hz: 4.0",
        'frequency_hz: "4.0"',
        [('"4.0"', 0, "'4.0' is text: write the number without quotes")],
    ),
    "true for a number": (
        "sight_m: 6",
        "sight_m: true",
        [("sight_m: true", 9, "must be a number, such as 1.5, is true")],
    ),
    "number for a title": (
        "title: Sardine",
        "title: 12",
        [("title: 12\n", 7, "must be text, is the number 12: put it in quotes")],
    ),
    "text for a choice": (
        "joins: true",
        "joins: often",
        [("often", 0, "must be true or false, is the text 'often'")],
    ),
    "part of a fish": (
        "count: 10",
        "count: 10.5",
        [("10.5", 0, "must be a whole number, such as 3, is the number 10.5")],
    ),
    "too large": (
        "size_cm: 20 ",
        "size_cm: 90000 ",
        [("90000", 0, "'90000' is out of range: must be at most 2000")],
    ),
    "too short a list": (
        "at_bl: [0.11, 0.28, 0.47, 0.66, 0.82]",
        "at_bl: [0.11, 0.28]",
        [("[0.11, 0.28]", 0, "the list has 2 values: must have 5")],
    ),
    "too long a list": (
        "depth_m: [1.5, 15]",
        "depth_m: [1.5, 15, 20]",
        [("[1.5, 15, 20]", 0, "the list has 3 values: must have 2")],
    ),
    "no list": (
        "depth_m: [1.5, 15]",
        "depth_m: 15 #",
        [("15 #", 0, "must be a list, such as [1, 2], is the number 15")],
    ),
    "no keys": (
        "fins:\n",
        "finns:\nfins: big\nbig:\n",
        [
            (
                "finns:",
                0,
                (
                    "unknown key 'finns'; did you mean 'fins'?; allowed are title, like, overrides, "
                    "role, size_cm, size_spread_percent, sight_m, depth_m, school, body, fins, swim, "
                    "mind, stirs or skin"
                ),
            ),
            ("big\n", 0, "must hold keys and values, is the text 'big'"),
            (
                "big:",
                0,
                (
                    "unknown key 'big'; allowed are title, like, overrides, "
                    "role, size_cm, size_spread_percent, sight_m, depth_m, school, body, fins, swim, "
                    "mind, stirs or skin"
                ),
            ),
        ],
    ),
    "stations out of order": (
        "at_bl: [0.11, 0.28, 0.47, 0.66, 0.82]",
        "at_bl: [0.11, 0.28, 0.27, 0.66, 0.82]",
        [
            (
                "[0.11, 0.28, 0.27",
                0,
                "stations must rise from nose to tail, each at least 0.04 behind the last",
            )
        ],
    ),
    "bare colour": (
        'tail: "#8c9980"',
        "tail: #8c9980",
        [
            (
                "tail: #8c9980",
                5,
                "must be text, is empty (a bare # begins a comment: put colours in quotes)",
            )
        ],
    ),
    "colour by name": (
        'tail: "#8c9980"',
        "tail: green",
        [
            (
                "green",
                0,
                "'green' is not allowed: must be a colour in quotes, such as \"#3a86c8\"",
            )
        ],
    ),
    "unknown paint": (
        "paint: scales",
        "paint: scale",
        [
            (
                "paint: scale",
                0,
                (
                    "'scale' is not known: must be gradient, stripes, spots, patch, band, hatch or scales; "
                    "did you mean 'scales'?"
                ),
            )
        ],
    ),
    "key of another layer": (
        "strength: 0.42",
        "strenght: 0.42",
        [
            (
                "strenght",
                0,
                "unknown key 'strenght'; did you mean 'strength'?; allowed are paint, size, strength or rim",
            )
        ],
    ),
}


@pytest.mark.parametrize("name", SPECIES)
def test_a_bad_species_is_refused_at_its_place(
    name: str, write: Write, herring: str, edited: Edit, checked: Checked
) -> None:
    old, new, expected = SPECIES[name]
    text = edited(herring, old, new)
    path = write("species/herring.yaml", text)
    wanted = []
    for where, further, message in expected:
        line, column = place(text, where).split(":")
        wanted.append(f"species/herring.yaml:{line}:{int(column) + further}: {message}")
    assert sorted(checked(path)) == sorted(wanted)


LEVEL = {
    "unknown species": (
        "{species: sardine, count: 48,",
        "{species: sardin, count: 48,",
        "sardin, ",
        "there is no species 'sardin'; did you mean 'sardine'?",
    ),
    "unknown species at home": (
        "at_m: [4.5, 0.2], species: blue_tang",
        "at_m: [4.5, 0.2], species: green_tang",
        "green_tang",
        "there is no species 'green_tang'; did you mean 'blue_tang'?",
    ),
    "no species at all like it": (
        "photograph: {species: sardine,",
        "photograph: {species: whale,",
        "whale",
        (
            "there is no species 'whale'; there are angelfish, anthias, barracuda, blue_tang, "
            "butterflyfish, clownfish, parrotfish, reef_shark or sardine"
        ),
    ),
    "fishes inside rock": (
        "around_m: [2.5, 0.0, -9.0]",
        "around_m: [-3.5, 8.5, -8.5]",
        "[-3.5, 8.5, -8.5]",
        "this lies inside rock: rocks[6] in line 36",
    ),
    "fishes in the ground": (
        "around_m: [2.5, 0.0, -9.0]",
        "around_m: [2.5, 0.0, -14.0]",
        "[2.5, 0.0, -14.0]",
        "this lies in the ground: z is -14, must be above ",
    ),
    "fishes out of the water": (
        "around_m: [2.5, 0.0, -9.0]",
        "around_m: [2.5, 0.0, 3.0]",
        "[2.5, 0.0, 3.0]",
        "this lies out of the water: z is 3, must be below 0",
    ),
    "fishes outside of the world": (
        "around_m: [2.5, 0.0, -9.0]",
        "around_m: [30, 40, -5]",
        "[30, 40, -5]",
        "this lies outside of the world: 50.0 m from the middle, at most 40 m",
    ),
    "submarine inside rock": (
        "at_m: [-22, 0, -7.5]",
        "at_m: [-3.5, 8.5, -8.5]",
        "[-3.5, 8.5, -8.5]",
        "this lies inside rock: rocks[6] in line 36",
    ),
    "submarine outside of the world": (
        "at_m: [-22, 0, -7.5]",
        "at_m: [-39.5, 0, -5]",
        "[-39.5, 0, -5]",
        "this lies outside of the world: 39.5 m from the middle, at most 39.1 m",
    ),
    "home outside of the world": (
        "at_m: [4.5, 0.2]",
        "at_m: [44, 0]",
        "[44, 0]",
        "this lies outside of the world: 44.0 m from the middle, at most 40 m",
    ),
    "rock beyond the ground": (
        "at_m: [25.0, 1.0]",
        "at_m: [100.0, 0.0]",
        "[100.0, 0.0]",
        "the rock lies 100.0 m from the middle: at most 60 m is allowed",
    ),
    "relief to the surface": (
        "relief_m: 2.2",
        "relief_m: 12.5",
        "12.5",
        "the seabed rises too high: at most 11 m in water 14 m deep",
    ),
    "cannot be won": (
        "count: 48",
        "count: 8",
        "12, within_m: 6",
        "this level cannot be won: 12 of 'sardine' are wanted, at most 8 are there at once",
    ),
    "leaves before it arrives": (
        "count: 48,",
        "count: 48, arrives_s: 9, leaves_s: 4,",
        "4, around_m: [-11",
        "the group must leave after it arrives",
    ),
    "a prompt for nothing": (
        "until: enough}",
        "until: done}",
        "done}",
        "'done' is not known: must be moved, turned, rose, framed, enough, photographed or won",
    ),
}


@pytest.mark.parametrize("name", LEVEL)
def test_a_bad_level_is_refused_at_its_place(
    name: str, write: Write, reef: str, edited: Edit, lines: Lines, checked: Checked
) -> None:
    old, new, where, message = LEVEL[name]
    text = edited(reef, old, new)
    path = write("levels/reef.yaml", text)
    found = checked(path)
    assert len(found) == 1
    assert found[0].startswith(f"levels/reef.yaml:{place(text, where)}: {message}")
    assert lines(lambda: load(path)) == found


def test_groups_that_never_meet_do_not_add_up(
    write: Write, reef: str, edited: Edit, checked: Checked
) -> None:
    group = "{species: sardine, count: 48, around_m: [-11.5, 1.2, -7.2], within_m: 2.3}"
    early = group.replace("count: 48", "count: 8, leaves_s: 10")
    late = group.replace("count: 48", "count: 7, arrives_s: 10")
    text = edited(reef, group, f"{early}\n  - {late}")
    found = checked(write("levels/reef.yaml", text))
    assert [line.split(": ", 1)[1] for line in found] == [
        "this level cannot be won: 12 of 'sardine' are wanted, at most 8 are there at once"
    ]
    both = text.replace("arrives_s: 10", "arrives_s: 9")
    assert checked(write("levels/reef.yaml", both)) == []


def test_all_faults_of_a_file_are_named_in_one_run(
    write: Write, reef: str, edited: Edit, checked: Checked
) -> None:
    text = edited(reef, "radius_m: 40", "radius_m: 4  # small")
    text = edited(text, "visibility_m: 24", "visibility_km: 1")
    text = edited(text, "count: 12, within_m: 6", "count: many, within_m: 6")
    places = [line.split(": ")[0] for line in checked(write("levels/reef.yaml", text))]
    assert places == [
        f"levels/reef.yaml:{place(text, '4  # small')}",
        f"levels/reef.yaml:{place(text, 'visibility_km')}",
        f"levels/reef.yaml:{place(text, 'many, within_m: 6')}",
    ]
