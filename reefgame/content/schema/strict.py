"""What all schemas share: strict models, and the names, colours, places and fractions that they hold.

Every key that holds a quantity ends in its unit; texts, names and colours are checked by pattern; numbers are finite.
"""

from typing import Annotated, TypeAlias

from pydantic import BaseModel, ConfigDict, Field, StringConstraints

COLOUR_PATTERN = r"^#[0-9a-fA-F]{6}$"
TITLE_PATTERN = r"^\S"
VERSION_PATTERN = r"^[0-9]{1,9}(\.[0-9]{1,9}){0,3}$"
_COMPARISON = r" *(>=|<=|==|<|>) *[0-9]{1,9}(\.[0-9]{1,9}){0,3} *"
GAME_PATTERN = rf"^{_COMPARISON}(,{_COMPARISON}){{0,3}}$"
NAME_PATTERN = r"^[a-z][a-z0-9_]{0,39}$"
REFERENCE_PATTERN = r"^([a-z][a-z0-9_]{0,39}:)?[a-z][a-z0-9_]{0,39}$"

_LETTERS = "small letters, digits and _, begin with a letter and have at most 40 characters"
ALLOWED = {
    NAME_PATTERN: f"must be {_LETTERS}",
    REFERENCE_PATTERN: f"must be a name, or mod:name; names are {_LETTERS}",
    COLOUR_PATTERN: 'must be a colour in quotes, such as "#3a86c8"',
    TITLE_PATTERN: "must be a text that does not begin with a space",
    VERSION_PATTERN: 'must be a version in quotes, such as "1.0"',
    GAME_PATTERN: 'must say which versions of the game it is for, such as ">=0.1"',
}
"""What each pattern asks for, in words."""

Identifier: TypeAlias = Annotated[str, StringConstraints(pattern=NAME_PATTERN)]
"""A name of a mod, species or level: small letters, digits and _, beginning with a letter."""

Reference: TypeAlias = Annotated[str, StringConstraints(pattern=REFERENCE_PATTERN)]
"""A name, or `mod:name`."""

Colour: TypeAlias = Annotated[str, StringConstraints(pattern=COLOUR_PATTERN)]
"""A colour as `"#rrggbb"`."""

Title: TypeAlias = Annotated[str, StringConstraints(pattern=TITLE_PATTERN, max_length=60)]
Words: TypeAlias = Annotated[str, StringConstraints(max_length=600)]
Metres: TypeAlias = Annotated[float, Field(ge=-1000.0, le=1000.0)]
Degrees: TypeAlias = Annotated[float, Field(ge=-360.0, le=360.0)]
Fraction: TypeAlias = Annotated[float, Field(ge=0.0, le=1.0)]
Ground: TypeAlias = tuple[Metres, Metres]
"""x and y [m]."""
Place: TypeAlias = tuple[Metres, Metres, Metres]
"""x, y and z [m]; z is up and 0 at the surface, so the sea lies below 0."""


class Strict(BaseModel):
    """A mapping of a content file: no other keys, no conversions, finite numbers, never changed."""

    model_config = ConfigDict(
        strict=True,
        extra="forbid",
        frozen=True,
        allow_inf_nan=False,
        use_attribute_docstrings=True,
    )
