"""A small writer of SVG: shapes by functions, numbers in tenths of a pixel, the same bytes for the same drawing."""

from collections.abc import Iterable, Sequence
from html import escape

from components.arrays import Float64s

FONT = "font-family='Inter,Segoe UI,Helvetica,Arial,sans-serif'"


def number(value: float, digits: int = 1) -> str:
    """Return a number as short as it gets at so many digits, never "-0"."""
    text = f"{value:.{digits}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def points(places: Float64s) -> str:
    """Return places (n, 2) [px] as SVG writes them."""
    return " ".join(f"{number(x)},{number(y)}" for x, y in places.tolist())


class Drawing:
    """Shapes in the order drawn, on a sheet of `width` x `height` [px], y downwards."""

    def __init__(self, width: float, height: float) -> None:
        """Begin an empty drawing."""
        self.width, self.height = width, height
        self._parts: list[str] = []

    def add(self, element: str) -> None:
        """Add an SVG element as it is."""
        self._parts.append(element)

    def polygon(self, places: Float64s, style: str) -> None:
        """Add a closed shape through places (n, 2)."""
        self.add(f"<polygon points='{points(places)}' {style}/>")

    def curve(self, places: Float64s, style: str) -> None:
        """Add an open line through places (n, 2)."""
        self.add(f"<polyline points='{points(places)}' fill='none' {style}/>")

    def line(self, x0: float, y0: float, x1: float, y1: float, style: str) -> None:
        """Add a straight line."""
        ends = " ".join(
            f"{name}='{number(v)}'"
            for name, v in zip(("x1", "y1", "x2", "y2"), (x0, y0, x1, y1), strict=True)
        )
        self.add(f"<line {ends} {style}/>")

    def box(self, x: float, y: float, width: float, height: float, style: str) -> None:
        """Add a rectangle."""
        place = f"x='{number(x)}' y='{number(y)}' width='{number(width)}' height='{number(height)}'"
        self.add(f"<rect {place} {style}/>")

    def dot(self, x: float, y: float, radius: float, style: str) -> None:
        """Add a disc."""
        self.add(f"<circle cx='{number(x)}' cy='{number(y)}' r='{number(radius)}' {style}/>")

    def text(self, x: float, y: float, words: str, style: str = "", size: float = 11) -> None:
        """Add words whose base line begins at a place, unless `style` anchors them otherwise."""
        place = f"x='{number(x)}' y='{number(y)}' font-size='{number(size)}'"
        fill = "" if "fill=" in style else "fill='#33505f' "
        self.add(f"<text {place} {fill}{style}>{escape(words)}</text>")

    def arrow(self, tail: Sequence[float], tip: Sequence[float], colour: str, size: float) -> None:
        """Add an arrow with a head of `size` [px]."""
        (x0, y0), (x1, y1) = tail, tip
        long = max(((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5, 1e-9)
        u, v = size * (x1 - x0) / long, size * (y1 - y0) / long
        self.line(x0, y0, x1, y1, f"stroke='{colour}' stroke-width='1'")
        ends = (
            (x1, y1),
            (x1 - u - 0.45 * v, y1 - v + 0.45 * u),
            (x1 - u + 0.45 * v, y1 - v - 0.45 * u),
        )
        places = " ".join(f"{number(x)},{number(y)}" for x, y in ends)
        self.add(f"<polygon points='{places}' fill='{colour}'/>")

    def place(self, other: "Drawing", x: float, y: float) -> None:
        """Add another drawing, its corner at (x, y)."""
        self.add(f"<g transform='translate({number(x)},{number(y)})'>")
        self._parts += other.parts()
        self.add("</g>")

    def parts(self) -> Iterable[str]:
        """Return the elements drawn so far."""
        return tuple(self._parts)

    def svg(self, label: str) -> str:
        """Return the drawing as an SVG element that says `label` to those who cannot see it."""
        size = f"{number(self.width)} {number(self.height)}"
        head = (
            f"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {size}' "
            f"width='{number(self.width)}' height='{number(self.height)}' {FONT} role='img' "
            f"aria-label='{escape(label, quote=True)}'>"
        )
        return "\n".join([head, *self._parts, "</svg>"]) + "\n"


def blend(share: float, colours: Sequence[str]) -> str:
    """Return the colour at `share`, 0 to 1, of a row of evenly spaced "#rrggbb"."""
    at = min(max(share, 0.0), 1.0) * (len(colours) - 1)
    low = min(int(at), len(colours) - 2)
    pairs = zip(_channels(colours[low]), _channels(colours[low + 1]), strict=True)
    mixed = [round(a + (b - a) * (at - low)) for a, b in pairs]
    return "#" + "".join(f"{channel:02x}" for channel in mixed)


def _channels(colour: str) -> tuple[int, ...]:
    return tuple(int(colour[i : i + 2], 16) for i in (1, 3, 5))
