"""What a bare word of YAML means: text, number, true, false or nothing; surprises are refused (FINDINGS 7).

YAML 1.1 and 1.2 and their readers disagree on `no`, `12:30`, `010`, `1e3` and others. Whatever not all of them read
alike is an error here, with a hint that says what to write.
"""

import re
from typing import TypeAlias

Plain: TypeAlias = str | int | float | bool | None

_INTEGER = re.compile(r"[-+]?(0|[1-9][0-9]*)\Z")
_FLOAT = re.compile(r"[-+]?(0|[1-9][0-9]*)?\.[0-9]+([eE][-+][0-9]+)?\Z|[-+]?(0|[1-9][0-9]*)\.\Z")
_WORDS: dict[str, Plain] = {"true": True, "false": False, "null": None, "~": None, "": None}
_YES_NO = {
    **dict.fromkeys(("yes", "on", "true"), "true"),
    **dict.fromkeys(("no", "off", "false"), "false"),
}
_LEADING_ZERO = re.compile(r"[-+]?0[0-9_]+(\.[0-9_]*)?\Z")
_SEXAGESIMAL = re.compile(r"[-+]?[0-9][0-9_]*(:[0-5]?[0-9])+(\.[0-9_]*)?\Z")
_OTHER_BASE = re.compile(r"[-+]?0[xXoObB][0-9a-fA-F_]+\Z")
_UNDERSCORED = re.compile(r"[-+]?[0-9][0-9_]*_[0-9_]*(\.[0-9_]*)?\Z")
_EXPONENT = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)[eE][-+]?[0-9]+\Z")
_DATE = re.compile(r"[0-9]{4}-[0-9]{1,2}-[0-9]{1,2}([Tt \t].*)?\Z")
_NOT_FINITE = re.compile(r"[-+]?\.?(inf|infinity|nan)\Z", re.IGNORECASE)
_DIGITS_AT_MOST = 40


class SurpriseError(ValueError):
    """A bare word that readers of YAML take for different things; the text says what to write."""


def _surprise(text: str) -> str | None:
    word = text.lower()
    if word == "null":
        return "write null, or put it in quotes if it is text"
    if word in _YES_NO:
        return f"write {_YES_NO[word]}, or put it in quotes if it is text"
    if _NOT_FINITE.match(text):
        return "numbers must be finite; put it in quotes if it is text"
    if _LEADING_ZERO.match(text):
        return (
            "YAML may read it as octal: write it without the leading 0, or in quotes if it is text"
        )
    if _SEXAGESIMAL.match(text):
        return (
            "YAML may read it as base 60: write a plain number, or put it in quotes if it is text"
        )
    if _OTHER_BASE.match(text) or _UNDERSCORED.match(text):
        return "write a plain decimal number, or put it in quotes if it is text"
    if _EXPONENT.match(text):
        return "YAML may read it as text: write the number out, or put it in quotes if it is text"
    if _DATE.match(text):
        return "YAML may read it as a date: put it in quotes"
    return None


def resolve(text: str) -> Plain:
    """Return what the bare word `text` means. Raise SurpriseError where readers of YAML disagree."""
    if text in _WORDS:
        return _WORDS[text]
    number = _FLOAT.match(text)
    if (number or _INTEGER.match(text)) and len(text) > _DIGITS_AT_MOST:
        raise SurpriseError("a number has at most 40 digits; put it in quotes if it is text")
    if number:
        value = float(text)
        if value - value != 0.0:
            raise SurpriseError("the number is too large")
        return value
    if _INTEGER.match(text):
        return int(text)
    hint = _surprise(text)
    if hint is not None:
        raise SurpriseError(hint)
    return text
