"""What a compiled kernel's stamp depends on: its file and all first-party files it stands on."""

from pathlib import Path

from components import kernels


def _files(module: str) -> set[str]:
    path = kernels._file_of(module)
    assert path is not None
    reached, front = set[Path](), {path}
    while front:
        reached |= front
        front = set[Path]().union(*map(kernels._imported, front)) - reached
    return {file.name for file in reached}


def test_the_stamp_reaches_through_modules_that_are_imported() -> None:
    found = _files("systems.motor.move")
    assert {"move.py", "rotation.py", "confinement.py", "kernels.py", "table.py"} <= found
    assert "control.py" not in found


def test_the_stamp_changes_with_any_file_it_reaches(tmp_path: Path) -> None:
    one, other = tmp_path / "one.py", tmp_path / "other.py"
    one.write_text("from components import (\n    chance,\n)\n")
    other.write_text("from components import (\n    trigonometry,\n)\n")
    assert kernels._imported(one) == {one, kernels._file_of("components"), _path("chance")}
    assert kernels.sources_hash(one) != kernels.sources_hash(other)
    assert kernels.sources_hash(one) == kernels.sources_hash(one)
    assert len(kernels.sources_hash(one)) == 32


def _path(name: str) -> Path:
    path = kernels._file_of(f"components.{name}")
    assert path is not None
    return path


def test_a_module_that_does_not_exist_has_no_file() -> None:
    assert kernels._file_of("components.table.Table") is None
    assert kernels._file_of("components.nowhere") is None
