"""What the instruments say, and how the picture is fitted to window and machine."""

from math import pi
from typing import Any

import pytest

from components.camera import VIEWFINDER_ASPECT, VIEWFINDER_SLOPE


@pytest.mark.parametrize(
    ("yaw", "expected"),
    [(0.0, 90.0), (pi / 2, 0.0), (pi, 270.0), (-pi / 2, 180.0), (5 * pi, 270.0)],
)
def test_bearings_count_from_north_clockwise(window: Any, yaw: float, expected: float) -> None:
    from reefgame.screens.hud import bearing

    assert bearing(yaw) == pytest.approx(expected, abs=1e-6)


def test_a_verdict_says_how_many_lack(window: Any) -> None:
    from reefgame.screens.hud import plural, verdict

    assert verdict(9, 12, plural("Sardine", 9), False) == "9 sardines, 3 more: get closer"
    assert verdict(0, 12, plural("Sardine", 0), False).startswith("No sardines")
    assert verdict(1, 12, plural("Sardine", 1), False) == "1 sardine, 11 more: get closer"
    assert plural("Clownfish", 3) == "clownfish"


@pytest.mark.parametrize("size", [(1280, 720), (640, 480), (300, 900), (3000, 500)])
def test_the_viewfinder_is_whole_in_every_window(window: Any, size: tuple[int, int]) -> None:
    from reefgame.screens.viewfinder import frame_box, slope_for

    left, low, wide, tall = frame_box(*size)
    assert wide / tall == pytest.approx(VIEWFINDER_ASPECT)
    assert tall / size[1] == pytest.approx(VIEWFINDER_SLOPE / slope_for(*size))
    assert left >= 0
    assert low >= 0
    assert left + wide <= size[0]


def test_auto_quality_spares_a_machine_without_a_graphics_card(window: Any) -> None:
    from reefgame.screens.stage import drawing

    assert drawing("auto", "llvmpipe (LLVM 15.0.6, 256 bits)") == drawing("low", "")
    assert drawing("auto", "NVIDIA GeForce RTX 3060/PCIe/SSE2") == drawing("high", "")
    assert drawing("high", "llvmpipe").samples > drawing("medium", "llvmpipe").samples == 0
