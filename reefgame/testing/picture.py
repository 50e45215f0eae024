"""Pictures of what was seen, as SVG: every fish a spindle where it was, with the way that it came.

o = observe(read_scene(path), seed=0)
svg = sheet([panel(o, t, o.position[t].mean(axis=0), 6.0, "now", place(0), 12)], "A school")
"""

from collections.abc import Sequence
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.mind import Courtship, Intention
from reefgame.testing.observation import Observation

WIDE, HIGH = 230, 230
"""Of a panel, in units of the picture."""
_PAPER, _INK, _FAINT = "#ffffff", "#1f2d38", "#d5dde2"
_CALM, _AFRAID, _COURTED, _LARGE = "#2b7a9b", "#d9622b", "#b5527f", "#30343a"
_SPINDLE: Final = ((0.5, 0.0), (0.28, 0.09), (-0.1, 0.1), (-0.38, 0.03), (-0.5, 0.11))
"""Half the outline of a fish from above, along and aside [BL]."""


def panel(
    o: Observation, t: int, centre: Float64s, metres: float, title: str, at: tuple[int, int],
    tail: int, up: int = 1,
) -> list[str]:  # fmt: skip
    """Return the sample `t`, `metres` wide round `centre` [m], x across and y up, or z for `up` 2."""
    scale = WIDE / metres
    x0, y0 = at
    out = [
        f'<g transform="translate({x0} {y0})">',
        f'<clipPath id="c{x0}_{y0}"><rect width="{WIDE}" height="{HIGH}"/></clipPath>',
        f'<rect width="{WIDE}" height="{HIGH}" fill="#f4f8fa" stroke="{_FAINT}"/>',
        f'<g clip-path="url(#c{x0}_{y0})">',
    ]

    def screen(points: Float64s) -> Float64s:
        flat = (points - centre)[..., [0, up]] * scale
        place: Float64s = flat * [1, -1] + [WIDE / 2, HIGH / 2]
        return place

    for fish in range(len(o.id)):
        if not np.isfinite(o.position[t, fish, 0]):
            continue
        path = screen(o.position[max(t - tail, 0) : t + 1, fish])
        colour = colour_of(o, t, fish)
        out.append(
            f'<path d="{line(path)}" fill="none" stroke="{colour}" stroke-opacity=".35" '
            f'stroke-width="1.2"/>'
        )
        out.append(
            f'<path d="{line(screen(outline(o, t, fish, up)))}Z" fill="{colour}" '
            f'stroke="{colour}" stroke-width=".8"/>'
        )
    bar = scale * (0.5 if metres < 4 else 1.0)
    words = "0.5 m" if metres < 4 else "1 m"
    out += [
        "</g>",
        f'<path d="M10 {HIGH - 12}h{bar:.1f}" stroke="{_INK}" stroke-width="2"/>',
        f'<text x="{14 + bar:.1f}" y="{HIGH - 8}">{words}</text>',
        f'<text x="0" y="-7">{title}</text>',
        "</g>",
    ]
    return out


def colour_of(o: Observation, t: int, fish: int) -> str:
    """Return the colour of a fish: large ones dark, those that flee or fear orange."""
    if o.length[fish] > 0.8:
        return _LARGE
    if o.intention[t, fish] == Intention.ESCAPE or o.fear[t, fish] > 0.5:
        return _AFRAID
    if fish % 2 and (o.courtship[:, fish] != Courtship.NONE).any():
        return _COURTED
    return _CALM


def outline(o: Observation, t: int, fish: int, up: int) -> Float64s:
    """Return the outline [m] of a fish, (9, 3), in the plane of the picture."""
    ahead = o.rotation[t, fish, :, 0]
    aside = np.array([-ahead[1], ahead[0], 0.0]) if up == 1 else np.array([-ahead[2], 0, ahead[0]])
    aside = aside / max(float(np.linalg.norm(aside)), 1e-9)
    half = [*_SPINDLE, *[(along, -wide) for along, wide in reversed(_SPINDLE[1:])]]
    middle = o.position[t, fish] + o.middle[fish] * ahead
    return np.array([middle + o.length[fish] * (a * ahead + w * aside) for a, w in half])


def line(points: Float64s) -> str:
    """Return the points as the data of a path."""
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points)


def sheet(panels: Sequence[Sequence[str]], words: str) -> str:
    """Return panels side by side as a picture; `words` say to those who do not see it what it shows."""
    width = len(panels) * (WIDE + 14) + 6
    body = "\n".join(part for one in panels for part in one)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {HIGH + 34}" '
        f'width="{width}" role="img" font-family="sans-serif" font-size="12" fill="{_INK}">\n'
        f"<title>{words}</title>\n"
        f'<rect width="{width}" height="{HIGH + 34}" fill="{_PAPER}"/>\n{body}\n</svg>\n'
    )


def place(index: int) -> tuple[int, int]:
    """Return where the panel `index` of a sheet lies."""
    return 10 + index * (WIDE + 14), 24
