"""The documentation's examples work: Python runs, YAML passes the check, commands exist, links lead somewhere."""

import re
import shlex
from pathlib import Path

import pytest

from reefgame.cli import main
from reefgame.content import check, load_species, new

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted([ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").glob("*.md")])
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```", re.MULTILINE | re.DOTALL)


def blocks(language: str) -> list[tuple[str, str]]:
    """Return (page, text) of every block in `language`."""
    found = []
    for page in PAGES:
        for kind, text in BLOCK.findall(page.read_text(encoding="utf-8")):
            if kind == language:
                found.append((page.name, text))
    return found


@pytest.mark.parametrize(("page", "code"), blocks("python"))
def test_python_examples_run(page: str, code: str, capsys: pytest.CaptureFixture[str]) -> None:
    exec(compile(code, page, "exec"), {})  # noqa: S102 (our own documentation)
    assert capsys.readouterr().out


def test_the_first_mod_passes_the_check(tmp_path: Path) -> None:
    new("mod", "my_reef", tmp_path)
    (page, text), *others = blocks("yaml")
    assert (page, others) == ("README.md", [])
    species = tmp_path / "my_reef" / "species" / "ember.yaml"
    species.write_text(text, encoding="utf-8")
    assert text.count("\n") <= 11
    assert check([tmp_path / "my_reef"]) == []
    ember = load_species("ember", mods=[tmp_path / "my_reef"])
    assert ember.length == pytest.approx(0.14)
    assert ember.name == "my_reef:ember"


def commands() -> list[list[str]]:
    """Return the words of every `reefgame` command that a page shows."""
    lines = [line for _, text in blocks("sh") for line in text.splitlines()]
    words = [shlex.split(line, comments=True) for line in lines]
    return [line[1:] for line in words if line and line[0] == "reefgame"]


@pytest.mark.parametrize("words", commands(), ids=" ".join)
def test_commands_of_the_docs_exist(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main([words[0], "--help"])
    assert stopped.value.code == 0
    text = capsys.readouterr().out
    for option in (word for word in words if word.startswith("-")):
        assert option in text


def test_links_and_pictures_lead_to_files() -> None:
    targets = [
        (page, target)
        for page in PAGES
        for target in re.findall(r"\]\(([^)#]+)\)", page.read_text(encoding="utf-8"))
        if "://" not in target
    ]
    assert len(targets) > 5
    assert [target for page, target in targets if not (page.parent / target).exists()] == []


def test_files_that_the_map_names_exist() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    table = [line for line in text.splitlines() if line.startswith("| ")]
    named = re.findall(
        r"\b((?:systems|components|tools|reefgame)/[\w/]+(?:\.py|/))", "\n".join(table)
    )
    assert len(named) > 15
    assert [path for path in named if not (ROOT / path).exists()] == []
