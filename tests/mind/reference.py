"""A slow mind in plain Python, fish by fish, to hold the kernels against (FINDINGS 2; papers/004).

It perceives by looking at everybody, feels, decides, and carries its own intentions, reasons, foci and memories from
tick to tick. It shares with the kernels what is not the mind's: chance, ground and rocks, the day, and where the fishes
have swum; and how far a courtship is, which its behaviour routine says.
"""

from dataclasses import dataclass, replace
from math import sqrt
from typing import Any

from components import chance
from components.food import in_stomach
from components.habitat import daylight, light, temperature
from components.mind import FOOD, SUBMARINE
from components.terrain import clearance, ground_height, in_sight
from components.trigonometry import arc
from systems.mind.sparse import divide_coarsely

NOBODY = 1e9
WANDER, OBSTACLE, AVOID, SCHOOL, EAT, MATE, LEAVE, ESCAPE = range(8)
(
    CONTENT, NEAR_OBSTACLE, COLLISION, FEAR_ESCAPE, FEAR_SCHOOL, HUNGER, LIBIDO, RESUMED, COMPANY,
    HABITAT, CURIOSITY, PERSISTENCE,
) = range(12)  # fmt: skip
PREY, PREDATOR, PACIFIST = range(3)


@dataclass(frozen=True)
class Mind:
    """What the reference remembers of one fish."""

    intention: int
    why: int
    since: int
    memory: int
    focus: int
    libido: float
    hunger: float
    fear: float
    wary_of: int
    value: float = 0.0


@dataclass(frozen=True)
class Body:
    """One fish as it was when the tick began."""

    id: int
    row: int
    species: int
    length: float
    at: tuple[float, float, float]
    way: tuple[float, float, float]
    speed: float
    eaten: float
    ate_at: int
    mated_at: int
    swallowed_by: int
    cell: tuple[int, int]


def clamp(value: float, low: float = 0.0, high: float = 1.0) -> float:
    return min(max(value, low), high)


def stimulus(length: float, far: float, q1: float, q2: float) -> float:
    s = length / (far + 1e-9)
    return 0.0 if s <= q1 else 1.0 if s >= q2 else (s - q1) / (2.0 * q2 - q1 - s)


def offset(a: tuple[float, ...], b: tuple[float, ...]) -> tuple[float, float, float]:
    return b[0] - a[0], b[1] - a[1], b[2] - a[2]


def dot(a: tuple[float, ...], b: tuple[float, ...]) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


class Reference:
    """The minds of a world's fishes; call `look` before and `decide` after the kernels think."""

    def __init__(self, world: Any, think: Any) -> None:
        self.world, self.think = world, think
        self.minds: dict[int, Mind] = {}
        self.bodies: list[Body] = []

    def look(self) -> None:
        """Take in where everybody is, and the minds of the newly born."""
        world = self.world
        fish, mind, n = world.population.fish, world.population.mind, world.population.count
        self.now, self.seed = world.clock.now, int(world.clock.seed[0])
        self.bodies = [self._body(i, fish, mind) for i in range(n)]
        food = world.food
        self.food = {
            k: tuple(food.position[k].tolist())
            for k in range(food.count)
            if food.returns[k] <= self.now and food.eaten_by[k] < 0
        }
        for body in self.bodies:
            if body.id not in self.minds:
                i = body.row
                self.minds[body.id] = Mind(
                    int(mind.intention[i]), int(mind.why[i]), int(mind.since[i]),
                    int(mind.memory[i]), int(mind.focus[i]), float(mind.libido[i]),
                    float(mind.hunger[i]), float(mind.fear[i]), int(mind.wary_of[i]),
                )  # fmt: skip
        self.new = {body.id for body in self.bodies if mind.thought_at[body.row] < 0}
        living = {body.id for body in self.bodies}
        self.minds = {k: m for k, m in self.minds.items() if k in living}

    def _body(self, i: int, fish: Any, mind: Any) -> Body:
        at, last = tuple(fish.position[i].tolist()), tuple(fish.last_position[i].tolist())
        d = offset(last, at)
        return Body(
            int(fish.id[i]), i, int(fish.species[i]), float(fish.length[i]), at,
            tuple(fish.rotation[i, :, 0].tolist()), 60.0 * sqrt(dot(d, d)), float(mind.eaten[i]),
            int(mind.ate_at[i]), int(mind.mated_at[i]), int(mind.swallowed_by[i]), (0, 0),
        )  # fmt: skip

    def decide(self) -> dict[int, Mind]:
        """Return the minds of those who have just thought, and remember them."""
        self.plan, senses = self.think.grid.plan, self.world.senses
        self.sense = senses
        self.bodies = [replace(b, cell=self._cell(b.at)) for b in self.bodies]
        self.bodies.sort(key=lambda b: (*b.cell, b.id))
        self.at = {b.id: k for k, b in enumerate(self.bodies)}
        self.day = daylight(self.world.habitat, self.now)
        self._hunting = sum(senses.hunts[b.species] != 0 for b in self.bodies)
        self._willing = sum(self._would(b) for b in self.bodies)
        mind = self.world.population.mind
        fresh = {b.id: self._mind(b) for b in self.bodies if mind.thought_at[b.row] == self.now}
        self.minds.update(fresh)
        return fresh

    def _would(self, body: Body) -> bool:
        its = self.minds[body.id]
        courts = its.libido >= 0.25 or (its.intention == MATE and its.focus >= 0)
        return courts and self.sense.schooling[body.species] == 0

    def _coarse(self, number: int) -> float:
        terrain = self.world.terrain
        return divide_coarsely(terrain.radius, terrain.depth, number, 3.0 * self.plan.cell)[0]

    def _cell(self, at: tuple[float, ...]) -> tuple[int, int]:
        plan = self.plan
        x, y = (int(clamp((v + plan.extent) // plan.cell, 0, plan.columns - 1)) for v in at[:2])
        return x * plan.columns + y, int(clamp(-at[2] // plan.cell, 0, plan.layers - 1))

    def _in_cone(self, me: Body, d: tuple[float, float, float]) -> bool:
        along = dot(d, me.way)
        return along >= 0.0 or along * along < 0.75 * dot(d, d)

    def _collision(self, me: Body, other: Body) -> float:
        d = offset(me.at, other.at)
        v = tuple(other.speed * other.way[a] - me.speed * me.way[a] for a in range(3))
        closing = dot(d, v)
        if closing >= 0.0:
            return NOBODY
        when = min(-closing / dot(v, v), 1.2)
        there = tuple(d[a] + when * v[a] for a in range(3))
        room = 0.4 * (me.length + other.length)
        return when if dot(there, there) < room * room else NOBODY

    def _clear(self, me: Body, other: Body) -> bool:
        return in_sight(self.world.terrain, *me.at, *other.at)

    def _swallows(self, eater: Body, victim: Body) -> bool:
        eats = bool(self.sense.eats[eater.species, victim.species] != 0)
        return bool(eats and victim.length <= 0.34 * eater.length)

    def _around(self, me: Body, target: int) -> tuple[list[tuple[float, Body]], float, int]:
        """Return the nearest 8 of its kind, and when and with whom it collides."""
        plan, kind = self.plan, me.species
        reach = min(self.sense.sight[kind], plan.cell)
        reach = min(reach, 2.5 * me.length) if plan.crowded else reach
        schooling = self.sense.schooling[kind] != 0
        own, when, who = [], NOBODY, -1
        for other in self.bodies:
            d = offset(me.at, other.at)
            square = dot(d, d)
            felt = 0.7 * 0.7 * me.length * me.length
            if other.id == me.id or square > reach * reach:
                continue
            if not (self._in_cone(me, d) or square < felt):
                continue
            if other.species == kind:
                own.append((square, other))
                if schooling:
                    continue
            if other.id != target and not self.sense.eats[other.species, kind]:
                soon = self._collision(me, other)
                if soon < when:
                    when, who = soon, other.id
        own.sort(key=lambda pair: pair[0])
        return own[:8], when, who

    def _hunters(self, me: Body, target: int) -> tuple[list[tuple[float, Body]], float, int]:
        sense, kind, hunters, when, who = self.sense, me.species, [], NOBODY, -1
        far = min(self.world.habitat.visibility, self._coarse(self._hunting))
        for other in self.bodies:
            if not sense.hunts[other.species] or other.id == me.id:
                continue
            d = offset(me.at, other.at)
            square = dot(d, d)
            if square > far * far:
                continue
            if square > sense.sight[kind] * sense.sight[kind] / me.length * other.length:
                continue
            felt = 0.7 * me.length + 2.0 * other.length
            if not (self._in_cone(me, d) or square < felt * felt):
                continue
            if sense.eats[other.species, kind]:
                if self._swallows(other, me):
                    hunters.append((square, other))
            elif other.id != target and square < 9.0 * other.length * other.length:
                soon = self._collision(me, other)
                if soon < when:
                    when, who = soon, other.id
        hunters.sort(key=lambda pair: pair[0])
        return hunters[:8], when, who

    def _fear_of(self, me: Body, other: Body) -> float:
        d = offset(me.at, other.at)
        return float(
            min(self.sense.wariness[me.species] * other.length / (sqrt(dot(d, d)) + 1e-9), 1.0)
        )

    def _fear(self, me: Body, hunters: list[tuple[float, Body]]) -> tuple[float, float, int]:
        total, worst, who = 0.0, 0.0, -1
        for _, other in hunters:
            one = self._fear_of(me, other)
            if one >= 0.1 and total < 1.0 and self._clear(me, other):
                total += one
                if one > worst:
                    worst, who = one, other.id
        return min(total, 1.0), worst, who

    def _alarm(
        self, me: Body, old: Mind, looks: bool, hunters: list[tuple[float, Body]], scare: float
    ) -> tuple[float, float, int]:
        """Return fear, danger and whom it fears most: as it looks round, or the one that it keeps in mind."""
        if not looks and old.wary_of in self.at:
            worst = self._fear_of(me, self.bodies[self.at[old.wary_of]])
            return max(old.fear, worst, scare), max(worst, scare), old.wary_of
        fear, worst, predator = self._fear(me, hunters)
        return min(fear + scare, 1.0), max(worst, scare), predator

    def _shoal(self, me: Body) -> bool:
        """Return whether the middle of its kind in nine squares of the plan is in sight."""
        plan = self.plan

        def square(body: Body) -> tuple[int, int]:
            column = body.cell[0]
            return column // plan.columns // plan.block, column % plan.columns // plan.block

        x, y = square(me)
        total = [-int(v * 65536.0) for v in me.at]
        number = -1
        for other in self.bodies:
            u, v = square(other)
            if other.species == me.species and abs(u - x) <= 1 and abs(v - y) <= 1:
                number += 1
                total = [t + int(c * 65536.0) for t, c in zip(total, other.at, strict=True)]
        if number <= 0:
            return False
        d = tuple(t / (number * 65536.0) - c for t, c in zip(total, me.at, strict=True))
        far = min(2.0 * self.sense.sight[me.species], self.world.habitat.visibility)
        return bool(dot(d, d) <= far * far)

    def _obstacle(self, me: Body) -> float:
        reach, best = me.length + 0.8 * me.speed, NOBODY
        alarm = 0.8 * me.length + 0.2
        for half in (1, 2):
            ahead = 0.5 * half * reach
            x, y, z = (me.at[a] + ahead * me.way[a] for a in range(3))
            best = min(best, clearance(self.world.terrain, x, y, z, 1.5 * alarm)[0])
        return best / alarm

    def _submarine(self, me: Body) -> tuple[float, float, float]:
        """Return when it comes too near, how far it is and how fast."""
        sub = self.world.submarine
        d = offset(tuple(sub.position[0].tolist()), me.at)
        v = tuple(sub.velocity[0].tolist())
        far = sqrt(dot(d, d))
        room = 2.5 + 0.5 * me.length
        relative = tuple(me.speed * me.way[a] - v[a] for a in range(3))
        closing = -dot(d, relative) / sqrt(dot(d, d) + 1e-9)
        gap = sqrt(dot(d, d)) - room
        if gap <= 0.0:
            return 0.0, far, sqrt(dot(v, v))
        if closing > 0.0 and gap < closing * 1.2:
            return gap / closing, far, sqrt(dot(v, v))
        return NOBODY, far, sqrt(dot(v, v))

    def _male(self, identity: int) -> bool:
        return bool(chance.uniform(self.seed, chance.SEX, 0, identity) < 0.5)

    def _suits(self, me: Body, other: Body) -> bool:
        if other.species != me.species or other.id == me.id:
            return False
        its = self.minds[other.id]
        courting = its.focus if its.intention == MATE else -1
        if (courting >= 0 and courting != me.id) or (courting < 0 and its.libido < 0.25):
            return False
        return self._male(other.id) != self._male(me.id)

    def _in_company(self, other: Body) -> bool:
        k = self.at[other.id]
        for mate in self.bodies[max(k - 4, 0) : k + 5]:
            d = offset(other.at, mate.at)
            near = dot(d, d) < 4.0 * other.length * 4.0 * other.length
            if near and mate.id != other.id and mate.species == other.species:
                return True
        return False

    def _search(self, me: Body) -> list[tuple[float, Body]]:
        sight, visibility = self.sense.sight[me.species], self.world.habitat.visibility
        wide = 4
        while True:
            reach = min(self.plan.cell * wide, visibility)
            found = []
            for other in self.bodies:
                d = offset(me.at, other.at)
                square = dot(d, d)
                if square > min(reach * reach, sight * sight / me.length * other.length):
                    continue
                if other.id == me.id or not self._in_cone(me, d):
                    continue
                if self._swallows(me, other) and other.swallowed_by in (-1, me.id):
                    found.append((square * 2.25 if self._in_company(other) else square, other))
            found = sorted(found, key=lambda pair: pair[0])[:8]
            if len(found) >= 8 or reach >= min(0.584 * sight, visibility):
                return found
            wide *= 2

    def _prey(self, me: Body, target: int) -> tuple[int, float]:
        best, least, near = -1, 1e18, 1e18
        for square, other in self._search(me):
            cost = far = sqrt(square)
            if self._in_company(other):
                far /= 1.5
            along = clamp(dot(offset(me.at, other.at), me.way) / (far + 1e-9), -1.0, 1.0)
            turn = arc(along, sqrt(1.0 - along * along))
            cost *= 1.0 + 0.2 * turn / 3.141592653589793
            cost *= 0.7 if other.id == target else 1.0
            if cost < least and self._clear(me, other):
                best, least, near = other.id, cost, far
        return best, near

    def _meal(self, me: Body, mind: Mind, plain: float, target: int) -> tuple[int, float]:
        sense, kind = self.sense, me.species
        if not (mind.intention == EAT or plain + 0.8 > 0.25):
            return -1, NOBODY
        if sense.hunts[kind]:
            prey, far = self._prey(me, target)
            if prey >= 0:
                return prey, far
        if not sense.grazes[kind] or not self.food:
            return -1, NOBODY
        reach = min(1.5 * sense.sight[kind], self._coarse(len(self.food)))

        def square(k: int) -> float:
            d = offset(me.at, self.food[k])
            return dot(d, d)

        food = min(self.food, key=square)
        if square(food) >= reach * reach:
            return -1, NOBODY
        far, kept = sqrt(square(food)), FOOD - mind.focus
        if kept in self.food and kept != food and 0.7 * sqrt(square(kept)) < far:
            food, far = kept, sqrt(square(kept))
        return FOOD - food, far

    def _find_meal(
        self, me: Body, old: Mind, looks: bool, plain: float, target: int
    ) -> tuple[int, float]:
        """Return the meal that it keeps to, or finds where it looks round or that is gone, and its distance."""
        eats = old.intention == EAT and old.focus != -1
        if not looks and eats:
            meal, far = self._kept_meal(me, old, target)
            if meal != -1:
                return meal, far
        return self._meal(me, old, plain, target) if looks or eats else (-1, NOBODY)

    def _kept_meal(self, me: Body, mind: Mind, target: int) -> tuple[int, float]:
        """Return the meal in focus and its distance, -1 where it is gone."""
        if target in self.at:
            prey = self.bodies[self.at[target]]
            d = offset(me.at, prey.at)
            return (prey.id, sqrt(dot(d, d))) if prey.swallowed_by in (-1, me.id) else (-1, NOBODY)
        if FOOD - mind.focus in self.food:
            d = offset(me.at, self.food[FOOD - mind.focus])
            return mind.focus, sqrt(dot(d, d))
        return -1, NOBODY

    def _mate(
        self, me: Body, mind: Mind, near: list[tuple[float, Body]], target: int
    ) -> tuple[int, float]:
        if mind.intention == MATE and target in self.at:
            partner = self.bodies[self.at[target]]
            d = offset(me.at, partner.at)
            if self._suits(me, partner) and sqrt(dot(d, d)) < 2.0 * self.sense.sight[me.species]:
                return partner.id, sqrt(dot(d, d))
        for square, other in near:
            if self._suits(me, other):
                return other.id, sqrt(square)
        if self.sense.schooling[me.species] or (self.now // 4 + me.id) % 8 != 0:
            return -1, NOBODY
        return self._seek_mate(me)

    def _seek_mate(self, me: Body) -> tuple[int, float]:
        far = min(self.world.habitat.visibility, self._coarse(self._willing))
        sight, best, least = self.sense.sight[me.species], -1, far * far
        for other in self.bodies:
            d = offset(me.at, other.at)
            square = dot(d, d)
            if square >= least or square > sight * sight / me.length * other.length:
                continue
            if self._suits(me, other) and self._in_cone(me, d) and self._clear(me, other):
                best, least = other.id, square
        return best, sqrt(least)

    def _unease(self, me: Body) -> float:
        world, sense, kind = self.world, self.sense, me.species
        bright, warm, terrain = sense.bright[kind], sense.warm[kind], world.terrain
        if (bright == 0 and warm == 0) or (terrain.home_species == kind).any():
            return 0.0
        floor = ground_height(terrain.height, terrain.extent, terrain.cell, me.at[0], me.at[1])
        low = max(sense.deep[kind], floor + 1.2 * me.length + 0.3)
        high = min(sense.shallow[kind], -1.2 * me.length - 0.2)
        if low > high:
            low = high = 0.5 * (low + high)
        z, much, up = me.at[2], 0.0, 0.0
        lit = light(world.habitat, self.day, z)
        if bright > 0:
            much, up = max(0.45 - lit, 0.0) / 0.45, 1.0
        elif bright < 0:
            much, up = max(lit - 0.55, 0.0) / (1.0 - 0.55), -1.0
        if warm != 0:
            below = world.habitat.surface - temperature(world.habitat, self.day, z)
            lack = clamp((below - 1.2 if warm > 0 else 1.0 - below), 0.0, 2.0) / 2.0
            if lack > much:
                much, up = lack, 1.0 if warm > 0 else -1.0
        room = high - z if up > 0.0 else z - low
        return 0.0 if room < 0.5 else min(much, 1.0)

    def _curious(self, me: Body, far: float) -> float:
        sense, kind = self.sense, me.species
        if sense.role[kind] == PREY:
            return 0.0
        if far > min(2.0 * sense.sight[kind], self.world.habitat.visibility):
            return 0.0
        share = 0.3 if sense.role[kind] == PREDATOR else sense.curiosity[kind]
        slot = (self.now + 61 * (me.id & 31)) // 1800
        return far if chance.uniform(self.seed, chance.CURIOSITY, slot, me.id) < share else 0.0

    def _scare(self, kind: int, far: float, speed: float) -> float:
        scare = min(self.sense.wariness[kind] * (0.5 + 0.6 * speed) / (far + 1e-9), 1.0)
        return 0.0 if scare < 0.1 or far > self.world.habitat.visibility else scare

    def _mind(self, me: Body) -> Mind:
        """Perceive, feel and decide for one fish."""
        sense, kind, old = self.sense, me.species, self.minds[me.id]
        role, schooling = sense.role[kind], sense.schooling[kind] != 0
        timid = role == PREY or (role == PACIFIST and sense.hunted[kind] != 0)
        target = old.focus if old.intention in (EAT, MATE) and old.focus in self.at else -1
        near, when, other = self._around(me, target)
        company = (len(near) + self._shoal(me)) if schooling else 0
        busy = old.intention in (MATE, LEAVE, ESCAPE) or old.memory >= 0 or me.id in self.new
        looks = busy or (self.now // 4 + me.id) % 4 == 0
        hunters: list[tuple[float, Body]] = []
        soon, big = NOBODY, -1
        if looks:
            hunters, soon, big = self._hunters(me, target)
        when, other = (soon, big) if soon < when else (when, other)
        meets, far, speed = self._submarine(me)
        scare = self._scare(kind, far, speed) if role == PREY else 0.0
        fear, danger, predator = self._alarm(me, old, looks, hunters, scare)
        obstacle, threat = self._obstacle(me), min(when, meets) < NOBODY
        blocked = obstacle < (1.4 if old.intention == OBSTACLE else 1.0)
        urgent = blocked or threat or (timid and fear > 0.5)
        stomach = in_stomach(me.eaten, me.ate_at, self.now, sense.digestion[kind])
        plain = max(1.0 - stomach / sense.appetite[kind], -1.0)
        meal, meal_far = -1, NOBODY
        if not urgent:
            meal, meal_far = self._find_meal(me, old, looks, plain, target)
        tempted = stimulus(me.length, meal_far, 1.0 / 8.0, 1.0 / 2.0)
        hunger = 0.0 if plain <= -1.0 else clamp(plain + 0.8 * tempted)
        hunger = hunger if looks or old.intention == EAT else old.hunger
        wish = 0.0
        if role != PREDATOR:
            waited = max(float(self.now - me.mated_at), 0.0)
            wish = min(waited / sense.breeding[kind] * (1.0 - clamp(plain)), 1.0)
        eager = min(4.0 * wish, 1.0)
        mate, mate_far = -1, NOBODY
        if looks and not urgent and min(wish + 0.5 * eager, 1.0) > 0.25 * 0.8:
            mate, mate_far = self._mate(me, old, near, target)
        allured = stimulus(me.length, mate_far, 1.0 / 16.0, 1.0 / 4.0)
        libido = min(wish + 0.5 * allured * eager, 1.0) if looks else old.libido
        intention, why, memory, value = self._intend(
            me, old, obstacle, min(when, meets), timid, fear, danger, company, hunger, libido,
            meal != -1, mate >= 0, role == PREDATOR, self._unease(me) if looks else 0.0,
            self._curious(me, far),
        )  # fmt: skip
        focus = -1
        if intention == EAT:
            focus = meal
        elif intention == MATE:
            focus = mate
        elif intention == SCHOOL and near:
            focus = near[0][1].id
        elif intention == ESCAPE and (predator >= 0 or scare > 0.0):
            focus = predator if predator >= 0 and danger > scare else SUBMARINE
        elif intention == AVOID and threat:
            focus = SUBMARINE if meets < when else other
        elif why == CURIOSITY:
            focus = SUBMARINE
        since = self.now if intention != old.intention or threat else old.since
        return Mind(intention, why, since, memory, focus, libido, hunger, fear, predator, value)

    def _intend(  # noqa: C901 (the generator's rules, one after another)
        self, me: Body, old: Mind, obstacle: float, collides: float, timid: bool, fear: float,
        danger: float, company: int, hunger: float, libido: float, food: bool, mate: bool,
        predator: bool, unease: float, curious: float,
    ) -> tuple[int, int, int, float]:  # fmt: skip
        """Return intention, reason, memory and what decided."""
        was, lasted = old.intention, self.now - old.since
        kept = was if was in (EAT, MATE) else old.memory
        if obstacle < (1.4 if was == OBSTACLE else 1.0):
            return OBSTACLE, NEAR_OBSTACLE, kept, obstacle
        if collides < NOBODY:
            return AVOID, COLLISION, kept, collides
        ease = 0.8 if was == ESCAPE else 1.0
        if timid and fear > 0.5 * ease:
            settled = was != ESCAPE or lasted >= 45
            if danger < 0.8 * ease and company > 0 and settled:
                return SCHOOL, FEAR_SCHOOL, kept, fear
            return ESCAPE, FEAR_ESCAPE, kept, fear
        if was == ESCAPE and lasted < 45:
            return ESCAPE, PERSISTENCE, old.memory, float(45 - lasted)
        if was == AVOID and lasted < 20:
            return AVOID, PERSISTENCE, old.memory, float(20 - lasted)
        if was == EAT and old.focus >= 0 and lasted > 600:
            return WANDER, PERSISTENCE, -1, 300.0
        if was == WANDER and old.why == PERSISTENCE and predator and lasted < 300:
            return WANDER, PERSISTENCE, -1, float(300 - lasted)
        if old.memory == EAT and hunger > 0.25 * 0.8 and food:
            return EAT, RESUMED, -1, hunger
        if old.memory == MATE and libido > 0.25 * 0.8 and mate:
            return MATE, RESUMED, -1, libido
        hungry = hunger > 0.25 * (0.8 if was == EAT else 1.0) and (food or predator)
        fond = libido > 0.25 * (0.8 if was == MATE else 1.0) and mate
        if hungry and fond:
            if hunger == libido:
                whim = chance.uniform(self.seed, chance.WHIM, self.now, me.id) < 0.5
                hungry = was == EAT or (was != MATE and bool(whim))
            else:
                hungry = hunger * (0.8 if was == MATE else 1.0) > libido
        if hungry:
            return EAT, HUNGER, -1, hunger
        if fond:
            return MATE, LIBIDO, -1, libido
        if unease > (0.1 if was == LEAVE else 0.3) and not predator:
            return LEAVE, HABITAT, -1, unease
        calm = SCHOOL if company > 0 else WANDER
        if was in (WANDER, SCHOOL) and calm != was and lasted < 40:
            return was, PERSISTENCE, -1, float(40 - lasted)
        if calm == SCHOOL:
            return SCHOOL, COMPANY, -1, float(company)
        if curious > 0.0:
            return WANDER, CURIOSITY, -1, curious
        return WANDER, CONTENT, -1, max(hunger, libido)
