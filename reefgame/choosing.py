"""`reefgame video --choose`: which fish is followed is chosen by a click in a window (papers/003, section 3.1)."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final

from reefgame.console import complain

if TYPE_CHECKING:
    from tools.video.follow import Choose, Scene

SIZE: Final = (1120, 760)
INSTEAD: Final = "--choose needs one to open a window; --select X,Y chooses without"


@contextmanager
def choice_by_click() -> "Iterator[Choose]":
    """Give what asks the user in a window, which opens at once and closes with the choice.

    Raise InputError, one line, where there is no display or no OpenGL.
    """
    from reefgame.window import open_window

    window = open_window(SIZE, instead=INSTEAD)
    from reefgame.screens.choose_stage import ChooseStage
    from reefgame.screens.choose_window import ChooseWindow
    from tools.video.candidates import first_sight

    view = ChooseWindow(window)
    try:

        def choose(scene: "Scene") -> tuple[float, float] | None:
            sight = first_sight(scene)
            place = None if sight is None else view.run(ChooseStage(sight))
            window.set_visible(False)
            told = "the largest" if place is None else f"--select {place[0]:.0f},{place[1]:.0f}"
            complain(f"{scene.clip.path}: followed: {told}")
            return place

        yield choose
    finally:
        view.close()
