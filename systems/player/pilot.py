"""Pilot: the submarine obeys its orders, with inertia, and slides along what it meets (papers/000,
8.2).

Maneuvers as the paper lists them: accelerate forward, decelerate, reverse, turn, pitch, rise, dive,
full stop. Each is a first-order lag, v <- v + (wanted - v) dt / tau: no exponential, the same bits
everywhere.
"""

from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int32s
from components.clock import TICK_SECONDS
from components.command import FULL, Command, CommandTable
from components.kernels import Launch, row
from components.possession import AvatarTable
from components.submarine import HULL_RADIUS, SubmarineTable
from components.table import Columns
from components.terrain import Terrain, confine
from components.trigonometry import DEGREE, cosine, sine

AHEAD: Final = 4.0
"""[m/s] at full throttle."""
ASTERN: Final = 1.6
"""[m/s] in full reverse."""
RISE: Final = 1.6
"""[m/s] of rising and diving."""
YAW_RATE: Final = 55.0 * DEGREE
PITCH_RATE: Final = 40.0 * DEGREE
PITCH_LIMIT: Final = 60.0 * DEGREE
THROTTLE_RATE: Final = 0.9
"""Engine setting per second at a full order."""
_TAU_HULL: Final = 0.9
_TAU_STOP: Final = 0.35
_TAU_TURN: Final = 0.22
_UNMANNED: Final = np.array([Command(stop=1)], np.int32)


class Ship(NamedTuple):
    """The columns of the submarine that it moves by."""

    position: Float64s
    velocity: Float64s
    yaw: Float64s
    pitch: Float64s
    yaw_rate: Float64s
    pitch_rate: Float64s
    throttle: Float64s
    last_position: Float64s
    last_yaw: Float64s
    last_pitch: Float64s


@row
def _toward(value: float, wanted: float, tau: float) -> float:
    return value + (wanted - value) * (TICK_SECONDS / tau)


@row
def _clamped(value: float, low: float, high: float) -> float:
    return min(max(value, low), high)


@row
def turn(
    orders: Int32s,
    yaw: Float64s,
    pitch: Float64s,
    yaw_rate: Float64s,
    pitch_rate: Float64s,
    ship: int,
) -> None:
    """Advance heading and pitch [rad] of row `ship` by one tick under `orders` (10,)."""
    yaw_rate[ship] = _toward(yaw_rate[ship], orders[1] * (YAW_RATE / FULL), _TAU_TURN)
    pitch_rate[ship] = _toward(pitch_rate[ship], orders[2] * (PITCH_RATE / FULL), _TAU_TURN)
    yaw[ship] += yaw_rate[ship] * TICK_SECONDS
    risen = pitch[ship] + pitch_rate[ship] * TICK_SECONDS
    pitch[ship] = _clamped(risen, -PITCH_LIMIT, PITCH_LIMIT)
    if pitch[ship] != risen:
        pitch_rate[ship] = 0.0


@row
def drive(
    orders: Int32s,
    throttle: Float64s,
    velocity: Float64s,
    yaw: Float64s,
    pitch: Float64s,
    ship: int,
) -> None:
    """Set engine and velocity [m/s] (n, 3) of row `ship` under `orders` (10,)."""
    setting = throttle[ship] + orders[0] * (THROTTLE_RATE * TICK_SECONDS / FULL)
    setting = _clamped(setting, -1.0, 1.0)
    if orders[4]:
        setting = 0.0
    throttle[ship] = setting
    speed = setting * (AHEAD if setting > 0.0 else ASTERN)
    tau = _TAU_STOP if orders[4] else _TAU_HULL
    level = cosine(pitch[ship]) * speed
    lift = sine(pitch[ship]) * speed + orders[3] * (RISE / FULL)
    velocity[ship, 0] = _toward(velocity[ship, 0], level * cosine(yaw[ship]), tau)
    velocity[ship, 1] = _toward(velocity[ship, 1], level * sine(yaw[ship]), tau)
    velocity[ship, 2] = _toward(velocity[ship, 2], lift, tau)


@row
def advance(position: Float64s, velocity: Float64s, ship: int, terrain: Terrain) -> None:
    """Move row `ship` by one tick [m]; what it meets pushes it out and takes the speed towards it."""
    before_x, before_y, before_z = position[ship, 0], position[ship, 1], position[ship, 2]
    for axis in range(3):
        position[ship, axis] += velocity[ship, axis] * TICK_SECONDS
    if confine(terrain, position, ship, HULL_RADIUS):
        velocity[ship, 0] = (position[ship, 0] - before_x) / TICK_SECONDS
        velocity[ship, 1] = (position[ship, 1] - before_y) / TICK_SECONDS
        velocity[ship, 2] = (position[ship, 2] - before_z) / TICK_SECONDS


@row
def steer(ship: Ship, commands: Int32s, terrain: Terrain) -> None:
    """Move the submarine by one tick under the first row of `commands`, (n, 10)."""
    orders = commands[0]
    for axis in range(3):
        ship.last_position[0, axis] = ship.position[0, axis]
    ship.last_yaw[0], ship.last_pitch[0] = ship.yaw[0], ship.pitch[0]
    turn(orders, ship.yaw, ship.pitch, ship.yaw_rate, ship.pitch_rate, 0)
    drive(orders, ship.throttle, ship.velocity, ship.yaw, ship.pitch, 0)
    advance(ship.position, ship.velocity, 0, terrain)


class Pilot:
    """Reads commands, terrain and whether the player is a fish; writes the submarine, which stands while unmanned."""

    def __init__(
        self,
        submarine: SubmarineTable,
        commands: CommandTable,
        terrain: Terrain,
        avatar: AvatarTable,
    ) -> None:
        self.submarine = submarine
        self.avatar = avatar
        self.commands = commands
        self.terrain = terrain
        self._ship, self._steer = Columns(Ship, submarine), Launch(steer)

    def __call__(self) -> None:
        """Move the submarine by one tick."""
        orders = _UNMANNED if self.avatar.attached else self.commands.now
        self._steer(self._ship(), orders, self.terrain)
