"""The command line (DESIGN 8). Each command imports what it needs when it runs, so that help is quick.

Exit status: 0 done, 1 the input is at fault (one line each, no traceback), 2 wrong usage.
"""

import argparse
import json
import re
import sys
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path

from components.fault import FaultError
from reefgame import VERSION
from reefgame.console import InputError, complain, open_streams, progress_bar, say
from reefgame.puppets import add_retouch
from reefgame.video_command import add_video

_LARGEST_SIDE = 16_384
_LARGEST_SEED = 2**62
_MOST_JOBS = 1000
_NEGATIVE = (
    "--from",
    "--at",
    "--seed",
    "--tick",
    "--ticks",
    "--size",
    "--checksum-every",
    "--live",
    "--jobs",
    "--fps",
    "--hz",
    "--select",
)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; return the exit status."""
    open_streams()
    try:
        options = _parser().parse_args(_joined(sys.argv[1:] if arguments is None else arguments))
        status: int = options.run(options)
    except KeyboardInterrupt:
        return 130
    except BrokenPipeError:
        return 1
    except MemoryError:
        complain("this needs more memory than there is")
        return 1
    except OSError as error:
        if error.filename is None:
            raise
        complain(f"{error.filename}: {error.strerror}")
        return 1
    except FaultError as error:
        complain(str(error))
        return 1
    return status


def _joined(arguments: Sequence[str]) -> list[str]:
    """Join an option and the value after it that begins with a minus: argparse takes it for an option."""
    joined: list[str] = []
    for argument in arguments:
        if joined and joined[-1] in _NEGATIVE and re.match(r"-[\d.]", argument):
            joined[-1] = f"{joined[-1]}={argument}"
        else:
            joined.append(argument)
    return joined


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="reefgame", description="A living reef: play it, mod it, record it, prove it."
    )
    parser.add_argument("--version", action="version", version=f"reefgame {VERSION}")
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    for add in (
        _add_play,
        _add_replay,
        _add_shot,
        _add_content,
        _add_soak,
        _add_capture,
        add_video,
        add_retouch,
        _add_bench,
    ):
        add(commands)
    return parser


_Commands = argparse._SubParsersAction


def _add_play(commands: "_Commands[argparse.ArgumentParser]") -> None:
    play = commands.add_parser("play", help="play a level", description="Play a level.")
    play.add_argument("level", nargs="?", help="a level's name; without it the title screen asks")
    _world_options(play)
    play.add_argument("--record", type=Path, metavar="FILE", help="write the dive's replay here")
    play.add_argument("--size", type=_size, metavar="WxH", help="the window's size")
    _live_option(play)
    _fibres_option(play)
    play.add_argument("--headless", action="store_true", help="no window: a scripted pilot dives")
    play.set_defaults(run=_play)


def _add_replay(commands: "_Commands[argparse.ArgumentParser]") -> None:
    replay = commands.add_parser("replay", help="play a recorded dive again, or prove it")
    replay.add_argument("file", type=Path)
    replay.add_argument("--mod", type=Path, action="append", default=[], metavar="DIR")
    replay.add_argument("--verify", action="store_true", help="compare every checksum, no picture")
    replay.add_argument("--headless", action="store_true", help="no window")
    replay.add_argument(
        "--checksum-every", type=_count, metavar="N", help="with -o: ticks between checksums"
    )
    replay.add_argument(
        "-o", "--output", type=Path, metavar="FILE", help="record what was played again"
    )
    replay.add_argument("--video", type=Path, metavar="OUT.mp4", help="film it")
    replay.add_argument(
        "--picture", type=Path, metavar="OUT.png", help="the picture of its best moment"
    )
    replay.add_argument("--size", type=_size, default=(960, 540), metavar="WxH", help="of the film")
    replay.set_defaults(run=_replay)


def _add_shot(commands: "_Commands[argparse.ArgumentParser]") -> None:
    shot = commands.add_parser("shot", help="take a picture of a level, a species or a plant")
    shot.add_argument("level", nargs="?")
    shot.add_argument("--species", metavar="NAME", help="a portrait of this species instead")
    shot.add_argument("--flora", metavar="NAME", help="a portrait of this plant instead")
    _world_options(shot)
    shot.add_argument("--tick", type=_count, default=300, metavar="N", help="when (60 a second)")
    shot.add_argument("--from", dest="eye", type=_point, metavar="X,Y,Z", help="where from [m]")
    shot.add_argument("--at", type=_point, metavar="X,Y,Z", help="looking at [m]")
    shot.add_argument("--size", type=_size, default=(1280, 720), metavar="WxH")
    _live_option(shot)
    _fibres_option(shot)
    shot.add_argument("-o", "--output", type=Path, required=True, metavar="OUT.png")
    shot.set_defaults(run=_shot)


def _add_content(commands: "_Commands[argparse.ArgumentParser]") -> None:
    check = commands.add_parser("check", help="check species, flora, levels and mods")
    check.add_argument("paths", type=Path, nargs="+", metavar="PATH")
    check.set_defaults(run=_check)
    listing = commands.add_parser("list", help="list what there is")
    listing.add_argument("what", choices=("levels", "species", "flora", "mods"))
    listing.add_argument("--mod", type=Path, action="append", default=[], metavar="DIR")
    listing.set_defaults(run=_list)
    schema = commands.add_parser("schema", help="print a JSON Schema for editors")
    schema.add_argument("kind", choices=("species", "flora", "level", "mod"))
    schema.set_defaults(run=_schema)
    new = commands.add_parser("new", help="begin a mod, a species, a plant or a level")
    new.add_argument("kind", choices=("mod", "species", "flora", "level"))
    new.add_argument("name")
    new.add_argument("--in", dest="folder", type=Path, default=Path(), metavar="DIR")
    new.set_defaults(run=_new)


def _add_soak(commands: "_Commands[argparse.ArgumentParser]") -> None:
    soak = commands.add_parser("soak", help="run a level headless for long")
    soak.add_argument("level")
    _world_options(soak)
    soak.add_argument("--ticks", type=_count, required=True, metavar="N")
    _live_option(soak)
    soak.add_argument("--trace", type=Path, metavar="OUT.npz", help="what every fish did")
    soak.set_defaults(run=_soak)


def _add_capture(commands: "_Commands[argparse.ArgumentParser]") -> None:
    capture = commands.add_parser("capture", help="capture repertoires from muscle physics")
    capture.add_argument("species", type=Path, nargs="+", metavar="SPECIES.yaml")
    capture.add_argument("-o", "--output", type=Path, metavar="DIR", help="where the .npz go")
    capture.add_argument(
        "--report", type=Path, metavar="DIR", help="a page of figures and tables, index.html"
    )
    capture.add_argument(
        "--control-points", action="store_true", help="for populous species: record the skin too"
    )
    capture.add_argument(
        "--tune", action="store_true", help="find each swim from the body, write it into the file"
    )
    capture.add_argument(
        "--seed", type=_seed, default=0, metavar="N", help="with --tune: what chance starts from"
    )
    capture.add_argument(
        "--jobs", type=_jobs, metavar="N", help="with --tune: processes, else one a processor"
    )
    capture.add_argument(
        "--scheduler", metavar="ADDRESS", help="with --tune: the Dask scheduler whose workers do it"
    )
    capture.set_defaults(run=_capture)


def _add_bench(commands: "_Commands[argparse.ArgumentParser]") -> None:
    bench = commands.add_parser("bench", help="measure, both sides of each ratio in one run")
    bench.add_argument(
        "names",
        nargs="+",
        metavar="NAME",
        help="motor, minds, fibres, step, view, video, startup, memory or all",
    )
    bench.add_argument("--json", type=Path, metavar="FILE")
    bench.set_defaults(run=_bench)


def _world_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--mod", type=Path, action="append", default=[], metavar="DIR", help="add a mod"
    )
    parser.add_argument(
        "--seed", type=_seed, default=None, metavar="N", help="what chance starts from"
    )


def _live_option(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--live", type=_fishes, metavar="N", help="simulate so many of the nearest fishes (0-50)"
    )


def _fibres_option(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--fibres",
        choices=("opencl", "numba"),
        help="what bends the plants; both bend them alike",
    )


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"([0-9]{1,5})x([0-9]{1,5})", text)
    if not match or not all(1 <= int(side) <= _LARGEST_SIDE for side in match.groups()):
        raise InputError(f"size '{text}': two numbers from 1 to {_LARGEST_SIDE}, such as 1280x720")
    return int(match.group(1)), int(match.group(2))


def _whole(text: str, what: str, most: int) -> int:
    if not re.fullmatch(r"[0-9]{1,19}", text) or int(text) > most:
        raise InputError(f"{what} '{text}': a whole number from 0 to {most} is expected")
    return int(text)


def _seed(text: str) -> int:
    return _whole(text, "seed", _LARGEST_SEED)


def _count(text: str) -> int:
    return _whole(text, "number of ticks", 10**9)


def _fishes(text: str) -> int:
    from components.live import MOST_LIVE

    return _whole(text, "number of fishes", MOST_LIVE)


def _jobs(text: str) -> int:
    jobs = _whole(text, "number of jobs", _MOST_JOBS)
    if jobs == 0:
        raise InputError(f"number of jobs '0': a whole number from 1 to {_MOST_JOBS} is expected")
    return jobs


def _point(text: str) -> tuple[float, float, float]:
    number = r"\s*(-?[0-9]+(?:\.[0-9]+)?)\s*"
    match = re.fullmatch(f"{number},{number},{number}", text)
    if not match:
        raise InputError(f"point '{text}': three numbers in metres are expected, such as 1.5,-2,-6")
    return float(match[1]), float(match[2]), float(match[3])


def _play(options: argparse.Namespace) -> int:
    if options.headless:
        from reefgame.headless import dive

        level, seed = options.level or "first_dive", options.seed or 0
        return dive(level, options.mod, seed, options.record, options.live or 0)
    from reefgame.window import play

    return play(
        options.level,
        options.mod,
        options.seed,
        options.record,
        options.size,
        options.live,
        options.fibres or "auto",
    )


def _replay(options: argparse.Namespace) -> int:
    from reefgame.headless import replay

    return replay(options)


def _shot(options: argparse.Namespace) -> int:
    from reefgame.shot import shoot

    subjects = (options.level, options.species, options.flora)
    if sum(subject is not None for subject in subjects) != 1:
        raise InputError("shot needs a level's name, --species NAME or --flora NAME, one of them")
    if options.at is None and options.eye is not None:
        raise InputError("--from needs --at as well")
    shoot(options)
    say(f"{options.output}")
    return 0


def _check(options: argparse.Namespace) -> int:
    from reefgame.content import check

    problems = check(options.paths)
    for problem in problems:
        complain(str(problem))
    if not problems:
        say("no fault found")
    return 1 if problems else 0


def _list(options: argparse.Namespace) -> int:
    from reefgame import content

    listing = {
        "levels": content.list_levels,
        "species": content.list_species,
        "flora": content.list_flora,
        "mods": content.list_mods,
    }
    for line in listing[options.what](options.mod):
        say(str(line))
    if options.what != "mods":
        for mod in content.list_disabled(options.mod):
            complain(str(mod))
    return 0


def _schema(options: argparse.Namespace) -> int:
    from reefgame.content import json_schema

    say(json.dumps(json_schema(options.kind), indent=2))
    return 0


def _new(options: argparse.Namespace) -> int:
    from reefgame.content import new

    for path in new(options.kind, options.name, options.folder):
        say(f"{path}")
    return 0


def _soak(options: argparse.Namespace) -> int:
    from reefgame.opening import open_level
    from reefgame.output import check_output
    from reefgame.soak import Trace, soak
    from reefgame.world import World

    check_output(options.trace)
    world = World.build(
        open_level(options.level, options.mod, live=bool(options.live)),
        options.seed or 0,
        options.live or 0,
    )
    doing = f"{options.ticks} ticks of {options.level}"
    with ExitStack() as kept:
        trace = kept.enter_context(Trace(options.trace)) if options.trace else None
        with progress_bar(doing) as report:
            soak(world, options.ticks, trace=trace, report=lambda done: report(done, doing))
        if trace is not None:
            trace.save()
    for name, value in world.checksums().items():
        say(f"{name} {value:016x}")
    return 0


def _capture(options: argparse.Namespace) -> int:
    from reefgame.captures import capture_files
    from reefgame.tuning import Tuning

    tuning = Tuning(options.seed, options.jobs, options.scheduler) if options.tune else None
    if tuning is None and (options.jobs or options.scheduler):
        raise InputError("--jobs and --scheduler need --tune")

    return capture_files(
        options.species, options.output, options.report, tuning, options.control_points
    )


def _bench(options: argparse.Namespace) -> int:
    from reefgame.bench.run import run

    return run(options.names, options.json)


if __name__ == "__main__":
    sys.exit(main())
