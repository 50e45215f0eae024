"""`reefgame capture --report`: one page about the repertoires captured (tools/capture/report)."""

from collections.abc import Sequence
from pathlib import Path
from typing import Final

from components.repertoire_file import load
from components.whole_file import write_whole
from reefgame.content.anatomy import body_of
from reefgame.content.schema.species import SpeciesFile
from reefgame.output import replacing

PAGE: Final = "index.html"
"""Name of the page in the folder of a report."""


def write_report(folder: Path, files: Sequence[tuple[Path, SpeciesFile]]) -> Path:
    """Write the page about the repertoires in these .npz files into `folder`, whole or not at all; return its path.

    Raise InputError or RepertoireError.
    """
    from tools.capture.report.page import page
    from tools.capture.report.subject import Subject

    subjects = [
        Subject(path.stem, file.title, file.size_cm / 100.0, body_of(file), load(path))
        for path, file in files
    ]
    target = folder / PAGE
    with replacing(target) as fresh:
        write_whole(fresh, page(subjects).encode())
    return target
