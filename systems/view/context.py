"""The OpenGL context: the window's where one is open, else one without a display (FINDINGS 8).

pyglet decides what kind of window it makes when `pyglet.window` is first imported, so whoever
wants one with a display imports it first; `ensure_context` asks for the headless kind only where
nothing has been decided yet.
"""

import os
import sys
import warnings
from typing import Any, Final

import pyglet

from components.fault import FaultError

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
# Threads that wait for the next parallel kernel must not spin on the cores that software OpenGL draws with.
os.environ.setdefault("OMP_WAIT_POLICY", "passive")

PACKAGES: Final = "libegl1 libegl-mesa0 libgl1 libglx-mesa0 libgl1-mesa-dri"
"""Debian's packages that draw without a graphics card."""

_kept: list[Any] = []


class NoOpenGLError(FaultError):
    """This machine cannot give an OpenGL 3.3 context; the message is one line that says why."""


def choose_options(headless: bool) -> None:
    """Set pyglet's options; it reads them when `pyglet.window` is imported for the first time."""
    pyglet.options["debug_gl"] = False
    pyglet.options["shadow_window"] = False
    pyglet.options["headless"] = headless


def ensure_context() -> None:
    """Make an OpenGL 3.3 context current, without a display unless a window is open.

    Raise NoOpenGLError with one line that names the cause and the packages to install.
    """
    if "pyglet.gl" in sys.modules:
        from pyglet import gl

        if gl.current_context is not None:
            return
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            _kept.append(_open_headless())
    except (ImportError, OSError, AttributeError, ValueError, _gl_errors()) as error:
        raise NoOpenGLError(_no_opengl(error)) from error


def config() -> Any:
    """Return pyglet's configuration of every context: core 3.3, forward compatible."""
    from pyglet import gl

    return gl.Config(  # type: ignore[abstract]  # pyglet picks the system's own class
        major_version=3, minor_version=3, forward_compatible=True, double_buffer=True, depth_size=24
    )


def _open_headless() -> Any:
    if "pyglet.window" not in sys.modules:
        choose_options(headless=True)
    from pyglet.window import Window

    # The size is of no matter: pictures are drawn into framebuffers of our own.
    return Window(16, 16, visible=False, config=config())


def _gl_errors() -> type[Exception]:
    """Return what pyglet raises where no context fits; importable only once its libraries are."""
    try:
        from pyglet.window import WindowException
    except (ImportError, OSError, AttributeError):
        return OSError
    return WindowException


def _no_opengl(error: Exception) -> str:
    reason = " ".join(str(error).split()) or type(error).__name__
    return f"no OpenGL 3.3: {reason}; on Debian: apt-get install {PACKAGES}"
