"""Which of the level's hints a newcomer sees: the first whose deed is not done yet."""

from collections.abc import Sequence
from math import hypot, remainder, tau

from components.command import Command
from reefgame.content.schema.level import Prompt
from reefgame.screens.screen import trace
from reefgame.world import World

_MOVED_SPEED = 0.3
"""[m/s] from which the submarine moves."""
_TURNED = 0.12
"""[rad] of turning that counts."""


class Briefing:
    """Watches what the player has done so far."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._prompts: Sequence[Prompt] = world.level.prompts
        self._heading = float(world.submarine.yaw[0]), float(world.submarine.pitch[0])
        self.done: set[str] = set()

    def notice(self, command: Command) -> None:
        """Take note of the tick that was just played under `command`."""
        ship, objective = self._world.submarine, self._world.objective
        x, y, _ = ship.velocity[0]
        yaw, pitch = float(ship.yaw[0]), float(ship.pitch[0])
        turned = max(abs(remainder(yaw - self._heading[0], tau)), abs(pitch - self._heading[1]))
        deeds = {
            "moved": hypot(x, y) > _MOVED_SPEED,
            "turned": turned > _TURNED,
            "rose": command.rise != 0,
        }
        if self._world.goals:
            framed = int(objective.framed[0])
            deeds["framed"] = framed > 0
            deeds["enough"] = framed >= self._world.goals[0].count
            deeds["photographed"] = bool(objective.shots[0])
            deeds["won"] = bool(objective.done[0])
        for deed in deeds:
            if deeds[deed] and deed not in self.done:
                self.done.add(deed)
                trace(f"deed {deed}")

    @property
    def prompt(self) -> str:
        """The hint to show, empty when everything was done."""
        return next((prompt.text for prompt in self._prompts if prompt.until not in self.done), "")
