"""`reefgame video --species NAME`: a mod with a playable species, made of a filmed motion (papers/003; 000, 9.1).

The mod is a folder NAME: the species, its repertoire, and a group of it in first_dive. It is built beside its place and
moved there, so that no half of it is ever seen, and replaces nothing.
"""

import shutil
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from components.fault import FaultError
from components.repertoire_file import save
from reefgame.console import InputError, Report, complain, progress_bar, say
from reefgame.content.mods import BASE, name_problem
from reefgame.output import unwritable

if TYPE_CHECKING:
    from tools.video.motion import Motion
    from tools.video.water.colours import Colours
    from tools.video.water.film import Film
    from tools.video.water.species import FilmedSpecies

SHORTEST, LONGEST = 1.0, 2000.0
"""[cm] of a fish."""

_BEATS = 1.6
"""Beats a second of a fish of one metre that cruises; they go with the root of its length (FINDINGS 1b, the nine)."""

_FAR = 3.0
"""Times more or fewer beats than usual that are believed."""


def check_species(name: str, folder: Path = Path()) -> None:
    """Raise InputError, one line, where no mod `name` can be made in `folder`."""
    fault = name_problem(name)
    if fault is None and name == BASE:
        fault = f"the name '{BASE}' is the base game's own: choose another"
    if fault:
        raise InputError(f"--species: {fault}")
    target = folder / name
    if target.exists() or target.is_symlink():
        raise InputError(f"{target}: this is already there: choose another name, or take it away")
    if not folder.is_dir():
        raise InputError(f"{folder}: there is no such folder")


def write_species(
    motion: "Motion", clip: Path | None, name: str, length_cm: float, folder: Path = Path()
) -> Path:
    """Make the mod `name` of a motion in `folder`; with `clip`'s colours, where it is given. Return its folder.

    Raise FaultError, one line, with nothing left behind.
    """
    from tools.video.water.film import film_of
    from tools.video.water.species import species_of

    check_species(name, folder)
    source = motion.provenance.get("clip", name) if clip is None else clip.name
    film = film_of(motion)
    with progress_bar(name) as report:
        try:
            made = species_of(
                film, source, lambda done, what: report(0.9 * done, f"{name}: {what}")
            )
        except FaultError as error:
            raise InputError(f"{clip or name}: no species: {error}") from None
        colours = _colours(film, motion, clip, report)
        target = _written(_texts(name, length_cm, made, colours, source), made, folder / name)
    _tell(made, colours, target)
    _doubt(made.cruise.frequency, length_cm)
    return target


def _colours(film: "Film", motion: "Motion", clip: Path | None, report: Report) -> "Colours":
    from tools.video.reading import Clip
    from tools.video.water.colours import ASSUMED, chosen, colours_of

    if clip is None:
        return ASSUMED
    report(0.92, "colours")
    opened = Clip(clip)
    wanted = [row + motion.first for row in chosen(film)]
    pictures = ((number - motion.first, picture) for number, picture in _pictures(opened, wanted))
    return colours_of(pictures, film, opened.scale)


def _pictures(clip: Any, wanted: list[int]) -> Iterator[tuple[int, Any]]:
    """Yield the pictures of some frames."""
    numbers, last = set(wanted), max(wanted)
    for frame in clip.frames(colour=True):
        if frame.number in numbers and frame.colour is not None:
            yield frame.number, frame.colour
        if frame.number >= last:
            return


def _texts(
    name: str, length_cm: float, made: "FilmedSpecies", colours: "Colours", source: str
) -> dict[str, str]:
    from tools.video.water.species_text import level_text, mod_text, species_text

    title = name.replace("_", " ").capitalize()
    species = species_text(title, length_cm, made.body, made.swim, colours, source)
    return {
        "mod.yaml": mod_text(name, title),
        f"species/{name}.yaml": species,
        "levels/first_dive.yaml": level_text(name),
    }


def _written(texts: Mapping[str, str], made: "FilmedSpecies", target: Path) -> Path:
    """Build the mod beside its place and move it there."""
    try:
        draft = Path(tempfile.mkdtemp(prefix=".new-", dir=target.parent))
    except OSError as error:
        raise unwritable(target, error) from None
    try:
        draft.chmod(0o755)
        for place, text in texts.items():
            (draft / place).parent.mkdir(exist_ok=True)
            (draft / place).write_text(text, encoding="utf-8", newline="\n")
        (draft / "repertoires").mkdir()
        save(draft / "repertoires" / f"{target.name}.npz", made.repertoire)
        draft.rename(target)
    except OSError as error:
        raise unwritable(target, error) from None
    finally:
        shutil.rmtree(draft, ignore_errors=True)
    return target


def _tell(made: "FilmedSpecies", colours: "Colours", target: Path) -> None:
    for line in made.said:
        say(line)
    if colours.assumed:
        say("assumed: its colours, of which there are none to see")
    for warning in filter(None, made.repertoire.provenance["warnings"].split("; ")):
        complain(f"{target.name}: warning: {warning}")
    say(f"{target}: play it with: reefgame play first_dive --mod {target}")


def _doubt(frequency: float, length_cm: float) -> None:
    """Say so where a fish of this length hardly beats its tail so often: films often hide their camera's rate."""
    usual = _BEATS / (length_cm / 100.0) ** 0.5
    if not usual / _FAR <= frequency <= usual * _FAR:
        complain(
            f"warning: {frequency:.2f} beats a second are odd for a fish of {length_cm:g} cm, about {usual:.1f} are "
            "usual: if the file does not hold the camera's rate, say --fps or --hz"
        )
