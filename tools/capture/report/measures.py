"""What a repertoire shows in numbers, taken from its entries alone: swims, turns and fast starts."""

from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.clock import TICKS_PER_SECOND
from components.segment import Pattern, heading_change, mean_speed
from tools.capture.bend import largest_joint
from tools.capture.report.replayed import Replayed, replay
from tools.capture.report.silhouette import STATIONS, Silhouette
from tools.capture.report.subject import Subject

SWIMS: Final = (Pattern.SWIM_SLOW, Pattern.SWIM_MEDIUM, Pattern.SWIM_FAST)
TURNS: Final = (Pattern.TURN_LEFT, Pattern.TURN_SHARP_LEFT)
_WAVE_FROM: Final = 16
"""Station from which the wave's length is taken: in front of it the body hardly bends."""
_STARTED: Final = 10.0
_BEATS: Final = 1000


@dataclass(frozen=True)
class SwimMeasures:
    """A beat in numbers."""

    speed: float
    "[BL/s]"
    frequency: float
    "[Hz]"
    stride: float
    "way made in a beat [BL]"
    strouhal: float
    sweep: float
    "of the tail from side to side [BL]"
    head: float
    "sweep of the nose over the tail's"
    wavelength: float
    "of the body wave over the rear body [BL]"
    backward: bool
    "whether the wave runs from head to tail"
    joint: float
    "sharpest angle between neighbouring parts of the centre line [degrees]"
    closure: float | None
    "change of shape over the cycle as captured [BL], None where the repertoire does not say"
    drift: float
    "turn of the course over 1,000 beats [degrees]"
    pitch: float
    "largest angle of the anterior axis above or below the level [degrees]"
    envelope: Float64s
    "half of what each station sweeps [BL], (41,)"


@dataclass(frozen=True)
class TurnMeasures:
    """A turn or a fast start in numbers."""

    net: float
    "change of the mean heading [degrees], left positive"
    seconds: float
    joint: float
    "sharpest angle between neighbouring parts of the centre line [degrees]"
    fastest: float
    "largest rate of turning over a frame [degrees/s]"
    speed: float
    "at the end, over the last tenth of a second [BL/s]"
    first_stroke: tuple[float, float]
    "when the head turns back for the first time [s], and how far it had turned [degrees]"
    pitch: float
    "largest angle of the anterior axis above or below the level [degrees]"


def measure_swim(subject: Subject, drawn: Silhouette, pattern: Pattern) -> SwimMeasures | None:
    """Return the figures of a swim, None where the repertoire has none."""
    segment = subject.segment(pattern)
    if segment is None:
        return None
    run = replay(segment)
    aside = run.nodes[:, :, 1]
    tail = np.ptp(0.5 * (aside[:, 21] + aside[:, 22]))
    frequency, speed = TICKS_PER_SECOND / len(aside), mean_speed(segment)
    way = np.einsum("sn,fn->fs", drawn.middle, aside)
    wavelength, backward = _wave(way)
    return SwimMeasures(
        speed=speed,
        frequency=frequency,
        stride=speed / frequency,
        strouhal=float(frequency * tail / speed) if speed > 0.0 else float("inf"),
        sweep=float(tail),
        head=float(np.ptp(aside[:, 0]) / max(tail, 1e-9)),
        wavelength=wavelength,
        backward=backward,
        joint=float(np.degrees(largest_joint(run.nodes))),
        closure=subject.noted(pattern, "closure"),
        drift=abs(float(run.heading()[-1] - run.heading()[0])) * _BEATS,
        pitch=float(np.abs(run.pitch()).max()),
        envelope=0.5 * np.ptp(way, axis=0),
    )


def _wave(way: Float64s) -> tuple[float, bool]:
    """Return length [BL] and direction of the wave in stations' places aside (F, 41): its phase along the body."""
    beat = np.exp(-2j * np.pi * np.arange(1, len(way) + 1) / len(way))
    phase = np.unwrap(np.angle(beat @ way))[_WAVE_FROM:]
    along = np.linspace(0.0, 1.0, STATIONS)[_WAVE_FROM:]
    slope = float(np.polyfit(along, phase, 1)[0])
    return float(2.0 * np.pi / max(abs(slope), 1e-9)), slope < 0.0


def measure_turn(subject: Subject, pattern: Pattern) -> TurnMeasures | None:
    """Return the figures of a turn or a fast start to the left, None where the repertoire has none."""
    segment = subject.segment(pattern)
    if segment is None:
        return None
    run, noted = replay(segment), subject.noted(pattern, "turn")
    heading = run.heading() - run.heading()[0]
    last = min(6, len(run.nodes))
    way = float(np.linalg.norm(run.origin[-1] - run.origin[-1 - last]))
    return TurnMeasures(
        net=float(np.degrees(heading_change(segment))) if noted is None else noted,
        seconds=len(run.nodes) / TICKS_PER_SECOND,
        joint=float(np.degrees(largest_joint(run.nodes))),
        fastest=float(np.diff(heading).max() * TICKS_PER_SECOND),
        speed=way * TICKS_PER_SECOND / last,
        first_stroke=_first_stroke(run),
        pitch=float(np.abs(run.pitch()).max()),
    )


def _first_stroke(run: Replayed) -> tuple[float, float]:
    heading = run.heading() - run.heading()[0]
    for frame in range(1, len(heading) - 1):
        if heading[frame] > _STARTED and heading[frame + 1] < heading[frame]:
            return frame / TICKS_PER_SECOND, float(heading[frame])
    return (len(heading) - 1) / TICKS_PER_SECOND, float(heading[-1])
