"""Where a species' motion comes from: shipped, else from the user's cache, else captured now and kept (DESIGN 4).

A repertoire fits a species where its fingerprint is that of body, swim and kernels; what a mod ships for another body
is stale and passed over. One that holds filmed segments is never stale: where body or swim were changed since, the
filmed segments are fitted to the body and the others captured anew (tools/video/water/joining.py).
"""

from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TypeAlias

from platformdirs import user_cache_path

from components.body import Body, Swim
from components.repertoire import Repertoire
from components.repertoire_file import RepertoireError, load, save
from reefgame.content.nodes import Mark
from reefgame.content.yaml_marks import shown

Progress: TypeAlias = Callable[[float, str], None]
"""Told how far the work is, 0 to 1, and what is being done."""


def cache_folder() -> Path:
    """Return where captured repertoires are kept, one file a fingerprint."""
    return user_cache_path("reefgame") / "repertoires"


def repertoire_of(
    body: Body, swim: Swim, shipped: Sequence[Path], origin: Mark, progress: Progress | None
) -> Repertoire:
    """Return the repertoire of a species; `shipped` are the files that mods may hold of it, nearest first.

    Raise ContentError where a shipped file is damaged, or where the body at `origin` does not swim.
    """
    from tools.capture.capture import fingerprint
    from tools.video.water.joining import fits, is_filmed

    wanted = fingerprint(body, swim)
    for path in shipped:
        found = _shipped(path)
        if found is None:
            continue
        if found.provenance.get("fingerprint") == wanted or fits(found, body, swim):
            return found
        if is_filmed(found):
            return _refitted(
                path, found, _captured(body, swim, wanted, origin, progress), body, swim
            )
    return _captured(body, swim, wanted, origin, progress)


def _refitted(
    path: Path, found: Repertoire, captured: Repertoire, body: Body, swim: Swim
) -> Repertoire:
    from tools.video.water.joining import rejoined

    try:
        return rejoined(found, captured, body, swim)
    except ValueError as error:
        raise Mark(shown(path)).error(f"not a usable repertoire: {error}") from None


def _captured(
    body: Body, swim: Swim, wanted: str, origin: Mark, progress: Progress | None
) -> Repertoire:
    """Return what the muscles swim, from the user's cache or captured now; `wanted` is its fingerprint."""
    from tools.capture.capture import capture

    kept = cache_folder() / f"{wanted}.npz"
    with suppress(RepertoireError):
        found = load(kept)
        if found.provenance.get("fingerprint") == wanted:
            return found
    try:
        captured = capture(body, swim, progress)
    except (ValueError, ArithmeticError) as error:
        raise origin.error(f"no motion can be captured for this body: {error}") from None
    with suppress(OSError):
        kept.parent.mkdir(parents=True, exist_ok=True)
        save(kept, captured)
    return captured


def _shipped(path: Path) -> Repertoire | None:
    if not path.exists():
        return None
    try:
        return load(path)
    except RepertoireError as error:
        reason = str(error).removeprefix(f"{path}: ")
        raise Mark(shown(path)).error(reason) from None
