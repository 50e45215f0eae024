"""Shapes of fishes in live physics: rows at the library's end that are brought to the GPU with every picture."""

from dataclasses import replace
from typing import Any

import numpy as np

from components.arrays import Float32s
from components.camera import camera_at
from components.fish import Population
from components.repertoire import RepertoireLibrary
from systems.view.draw_fish import DrawFish
from systems.view.frame import FrameBlock, Look
from systems.view.target import Target, UInt8s, start_drawing

SIZE = (240, 160)


def with_spare(library: RepertoireLibrary, spare: int) -> RepertoireLibrary:
    """Return the library with `spare` rows of noughts after its shapes."""
    noughts: Float32s = np.zeros((spare, *library.shape.shape[1:]), np.float32)
    return replace(library, shape=np.concatenate([library.shape, noughts]), spare=spare)


def one_tang(shoal: Any) -> Population:
    """Return a tang a little ahead of the eye and across it."""
    turn = shoal.rotation(np.array([0.1, 1.0, 0.0]))
    population: Population = shoal.population(
        np.array([[1.4, 0.1, -5.0]]), turn[None], np.array([0.25]), [1]
    )
    return population


def picture(draw: DrawFish, population: Population) -> UInt8s:
    """Return what an eye 5 m down sees of the population."""
    camera = camera_at(np.array([0.0, 0.0, -5.0]), 0.0, 0.0, 0.2)
    with Target(*SIZE) as target:
        start_drawing(*SIZE)
        FrameBlock().update(camera, *SIZE, 0.0, Look())
        draw.draw(population, camera, 1.0, 0.0, 720.0, 30.0)
        return target.read()


def test_a_spare_row_is_drawn_as_it_is_now(shoal: Any) -> None:
    # So many that they fill the end of one row of the texture and the beginning of the next.
    library = with_spare(shoal.library, 200)
    population, spare = one_tang(shoal), len(library.shape) - 1
    motor, draw = population.motor, DrawFish(shoal.species, library)
    replayed = []
    for row in (24, 35):
        motor.shape_row[0] = motor.last_shape_row[0] = row
        replayed.append(picture(draw, population))
    motor.shape_row[0] = motor.last_shape_row[0] = spare
    for row, expected in zip((24, 35), replayed, strict=True):
        library.shape[spare] = library.shape[row]
        np.testing.assert_array_equal(picture(draw, population), expected)
    draw.delete()
    assert (replayed[0] != replayed[1]).any()
