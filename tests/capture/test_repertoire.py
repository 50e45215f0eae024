"""The repertoire's file and the packed library: exact, safe to read, clear when bad."""

import io
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import assets
import components.repertoire_file as file
from components.repertoire import (
    Pattern,
    Repertoire,
    RepertoireError,
    Segment,
    heading_change,
    load,
    mean_speed,
    pack,
    save,
    turn_left_over,
)


@pytest.fixture
def name() -> str:
    """One species is enough for the file's sake."""
    return "sardine"


def same(one: Repertoire, other: Repertoire) -> bool:
    """Whether two repertoires are equal to the bit."""
    pairs = zip(one.segments, other.segments, strict=True)
    return one.provenance == other.provenance and all(
        a.pattern == b.pattern
        and a.loops == b.loops
        and np.array_equal(a.rotation, b.rotation)
        and np.array_equal(a.translation, b.translation)
        and np.array_equal(a.shape, b.shape)
        for a, b in pairs
    )


def rewritten(source: Path, target: Path, name: str, array: object, pickled: bool = False) -> Path:
    """Copy an archive with one array replaced."""
    with zipfile.ZipFile(source) as old, zipfile.ZipFile(target, "w") as new:
        for entry in old.infolist():
            data = old.read(entry)
            if entry.filename == f"{name}.npy":
                out = io.BytesIO()
                np.lib.format.write_array(
                    out, np.asarray(array), version=(1, 0), allow_pickle=pickled
                )
                data = out.getvalue()
            new.writestr(entry.filename, data)
    return target


def test_what_is_saved_is_loaded_to_the_bit(shipped: Repertoire, tmp_path: Path) -> None:
    save(tmp_path / "a.npz", shipped)
    save(tmp_path / "b.npz", load(tmp_path / "a.npz"))
    assert same(load(tmp_path / "a.npz"), shipped)
    assert (tmp_path / "a.npz").read_bytes() == (tmp_path / "b.npz").read_bytes()
    assert [path.name for path in sorted(tmp_path.iterdir())] == ["a.npz", "b.npz"]


def test_numpy_reads_the_file_without_pickle(shipped: Repertoire, shipped_file: Path) -> None:
    with np.load(shipped_file, allow_pickle=False) as arrays:
        assert sorted(arrays) == sorted(file._ARRAYS)
        assert arrays["length"].sum() == len(arrays["shape"])
        assert np.array_equal(arrays["rotation"][: len(shipped.segments[0].rotation)],
                              shipped.segments[0].rotation)  # fmt: skip


def test_a_failed_save_leaves_the_old_file(
    shipped: Repertoire, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = tmp_path / "a.npz"
    target.write_bytes(b"old")

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    with pytest.raises(OSError, match="No space"):
        save(target, shipped)
    assert target.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [target]


def test_a_missing_file_is_one_clear_line(tmp_path: Path) -> None:
    with pytest.raises(RepertoireError, match=r"nothing\.npz: cannot be read: No such file"):
        load(tmp_path / "nothing.npz")


ENTRIES = sum(
    len(segment.translation)
    for segment in load(Path(str(assets.__file__)).parent / "repertoires" / "sardine.npz").segments
)
"Of the sardine, in all."

BAD_ARRAYS = [
    ("version", np.int32(2), "version 2, this game reads 1"),
    ("pattern", np.array([0, 0, 2, 3, 5, 7], np.int8), "each at most once"),
    ("pattern", np.array([0, 1, 2, 3, 5, 9], np.int8), "are not of 0 to 8"),
    ("pattern", np.array([0, 1, 2, 4, 5, 7], np.int8), "has no turn_left"),
    ("loops", np.array([1, 1, 1, 7, 0, 0], np.int8), "neither 0 nor 1"),
    ("loops", np.array([1, 1, 1], np.int8), "differ in number"),
    ("length", np.array([23, 15, 9, 74, 9, 9], np.int32), "does not add up"),
    ("length", np.array([-1, 15, 9, 99, 9, 9], np.int32), "does not add up"),
    ("rotation", np.zeros((ENTRIES, 3, 3)), "no rotation"),
    ("rotation", np.zeros((ENTRIES, 3, 3), np.float32), "not <f8"),
    ("translation", np.full((ENTRIES, 3), np.nan), "not finite"),
    ("translation", np.full((ENTRIES, 3), 9.0), "beyond 3"),
    ("translation", np.zeros((ENTRIES, 4)), "has shape"),
    ("shape", np.zeros((ENTRIES, 22, 3), np.float32), "has shape"),
    ("provenance", np.frombuffer(b"[1]", np.uint8), "not an object of strings"),
    ("provenance", np.frombuffer(b"\xff{", np.uint8), "provenance is damaged"),
]


@pytest.mark.parametrize(("array", "value", "says"), BAD_ARRAYS)
def test_a_wrong_array_is_named(
    shipped_file: Path, tmp_path: Path, array: str, value: object, says: str
) -> None:
    bad = rewritten(shipped_file, tmp_path / "bad.npz", array, value)
    with pytest.raises(RepertoireError) as caught:
        load(bad)
    assert str(caught.value).startswith(f"{bad}: ")
    assert says in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_pickled_array_is_never_loaded(shipped_file: Path, tmp_path: Path) -> None:
    class Bomb:
        def __reduce__(self) -> tuple[object, ...]:
            return (Path.touch, (tmp_path / "went off",))

    value = np.array([Bomb()], dtype=object)
    bad = rewritten(shipped_file, tmp_path / "bad.npz", "provenance", value, pickled=True)
    with pytest.raises(RepertoireError, match="pickled objects, which are never loaded"):
        load(bad)
    assert not (tmp_path / "went off").exists()


def test_archives_of_another_kind_are_refused(shipped_file: Path, tmp_path: Path) -> None:
    bad = tmp_path / "bad.npz"
    np.savez(bad, version=np.int32(1))
    with pytest.raises(RepertoireError, match="holds"):
        load(bad)
    with np.load(shipped_file) as arrays:
        np.savez_compressed(bad, **arrays)
    with pytest.raises(RepertoireError, match="is compressed"):
        load(bad)
    bad.write_bytes(b"")
    with pytest.raises(RepertoireError, match="no npz archive"):
        load(bad)
    with bad.open("wb") as sparse:
        sparse.truncate(file.SIZE_LIMIT + 1)
    with pytest.raises(RepertoireError, match="larger than"):
        load(bad)


@settings(max_examples=150, deadline=None, suppress_health_check=list(HealthCheck))
@given(
    cut=st.integers(0, 60_000),
    flips=st.lists(st.tuples(st.integers(0, 59_999), st.integers(1, 255)), max_size=6),
    near_end=st.booleans(),
)
def test_damaged_bytes_give_an_error_or_the_same_motion(
    shipped_file: Path,
    tmp_path: Path,
    cut: int,
    flips: list[tuple[int, int]],
    near_end: bool,
) -> None:
    content = bytearray(shipped_file.read_bytes())
    whole = load(shipped_file)
    for place, mask in flips:
        at = len(content) - 1 - place % 700 if near_end else place % len(content)
        content[at] ^= mask
    damaged = tmp_path / "damaged.npz"
    damaged.write_bytes(bytes(content[: cut or None]))
    found, said = None, ""
    try:
        found = load(damaged)
    except RepertoireError as error:
        said = str(error)
    assert same(found, whole) if found else said.startswith(str(damaged)) and "\n" not in said


def test_the_library_holds_all_segments_and_mirrored_turns(shipped: Repertoire) -> None:
    library = pack([shipped, shipped])
    assert library.segment.tolist() == [list(range(9)), list(range(9, 18))]
    assert library.pattern.tolist() == list(range(9)) * 2
    assert library.loops.tolist() == [1, 1, 1, 0, 0, 0, 0, 0, 0] * 2
    assert library.start.tolist() == [0, *np.cumsum(library.length)[:-1].tolist()]
    assert library.shape.shape == (library.length.sum(), 23, 3)
    assert library.shape.dtype == np.float32
    for segment in shipped.segments:
        row = library.segment[1, segment.pattern]
        span = slice(library.start[row], library.start[row] + library.length[row])
        assert np.array_equal(library.rotation[span], segment.rotation)
        assert np.array_equal(library.translation[span], segment.translation)
        assert library.speed[row] == mean_speed(segment)
    assert library.turn[4] == -library.turn[3] == -heading_change(shipped.segments[3])
    assert library.turn[6] == -library.turn[5] == -heading_change(shipped.segments[4])
    assert library.turn[8] == -library.turn[7] == -heading_change(shipped.segments[5])
    assert np.abs(library.turn[:3]).max() < 1e-9


def test_a_pattern_that_is_not_there_is_marked(shipped: Repertoire) -> None:
    swims = Repertoire(shipped.segments[:2], {})
    library = pack([swims])
    assert library.segment.tolist() == [[0, 1, -1, -1, -1, -1, -1, -1, -1]]
    assert pack([]).segment.shape == (0, 9)


@pytest.mark.parametrize("angle", [-2.5, -0.3, 0.0, 1e-6, 0.6, 3.0])
def test_the_change_of_heading_is_the_angle_turned(shipped: Repertoire, angle: float) -> None:
    c, s = np.cos(angle / 8), np.sin(angle / 8)
    left = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
    segment = Segment(
        Pattern.TURN_LEFT,
        False,
        np.tile(left, (8, 1, 1)),
        np.zeros((8, 3)),
        np.zeros((8, 23, 3), np.float32),
    )
    assert heading_change(segment) == pytest.approx(angle, abs=1e-12)


def test_what_is_left_of_a_turn_runs_from_its_whole_to_its_last_entry(shipped: Repertoire) -> None:
    turn = shipped.segments[4]
    left = np.zeros(len(turn.rotation))
    turn_left_over(turn.rotation, left)
    assert left[0] == heading_change(turn)
    assert np.abs(np.diff(left)).max() < 0.15
    last = turn.rotation[-1]
    assert left[-1] == pytest.approx(np.arctan2(-last[2, 0], last[0, 0]), abs=1e-12)
    middle = replace(turn, rotation=turn.rotation[30:])
    assert left[30] == pytest.approx(heading_change(middle), abs=1e-12)
