"""`reefgame video`: from a clip of a fish to a motion file, and a page about it (papers/003; DESIGN 8)."""

from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from components.whole_file import write_whole
from reefgame.console import InputError, Report, complain, progress_bar, say
from reefgame.output import check_output, replacing, unwritable

if TYPE_CHECKING:
    from tools.video.follow import Choices, Choose, Followed

PAGE = "index.html"


@dataclass(frozen=True)
class Request:
    """What the command line asks for."""

    clip: Path
    output: Path | None = None
    "where the motion goes; CLIP's name and .motion in this folder where None"
    report: Path | None = None
    "folder of the page, none where None"


def film_to_motion(
    request: Request, choices: "Choices", choose: "Choose | None" = None
) -> "Followed":
    """Follow the fish in a clip, write its motion and, if asked, the page; return what was found.

    `choose` says which fish it is once the clip has been looked at.

    Raise FaultError, one line, with nothing half-written.
    """
    from tools.video.follow import follow
    from tools.video.motion_file import save

    target = request.output or Path(f"{request.clip.stem}.motion")
    check_output(target)
    if request.report is not None:
        _prepare(request.report)
    with progress_bar(request.clip.name) as report:
        followed = follow(request.clip, choices, report, choose)
        with replacing(target) as fresh:
            save(fresh, followed.assembled.motion)
        if request.report is not None:
            _write_report(followed, request.report, report)
    for note in followed.notes:
        complain(note)
    say(_summary(followed))
    say(f"{target}")
    if request.report is not None:
        say(f"{request.report / PAGE}")
    return followed


def check_installed() -> None:
    """Raise InputError where the extra [video] is not installed."""
    for module in ("cv2", "av"):
        try:
            import_module(module)
        except ImportError:
            raise InputError("clips need OpenCV and PyAV: pip install 'reefgame[video]'") from None


def _prepare(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise unwritable(folder, error) from None
    check_output(folder / PAGE)


def _write_report(followed: "Followed", folder: Path, report: Report) -> None:
    from tools.video.report.overlay import overlaid
    from tools.video.report.page import FILM, page
    from tools.video.writing import write_film

    report(1.0, "drawing the film")
    rate = min(followed.assembled.motion.rate, 30.0)
    with replacing(folder / FILM) as fresh:
        write_film(fresh, overlaid(followed), rate)
    with replacing(folder / PAGE) as fresh:
        write_whole(fresh, page(followed).encode())


def _summary(followed: "Followed") -> str:
    motion, beat = followed.assembled.motion, followed.assembled.beat
    good = int((followed.assembled.fault == 0).sum())
    told = f"{good} of {len(followed.features)} frames are good, the fish is {motion.length:.0f} pixels long"
    if beat.certainty > 0.0:
        told += f", a beat takes {beat.period:.1f} frames: {motion.rate / beat.period:.2f} a second"
    return told
