"""The pause: the dive stands still until the player comes back, starts over or leaves."""

from typing import TYPE_CHECKING

from reefgame.screens.menu import Item
from reefgame.screens.options import OptionsScreen
from reefgame.screens.overlay import OverlayScreen

if TYPE_CHECKING:
    from reefgame.screens.dive import DiveScreen


class PauseScreen(OverlayScreen):
    """Resume, restart, inspect, options, title."""

    name = "pause"
    headline = "Paused"

    def __init__(self, dive: "DiveScreen") -> None:
        game, self._dive = dive.game, dive
        super().__init__(
            game,
            [
                Item("Resume", self.back),
                Item("Restart the dive", dive.restart),
                Item("Inspect the fishes", self._inspect),
                Item("Options", lambda: game.open(OptionsScreen(game))),
                Item("Leave for the title", dive.leave),
            ],
        )

    def _inspect(self) -> None:
        self.back()
        self._dive.inspect()
