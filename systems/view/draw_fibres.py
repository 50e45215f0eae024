"""Draws the garden: fibres as textured generalized cylinders and blades, one record a fibre (papers/002, 3 and 5).

Each frame the fibres that are seen become rings (fibre_strips.py), as many as their size asks for (fibre_levels.py); a
texture takes the rings to the GPU, where a corner of the mesh finds its own. Colours, marks and how light shines
through come from a texture of looks.
"""

from collections.abc import Sequence
from ctypes import byref, c_int, c_uint
from typing import Any, Final, NamedTuple

import numpy as np

from components.arrays import AnyArray, Float32s, Float64s, Int64s
from components.flora import Disc, Look
from components.garden import Garden
from components.terrain import Terrain
from systems.view.context import ensure_context
from systems.view.cull import View
from systems.view.draw_discs import DrawDiscs
from systems.view.fibre_levels import (
    FLAT,
    LEVELS,
    ROUND,
    SIDES,
    TRIANGLES,
    WIDE,
    Choice,
    Tufts,
    choose_levels,
    widening,
)
from systems.view.fibre_mesh import RECORD, FibreMesh
from systems.view.fibre_strips import RING, fibres_of, write_strips
from systems.view.float_texture import FloatTexture
from systems.view.program import load_program, uniform_location
from systems.view.shade import ground_light

RINGS_UNIT, LOOKS_UNIT = 0, 1
SHAPES: Final = {"tentacle": ROUND, "branch": ROUND, "foot": WIDE, "blade": FLAT, "frond": FLAT}
"""Of a tuft, by the kind of its look."""
KINDS: Final = ("tentacle", "branch", "foot", "blade", "frond", "disc")
"""Kinds of looks as shaders/flora.glsl numbers them."""
PATTERNS: Final = ("plain", "spots", "bands", "stripes", "mottle")
"""Patterns as shaders/fibre.frag.glsl numbers them."""
_LIFT: Final = 0.3
"""[m] over its root at which a plant is asked how much light the rocks leave it."""
_KEY: Final = 100


class Fibre(NamedTuple):
    """What records say of fibres, all that a frame does not change."""

    look: Float32s
    "of each tuft, (tufts,)"
    light: Float32s
    "sky and sun that reach each tuft, (tufts, 2)"
    chance: Float32s
    "0 to 1, of each fibre, (fibres,)"


def look_texels(looks: Sequence[Look]) -> Float32s:
    """Return the texture of looks, 4 texels each, (looks or 1, 4, 4)."""
    texels = np.zeros((max(len(looks), 1), 4, 4), np.float32)
    for row, look in enumerate(looks):
        texels[row, 0] = (*look.root, KINDS.index(look.kind))
        texels[row, 1] = (*look.tip, PATTERNS.index(look.pattern))
        texels[row, 2] = (*look.pattern_colour, look.pattern_scale)
        texels[row, 3, 0] = look.translucency
    return texels


def tufts_of(garden: Garden, looks: Sequence[Look]) -> Tufts:
    """Return what choosing levels of detail reads of a garden's tufts."""
    number = len(garden.plant)
    fibres = np.diff(garden.first_fibre).astype(np.int64)
    nodes, length, thickness = np.zeros(number, np.int64), np.zeros(number), np.zeros(number)
    for tuft in range(number):
        if fibres[tuft]:
            fibre = garden.fibre(tuft, int(fibres[tuft]) // 2)
            nodes[tuft] = garden.nodes[fibre]
            points = garden.points(fibre).astype(np.float64)
            length[tuft] = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
            rows = garden.first_row[fibre] + np.arange(nodes[tuft])
            thickness[tuft] = 2.0 * garden.radius[rows, garden.lane[fibre]].max()
    shape = np.array([SHAPES[looks[look].kind] for look in garden.look], np.int64)
    plant = garden.plant.astype(np.int64)
    return Tufts(garden.tuft_sphere, shape, thickness, length, nodes, fibres, plant)


class DrawFibres:
    """Draws a garden. Reads its nodes; writes to the GPU only.

    `looks` are what `garden.look` counts, `discs` ride on its feet; `terrain` shades them under the unit vector `sun`.
    To be made while the garden stands at rest. `draw` expects the `Frame` block up to date.
    """

    def __init__(
        self,
        garden: Garden,
        looks: Sequence[Look],
        discs: Sequence[Disc],
        terrain: Terrain,
        sun: tuple[float, float, float],
        defines: Sequence[str] = (),
    ) -> None:
        ensure_context()
        from pyglet import gl

        self._garden = garden
        self.tufts = tufts_of(garden, looks)
        self._fibres = fibres_of(garden)
        self._tables = self._constants(terrain, np.asarray(sun))
        self._frame = np.zeros(RING)
        widest = c_int()
        gl.glGetIntegerv(gl.GL_MAX_TEXTURE_SIZE, byref(widest))
        a_row = min(widest.value, 3072) * 4 // RING
        self._rings = FloatTexture(a_row * RING // 4, widest.value)
        self._looks = FloatTexture(4, widest.value)
        self._looks.upload(look_texels(looks))
        self._records = c_uint()
        gl.glGenBuffers(1, byref(self._records))
        self._room = np.zeros((256, RING), np.float32)
        self._meshes = [[FibreMesh(s, n, self._records) for n in range(LEVELS)] for s in range(3)]
        sizes = (f"RINGS_A_ROW {a_row}", *defines)
        self._programs = {
            name: _program(sizes, kinds)
            for name, kinds in (
                ("tube", ()),
                ("ribbon", ("RIBBON", "TWO_SIDED")),
                ("blade", ("FLAT", "TWO_SIDED")),
            )
        }
        light = self._tables.light
        self._discs = DrawDiscs(garden, discs, light, self._fibres.side, defines)

    def draw(self, view: View, most: int = TRIANGLES) -> Choice:
        """Draw what is seen in `view` with at most so many triangles; return what was chosen."""
        choice = choose_levels(self.tufts, view, most)
        if not len(choice.tuft):
            return choice
        pieces, records = self._write(choice)
        self._bind()
        self._upload(records)
        for shape, level, rings, first, number in pieces:
            self._draw_piece(shape, level, rings, first, number)
        self._discs.draw(view)
        self._finish()
        return choice

    def _write(self, choice: Choice) -> tuple[list[tuple[int, int, int, int, int]], Float32s]:
        """Write the rings of what was chosen; return pieces (shape, level, rings, first, number) of the records."""
        shape = self.tufts.shape[choice.tuft]
        key = (shape * LEVELS + choice.level) * _KEY + choice.rings
        order = np.argsort(key, kind="stable")
        tuft, fibres, level = choice.tuft[order], choice.fibres[order], choice.level[order]
        owner = np.repeat(np.arange(len(order)), fibres)
        wide = widening(level)
        within = np.arange(len(owner)) - np.repeat(np.cumsum(fibres) - fibres, fibres)
        fibre = self._garden.first_fibre[tuft[owner]] + (within * wide[owner]).astype(np.int64)
        rings = choice.rings[order][owner]
        starts = np.cumsum(rings) - rings
        self._write_rings(fibre, rings, starts)
        records = np.empty((len(fibre), RECORD), np.float32)
        records[:, 0] = starts + rings - 1
        records[:, 1] = np.pi * self.tufts.thickness[tuft[owner]]
        records[:, 2], records[:, 3] = self._tables.look[tuft[owner]], self._tables.chance[fibre]
        records[:, 4], records[:, 7] = self.tufts.length[tuft[owner]], wide[owner]
        records[:, 5:7] = self._tables.light[tuft[owner]]
        keys, first, number = np.unique(key[order][owner], return_index=True, return_counts=True)
        pieces = [
            (int(k) // _KEY // LEVELS, int(k) // _KEY % LEVELS, int(k) % _KEY, int(a), int(n))
            for k, a, n in zip(keys, first, number, strict=True)
        ]
        return pieces, records

    def _write_rings(self, fibre: AnyArray, rings: Int64s, starts: Int64s) -> None:
        total = self._rings.whole_rows(int(rings.sum()) * RING // 4) * 4 // RING
        if total > len(self._room):
            self._room = np.zeros((2 * total, RING), np.float32)
        chosen = fibre.astype(np.int32)
        counts, begins = rings.astype(np.int32), starts.astype(np.int32)
        write_strips(self._fibres, chosen, counts, begins, self._frame, self._room)
        self._rings.upload(self._room[:total].reshape(-1, self._rings.width, 4))

    def _constants(self, terrain: Terrain, sun: Float64s) -> Fibre:
        garden = self._garden
        number = len(garden.plant)
        roots = np.zeros((number, 3))
        for tuft in np.flatnonzero(self.tufts.fibres):
            roots[tuft] = garden.points(garden.fibre(int(tuft), 0))[0]
        roots[:, 2] += _LIFT
        light = ground_light(roots, terrain, sun) if number else np.zeros((0, 2))
        chance = np.arange(garden.fibres) * 0.6180339887498949
        return Fibre(
            garden.look.astype(np.float32),
            light.astype(np.float32),
            (chance - np.floor(chance)).astype(np.float32),
        )

    def _bind(self) -> None:
        from pyglet import gl

        self._rings.bind(RINGS_UNIT)
        self._looks.bind(LOOKS_UNIT)
        gl.glEnable(gl.GL_DEPTH_TEST)
        gl.glDisable(gl.GL_BLEND)

    def _upload(self, records: Float32s) -> None:
        from pyglet import gl

        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, self._records)
        gl.glBufferData(gl.GL_ARRAY_BUFFER, records.nbytes, records.ctypes.data, gl.GL_STREAM_DRAW)

    def _draw_piece(self, shape: int, level: int, rings: int, first: int, number: int) -> None:
        from pyglet import gl

        ribbon = shape != FLAT and SIDES[shape][level] == 2
        name = "blade" if shape == FLAT else "ribbon" if ribbon else "tube"
        gl.glUseProgram(self._programs[name].id)
        if name == "tube":
            gl.glEnable(gl.GL_CULL_FACE)
        else:
            gl.glDisable(gl.GL_CULL_FACE)
        self._meshes[shape][level].draw(first, number, rings)

    @staticmethod
    def _finish() -> None:
        from pyglet import gl

        gl.glDisable(gl.GL_CULL_FACE)
        gl.glBindVertexArray(0)
        gl.glUseProgram(0)

    def delete(self) -> None:
        """Free textures, buffers and programs."""
        from pyglet import gl

        self._rings.delete()
        self._looks.delete()
        gl.glDeleteBuffers(1, byref(self._records))
        for meshes in self._meshes:
            for mesh in meshes:
                mesh.delete()
        for program in self._programs.values():
            program.delete()
        self._discs.delete()


def _program(sizes: Sequence[str], kinds: Sequence[str]) -> Any:
    from pyglet import gl

    program = load_program("fibre.vert.glsl", "fibre.frag.glsl", (*kinds, *sizes))
    gl.glUseProgram(program.id)
    for name, unit in (("rings", RINGS_UNIT), ("looks", LOOKS_UNIT)):
        gl.glUniform1i(uniform_location(program, name), unit)
    gl.glUseProgram(0)
    return program
