"""Follows one fish through a clip in two passes and bounded memory: mask, features, motion (papers/003, 3.1).

One thread decodes and finds the mask, which OpenCV does without Python's lock; another takes the features of the frame
before.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import chain, islice
from math import isfinite
from pathlib import Path
from queue import Queue
from threading import Event, Thread
from typing import Final, NamedTuple

import cv2
import numpy as np

from components.arrays import Float64s
from tools.video.assembly import Assembled, assemble
from tools.video.background import MODELS, clean_plate, model_of, threshold
from tools.video.faults import REASONS, Fault
from tools.video.features import Features, features_of
from tools.video.images import ClipError, Grey
from tools.video.mask import Segmenter, Sighting
from tools.video.orientation import first_heading
from tools.video.reading import Clip
from tools.video.survey import Survey, survey

_AHEAD: Final = 16
"""Frames that may wait between the two threads."""
_VOTES: Final = 15
"""Frames that say together where the head is."""
_LOST: Final = 10
"""Frames without a fish after which the head is looked for anew."""
_SHADED: Final = 1.15
"""Growth of the fish's area, where all that differs weakly is let in, from which that is shadow and no fin."""
_ROUNDED: Final = 1
"""Frames by which a header may err that tells seconds alone."""
_LIKE_A_FISH: Final = 1.0 / 3.0
"""Of the frames that show it whole: in so many at least, what moves has the shape of a fish, or is none."""
_SURVEYED: Final = 0.35
"""Part of the work that the first pass is."""

Report = Callable[[float, str], None]
Choose = Callable[["Scene"], tuple[float, float] | None]
"""Says, once the first pass is over, where the fish is when it is first seen [px]; None leaves it at the largest."""


def quiet(done: float, what: str) -> None:
    """Report nothing."""


@dataclass(frozen=True)
class Choices:
    """What the user may choose."""

    background: str = MODELS[0]
    select: tuple[float, float] | None = None
    "a place [px] that the fish covers when it is first seen"
    rate: float | None = None
    "frames a second of the camera; the file's own where None"
    beats: float | None = None
    "tail beats a second, from which the camera's rate follows"


@dataclass(frozen=True)
class Scene:
    """What the first pass tells the second."""

    clip: Clip
    survey: Survey
    plate: Grey
    gate: float
    "T [grey levels]"
    painted: bool
    "whether a fish that holds station was painted out of the plate"
    usual_area: float
    "[px] of the fish"
    wary: bool
    "whether shadows are about: see `Segmenter.wary`"


@dataclass(frozen=True)
class Followed:
    """A clip's motion and what there is to tell about it."""

    scene: Scene
    features: list[Features]
    "of every frame"
    assembled: Assembled
    notes: tuple[str, ...]
    "a line about each thing that the user should know"


class _Seen(NamedTuple):
    sighting: Sighting | None
    fault: Fault


def follow(
    path: Path,
    choices: Choices | None = None,
    report: Report = quiet,
    choose: Choose | None = None,
) -> Followed:
    """Return the motion of the fish in a clip. Raise ClipError, one line, where there is none."""
    threads = cv2.getNumThreads()
    # The two threads here keep two processors busy; OpenCV's own would only get in their way.
    cv2.setNumThreads(1)
    try:
        return _follow(path, choices or Choices(), report, choose)
    finally:
        cv2.setNumThreads(threads)


def _follow(path: Path, chosen: Choices, report: Report, choose: Choose | None) -> Followed:
    scene = look(Clip(path), chosen, lambda done: report(_SURVEYED * done, "looking at the clip"))
    place = None if choose is None else choose(scene)
    if place is not None:
        chosen = replace(chosen, select=place)
        scene = _aimed(scene, _checked(scene.clip, place))
    features = []
    for found in frame_by_frame(scene, chosen):
        features.append(found)
        share = len(features) / scene.survey.count
        report(_SURVEYED + (1.0 - _SURVEYED) * share, f"frame {len(features)}")
    clip = scene.clip
    rate = camera_rate(scene, chosen)
    size = (clip.width, clip.height)
    assembled = assemble(features, rate, size, clip.scale, provenance(scene, chosen))
    if assembled is None:
        raise ClipError(_no_fish(scene, features))
    _check_shape(scene, assembled)
    if chosen.beats is not None:
        assembled = _timed(assembled, chosen.beats)
    return Followed(scene, features, assembled, tuple(_notes(scene, assembled, chosen)))


def look(clip: Clip, choices: Choices, report: Callable[[float], None]) -> Scene:
    """Return what the first pass over a clip tells. Raise ClipError where no fish is seen."""
    found = survey(clip, report)
    plate, painted = clean_plate(found.samples)
    gate = threshold(found.samples, plate)
    scene = Scene(clip, found, plate, gate, painted, usual_area=0.0, wary=True)
    return _aimed(scene, _checked(clip, choices.select))


def _aimed(scene: Scene, select: tuple[float, float] | None) -> Scene:
    """Return the scene with the size of the fish at `select` [working px]. Raise ClipError where no fish is seen."""
    narrow, wide = (_areas(scene, select, wary) for wary in (True, False))
    if not np.isfinite(narrow).any():
        told = f"frame {scene.survey.first}: no fish is seen: nothing large moves"
        raise ClipError(f"{scene.clip.path}: {told}")
    both = np.isfinite(narrow) & np.isfinite(wide)
    wary = not both.any() or float(np.median(wide[both] / narrow[both])) > _SHADED
    return replace(scene, usual_area=float(np.nanmedian(narrow if wary else wide)), wary=wary)


def _areas(scene: Scene, select: tuple[float, float] | None, wary: bool) -> Float64s:
    """Return the area of the fish in each sample [px], nan where none is seen, (n,)."""
    finder = Segmenter(scene.plate, scene.gate, model_of("median", scene.plate))
    finder.select, finder.wary = select, wary
    samples = scene.survey.samples
    seen = [finder.find(sample) for sample in samples] if scene.gate > 0.0 else []
    return np.array([np.nan if one is None else one.area for one in seen])


def _checked(clip: Clip, select: tuple[float, float] | None) -> tuple[float, float] | None:
    """Return a chosen place at the working size. Raise ClipError where it lies outside the picture."""
    if select is None:
        return None
    if not (0 <= select[0] < clip.width and 0 <= select[1] < clip.height):
        size = f"{clip.width}x{clip.height}"
        raise ClipError(f"{clip.path}: place {select[0]:g},{select[1]:g} lies outside its {size}")
    return select[0] * clip.scale, select[1] * clip.scale


def frame_by_frame(scene: Scene, choices: Choices) -> Iterator[Features]:
    """Yield the features of every frame of a clip in order."""
    frames = _ahead(_sightings(scene, choices))
    waiting: list[_Seen] = []
    votes: list[Sighting] = []
    for seen in frames:
        waiting.append(seen)
        if seen.sighting is not None and not seen.fault:
            votes.append(seen.sighting)
        if len(votes) == _VOTES or len(waiting) > 8 * _VOTES:
            break
    heading = first_heading(votes) if votes else None
    lost = 0
    for seen in chain(waiting, frames):
        if seen.sighting is None or seen.fault:
            lost += 1
            yield Features(seen.fault)
            continue
        found = features_of(seen.sighting, None if lost > _LOST else heading)
        heading, lost = (heading if found.ahead is None else found.ahead), 0
        yield found


def _sightings(scene: Scene, choices: Choices) -> Iterator[_Seen]:
    segmenter = Segmenter(scene.plate, scene.gate, model_of(choices.background, scene.plate))
    segmenter.usual_area, segmenter.wary = scene.usual_area, scene.wary
    segmenter.select = _checked(scene.clip, choices.select)
    for frame in islice(scene.clip.frames(), scene.survey.count):
        if not scene.survey.first <= frame.number < scene.survey.stop:
            yield _Seen(None, Fault.CUT)
        elif frame.grey is None:
            yield _Seen(None, Fault.DAMAGED)
        else:
            sighting = segmenter.find(frame.grey)
            yield _Seen(sighting, segmenter.fault(sighting))


def _ahead(items: Iterator[_Seen]) -> Iterator[_Seen]:
    """Yield items that another thread makes a few ahead; what it raises is raised here."""
    queue: Queue[_Seen | BaseException | None] = Queue(_AHEAD)
    over = Event()

    def make() -> None:
        try:
            for item in items:
                if over.is_set():
                    return
                queue.put(item)
            queue.put(None)
        except BaseException as error:  # noqa: BLE001 (handed to the other thread)
            queue.put(error)

    thread = Thread(target=make, daemon=True)
    thread.start()
    try:
        while (item := queue.get()) is not None:
            if isinstance(item, BaseException):
                raise item
            yield item
    finally:
        over.set()
        while thread.is_alive():
            while not queue.empty():
                queue.get_nowait()
            thread.join(0.01)


def camera_rate(scene: Scene, choices: Choices) -> float:
    """Return frames a second: what the user says, else the frames' own times, else the header's, else 30."""
    if choices.rate is not None:
        return choices.rate
    return scene.survey.rate or scene.clip.rate or 30.0


def provenance(scene: Scene, choices: Choices) -> dict[str, str]:
    """Return how a motion is made, in words that hold no folder and no date."""
    return {
        "tool": "reefgame video",
        "clip": scene.clip.path.name,
        "codec": scene.clip.codec,
        "background": choices.background,
        "threshold": f"{scene.gate:g}",
        "station": "painted out" if scene.painted else "moves",
        "rate": "given" if choices.rate or choices.beats else "of the file",
    }


def _timed(assembled: Assembled, beats: float) -> Assembled:
    """Return the motion at the rate at which its tail beats so often a second. Raise ClipError where it beats not."""
    period = assembled.beat.period
    if not isfinite(period):
        clip = assembled.motion.provenance["clip"]
        raise ClipError(f"{clip}: the tail does not beat in it, so --hz says nothing; give --fps")
    return replace(assembled, motion=replace(assembled.motion, rate=beats * period))


def _check_shape(scene: Scene, assembled: Assembled) -> None:
    """Raise ClipError where what moves is no fish, as a hand is not: few of the frames that show it whole are good."""
    odd = np.flatnonzero(assembled.fault >= Fault.ROUND)
    seen = len(odd) + np.count_nonzero(assembled.fault == Fault.NONE)
    if seen - len(odd) >= _LIKE_A_FISH * seen:
        return
    reason = REASONS[Fault(int(assembled.fault[odd[0]]))]
    told = (
        f"what moves is no fish in {len(odd)} of {seen} frames; no motion can be made of this clip"
    )
    raise ClipError(f"{scene.clip.path}: frame {odd[0]}: {reason}; {told}")


def _no_fish(scene: Scene, features: list[Features]) -> str:
    """Return the line about a clip in which too few frames show a whole fish."""
    faults = [found.fault for found in features if found.fault and found.fault != Fault.CUT]
    usual = max(set(faults), key=faults.count) if faults else Fault.NO_FISH
    first = next((k for k, found in enumerate(features) if found.fault == usual), 0)
    return f"{scene.clip.path}: frame {first}: {REASONS[usual]}; no motion can be made of this clip"


def _notes(scene: Scene, assembled: Assembled, choices: Choices) -> Iterator[str]:
    path, found = scene.clip.path, scene.survey
    if scene.clip.expected > found.count + _ROUNDED:
        yield f"{path}: frame {found.count}: the file ends, but its header says {scene.clip.expected} frames"
    for cut in found.cuts:
        yield f"{path}: frame {cut}: the film is cut here; frames {found.first} to {found.stop - 1} are taken"
    for fault in sorted(set(assembled.fault.tolist()) - {Fault.NONE, Fault.CUT}):
        at = np.flatnonzero(assembled.fault == fault)
        more = f" (and {len(at) - 1} more)" if len(at) > 1 else ""
        yield f"{path}: frame {at[0]}{more}: {REASONS[Fault(fault)]}; bridged"
    if choices.background in ("mog2", "knn") and scene.painted:
        yield f"{path}: --background {choices.background} learns a fish that holds station as ground; try median"
