"""Loading: the base game is without fault, levels come by name and by file, the hash knows what matters."""

import shutil
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

import assets
import levels
from components.mind import Role
from components.skin import Gradient, Scales, Spots, Stripes
from components.species import Species
from reefgame.content import (
    Content,
    ContentError,
    check,
    json_schema,
    load,
    load_species,
    new,
    read_species,
)
from reefgame.content.assembly import catalogue

Write = Callable[[str, str | bytes], Path]
WriteMod = Callable[..., Path]
Edit = Callable[[str, str, str], str]
Lines = Callable[[Callable[[], object]], list[str]]
Checked = Callable[..., list[str]]


def test_the_base_game_is_without_fault() -> None:
    folders = [Path(str(files(levels))), Path(str(files(assets)))]
    assert [str(problem) for problem in check(folders)] == []


def test_the_sample_mods_are_without_fault(checkout: Path) -> None:
    mods = [path.parent for path in (checkout / "tests" / "mods").glob("*/mod.yaml")]
    assert len(mods) >= 1
    assert [str(problem) for problem in check(mods)] == []


def _named(content: Content, name: str) -> Species:
    return next(species for species in content.species if species.name == name)


def test_first_dive_is_what_the_issue_asks_for() -> None:
    content = load("first_dive")
    goal = content.level.objective.photograph
    assert (goal.species, goal.count, goal.within_m) == ("sardine", 12, 6)
    counts = {group.species: 0 for group in content.level.fishes}
    for group in content.level.fishes:
        counts[group.species] += group.count
    assert counts == {"sardine": 48, "blue_tang": 12, "angelfish": 3, "barracuda": 1}
    tang, sardine = (_named(content, name) for name in ("blue_tang", "sardine"))
    assert (tang.name, tang.role, tang.schooling) == ("blue_tang", Role.PACIFIST, False)
    assert (sardine.name, sardine.role, sardine.schooling) == ("sardine", Role.PREY, True)
    assert sardine.length == 0.2
    assert len(sardine.repertoire.segments) >= 4


def test_a_skin_s_layers_come_in_the_order_of_the_file(write: Write, herring: str) -> None:
    from reefgame.content.skins import skin_of

    skin = skin_of(read_species(write("herring.yaml", herring))[1].skin)
    assert [type(layer) for layer in skin.layers][:4] == [Gradient, Stripes, Scales, Spots]
    line = skin.layers[1]
    assert isinstance(line, Stripes)
    assert line.along
    assert line.colour == pytest.approx((0.8, 0.8, 148 / 255))
    assert skin.tail == pytest.approx((0x8C / 255, 0x99 / 255, 0x80 / 255))


def test_a_level_loads_by_file_and_by_name_alike() -> None:
    by_name = load("first_dive")
    by_file = load(Path(str(files(levels))) / "first_dive.yaml")
    assert (by_file.level, by_file.hash) == (by_name.level, by_name.hash)


def test_a_level_file_of_a_mod_brings_its_mod(checkout: Path) -> None:
    content = load(checkout / "tests" / "mods" / "sample" / "levels" / "lagoon.yaml")
    assert content.level.name == "sample:lagoon"


def test_comments_line_ends_order_and_place_leave_the_hash(
    write: Write, reef: str, edited: Edit
) -> None:
    hashes = {load(write("one/reef.yaml", reef)).hash}
    hashes.add(load(write("two/reef.yaml", "# A note\n" + reef.replace("\n", "\r\n"))).hash)
    hashes.add(load(write("bom/reef.yaml", b"\xef\xbb\xbf" + reef.encode())).hash)
    moved = edited(
        reef, "world:\n  radius_m: 40\n  depth_m: 14 ", "world:\n  depth_m: 14.0\n  radius_m: 40 "
    )
    hashes.add(load(write("three/reef.yaml", moved)).hash)
    hashes.add(load(write("four/reef.yaml", edited(reef, "title: First dive", "title: Dive"))).hash)
    assert len(hashes) == 1


def test_whatever_the_fishes_feel_changes_the_hash(
    write: Write, write_mod: WriteMod, reef: str, edited: Edit
) -> None:
    path = write("reef.yaml", reef)
    hashes = [load(path).hash]
    hashes.append(load(write("a/reef.yaml", edited(reef, "count: 48", "count: 47"))).hash)
    hashes.append(load(write("b/reef.yaml", edited(reef, "seed: 7", "seed: 8"))).hash)
    for number, change in enumerate(("size_cm: 21", "swim: {frequency_hz: 4.5}")):
        text = f"overrides: sardine\n{change}\n"
        hashes.append(load(path, [write_mod(f"m{number}", species={"s": text})]).hash)
    assert len(set(hashes)) == 5
    repainted = write_mod("paint", species={"s": "overrides: sardine\nskin: {shine: 0.1}\n"})
    assert load(path, [repainted]).hash == hashes[0]


def shipped(name: str) -> Path:
    return Path(str(files(assets))) / "repertoires" / f"{name}.npz"


@pytest.mark.parametrize("damage", ["truncated", "pickled", "empty"])
def test_a_damaged_repertoire_is_one_clear_line(
    damage: str, write: Write, write_mod: WriteMod, reef: str, lines: Lines
) -> None:
    mod = write_mod("a", species={"sardine": "like: sardine\n"}, levels={"reef": reef})
    target = write("a/repertoires/sardine.npz", b"")
    if damage == "truncated":
        target.write_bytes(shipped("sardine").read_bytes()[:5000])
    elif damage == "pickled":
        np.savez(target, allow_pickle=True, pattern=np.array([print], dtype=object))
    found = lines(lambda: load("a:reef", [mod]))
    assert len(found) == 1
    assert found[0].startswith("a/repertoires/sardine.npz:1:1: not a usable repertoire: ")


def test_a_repertoire_linked_out_of_the_mod_is_refused(
    write_mod: WriteMod, reef: str, lines: Lines
) -> None:
    mod = write_mod("a", species={"sardine": "like: sardine\n"}, levels={"reef": reef})
    (mod / "repertoires").mkdir()
    (mod / "repertoires" / "sardine.npz").symlink_to(shipped("sardine"))
    assert lines(lambda: load("a:reef", [mod])) == [
        (
            "a/repertoires/sardine.npz:1:1: "
            "this leads out of the mod: only files inside it are allowed"
        )
    ]


def test_a_loose_species_swims(write: Write) -> None:
    species = load_species(write("kin.yaml", "like: sardine\ntitle: Kin\n"))
    base = load_species("sardine")
    assert (species.name, species.title, base.title) == ("kin", "Kin", "Sardine")
    assert species.repertoire.provenance == base.repertoire.provenance


def test_a_body_that_does_not_swim_is_one_clear_line(
    write: Write, lines: Lines, monkeypatch: pytest.MonkeyPatch
) -> None:
    def sink(*arguments: object) -> None:
        raise ValueError("it sinks")

    monkeypatch.setattr("tools.capture.capture.capture", sink)
    path = write("stone.yaml", "like: sardine\nswim:\n  lag_deg: 1.25\n")
    assert lines(lambda: load_species(path)) == [
        "stone.yaml:3:3: no motion can be captured for this body: it sinks"
    ]


def test_a_new_body_is_captured_once_and_then_comes_from_the_cache(
    write_mod: WriteMod, reef: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("reefgame.content.repertoires.cache_folder", lambda: tmp_path / "cache")
    change = "overrides: sardine\nswim: {contraction_rear: 0.5}\n"
    mod = write_mod("a", species={"s": change})
    told: list[float] = []
    first = load("first_dive", [mod], lambda fraction, _: told.append(fraction))
    assert told == sorted(told)
    assert told[-1] == 1.0
    kept = list((tmp_path / "cache").iterdir())
    assert len(kept) == 1
    before = len(told)
    assert load("first_dive", [mod], lambda fraction, _: told.append(fraction)).hash == first.hash
    assert len(told) == before
    kept[0].write_bytes(b"spoilt")
    assert load("first_dive", [mod]).hash == first.hash
    assert kept[0].stat().st_size > 1000


def test_a_stale_shipped_repertoire_is_passed_over(
    write_mod: WriteMod, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("reefgame.content.repertoires.cache_folder", lambda: tmp_path / "cache")
    mod = write_mod("a", species={"s": "overrides: sardine\nswim: {lag_deg: 140}\n"})
    (mod / "repertoires").mkdir()
    shutil.copy(shipped("blue_tang"), mod / "repertoires" / "s.npz")
    sardine = _named(load("first_dive", [mod]), "sardine").repertoire
    assert len(list((tmp_path / "cache").iterdir())) == 1
    assert sardine.provenance["fingerprint"] in str(next((tmp_path / "cache").iterdir()))


def test_an_unwritable_cache_costs_time_only(
    write_mod: WriteMod, write: Write, monkeypatch: pytest.MonkeyPatch
) -> None:
    blocked = write("cache", "a file where the folder should be")
    monkeypatch.setattr("reefgame.content.repertoires.cache_folder", lambda: blocked)
    mod = write_mod("a", species={"s": "overrides: sardine\nswim: {lag_deg: 141}\n"})
    assert _named(load("first_dive", [mod]), "sardine").swim.lag_deg == 141


@pytest.mark.parametrize("kind", ["mod", "species", "flora", "level"])
def test_what_new_writes_passes_check(kind: str, folder: Path, checked: Checked) -> None:
    written = new(kind, "no_1", folder)
    assert all(path.is_file() for path in written)
    assert checked(written[0].parent if kind == "mod" else written[0]) == []


def test_new_species_and_levels_go_into_the_mod_in_the_folder(
    folder: Path, checked: Checked
) -> None:
    root = new("mod", "kelp", folder)[0].parent
    assert new("species", "cod", root) == [root / "species" / "cod.yaml"]
    assert new("level", "bay", root) == [root / "levels" / "bay.yaml"]
    assert checked(root) == []
    assert {"kelp:cod", "kelp:kelp_fish"} <= set(catalogue([root])[0].species)


@pytest.mark.parametrize("kind", ["mod", "species", "flora", "level"])
def test_new_refuses_to_overwrite(kind: str, folder: Path, lines: Lines) -> None:
    path = new(kind, "cod", Path())[0]
    before = path.read_bytes()
    target = "cod" if kind == "mod" else "cod.yaml"
    assert lines(lambda: new(kind, "cod", Path())) == [
        f"{target}:1:1: this is already there: choose another name"
    ]
    assert path.read_bytes() == before
    assert [entry.name for entry in folder.iterdir()] == [target]


@pytest.mark.parametrize("name", ["../cod", "a/b", "", "Cod", "a b", "nul", ".cod", "c\nd"])
def test_new_refuses_names_that_are_paths(name: str, folder: Path, lines: Lines) -> None:
    found = lines(lambda: new("mod", name, folder))
    assert len(found) == 1
    assert "is not allowed" in found[0]
    assert list(folder.iterdir()) == []


def test_new_leaves_nothing_behind_where_it_cannot_write(write: Write, lines: Lines) -> None:
    blocked = write("file", "")
    assert lines(lambda: new("mod", "cod", blocked))[0].startswith("file/cod:1:1: this cannot be")
    assert list(blocked.parent.iterdir()) == [blocked]


def test_schemas_name_every_key_with_its_range_and_words() -> None:
    species = json_schema("species")
    size = species["else"]["properties"]["size_cm"]
    assert (size["minimum"], size["maximum"]) == (1.0, 2000.0)
    assert "nose to tail" in size["description"]
    assert "size_cm" in species["else"]["required"]
    assert "required" not in species["then"]
    assert "required" not in species["$defs"]["PartialSkinLook"]
    assert json_schema("mod")["required"] == ["id", "title", "version"]
    level = json_schema("level")["else"]["properties"]
    assert {"world", "fishes", "objective", "prompts"} <= set(level)
    assert "name" not in level


_MARKS = [":", " ", "\n", "- ", "[", "]", "{", "}", "&x", "*x", "!!str ", "'", '"', "#", "|", ">"]
_WORDS = ["a", "title: A\n", "world: ", "fishes:\n", "- {species: sardine, count: ", "1", "no", "é"]
_PIECES = st.sampled_from([*_MARKS, *_WORDS, "\t", "\0", "---\n"])


@settings(
    max_examples=60,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(data=st.one_of(st.binary(max_size=300), st.lists(_PIECES, max_size=60).map("".join)))
@example(data=b"\xff\xfe\x00")
@example(data="? ? ? a\n")
@example(data="title: !\n")
def test_any_bytes_are_content_or_a_content_error(data: bytes | str, folder: Path) -> None:
    path = folder / "reef.yaml"
    path.write_bytes(data.encode("utf-8", "surrogatepass") if isinstance(data, str) else data)
    for reader in (load, read_species):
        with pytest.raises(ContentError) as raised:
            reader(path)
        assert all(line.startswith("reef.yaml:") for line in str(raised.value).splitlines())


@settings(
    max_examples=50,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(data=st.data())
def test_a_damaged_level_is_content_or_a_content_error(
    data: st.DataObject, folder: Path, reef: str
) -> None:
    text = reef
    for _ in range(data.draw(st.integers(1, 3))):
        start = data.draw(st.integers(0, len(text)))
        end = start + data.draw(st.integers(0, 12))
        text = text[:start] + data.draw(st.text(max_size=6)) + text[end:]
    path = folder / "reef.yaml"
    path.write_bytes(text.encode("utf-8", "surrogatepass"))
    problems = check([path])
    assert all(problem.file == "reef.yaml" and problem.message for problem in problems)
