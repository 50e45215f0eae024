"""Pictures taken without a window: `reefgame shot`."""

import argparse

import numpy as np

from components.arrays import Float64s
from components.camera import Camera, camera_towards
from components.clock import TICKS_PER_SECOND
from components.fish import Population
from components.repertoire import RepertoireLibrary, pack
from components.species import Species
from reefgame.console import progress_bar
from reefgame.content import load_species, read_flora
from reefgame.filming import COCKPIT_SLOPE, cockpit
from reefgame.opening import open_level
from reefgame.output import check_output, replacing
from reefgame.picture import picture
from reefgame.plant_portrait import plant_portrait
from reefgame.scene import QUALITIES
from reefgame.viewpoint import viewpoint
from reefgame.world import World
from systems.sea.choose import Backend
from systems.view.context import ensure_context
from systems.view.draw_fish import DrawFish
from systems.view.draw_water import DrawWater
from systems.view.frame import FrameBlock, Look
from systems.view.target import Target, UInt8s, start_drawing, stop_drawing, write_png


def shoot(options: argparse.Namespace) -> None:
    """Take the picture that `reefgame shot` was asked for; options are those of the command line.

    Raise ContentError, InputError, NoOpenGLError or TargetError, one line each.
    """
    check_output(options.output)
    ensure_context()
    if options.species is not None:
        drawn = portrait(load_species(options.species, options.mod), *options.size)
    elif options.flora is not None:
        flora, company = read_flora(options.flora, options.mod), load_species("clownfish")
        drawn = plant_portrait(flora, company, *options.size)
    else:
        world = _dived(options)
        seconds = options.tick / TICKS_PER_SECOND
        width, height = options.size
        camera = _camera(world, options)
        fibres: Backend = options.fibres or "numba"
        drawn = picture(world, camera, width, height, seconds, fibres=fibres)
    with replacing(options.output) as fresh:
        write_png(fresh, drawn)


def portrait(species: Species, width: int, height: int, seconds: float = 0.0) -> UInt8s:
    """Return the right side of an adult `species` in open water, (height, width, 3)."""
    look, library = Look(sun_azimuth=250.0), pack([species.repertoire])
    at = np.array([0.0, 0.0, -4.0])
    slope = 0.41
    away = 0.47 * species.length / slope * max(1.0, height / width * 1.2)
    camera = camera_towards(at + np.array([0.25, -1.0, 0.12]) * away, at, slope)
    with Target(width, height, QUALITIES["high"].samples) as target:
        frame, water, fish = (
            FrameBlock(),
            DrawWater(),
            DrawFish([species], library),
        )
        target.bind()
        start_drawing(width, height)
        frame.update(camera, width, height, seconds, look)
        water.draw()
        fish.draw(
            _alone(species, library, at),
            camera,
            1.0,
            seconds,
            height,
            look.visibility,
            width / height,
        )
        stop_drawing()
        drawn = target.read()
        for part in (frame, water, fish):
            part.delete()
    return drawn


def _alone(species: Species, library: RepertoireLibrary, at: Float64s) -> Population:
    """Return a population of one adult that looks along x, upright, in its first frame."""
    population = Population()
    row = population.append(np.zeros(1, np.int64))
    fish = population.fish
    fish.length[row] = species.length
    # Its origin lies ahead of its middle.
    ends = library.shape[0, :, 0]
    middle = np.array([0.5 * (ends.max() + ends.min()) * species.length, 0.0, 0.0])
    fish.position[row] = fish.last_position[row] = at - middle
    # Columns: anterior along x, dorsal up, right along -y.
    upright = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    fish.rotation[row] = fish.last_rotation[row] = upright
    return population


def _dived(options: argparse.Namespace) -> World:
    """Return the level's world after the ticks asked for."""
    world = World.build(
        open_level(options.level, options.mod), options.seed or 0, options.live or 0
    )
    with progress_bar("diving") as report:
        for tick in range(options.tick):
            world.tick()
            if tick % TICKS_PER_SECOND == 0:
                report(tick / options.tick, "diving")
    return world


def _camera(world: World, options: argparse.Namespace) -> Camera:
    if options.at is None:
        return viewpoint(world)
    eye = cockpit(world).eye if options.eye is None else np.array(options.eye)
    return camera_towards(eye, np.array(options.at), COCKPIT_SLOPE)
