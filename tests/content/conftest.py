"""Content written into a folder of the test's own, which is also the working folder, so that places read short."""

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from reefgame.content import ContentError, check

SAMPLES = Path(__file__).parent / "samples"
MOD = 'id: {id}\ntitle: A mod\nversion: "1.0"\n'


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty working folder."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def write(folder: Path) -> Callable[[str, str | bytes], Path]:
    """Write a file below the working folder."""

    def writer(place: str, content: str | bytes) -> Path:
        path = folder / place
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return path

    return writer


@pytest.fixture
def write_mod(write: Callable[[str, str | bytes], Path]) -> Callable[..., Path]:
    """Write a mod: its head's further lines, and its files by place."""

    def writer(identity: str, head: str = "", place: str = "", **parts: Mapping[str, str]) -> Path:
        root = place or identity
        path = write(f"{root}/mod.yaml", MOD.format(id=identity) + head)
        for part, contents in parts.items():
            for name, text in contents.items():
                write(f"{root}/{part}/{name}.yaml", text)
        return path.parent

    return writer


@pytest.fixture
def herring() -> str:
    """A species without fault, as text; like the sardine, but it stays when the game's changes."""
    return (SAMPLES / "herring.yaml").read_text(encoding="utf-8")


@pytest.fixture
def reef() -> str:
    """A level without fault, as text; like the first dive, but it stays when the game's changes."""
    return (SAMPLES / "reef.yaml").read_text(encoding="utf-8")


@pytest.fixture
def edited() -> Callable[[str, str, str], str]:
    """Replace the one `old` of a text by `new`."""

    def editor(text: str, old: str, new: str) -> str:
        assert text.count(old) == 1, f"{text.count(old)} x {old!r}"
        return text.replace(old, new)

    return editor


@pytest.fixture
def lines() -> Callable[[Callable[[], object]], list[str]]:
    """Run what must raise ContentError; return its lines."""

    def catcher(work: Callable[[], object]) -> list[str]:
        with pytest.raises(ContentError) as raised:
            work()
        return str(raised.value).splitlines()

    return catcher


@pytest.fixture
def checked() -> Callable[..., list[str]]:
    """Return what `reefgame check` prints of paths in the working folder."""

    def checker(*paths: Path) -> list[str]:
        problems = check([path.relative_to(Path.cwd()) for path in paths])
        return [str(problem) for problem in problems]

    return checker
