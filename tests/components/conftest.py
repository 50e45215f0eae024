"""Hypothesis without a clock: a kernel's first call compiles, and no test times anything."""

from hypothesis import settings

settings.register_profile("untimed", deadline=None)
settings.load_profile("untimed")
