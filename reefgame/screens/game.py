"""What all screens share: the levels, the stage, settings, progress, recordings and messages."""

import re
from collections.abc import Callable, Sequence
from datetime import datetime
from pathlib import Path

from platformdirs import user_data_path

from reefgame import settings
from reefgame.console import say
from reefgame.content import Content
from reefgame.progress import Progress
from reefgame.recordings import Recording
from reefgame.screens.screen import Screen, ScreenStack
from reefgame.screens.stage import Stage
from reefgame.settings import Settings
from reefgame.shelf import LevelCard
from systems.sea.choose import Backend


class Game:
    """The state behind the screens; it outlives each of them."""

    def __init__(
        self,
        levels: Sequence[LevelCard],
        load: Callable[[str], Content],
        start: str,
        seed: int,
        record: Path | None = None,
        live: int | None = None,
        fibres: Backend = "auto",
    ) -> None:
        self.levels = tuple(levels)
        self.load = load
        self.chosen = start
        self.seed = seed
        self.record = record
        self._live = live
        self._fibres: Backend = fibres
        self.stack = ScreenStack()
        self.settings, wrong = settings.load()
        self.progress = Progress()
        self.messages: list[str] = [*wrong, *self.progress.warnings]
        self.quit: Callable[[], None] = self.stack.close
        self.apply: Callable[[Settings], None] = lambda _: None
        self.to_title: Callable[[], None] = self.stack.close
        self._stage: Stage | None = None
        self._recorded = 0

    @property
    def live(self) -> int:
        """Fishes in live physics at most in the next dive, as command line or replay asked, else as settings say."""
        return self.settings.live_physics if self._live is None else self._live

    @property
    def stage(self) -> Stage:
        """The sea on show, of the level chosen, for a dive. Raise ContentError where the level is at fault."""
        stage = self._stage
        fits = stage is not None and stage.world.level.name == self.chosen
        if stage is None or not fits or stage.world.live_fishes != self.live:
            content = self.load(self.chosen)
            if stage is not None:
                stage.delete()
            stage = self._stage = Stage(content, self.seed, self.settings, self.live, self._fibres)
        return stage

    @property
    def backdrop(self) -> Stage:
        """The sea to show behind the title: the one on show, whatever level was chosen since."""
        return self._stage or self.stage

    @property
    def card(self) -> LevelCard:
        """The level chosen."""
        return next(card for card in self.levels if card.name == self.chosen)

    def change(self, changed: Settings) -> None:
        """Take the settings, save them and draw by them."""
        self.settings = changed
        warning = settings.save(changed)
        if warning:
            self.say(warning)
        self.apply(changed)

    def say(self, message: str) -> None:
        """Show the player a line; it is printed where the game was started, too."""
        self.messages.append(message)
        say(message)

    def begin_recording(self) -> Recording:
        """Begin the recording of a dive. --record names the first dive's file; the rest end in -2 ...

        Raise InputError where the file that was asked for cannot be written.
        """
        also = self.record
        self._recorded += 1
        if also is not None and self._recorded > 1:
            also = also.with_stem(f"{also.stem}-{self._recorded}")
        recording = Recording(self.stage.world, also)
        if recording.warning:
            self.say(recording.warning)
        return recording

    def picture_path(self) -> Path:
        """Return where the next picture goes: a name in the user's folder that nothing has yet."""
        folder = user_data_path("reefgame") / "pictures"
        folder.mkdir(parents=True, exist_ok=True)
        level = re.sub(r"\W+", "-", self.chosen)
        stem = f"{level}-{datetime.now().astimezone():%Y%m%d-%H%M%S}"
        names = (f"{stem}{f'-{again}' if again else ''}.png" for again in range(1000))
        return next(path for name in names if not (path := folder / name).exists())

    def open(self, screen: Screen) -> None:
        """Open `screen` above the others."""
        self.stack.push(screen)
