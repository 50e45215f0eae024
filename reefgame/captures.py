"""`reefgame capture`: runs the muscle model of each species given and writes its repertoire."""

from collections.abc import Sequence
from pathlib import Path

from components.body import Body, Swim
from components.repertoire_file import save
from reefgame.console import InputError, complain, progress_bar, say
from reefgame.content import read_species
from reefgame.content.anatomy import body_of, swim_of
from reefgame.motion_report import PAGE, write_report
from reefgame.output import check_output, replacing, unwritable


def capture_files(paths: Sequence[Path], output: Path | None, report: Path | None = None) -> int:
    """Capture the species of each YAML file and write NAME.npz; return the exit status.

    Without `output` a file goes where its mod ships it: `repertoires/` beside the folder `species/`. With `report` a
    page about all of them is written there. All files are checked before the first capture begins. Raise ContentError
    or InputError.
    """
    named = [read_species(path) for path in paths]
    for path in paths:
        _prepare(_target(path, output))
    if report is not None:
        _prepare(report / PAGE)
    for path, (_, file) in zip(paths, named, strict=True):
        _capture(path, body_of(file), swim_of(file), file.title, output)
    if report is not None:
        files = [
            (_target(path, output), file) for path, (_, file) in zip(paths, named, strict=True)
        ]
        say(f"{write_report(report, files)}")
    return 0


def _target(path: Path, output: Path | None) -> Path:
    folder = output or path.absolute().parent.parent / "repertoires"
    return folder / f"{path.stem}.npz"


def _prepare(target: Path) -> None:
    """Make the folder of `target`, and refuse what could not be written after a long capture."""
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise unwritable(target, error) from None
    check_output(target)


def _capture(path: Path, body: Body, swim: Swim, title: str, output: Path | None) -> None:
    from tools.capture.capture import capture

    target = _target(path, output)
    try:
        with progress_bar(title) as report:
            repertoire = capture(body, swim, lambda done, what: report(done, f"{title}: {what}"))
    except ValueError as error:
        raise InputError(f"{path}: this body does not swim: {error}") from None
    with replacing(target) as fresh:
        save(fresh, repertoire)
    for warning in filter(None, repertoire.provenance["warnings"].split("; ")):
        complain(f"{path}: warning: {warning}")
    say(f"{target}")
