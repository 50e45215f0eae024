"""The player's settings, a small JSON file in the user's config folder (DESIGN 9).

A bad file costs its bad values only: each is named by `file:line:column`, the default takes its
place, and the file is kept beside the new one when settings are next saved.
"""

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Final

from platformdirs import user_config_path

from reefgame.durable import UnreadableError, exclusive, place, read_object, set_aside, write

QUALITIES: Final = ("auto", "low", "medium", "high")
RENDER_SCALES: Final = (50, 75, 100)
LIVE_FISHES: Final = (0, 10, 50)
SENSITIVITY: Final = (0.2, 3.0)
"""Least and most of the mouse's sensitivity."""


@dataclass(frozen=True)
class Settings:
    """What the player chose."""

    mouse_sensitivity: float = 1.0
    "steering per pixel of mouse motion, 1 by default"
    invert_pitch: bool = False
    "whether pushing forward points the nose down"
    quality: str = "auto"
    "one of QUALITIES; auto is high with a graphics card, low without"
    render_scale: int = 100
    "[%] of the resolution that the quality gives the sea, one of RENDER_SCALES"
    fullscreen: bool = False
    live_physics: int = 0
    "how many of the nearest fishes run the muscle model in the next dive, one of LIVE_FISHES"


def settings_path() -> Path:
    """Return where the settings are kept."""
    return user_config_path("reefgame") / "settings.json"


def _is_sensitivity(value: object) -> bool:
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return number and SENSITIVITY[0] <= float(str(value)) <= SENSITIVITY[1]


_ALLOWED: Final[dict[str, tuple[Callable[[object], bool], str]]] = {
    "mouse_sensitivity": (_is_sensitivity, f"a number from {SENSITIVITY[0]} to {SENSITIVITY[1]}"),
    "invert_pitch": (lambda value: isinstance(value, bool), "true or false"),
    "quality": (lambda value: value in QUALITIES, " or ".join(f'"{name}"' for name in QUALITIES)),
    "render_scale": (
        lambda value: type(value) is int and value in RENDER_SCALES,
        " or ".join(map(str, RENDER_SCALES)),
    ),
    "fullscreen": (lambda value: isinstance(value, bool), "true or false"),
    "live_physics": (
        lambda value: type(value) is int and value in LIVE_FISHES,
        " or ".join(map(str, LIVE_FISHES)),
    ),
}


def load(path: Path | None = None) -> tuple[Settings, list[str]]:
    """Return the settings and one line for everything wrong in the file; defaults stand in."""
    path = path or settings_path()
    try:
        found, text = read_object(path)
    except UnreadableError as error:
        return Settings(), [str(error)]
    except OSError as error:
        return Settings(), [f"{path}: the settings cannot be read: {error.strerror}"]
    good, wrong = {}, []
    for key, value in found.items():
        if key not in _ALLOWED:
            wrong.append(f"{path}:{place(text, key)}: unknown setting {key!r}")
        elif not _ALLOWED[key][0](value):
            wrong.append(f"{path}:{place(text, key)}: {key} must be {_ALLOWED[key][1]}")
        else:
            good[key] = value
    return _settings(good), wrong


def _settings(values: dict[str, object]) -> Settings:
    merged = asdict(Settings()) | values
    return Settings(**{field.name: merged[field.name] for field in fields(Settings)})


def save(settings: Settings, path: Path | None = None) -> str | None:
    """Write the settings; a file with mistakes is kept aside first. Return a warning, or None."""
    path = path or settings_path()
    try:
        with exclusive(path):
            if path.exists() and load(path)[1]:
                set_aside(path)
            write(path, json.dumps(asdict(settings), indent=2) + "\n")
    except OSError as error:
        return f"{path}: the settings cannot be saved: {error.strerror or error}"
    return None
