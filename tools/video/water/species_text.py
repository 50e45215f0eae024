"""The text of a filmed species' files: every number with where it came from, so that its owner can change it."""

from components.body import Body, Fin, Swim
from tools.video.water.colours import Colour, Colours


def species_text(
    title: str, size_cm: float, body: Body, swim: Swim, colours: Colours, source: str
) -> str:
    """Return the YAML of a species file."""
    return "\n".join(
        [
            f"# {title}, filmed: its beats, its outline from above and what colours there were come from a clip.",
            "# What is marked `assumed` the clip could not show: change it as you know better. The filmed motion lies",
            "# in repertoires/, fits itself to the body that stands here, and stays.",
            "",
            f"title: {_quoted(title)}",
            "role: pacifist                # prey, predator or pacifist",
            f"size_cm: {size_cm:g}                   # nose to tail tip, as --length-cm said",
            "size_spread_percent: 10",
            f"sight_m: {min(max(0.2 * size_cm, 2.0), 20.0):g}",
            "depth_m: [1, 14]",
            "school: {joins: true, spacing_bl: 1.3}",
            "",
            f"# Widths were measured in {_printable(source)}.",
            *_body_lines(body),
            "",
            *_fin_lines(body),
            "",
            "# Muscles that swim this body much as it was filmed; what the clip did not show is captured with them.",
            "swim:",
            f"  contraction_middle: {swim.contraction_middle}",
            f"  contraction_rear: {swim.contraction_rear}",
            f"  lag_deg: {swim.lag_deg}",
            f"  frequency_hz: {swim.frequency_hz}",
            "",
            "mind: {curiosity: 0.5}",
            "",
            *_skin_lines(colours),
            "",
        ]
    )


def mod_text(name: str, title: str) -> str:
    """Return the YAML of the mod's head."""
    return "\n".join(
        [
            "# A mod: this folder. Play it with `reefgame play first_dive --mod FOLDER`.",
            f"id: {name}",
            f"title: {_quoted(title)}",
            'version: "1.0"',
            'game: ">=0.1"',
            f"about: {_quoted(f'{title}, from a clip.')}",
            "",
        ]
    )


def level_text(name: str, count: int = 8) -> str:
    """Return the YAML that puts a group of the species before the submarine in first_dive."""
    return "\n".join(
        [
            "# A group of this fish in first_dive, ahead of where the submarine starts, beside all that live there.",
            "overrides: first_dive",
            "more_fishes:",
            f"  - {{species: {name}, count: {count}, around_m: [-21.0, -0.4, -9.6], within_m: 0.8}}",
            "",
        ]
    )


def _body_lines(body: Body) -> list[str]:
    return [
        "body:",
        f"  at_bl: {_row(body.station)}",
        f"  half_width_bl: {_row(body.half_width)}",
        f"  half_height_bl: {_row(body.half_height)}   # assumed",
        f"  stiffness: {body.stiffness}",
    ]


def _fin_lines(body: Body) -> list[str]:
    return [
        "fins:                         # assumed",
        f"  tail: {{half_span_bl: {body.tail_span}, fork_bl: {body.tail_fork}}}",
        *(
            f"  {name}: {_fin(fin)}"
            for name, fin in (("dorsal", body.dorsal), ("anal", body.anal))
            if fin
        ),
        f"  pectoral: {{at_bl: {body.pectoral_at}, length_bl: {body.pectoral_length}, height: {body.pectoral_height}}}",
    ]


def _fin(fin: Fin) -> str:
    return (
        f"{{from_bl: {fin.start}, to_bl: {fin.end}, height_bl: {fin.height}, lean_bl: {fin.lean}}}"
    )


def _skin_lines(colours: Colours) -> list[str]:
    shades = (colours.belly, _between(colours.belly, colours.flank), colours.flank, colours.back)
    told = "# Colours are assumed: there were none to see." if colours.assumed else ""
    lines = [
        told or "# Back and flanks have the clip's colours; the belly is assumed lighter.",
        "skin:",
        "  layers:",
        f"    - {{paint: gradient, colours: {_hexes(shades)}, at: [-1.0, -0.5, 0.15, 0.8]}}",
    ]
    if colours.bars:
        width = sum(wide for _, wide in colours.bars) / len(colours.bars)
        places = ", ".join(f"{at}" for at, _ in colours.bars)
        lines.append(
            f"    - {{paint: stripes, at: [{places}], width: {max(width, 0.01):.3f}, softness: 0.03, "
            f'colour: "{_hex(colours.bar)}", reach: [-0.5, 1.0]}}'
        )
    return [
        *lines,
        "    - {paint: scales, size: 0.018, strength: 0.3}",
        f'  fins: "{_hex(_between(colours.flank, colours.tail))}"',
        "  fins_opacity: 0.6",
        f'  tail: "{_hex(colours.tail)}"',
        "  shine: 0.5",
    ]


def _row(numbers: tuple[float, ...]) -> str:
    return "[" + ", ".join(f"{n}" for n in numbers) + "]"


def _hex(colour: Colour) -> str:
    return "#" + "".join(f"{part:02x}" for part in colour)


def _hexes(colours: tuple[Colour, ...]) -> str:
    return "[" + ", ".join(f'"{_hex(c)}"' for c in colours) + "]"


def _between(one: Colour, other: Colour) -> Colour:
    red, green, blue = ((a + b) // 2 for a, b in zip(one, other, strict=True))
    return red, green, blue


def _printable(text: str) -> str:
    """Return a file's name as a comment can hold it."""
    return "".join(c if c.isascii() and c.isprintable() else "?" for c in text)[:80]


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
