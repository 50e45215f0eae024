"""A level opened for the command line: loaded with a bar, its warnings told, the kernels compiled (DESIGN 6, 8)."""

from collections.abc import Sequence
from pathlib import Path

from reefgame.console import complain, progress_bar
from reefgame.content import Content, load
from reefgame.content.catalogue import LEVEL
from reefgame.content.loading import find
from reefgame.warmup import is_warm, warm_up


def open_level(
    level: str, mods: Sequence[Path], compiled: bool = True, live: bool = False
) -> Content:
    """Return the content of a level by name or file; installed mods at fault are left out and told of.

    Where `compiled`, every kernel is ready before this returns, those of live physics too where `live`. Raise
    ContentError.
    """
    if compiled and not is_warm(live):
        # A level that is not there is told before the long work.
        find(LEVEL, level, mods)
        warm_up(live=live)
    with progress_bar("loading") as report:
        content = load(level, mods=mods, progress=report)
    for mod in content.disabled:
        complain(str(mod))
    return content
