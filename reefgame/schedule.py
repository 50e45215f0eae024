"""The schedule: everything that happens in a tick of 1/60 s, in order, once (DESIGN 3).

pilot    the submarine obeys the player                                systems/player/pilot.py
become   the player turns into a fish, and back                        systems/player/become.py
obey     that fish does as the player orders                           systems/player/obey.py
stir     singularities follow their key frames and carriers            systems/sea/stir.py
think    a quarter of the fishes perceive, intend and behave           systems/mind/think.py
sting    anemones sting who is not at home in them: it flees           systems/play/sting.py
swim     three in one launch:                                          systems/motor/swim.py
  bound    ground, rocks, surface and rim turn fishes inward           systems/motor/bound.py
  control  the secondary controller chooses segments and steers        systems/motor/control.py
  move     every fish plays its segment, warps and balances            systems/motor/move.py
live     the nearest few run the muscle model, where that is asked for systems/motor/live.py
drift    the flow carries food and fishes                             systems/sea/drift.py
hold     anemones hold and eat small fishes that touch them            systems/play/hold.py
feed     open mouths suck in and swallow                              systems/play/feed.py
spawn    the level's groups arrive and leave; the eaten are replaced   systems/play/spawn.py
judge    photographs and objectives                                    systems/play/judge.py
"""

from typing import TYPE_CHECKING, Protocol

from systems.mind.think import Think
from systems.motor.bound import Bound
from systems.motor.control import Control
from systems.motor.live import Live
from systems.motor.move import Move
from systems.motor.strokes import strokes
from systems.motor.swim import Swim
from systems.motor.track import Track
from systems.play.feed import Feed
from systems.play.hold import Hold
from systems.play.judge import Judge
from systems.play.spawn import Spawn
from systems.play.sting import Sting
from systems.player.become import Become
from systems.player.obey import Obey
from systems.player.pilot import Pilot
from systems.sea.drift import Drift
from systems.sea.stir import Stir

if TYPE_CHECKING:
    from reefgame.world import World


class System(Protocol):
    """A verb of the tick: constructed with the tables it reads and writes, called once a tick."""

    def __call__(self) -> None:
        """Advance the tables by one tick."""


def spawner(world: "World") -> Spawn:
    """Return the system that fills the world before its first tick and is part of every tick."""
    return Spawn(
        world.cohorts,
        world.restocks,
        world.roster,
        world.population,
        world.entities,
        world.species,
        world.library,
        world.terrain,
        world.submarine,
        world.level.water.visibility_m,
        world.clock,
    )


def stirrer(world: "World") -> Stir:
    """Return the system that places singularities before the first tick and is part of every tick."""
    return Stir(
        world.singularities, world.key_frames, world.submarine, world.population, world.clock
    )


def live(world: "World", track: Track) -> tuple[Live, ...]:
    """Return the system of live physics on move's `track`, none where no fish may be live."""
    if not world.live.count:
        return ()
    known = strokes(world.species, world.library)
    return (
        Live(
            *(world.live, world.population, world.library, track, known),
            *(world.submarine, world.terrain, world.clock),
        ),
    )


def schedule(world: "World") -> tuple[System, ...]:
    """Return the systems of a tick in their order."""
    fishes, terrain, clock = world.population, world.terrain, world.clock
    senses, avatar, orders = world.senses, world.avatar, world.commands
    move = Move(fishes, world.library, terrain, clock)
    return (
        Pilot(world.submarine, orders, terrain, avatar),
        Become(avatar, orders, fishes, world.submarine, terrain, clock),
        Obey(avatar, orders, fishes, world.food, senses, terrain, clock),
        world.stir,
        Think(fishes, senses, terrain, world.submarine, clock, world.food, world.habitat),
        Sting(world.anemones, fishes, senses, terrain, clock),
        Swim(Bound(fishes, senses, terrain), Control(fishes, world.library, clock), move),
        *live(world, move.track),
        Drift(world.singularities, fishes, world.food, world.patches, senses, terrain, clock),
        Hold(world.anemones, fishes, senses, terrain, world.spawn, clock),
        Feed(fishes, world.food, world.patches, senses, world.spawn, clock),
        world.spawn,
        Judge(
            world.objective,
            world.goals,
            world.level.objective.par_s,
            fishes,
            world.submarine,
            orders,
            avatar,
            terrain,
            clock,
        ),
    )
