"""Benches run their sides in turn, and compare them round by round."""

from reefgame.bench.case import in_turn, seconds_in_turn, times_faster


def test_sides_run_in_turn_after_one_warm_up() -> None:
    played: list[str] = []
    sides = (lambda: played.append("a"), lambda: played.append("b"))
    seconds = seconds_in_turn(sides, rounds=3)
    assert played == ["a", "b"] * 4
    assert [len(side) for side in seconds] == [3, 3]
    assert len(in_turn(sides, rounds=1)) == 2


def test_a_slow_spell_takes_both_sides() -> None:
    assert times_faster([1.0, 3.0, 1.0, 3.0, 3.0], [2.0, 6.0, 2.0, 6.0, 7.0]) == 2.0
