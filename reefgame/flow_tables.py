"""A level's `flow` turned into the singularities and key frames of a dive (papers/002, sections 2 and 5.2)."""

from collections.abc import Sequence

import numpy as np

from components.arrays import Float64s
from components.singularity import (
    NOBODY,
    SUBMARINE,
    KeyFrames,
    SingularityKind,
    SingularityTable,
    Track,
    pack_tracks,
)
from components.terrain import Terrain
from reefgame.content.schema.flow import AnyFlow, Carrier, Current, Whirlwind
from reefgame.content.schema.level import Level
from systems.sea.stir import turned, wash

_KINDS = {
    "source": SingularityKind.SOURCE,
    "hole": SingularityKind.HOLE,
    "whirlwind": SingularityKind.WHIRLWIND,
    "current": SingularityKind.DIRECTIONAL,
}


def singularities_of(
    level: Level, species: Sequence[str], terrain: Terrain
) -> tuple[SingularityTable, KeyFrames]:
    """Return the level's singularities, in the order of the file, and the submarine's wash; and their key frames.

    `species` are the names in the order of their rows.
    """
    table = SingularityTable(count=len(level.flow))
    tracks: list[Track] = []
    for row, flow in enumerate(level.flow):
        table.kind[row] = _KINDS[flow.kind]
        table.intensity[row] = flow.speed_m_per_s
        table.reach[row] = np.inf if flow.reach_m is None else flow.reach_m
        if isinstance(flow, Current):
            _set_wave(table, row, flow)
        else:
            # In the centre V is Phi_max, and half of it at a^2 = |Phi| / Phi_max (components/field.py).
            table.intensity[row] *= flow.core_m * flow.core_m
            table.most[row] = max(abs(flow.speed_m_per_s), 1e-6)
            table.softening[row] = flow.softening_m
        if isinstance(flow, Current | Whirlwind):
            table.axis[row] = table.carried_axis[row] = _unit(flow.axis)
        if flow.at_m is not None:
            table.position[row] = flow.at_m
        if flow.attached is not None:
            _attach(table, row, flow.attached, species, terrain)
        if flow.track is not None:
            table.track[row] = len(tracks)
            tracks.append(_track_of(flow, table, row))
    wash(table)
    table.id[: table.count] = np.arange(table.count)
    return table, pack_tracks(tracks)


def _unit(axis: Sequence[float]) -> Float64s:
    vector = np.asarray(axis, np.float64)
    return np.asarray(vector / np.sqrt((vector * vector).sum()))


def _set_wave(table: SingularityTable, row: int, flow: Current) -> None:
    wave = flow.wave
    if wave is None:
        return
    table.wave_number[row] = 0.0 if wave.length_m is None else 1.0 / wave.length_m
    table.frequency[row] = 0.0 if wave.period_s is None else 1.0 / wave.period_s
    table.amplitude[row], table.phase[row] = wave.amplitude, wave.phase_turns


def _attach(
    table: SingularityTable, row: int, carrier: Carrier, species: Sequence[str], terrain: Terrain
) -> None:
    table.offset[row] = carrier.offset_m
    if carrier.submarine:
        table.attached[row] = SUBMARINE
    elif carrier.species is not None:
        table.attached[row], table.carrier[row] = NOBODY, species.index(carrier.species)
        table.there[row] = 0
    elif carrier.rock is not None:
        # A rock stays where it is: so does what it carries.
        c, s = terrain.rock_axes[carrier.rock]
        axes = np.array([[c, 0.0, s], [s, 0.0, -c], [0.0, 1.0, 0.0]])
        table.position[row] = terrain.rock_centre[carrier.rock] + turned(axes, *table.offset[row])
        table.axis[row] = turned(axes, *table.carried_axis[row])


def _track_of(flow: AnyFlow, table: SingularityTable, row: int) -> Track:
    assert flow.track is not None
    frames, stays = flow.track.frames, tuple(table.position[row].tolist())
    return Track(
        seconds=[frame.at_s for frame in frames],
        positions=[stays if frame.at_m is None else frame.at_m for frame in frames],
        intensities=[frame.strength * float(table.intensity[row]) for frame in frames],
        smooth=flow.track.between == "smooth",
        loop=flow.track.loop,
    )
