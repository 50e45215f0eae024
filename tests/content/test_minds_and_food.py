"""What species and levels say of minds, food, light and warmth: taken over, and refused where it cannot be."""

from collections.abc import Callable
from pathlib import Path

import pytest

from components.food import GONE
from components.habitat import daylight, light, temperature
from reefgame.content import load, load_species
from reefgame.content.level_checks import terrain_of
from reefgame.level_tables import cohorts_of, food_of, habitat_of, patches_of

Write = Callable[[str, str | bytes], Path]
WriteMod = Callable[..., Path]
Edit = Callable[[str, str, str], str]
Checked = Callable[..., list[str]]

SPECIES = {
    "unknown in the diet": (
        "role: predator\nmind: {diet: [anthias, sardin]}\n",
        "sardin]",
        "there is no species 'sardin'; did you mean 'sardine'?",
    ),
    "prey that hunts": (
        "mind: {diet: [anthias]}\n",
        "diet:",
        "a prey hunts no fishes, but `diet` names 'anthias': write `role: predator`, or `diet: []`",
    ),
    "eats nothing": (
        "mind: {grazes: false}\n",
        "grazes:",
        "this prey would eat nothing: leave `grazes` out, or write `grazes: true`",
    ),
    "dark in the shallows": (
        "depth_m: [1, 4]\nmind: {likes: {light: dark}}\n",
        "light:",
        "it likes the dark but not the deep: `depth_m` ends at 4, and it is bright down to 5",
    ),
    "light in the deep": (
        "depth_m: [50, 90]\nmind: {likes: {light: bright}}\n",
        "light:",
        (
            "it likes the light but not the shallows: `depth_m` begins at 50, "
            "and it is dark from 40 down"
        ),
    ),
    "both warm and cold": (
        "mind: {likes: {water: tepid}}\n",
        "tepid",
        "'tepid' is not known: must be warm or cold",
    ),
    "no appetite": (
        "mind: {appetite_meals: 0}\n",
        "0}",
        "'0' is out of range: must be at least 0.5",
    ),
    "another unit": (
        "mind: {meal_kg: 1}\n",
        "meal_kg",
        "unknown key 'meal_kg': give it in grams as 'meal_g'",
    ),
}


def place(text: str, where: str) -> str:
    """Return line:column of the one `where` in the text."""
    assert text.count(where) == 1
    before = text[: text.index(where)]
    return f"{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}"


@pytest.mark.parametrize("name", SPECIES)
def test_contradictory_habits_are_refused_at_their_place(
    name: str, write: Write, checked: Checked
) -> None:
    said, where, message = SPECIES[name]
    text = f"like: sardine\ntitle: Herring\n{said}"
    found = checked(write("species/herring.yaml", text))
    assert found == [f"species/herring.yaml:{place(text, where)}: {message}"]


def test_a_role_that_contradicts_an_inherited_diet_is_marked_in_the_own_file(
    write: Write, checked: Checked
) -> None:
    text = "like: barracuda\ntitle: Meek\nrole: pacifist\nmind: {grazes: true}\n"
    (found,) = checked(write("species/meek.yaml", text))
    assert found.startswith("species/meek.yaml:3:1: a pacifist hunts no fishes, but `diet` names")


def test_species_may_eat_each_other_in_a_circle_and_themselves(write_mod: WriteMod) -> None:
    shark = "like: reef_shark\ntitle: Shark\nmind: {{diet: [{}, {}]}}\n"
    mod = write_mod(
        "ring", species={"one": shark.format("two", "one"), "two": shark.format("one", "sardine")}
    )
    one, two = (load_species(f"ring:{name}", mods=[mod]).temper for name in ("one", "two"))
    assert one.diet == ("ring:two", "ring:one")
    assert two.diet == ("ring:one", "sardine")


def test_a_mind_left_out_is_that_of_a_modest_grazer_or_a_hunter(
    write: Write, herring: str, edited: Edit
) -> None:
    grazer = load_species(write("species/herring.yaml", herring)).temper
    hunter = load_species(
        write("species/pike.yaml", edited(herring, "role: prey ", "role: predator "))
    ).temper
    assert grazer.grazes
    assert not hunter.grazes
    assert grazer.diet == hunter.diet == ()
    assert grazer.meal == pytest.approx(0.2)
    assert grazer.digestion == 1500.0
    assert (grazer.bright, grazer.warm) == (0, 0)


def test_the_mind_of_a_file_becomes_temper_in_seconds_and_signs() -> None:
    temper = load_species("barracuda").temper
    assert "sardine" in temper.diet
    assert not temper.grazes
    assert temper.digestion == 480.0
    clown = load_species("clownfish").temper
    assert (clown.bright, clown.warm) == (0, 1)
    assert clown.breeding == 2400.0


PATCH = "food:\n  - {around_m: [-8, 0, -6], within_m: 2, particles: 30, meal_g: 0.1}\n\nobjective:"

LEVEL = {
    "food in rock": (
        "objective:",
        PATCH.replace("[-8, 0, -6]", "[-3.5, 8.5, -8.5]"),
        "[-3.5, 8.5, -8.5]",
        "this lies inside rock: rocks[6] in line 36",
    ),
    "no particles": (
        "objective:",
        PATCH.replace("particles: 30", "particles: 0"),
        "0, meal_g",
        "'0' is out of range: must be at least 1",
    ),
    "a river": (
        "objective:",
        PATCH.replace("meal_g: 0.1", "drift_m_per_s: [0, 9, 0]"),
        "9, 0]",
        "'9' is out of range: must be at most 2",
    ),
    "too much food": (
        "objective:",
        "food:"
        + 3 * PATCH.replace("30", "20000").removesuffix("\n\nobjective:")[5:]
        + "\nobjective:",
        "- {around_m: [-8, 0, -6]",
        "there is too much food: 60000 particles, at most 50000",
    ),
    "a hot bottom": (
        "visibility_m: 24",
        "visibility_m: 24\n  surface_c: 20\n  bottom_c: 21",
        "21\n",
        "the bottom cannot be warmer than the surface: bottom_c <= surface_c",
    ),
    "an unknown hour": (
        "submarine:",
        "day: {starts: teatime}\n\nsubmarine:",
        "teatime",
        "'teatime' is not known: must be sunrise, morning, noon, afternoon, sunset or midnight",
    ),
    "a day of seconds": (
        "submarine:",
        "day: {length_s: 5}\n\nsubmarine:",
        "5}\n\nsubmarine",
        "'5' is out of range: must be at least 60",
    ),
    "replaced in no time": (
        "count: 48,",
        "count: 48, restock_s: -1,",
        "-1, around",
        "'-1' is out of range: must be at least 0",
    ),
}


@pytest.mark.parametrize("name", LEVEL)
def test_impossible_food_and_water_are_refused_at_their_place(
    name: str, write: Write, reef: str, edited: Edit, checked: Checked
) -> None:
    old, new, where, message = LEVEL[name]
    text = edited(reef, old, new)
    at = text.index(where)
    line, column = text[:at].count("\n") + 1, at - text.rfind("\n", 0, at)
    assert checked(write("levels/reef.yaml", text)) == [
        f"levels/reef.yaml:{line}:{column}: {message}"
    ]


def test_a_level_says_nothing_of_food_and_light_and_has_noon_and_none(
    write: Write, reef: str
) -> None:
    level = load(write("levels/reef.yaml", reef)).level
    habitat = habitat_of(level)
    assert level.food == ()
    assert daylight(habitat, 0) == daylight(habitat, 100_000) == pytest.approx(1.0)
    assert light(habitat, 1.0, -12.0) == pytest.approx(0.5)
    assert temperature(habitat, 1.0, -14.0) == pytest.approx(24.0)
    assert cohorts_of(level, ["blue_tang", "sardine"]).restock[0] == 120 * 60


def test_food_and_day_of_a_level_become_tables(write: Write, reef: str, edited: Edit) -> None:
    text = edited(reef, "objective:", PATCH.replace("meal_g: 0.1", "meal_g: 0.1, returns_s: null"))
    text = edited(text, "submarine:", "day: {length_s: 240, starts: midnight}\n\nsubmarine:")
    level = load(write("levels/reef.yaml", text)).level
    patches, terrain = patches_of(level), terrain_of(level)
    food = food_of(level, patches, terrain, 5)
    assert food.count == 30
    assert set(food.live("meal")) == {0.1}
    assert patches.returns_after[0] == GONE
    away = food.live("position") - patches.around[0]
    assert 0.5 < abs(away).max() <= 2.0
    habitat = habitat_of(level)
    assert daylight(habitat, 0) == pytest.approx(0.1)
    assert daylight(habitat, 120 * 60) == pytest.approx(1.0)
