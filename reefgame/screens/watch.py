"""A recorded dive, watched: the pilot's window and instruments, and orders that come from the file."""

from components.command import Command
from reefgame.eyes import eyes
from reefgame.replay import Replay
from reefgame.screens import theme
from reefgame.screens.game import Game
from reefgame.screens.hud import Hud, hint, plural
from reefgame.screens.inspector import InspectorScreen
from reefgame.screens.menu import BACK
from reefgame.screens.screen import Screen
from reefgame.screens.viewfinder import Viewfinder, slope_for
from reefgame.timeline import Timeline


class WatchScreen(Screen):
    """Plays a replay to its end; Space holds it, Escape leaves."""

    name = "watch"

    def __init__(self, game: Game, replay: Replay) -> None:
        super().__init__(game)
        self._replay = replay
        self._commands = replay.play()
        self._tick = 0
        self._held = False
        game.stage.restart()
        self.timeline = Timeline(game.stage.world)

    def layout(self) -> None:
        """Set up what the pilot saw, and a bar for how far the replay is."""
        c, world = self.canvas, self.game.stage.world
        wanted, name = 0, ""
        if world.goals:
            goal = world.goals[0]
            wanted, name = goal.count, plural(world.species[goal.species].title, goal.count)
        self._finder = Viewfinder(c, wanted, name)
        self._hud = Hud(c, world)
        c.panel(0, 0, c.width, 5 * c.unit, theme.DEEP, order=4)
        self._bar = c.panel(0, 0, 0, 5 * c.unit, theme.LAGOON, order=5)
        hint(c, "Space  hold     I  inspect     Esc  leave")

    def update(self, seconds: float) -> None:
        """Take the ticks that are due, until the replay ends."""
        if not self._held and self._tick < self._replay.ticks:
            self.game.stage.advance(seconds, self.drive, self.ticked)
        objective, world = self.game.stage.world.objective, self.game.stage.world
        if world.goals:
            framed = -1 if world.avatar.attached else int(objective.framed[0])
            self._finder.show(framed, bool(objective.done[0]))
        over = self._tick >= self._replay.ticks
        self._hud.show("The replay is over" if over else "", "", 99.0)
        part = self._tick / max(self._replay.ticks, 1)
        self._bar.place(0, 0, round(self.canvas.width * part), 5 * self.canvas.unit)

    def ticked(self, command: Command) -> None:
        """Note a tick that was played."""
        self.timeline.tick(command)

    def drive(self) -> Command:
        """Return the orders of the next tick, from the file."""
        self._tick += 1
        return next(self._commands, Command())

    def draw_sea(self, width: int, height: int) -> None:
        """Draw what the pilot saw."""
        stage = self.game.stage
        stage.draw(eyes(stage.world, stage.alpha, slope_for(width, height)), width, height)

    def pressed(self, name: str) -> None:
        """Hold, go on, inspect or leave."""
        if name == "i":
            self.game.open(InspectorScreen(self.game, self))
        elif name == "space":
            self._held = not self._held
        elif name in BACK:
            self.game.quit()
