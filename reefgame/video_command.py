"""`reefgame video`: a clip of a fish becomes a motion, a species, or another body's film (papers/003)."""

import argparse
import re
from pathlib import Path
from typing import Final

from reefgame.console import InputError
from reefgame.puppets import add_target_options

_USUAL_LENGTH: Final = 25.0
"""[cm] of a filmed fish whose length nobody said."""


def add_video(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `reefgame video`."""
    video = commands.add_parser("video", help="take a fish's motion from a clip")
    video.add_argument(
        "clip",
        type=Path,
        metavar="CLIP",
        help="a film of a fish from above; with --species also a .motion",
    )
    video.add_argument("-o", "--output", type=Path, metavar="OUT.motion", help="where it goes")
    rate = video.add_mutually_exclusive_group()
    rate.add_argument(
        "--fps", type=_rate, metavar="N", help="frames a second of the camera, if not the file's"
    )
    rate.add_argument(
        "--hz", type=_rate, metavar="N", help="or: beats of the tail a second, if those are known"
    )
    video.add_argument(
        "--background",
        choices=("median", "mog2", "knn", "vibe"),
        default="median",
        help="how the ground is told from the fish; vibe is patented, see docs/video.md",
    )
    which = video.add_mutually_exclusive_group()
    which.add_argument(
        "--select", type=_place, metavar="X,Y", help="which fish: a pixel that it covers at first"
    )
    which.add_argument("--choose", action="store_true", help="or: click it in a window")
    video.add_argument(
        "--report", type=Path, metavar="DIR", help="a page with a film and figures, index.html"
    )
    video.add_argument(
        "--species", metavar="NAME", help="make a mod NAME of it: the fish as a species, to play"
    )
    video.add_argument(
        "--length-cm",
        type=_length,
        metavar="N",
        help="with --species: how long the fish is, else 25",
    )
    add_target_options(video)
    video.set_defaults(run=_video)


def _length(text: str) -> float:
    from reefgame.filmed import LONGEST, SHORTEST

    if not re.fullmatch(r"[0-9]{1,4}(\.[0-9]+)?", text) or not SHORTEST <= float(text) <= LONGEST:
        raise InputError(
            f"length '{text}': centimetres from {SHORTEST:g} to {LONGEST:g} are expected"
        )
    return float(text)


def _rate(text: str) -> float:
    if not re.fullmatch(r"[0-9]{1,5}(\.[0-9]{1,6})?", text) or not 0.0 < float(text) <= 10_000.0:
        raise InputError(f"rate '{text}': a number over 0, up to 10000, is expected, such as 29.97")
    return float(text)


def _place(text: str) -> tuple[float, float]:
    match = re.fullmatch(r"\s*([0-9]{1,5})\s*,\s*([0-9]{1,5})\s*", text)
    if not match:
        raise InputError(f"place '{text}': two whole pixels are expected, such as 320,200")
    return float(match[1]), float(match[2])


def _video(options: argparse.Namespace) -> int:
    from reefgame.clips import Request, check_installed, film_to_motion

    check_installed()
    from reefgame.filmed import check_species, write_species
    from reefgame.puppets import film_command
    from tools.video.follow import Choices

    _check_together(options)
    if options.species is not None:
        check_species(options.species)
    if options.clip.suffix == ".motion" and options.target is not None:
        return film_command(options)
    if options.clip.suffix == ".motion" and options.species is not None:
        return _species_from_motion(options)
    choices = Choices(options.background, options.select, options.fps, options.hz)
    output = None if options.target is not None else options.output
    request = Request(options.clip, output, options.report)
    if options.choose:
        from reefgame.choosing import choice_by_click

        with choice_by_click() as choose:
            followed = film_to_motion(request, choices, choose)
    else:
        followed = film_to_motion(request, choices)
    motion = followed.assembled.motion
    if options.target is not None:
        return film_command(options, motion)
    if options.species is not None:
        write_species(motion, options.clip, options.species, options.length_cm or _USUAL_LENGTH)
    return 0


def _check_together(options: argparse.Namespace) -> None:
    """Raise InputError for options that do not go together."""
    if options.length_cm is not None and options.species is None:
        raise InputError("--length-cm needs --species")
    if options.species is not None and options.target is not None:
        raise InputError("--species makes a mod, --target a film: ask for one of them")
    if options.clip.suffix == ".motion" and any(
        (options.fps, options.hz, options.select, options.choose, options.report)
    ):
        told = "--fps, --hz, --select, --choose and --report need a clip"
        raise InputError(f"{options.clip}: {told}")


def _species_from_motion(options: argparse.Namespace) -> int:
    from reefgame.filmed import write_species
    from tools.video.motion_file import load

    if options.output is not None:
        raise InputError(f"{options.clip}: -o needs a clip; --species names the folder")
    write_species(load(options.clip), None, options.species, options.length_cm or _USUAL_LENGTH)
    return 0
