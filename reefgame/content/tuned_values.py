"""Writes numbers that tuning found into a species' file, at their marks: comments and layout stay as they are.

The text is edited, read again and compared, so that a file whose layout is too unusual is refused, never spoilt.
"""

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final, TypeAlias

from components.whole_file import write_whole
from reefgame.console import InputError
from reefgame.content.errors import ContentError
from reefgame.content.nodes import Mapping as Tree
from reefgame.content.nodes import Mark, Node, plain
from reefgame.content.yaml_marks import parse, read_bytes, shown
from reefgame.output import check_output, unwritable

Values: TypeAlias = Mapping[str, Mapping[str, float]]
"""Numbers by section (`swim`, `body`) and key."""

_Edit: TypeAlias = tuple[int, int, str]
"""From and to which character, and what comes there."""

_BOM: Final = b"\xef\xbb\xbf"
_LINE_END: Final = re.compile(r"\r\n|\r|\n")
_WORD: Final = re.compile(r"[^\s,}\]]*")
_GAP_TO_COMMENT: Final = re.compile(r" +(?=#)")
_BEFORE: Final = "skin"
"""A section that is missing comes before this one, else at the end."""


def check_writable(path: Path) -> None:
    """Raise InputError, one line, where `write_values` could not replace the file."""
    try:
        read_only = not path.stat().st_mode & 0o222
    except OSError as error:
        raise unwritable(path, error) from None
    if read_only:
        raise InputError(f"{path}: cannot be written: the file is read-only")
    check_output(path.resolve())


def write_values(path: Path, values: Values) -> None:
    """Put `values` into the species' file `path`, whole or not at all; a link's target is what changes.

    Raise InputError where it cannot be written, ContentError where its layout is too unusual.
    """
    check_writable(path)
    content = with_values(read_bytes(path), shown(path), values)
    target = path.resolve()
    try:
        mode = target.stat().st_mode
        write_whole(target, content)
        target.chmod(mode & 0o7777)
    except OSError as error:
        raise unwritable(path, error) from None


def with_values(content: bytes, file: str, values: Values) -> bytes:
    """Return a species file's bytes with `values`; `file` names it in errors. Raise ContentError."""
    tree = parse(content, file)
    bom = _BOM if content.startswith(_BOM) else b""
    text = _Text(content[len(bom) :].decode("utf-8"), tree)
    edits = [edit for section, numbers in values.items() for edit in text.edits(section, numbers)]
    edited = bom + _applied(text.text, edits).encode("utf-8")
    wanted: dict[str, Any] = plain(tree)
    for section, numbers in values.items():
        wanted[section] = {**(wanted.get(section) or {}), **numbers}
    if not _holds(edited, file, wanted):
        lines = "; ".join(f"{s}: {_flow(numbers)}" for s, numbers in values.items())
        raise tree.mark.error(f"this layout cannot be edited: write yourself {lines}")
    return edited


def _holds(content: bytes, file: str, wanted: dict[str, Any]) -> bool:
    try:
        return bool(plain(parse(content, file)) == wanted)
    except ContentError:
        return False


def _applied(text: str, edits: list[_Edit]) -> str:
    parts, place = [], 0
    for start, end, new in sorted(edits, key=lambda edit: edit[0]):
        parts += [text[place:start], new]
        place = end
    return "".join([*parts, text[place:]])


class _Text:
    """A file's text beside its tree, and the edits that put values there."""

    def __init__(self, text: str, tree: Tree) -> None:
        self.text, self.tree = text, tree
        self.starts = [0, *(end.end() for end in _LINE_END.finditer(text))]
        first = _LINE_END.search(text)
        self.newline = first.group() if first else "\n"
        self.ended = text.endswith(("\n", "\r"))

    def at(self, mark: Mark) -> int:
        """Return the place of a mark in the text."""
        return self.starts[mark.line - 1] + mark.column - 1

    def edits(self, section: str, numbers: Mapping[str, float]) -> list[_Edit]:
        """Return what puts `numbers` into a section, which may be missing."""
        node = self.tree.items.get(section)
        if node is None:
            return [self._new_section(section, numbers)]
        if not isinstance(node, Tree):
            return [self._in_place_of(node, f" {_flow(numbers)}")]
        edits = [
            self._in_place_of(node.items[key], _number(value))
            for key, value in numbers.items()
            if key in node.items and plain(node.items[key]) != value
        ]
        missing = {key: value for key, value in numbers.items() if key not in node.items}
        return [*edits, self._added(node, missing)] if missing else edits

    def _in_place_of(self, node: Node, new: str) -> _Edit:
        """Return what replaces a scalar; a comment behind it keeps its column where it can."""
        start = self.at(node.mark)
        word = _WORD.match(self.text, start)
        end = word.end() if word else start
        if end > start:
            new = new.strip()
        gap = _GAP_TO_COMMENT.match(self.text, end)
        if gap:
            spaces = max(1, len(gap.group()) + (end - start) - len(new))
            return start, gap.end(), new + " " * spaces
        return start, end, new

    def _added(self, node: Tree, numbers: Mapping[str, float]) -> _Edit:
        """Return what adds keys at the front of a mapping."""
        start = self.at(node.mark)
        if self.text[start : start + 1] == "{":
            return start + 1, start + 1, _pairs(numbers) + (", " if node.items else "")
        indent = self.newline + " " * (node.mark.column - 1)
        new = "".join(f"{key}: {_number(value)}{indent}" for key, value in numbers.items())
        return start, start, new

    def _new_section(self, section: str, numbers: Mapping[str, float]) -> _Edit:
        root = self.tree
        start = self.at(root.mark)
        if self.text[start : start + 1] == "{":
            return start + 1, start + 1, f"{section}: {_flow(numbers)}, "
        indent = " " * (root.mark.column - 1)
        lines = [f"{section}:", *(f"  {key}: {_number(value)}" for key, value in numbers.items())]
        block = "".join(f"{indent}{line}{self.newline}" for line in lines)
        if _BEFORE in root.keys:
            place = self.starts[self._top_of(root.keys[_BEFORE].line - 1)]
            return place, place, block + self.newline
        place, gap = len(self.text), self.newline
        if not self.ended:
            gap, self.ended = 2 * self.newline, True
        return place, place, gap + block

    def _top_of(self, line: int) -> int:
        """Return the first of the comment lines that stand right above a line."""
        while line > 0 and self.text[self.starts[line - 1] :].lstrip(" ").startswith("#"):
            line -= 1
        return line


def _number(value: float) -> str:
    return repr(float(value))


def _pairs(numbers: Mapping[str, float]) -> str:
    return ", ".join(f"{key}: {_number(value)}" for key, value in numbers.items())


def _flow(numbers: Mapping[str, float]) -> str:
    return "{" + _pairs(numbers) + "}"
