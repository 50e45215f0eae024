"""`reefgame video --target` and `reefgame retouch`: a motion played by another body, and its tuning (papers/003).

Films are H.264 through PyAV, picture sequences PNG; the models are tools/video/retarget's.
"""

import argparse
import shutil
import uuid
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from components.arrays import Float64s
from reefgame.console import InputError, progress_bar, say
from reefgame.output import check_output, replacing, unwritable

if TYPE_CHECKING:
    from tools.video.images import Colour
    from tools.video.motion import Motion
    from tools.video.retarget.target import Target

FILM_RATE: Final = 30.0
"""Frames a second of films and sequences."""
WINDOW: Final = (1120, 760)
INSTEAD: Final = "a motion is edited in Python with tools.video.retouch.session.Session"
"""What to do where there is no window."""
HEADS: Final = ("up", "down", "left", "right")
"""As tools.video.retarget.choose.HEADS, which needs OpenCV."""


def add_target_options(video: argparse.ArgumentParser) -> None:
    """Add to `reefgame video` what makes a film of another body."""
    video.add_argument(
        "--target",
        metavar="MODEL",
        help="film this picture, mesh, model or species; -o is the film, or a folder of PNG",
    )
    _model_options(video)
    video.add_argument(
        "--fins", choices=("turn", "paper"), default="turn", help="with --target: how fins move"
    )
    video.add_argument(
        "--side", action="store_true", help="with --target: it shows its side, keep its back up"
    )


def add_retouch(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `reefgame retouch`."""
    retouch = commands.add_parser("retouch", help="edit a motion by hand in a window")
    retouch.add_argument("motion", type=Path, metavar="MOTION")
    model = retouch.add_mutually_exclusive_group()
    model.add_argument("--species", metavar="NAME", help="the species that plays it")
    model.add_argument("--target", metavar="MODEL", help="or a picture, mesh or model")
    _model_options(retouch)
    retouch.add_argument("--mod", type=Path, action="append", default=[], metavar="DIR")
    retouch.add_argument(
        "-o", "--output", type=Path, metavar="OUT.motion", help="where it is saved"
    )
    retouch.set_defaults(run=run_retouch)


def _model_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--head", choices=HEADS, help="where the model's head points in its picture"
    )
    parser.add_argument("--open", action="store_true", help="take a mesh that has holes")


def target_named(
    name: str, mods: Sequence[Path] = (), head: str | None = None, may_be_open: bool = False
) -> "Target":
    """Return the target that `name` means: a file, a model that ships with the game, or a species.

    Raise FaultError, one line.
    """
    from tools.video.retarget.choose import is_file, shipped, target_from

    if is_file(name):
        return target_from(name, head, may_be_open)
    if Path(name).suffix and Path(name).suffix not in (".yaml", ".yml"):
        raise InputError(f"{name}: no picture (PNG, JPEG, ...), mesh (OBJ, glTF) or species")
    from reefgame.content import load_species
    from reefgame.content.errors import ContentError
    from tools.video.retarget.species import species_target

    try:
        species = load_species(name, mods)
    except ContentError as error:
        if Path(name).suffix:
            raise
        raise InputError(f"{error}; models that are no species: {', '.join(shipped())}") from None
    return species_target(species.name, species.body, species.skin)


def film_target(
    motion: "Motion",
    target: "Target",
    output: Path,
    fins: str = "turn",
    beside: bool = False,
    size: tuple[int, int] = (960, 544),
) -> None:
    """Write a film (.mp4) of the target playing the motion, or a folder of PNG.

    Raise FaultError with nothing half-written.
    """
    from tools.video.retarget.film import frames
    from tools.video.retarget.intermediate import intermediate
    from tools.video.retarget.retarget import Retargeting

    as_film = output.suffix.lower() == ".mp4"
    if not as_film and output.suffix:
        raise InputError(
            f"{output}: a film's name ends in .mp4; a name without an ending is a folder of PNG"
        )
    check_output(output) if as_film else _check_folder(output)
    played = intermediate(motion).at_rate(FILM_RATE)
    retargeting = Retargeting(target, played, "paper" if fins == "paper" else "turn")
    with progress_bar("filming") as report:
        pictures = _reported(frames(retargeting, *size, beside), played.frames, report)
        if as_film:
            from tools.video.writing import write_film

            with replacing(output) as fresh:
                write_film(fresh, pictures, FILM_RATE)
        else:
            _write_sequence(output, pictures)
    say(f"{output}")


def _reported(pictures: "Iterator[Colour]", count: int, report: Any) -> "Iterator[Colour]":
    for number, picture in enumerate(pictures):
        yield picture
        report((number + 1) / count, "filming")


def _check_folder(folder: Path) -> None:
    if folder.is_dir() and any(folder.iterdir()):
        raise InputError(f"{folder}: this folder is not empty")
    check_output(folder.parent / f"{folder.name}.new")


def _write_sequence(folder: Path, pictures: "Iterator[Colour]") -> None:
    """Write pictures as 00001.png and on into a folder that takes its name when it is whole."""
    from systems.view.target import write_png

    fresh = folder.with_name(f".{folder.name}.{uuid.uuid4().hex[:12]}")
    try:
        fresh.mkdir()
        for number, picture in enumerate(pictures, 1):
            write_png(fresh / f"{number:05d}.png", picture)
        if folder.is_dir():
            folder.rmdir()
        fresh.replace(folder)
    except OSError as error:
        raise unwritable(folder, error) from None
    finally:
        shutil.rmtree(fresh, ignore_errors=True)


def film_command(options: argparse.Namespace, motion: "Motion | None" = None) -> int:
    """Run `reefgame video CLIP|MOTION --target MODEL -o FILM`; `motion` is the clip's where it was just taken."""
    from tools.video.motion_file import load

    target = target_named(options.target, getattr(options, "mod", ()), options.head, options.open)
    output = options.output or Path(f"{options.clip.stem}_{target.name.rpartition(':')[2]}.mp4")
    film_target(motion or load(options.clip), target, output, options.fins, options.side)
    return 0


def run_retouch(options: argparse.Namespace) -> int:
    """Run `reefgame retouch`. Raise FaultError, one line."""
    from reefgame.clips import check_installed

    check_installed()
    from tools.video.motion_file import load
    from tools.video.retarget.intermediate import intermediate

    motion = load(options.motion)
    output = options.output or options.motion.with_name(f"{options.motion.stem}_retouched.motion")
    check_output(output)
    name = options.species or options.target or "carp"
    target = target_named(name, options.mod, options.head, options.open)
    played = intermediate(motion)
    from reefgame.window import open_window

    window = open_window(WINDOW, instead=INSTEAD)
    from reefgame.screens.retouch_stage import RetouchStage
    from reefgame.screens.retouch_window import RetouchWindow

    RetouchWindow(window, RetouchStage(played, target), _saver(motion, output)).run()
    return 0


def _saver(motion: "Motion", output: Path) -> Any:
    """Return what writes edited angles into the output file and says so."""
    from tools.video.motion_file import save
    from tools.video.retouch.apply import retouched

    def store(angles: Float64s, edits: int) -> str:
        with replacing(output) as fresh:
            save(fresh, retouched(motion, angles, edits))
        return f"saved: {output}"

    return store
