"""The page of a clip's report: one HTML file, its film beside it, and nothing that changes from run to run."""

from collections.abc import Iterable
from html import escape
from itertools import groupby
from math import isfinite
from typing import Final

import numpy as np

from tools.capture.report.style import STYLE
from tools.video.faults import REASONS, Fault
from tools.video.follow import Followed
from tools.video.report.figures import beats_figure, envelope_figure, kymograph

FILM: Final = "film.mp4"
"""Name of the film beside the page."""
_VIDEO: Final = (
    "video { width: 100%; border-radius: 8px; background: #fff; } .bad td { color: #9a2f1c; }"
)
_COLOURS: Final = (
    "Green: the contour from its first harmonics. Red: the axis, smoothed; orange where a frame failed and is bridged. "
    "Blue: pectoral fins. Pink: head and tail."
)
_KYMOGRAPH: Final = (
    "Each column is a frame, each row a place along the body; orange marks bridged frames."
)


def page(followed: Followed) -> str:
    """Return the report of a clip as one HTML page."""
    motion = followed.assembled.motion
    title = f"Motion of {motion.provenance['clip']}"
    return "\n".join(
        [
            "<!DOCTYPE html>",
            "<html lang='en'><head><meta charset='utf-8'>",
            "<meta name='viewport' content='width=device-width, initial-scale=1'>",
            f"<title>{escape(title)}</title><style>{STYLE}{_VIDEO}</style></head><body><main>",
            f"<h1>{escape(title)}</h1><p class='lead'>{escape(_lead(followed))}</p>",
            *(
                f"<p class='warnings'>{escape(_local(note, followed))}</p>"
                for note in followed.notes
            ),
            f"<section><h2>What was seen</h2><video controls loop muted src='{FILM}'></video>",
            f"<p class='caption'>{_COLOURS}</p></section>",
            "<section><h2>The midline over time</h2>",
            kymograph(motion, followed.assembled.beat.period).svg("kymograph of the midline"),
            f"<p class='caption'>{_KYMOGRAPH}</p>",
            "<h3>Envelope</h3>",
            envelope_figure(motion, followed.assembled.beat.period).svg(
                "half of the sweep along the body"
            ),
            "<h3>Beats of the tail</h3>",
            beats_figure(followed.assembled).svg("the tail tip's swing"),
            "</section><section><h2>How it was measured</h2>",
            _table(("", ""), _settings(followed)),
            "<h3>Frames</h3>",
            _table(("frames", "number", "what", "confidence"), _frames(followed)),
            "</section></main></body></html>\n",
        ]
    )


def _lead(followed: Followed) -> str:
    fault, motion, beat = (
        followed.assembled.fault,
        followed.assembled.motion,
        followed.assembled.beat,
    )
    good = int((fault == Fault.NONE).sum())
    told = f"{good} of {len(fault)} frames are good. The fish is {motion.length:.0f} pixels long"
    if isfinite(beat.period):
        told += f" and beats its tail {motion.rate / beat.period:.2f} times a second at {motion.rate:g} frames a second"
    return told + "."


def _local(note: str, followed: Followed) -> str:
    """Return a note without the folder that the clip lies in."""
    path = followed.scene.clip.path
    return note.replace(str(path), path.name)


def _settings(followed: Followed) -> Iterable[tuple[str, ...]]:
    scene, motion = followed.scene, followed.assembled.motion
    harmonics = [f.harmonics for f in followed.features if f.harmonics]
    yield (
        "clip",
        f"{scene.clip.width}x{scene.clip.height}, {scene.survey.count} frames, {scene.clip.codec}",
    )
    yield "frames a second", f"{motion.rate:.4g}, {motion.provenance['rate']}"
    yield "worked at", f"{scene.clip.working[0]}x{scene.clip.working[1]}"
    yield "background", f"{motion.provenance['background']}, {motion.provenance['station']}"
    yield "threshold T", f"{scene.gate:g} grey levels"
    yield "harmonics S", f"{min(harmonics)} to {max(harmonics)}" if harmonics else "none"
    yield "tail", "forked: the middle between its tips" if followed.assembled.forked else "its end"
    explained = followed.assembled.beat.certainty
    yield "the sinusoid explains", f"{100.0 * explained:.0f} % of the tail's swing"


def _frames(followed: Followed) -> Iterable[tuple[str, ...]]:
    """Yield a row for each run of frames with the same fault."""
    motion, fault = followed.assembled.motion, followed.assembled.fault.tolist()
    sure = np.zeros(len(fault))
    sure[motion.first : motion.first + motion.count] = motion.confidence
    for code, run in groupby(range(len(fault)), key=lambda k: fault[k]):
        at = list(run)
        span = f"{at[0]}" if len(at) == 1 else f"{at[0]} to {at[-1]}"
        yield span, str(len(at)), REASONS[Fault(code)], f"{sure[at].mean():.2f}"


def _table(head: Iterable[str], rows: Iterable[tuple[str, ...]]) -> str:
    top = "".join(f"<th>{escape(cell)}</th>" for cell in head)
    body = "".join(
        "<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in rows
    )
    return f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"
