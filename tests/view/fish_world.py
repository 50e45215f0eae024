"""A library of made-up swimming shapes, and populations in chosen poses, for tests of the drawn fishes."""

from collections.abc import Sequence

import numpy as np

from components.arrays import Float32s, Float64s
from components.body import Body, Swim, rest_nodes
from components.fish import Population
from components.mind import Role
from components.repertoire import Pattern, Repertoire, RepertoireLibrary
from components.skin import Skin
from components.species import Species

FRAMES = 24


def swimming_shapes(body: Body, frames: int = FRAMES) -> Float32s:
    """Return shapes (frames, 23, 3) of a wave that runs along the body and grows towards the tail."""
    rest = rest_nodes(body)
    back = -rest[:, 0]
    shapes = np.repeat(rest[None], frames, axis=0)
    phase = 2.0 * np.pi * np.arange(frames)[:, None] / frames
    amplitude = 0.012 + 0.075 * back**2
    bend = amplitude * np.sin(phase - 2.0 * np.pi * back / 1.2)
    swing = np.gradient(amplitude) * 0.0 - 2.0 * np.pi / 1.2 * amplitude * np.cos(
        phase - 2.0 * np.pi * back / 1.2
    )
    shapes[:, :, 0] += -swing * rest[:, 2] * -1.0
    shapes[:, :, 2] += bend
    shapes[:, :, 0] += 0.35
    return shapes.astype(np.float32)


def library_of(bodies: Sequence[Body]) -> RepertoireLibrary:
    """Return a library with one swimming segment for each body."""
    shape = np.concatenate([swimming_shapes(body) for body in bodies])
    entries, count = len(shape), len(bodies)
    start = FRAMES * np.arange(count, dtype=np.int32)
    return RepertoireLibrary(
        rotation=np.repeat(np.eye(3)[None], entries, axis=0),
        translation=np.zeros((entries, 3)),
        shape=shape,
        start=start,
        length=np.full(count, FRAMES, np.int32),
        loops=np.ones(count, np.int8),
        pattern=np.full(count, int(Pattern.SWIM_MEDIUM), np.int8),
        segment=np.repeat(np.arange(count, dtype=np.int32)[:, None], 5, axis=1),
        speed=np.ones(count),
        turn=np.zeros(count),
    )


def species_of(name: str, body: Body, skin: Skin) -> Species:
    """Return a species with no repertoire of its own."""
    return Species(
        name=name,
        title=name,
        role=Role.PREY,
        schooling=True,
        length=0.2,
        length_spread=0.1,
        sight=4.0,
        spacing=1.0,
        depth=(1.0, 20.0),
        body=body,
        swim=Swim(0.3, 0.5, 140.0, 3.0),
        skin=skin,
        repertoire=Repertoire((), {}),
    )


def rotation_of(forward: Float64s, up: tuple[float, float, float] = (0.0, 0.0, 1.0)) -> Float64s:
    """Return the rotation whose first column looks along `forward`."""
    x = np.asarray(forward, np.float64) / np.linalg.norm(forward)
    z = np.cross(x, up)
    z /= np.linalg.norm(z)
    return np.stack((x, np.cross(z, x), z), axis=1)


def population_of(
    positions: Float64s, rotations: Float64s, lengths: Float64s, species: Sequence[int]
) -> Population:
    """Return fishes at rest between two ticks at the places given."""
    population = Population()
    rows = population.append(np.arange(len(positions), dtype=np.int64))
    fish, motor = population.fish, population.motor
    fish.position[rows], fish.last_position[rows] = positions, positions
    fish.rotation[rows], fish.last_rotation[rows] = rotations, rotations
    fish.length[rows], fish.species[rows] = lengths, species
    row = FRAMES * np.asarray(species, np.int32) + np.arange(len(positions)) % FRAMES
    motor.shape_row[rows], motor.last_shape_row[rows] = row, row
    motor.warp_from[rows], motor.warp_to[rows] = row, row
    return population
