"""What screens are painted with: rounded panels and text, gathered in one batch (FINDINGS 8).

A panel is one quad whose fragment shader measures the distance to a rounded rectangle, so edges are
smooth without multisampling; circles, bars and hair lines are panels too. Places are in pixels from
the window's lower left corner. Setters touch the GPU only where something changed.
"""

from typing import Any, Final

from pyglet import gl
from pyglet.graphics import Batch, Group, ShaderGroup
from pyglet.graphics.shader import Shader, ShaderProgram
from pyglet.image import Texture
from pyglet.sprite import Sprite
from pyglet.text import Label

from reefgame.screens import theme
from reefgame.screens.theme import Colour

_VERTEX: Final = """#version 330 core
in vec2 position;
in vec4 shape;
in vec2 edge;
in vec4 fill;
in vec4 rim;
out vec2 local;
flat out vec2 half_size;
flat out vec2 edges;
out vec4 inside;
flat out vec4 line;
uniform WindowBlock { mat4 projection; mat4 view; } window;
void main() {
    gl_Position = window.projection * window.view * vec4(position, 0.0, 1.0);
    local = shape.xy;
    half_size = shape.zw;
    edges = edge;
    inside = fill;
    line = rim;
}
"""

_FRAGMENT: Final = """#version 330 core
in vec2 local;
flat in vec2 half_size;
flat in vec2 edges;
in vec4 inside;
flat in vec4 line;
out vec4 colour;
void main() {
    float radius = min(edges.x, min(half_size.x, half_size.y));
    vec2 q = abs(local) - half_size + radius;
    float away = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - radius;
    float body = clamp(0.5 - away, 0.0, 1.0);
    float on_line = edges.y > 0.0 ? clamp(away + edges.y + 0.5, 0.0, 1.0) : 0.0;
    vec4 paint = mix(inside, line, on_line);
    colour = vec4(paint.rgb, paint.a * body);
}
"""

_LAYERS: Final = 3
"""Layers of one order: panels, shadows and pictures, letters."""
_MARGIN: Final = 1.0
"""[px] that the quad stands out beyond the panel, for its soft edge."""


class _PanelGroup(ShaderGroup):
    """Blends panels over what is there."""

    def set_state(self) -> None:
        """Bind the program, with blending on."""
        super().set_state()
        gl.glEnable(gl.GL_BLEND)
        gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)


class Panel:
    """A rounded rectangle with a thin rim; the gradient runs down, or to the right if `sideways`."""

    def __init__(
        self,
        canvas: "Canvas",
        box: tuple[float, float, float, float],
        fill: Colour = theme.DEEP,
        bottom: Colour | None = None,
        radius: float = 0.0,
        rim: Colour = theme.CLEAR,
        rim_width: float = 0.0,
        order: int = 0,
        sideways: bool = False,
    ) -> None:
        self._sideways = sideways
        self._box = self._colours = self._rim = None
        self._list: Any = canvas.panel_program.vertex_list_indexed(
            4,
            gl.GL_TRIANGLES,
            (0, 1, 2, 0, 2, 3),
            batch=canvas.batch,
            group=canvas.panel_group(order),
            position=("f", (0.0,) * 8),
            shape=("f", (0.0,) * 16),
            edge=("f", (radius, rim_width) * 4),
            fill=("Bn", (0,) * 16),
            rim=("Bn", (0,) * 16),
        )
        self.place(*box)
        self.paint(fill, bottom, rim)

    _box: tuple[float, float, float, float] | None
    _colours: tuple[Colour, Colour] | None
    _rim: Colour | None

    def place(self, x: float, y: float, width: float, height: float) -> None:
        """Put the lower left corner at (x, y), of width x height [px]."""
        if self._box == (x, y, width, height):
            return
        self._box = (x, y, width, height)
        left, low, right, high = x - _MARGIN, y - _MARGIN, x + width + _MARGIN, y + height + _MARGIN
        a, b = 0.5 * width, 0.5 * height
        u, v = a + _MARGIN, b + _MARGIN
        self._list.position[:] = (left, low, right, low, right, high, left, high)
        self._list.shape[:] = (-u, -v, a, b, u, -v, a, b, u, v, a, b, -u, v, a, b)

    def paint(self, fill: Colour, bottom: Colour | None = None, rim: Colour | None = None) -> None:
        """Set the colours: `fill` where the gradient begins, `bottom` where it ends, the rim's."""
        colours = (fill, bottom or fill)
        if colours != self._colours:
            self._colours = colours
            first, last = colours
            far = first if self._sideways else last
            self._list.fill[:] = (*far, *last, *(last if self._sideways else first), *first)
        if rim is not None and rim != self._rim:
            self._rim = rim
            self._list.rim[:] = rim * 4

    def hide(self) -> None:
        """Make the panel vanish until it is placed again."""
        self.place(-10.0, -10.0, 0.0, 0.0)


class Text:
    """One line or paragraph; set anew only where it differs."""

    def __init__(self, label: Label, shadow: Label | None, drop: int) -> None:
        self._label, self._shadow, self._drop = label, shadow, drop
        self._text, self._colour = label.text, tuple(label.color)
        self._at = (float(label.x), float(label.y))

    def set(self, text: str, colour: Colour | None = None) -> None:
        """Show `text`, in `colour` where given."""
        if text != self._text:
            self._text = text
            self._label.text = text
            if self._shadow:
                self._shadow.text = text
        if colour is not None and colour != self._colour:
            self._colour = colour
            self._label.color = colour
            if self._shadow:
                self._shadow.color = (0, 10, 18, colour[3] * 3 // 4)

    def move(self, x: float, y: float) -> None:
        """Put the anchor at (x, y) [px]."""
        if (x, y) != self._at:
            self._at = (x, y)
            self._label.position = (round(x), round(y), 0.0)
            if self._shadow:
                self._shadow.position = (round(x), round(y - self._drop), 0.0)

    @property
    def width(self) -> float:
        """[px] that the text takes."""
        return float(self._label.content_width)

    @property
    def height(self) -> float:
        """[px] that the text takes."""
        return float(self._label.content_height)


class Canvas:
    """All panels, texts and pictures of one screen at one window size."""

    _program: ShaderProgram | None = None

    def __init__(self, width: int, height: int) -> None:
        self.width, self.height = width, height
        self.unit = theme.unit(width, height)
        self.batch = Batch()
        self._panel_groups: dict[int, _PanelGroup] = {}
        self._groups: dict[int, Group] = {}
        self._kept: list[object] = []
        "texts and pictures: pyglet takes what nobody holds out of the batch"

    @property
    def panel_program(self) -> ShaderProgram:
        """The program that paints panels, made once for the window's context."""
        if Canvas._program is None:
            Canvas._program = ShaderProgram(
                Shader(_VERTEX, "vertex"), Shader(_FRAGMENT, "fragment")
            )
        return Canvas._program

    def panel_group(self, order: int) -> Group:
        """Return the group of panels at `order`: higher ones cover lower ones."""
        if order not in self._panel_groups:
            self._panel_groups[order] = _PanelGroup(self.panel_program, _LAYERS * order)
        return self._panel_groups[order]

    def panel(
        self, x: float, y: float, width: float, height: float, fill: Colour, **look: Any
    ) -> Panel:
        """Add a panel; `look` are Panel's other arguments, with lengths in pixels."""
        return Panel(self, (x, y, width, height), fill, **look)

    def card(self, x: float, y: float, width: float, height: float, order: int = 0) -> Panel:
        """Add a panel in the house style."""
        u = self.unit
        return self.panel(
            x, y, width, height, theme.DEEP, bottom=theme.ABYSS, radius=12 * u, rim=theme.RIM,
            rim_width=max(1.0, 1.2 * u), order=order,
        )  # fmt: skip

    def text(
        self,
        text: str,
        x: float,
        y: float,
        size: float = theme.BODY,
        colour: Colour = theme.FOAM,
        anchor: str = "left baseline",
        width: float | None = None,
        weight: str = "normal",
        shadow: bool = False,
        order: int = 0,
    ) -> Text:
        """Add text of `size` units; `anchor` is "left|center|right top|center|baseline|bottom".

        A `width` [px] makes it a paragraph.
        """
        x, y, drop = round(x), round(y), max(1, round(1.4 * self.unit))
        look: dict[str, Any] = {
            "font_name": theme.FAMILIES,
            "font_size": max(9.0, size * self.unit),
            "weight": weight,
            "anchor_x": anchor.split()[0],
            "anchor_y": anchor.split()[1],
            "align": anchor.split()[0],
            "width": None if width is None else round(width),
            "multiline": width is not None,
            "dpi": 72,
            "batch": self.batch,
        }
        under = None
        if shadow:
            dark = (0, 10, 18, colour[3] * 3 // 4)
            under = Label(text, x=x, y=y - drop, color=dark, group=self._group(order, 1), **look)
        label = Label(text, x=x, y=y, color=colour, group=self._group(order, 2), **look)
        written = Text(label, under, drop)
        self._kept.append(written)
        return written

    def picture(
        self, texture: Texture, box: tuple[float, float, float, float], order: int
    ) -> Sprite:
        """Add `texture` stretched over the box (x, y, width, height) [px]."""
        sprite = Sprite(texture, x=box[0], y=box[1], batch=self.batch, group=self._group(order, 1))
        sprite.scale_x = box[2] / texture.width
        sprite.scale_y = box[3] / texture.height
        self._kept.append(sprite)
        return sprite

    def draw(self) -> None:
        """Paint everything over the bound framebuffer."""
        gl.glDisable(gl.GL_DEPTH_TEST)
        gl.glDisable(gl.GL_CULL_FACE)
        gl.glActiveTexture(gl.GL_TEXTURE0)
        self.batch.draw()

    def delete(self) -> None:
        """Forget everything on the canvas."""
        self.batch, self._kept = Batch(), []

    def _group(self, order: int, layer: int) -> Group:
        """Return the group of texts at `order`: panels, then pictures and shadows (1), then letters (2)."""
        place = _LAYERS * order + layer
        if place not in self._groups:
            self._groups[place] = Group(place)
        return self._groups[place]
