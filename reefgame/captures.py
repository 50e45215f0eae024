"""`reefgame capture`: runs the muscle model of each species given and writes its repertoire."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path

from components.repertoire import Repertoire
from components.repertoire_file import RepertoireError, load, save
from reefgame.console import InputError, Report, complain, progress_bar, say
from reefgame.content import read_species
from reefgame.content.anatomy import UNTUNED, body_of, swim_of
from reefgame.content.nodes import Mark
from reefgame.content.schema.species import SpeciesFile
from reefgame.content.yaml_marks import shown
from reefgame.motion_report import PAGE, write_report
from reefgame.output import check_output, replacing, unwritable
from reefgame.tuning import Tuning, tuned
from tools.video.water.joining import is_filmed


def capture_files(
    paths: Sequence[Path],
    output: Path | None,
    report: Path | None = None,
    tuning: Tuning | None = None,
    control_points: bool = False,
) -> int:
    """Capture the species of each YAML file and write NAME.npz; return the exit status.

    Without `output` a file goes where its mod ships it: `repertoires/` beside the folder `species/`. With `report` a
    page about all of them is written there. With `tuning` their swims are found first and written into the YAML files;
    with `control_points` the files hold those of the skin too (tools/capture/control_points.py).
    All files are checked before the first capture begins. Raise ContentError or FaultError.
    """
    files = {path: read_species(path)[1] for path in paths}
    if tuning is None:
        _check_tuned(files)
    for path in paths:
        _prepare(_target(path, output))
        _check_not_filmed(_target(path, output))
    if report is not None:
        _prepare(report / PAGE)
    captured = _captured(files) if tuning is None else tuned(list(files.items()), tuning)
    if control_points:
        captured = ((path, _with_skin(files[path], made)) for path, made in captured)
    done = {path: _keep(path, repertoire, output) for path, repertoire in captured}
    if report is not None and done:
        written = [(done[path], file) for path, file in files.items() if path in done]
        say(f"{write_report(report, written)}")
    return 0 if len(done) == len(files) else 1


def _check_tuned(files: Mapping[Path, SpeciesFile]) -> None:
    for path, file in files.items():
        if file.swim is None:
            raise Mark(shown(path)).error(f"this species {UNTUNED} {shown(path)}")


def _check_not_filmed(target: Path) -> None:
    """Refuse to replace motion that came from a clip: muscles could not give it back."""
    with suppress(RepertoireError):
        if is_filmed(load(target)):
            raise InputError(
                f"{target}: holds motion from a clip, which a capture would replace: take it away first, or use -o DIR"
            )


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


def _captured(files: Mapping[Path, SpeciesFile]) -> Iterator[tuple[Path, Repertoire]]:
    from tools.capture.capture import capture

    for path, file in files.items():
        title = file.title
        try:
            with progress_bar(title) as report:
                told = partial(_tell, report, title)
                repertoire = capture(body_of(file), swim_of(file), told)
        except (ValueError, ArithmeticError) as error:
            raise InputError(f"{path}: this body does not swim: {error}") from None
        yield path, repertoire


def _with_skin(file: SpeciesFile, repertoire: Repertoire) -> Repertoire:
    """Return the repertoire with control points, having said what they cost."""
    from tools.capture.control_points import memory, with_control_points

    recorded = with_control_points(repertoire, body_of(file))
    plain, more = memory(recorded)
    say(f"{file.title}: {plain + more:,} bytes with control points, {plain:,} without")
    return recorded


def _tell(report: Report, title: str, done: float, what: str) -> None:
    report(done, f"{title}: {what}")


def _keep(path: Path, repertoire: Repertoire, output: Path | None) -> Path:
    """Write the repertoire of the species in `path`, say so and what is wrong with it; return its file."""
    target = _target(path, output)
    with replacing(target) as fresh:
        save(fresh, repertoire)
    for warning in filter(None, repertoire.provenance["warnings"].split("; ")):
        complain(f"{path}: warning: {warning}")
    say(f"{target}")
    return target
