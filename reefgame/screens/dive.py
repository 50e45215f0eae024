"""The dive: the pilot's window, the camera, and the way from keys to ticks (DESIGN 3, 8)."""

from pyglet import gl
from pyglet.image import Texture
from pyglet.sprite import Sprite

from components.clock import TICKS_PER_SECOND
from components.command import Command
from reefgame.controls import Controls
from reefgame.eyes import eyes
from reefgame.progress import Record, Result
from reefgame.screens import theme
from reefgame.screens.briefing import Briefing
from reefgame.screens.canvas import Panel
from reefgame.screens.game import Game
from reefgame.screens.help import HelpScreen
from reefgame.screens.hud import Hud, hint, plural, verdict
from reefgame.screens.inspector import InspectorScreen
from reefgame.screens.pause import PauseScreen
from reefgame.screens.result import ResultScreen
from reefgame.screens.screen import Screen, trace
from reefgame.screens.viewfinder import Viewfinder, frame_box, slope_for
from reefgame.timeline import Timeline

_FLASH_SECONDS = 0.35
_PRINT_SECONDS = 4.0
_APPLAUSE = 140
"""[ticks] between success and the result screen."""


class DiveScreen(Screen):
    """One dive, from its first tick to success or departure."""

    name = "dive"
    captures_mouse = True
    photograph: Texture | None
    "the latest photograph"

    def __init__(self, game: Game) -> None:
        super().__init__(game)
        self.stage = game.stage
        self.world = game.stage.world
        self.controls = Controls()
        self.photograph = None
        self.stage.restart()
        self.briefing = Briefing(self.world)
        self.timeline = Timeline(self.world)
        self.recording = self.game.begin_recording()
        self._saved = False
        self._message, self._message_age = "", 99.0
        self._since_shot = 99.0
        self._won = 0
        self._over = False
        self._before = Record()
        self._develop = False
        self._shots = 0
        self._was = -1

    def restart(self) -> None:
        """Begin the same dive anew."""
        self.game.stack.replace(lambda: DiveScreen(self.game))

    def leave(self) -> None:
        """Go back to the title."""
        self.game.to_title()

    def closed(self) -> None:
        """Keep what was achieved, and the recording."""
        self.recording.close()
        if not self._saved and self.world.goals and self.world.objective.shots[0]:
            self._save(won=False)

    def opened(self) -> None:
        """Take the helm, with nothing held and the settings as they are now."""
        chosen = self.game.settings
        self.controls.release_all()
        self.controls.sensitivity = chosen.mouse_sensitivity
        self.controls.invert_pitch = chosen.invert_pitch

    def layout(self) -> None:
        """Set up the viewfinder, the instruments and what a photograph shows."""
        c, world = self.canvas, self.world
        wanted, name = 0, ""
        if world.goals:
            goal = world.goals[0]
            wanted, name = goal.count, plural(world.species[goal.species].title, goal.count)
        self._finder = Viewfinder(c, wanted, name)
        self._hud = Hud(c, world)
        self._flash: Panel = c.panel(0, 0, c.width, c.height, theme.CLEAR, order=6)
        self._print: Sprite | None = None
        self._border: Panel = c.panel(0, 0, 0, 0, (244, 248, 246, 255), radius=3 * c.unit, order=4)
        hint(c, "B  become a fish, and back     I  inspect     H  help     Esc  pause")
        self._show()

    def update(self, seconds: float) -> None:
        """Take the ticks that are due and show what came of them."""
        self.stage.advance(seconds, self.controls.command, self.ticked)
        self._message_age += seconds
        self._since_shot += seconds
        self._show()
        if self._won and not self._over and self.world.clock.now > self._won + _APPLAUSE:
            self._over = True
            self.recording.close()
            self.game.open(ResultScreen(self, self._result(won=True), self._before))

    def drive(self) -> Command:
        """Return the orders while the player inspects: the submarine stands, a fish swims on."""
        return Command(stop=int(not self.world.avatar.attached))

    def ticked(self, command: Command) -> None:
        """Record a tick that was played, and note what came of it."""
        self.recording.tick(command)
        self.timeline.tick(command)
        self.briefing.notice(command)
        self._notice_avatar()
        if self.world.goals and int(self.world.objective.shots[0]) != self._shots:
            self._shots = int(self.world.objective.shots[0])
            self._photographed()
        if self.recording.warning and self.recording.warning not in self.game.messages:
            self.game.say(self.recording.warning)

    def _notice_avatar(self) -> None:
        """Say what became of the player in the tick that was just played."""
        world, at = self.world, self.world.clock.now - 1
        identity = int(world.avatar.fish[0])
        if identity != self._was:
            self._was = identity
            trace("became fish" if identity >= 0 else "became pilot")
            if identity >= 0:
                kind = world.population.fish.species[world.population.row(identity)]
                name = world.species[kind].title.lower()
                self._tell(f"You are {'an' if name[0] in 'aeiou' else 'a'} {name}")
            elif int(world.avatar.lost_at[0]) == at:
                self._tell("You were eaten: back at the helm")
            else:
                self._tell("Back at the helm")
        elif int(world.avatar.refused_at[0]) == at:
            self._tell("No fish before the bow: turn to one within 15 m")

    def _photographed(self) -> None:
        goal, objective = self.world.goals[0], self.world.objective
        framed, done = int(objective.latest[0]), bool(objective.done[0])
        trace(f"photograph {framed}/{goal.count}")
        self._since_shot, self._develop = 0.0, True
        name = plural(self.world.species[goal.species].title, framed)
        self._tell(verdict(framed, goal.count, name, framed >= goal.count))
        if done and not self._saved:
            trace("won")
            self._before = self.game.progress.record(self.world.level.name)
            self._save(won=True)
            self._won = self.world.clock.now

    def _tell(self, message: str) -> None:
        self._message, self._message_age = message, 0.0

    def _result(self, won: bool) -> Result:
        objective = self.world.objective
        ticks = int(objective.won_at[0]) if won else self.world.clock.now
        return Result(
            self.world.level.name,
            int(objective.score[0]),
            ticks / TICKS_PER_SECOND,
            int(objective.best[0]),
            won,
        )

    def _save(self, won: bool) -> None:
        self._saved = True
        progress = self.game.progress
        known = len(progress.warnings)
        progress.add(self._result(won))
        for warning in progress.warnings[known:]:
            self.game.say(warning)

    def _show(self) -> None:
        framed = int(self.world.objective.framed[0]) if self.world.goals else 0
        done = bool(self.world.goals and self.world.objective.done[0])
        self._finder.show(-1 if self.world.avatar.attached else framed, done)
        self._hud.show("" if done else self.briefing.prompt, self._message, self._message_age)
        bright = max(0.0, 1.0 - self._since_shot / _FLASH_SECONDS)
        self._flash.paint((255, 255, 250, round(210 * bright * bright)))
        self._show_print()

    def _show_print(self) -> None:
        shown = self._since_shot < _PRINT_SECONDS and self.photograph is not None
        if shown == (self._print is not None):
            return
        if not shown or self.photograph is None:
            self._remove_print()
            self._border.hide()
            return
        u = self.canvas.unit
        wide, tall, edge = 180 * u, 120 * u, 6 * u
        left, low = self.canvas.width - wide - 28 * u, self.canvas.height - tall - 84 * u
        self._border.place(left - edge, low - edge, wide + 2 * edge, tall + 2 * edge)
        self._print = self.canvas.picture(self.photograph, (left, low, wide, tall), order=4)

    def _remove_print(self) -> None:
        if self._print is not None:
            self._print.delete()
        self._print = None

    def draw_sea(self, width: int, height: int) -> None:
        """Draw what the pilot sees, and keep it where a photograph was taken."""
        camera = eyes(self.world, self.stage.alpha, slope_for(width, height))
        self.stage.draw(camera, width, height)
        if self._develop:
            self._develop = False
            self._copy_frame(width, height)

    def _copy_frame(self, width: int, height: int) -> None:
        left, low, wide, tall = (round(side) for side in frame_box(width, height))
        self._remove_print()
        self.photograph = Texture.create(wide, tall)
        gl.glBindTexture(gl.GL_TEXTURE_2D, self.photograph.id)
        gl.glCopyTexSubImage2D(gl.GL_TEXTURE_2D, 0, 0, 0, left, low, wide, tall)

    def pressed(self, name: str) -> None:
        """Steer, pause or ask for help."""
        if name in ("escape", "pad_start"):
            self._pause()
        elif name in ("h", "pad_back"):
            self.game.open(HelpScreen(self.game))
        elif name == "i":
            self.inspect()
        else:
            self.controls.press(name)

    def inspect(self) -> None:
        """Look into the fishes' minds."""
        self.controls.release_all()
        self.game.open(InspectorScreen(self.game, self))

    def released(self, name: str) -> None:
        """Let go."""
        self.controls.release(name)

    def moved(self, dx: float, dy: float) -> None:
        """Steer by mouse."""
        self.controls.mouse_moved(dx, dy)

    def clicked(self, _x: float, _y: float) -> None:
        """Photograph."""
        self.controls.press("mouse_left")

    def wheel(self, notches: float) -> None:
        """Set the throttle by the wheel."""
        self.controls.wheel_turned(notches)

    def stick(self, name: str, deflection: float) -> None:
        """Steer by gamepad."""
        self.controls.stick_moved(name, deflection)

    def focus_lost(self) -> None:
        """Pause: nobody is at the helm."""
        self._pause()

    def _pause(self) -> None:
        self.controls.release_all()
        self.game.open(PauseScreen(self))
