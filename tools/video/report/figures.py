"""Figures of a clip's motion: the kymograph of its midline, the envelope, and the tail's beats."""

from base64 import b64encode
from math import isfinite
from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s
from tools.capture.report.svg import Drawing, number
from tools.video.assembly import Assembled
from tools.video.beats import tail_swing
from tools.video.motion import Motion
from tools.video.report.waves import envelope, sideways

WIDTH: Final = 980.0
_LEFT, _TOP = 56.0, 14.0
_INK: Final = "#1f6f9f"
_BAD: Final = "#d98c1f"
_GRID: Final = "stroke='#d5e4ea' stroke-width='1'"
_MOST_COLUMNS: Final = 2000


def kymograph(motion: Motion, period: float) -> Drawing:
    """Return the midline's sideways place by colour, time to the right and head at the top."""
    wave = sideways(motion, period)
    most = max(float(np.quantile(np.abs(wave), 0.995)), 1e-3)
    height = 210.0
    drawing = _sheet(height)
    wide, tall = WIDTH - _LEFT - 10.0, height - _TOP - 34.0
    picture = b64encode(_coloured(wave / most)).decode()
    drawing.add(
        f"<image x='{number(_LEFT)}' y='{number(_TOP)}' width='{number(wide)}' height='{number(tall)}' "
        f"preserveAspectRatio='none' href='data:image/png;base64,{picture}'/>"
    )
    for k in np.flatnonzero(~motion.good).tolist():
        x = _LEFT + wide * k / motion.count
        drawing.box(x, _TOP + tall + 2, max(wide / motion.count, 1.0), 4, f"fill='{_BAD}'")
    drawing.text(8, _TOP + 12, "head")
    drawing.text(8, _TOP + tall, "tail")
    _seconds(drawing, motion, _TOP + tall)
    told = f"red: to the fish's right, blue: to its left, up to {most:.2f} BL"
    drawing.text(0.5 * WIDTH, _TOP + tall + 20, told, "text-anchor='middle'")
    return drawing


def _coloured(part: Float64s) -> bytes:
    """Return a PNG of -1 to 1: red, white, blue; (n, 41) with n to the right."""
    step = max(1, -(-len(part) // _MOST_COLUMNS))
    kept = np.clip(part[::step].T, -1.0, 1.0)[..., None]
    left, right = np.array([150.0, 80.0, 30.0]), np.array([40.0, 60.0, 200.0])
    ends = np.where(kept > 0.0, left, right)
    bgr = 255.0 + (ends - 255.0) * np.abs(kept)
    return bytes(cv2.imencode(".png", bgr.round().astype(np.uint8))[1])


def envelope_figure(motion: Motion, period: float) -> Drawing:
    """Return half of the sweep along the body."""
    half = envelope(motion, period)
    height = 200.0
    drawing = _sheet(height)
    top = max(0.05, float(half.max()) * 1.1)
    wide, tall = 0.6 * WIDTH - _LEFT, height - _TOP - 34.0
    for tick in np.arange(0.0, top, 0.05).tolist():
        y = _TOP + tall * (1.0 - tick / top)
        drawing.line(_LEFT, y, _LEFT + wide, y, _GRID)
        drawing.text(_LEFT - 6, y + 4, f"{tick:.2f}", "text-anchor='end'")
    s = np.linspace(0.0, 1.0, len(half))
    living = 0.02 - 0.0825 * s + 0.1625 * s**2
    for line, style in (
        (living, "stroke='#9fb4bf' stroke-dasharray='5 4'"),
        (half, f"stroke='{_INK}' stroke-width='2'"),
    ):
        places = np.stack((_LEFT + wide * s, _TOP + tall * (1.0 - np.minimum(line / top, 1.0))), -1)
        drawing.curve(places, style)
    drawing.text(_LEFT, height - 10, "head")
    drawing.text(_LEFT + wide, height - 10, "tail", "text-anchor='end'")
    drawing.text(_LEFT + wide + 16, _TOP + 14, "half of what each place sweeps, BL")
    drawing.text(_LEFT + wide + 16, _TOP + 34, "dashed: living fishes that swim with the tail")
    return drawing


def beats_figure(assembled: Assembled) -> Drawing:
    """Return how the tail tip swings, and the sinusoid that tells its period."""
    motion, beat = assembled.motion, assembled.beat
    swing = tail_swing(motion.axis.astype(np.float64))
    most = max(float(np.abs(swing).max()), 1e-3)
    height = 190.0
    drawing = _sheet(height)
    wide, tall = WIDTH - _LEFT - 10.0, height - _TOP - 34.0
    x = _LEFT + wide * (np.arange(motion.count) + 0.5) / motion.count
    drawing.line(_LEFT, _TOP + tall / 2, _LEFT + wide, _TOP + tall / 2, _GRID)
    for value in (-most, most):
        y = _TOP + tall * (0.5 - 0.5 * value / most)
        drawing.text(_LEFT - 6, y + 4, f"{value:.2f}", "text-anchor='end'")
    drawing.curve(
        np.stack((x, _TOP + tall * (0.5 - 0.5 * swing / most)), -1),
        f"stroke='{_INK}' stroke-width='1.6'",
    )
    bad = ~motion.good
    if bad.any():
        for at, value in zip(x[bad].tolist(), swing[bad].tolist(), strict=True):
            drawing.dot(at, _TOP + tall * (0.5 - 0.5 * value / most), 2.5, f"fill='{_BAD}'")
    if isfinite(beat.period):
        told = f"a beat in {beat.period:.2f} frames, {motion.rate / beat.period:.2f} a second, {beat.beats:.1f} beats"
        drawing.text(0.5 * WIDTH, _TOP + tall + 20, told, "text-anchor='middle'")
    _seconds(drawing, motion, _TOP + tall)
    return drawing


def _seconds(drawing: Drawing, motion: Motion, y: float) -> None:
    """Write when and in which frames a figure begins and ends, under its corners."""
    last = motion.first + motion.count - 1
    drawing.text(_LEFT, y + 20, f"{motion.first / motion.rate:.2f} s, frame {motion.first}")
    drawing.text(
        WIDTH - 10, y + 20, f"{last / motion.rate:.2f} s, frame {last}", "text-anchor='end'"
    )


def _sheet(height: float) -> Drawing:
    drawing = Drawing(WIDTH, height)
    drawing.box(0, 0, WIDTH, height, "fill='#fff'")
    return drawing
