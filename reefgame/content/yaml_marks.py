"""YAML read into a tree whose every node knows its file, line and column (DESIGN 6, FINDINGS 7).

The tree is composed from PyYAML's events as they come, by libyaml where it is built in, without recursion: aliases,
anchors, tags, depth and node floods are refused before anything is expanded, so no file can cost much.
"""

import re
import stat
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

import yaml

from reefgame.content.errors import ContentError, Problem, printable, quoted
from reefgame.content.nodes import Listing, Mapping, Mark, Node, Scalar
from reefgame.content.scalars import SurpriseError, resolve

LARGEST_FILE: Final = 1_000_000
DEEPEST: Final = 32
MOST_NODES: Final = 50_000

_NOT_TEXT = re.compile(
    "[^\n\t -~\u00a0-\u2027\u202a-\ud7ff\ue000-\ufdcf\ufdf0-\ufefe\uff00-\ufffd"
    "\U00010000-\U0010fffd]"
)
"""What no content file holds, raw or escaped: control characters, other line ends, surrogates, marks of byte order."""
_TAB_INDENT = re.compile(r"(?m)^ *\t(?=[^\n]*[^\s])")

_Loader: Any = getattr(yaml, "CLoader", yaml.Loader)


def shown(path: Path) -> str:
    """Return the path as messages show it: from the working folder where it lies in it."""
    try:
        return path.absolute().relative_to(Path.cwd()).as_posix()
    except (ValueError, OSError):
        return str(path)


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a content file. Raise ContentError where it is missing, no file, or too large."""
    mark = Mark(shown(path))
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            raise mark.error("this is not a file")
        if status.st_size > LARGEST_FILE:
            raise mark.error(
                f"the file is too large: {status.st_size} bytes, at most {LARGEST_FILE}"
            )
        with path.open("rb") as file:
            return file.read(LARGEST_FILE + 1)
    except FileNotFoundError:
        raise mark.error("there is no such file") from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise mark.error(f"the file cannot be read: {printable(reason)}") from None


def read(path: Path) -> Mapping:
    """Return the file's tree. Raise ContentError with every problem found."""
    return parse(read_bytes(path), shown(path))


def parse(data: bytes, file: str) -> Mapping:
    """Return the tree of a file's bytes; `file` names it in marks. Raise ContentError."""
    composer = _Composer(file)
    try:
        root = composer.compose(_decoded(data, file))
    except ContentError as error:
        raise ContentError([*composer.problems, *error.problems]) from None
    if composer.problems:
        raise ContentError(composer.problems)
    if not isinstance(root, Mapping):
        raise root.mark.error("the file must hold keys and values, such as `title: Reef`")
    return root


def _decoded(data: bytes, file: str) -> str:
    if len(data) > LARGEST_FILE:
        raise Mark(file).error(f"the file is too large: at most {LARGEST_FILE} bytes are allowed")
    data = data.removeprefix(b"\xef\xbb\xbf").replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        mark = _mark_of(data[: error.start].decode("utf-8"), file)
        byte = data[error.start]
        raise mark.error(f"byte 0x{byte:02x} is not UTF-8: save the file as UTF-8") from None
    _check_characters(text, file)
    return text


def _mark_of(before: str, file: str) -> Mark:
    return Mark(file, before.count("\n") + 1, len(before) - (before.rfind("\n") + 1) + 1)


def _check_characters(text: str, file: str) -> None:
    bad = _NOT_TEXT.search(text)
    if bad:
        message = f"character U+{ord(bad.group()):04X} is not allowed: use plain text"
        raise _mark_of(text[: bad.start()], file).error(message)
    tab = _TAB_INDENT.search(text)
    if tab:
        raise _mark_of(text[: tab.end() - 1], file).error("a tab indents this line: use spaces")


def _events(text: str, file: str) -> Iterator[Any]:
    loader: Any = None
    try:
        loader = _Loader(text)
        while loader.check_event():
            yield loader.get_event()
    except yaml.MarkedYAMLError as error:
        at = error.problem_mark or error.context_mark
        mark = Mark(file, at.line + 1, at.column + 1) if at else Mark(file)
        reason = printable(str(error.problem or error.context or "unknown fault"))
        raise mark.error(f"this is not YAML: {reason}") from None
    except yaml.YAMLError as error:
        raise Mark(file).error(f"this is not YAML: {printable(str(error))}") from None
    finally:
        if loader is not None:
            loader.dispose()


class _Composer:
    """Builds the tree of one document from events, keeping a stack of open lists and mappings."""

    def __init__(self, file: str) -> None:
        self.file = file
        self.problems: list[Problem] = []
        self.root: Node | None = None
        self.open: list[Listing | Mapping] = []
        self.pending: list[Scalar | None] = []
        self.nodes = 0
        self.documents = 0

    def compose(self, text: str) -> Node:
        for event in _events(text, self.file):
            self._take(event)
        if self.root is None or (isinstance(self.root, Scalar) and self.root.value is None):
            raise Mark(self.file).error("the file is empty")
        return self.root

    def _mark(self, event: Any) -> Mark:
        return Mark(self.file, event.start_mark.line + 1, event.start_mark.column + 1)

    def _take(self, event: Any) -> None:
        if isinstance(event, yaml.DocumentStartEvent):
            self._begin_document(event)
        elif isinstance(event, yaml.AliasEvent):
            raise self._mark(event).error(
                f"aliases (*{event.anchor}) are not allowed: write it out"
            )
        elif isinstance(event, yaml.NodeEvent):
            self._begin_node(event)
        elif isinstance(event, (yaml.SequenceEndEvent, yaml.MappingEndEvent)):
            self.open.pop()
            self.pending.pop()

    def _begin_document(self, event: Any) -> None:
        self.documents += 1
        if self.documents > 1:
            raise self._mark(event).error("a second document begins here: one file holds one")
        if event.tags or event.version:
            raise self._mark(event).error("directives (%) are not allowed")

    def _begin_node(self, event: Any) -> None:
        mark = self._mark(event)
        self.nodes += 1
        if event.anchor is not None:
            raise mark.error(f"anchors (&{event.anchor}) are not allowed: write it out")
        if event.tag is not None:
            raise mark.error(
                f"tags ({printable(str(event.tag))}) are not allowed: files hold data only"
            )
        if self.nodes > MOST_NODES:
            raise mark.error(f"the file holds too much: at most {MOST_NODES} values are allowed")
        if isinstance(event, yaml.ScalarEvent):
            self._attach(self._scalar(event, mark))
            return
        if len(self.open) == DEEPEST:
            raise mark.error(f"nested too deeply: at most {DEEPEST} levels are allowed")
        node = Listing(mark) if isinstance(event, yaml.SequenceStartEvent) else Mapping(mark)
        self._attach(node)
        self.open.append(node)
        self.pending.append(None)

    def _scalar(self, event: Any, mark: Mark) -> Scalar:
        if not event.implicit[0]:
            return Scalar(mark, self._text(event.value, mark))
        try:
            return Scalar(mark, resolve(event.value))
        except SurpriseError as error:
            self.problems.append(mark.problem(f"{quoted(event.value)} is ambiguous: {error}"))
            return Scalar(mark, str(event.value))

    def _text(self, text: str, mark: Mark) -> str:
        bad = _NOT_TEXT.search(text)
        if bad:
            message = f"character U+{ord(bad.group()):04X} is not allowed: use plain text"
            self.problems.append(mark.problem(message))
        return text

    def _attach(self, node: Node) -> None:
        parent = self.open[-1] if self.open else None
        if parent is None:
            self.root = node
        elif isinstance(parent, Listing):
            parent.items.append(node)
        elif self.pending[-1] is None:
            self.pending[-1] = self._key(node)
        else:
            key, self.pending[-1] = self.pending[-1], None
            self._enter(parent, key, node)

    def _key(self, node: Node) -> Scalar:
        if isinstance(node, Scalar) and isinstance(node.value, str) and node.value != "<<":
            return node
        if isinstance(node, Scalar) and node.value == "<<":
            raise node.mark.error("merge keys (<<) are not allowed: write it out, or use `like:`")
        raise node.mark.error("a key must be a word")

    def _enter(self, parent: Mapping, key: Scalar, node: Node) -> None:
        name = str(key.value)
        if name in parent.items:
            first = parent.keys[name]
            message = f"key {quoted(name)} stands here twice: first in line {first.line}"
            self.problems.append(key.mark.problem(message))
            return
        parent.items[name] = node
        parent.keys[name] = key.mark
