"""Mods: where they may reach, in which order they load, what they change, and what becomes of broken ones."""

from collections.abc import Callable
from pathlib import Path

import pytest
from platformdirs import user_data_path

from reefgame.content import Content, list_levels, list_mods, list_species, load, read_species

Write = Callable[[str, str | bytes], Path]
WriteMod = Callable[..., Path]
Lines = Callable[[Callable[[], object]], list[str]]
Checked = Callable[..., list[str]]
SMALL = "like: sardine\nsize_cm: {}\n"


def mods_named(*mods: Path) -> list[str]:
    return [line.name for line in list_mods(mods)]


def test_the_sample_mod_adds_and_overrides(checkout: Path) -> None:
    sample = checkout / "tests" / "mods" / "sample"
    content: Content = load("sample:lagoon", [sample])
    sizes = {species.name: species.length for species in content.species}
    assert sizes == {"sample:anchovy": 0.12, "sardine": 0.16}
    anchovy, sardine = content.species
    assert (anchovy.title, anchovy.swim.frequency_hz) == ("Anchovy", 5.0)
    assert anchovy.body.station == sardine.body.station
    assert anchovy.spacing == sardine.spacing == 1.1
    assert [group.species for group in content.level.fishes] == ["sample:anchovy", "sardine"]
    assert "sample:lagoon" in [line.name for line in list_levels([sample])]


def test_without_the_mod_the_base_game_is_as_it_was() -> None:
    assert read_species("sardine")[1].size_cm == 20
    names = [line.name for line in list_species()]
    assert len(names) == 9
    assert not [name for name in names if ":" in name]


def test_a_link_out_of_the_mod_is_refused(
    write: Write, write_mod: WriteMod, checked: Checked, lines: Lines
) -> None:
    secret = write("secret.yaml", "password: x\n")
    mod = write_mod("spy", species={"bait": SMALL.format(9)})
    (mod / "species" / "leak.yaml").symlink_to(secret)
    message = (
        "spy/species/leak.yaml:1:1: this leads out of the mod: only files inside it are allowed"
    )
    assert checked(mod) == [message]
    assert lines(lambda: load("first_dive", [Path("spy")])) == [message]


def test_a_linked_folder_out_of_the_mod_is_refused(
    write: Write, write_mod: WriteMod, checked: Checked
) -> None:
    write("elsewhere/thief.yaml", SMALL.format(9))
    mod = write_mod("spy")
    (mod / "species").symlink_to(mod.parent / "elsewhere")
    assert checked(mod) == [
        "spy/species/thief.yaml:1:1: this leads out of the mod: only files inside it are allowed"
    ]


def test_a_link_that_stays_inside_is_fine(write_mod: WriteMod, checked: Checked) -> None:
    mod = write_mod("twins", species={"one": SMALL.format(9)})
    (mod / "species" / "two.yaml").symlink_to("one.yaml")
    assert checked(mod) == []
    assert "twins:two" in [line.name for line in list_species([mod])]


@pytest.mark.parametrize(
    "reference", ["../../etc/passwd", "/etc/passwd", "a/b", "a:b:c", "..", "Sardine"]
)
def test_names_are_no_paths(
    reference: str, write_mod: WriteMod, checked: Checked, reef: str
) -> None:
    mod = write_mod("spy", species={"bait": f"like: {reference}\nsize_cm: 9\n"})
    found = checked(mod)
    assert len(found) == 1
    assert found[0].startswith(f"spy/species/bait.yaml:1:7: there is no species '{reference}'")


@pytest.mark.parametrize("name", ["Big", "my fish", "con", "9tails", "x" * 41])
def test_file_names_must_be_plain(name: str, write_mod: WriteMod, checked: Checked) -> None:
    mod = write_mod("spy", species={name: SMALL.format(9)})
    found = checked(mod)
    assert len(found) == 1
    assert found[0].startswith(f"spy/species/{name}.yaml:1:1: the name '{name[:40]}")


def test_a_yml_file_is_not_passed_over_in_silence(
    write: Write, write_mod: WriteMod, checked: Checked
) -> None:
    mod = write_mod("spy")
    write("spy/species/bait.yml", SMALL.format(9))
    assert checked(mod) == ["spy/species/bait.yml:1:1: name the file .yaml, not .yml"]


def test_two_mods_of_one_id_are_refused(
    write_mod: WriteMod, checked: Checked, lines: Lines
) -> None:
    one, two = write_mod("coral"), write_mod("coral", place="other")
    message = "other/mod.yaml:1:5: two mods are called 'coral': the other is coral/mod.yaml:1"
    assert checked(one, two) == [message]
    assert lines(lambda: load("first_dive", [one, two])) == [message]


def test_a_circle_in_the_load_order_is_refused(
    write_mod: WriteMod, checked: Checked, lines: Lines
) -> None:
    mods = [
        write_mod("a", "after: [b]\n"),
        write_mod("b", "requires: [c]\n"),
        write_mod("c", "after: [x, a]\n"),
    ]
    expected = [
        "a/mod.yaml:4:9: the load order goes round in a circle: a after b after c after a",
        "b/mod.yaml:4:12: the load order goes round in a circle: b after c after a after b",
        "c/mod.yaml:4:12: the load order goes round in a circle: c after a after b after c",
    ]
    assert checked(*mods) == expected
    assert lines(lambda: load("first_dive", mods)) == expected


def test_a_mod_after_itself_is_refused(write_mod: WriteMod, checked: Checked) -> None:
    mod = write_mod("a", "after: [a]\n")
    assert checked(mod) == ["a/mod.yaml:4:9: a mod cannot load after itself"]


def test_a_required_mod_must_be_there(write_mod: WriteMod, checked: Checked) -> None:
    mods = [write_mod("reefs", "requires: [corals]\n"), write_mod("coral")]
    assert checked(*mods) == [
        "reefs/mod.yaml:4:12: the mod 'corals' is required and not there; did you mean 'coral'?"
    ]


@pytest.mark.parametrize(
    ("game", "fault"),
    [
        ('">=0.0.1, <999"', None),
        ('">=99"', "4:7: the mod is for versions >=99 of the game; this is "),
        ('"<0.0.1"', "4:7: the mod is for versions <0.0.1 of the game; this is "),
        ('"new"', "4:7: 'new' is not allowed: must say which versions of the game it is for, such"),
        ("0.1", "4:7: must be text, is the number 0.1: put it in quotes"),
    ],
)
def test_a_mod_says_which_game_it_is_for(
    game: str, fault: str | None, write_mod: WriteMod, checked: Checked
) -> None:
    found = checked(write_mod("a", f"game: {game}\n"))
    if fault is None:
        assert found == []
    else:
        assert len(found) == 1
        assert found[0].startswith(f"a/mod.yaml:{fault}")


def test_a_folder_without_a_head_is_no_mod(folder: Path, lines: Lines) -> None:
    (folder / "thing").mkdir()
    assert lines(lambda: load("first_dive", [Path("thing")])) == [
        "thing/mod.yaml:1:1: there is no such file: a mod is a folder with mod.yaml"
    ]
    assert lines(lambda: load("first_dive", [Path("gone")])) == [
        "gone:1:1: there is no such folder: a mod is a folder with mod.yaml"
    ]


def test_the_base_game_s_name_is_taken(write_mod: WriteMod, lines: Lines) -> None:
    mod = write_mod("reefgame", place="fake")
    assert lines(lambda: load("first_dive", [mod])) == [
        "fake/mod.yaml:1:5: 'reefgame' is the base game's own name: choose another"
    ]


def test_later_mods_override_earlier_ones(write_mod: WriteMod) -> None:
    change = "overrides: sardine\nsize_cm: {}\n"
    big = write_mod("big", "after: [zebra]\n", species={"s": change.format(40)})
    zebra = write_mod("zebra", species={"s": change.format(30) + "sight_m: 9\n"})
    assert mods_named(big, zebra) == ["reefgame", "zebra", "big"]
    species = read_species("sardine", [big, zebra])[1]
    assert (species.size_cm, species.sight_m, species.title) == (40, 9, "Sardine")


def test_what_is_like_an_overridden_species_follows_it(write_mod: WriteMod) -> None:
    adder = write_mod("adder", species={"kin": "like: sardine\ntitle: Kin\n"})
    changer = write_mod("changer", species={"s": "overrides: sardine\nsize_cm: 33\n"})
    assert read_species("adder:kin", [adder, changer])[1].size_cm == 33


def test_a_level_is_overridden_by_value(write_mod: WriteMod) -> None:
    change = "overrides: first_dive\nwater: {visibility_m: 11}\ntitle: Murky\n"
    level = load("first_dive", [write_mod("murk", levels={"murk": change})]).level
    assert (level.name, level.title, level.water.visibility_m) == ("first_dive", "Murky", 11)
    assert level.world == load("first_dive").level.world


def test_an_override_of_nothing_is_refused(write_mod: WriteMod, checked: Checked) -> None:
    mod = write_mod("a", species={"s": "overrides: sardines\nsize_cm: 3\n"})
    assert checked(mod) == [
        "a/species/s.yaml:1:12: there is no species 'sardines'; did you mean 'sardine'?"
    ]


def test_like_and_overrides_exclude_each_other(write_mod: WriteMod, checked: Checked) -> None:
    mod = write_mod("a", species={"s": "overrides: sardine\nlike: blue_tang\n"})
    assert checked(mod) == [
        "a/species/s.yaml:2:1: `like` and `overrides` exclude each other",
    ]


def test_an_override_belongs_into_a_mod(
    write: Write, write_mod: WriteMod, checked: Checked, lines: Lines
) -> None:
    text = "overrides: sardine\nsize_cm: 3\n"
    loose = write("loose.yaml", text)
    message = "loose.yaml:1:1: only a file in a mod overrides: put it into the mod's folder"
    assert checked(loose) == [message]
    assert lines(lambda: read_species(loose)) == [message]
    mod = write_mod("a", species={"s": text})
    assert checked(mod / "species" / "s.yaml") == []
    assert read_species(mod / "species" / "s.yaml")[1].size_cm == 3


def test_loose_species_may_start_from_one_beside_them(write: Write, checked: Checked) -> None:
    write("two.yaml", "like: three\nsize_cm: 33\n")
    write("three.yaml", "like: sardine\nsight_m: 3\n")
    one = write("one.yaml", "like: two\ntitle: One\n")
    write("broken.yaml", "like: [\n")
    assert checked(one) == []
    species = read_species(one)[1]
    assert (species.title, species.size_cm, species.sight_m) == ("One", 33, 3)


def test_a_fault_in_an_override_shows_where_it_was_written(
    write_mod: WriteMod, checked: Checked
) -> None:
    text = "overrides: sardine\nskin:\n  shine: 3\nbody: {girth_bl: 1}\n"
    mod = write_mod("a", species={"s": text})
    assert [line.split(": ")[0] for line in checked(mod)] == [
        "a/species/s.yaml:3:10",
        "a/species/s.yaml:4:8",
    ]


def test_a_circle_of_likes_is_refused(write_mod: WriteMod, checked: Checked) -> None:
    species = {"one": "like: two\n", "two": "like: three\n", "three": "like: one\n"}
    found = checked(write_mod("a", species=species))
    assert found == [
        (
            "a/species/one.yaml:1:7: "
            "`like` goes in a circle: a:two like a:three like a:one like a:two"
        ),
        (
            "a/species/three.yaml:1:7: "
            "`like` goes in a circle: a:one like a:two like a:three like a:one"
        ),
        (
            "a/species/two.yaml:1:7: "
            "`like` goes in a circle: a:three like a:one like a:two like a:three"
        ),
    ]


def test_a_species_like_itself_is_refused(write_mod: WriteMod, checked: Checked) -> None:
    found = checked(write_mod("a", species={"one": "like: one\n"}))
    assert found == ["a/species/one.yaml:1:7: `like` goes in a circle: a:one like a:one"]


def test_an_own_sardine_may_start_from_the_base_game_s(write_mod: WriteMod) -> None:
    mod = write_mod("a", species={"sardine": SMALL.format(7)})
    assert read_species("a:sardine", [mod])[1].size_cm == 7
    assert read_species("sardine", [mod])[1].size_cm == 20


def test_a_mod_s_own_names_come_first(write_mod: WriteMod, reef: str) -> None:
    own = write_mod("a", species={"sardine": SMALL.format(7)}, levels={"reef": reef})
    level = load("a:reef", [own]).level
    assert {group.species for group in level.fishes} == {"a:sardine", "blue_tang"}
    assert level.objective.photograph.species == "a:sardine"


def test_a_name_that_two_mods_have_is_ambiguous(
    write_mod: WriteMod, checked: Checked, lines: Lines
) -> None:
    mods = [
        write_mod("a", species={"cod": SMALL.format(30)}),
        write_mod("b", species={"cod": SMALL.format(40)}),
    ]
    user = write_mod("c", "requires: [a, b]\n", species={"kin": "like: cod\n"})
    assert checked(*mods, user) == [
        "c/species/kin.yaml:1:7: 'cod' is ambiguous: write a:cod or b:cod"
    ]
    assert read_species("b:cod", mods)[1].size_cm == 40
    assert lines(lambda: read_species("cod", mods)) == [
        "cod: 'cod' is ambiguous: write a:cod or b:cod"
    ]


def install(name: str, **parts: str) -> Path:
    """Put a mod into the user's data folder."""
    root = user_data_path("reefgame") / "mods" / name
    for place, text in parts.items():
        path = root / f"{place.replace('__', '/')}.yaml"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return root


def head(identity: str, more: str = "") -> str:
    return f'id: {identity}\ntitle: A mod\nversion: "1"\n{more}'


def test_installed_mods_are_found(user_folders: Path) -> None:
    install("good", mod=head("good"), species__cod=SMALL.format(50))
    assert "good:cod" in [line.name for line in list_species()]


def test_a_broken_installed_mod_is_disabled_and_never_fatal(user_folders: Path) -> None:
    install("bad", mod=head("bad"), species__cod=SMALL.format("large"))
    install("worse", mod="id: [\n")
    install("needy", mod=head("needy", "requires: [bad]\n"))
    install("good", mod=head("good"), species__cod=SMALL.format(50))
    content = load("first_dive")
    told = {Path(mod.folder).name: str(mod.problems[0]) for mod in content.disabled}
    assert sorted(told) == ["bad", "needy", "worse"]
    assert told["bad"].endswith(
        "bad/species/cod.yaml:2:10: must be a number, such as 1.5, is the text 'large'"
    )
    assert told["needy"].endswith("needy/mod.yaml:4:12: the mod 'bad' is required and disabled")
    assert told["worse"].endswith(
        "worse/mod.yaml:2:1: this is not YAML: did not find expected node content"
    )
    assert "good:cod" in [line.name for line in list_species()]


def test_installed_mods_in_a_circle_are_disabled(user_folders: Path) -> None:
    install("a", mod=head("a", "after: [b]\n"))
    install("b", mod=head("b", "after: [a]\n"))
    install("c", mod=head("c"))
    assert sorted(Path(mod.folder).name for mod in load("first_dive").disabled) == ["a", "b"]
    assert mods_named() == ["reefgame", "c", "a", "b"]


def test_a_given_mod_goes_before_an_installed_one_of_its_id(
    user_folders: Path, write_mod: WriteMod
) -> None:
    install("cods", mod=head("cods"), species__cod=SMALL.format(50))
    mine = write_mod("cods", species={"cod": SMALL.format(60)})
    assert read_species("cods:cod", [mine])[1].size_cm == 60
    disabled = load("first_dive", [mine]).disabled
    assert [Path(mod.folder).name for mod in disabled] == ["cods"]
    assert "two mods are called 'cods'" in str(disabled[0].problems[0])
