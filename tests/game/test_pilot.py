"""The submarine: it obeys with inertia and never enters ground, rock or the world's bounds."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.arrays import Float64s
from components.clock import TICKS_PER_SECOND
from components.command import Command, CommandTable
from components.possession import AvatarTable
from components.submarine import HULL_RADIUS, SubmarineTable
from components.terrain import Rock, Terrain, build_terrain, clearance
from components.trigonometry import DEGREE
from systems.player.pilot import AHEAD, ASTERN, PITCH_LIMIT, RISE, Pilot

WORLD = build_terrain(30.0, 12.0, 1.5, 12.0, 3, [Rock((9.0, 0.0, -9.5), (3.0, 2.5, 2.0), 30.0)])


class Ship:
    """A submarine with its orders, in the middle of a small world."""

    def __init__(self, at: tuple[float, float, float] = (-8.0, 0.0, -5.0)) -> None:
        self.table = SubmarineTable(count=1)
        self.table.position[0] = at
        self.commands = CommandTable()
        self.avatar = AvatarTable()
        self.pilot = Pilot(self.table, self.commands, WORLD, self.avatar)

    def sail(self, command: Command, seconds: float) -> "Ship":
        for _ in range(round(seconds * TICKS_PER_SECOND)):
            self.commands.give(command)
            self.pilot()
        return self

    @property
    def velocity(self) -> Float64s:
        return np.asarray(self.table.velocity[0], np.float64)


def gap(terrain: Terrain, ship: Ship) -> float:
    x, y, z = ship.table.position[0]
    return clearance(terrain, x, y, z)[0]


def test_full_ahead_gathers_way_slowly_and_reaches_its_speed() -> None:
    ship = Ship((-20.0, 0.0, -5.0))
    early = ship.sail(Command(throttle=100), 0.5).velocity[0]
    assert 0.0 < early < 0.3 * AHEAD
    assert ship.sail(Command(throttle=100), 5.0).velocity[0] == pytest.approx(AHEAD, rel=0.02)


def test_decelerating_goes_over_into_reverse() -> None:
    ship = Ship().sail(Command(throttle=100), 2.0).sail(Command(throttle=-100), 8.0)
    assert ship.velocity[0] == pytest.approx(-ASTERN, rel=0.05)


def test_full_stop_halts_within_two_seconds() -> None:
    ship = Ship().sail(Command(throttle=100), 3.0)
    ship.sail(Command(stop=1), 2.0)
    assert float(np.linalg.norm(ship.velocity)) < 0.02
    assert ship.table.throttle[0] == 0.0


def test_while_the_player_is_a_fish_the_submarine_stands() -> None:
    ship = Ship().sail(Command(throttle=100), 3.0)
    ship.avatar.fish[0] = 7
    ship.sail(Command(throttle=100, turn=100), 2.0)
    assert float(np.linalg.norm(ship.velocity)) < 0.02
    yaw = float(ship.table.yaw[0])
    assert ship.sail(Command(turn=100), 1.0).table.yaw[0] == pytest.approx(yaw, abs=1e-3)


def test_turning_left_turns_from_x_towards_y_and_keeps_turning_a_moment() -> None:
    ship = Ship().sail(Command(turn=100), 1.0)
    yaw = float(ship.table.yaw[0])
    assert 30.0 * DEGREE < yaw < 55.0 * DEGREE
    assert ship.sail(Command(), 0.3).table.yaw[0] > yaw


def test_pitch_stops_at_its_limit_and_leaves_it_at_once() -> None:
    ship = Ship().sail(Command(pitch=100), 5.0)
    assert ship.table.pitch[0] == PITCH_LIMIT
    assert ship.sail(Command(pitch=-100), 0.2).table.pitch[0] < PITCH_LIMIT


def test_rising_and_diving_need_no_way() -> None:
    assert Ship().sail(Command(rise=100), 1.5).velocity[2] > 0.7 * RISE
    assert Ship().sail(Command(rise=-100), 1.0).velocity[2] < -0.6 * RISE


def test_a_rock_in_the_way_stops_the_hull() -> None:
    ship = Ship((-5.0, 0.0, -9.2)).sail(Command(throttle=100), 8.0)
    assert gap(WORLD, ship) > HULL_RADIUS - 0.1
    assert float(np.linalg.norm(ship.velocity)) < AHEAD


ORDERS = st.builds(
    Command,
    throttle=st.integers(-100, 100),
    turn=st.integers(-100, 100),
    pitch=st.integers(-100, 100),
    rise=st.integers(-100, 100),
    stop=st.integers(0, 1),
    photograph=st.just(0),
    become=st.integers(0, 1),
    eat=st.integers(0, 1),
    hide=st.integers(0, 1),
    view=st.integers(0, 1),
)


@settings(max_examples=30, deadline=None)
@given(st.lists(ORDERS, min_size=1, max_size=8))
def test_no_orders_bring_the_submarine_out_of_the_water(orders: list[Command]) -> None:
    ship = Ship()
    for command in orders:
        ship.sail(command, 3.0)
        x, y, z = ship.table.position[0]
        assert gap(WORLD, ship) > 0.0
        assert z <= -HULL_RADIUS + 1e-9
        assert np.hypot(x, y) <= WORLD.radius
