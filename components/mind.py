"""What each fish attends to, wants, feels, remembers and intends, and why (papers/004; papers/000 sections 3.2 and
6; FINDINGS 2).

The rows stand in step with `FishTable`'s (components/fish.py).
"""

from enum import IntEnum
from typing import Final

import numpy as np

from components.arrays import Float32s, Float64s, Int8s, Int64s
from components.table import Table, column


class Role(IntEnum):
    """The three types of artificial fish (papers/004)."""

    PREY = 0
    PREDATOR = 1
    PACIFIST = 2


class Intention(IntEnum):
    """What a fish is about; each has a behaviour routine of its own in systems/mind/behave."""

    WANDER = 0
    AVOID_OBSTACLE = 1
    AVOID_FISH = 2
    SCHOOL = 3
    EAT = 4
    MATE = 5
    LEAVE = 6
    ESCAPE = 7
    OBEY = 8
    "the player steers it"


class Why(IntEnum):
    """The branch of the intention generator that decided (FINDINGS 2); its input stands in `why_value`."""

    CONTENT = 0
    "nothing pressed; largest of hunger and libido"
    OBSTACLE = 1
    "an obstacle is near; its distance over the distance that alarms"
    COLLISION = 2
    "a fish crosses; seconds until then"
    FEAR_ESCAPE = 3
    "fear above f0, and a predator too near, or no schooler; the fear"
    FEAR_SCHOOL = 4
    "fear above f0, no single predator too near: safety in numbers; the fear"
    HUNGER = 5
    "hunger above r; the hunger"
    LIBIDO = 6
    "libido above r; the libido"
    RESUMED = 7
    "an interrupted intention was remembered; its want"
    COMPANY = 8
    "a schooler sees its kind; how many it attends to"
    HABITAT = 9
    "too bright, dark, warm or cold; by how much"
    CURIOSITY = 10
    "a pacifist saw the submarine; its distance [m]"
    PERSISTENCE = 11
    "what it is about holds a while yet; ticks left"
    PLAYER = 12
    "the player steers it; 0"
    STUNG = 13
    "an anemone stung it; ticks for which it yet hurts"


class Courtship(IntEnum):
    """The phases of mating (papers/004)."""

    NONE = 0
    LOOPING = 1
    CIRCLING = 2
    ASCENT = 3
    NUZZLING = 4


SUBMARINE: Final = -2
"""What the focus holds where the submarine is attended to."""

FOOD: Final = -16
"""The focus on food particle k is FOOD - k."""


class MindTable(Table):
    """The mind of each fish, one row each."""

    intention: Int8s = column(np.int8)
    "an `Intention`, (capacity,)"
    why: Int8s = column(np.int8)
    "the `Why` of the last decision, (capacity,)"
    why_value: Float32s = column(np.float32)
    "its deciding input, in the unit that `Why` names, (capacity,)"
    focus: Int64s = column(np.int64, fill=-1)
    "stable id of the fish attended to, -1 for none, `SUBMARINE`, or `FOOD` - k for food, (capacity,)"
    since: Int64s = column(np.int64)
    "tick at which the intention began, (capacity,)"
    thought_at: Int64s = column(np.int64, fill=-1_000_000)
    "tick of the last thought, (capacity,)"
    wander_until: Int64s = column(np.int64)
    "tick at which a wanderer picks a new direction, (capacity,)"
    wander: Float64s = column(np.float64, 3)
    "unit direction of a wanderer, world axes, (capacity, 3)"
    side: Int8s = column(np.int8)
    "to which it swings round the obstacle before it: 1 left of the way out, -1 right, 0 for none, (capacity,)"
    memory: Int8s = column(np.int8, fill=-1)
    "the one intention that was interrupted and is remembered, -1 for none, (capacity,)"
    memory_focus: Int64s = column(np.int64, fill=-1)
    "what that one was focused on, (capacity,)"
    hunger: Float64s = column(np.float64)
    "H, 0 to 1, with the stimulus term, as of the last thought, (capacity,)"
    libido: Float64s = column(np.float64)
    "L, 0 to 1, (capacity,)"
    fear: Float64s = column(np.float64)
    "F, 0 to 1, of all predators seen, (capacity,)"
    danger: Float64s = column(np.float64)
    "F_m, 0 to 1, of the most dangerous predator seen, (capacity,)"
    wary_of: Int64s = column(np.int64, fill=-1)
    "stable id of that predator, -1 for none: it is kept in mind between two looks round, (capacity,)"
    eaten: Float64s = column(np.float64)
    "n: meals in the stomach, over the fish's own average meal, (capacity,)"
    ate_at: Int64s = column(np.int64)
    "tick of the last bite; digestion runs from there; spawning draws it from the past, (capacity,)"
    mated_at: Int64s = column(np.int64)
    "tick of the last mating; libido grows from there; spawning draws it from the past, (capacity,)"
    courtship: Int8s = column(np.int8)
    "a `Courtship`, (capacity,)"
    courtship_since: Int64s = column(np.int64)
    "tick at which that phase began, (capacity,)"
    gape: Float64s = column(np.float64)
    "how wide the mouth is open, 0 to 1; for feeding and the view, (capacity,)"
    swallowed_by: Int64s = column(np.int64, fill=-1)
    "stable id of the fish that sucks this one in, -1 for none, (capacity,)"
    stung_until: Int64s = column(np.int64)
    "tick until which a fish flees the anemone that stung it, (capacity,)"
