"""Arrays kept in the user's cache folder: never wrong, at worst made again."""

from pathlib import Path

import numpy as np
import pytest

from components.arrays import AnyArray
from components.skin import Eye, Skin
from systems.view import keep
from systems.view.keep import kept, named


class Maker:
    """Makes two arrays and counts how often."""

    def __init__(self) -> None:
        self.times = 0

    def __call__(self) -> list[AnyArray]:
        self.times += 1
        return [np.arange(6, dtype=np.float32).reshape(2, 3), np.zeros((0, 3), np.uint32)]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(keep, "user_cache_path", lambda _: tmp_path)
    return tmp_path / "view"


def same(found: list[AnyArray]) -> bool:
    made = Maker()()
    return all(
        a.dtype == b.dtype and a.shape == b.shape and bool((a == b).all())
        for a, b in zip(found, made, strict=True)
    )


def test_what_was_made_once_is_read_the_next_time(folder: Path) -> None:
    make = Maker()
    assert same(kept("thing", make))
    assert same(kept("thing", make))
    assert make.times == 1
    assert same(kept("other", make))
    assert make.times == 2
    assert sorted(path.name for path in folder.iterdir()) == ["other", "thing"]


@pytest.mark.parametrize("damage", ["empty", "short", "flipped", "foreign"])
def test_a_damaged_file_is_made_again(folder: Path, damage: str) -> None:
    make = Maker()
    kept("thing", make)
    path = folder / "thing"
    content = bytearray(path.read_bytes())
    content[-1] ^= 1
    damaged = {"empty": b"", "short": bytes(content[:40]), "foreign": b"PK" * 50}
    path.write_bytes(damaged.get(damage, bytes(content)))
    assert same(kept("thing", make))
    assert make.times == 2
    assert same(kept("thing", make))
    assert make.times == 2


def test_a_folder_that_cannot_be_written_costs_only_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setattr(keep, "user_cache_path", lambda _: tmp_path / "file")
    make = Maker()
    assert same(kept("thing", make))
    assert same(kept("thing", make))
    assert make.times == 2


def test_old_files_make_room(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(keep, "MOST", 3)
    for number in range(6):
        kept(f"thing{number}", Maker())
    assert len(list(folder.iterdir())) == 3


def test_names_follow_all_that_the_arrays_are_made_from() -> None:
    skin = Skin((), Eye(), (0.1, 0.2, 0.3), (0.4, 0.5, 0.6))
    other = Skin((), Eye(radius=0.03), (0.1, 0.2, 0.3), (0.4, 0.5, 0.6))
    here, there = str(Path(keep.__file__)), str(Path(__file__))
    contents = [(skin,), (other,), (np.zeros(3),), (np.zeros((3, 1)),), (np.zeros(3), 1), (1.0,)]
    names = [named(here, *content) for content in contents] + [named(there, skin)]
    assert len(set(names)) == len(names)
    assert named(here, skin) == named(here, Skin((), Eye(), (0.1, 0.2, 0.3), (0.4, 0.5, 0.6)))
