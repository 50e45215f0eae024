"""The rules of the house: which way imports point (DESIGN 1), what a file may say, what is locked.

Checkers rot, so every import contract also has a breach planted, which must be caught.
"""

import ast
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from importlinter.cli import lint_imports

FOLDERS = ("reefgame", "tools", "systems", "components", "levels", "assets")

# contract broken, file to write, what it says
BREACHES = [
    ("layers", "components/planted.py", "import systems"),
    ("layers", "tools/planted.py", "import reefgame"),
    ("layers", "levels/planted.py", "import components"),
    ("folders", "systems/mind/planted.py", "import systems.motor"),
    ("pyglet", "reefgame/planted.py", "import pyglet"),
    ("pyopencl", "systems/sea/planted.py", "import pyopencl"),
    ("yaml", "reefgame/planted.py", "import yaml"),
    ("simulation", "components/planted.py", "def late() -> None:\n    import yaml"),
]


def _tracked(checkout: Path) -> list[Path]:
    """Return the files that git tracks, and those it would."""
    listed = subprocess.run(
        ["git", "-c", "safe.directory=*", "ls-files", "-z", "-co", "--exclude-standard"],
        cwd=checkout,
        capture_output=True,
        check=True,
    )
    names = listed.stdout.decode().split("\0")
    return [checkout / name for name in names if name and (checkout / name).is_file()]


def _lint_copy(config: Path, copy: Path, contract: str) -> subprocess.CompletedProcess[str]:
    """Lint a copy in a process of its own, so that no package already imported stands for it."""
    program = (
        "import sys; from importlinter.cli import lint_imports as lint; "
        f"sys.exit(lint({str(config)!r}, limit_to_contracts=({contract!r},), no_cache=True))"
    )
    return subprocess.run(
        [sys.executable, "-c", program], cwd=copy, capture_output=True, text=True, check=False
    )


@pytest.fixture(scope="module")
def copy(installed: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the sources that a breach may be planted in."""
    there = tmp_path_factory.mktemp("copy")
    for folder in FOLDERS:
        for source in (installed / folder).rglob("*.py"):
            target = there / source.relative_to(installed)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, target)
    return there


def test_imports_point_one_way(
    checkout: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert lint_imports(str(checkout / "pyproject.toml"), no_cache=True) == 0


@pytest.mark.parametrize(("contract", "where", "text"), BREACHES)
def test_a_planted_breach_is_caught(
    checkout: Path, copy: Path, contract: str, where: str, text: str
) -> None:
    planted = copy / where
    planted.write_text(f'"""Planted."""\n\n{text}\n')
    try:
        result = _lint_copy(checkout / "pyproject.toml", copy, contract)
    finally:
        planted.unlink()
    assert result.returncode == 1, result.stdout + result.stderr
    assert "1 broken" in result.stdout
    assert planted.stem in result.stdout


def test_every_source_opens_with_a_docstring(checkout: Path) -> None:
    sources = [path for path in _tracked(checkout) if path.suffix == ".py"]
    assert len(sources) > len(FOLDERS)
    without = [
        str(path.relative_to(checkout))
        for path in sources
        if not ast.get_docstring(ast.parse(path.read_text(encoding="utf-8")))
    ]
    assert without == []


def test_no_file_names_a_machine_or_a_package_index(checkout: Path) -> None:
    folders = "|".join(("work", "root", "home", "Users", "tmp", "opt"))
    pattern = re.compile(rf"(?<![\w.~*)}}\]])/(?:{folders})/|pypi\.org|pythonhosted\.org")
    found = []
    for path in _tracked(checkout):
        data = path.read_bytes()
        if b"\0" in data:
            continue
        for number, line in enumerate(data.decode("utf-8").splitlines(), start=1):
            if pattern.search(line):
                found.append(f"{path.relative_to(checkout)}:{number}: {line.strip()[:80]}")
    assert found == []


def test_locks_pin_every_package_by_hash_and_name_no_host(checkout: Path) -> None:
    locks = sorted((checkout / "requirements").glob("*.lock"))
    assert [lock.stem for lock in locks] == ["dev", "play"]
    pinned = []
    for lock in locks:
        requirements = re.split(r"(?<!\\)\n", lock.read_text(encoding="utf-8").strip())
        assert all("==" in text and "--hash=sha256:" in text for text in requirements)
        assert "://" not in lock.read_text(encoding="utf-8")
        pinned.append({text.split("\\")[0].strip() for text in requirements})
    assert pinned[1] < pinned[0]


def test_every_data_file_is_installed(checkout: Path, installed: Path) -> None:
    expected = [
        path.relative_to(checkout)
        for path in _tracked(checkout)
        if path.relative_to(checkout).parts[0] in FOLDERS
    ]
    assert Path("reefgame/py.typed") in expected
    assert [str(path) for path in expected if not (installed / path).is_file()] == []
