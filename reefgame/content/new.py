"""`reefgame new`: files to begin a mod, a species, a plant or a level with, which pass `reefgame check` as they are."""

import shutil
import tempfile
from importlib.resources import files
from pathlib import Path

from reefgame.content.errors import printable
from reefgame.content.mods import FOLDERS, name_problem
from reefgame.content.nodes import Mark
from reefgame.content.yaml_marks import shown


def new(kind: str, name: str, folder: Path = Path()) -> list[Path]:
    """Write the beginnings of a `mod`, `species`, `flora` or `level` called `name`; return the files written.

    Species, flora and levels go into the mod in `folder`, or straight into `folder` where it is no mod.
    Raise ContentError where the name is not allowed, something of that name is there, or nothing can
    be written; then nothing is left behind.
    """
    fault = name_problem(name)
    if fault:
        raise Mark(printable(name)).error(fault)
    folder = Path(folder)
    if kind != "mod" and (folder / "mod.yaml").is_file():
        folder = folder / FOLDERS[kind]
    target = folder / (name if kind == "mod" else f"{name}.yaml")
    if target.exists() or target.is_symlink():
        raise Mark(shown(target)).error("this is already there: choose another name")
    try:
        return _new_mod(target, name) if kind == "mod" else [_new_file(target, kind, name)]
    except OSError as error:
        reason = printable(error.strerror or str(error))
        raise Mark(shown(target)).error(f"this cannot be written: {reason}") from None


def _text(kind: str, name: str) -> str:
    template = files("reefgame.content") / "templates" / f"{kind}.yaml"
    title = name.replace("_", " ").capitalize()
    # The quotes keep a title such as "No" or "010" a text.
    return template.read_text(encoding="utf-8").replace("NAME", name).replace("TITLE", f'"{title}"')


def _new_file(target: Path, kind: str, name: str) -> Path:
    target.parent.mkdir(parents=True, exist_ok=True)
    text = _text(kind, name)
    with target.open("x", encoding="utf-8", newline="\n") as file:
        file.write(text)
    return target


def _new_mod(target: Path, name: str) -> list[Path]:
    """Build the mod beside its place and move it there, so that no half of it is ever seen."""
    target.parent.mkdir(parents=True, exist_ok=True)
    draft = Path(tempfile.mkdtemp(prefix=".new-", dir=target.parent))
    draft.chmod(0o755)
    written = {
        "mod.yaml": _text("mod", name),
        f"species/{name}_fish.yaml": _text("species", f"{name}_fish"),
        f"levels/{name}_dive.yaml": _text("level", f"{name}_dive"),
    }
    try:
        for place, text in written.items():
            (draft / place).parent.mkdir(exist_ok=True)
            (draft / place).write_text(text, encoding="utf-8", newline="\n")
        draft.rename(target)
    except OSError:
        shutil.rmtree(draft, ignore_errors=True)
        raise
    return [target / place for place in written]
