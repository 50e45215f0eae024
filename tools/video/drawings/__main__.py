"""Writes the six models of papers/003, fig. 7, into a folder: `python -m tools.video.drawings assets/models`."""

import sys
from pathlib import Path

import cv2

from tools.video.drawings.creatures import flower, lobster, mermaid
from tools.video.drawings.fishes import carp, cartoon
from tools.video.drawings.whale import whale


def main(folder: Path) -> None:
    """Write carp, cartoon, mermaid, flower and lobster as PNG and the whale as GLB."""
    for drawing in (carp, cartoon, mermaid, flower, lobster):
        picture = cv2.cvtColor(drawing(), cv2.COLOR_RGBA2BGRA)
        _, content = cv2.imencode(".png", picture, [cv2.IMWRITE_PNG_COMPRESSION, 9])
        (folder / f"{drawing.__name__}.png").write_bytes(content.tobytes())
    (folder / "whale.glb").write_bytes(whale())


if __name__ == "__main__":
    main(Path(sys.argv[1]))
