"""Photographs: what counts is inside the viewfinder, near enough and not hidden."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from components.camera import VIEWFINDER_ASPECT, VIEWFINDER_SLOPE, camera_at
from components.clock import Clock
from components.command import Command, CommandTable
from components.fish import Population
from components.objective import ObjectiveTable, Photograph
from components.possession import AvatarTable
from components.submarine import SubmarineTable
from components.terrain import Rock, build_terrain
from systems.play.judge import Judge, inside_frame, score

WATER = build_terrain(40.0, 20.0, 0.5, 12.0, 3)
ROCKY = WATER.with_rocks([Rock((3.0, 0.0, -10.0), (0.8, 0.8, 0.8))])


class Scene:
    """Sardines at given places before a submarine that looks along +x from (0, 0, -10)."""

    def __init__(self, *places: tuple[float, float, float], rocky: bool = False) -> None:
        self.population = Population()
        rows = self.population.append(np.arange(len(places), dtype=np.int64))
        self.population.fish.position[rows] = np.array(places).reshape(-1, 3)
        self.ship = SubmarineTable(count=1)
        self.ship.position[0] = self.ship.last_position[0] = (0.0, 0.0, -10.0)
        self.commands, self.clock = CommandTable(), Clock()
        self.clock.tick[0] = 61
        self.objectives = ObjectiveTable(count=1)
        self.avatar = AvatarTable()
        goals = [Photograph(species=0, count=2, within=6.0)]
        self.judge = Judge(
            self.objectives,
            goals,
            120.0,
            self.population,
            self.ship,
            self.commands,
            self.avatar,
            ROCKY if rocky else WATER,
            self.clock,
        )

    def shoot(self, photograph: int = 1) -> int:
        self.commands.give(Command(photograph=photograph))
        self.judge()
        self.clock.tick[0] += 1
        return int(self.objectives.latest[0])


def test_a_fish_ahead_and_near_counts_and_one_behind_or_far_does_not() -> None:
    assert Scene((4.0, 0.0, -10.0), (-4.0, 0.0, -10.0), (7.0, 0.0, -10.0)).shoot() == 1


def test_a_fish_behind_a_rock_does_not_count() -> None:
    hidden = (5.0, 0.0, -10.0)
    assert Scene(hidden).shoot() == 1
    assert Scene(hidden, rocky=True).shoot() == 0


def test_another_species_does_not_count() -> None:
    scene = Scene((4.0, 0.0, -10.0), (4.0, 0.5, -10.0))
    scene.population.fish.species[1] = 1
    assert scene.shoot() == 1


def test_the_shutter_counts_once_until_it_is_released() -> None:
    scene = Scene((4.0, 0.0, -10.0))
    for _ in range(5):
        scene.shoot()
    assert scene.objectives.shots[0] == 1
    scene.shoot(photograph=0)
    scene.shoot()
    assert scene.objectives.shots[0] == 2


def test_enough_fishes_win_once_and_the_score_stays() -> None:
    scene = Scene((4.0, 0.0, -10.0), (4.0, 0.5, -10.0))
    scene.shoot()
    assert scene.objectives.done[0] == 1
    assert scene.objectives.won_at[0] == 61
    points = int(scene.objectives.score[0])
    scene.shoot(photograph=0)
    scene.shoot()
    assert (int(scene.objectives.score[0]), int(scene.objectives.won_at[0])) == (points, 61)


def test_what_a_photograph_would_hold_is_told_without_a_photograph() -> None:
    scene = Scene((4.0, 0.0, -10.0))
    scene.clock.tick[0] = 60
    scene.shoot(photograph=0)
    assert scene.objectives.framed[0] == 1
    assert scene.objectives.latest[0] == -1


def test_more_fishes_and_less_time_score_more_and_wasted_film_less() -> None:
    plain = score(12, 12, 60.0, 120.0, 1)
    assert score(14, 12, 60.0, 120.0, 1) > plain
    assert score(12, 12, 30.0, 120.0, 1) > plain
    assert score(12, 12, 60.0, 120.0, 4) < plain
    assert score(12, 12, 5000.0, 120.0, 1000) > 0


@given(
    yaw=st.floats(-3.0, 3.0),
    pitch=st.floats(-1.0, 1.0),
    right=st.floats(-1.3, 1.3),
    up=st.floats(-1.3, 1.3),
)
def test_the_frame_is_three_to_two_wherever_the_camera_looks(
    yaw: float, pitch: float, right: float, up: float
) -> None:
    camera = camera_at(np.array([1.0, 2.0, -5.0]), yaw, pitch)
    across = right * VIEWFINDER_SLOPE * VIEWFINDER_ASPECT
    point = camera.eye + 3.0 * (
        camera.forward + across * camera.right + up * VIEWFINDER_SLOPE * camera.up
    )
    expected = abs(right) <= 1.0 and abs(up) <= 1.0
    if min(abs(abs(right) - 1.0), abs(abs(up) - 1.0)) > 1e-9:
        found = inside_frame(point[None], 0, camera.eye, camera.axes, 50.0)
        assert bool(found) == expected


def test_an_empty_sea_frames_nothing() -> None:
    assert Scene().shoot() == 0
    assert score(0, 0, 0.0, 0.0, 1) == pytest.approx(1000)


def test_a_fish_takes_no_photograph() -> None:
    scene = Scene((4.0, 0.0, -10.0))
    scene.avatar.fish[0] = 0
    assert scene.shoot() == -1
    assert scene.objectives.shots[0] == 0
    assert scene.objectives.framed[0] == 0
