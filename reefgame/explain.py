"""Why a fish does what it does, in words: the branch of the intention generator and its inputs (papers/004)."""

from dataclasses import dataclass
from math import hypot, sqrt
from typing import Final

from components.clock import TICKS_PER_SECOND
from components.food import in_stomach
from components.mind import FOOD, SUBMARINE, Courtship, Intention, Why
from components.repertoire import Pattern
from reefgame.world import World
from systems.mind.intend import AFRAID, PANICKED, UNEASY, WANTING

DOES: Final[dict[Intention, str]] = {
    Intention.WANDER: "wanders",
    Intention.AVOID_OBSTACLE: "swings round an obstacle",
    Intention.AVOID_FISH: "gets out of the way",
    Intention.SCHOOL: "schools",
    Intention.EAT: "goes for food",
    Intention.MATE: "courts",
    Intention.LEAVE: "leaves for better water",
    Intention.ESCAPE: "escapes",
    Intention.OBEY: "obeys you",
}
_GEARS: Final = ("slow", "medium", "fast")


@dataclass(frozen=True)
class Explanation:
    """What the inspector says of one fish."""

    title: str
    does: str
    "the intention as a verb"
    reason: str
    facts: tuple[tuple[str, str], ...]
    "name and value of what else there is to know"


def explain(world: World, row: int) -> Explanation:
    """Return what the fish in `row` does, and why."""
    mind = world.population.mind
    intention = Intention(int(mind.intention[row]))
    does = DOES[intention]
    if intention == Intention.EAT and mind.focus[row] >= 0:
        does = "hunts"
    elif intention == Intention.EAT and mind.focus[row] == -1:
        does = "looks for food"
    return Explanation(name_of(world, row), does, reason_of(world, row), _facts(world, row))


def name_of(world: World, row: int) -> str:
    """Return the species and the id of the fish in `row`."""
    fish = world.population.fish
    return f"{world.species[fish.species[row]].title} {int(fish.id[row])}"


def focus_of(world: World, row: int) -> tuple[str, tuple[float, float, float]] | None:
    """Return the name of what the fish attends to and where that is [m]; None for nothing, or what is gone."""
    focus, people = int(world.population.mind.focus[row]), world.population
    if focus == SUBMARINE:
        return "the submarine", _place(world.submarine.position[0])
    if focus <= FOOD and FOOD - focus < world.food.count:
        return "food", _place(world.food.position[FOOD - focus])
    if focus >= 0 and focus in people:
        other = people.row(focus)
        return name_of(world, other).lower(), _place(people.fish.position[other])
    return None


def _place(at: object) -> tuple[float, float, float]:
    x, y, z = (float(v) for v in at)  # type: ignore[attr-defined]  # a row of a float column
    return x, y, z


def _away(world: World, row: int) -> str:
    """Return the focus and its distance in words, empty for none."""
    focus = focus_of(world, row)
    if focus is None:
        return ""
    name, (x, y, z) = focus
    u, v, w = world.population.fish.position[row]
    return f"{name}, {sqrt((x - u) ** 2 + (y - v) ** 2 + (z - w) ** 2):.1f} m away"


def reason_of(world: World, row: int) -> str:
    """Return the branch that decided, with the numbers that it compared."""
    mind = world.population.mind
    why, value = Why(int(mind.why[row])), float(mind.why_value[row])
    away, danger = _away(world, row), float(mind.danger[row])
    hunger, libido = float(mind.hunger[row]), float(mind.libido[row])
    reasons = {
        Why.CONTENT: f"nothing presses: hunger {hunger:.2f}, libido {libido:.2f}, fear {mind.fear[row]:.2f}",
        Why.OBSTACLE: f"an obstacle ahead, at {value:.2f} of the distance that alarms",
        Why.COLLISION: f"{away or 'a fish'}: too near in {value:.1f} s",
        Why.FEAR_ESCAPE: f"fear {value:.2f} above {AFRAID:g}; {away or 'a predator'} (F_m {danger:.2f}, "
        + (f"above {PANICKED:g})" if danger > PANICKED else "and no company)"),
        Why.FEAR_SCHOOL: f"fear {value:.2f} above {AFRAID:g}, but no single danger above {PANICKED:g} "
        f"(F_m {danger:.2f}): safety in numbers",
        Why.HUNGER: f"hunger {value:.2f} above {WANTING:g}" + (f"; {away}" if away else ""),
        Why.LIBIDO: f"libido {value:.2f} above {WANTING:g}" + (f"; {away}" if away else ""),
        Why.RESUMED: f"was interrupted and remembers: {value:.2f}" + (f"; {away}" if away else ""),
        Why.COMPANY: f"sees {round(value)} of its kind",
        Why.HABITAT: f"light or warmth is wrong here: unease {value:.2f} above {UNEASY:g}",
        Why.CURIOSITY: f"curious of the submarine, {value:.1f} m away",
        Why.PERSISTENCE: f"stays with it for {value / TICKS_PER_SECOND:.1f} s yet",
        Why.PLAYER: "you steer it",
        Why.STUNG: f"an anemone stung it: it hurts for {value / TICKS_PER_SECOND:.1f} s yet",
    }
    return reasons[why]


def _facts(world: World, row: int) -> tuple[tuple[str, str], ...]:
    people, senses, now = world.population, world.senses, world.clock.now
    fish, mind, motor = people.fish, people.mind, people.motor
    kind, length = int(fish.species[row]), float(fish.length[row])
    full = in_stomach(
        float(mind.eaten[row]), int(mind.ate_at[row]), now, float(senses.digestion[kind])
    )
    phase = Courtship(int(mind.courtship[row]))
    memory = int(mind.memory[row])
    speed = TICKS_PER_SECOND * hypot(*(fish.position[row] - fish.last_position[row]))
    segment, library = int(motor.segment[row]), world.library
    pattern = Pattern(int(library.pattern[segment])).name.lower().replace("_", " ")
    since = (now - int(mind.since[row])) / TICKS_PER_SECOND
    swallower = int(mind.swallowed_by[row])
    asked = f"{_GEARS[int(motor.gear[row])]}, throttle {motor.throttle[row]:.2f}"
    facts = (
        ("for", f"{max(since, 0.0):.1f} s"),
        ("attends to", _away(world, row) or "nothing"),
        ("remembers", DOES[Intention(memory)] if memory >= 0 else "nothing"),
        ("stomach", f"{full:.1f} of {float(senses.appetite[kind]):.1f} meals"),
        ("courtship", phase.name.lower()),
        ("plays", f"{pattern}, {int(motor.frame[row])} of {int(library.length[segment])}"),
        ("is asked", asked),
        ("urgency", f"{motor.urgency[row]:.2f}"),
        ("swims", f"{speed:.2f} m/s, {speed / length:.1f} BL/s at {-fish.position[row, 2]:.1f} m"),
    )  # fmt: skip
    return (*facts, ("is eaten by", f"fish {swallower}")) if swallower >= 0 else facts
