"""What is refused before any schema is asked, each with its place; and that all fine files read alike."""

from typing import Any

import pytest
import yaml

from reefgame.content import yaml_marks
from reefgame.content.errors import ContentError
from reefgame.content.nodes import plain
from reefgame.content.yaml_marks import LARGEST_FILE, MOST_NODES, parse


def fault(data: bytes) -> str:
    with pytest.raises(ContentError) as raised:
        parse(data, "f.yaml")
    return str(raised.value)


BAD = {
    "empty": (b"", "1:1: the file is empty"),
    "only a comment": (b"# nothing\n", "1:1: the file is empty"),
    "only null": (b"~\n", "1:1: the file is empty"),
    "a list": (b"- 1\n", "1:1: the file must hold keys and values, such as `title: Reef`"),
    "tab": (b"a:\n  b: 1\n\tc: 2\n", "3:1: a tab indents this line: use spaces"),
    "tab after spaces": (b"a:\n  \tc: 2\n", "2:3: a tab indents this line: use spaces"),
    "NUL": (b"a: x\0y\n", "1:5: character U+0000 is not allowed: use plain text"),
    "escape": (b"b: 1\na: \x1b[31m\n", "2:4: character U+001B is not allowed: use plain text"),
    "escaped NUL": (b'a: "\\0"\n', "1:4: character U+0000 is not allowed: use plain text"),
    "Latin-1": (
        "a: 1\ntitle: Récif\n".encode("latin-1"),
        "2:9: byte 0xe9 is not UTF-8: save the file as UTF-8",
    ),
    "UTF-16": ("a: 1".encode("utf-16"), "1:1: byte 0xff is not UTF-8: save the file as UTF-8"),
    "two documents": (
        b"a: 1\n---\nb: 2\n",
        "2:1: a second document begins here: one file holds one",
    ),
    "tag": (
        b"a: !!python/object/apply:os.system [ls]\n",
        (
            "1:4: tags (tag:yaml.org,2002:python/object/apply:os.system) are not allowed: "
            "files hold data only"
        ),
    ),
    "own tag": (b"a: !fish 1\n", "1:4: tags (!fish) are not allowed: files hold data only"),
    "alias": (b"a: *b\n", "1:4: aliases (*b) are not allowed: write it out"),
    "recursion": (b"a: &a [*a]\n", "1:4: anchors (&a) are not allowed: write it out"),
    "merge key": (
        b"<<: {a: 1}\n",
        "1:1: merge keys (<<) are not allowed: write it out, or use `like:`",
    ),
    "brackets": (b"a: " + b"[" * 200_000, "1:35: nested too deeply: at most 32 levels are allowed"),
    "closed brackets": (
        b"a:\n " + b"[" * 100_000 + b"]" * 100_000,
        "2:33: nested too deeply: at most 32 levels are allowed",
    ),
    "braces": (b"{a: " * 40, "1:129: nested too deeply: at most 32 levels are allowed"),
    "node flood": (
        b"a: [" + b"1," * MOST_NODES + b"1]",
        (
            f"1:{4 + 2 * (MOST_NODES - 3) + 1}: "
            f"the file holds too much: at most {MOST_NODES} values are allowed"
        ),
    ),
    "directive": (b"%YAML 1.1\n---\na: 1\n", "1:1: directives (%) are not allowed"),
    "unclosed": (b"a: [1, 2\n", "2:1: this is not YAML: did not find expected ',' or ']'"),
    "two colons": (
        b"a: b: c\n",
        "1:5: this is not YAML: mapping values are not allowed in this context",
    ),
    "key of a list": (b"? [1]\n: 2\n", "1:3: a key must be a word"),
    "key of a number": (b"1: 2\n", "1:1: a key must be a word"),
    "no": (
        b"a: no\n",
        "1:4: 'no' is ambiguous: write false, or put it in quotes if it is text",
    ),
    "On": (b"a: On\n", "1:4: 'On' is ambiguous: write true, or put it in quotes if it is text"),
    "True": (
        b"a: True\n",
        "1:4: 'True' is ambiguous: write true, or put it in quotes if it is text",
    ),
    "key no": (
        b"no: 1\n",
        "1:1: 'no' is ambiguous: write false, or put it in quotes if it is text",
    ),
    "010": (
        b"a:\n  b: 010\n",
        (
            "2:6: '010' is ambiguous: YAML may read it as octal: "
            "write it without the leading 0, or in quotes if it is text"
        ),
    ),
    "12:30": (
        b"a: 12:30\n",
        (
            "1:4: '12:30' is ambiguous: YAML may read it as base 60: "
            "write a plain number, or put it in quotes if it is text"
        ),
    ),
    "1e3": (
        b"a: 1e3\n",
        (
            "1:4: '1e3' is ambiguous: YAML may read it as text: "
            "write the number out, or put it in quotes if it is text"
        ),
    ),
    "0x1F": (
        b"a: 0x1F\n",
        "1:4: '0x1F' is ambiguous: write a plain decimal number, or put it in quotes if it is text",
    ),
    "1_000": (
        b"a: 1_000\n",
        "1:4: '1_000' is ambiguous: write a plain decimal number, or put it in quotes if it is text",
    ),
    "date": (
        b"a: 2026-01-02\n",
        "1:4: '2026-01-02' is ambiguous: YAML may read it as a date: put it in quotes",
    ),
    "NaN": (
        b"a: .nan\n",
        "1:4: '.nan' is ambiguous: numbers must be finite; put it in quotes if it is text",
    ),
    "infinity": (
        b"a: [1, -.inf]\n",
        "1:8: '-.inf' is ambiguous: numbers must be finite; put it in quotes if it is text",
    ),
    "1.0e+999": (b"a: 1.0e+999\n", "1:4: '1.0e+999' is ambiguous: the number is too large"),
    "a long number": (
        b"a: " + b"7" * 5000,
        (
            f"1:4: '{'7' * 40}...' is ambiguous: a number has at most 40 digits; "
            "put it in quotes if it is text"
        ),
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_yaml_is_refused_at_its_place(name: str) -> None:
    data, expected = BAD[name]
    assert fault(data) == f"f.yaml:{expected}"


def test_an_alias_bomb_is_refused_at_its_first_anchor() -> None:
    bomb = "a: &a [x, x, x, x, x, x, x, x, x]\n"
    for before, now in zip("abcdefgh", "bcdefghi", strict=True):
        bomb += f"{now}: &{now} [{', '.join([f'*{before}'] * 9)}]\n"
    assert fault(bomb.encode()) == "f.yaml:1:4: anchors (&a) are not allowed: write it out"


def test_bytes_beyond_the_limit_are_refused() -> None:
    data = b"a: " + b"x" * 3_000_000
    limit = f"f.yaml:1:1: the file is too large: at most {LARGEST_FILE} bytes are allowed"
    assert fault(data) == limit


def test_every_surprise_and_duplicate_is_named_in_one_run() -> None:
    found = fault(b"a: no\nb:\n  c: 010\n  c: 1\nb: 3\n").splitlines()
    assert [line.split(": ")[0] for line in found] == [
        "f.yaml:1:4",
        "f.yaml:3:6",
        "f.yaml:4:3",
        "f.yaml:5:1",
    ]
    assert found[2] == "f.yaml:4:3: key 'c' stands here twice: first in line 3"


def test_plain_words_and_numbers_mean_what_they_say() -> None:
    text = 'a: true\nb: ~\nc: [0, -7, +3, 1.5, .5, -2.5e-3]\nd: "no"\ne: 1.2.3\nf: "010"\ng:\n'
    assert plain(parse(text.encode(), "f")) == {
        "a": True,
        "b": None,
        "c": (0, -7, 3, 1.5, 0.5, -0.0025),
        "d": "no",
        "e": "1.2.3",
        "f": "010",
        "g": None,
    }


@pytest.mark.parametrize("end", [b"\r\n", b"\r"])
def test_line_ends_and_a_byte_order_mark_change_nothing(end: bytes) -> None:
    text = b"a: 1\nb:\n  - x y\n  - {c: 2}\n# note\nd: >-\n  two\n  lines\n"
    tree = parse(text, "f")
    assert parse(b"\xef\xbb\xbf" + text.replace(b"\n", end), "f") == tree
    assert tree.items["b"].mark.line == 3


@pytest.mark.parametrize("name", [n for n in BAD if "not YAML" not in BAD[n][1]])
def test_python_s_own_parser_refuses_the_same(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    loader: Any = yaml.Loader
    monkeypatch.setattr(yaml_marks, "_Loader", loader)
    data, expected = BAD[name]
    assert fault(data) == f"f.yaml:{expected}"


def test_python_s_own_parser_builds_the_same_tree(
    reef: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    tree = parse(reef.encode(), "f")
    monkeypatch.setattr(yaml_marks, "_Loader", yaml.Loader)
    assert parse(reef.encode(), "f") == tree
