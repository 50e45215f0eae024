"""Four species to paint and draw, made-up swimming shapes, and populations in chosen poses."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Final

import numpy as np
import pytest

from components.arrays import Float32s, Float64s
from components.body import Body, Fin, Swim, rest_nodes
from components.fish import Population
from components.mind import Role
from components.repertoire import Pattern, Repertoire, RepertoireLibrary
from components.skin import Eye, Gradient, Patch, Scales, Skin, Spots, Stripes
from components.species import Species
from systems.view.skin_texture import Texels, paint_skin

SARDINE_BODY: Final = Body(
    station=(0.11, 0.28, 0.47, 0.66, 0.82),
    half_width=(0.036, 0.050, 0.047, 0.032, 0.013),
    half_height=(0.060, 0.088, 0.085, 0.058, 0.026),
    tail_span=0.105,
    tail_fork=0.085,
    dorsal=Fin(0.42, 0.56, 0.07, 0.05),
    anal=Fin(0.68, 0.80, 0.028, 0.02),
    pectoral_at=0.25,
    pectoral_length=0.11,
    pectoral_height=-0.62,
)
SARDINE_SKIN: Final = Skin(
    layers=(
        Gradient(
            colours=(
                (0.94, 0.95, 0.94),
                (0.84, 0.87, 0.89),
                (0.70, 0.77, 0.81),
                (0.52, 0.69, 0.70),
                (0.16, 0.37, 0.44),
                (0.07, 0.19, 0.28),
            ),
            at=(-1.0, -0.4, 0.15, 0.42, 0.66, 1.0),
        ),
        Stripes(colour=(0.80, 0.80, 0.58), at=(0.44,), width=0.05, softness=0.12, along=True),
        Scales(size=0.021, strength=0.42),
        Spots(
            colour=(0.09, 0.17, 0.23),
            count=10,
            size=0.0115,
            seed=4,
            height=(0.33, 0.38),
            reach=(0.23, 0.78),
            in_row=True,
        ),
        Patch(colour=(0.80, 0.78, 0.55), at=(0.13, -0.1), size=(0.05, 0.35), softness=0.9),
    ),
    eye=Eye(at=(0.085, 0.22), radius=0.025, iris=(0.86, 0.86, 0.74), pupil=0.5),
    fin=(0.62, 0.70, 0.68),
    tail=(0.55, 0.60, 0.50),
    tail_edge=(0.25, 0.30, 0.30),
    shine=0.85,
    fin_opacity=0.45,
    gill_at=0.225,
    gill_strength=0.55,
)
TANG_BODY: Final = Body(
    station=(0.11, 0.27, 0.46, 0.65, 0.80),
    half_width=(0.040, 0.058, 0.054, 0.036, 0.016),
    half_height=(0.120, 0.180, 0.185, 0.125, 0.042),
    tail_span=0.140,
    tail_fork=0.045,
    dorsal=Fin(0.22, 0.80, 0.06, 0.03),
    anal=Fin(0.44, 0.80, 0.05, 0.03),
    pectoral_at=0.27,
    pectoral_length=0.13,
    pectoral_height=-0.15,
)
_INK: Final = (0.015, 0.02, 0.06)
_BLUE: Final = (0.14, 0.44, 1.0)
TANG_SKIN: Final = Skin(
    layers=(
        Gradient(
            colours=((0.20, 0.48, 0.96), (0.14, 0.44, 1.0), (0.10, 0.34, 0.95), (0.07, 0.22, 0.77)),
            at=(-1.0, -0.2, 0.4, 1.0),
        ),
        Scales(size=0.014, strength=0.16),
        Patch(colour=_INK, at=(0.52, 0.26), size=(0.36, 0.62), softness=0.10, tilt_deg=2.0),
        Patch(colour=_BLUE, at=(0.47, 0.14), size=(0.20, 0.36), softness=0.14, tilt_deg=6.0),
        Stripes(colour=_INK, at=(0.62,), width=0.42, softness=0.14, along=True, reach=(0.14, 0.46)),
        Patch(colour=_INK, at=(0.88, 0.0), size=(0.20, 1.30), softness=0.2),
        Patch(colour=(0.98, 0.82, 0.06), at=(1.0, 0.0), size=(0.115, 0.62), softness=0.12),
    ),
    eye=Eye(at=(0.105, 0.36), radius=0.026, iris=(0.24, 0.30, 0.42), pupil=0.55),
    fin=(0.15, 0.41, 0.96),
    fin_edge=(0.01, 0.015, 0.04),
    tail=(0.99, 0.83, 0.07),
    tail_edge=_INK,
    pectoral=(0.93, 0.80, 0.20),
    shine=0.22,
    fin_opacity=0.85,
    gill_at=0.215,
    gill_strength=0.4,
)
CLOWN_BODY: Final = Body(
    station=(0.11, 0.27, 0.45, 0.62, 0.77),
    half_width=(0.055, 0.080, 0.072, 0.048, 0.020),
    half_height=(0.105, 0.180, 0.180, 0.125, 0.070),
    tail_span=0.115,
    tail_fork=-0.03,
    dorsal=Fin(0.28, 0.76, 0.085, 0.05),
    anal=Fin(0.52, 0.74, 0.08, 0.06),
    pectoral_at=0.29,
    pectoral_length=0.15,
    pectoral_height=-0.2,
)
_ORANGE: Final = (0.97, 0.43, 0.06)
_RIM: Final = (0.04, 0.03, 0.03)
CLOWN_SKIN: Final = Skin(
    layers=(
        Gradient(colours=((1.0, 0.62, 0.18), (0.98, 0.47, 0.07), (0.86, 0.30, 0.04))),
        Scales(size=0.022, strength=0.18),
        Stripes((0.97, 0.97, 0.95), (0.245,), 0.085, 0.012, False, _RIM, 0.013, 0.03, wobble=0.2),
        Stripes((0.97, 0.97, 0.95), (0.555,), 0.10, 0.012, False, _RIM, 0.013, -0.06, wobble=0.2),
        Stripes((0.97, 0.97, 0.95), (0.90,), 0.07, 0.012, False, _RIM, 0.013, 0.0, wobble=0.1),
    ),
    eye=Eye(at=(0.095, 0.30), radius=0.027, iris=(0.85, 0.42, 0.10), pupil=0.62),
    fin=_ORANGE,
    fin_edge=_RIM,
    tail=_ORANGE,
    tail_edge=_RIM,
    shine=0.15,
    fin_opacity=0.9,
    gill_at=0.2,
)
BUTTERFLY_BODY: Final = Body(
    station=(0.13, 0.30, 0.48, 0.66, 0.80),
    half_width=(0.035, 0.056, 0.055, 0.036, 0.015),
    half_height=(0.110, 0.235, 0.265, 0.195, 0.055),
    tail_span=0.115,
    tail_fork=0.01,
    dorsal=Fin(0.26, 0.82, 0.09, 0.03),
    anal=Fin(0.50, 0.82, 0.09, 0.03),
    pectoral_at=0.31,
    pectoral_length=0.13,
    pectoral_height=-0.2,
)
BUTTERFLY_SKIN: Final = Skin(
    layers=(
        Gradient(colours=((0.99, 0.95, 0.78), (0.98, 0.90, 0.45), (0.96, 0.80, 0.16))),
        Scales(size=0.020, strength=0.30),
        Stripes((0.09, 0.10, 0.16), (0.36, 0.55, 0.74), 0.055, 0.03, False, bow=-0.03, wobble=0.6),
        Stripes((0.05, 0.05, 0.08), (0.115,), 0.06, 0.014, False, (1.0, 1.0, 0.95), 0.012, -0.01),
    ),
    eye=Eye(at=(0.115, 0.28), radius=0.024, iris=(0.75, 0.68, 0.35), pupil=0.6),
    fin=(0.97, 0.84, 0.22),
    fin_edge=(0.99, 0.97, 0.85),
    tail=(0.98, 0.86, 0.25),
    shine=0.3,
    gill_at=0.235,
)
SAMPLES: Final = {
    "sardine": (SARDINE_BODY, SARDINE_SKIN),
    "blue_tang": (TANG_BODY, TANG_SKIN),
    "clownfish": (CLOWN_BODY, CLOWN_SKIN),
    "butterflyfish": (BUTTERFLY_BODY, BUTTERFLY_SKIN),
}

FRAMES = 24


def swimming_shapes(body: Body, frames: int = FRAMES) -> Float32s:
    """Return shapes (frames, 23, 3) of a wave that runs along the body and grows towards the tail."""
    rest = rest_nodes(body)
    back = -rest[:, 0]
    shapes = np.repeat(rest[None], frames, axis=0)
    phase = 2.0 * np.pi * np.arange(frames)[:, None] / frames
    amplitude = 0.012 + 0.075 * back**2
    bend = amplitude * np.sin(phase - 2.0 * np.pi * back / 1.2)
    swing = -2.0 * np.pi / 1.2 * amplitude * np.cos(phase - 2.0 * np.pi * back / 1.2)
    shapes[:, :, 0] += 0.35 + swing * rest[:, 2]
    shapes[:, :, 2] += bend
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


@dataclass(frozen=True)
class Shoal:
    """What the tests draw: species, their library, and how to make fishes of them."""

    species: tuple[Species, ...]
    library: RepertoireLibrary
    population: Callable[..., Population] = field(default=population_of)
    rotation: Callable[..., Float64s] = field(default=rotation_of)


@pytest.fixture(scope="session")
def shoal() -> Shoal:
    """Sardine, blue tang, clownfish and butterflyfish, in this order."""
    species = tuple(species_of(name, body, skin) for name, (body, skin) in SAMPLES.items())
    return Shoal(species, library_of([s.body for s in species]))


@pytest.fixture(scope="session", params=list(SAMPLES))
def sample(request: pytest.FixtureRequest) -> Species:
    """Each of the four species in turn."""
    return species_of(request.param, *SAMPLES[request.param])


@pytest.fixture(scope="session")
def bent() -> Callable[[Body], Float64s]:
    """Return how a body looks in the middle of a stroke: nodes (23, 3) [BL]."""
    return lambda body: swimming_shapes(body)[7].astype(np.float64)


@pytest.fixture(scope="session")
def shoal_skins(shoal: Shoal) -> list[Texels]:
    """The four species' painted layers."""
    return [paint_skin(s.skin, s.body) for s in shoal.species]
