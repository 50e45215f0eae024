"""Shader programs from the files in shaders/, `#include "name.glsl"` lines resolved."""

from collections.abc import Sequence
from ctypes import c_char_p, c_int
from importlib.resources import files
from typing import Any, Final

from systems.view.context import ensure_context

SAMPLER_UNITS: Final = {
    "water_map": 6,
    "surface_map": 7,
    "relief_map": 5,
    "stone_map": 4,
    "mark_map": 8,
    "coral_map": 9,
}
"""Texture units of the maps that `FrameBlock` binds; drawers of their own textures take 0 to 3."""

FRAME_BINDING: Final = 3
"""Uniform buffer binding of the `Frame` block; pyglet's window block holds 0."""


class ShaderError(RuntimeError):
    """A shader does not compile or link; the message names the files and gives the driver's log."""


def shader_source(name: str, defines: Sequence[str] = ()) -> str:
    """Return the GLSL text of the shader `name`, its includes and `defines` ("NAME 3") put in."""
    head = "".join(f"#define {line}\n" for line in defines)
    return f"#version 330 core\n{head}{_resolved(name, [])}"


def _resolved(name: str, seen: list[str]) -> str:
    if name in seen:
        return ""
    seen.append(name)
    text = (files("systems.view") / "shaders" / name).read_text(encoding="utf-8")
    lines = []
    for line in text.splitlines():
        words = line.split('"')
        lines.append(_resolved(words[1], seen) if words[0].strip() == "#include" else line)
    return "\n".join(lines) + "\n"


def load_program(vertex_file: str, fragment_file: str, defines: Sequence[str] = ()) -> Any:
    """Return pyglet's ShaderProgram of the two files, its `Frame` block and water maps connected.

    Raise ShaderError where the driver refuses them.
    """
    ensure_context()
    from pyglet import gl
    from pyglet.graphics.shader import Shader, ShaderException, ShaderProgram

    try:
        vertex = Shader(shader_source(vertex_file, defines), "vertex")
        fragment = Shader(shader_source(fragment_file, defines), "fragment")
        program = ShaderProgram(vertex, fragment)
    except ShaderException as error:
        raise ShaderError(f"{vertex_file}, {fragment_file}: {error}") from error
    block = gl.glGetUniformBlockIndex(program.id, c_char_p(b"Frame"))
    if block != gl.GL_INVALID_INDEX:
        gl.glUniformBlockBinding(program.id, block, FRAME_BINDING)
    program.use()
    for name, unit in SAMPLER_UNITS.items():
        location = uniform_location(program, name)
        if location >= 0:
            gl.glUniform1i(location, c_int(unit))
    program.stop()
    return program


def uniform_location(program: Any, name: str) -> int:
    """Return where the uniform `name` lies, -1 where the driver dropped it as unused."""
    from pyglet import gl

    return int(gl.glGetUniformLocation(program.id, c_char_p(name.encode())))
