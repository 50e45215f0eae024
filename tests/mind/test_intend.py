"""The intention generator, rule by rule (FINDINGS 2)."""

from typing import Any

import pytest

from components.mind import Intention, Why
from systems.mind.intend import (
    AFRAID,
    AVOID_TICKS,
    CALM_TICKS,
    CHASE_TICKS,
    ESCAPE_TICKS,
    PANICKED,
    RELENT,
    REST_TICKS,
    UNEASY,
    WANTING,
    Held,
    Percept,
    intend,
)

Do, W = Intention, Why
NOW = 10_000

CALM = Percept(
    obstacle=9.0,
    collision=1e9,
    threat=False,
    timid=True,
    fear=0.0,
    danger=0.0,
    company=0,
    hunger=0.0,
    libido=0.0,
    food=False,
    mate=False,
    hunter=False,
    chasing=False,
    unease=0.0,
    curious=0.0,
    whim=False,
)


def decide(
    previous: Intention = Do.WANDER, lasted: int = 1000, memory: int = -1, why: Why = W.CONTENT,
    **percept: Any,
) -> tuple[Intention, Why, float, int]:  # fmt: skip
    intention, reason, value, kept = intend(
        NOW,
        Held(int(previous), int(why), NOW - lasted, int(memory)),
        CALM._replace(**{name: type(getattr(CALM, name))(v) for name, v in percept.items()}),
    )
    return Do(intention), W(reason), value, kept


def test_an_obstacle_goes_before_everything() -> None:
    found = decide(obstacle=0.7, threat=True, collision=0.3, fear=1.0, danger=1.0)
    assert found[:3] == (Do.AVOID_OBSTACLE, W.OBSTACLE, 0.7)


def test_an_obstacle_is_watched_a_little_longer_than_it_alarms() -> None:
    assert decide(Do.AVOID_OBSTACLE, obstacle=1.2)[0] == Do.AVOID_OBSTACLE
    assert decide(Do.WANDER, obstacle=1.2)[0] == Do.WANDER


def test_a_collision_goes_before_fear_and_is_persisted_in() -> None:
    assert decide(threat=True, collision=0.4, fear=1.0)[:3] == (Do.AVOID_FISH, W.COLLISION, 0.4)
    assert decide(Do.AVOID_FISH, lasted=1)[:2] == (Do.AVOID_FISH, W.PERSISTENCE)
    assert decide(Do.AVOID_FISH, lasted=AVOID_TICKS)[0] == Do.WANDER


def test_fear_flees_or_schools_by_how_near_one_predator_is() -> None:
    alone = decide(fear=AFRAID + 0.1, danger=0.5, hunger=1.0, food=True)
    assert alone[:2] == (Do.ESCAPE, W.FEAR_ESCAPE)
    among = decide(fear=AFRAID + 0.1, danger=PANICKED - 0.1, company=4)
    assert among[:2] == (Do.SCHOOL, W.FEAR_SCHOOL)
    upon = decide(fear=1.0, danger=PANICKED + 0.1, company=4)
    assert upon[:2] == (Do.ESCAPE, W.FEAR_ESCAPE)


def test_who_is_not_timid_does_not_flee() -> None:
    assert decide(timid=False, fear=1.0, danger=1.0)[0] == Do.WANDER


def test_a_fish_flees_for_a_while_and_until_fear_has_well_passed() -> None:
    assert decide(Do.ESCAPE, lasted=5)[:2] == (Do.ESCAPE, W.PERSISTENCE)
    assert decide(Do.ESCAPE, lasted=ESCAPE_TICKS)[0] == Do.WANDER
    assert decide(Do.ESCAPE, fear=AFRAID * 0.9)[0] == Do.ESCAPE
    assert decide(Do.WANDER, fear=AFRAID * 0.9)[0] == Do.WANDER


@pytest.mark.parametrize(
    ("hunger", "libido", "wanted", "why"),
    [
        (WANTING + 0.2, WANTING + 0.1, Do.EAT, W.HUNGER),
        (WANTING + 0.1, WANTING + 0.2, Do.MATE, W.LIBIDO),
        (WANTING, WANTING, Do.WANDER, W.CONTENT),
    ],
)
def test_the_larger_want_above_the_threshold_is_followed(
    hunger: float, libido: float, wanted: Intention, why: Why
) -> None:
    assert decide(hunger=hunger, libido=libido, food=True, mate=True)[:2] == (wanted, why)


@pytest.mark.parametrize("previous", [Do.EAT, Do.MATE])
def test_ties_of_hunger_and_libido_keep_what_one_is_about(previous: Intention) -> None:
    for whim in (False, True):
        found = decide(previous, hunger=0.6, libido=0.6, food=True, mate=True, whim=whim)
        assert found[0] == previous


def test_other_ties_are_tossed() -> None:
    tossed = {
        decide(hunger=0.6, libido=0.6, food=True, mate=True, whim=whim)[0] for whim in (False, True)
    }
    assert tossed == {Do.EAT, Do.MATE}


def test_a_want_needs_something_to_be_about_but_hunters_search() -> None:
    assert decide(hunger=1.0, libido=1.0)[0] == Do.WANDER
    assert decide(hunger=1.0, hunter=True)[:2] == (Do.EAT, W.HUNGER)


def test_what_danger_interrupts_is_remembered_and_resumed() -> None:
    interrupted = decide(Do.EAT, threat=True, collision=0.2, hunger=0.5)
    assert interrupted[0] == Do.AVOID_FISH
    assert interrupted[3] == Do.EAT
    still = decide(Do.AVOID_FISH, memory=Do.EAT, obstacle=0.5)
    assert still[3] == Do.EAT
    after = decide(Do.AVOID_FISH, memory=Do.EAT, hunger=0.5, libido=0.9, food=True, mate=True)
    assert after[:2] == (Do.EAT, W.RESUMED)
    assert after[3] == -1


def test_what_is_remembered_is_dropped_when_it_has_no_object_left() -> None:
    found = decide(Do.AVOID_FISH, memory=Do.EAT, hunger=0.5)
    assert found[0] == Do.WANDER
    assert found[3] == -1


def test_the_memory_holds_one_thing() -> None:
    assert decide(Do.MATE, memory=Do.EAT, threat=True, collision=0.1)[3] == Do.MATE
    assert decide(Do.SCHOOL, memory=Do.EAT, threat=True, collision=0.1)[3] == Do.EAT


def test_unsuitable_light_or_warmth_is_left_until_it_is_well_suited() -> None:
    assert decide(unease=UNEASY + 0.1, company=5)[:2] == (Do.LEAVE, W.HABITAT)
    assert decide(Do.LEAVE, unease=UNEASY * 0.5)[0] == Do.LEAVE
    assert decide(Do.WANDER, unease=UNEASY * 0.5)[0] == Do.WANDER
    assert decide(unease=1.0, hunter=True)[0] == Do.WANDER


def test_company_is_joined_and_calm_intentions_do_not_flicker() -> None:
    assert decide(company=3)[:3] == (Do.SCHOOL, W.COMPANY, 3.0)
    assert decide(Do.SCHOOL, lasted=1)[:2] == (Do.SCHOOL, W.PERSISTENCE)
    assert decide(Do.SCHOOL, lasted=CALM_TICKS)[0] == Do.WANDER
    assert decide(Do.WANDER, lasted=1, company=3)[0] == Do.WANDER


def test_curiosity_comes_last() -> None:
    assert decide(curious=4.0)[:3] == (Do.WANDER, W.CURIOSITY, 4.0)
    assert decide(curious=4.0, hunger=0.9, food=True)[0] == Do.EAT


def test_a_hunter_gives_a_chase_up_and_rests() -> None:
    chase: dict[str, Any] = {"hunger": 1.0, "food": True, "hunter": True, "chasing": True}
    assert decide(Do.EAT, lasted=CHASE_TICKS, **chase)[0] == Do.EAT
    assert decide(Do.EAT, lasted=CHASE_TICKS + 1, **chase)[:2] == (Do.WANDER, W.PERSISTENCE)
    rest = decide(Do.WANDER, lasted=10, why=W.PERSISTENCE, **chase)
    assert rest[:2] == (Do.WANDER, W.PERSISTENCE)
    assert decide(Do.WANDER, lasted=REST_TICKS, why=W.PERSISTENCE, **chase)[0] == Do.EAT


def test_wants_go_on_a_little_below_their_threshold() -> None:
    assert decide(Do.EAT, hunger=WANTING * RELENT + 0.01, food=True)[0] == Do.EAT
    assert decide(Do.WANDER, hunger=WANTING * RELENT + 0.01, food=True)[0] == Do.WANDER
