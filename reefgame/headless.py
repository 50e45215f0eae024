"""Dives without a window: a scripted pilot's, and replays that are proven, filmed or recorded again."""

import argparse
from collections.abc import Sequence
from pathlib import Path

from components.clock import TICKS_PER_SECOND
from reefgame import VERSION
from reefgame.autopilot import Photographer
from reefgame.console import InputError, complain, progress_bar, say
from reefgame.content import Content
from reefgame.opening import open_level
from reefgame.output import check_output, replacing
from reefgame.recordings import Recording
from reefgame.replay import Recorder, Replay, read_replay, verify
from reefgame.world import World

LONGEST_DIVE_SECONDS = 180


def dive(level: str, mods: Sequence[Path], seed: int, record: Path | None, live: int = 0) -> int:
    """Let a scripted pilot play the level, record it and say what came of it; return the exit status."""
    world = World.build(open_level(level, mods, live=live > 0), seed, live)
    pilot = Photographer()
    ticks = LONGEST_DIVE_SECONDS * TICKS_PER_SECOND
    recording = Recording(world, record)
    try:
        with progress_bar(f"diving in {level}") as report:
            for tick in range(ticks):
                command = pilot(world)
                world.tick(command)
                recording.tick(command)
                if tick % TICKS_PER_SECOND == 0:
                    report(tick / ticks, f"diving in {level}")
                if world.objective.live("done").all():
                    break
    finally:
        recording.close()
    say(_story(world))
    if recording.warning is None:
        say(f"recorded in {recording.path}")
        return 0
    complain(f"warning: {recording.warning}")
    return 1 if record else 0


def replay(options: argparse.Namespace) -> int:
    """Play a recorded dive again as the command line's options say; return the exit status."""
    record = read_replay(options.file)
    _same_version(options.file, record)
    outputs = (options.output, options.video, options.picture)
    for path in outputs:
        check_output(path)
    watched = not (options.headless or options.verify or any(outputs))
    if watched or options.video or options.picture:
        _something_to_see(options.file, record)
    content = open_level(record.level, options.mod, not watched, record.live > 0)
    _same_content(options.file, record, content)
    if watched:
        from reefgame.window import watch

        return watch(record, content)
    world = World.build(content, record.seed, record.live)
    if options.output:
        return _record_again(record, world, options.output, options.checksum_every or record.every)
    if options.video or options.picture:
        from reefgame.filming import film

        film(record, world, options.video, options.picture, options.size)
        return 0
    return _verify(record, world, options.file)


def _same_version(path: Path, record: Replay) -> None:
    if record.game != VERSION:
        raise InputError(f"{path}:2:1: recorded with reefgame {record.game}, this is {VERSION}")


def _same_content(path: Path, record: Replay, content: Content) -> None:
    if record.content != content.hash:
        raise InputError(
            f"{path}:4:1: recorded with other content of level '{record.level}' than is installed; "
            "the same mods must be given"
        )


def _something_to_see(path: Path, record: Replay) -> None:
    if record.ticks == 0:
        after = 7 if record.live > 0 else 6
        raise InputError(
            f"{path}:{after}:1: no tick was recorded after the header; a dive of one tick at least can be shown"
        )


def _verify(record: Replay, world: World, path: Path) -> int:
    with progress_bar(f"verifying {path.name}") as report:
        desync = verify(
            record, world, lambda tick: report(tick / max(record.ticks, 1), "verifying")
        )
    if desync is not None:
        raise InputError(f"{path}: {desync}")
    cut = "" if record.ended else "; the recording was cut short"
    checked = len(record.checksums)
    say(f"{record.ticks} ticks, {checked} checksums of {len(world.tables)} tables equal{cut}")
    return 0


def _record_again(record: Replay, world: World, output: Path, every: int) -> int:
    with (
        replacing(output) as fresh,
        progress_bar(f"recording {output.name}") as report,
        fresh.open("w", encoding="ascii", newline="\n") as stream,
    ):
        recorder = Recorder(world, stream, record.level, max(every, 1))
        for tick, command in enumerate(record.play()):
            world.tick(command)
            recorder.tick(command)
            report(tick / record.ticks, "recording")
        recorder.finish()
    say(f"{output}")
    return 0


def _story(world: World) -> str:
    seconds = world.clock.now / TICKS_PER_SECOND
    if world.objective.live("done").all():
        return f"won after {seconds:.0f} s with {int(world.objective.score[0])} points"
    best = int(world.objective.best[0])
    return f"not won in {seconds:.0f} s; the best photograph held {best}"
