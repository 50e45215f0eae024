"""The clock: 60 ticks a second, one row."""

from components.clock import TICK_SECONDS, TICKS_PER_SECOND, Clock


def test_a_clock_starts_at_tick_nought_with_its_seed() -> None:
    clock = Clock(seed=5)
    assert (clock.now, int(clock.seed[0]), clock.count) == (0, 5, 1)
    clock.tick[0] += 61
    assert clock.now == 61
    assert TICK_SECONDS * TICKS_PER_SECOND == 1.0


def test_a_restored_clock_goes_on_from_there() -> None:
    clock = Clock(seed=3)
    clock.tick[0] = 10
    saved = clock.snapshot()
    clock.tick[0] = 99
    clock.restore(saved)
    assert clock.now == 10
