"""What tuning found goes into a species' file at its place: nothing else of the file changes, and nothing is lost."""

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from components.fault import FaultError
from reefgame.content import ContentError, read_species
from reefgame.content.tuned_values import check_writable, with_values, write_values

Write = Callable[[str, str | bytes], Path]
VALUES = {
    "body": {"stiffness": 1.25},
    "swim": {
        "contraction_middle": 0.3,
        "contraction_rear": 0.5,
        "lag_deg": 140.0,
        "frequency_hz": 3.333,
    },
}
FLOW = "{contraction_middle: 0.3, contraction_rear: 0.5, lag_deg: 140.0, frequency_hz: 3.333}"
BLOCK = """swim:
  contraction_middle: 0.3
  contraction_rear: 0.5
  lag_deg: 140.0
  frequency_hz: 3.333
"""


def edited(text: str) -> str:
    """Return a file's text with the values."""
    return with_values(text.encode(), "fish.yaml", VALUES).decode()


def test_numbers_change_at_their_place_and_all_else_stays(herring: str) -> None:
    before, after = herring.splitlines(), edited(herring).splitlines()
    added = [line for line in after if line not in before]
    assert added == [
        "  stiffness: 1.25",
        "  contraction_middle: 0.3     # how much the muscles of the middle shorten",
        "  contraction_rear: 0.5",
        "  lag_deg: 140.0              # the rear follows the middle by this part of a beat",
        "  frequency_hz: 3.333         # beats of the tail a second",
    ]
    assert len(after) == len(before) + 1
    assert edited(edited(herring)) == edited(herring)


def test_a_file_without_swim_gets_one_before_its_skin_and_the_comments_on_it(herring: str) -> None:
    begin = herring.index("# What the muscles do")
    skin = herring.index("# Layers are painted")
    bare = herring[:begin] + herring[skin:]
    assert f"height: -1 belly, 1 back\n\n{BLOCK}\n# Layers are painted" in edited(bare)


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("like: a\n", "like: a\n\nbody:\n  stiffness: 1.25\n\n" + BLOCK),
        ("like: a", "like: a\n\nbody:\n  stiffness: 1.25\n\n" + BLOCK),
        ("swim: {}\nbody: {at_bl: 1}\n", f"swim: {FLOW}\nbody: {{stiffness: 1.25, at_bl: 1}}\n"),
        ("swim:\nbody: ~\n", f"swim: {FLOW}\nbody: {{stiffness: 1.25}}\n"),
        ("{like: a}", f"{{body: {{stiffness: 1.25}}, swim: {FLOW}, like: a}}"),
        (
            "body:\n  stiffness: 2 # firm\nswim:\n    # why\n    lag_deg: 1\n",
            (
                "body:\n  stiffness: 1.25 # firm\nswim:\n    # why\n    contraction_middle: 0.3\n"
                "    contraction_rear: 0.5\n    frequency_hz: 3.333\n    lag_deg: 140.0\n"
            ),
        ),
    ],
)
def test_layouts_are_kept(text: str, wanted: str) -> None:
    assert edited(text) == wanted


def test_line_ends_and_a_byte_order_mark_are_kept(herring: str) -> None:
    windows = "\ufeff" + herring.replace("\n", "\r\n")
    assert edited(windows) == "\ufeff" + edited(herring).replace("\n", "\r\n")


def test_a_layout_that_cannot_be_edited_is_refused_with_what_to_write() -> None:
    with pytest.raises(ContentError, match=r"fish.yaml:1:1: .*cannot be edited: write yourself"):
        edited("like: a\n...\n")


def test_a_written_file_is_read_with_its_values_and_its_mode(write: Write, herring: str) -> None:
    path = write("herring.yaml", herring)
    path.chmod(0o640)
    write_values(path, VALUES)
    _, file = read_species(path)
    assert file.swim is not None
    assert file.swim.model_dump() == VALUES["swim"]
    assert file.body.stiffness == 1.25
    assert path.stat().st_mode & 0o777 == 0o640
    assert [one.name for one in path.parent.iterdir()] == ["herring.yaml"]


def test_a_link_stays_and_its_target_changes(write: Write, herring: str, folder: Path) -> None:
    target = write("kept/herring.yaml", herring)
    link = folder / "herring.yaml"
    link.symlink_to(target)
    write_values(link, VALUES)
    assert link.is_symlink()
    assert target.read_text(encoding="utf-8") == edited(herring)


def test_a_read_only_file_is_refused_in_one_line(write: Write, herring: str) -> None:
    path = write("herring.yaml", herring)
    path.chmod(0o444)
    with pytest.raises(FaultError, match="cannot be written: the file is read-only"):
        check_writable(path)
    with pytest.raises(FaultError, match="read-only"):
        write_values(path, VALUES)
    assert path.read_text(encoding="utf-8") == herring


def test_a_disk_that_is_full_leaves_the_old_file(
    write: Write, herring: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write("herring.yaml", herring)

    def full(handle: int) -> None:
        raise OSError(28, os.strerror(28), str(path))

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(FaultError, match="cannot be written: No space left on device") as raised:
        write_values(path, VALUES)
    assert "\n" not in str(raised.value)
    assert path.read_text(encoding="utf-8") == herring
    assert [one.name for one in path.parent.iterdir()] == ["herring.yaml"]
