"""Flora files: the base game's, a modder's ten lines, and what is refused with its place."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from components.flora import Anemone, Coral, Kelp, Limb, Plant, Seagrass, tentacle_cap
from components.landscape import build_terrain
from reefgame.content import ContentError, Problem, json_schema, list_flora, load, new, read_flora
from tools.grow.plants import grow, nodes

Write = Callable[[str, str | bytes], Path]
WriteMod = Callable[..., Path]
Edit = Callable[[str, str, str], str]
Lines = Callable[[Callable[[], object]], list[str]]
Checked = Callable[..., list[str]]


@pytest.fixture
def actinia(installed: Path) -> str:
    """The file of the strawberry anemone."""
    return (installed / "assets" / "flora" / "actinia.yaml").read_text(encoding="utf-8")


def _anemone(name: str | Path, mods: tuple[Path, ...] = ()) -> Anemone:
    form = read_flora(name, mods).form
    assert isinstance(form, Anemone)
    return form


def test_the_base_game_has_the_anemones_of_the_paper_and_other_plants() -> None:
    forms = {line.name: line.note.split(",")[0] for line in list_flora()}
    assert [name for name, form in forms.items() if form == "anemone"] == [
        "actinia",
        "anthopleura",
        "anthothoe",
        "magnificent_anemone",
        "stomphia",
    ]
    assert set(forms.values()) == {"anemone", "seagrass", "kelp", "sea fan", "soft coral"}


@pytest.mark.parametrize(
    ("name", "tentacles"),
    [("actinia", 199), ("anthopleura", 377), ("anthothoe", 218), ("stomphia", 89)],
)
def test_they_have_the_tentacles_of_their_species(name: str, tentacles: int) -> None:
    form = _anemone(name)
    count = (nodes(read_flora(name)) - form.foot.nodes) / form.tentacle.nodes
    assert abs(count - tentacles) <= 3


def test_a_file_s_centimetres_become_metres_and_its_colours_linear_light(
    write: Write, actinia: str
) -> None:
    flora = read_flora(write("flora/actinia.yaml", actinia))
    form = flora.form
    assert isinstance(form, Anemone)
    assert (form.radius, form.mouth, form.base) == pytest.approx((0.24, 0.108, 0.012))
    assert form.tentacle.length == pytest.approx((0.20, 0.15))
    assert form.tentacle.radii[0] == pytest.approx(0.0115)
    assert (form.stings, form.holds, flora.room, flora.stands) == (True, 0.12, 0.46, "rock")
    assert flora.looks["foot"].pattern == "spots"
    # #b3192a by the definition of sRGB.
    assert flora.looks["foot"].tip == pytest.approx((0.45079, 0.00972, 0.02315), abs=1e-4)


def test_the_ten_lines_of_the_page_make_a_new_anemone(
    checkout: Path, write_mod: WriteMod, checked: Checked
) -> None:
    page = (checkout / "docs" / "sea.md").read_text(encoding="utf-8")
    found = re.search(r"^like: .*?(?=^```)", page, re.DOTALL | re.MULTILINE)
    assert found
    text = found.group()
    assert len(text.splitlines()) <= 10
    mod = write_mod("my_reef", flora={"moon_anemone": text})
    assert checked(mod) == []
    moon, host = _anemone("my_reef:moon_anemone", (mod,)), _anemone("magnificent_anemone")
    assert moon.base == pytest.approx(0.026)
    assert moon.tentacle.curl == -40
    assert (moon.radius, moon.tentacle.length) == (host.radius, host.tentacle.length)
    flora = read_flora("my_reef:moon_anemone", [mod])
    plant = Plant(flora.name, (0.0, 0.0, -8.0), (0.0, 0.0, 1.0), 0.0, 1.0, 1)
    growth = grow([plant], {flora.name: flora}, build_terrain(12.0, 9.0, 0.0, 8.0, 1))
    assert growth.tufts[1].fibres > 100


def _main_limb(name: str) -> Limb:
    form = read_flora(name).form
    match form:
        case Anemone():
            return form.tentacle
        case Seagrass():
            return form.blade
        case Kelp():
            return form.stipe
        case Coral():
            return form.stem


def test_the_page_s_table_says_what_the_files_say(checkout: Path) -> None:
    page = (checkout / "docs" / "sea.md").read_text(encoding="utf-8")
    rows = [line.split("|")[2:-1] for line in page.splitlines() if line.startswith("| ![](pic")]
    assert {row[0].strip(" `") for row in rows} == {line.name for line in list_flora()}
    for row in rows:
        limb = _main_limb(row[0].strip(" `"))
        said = [float(number) for cell in row[2:] for number in re.findall(r"[0-9.]+", cell)]
        shape = [*limb.length, limb.radii[0], limb.radii[-1]]
        rest = [limb.modulus, limb.exponent, limb.curl]
        assert said == pytest.approx([limb.nodes, *(100.0 * size for size in shape), *rest])


def test_what_new_writes_passes_check_and_goes_into_the_mod(folder: Path, checked: Checked) -> None:
    root = new("mod", "bay", folder)[0].parent
    assert new("flora", "blue_star", root) == [root / "flora" / "blue_star.yaml"]
    assert checked(root) == []
    assert "bay:blue_star" in [line.name for line in list_flora([root])]
    loose = new("flora", "red_star", folder)[0]
    assert checked(loose) == []
    assert read_flora(loose).title == "Red star"


def test_a_mod_overrides_a_plant(write_mod: WriteMod) -> None:
    text = "overrides: actinia\nanemone: {disc: {mouth_cm: 16}}\n"
    mod = write_mod("a", flora={"a": text})
    assert _anemone("actinia", (mod,)).mouth == pytest.approx(0.16)
    assert _anemone("actinia").mouth == pytest.approx(0.108)


def test_plants_may_not_be_like_each_other_in_a_circle(
    write_mod: WriteMod, checked: Checked
) -> None:
    mod = write_mod("a", flora={"one": "like: two\n", "two": "like: one\n"})
    assert checked(mod)[0] == (
        "a/flora/one.yaml:1:7: `like` goes in a circle: a:two like a:one like a:two"
    )


def test_a_plant_is_not_like_a_fish(write_mod: WriteMod, checked: Checked) -> None:
    (line,) = checked(write_mod("a", flora={"one": "like: sardine\n"}))
    assert line.startswith("a/flora/one.yaml:1:7: there is no flora 'sardine'")


def test_links_out_of_the_mod_are_refused_for_plants_too(
    write: Write, write_mod: WriteMod, checked: Checked
) -> None:
    mod = write_mod("spy", flora={"bait": "like: actinia\n"})
    (mod / "flora" / "leak.yaml").symlink_to(write("secret.yaml", "password: x\n"))
    assert checked(mod) == [
        "spy/flora/leak.yaml:1:1: this leads out of the mod: only files inside it are allowed"
    ]


BAD = [
    ("radius_cm: 24\n", "radius_cm: 0\n", "'0' is out of range: must be at least 1"),
    ("base_cm: 1.2 ", "base_cm: 9 ", "no tentacle fits between mouth and rim: base_cm is at most 6.6"),
    ("base_cm: 1.2 ", "base_cm: 0.2 ", "about 8613 tentacles would stand on this disc, at most 3000"),
    ("mouth_cm: 10.8", "mouth_cm: 24", "the mouth is smaller than the disc"),
    ("stiffness: 19", "stiffness: 0", "'0' is out of range: must be more than 0"),
    ("nodes: 8", "nodes: 1", "'1' is out of range: must be at least 2"),
    ("length_cm: [20, 15]", "length_cm: [20, 0]", "'0' is out of range: must be at least 0.5"),
    ("length_cm: [20, 15]", "length_cm: [20]", "the list has 1 values: must have 2"),
    ("radius_cm: [28, 26, 21.5, 20, 22, 24]", "radius_cm: []", "the list is too short: 0 values, at least 1"),
    ("exponent: 2", "exponent: 21", "'21' is out of range: must be at most 20"),
    ("pattern: plain", "pattern: plaid", "'plaid' is not known: must be plain, spots, bands, stripes or mottle"),
    ("splay_deg: [12, 82]", "splay: [12, 82]", "unknown key 'splay': give it in degrees as 'splay_deg'"),
    ("stings: true", "stings: maybe", "must be true or false, is the text 'maybe'"),
    ("room_cm: 46  ", "room_m: 46  ", "unknown key 'room_m'"),
    ("\"#b3192a\"]", "\"#b3192\"]", "'#b3192' is not allowed: must be a colour in quotes"),
]  # fmt: skip


@pytest.mark.parametrize(("old", "wrong", "message"), BAD, ids=[b[1].strip() for b in BAD])
def test_bad_values_are_told_with_their_place(
    old: str, wrong: str, message: str,
    write: Write, checked: Checked, actinia: str,
) -> None:  # fmt: skip
    assert actinia.count(old) == 1
    found = checked(write("flora/actinia.yaml", actinia.replace(old, wrong)))
    assert any(message in line for line in found), found
    assert all(re.match(r"flora/actinia\.yaml:[0-9]+:[0-9]+: ", line) for line in found)


def test_a_plant_has_one_form(write: Write, checked: Checked, actinia: str) -> None:
    none = write("flora/none.yaml", "title: None\nroom_cm: 10\n")
    assert checked(none)[0].endswith(
        "a plant has one form, of anemone, seagrass, kelp, sea_fan, soft_coral: this has none"
    )
    both = write("flora/both.yaml", "like: actinia\nseagrass: {}\n")
    assert "flora/both.yaml:2:11: key 'blades' is missing" in checked(both)


def test_too_many_fibres_are_refused(write: Write, checked: Checked) -> None:
    fan = write("flora/fan.yaml", "like: sea_fan\nsea_fan: {branches: {number: 20, orders: 3}}\n")
    assert checked(fan) == [
        "flora/fan.yaml:2:42: this sea fan would have 8421 fibres: at most 3000"
    ]
    kelp = write("flora/weed.yaml", "like: kelp\nkelp: {stipes: 20, fronds: {number: 200}}\n")
    assert checked(kelp) == ["flora/weed.yaml:2:28: this kelp would have 8020 fibres: at most 3000"]


def test_the_schema_for_editors_knows_every_form() -> None:
    schema = json_schema("flora")
    assert {"anemone", "seagrass", "kelp", "sea_fan", "soft_coral"} <= set(
        schema["else"]["properties"]
    )
    assert "required" not in schema["$defs"]["PartialTentacles"]


def test_the_cap_of_an_anemone_stands_on_what_it_stands_on() -> None:
    form = _anemone("stomphia")
    plant = Plant("stomphia", (1.0, 2.0, -8.0), (0.0, 0.6, 0.8), 0.0, 2.0, 1)
    centre, radius = tentacle_cap(plant, form)
    above = 2.0 * (0.28 + 0.5 * 0.24)
    assert centre == pytest.approx((1.0, 2.0 + 0.6 * above, -8.0 + 0.8 * above))
    assert radius == pytest.approx(2.0 * (0.22 + 0.12))


def test_a_plant_s_colours_leave_the_content_hash_and_its_sting_does_not(
    write_mod: WriteMod,
) -> None:
    def hash_with(text: str, name: str) -> str:
        mod = write_mod(name, flora={"s": f"overrides: actinia\n{text}"}, levels={})
        return load("anemone_garden", [mod]).hash

    plain = load("anemone_garden").hash
    assert hash_with('anemone: {foot: {colours: ["#ffffff", "#ffffff"]}}\n', "a") == plain
    assert hash_with("anemone: {stings: false}\n", "b") != plain
    assert hash_with("room_cm: 40\n", "c") != plain


WORDS = st.sampled_from(
    ["0", "-1", "1e300", ".nan", "3", "[1, 2]", "[]", "{}", "null", "true", "'x'", "0.5", "99999", "[0.1, 1e9]"]
)  # fmt: skip


@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_any_value_anywhere_grows_or_is_told_in_words(
    data: st.DataObject, write: Write, installed: Path
) -> None:
    name = data.draw(st.sampled_from(["actinia", "seagrass", "kelp", "sea_fan", "soft_coral"]))
    text = (installed / "assets" / "flora" / f"{name}.yaml").read_text(encoding="utf-8")
    values = list(re.finditer(r"(?<=: )[\[\w\"#][^#\n]*?(?=\s*(#.*)?\n)", text))
    for match in sorted(
        data.draw(st.lists(st.sampled_from(values), min_size=1, max_size=3, unique=True)),
        key=lambda match: -match.start(),
    ):
        text = text[: match.start()] + data.draw(WORDS) + text[match.end() :]
    problems: tuple[Problem, ...] = ()
    try:
        flora = read_flora(write(f"flora/{name}.yaml", text))
    except ContentError as error:
        problems = error.problems
    assert all(problem.message and problem.line for problem in problems)
    if problems:
        return
    plant = Plant(flora.name, (0.0, 0.0, -8.0), (0.0, 0.0, 1.0), 0.0, 1.0, 1)
    growth = grow([plant], {flora.name: flora}, build_terrain(12.0, 9.0, 0.0, 8.0, 1))
    assert sum(tuft.fibres * tuft.nodes for tuft in growth.tufts) == nodes(flora)
