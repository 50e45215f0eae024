"""How much of a stretch of drawing OpenGL takes, so that benches can tell our own Python from the driver."""

from collections.abc import Callable
from importlib import import_module
from time import perf_counter
from typing import Any


class GLTime:
    """While it is entered, adds up the seconds that calls through `pyglet.gl` take."""

    def __init__(self) -> None:
        self.seconds = 0.0
        # pyglet's own attribute may still be a proxy that stands for the module until its first use.
        self._gl = import_module("pyglet.gl")
        self._kept: dict[str, Any] = {}

    def finish(self) -> None:
        """Wait until all that was asked for is drawn."""
        self._gl.glFinish()

    def __enter__(self) -> "GLTime":
        for name in [n for n in dir(self._gl) if n.startswith("gl") and n[2:3].isupper()]:
            call = getattr(self._gl, name)
            if callable(call):
                self._kept[name] = call
                setattr(self._gl, name, self._timed(call))
        return self

    def __exit__(self, *_: object) -> None:
        for name, call in self._kept.items():
            setattr(self._gl, name, call)

    def _timed(self, call: Callable[..., Any]) -> Callable[..., Any]:
        def timed(*arguments: Any) -> Any:
            start = perf_counter()
            try:
                return call(*arguments)
            finally:
                self.seconds += perf_counter() - start

        return timed
