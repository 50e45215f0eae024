"""The pictures of docs/sea.md that show papers/002's figures: `python tests/scenes/sea_pictures.py` draws them anew."""

from pathlib import Path
from typing import Final

import numpy as np

from reefgame.testing import read_scene
from reefgame.testing.photograph import photograph
from systems.view.context import ensure_context
from systems.view.target import UInt8s, write_png

HERE = Path(__file__).parent
PICTURES = HERE.parents[1] / "docs" / "pictures"
SINGLE: Final = ("current", "school_passes", "other_plants")
ROWS: Final = {"fishes": ("attract", "repel"), "singularities": ("source", "hole", "whirlwind")}
"""Scenes side by side in one picture."""
GAP: Final = 6
"""[px] between them."""


def shown(name: str, width: int, height: int) -> UInt8s:
    """Return the picture of a scene of sea/."""
    return photograph(read_scene(HERE / "sea" / f"{name}.yaml"), width, height)


def beside(pictures: list[UInt8s]) -> UInt8s:
    """Return pictures of one height side by side, white between them."""
    gap = np.full((len(pictures[0]), GAP, 3), 255, np.uint8)
    parts = [part for picture in pictures for part in (gap, picture)]
    return np.concatenate(parts[1:], axis=1)


def main() -> None:
    """Draw the pictures."""
    ensure_context()
    for name in SINGLE:
        write_png(PICTURES / f"sea_{name}.png", shown(name, 560, 315))
    for row, names in ROWS.items():
        width, height = 720 // len(names), 600 // len(names)
        drawn = beside([shown(name, width, height) for name in names])
        write_png(PICTURES / f"sea_{row}.png", drawn)


if __name__ == "__main__":
    main()
