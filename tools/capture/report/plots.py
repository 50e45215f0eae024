"""Plots of a report: the envelope of the swim, the wave along the body, heading against time."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.clock import TICKS_PER_SECOND
from components.segment import Segment
from tools.capture.report import ranges
from tools.capture.report.measures import SwimMeasures
from tools.capture.report.replayed import replay
from tools.capture.report.silhouette import STATIONS, Silhouette
from tools.capture.report.svg import Drawing, blend, number

GEARS: Final = (("slow", "#7fb4d6"), ("medium", "#1f6f9f"), ("fast", "#12305a"))
"""Names and colours of the three swims."""
LIVING: Final = "#d9822b"
"""Colour of what living fishes do."""
_GRID: Final = "stroke='#dfe9ed' stroke-width='1'"
_FRAME: Final = "fill='#fbfdfe' stroke='#c4d6de'"
_PHASES: Final = ("#12305a", "#1f6f9f", "#3fb573", "#e0a526", "#c8553d", "#6a3d7c", "#12305a")
_LEFT, _TOP, _RIGHT, _BOTTOM = 46.0, 26.0, 14.0, 36.0
_WAVES: Final = 11


@dataclass(frozen=True)
class Axes:
    """A frame with scales: x from `x0` to `x1`, y from `y0` to `y1`, upwards."""

    sheet: Drawing
    x0: float
    x1: float
    y0: float
    y1: float

    def __call__(self, x: Float64s, y: Float64s) -> Float64s:
        """Return the places on the sheet, (n, 2) [px], of points of the plot."""
        wide, high = self.sheet.width - _LEFT - _RIGHT, self.sheet.height - _TOP - _BOTTOM
        across = _LEFT + wide * (np.asarray(x) - self.x0) / (self.x1 - self.x0)
        down = _TOP + high * (self.y1 - np.asarray(y)) / (self.y1 - self.y0)
        return np.stack(np.broadcast_arrays(across, down), axis=-1)

    def at(self, x: float, y: float) -> tuple[float, float]:
        """Return one place on the sheet [px]."""
        place = self(np.array(x), np.array(y))
        return float(place[0]), float(place[1])


def plot(
    size: tuple[float, float],
    title: str,
    x: tuple[str, Sequence[float]],
    y: tuple[str, Sequence[float]],
    rise: tuple[float, float] | None = None,
) -> Axes:
    """Return an empty plot [px]; x and y are each what is meant and where the scale has its marks.

    y runs over its marks unless `rise` says from where to where.
    """
    sheet = Drawing(*size)
    frame = Axes(sheet, x[1][0], x[1][-1], *(rise or (y[1][0], y[1][-1])))
    (left, low), (right, high) = frame.at(frame.x0, frame.y0), frame.at(frame.x1, frame.y1)
    sheet.box(left, high, right - left, low - high, _FRAME)
    for mark in x[1]:
        at = frame.at(mark, frame.y0)[0]
        sheet.line(at, low, at, high, _GRID)
        sheet.text(at, low + 14, _short(mark), "text-anchor='middle' fill='#6d8794'", 10)
    for mark in y[1]:
        at = frame.at(frame.x0, mark)[1]
        sheet.line(left, at, right, at, _GRID)
        sheet.text(left - 6, at + 3.5, _short(mark), "text-anchor='end' fill='#6d8794'", 10)
    sheet.text(_LEFT, 14, title, "font-weight='600'", 12)
    sheet.text(right, low + 29, x[0], "text-anchor='end'", 10.5)
    sheet.text(right, 14, y[0], "text-anchor='end'", 10.5)
    return frame


def _short(mark: float) -> str:
    text = number(mark, 3)
    return text.replace("0.", ".", 1) if text.startswith(("0.", "-0.")) else text


def envelope(gears: Sequence[SwimMeasures], size: tuple[float, float] = (512.0, 268.0)) -> Drawing:
    """Return how far each station goes to either side in slow, medium and fast, and a living carangiform's."""
    along = np.linspace(0.0, 1.0, STATIONS)
    living = np.array([ranges.envelope(s) for s in along.tolist()])
    most = max(0.1, *(float(g.envelope.max()) for g in gears), 1.25 * float(living.max()))
    frame = plot(
        size,
        "How far the body goes aside",
        ("nose to tail, BL", np.linspace(0.0, 1.0, 6).tolist()),
        ("half amplitude, BL", np.arange(0.0, most, 0.02).tolist()),
        (0.0, most),
    )
    sheet = frame.sheet
    band = np.concatenate((frame(along, 0.75 * living), frame(along, 1.25 * living)[::-1]))
    sheet.polygon(band, f"fill='{LIVING}' fill-opacity='.14'")
    sheet.curve(frame(along, living), f"stroke='{LIVING}' stroke-width='2' stroke-dasharray='6 4'")
    for (_, colour), gear in zip(GEARS, gears, strict=False):
        sheet.curve(frame(along, gear.envelope), f"stroke='{colour}' stroke-width='2.2'")
    names = [(name, colour) for (name, colour), _ in zip(GEARS, gears, strict=False)]
    _legend(sheet, [*names, ("living fish, a quarter either way", LIVING)])
    return sheet


def _legend(sheet: Drawing, names: Sequence[tuple[str, str]]) -> None:
    x, y = _LEFT + 10.0, _TOP + 16.0
    for name, colour in names:
        sheet.line(x, y - 4, x + 18, y - 4, f"stroke='{colour}' stroke-width='2.4'")
        sheet.text(x + 24, y, name, "", 10.5)
        y += 16.0


def midlines(
    drawn: Silhouette, segment: Segment, size: tuple[float, float] = (512.0, 268.0)
) -> Drawing:
    """Return the centre lines of a beat and a quarter, one below the other: the crest that runs rearwards is the wave.

    Dots stand where a centre line crosses the course; aside and along have one scale.
    """
    run = replay(segment, 2)
    period = len(segment.translation)
    frames = np.arange(0, period + period // 4 + 1, max(1, round(period / _WAVES)))
    aside = np.einsum("sn,fn->fs", drawn.middle, run.nodes[:, :, 1])
    along = np.linspace(0.0, 1.0, STATIONS)
    beat = period / TICKS_PER_SECOND
    frame = plot(
        size,
        "The wave along the body, medium",
        ("nose to tail, BL", np.linspace(0.0, 1.0, 6).tolist()),
        ("time downwards, beats", [0.0, -0.25, -0.5, -0.75, -1.0, -1.25]),
        (-1.45, 0.2),
    )
    scale = size[0] - _LEFT - _RIGHT
    for k in frames.tolist():
        time = -k / TICKS_PER_SECOND / beat
        line = frame(along, np.full(STATIONS, time))
        line[:, 1] -= scale * aside[k]
        colour = blend((k % period) / period, _PHASES)
        frame.sheet.curve(line, f"stroke='{colour}' stroke-width='1.6' stroke-opacity='.9'")
        for s in _crossings(aside[k]):
            frame.sheet.dot(*frame.at(s, time), 2.4, f"fill='{colour}'")
    return frame.sheet


def _crossings(aside: Float64s) -> list[float]:
    """Return the stations at which a centre line changes sides, behind the head."""
    found = []
    for k in range(STATIONS // 6, STATIONS - 1):
        a, b = float(aside[k]), float(aside[k + 1])
        if (a < 0.0) != (b < 0.0):
            found.append((k + a / (a - b)) / (STATIONS - 1))
    return found


def overlaid(
    drawn: Silhouette, segment: Segment, size: tuple[float, float] = (1040.0, 268.0)
) -> Drawing:
    """Return the centre lines of a beat over each other, one turn of the colours a beat, to one scale both ways."""
    run = replay(segment)
    period = len(run.nodes)
    middle = np.einsum("sn,fnc->fsc", drawn.middle, run.nodes)
    centre = np.arange(1, period + 1)[:, None] * (run.origin[-1, 0] / period)
    x, y = middle[:, :, 0] - centre, middle[:, :, 1]
    start = float(x.min())
    half = (size[1] - _TOP - _BOTTOM) / (size[0] - _LEFT - _RIGHT) / 2.0
    frame = plot(
        size,
        "Centre lines of a beat, medium",
        ("along the course, BL, head right", [0.0, 0.2, 0.4, 0.6, 0.8, 1.0]),
        ("aside, BL", [-0.1, 0.0, 0.1]),
        (-half, half),
    )
    for k in range(period):
        colour = blend(k / period, _PHASES)
        style = f"stroke='{colour}' stroke-width='1.3' stroke-opacity='.85'"
        frame.sheet.curve(frame(x[k] - start, y[k]), style)
    return frame.sheet


def heading(
    turns: Sequence[tuple[str, str, Segment]],
    stage_one: bool,
    size: tuple[float, float] = (464.0, 300.0),
) -> Drawing:
    """Return heading against time of turns (name, colour, segment); `stage_one` marks what a C-start's is."""
    runs = [replay(segment) for _, _, segment in turns]
    angles = [run.heading() - run.heading()[0] for run in runs]
    longest = max(len(a) for a in angles) / TICKS_PER_SECOND
    low = 20.0 * np.floor(min(float(a.min()) for a in angles) / 20.0)
    high = 20.0 * np.ceil(max(float(a.max()) for a in angles) / 20.0)
    step = 20.0 if high - low <= 140.0 else 40.0
    frame = plot(
        size,
        "Heading of the head",
        ("s", np.arange(0.0, longest + 0.2, 0.2).tolist()),
        ("degrees to the left", np.arange(low, high + step, step).tolist()),
    )
    sheet = frame.sheet
    if stage_one:
        _stage_one(frame)
    for (_, colour, _), angle in zip(turns, angles, strict=True):
        time = np.arange(len(angle)) / TICKS_PER_SECOND
        sheet.curve(frame(time, angle), f"stroke='{colour}' stroke-width='2.2'")
        end = frame.at(float(time[-1]), float(angle[-1]))
        sheet.dot(*end, 3.2, f"fill='{colour}'")
        sheet.text(end[0] + 7, end[1] + 4, f"{angle[-1]:.0f}", f"fill='{colour}'", 11)
    return sheet


def _stage_one(frame: Axes) -> None:
    time, angle = ranges.STAGE_ONE_TIME, ranges.STAGE_ONE_ANGLE
    left, top = frame.at((time.low or 0.0) / 1000.0, min(angle.high or 0.0, frame.y1))
    right, bottom = frame.at((time.high or 0.0) / 1000.0, angle.low or 0.0)
    style = f"fill='{LIVING}' fill-opacity='.35' stroke='{LIVING}'"
    frame.sheet.box(left, top, right - left, bottom - top, style)
    end, low = frame.at(frame.x1, frame.y0)
    words = f"text-anchor='end' fill='{LIVING}'"
    frame.sheet.text(end - 8, low - 8, "box: stage 1 of a living fish of 10 cm", words, 10.5)


def pace(
    turns: Sequence[tuple[str, str, Segment]], size: tuple[float, float] = (464.0, 240.0)
) -> Drawing:
    """Return speed against time of turns (name, colour, segment), a mean over a tenth of a second."""
    runs = [replay(segment) for _, _, segment in turns]
    speeds = [_speed(run.origin) for run in runs]
    most = max(1.0, *(float(s.max()) for s in speeds))
    longest = max(len(s) for s in speeds) / TICKS_PER_SECOND
    step = 0.5 if most <= 3.0 else 1.0
    frame = plot(
        size,
        "Speed of the centre",
        ("s", np.arange(0.0, longest + 0.2, 0.2).tolist()),
        ("BL/s", np.arange(0.0, most + step, step).tolist()),
    )
    for (_, colour, _), speed in zip(turns, speeds, strict=True):
        time = (np.arange(len(speed)) + 0.5) / TICKS_PER_SECOND
        frame.sheet.curve(frame(time, speed), f"stroke='{colour}' stroke-width='2'")
    return frame.sheet


def _speed(origin: Float64s) -> Float64s:
    steps = np.linalg.norm(np.diff(origin, axis=0), axis=1) * TICKS_PER_SECOND
    span = 6
    padded = np.concatenate(
        (np.full(span // 2, steps[0]), steps, np.full(span - span // 2 - 1, steps[-1]))
    )
    mean: Float64s = np.convolve(padded, np.ones(span) / span, mode="valid")
    return mean
