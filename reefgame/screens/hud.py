"""The cockpit's instruments: compass, depth, speed, throttle, task, time, prompts and messages.

Numbers are rounded first and texts touched only where they differ, so a frame costs little.
"""

from math import atan2, degrees, hypot

from components.clock import TICKS_PER_SECOND
from reefgame.screens import theme
from reefgame.screens.canvas import Canvas, Panel, Text
from reefgame.screens.fish_panel import FishPanel
from reefgame.screens.theme import Colour, faded
from reefgame.world import World

_POINTS = ("N", "NE", "E", "SE", "S", "SW", "W", "NW")
_TAPE_HALF = 70.0
"""[deg] of heading that the compass shows to either side."""
_MESSAGE_SECONDS = 3.4
_FADE_SECONDS = 0.5


def bearing(yaw: float) -> float:
    """Return the compass bearing [deg, 0 to 360) of a yaw [rad]: +y is north, +x east."""
    return (90.0 - degrees(yaw)) % 360.0


def plural(title: str, count: int) -> str:
    """Return a species' name as it reads after a number."""
    name = title.lower()
    return name if count == 1 or name.endswith(("fish", "s")) else f"{name}s"


def verdict(framed: int, wanted: int, name: str, done: bool) -> str:
    """Return what a photograph of `framed` animals is worth, in a few words."""
    if done:
        return f"{framed} {name} in one frame. Perfect!"
    if framed == 0:
        return f"No {name} in the frame, or too far away"
    return f"{framed} {name}, {wanted - framed} more: get closer"


def hint(canvas: Canvas, text: str) -> None:
    """Add a line about keys at the lower right; a narrow window has no room for it."""
    u = canvas.unit
    right = canvas.width - 14 * u
    written = canvas.text(
        text, right - 12 * u, 26 * u, theme.TINY, theme.MIST, "right center", order=1
    )
    left = right - written.width - 24 * u
    if left > 0.5 * canvas.width + 245 * u:
        canvas.panel(left, 14 * u, right - left, 24 * u, faded(theme.DEEP, 0.75), radius=8 * u)
    else:
        written.set("")


class Compass:
    """A strip of bearings that slides below a mark."""

    def __init__(self, canvas: Canvas) -> None:
        u = canvas.unit
        self._middle, self._top, self._unit = 0.5 * canvas.width, canvas.height - 16 * u, u
        self._half = 150 * u
        canvas.panel(
            self._middle - self._half - 14 * u, self._top - 34 * u, 2 * self._half + 28 * u, 40 * u,
            faded(theme.DEEP, 0.75), radius=10 * u,
        )  # fmt: skip
        self._ticks = [
            canvas.panel(0, 0, max(1.0, u), 5 * u, theme.HAZE, order=1) for _ in range(24)
        ]
        self._names = [
            canvas.text(
                name, 0, -99, theme.SMALL if at % 2 else theme.BODY,
                theme.HAZE if at % 2 else theme.FOAM, "center center", order=1,
            )
            for at, name in enumerate(_POINTS)
        ]  # fmt: skip
        canvas.panel(
            self._middle - u, self._top - 31 * u, 2 * u, 9 * u, theme.SUNLIT, radius=u, order=2
        )
        self._shown = -1.0

    def show(self, heading: float) -> None:
        """Slide the strip to `heading` [deg]."""
        heading = round(heading * 4.0) / 4.0 % 360.0
        if heading == self._shown:
            return
        self._shown = heading
        for at, tick in enumerate(self._ticks):
            x = self._across(15.0 * at - heading)
            if x is None:
                tick.hide()
            else:
                tick.place(x, self._top - 29 * self._unit, max(1.0, self._unit), 5 * self._unit)
        for at, name in enumerate(self._names):
            x = self._across(45.0 * at - heading)
            name.move(-99.0 if x is None else x, self._top - 10 * self._unit)

    def _across(self, away: float) -> float | None:
        away = (away + 180.0) % 360.0 - 180.0
        if abs(away) > _TAPE_HALF:
            return None
        return float(round(self._middle + self._half * away / _TAPE_HALF))


class Gauge:
    """A number with its unit over a small name."""

    def __init__(self, canvas: Canvas, x: float, low: float, name: str) -> None:
        u = canvas.unit
        self._number = canvas.text(
            "", x, low + 24 * u, theme.LARGE, anchor="center baseline", order=1
        )
        canvas.text(name, x, low + 9 * u, theme.TINY, theme.HAZE, "center baseline", order=1)

    def show(self, text: str) -> None:
        """Show `text`."""
        self._number.set(text)


class Throttle:
    """A bar that grows upwards ahead and downwards astern."""

    def __init__(self, canvas: Canvas, x: float, low: float, width: float) -> None:
        u = canvas.unit
        self._x, self._low, self._width, self._unit = x, low + 26 * u, width, u
        canvas.panel(x, self._low, width, 8 * u, (255, 255, 255, 26), radius=4 * u, order=1)
        self._bar = canvas.panel(0, 0, 0, 0, theme.LAGOON, radius=4 * u, order=2)
        canvas.panel(
            x + 0.5 * width - 0.5 * u, self._low - 2 * u, max(1.0, u), 12 * u, theme.HAZE, order=3
        )
        canvas.text(
            "THROTTLE", x + 0.5 * width, low + 9 * u, theme.TINY, theme.HAZE, "center baseline",
            order=1,
        )  # fmt: skip

    def show(self, setting: float) -> None:
        """Show a setting from -1 to 1."""
        setting = round(setting * 50.0) / 50.0
        middle, reach = self._x + 0.5 * self._width, 0.5 * self._width * abs(setting)
        self._bar.paint(theme.LAGOON if setting >= 0 else theme.CORAL)
        left = middle if setting >= 0 else middle - reach
        self._bar.place(left, self._low, reach, 8 * self._unit)


class Banner:
    """A line on a pill that fades by itself: prompts stay, messages go."""

    def __init__(self, canvas: Canvas, low: float, size: float, colour: Colour) -> None:
        self._canvas, self._low, self._colour = canvas, low, colour
        self._height = (size + 17) * canvas.unit
        self._pill: Panel = canvas.panel(
            0, 0, 0, 0, theme.ABYSS, radius=0.5 * self._height, rim=theme.CLEAR,
            rim_width=max(1.0, 1.2 * canvas.unit), order=3,
        )  # fmt: skip
        middle = low + 0.5 * self._height
        self._text: Text = canvas.text(
            "", 0.5 * canvas.width, middle, size, colour, "center center", order=3
        )
        self._step = -1

    def show(self, text: str, opacity: float) -> None:
        """Show `text`, or nothing at opacity 0."""
        step = round(20 * max(0.0, min(1.0, opacity))) if text else 0
        self._text.set(text if step else "", faded(self._colour, step / 20))
        if not step:
            self._pill.hide()
            return
        width = self._text.width + 2 * self._height
        self._pill.place(0.5 * (self._canvas.width - width), self._low, width, self._height)
        if step != self._step:
            self._step = step
            rim = faded(faded(self._colour, 0.35), step / 20)
            self._pill.paint(faded(theme.ABYSS, step / 20), rim=rim)


class Hud:
    """All instruments, shown from the world."""

    def __init__(self, canvas: Canvas, world: World) -> None:
        u, middle = canvas.unit, 0.5 * canvas.width
        self._world = world
        self.compass = Compass(canvas)
        strip, low = min(470 * u, canvas.width - 16 * u), 14 * u
        canvas.card(middle - 0.5 * strip, low, strip, 56 * u)
        self._depth = Gauge(canvas, middle - 0.39 * strip, low, "DEPTH")
        self._speed = Gauge(canvas, middle - 0.16 * strip, low, "SPEED")
        self._heading = Gauge(canvas, middle + 0.07 * strip, low, "HEADING")
        self._throttle = Throttle(canvas, middle + 0.20 * strip, low, 0.25 * strip)
        self._task = self._corner(canvas) if world.goals else None
        right, top, wide = canvas.width - 14 * u, canvas.height - 10 * u, 92 * u
        canvas.panel(
            right - wide, top - 50 * u, wide, 50 * u, faded(theme.DEEP, 0.75), radius=10 * u
        )
        self._time = canvas.text(
            "", right - 14 * u, top - 25 * u, theme.LARGE, anchor="right baseline", order=1
        )
        self._shots = canvas.text(
            "", right - 14 * u, top - 42 * u, theme.SMALL, theme.MIST, "right baseline", order=1
        )
        self._fish = FishPanel(canvas, world)
        self._prompt = Banner(canvas, canvas.height - 112 * u, theme.BODY, theme.FOAM)
        self._message = Banner(canvas, canvas.height * 0.66, theme.LARGE, theme.SUNLIT)

    def _corner(self, canvas: Canvas) -> Text:
        """Say at the top left what is to be done; return the text that says how far it is."""
        u, goal = canvas.unit, self._world.goals[0]
        name = plural(self._world.species[goal.species].title, goal.count)
        left, top = 14 * u, canvas.height - 10 * u
        room = 0.5 * canvas.width - 190 * u
        canvas.text("PHOTOGRAPH", left + 14 * u, top - 17 * u, theme.TINY, theme.HAZE, order=1)
        told = canvas.text(
            f"{goal.count} {name} in one frame, within {goal.within:g} m", left + 14 * u,
            top - 22 * u, theme.BODY, anchor="left top", width=room - 28 * u, order=1,
        )  # fmt: skip
        tall = told.height + 46 * u
        wide = min(room, told.width + 30 * u)
        canvas.panel(left, top - tall, wide, tall, faded(theme.DEEP, 0.75), radius=10 * u)
        return canvas.text(
            "", left + 14 * u, top - tall + 8 * u, theme.SMALL, theme.SUNLIT, order=1
        )

    def show(self, prompt: str, message: str, age: float) -> None:
        """Show the world as it is, a prompt, and a message that was given `age` seconds ago."""
        depth, speed, yaw, setting = self._helm()
        heading, objective = bearing(yaw), self._world.objective
        self.compass.show(heading)
        self._depth.show(f"{depth:.1f} m")
        self._speed.show(f"{speed:.1f} m/s")
        self._heading.show(f"{round(heading) % 360:03d}\u00b0")
        self._throttle.show(setting)
        self._fish.show()
        seconds = self._world.clock.now // TICKS_PER_SECOND
        self._time.set(f"{seconds // 60}:{seconds % 60:02d}")
        if self._task is not None:
            shots, best = int(objective.shots[0]), int(objective.best[0])
            self._shots.set(f"{shots} photo{'' if shots == 1 else 's'}")
            self._task.set(f"best so far: {best}" if shots else "no photograph yet")
        self._prompt.show("" if self._world.avatar.attached else prompt, 1.0)
        self._message.show(message, (_MESSAGE_SECONDS - age) / _FADE_SECONDS)

    def _helm(self) -> tuple[float, float, float, float]:
        """Return depth [m], speed [m/s], yaw [rad] and speed setting of what the player is."""
        ship, avatar, people = self._world.submarine, self._world.avatar, self._world.population
        identity = int(avatar.fish[0])
        if identity < 0 or identity not in people:
            setting, yaw = float(ship.throttle[0]), float(ship.yaw[0])
            return -float(ship.position[0, 2]), hypot(*ship.velocity[0]), yaw, setting
        row = people.row(identity)
        place, last = people.fish.position[row], people.fish.last_position[row]
        yaw = atan2(float(avatar.gaze[0, 1]), float(avatar.gaze[0, 0]))
        speed = TICKS_PER_SECOND * hypot(*(place - last))
        return -float(place[2]), speed, yaw, float(avatar.setting[0])
