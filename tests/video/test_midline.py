"""The medial axis, the fins taken off, and which way a fish heads."""

from collections.abc import Callable

import cv2
import numpy as np
import pytest

from tools.video.contour import outline_of, smooth_contour
from tools.video.fins import Finless, without_fins
from tools.video.images import Grey
from tools.video.mask import Sighting
from tools.video.midline import medial_axis, whole_axis
from tools.video.orientation import continued, first_heading, shape_of
from tools.video.pectorals import pectorals_of

LEFT = np.array([-1.0, 0.0])


def _finless(mask: Grey) -> Finless:
    outline = outline_of(mask).astype(np.int32)
    return without_fins(mask, outline, shape_of(outline).centre, LEFT)


def _axis(mask: Grey) -> np.ndarray:
    finless = _finless(mask)
    contour, _ = smooth_contour(finless.outline, 0.5 * len(finless.outline))
    found = medial_axis(finless, contour, LEFT)
    return whole_axis(found.head, found.spine, found.tail)


def _with_fin(mask: Grey, below: bool = True) -> Grey:
    finned = mask.copy()
    way = 1 if below else -1
    leaf = np.array(
        [(116, 150), (137, 150 + way * 48), (141, 150 + way * 46), (124, 150)], np.int32
    )
    cv2.fillPoly(finned, [leaf], 255)
    return finned


@pytest.mark.parametrize("degrees", [-60.0, -20.0, 0.0, 45.0, 90.0])
def test_the_axis_of_an_arc_lies_on_it(body_mask: Callable[..., Grey], degrees: float) -> None:
    axis = _axis(body_mask(degrees=degrees))
    turn = np.radians(degrees)
    if degrees:
        radius = 200.0 / turn
        centre = np.array([150.0, 150.0 + radius])
        away = np.abs(np.hypot(*(axis - centre).T) - abs(radius))
    else:
        away = np.abs(axis[:, 1] - 150.0)
    assert away.mean() < 0.4
    assert np.hypot(*np.diff(axis, axis=0).T).sum() == pytest.approx(200.0, rel=0.03)
    assert axis[0, 0] < axis[-1, 0]


def test_a_fin_is_taken_off_and_the_tail_is_not(body_mask: Callable[..., Grey]) -> None:
    mask = _with_fin(body_mask())
    finless = _finless(mask)
    assert len(finless.fins) == 1
    assert finless.body[190, 130] == 0
    tail = body_mask()[:, 235:]
    assert (finless.body[:, 235:] == tail).all()


@pytest.mark.parametrize("widest", [130, 150, 170])
def test_a_pointed_snout_is_no_fin(widest: int) -> None:
    mask = np.zeros((200, 360), np.uint8)
    body = [(20, 100), (widest, 120), (220, 120), (340, 104), (340, 96), (220, 80), (widest, 80)]
    cv2.fillPoly(mask, [np.array(body, np.int32)], 255)
    snout = mask[:, : widest - 10].copy()
    fin = [(widest, 115), (widest + 25, 140), (widest + 30, 138), (widest + 20, 115)]
    cv2.fillPoly(mask, [np.array(fin, np.int32)], 255)
    finless = _finless(mask)
    assert len(finless.fins) == 1
    assert (finless.body[:, : widest - 10] == snout).all()
    assert _axis(mask)[0, 0] == pytest.approx(20.0, abs=2.0)


def test_a_fin_does_not_bend_the_axis(body_mask: Callable[..., Grey]) -> None:
    plain, finned = _axis(body_mask()), _axis(_with_fin(body_mask()))
    assert np.abs(plain - finned).max() < 2.0
    assert np.abs(plain - finned).mean() < 0.4


@pytest.mark.parametrize(("below", "side"), [(True, 0), (False, 1)])
def test_a_fin_belongs_to_the_side_it_stands_on(
    body_mask: Callable[..., Grey], below: bool, side: int
) -> None:
    mask = _with_fin(body_mask(), below)
    finless = _finless(mask)
    fins = pectorals_of(finless, _axis(mask))
    # A fish that heads left, seen from above, has its left below.
    assert not np.isnan(fins.tip[side, 0])
    assert np.isnan(fins.tip[1 - side, 0])
    assert abs(fins.tip[side, 1] - 150.0) > 40.0
    top, bottom = fins.junction[side], fins.junction[2 + side]
    assert top[0] < bottom[0]
    assert np.abs(np.array([top[1], bottom[1]]) - 150.0).max() < 30.0


def test_a_forked_tail_ends_between_its_lobes(body_mask: Callable[..., Grey]) -> None:
    mask = body_mask()
    for way in (1, -1):
        lobe = np.array(
            [(228, 150), (262, 150 + way * 22), (256, 150 + way * 8), (240, 150)], np.int32
        )
        cv2.fillPoly(mask, [lobe], 255)
    finless = _finless(mask)
    contour, _ = smooth_contour(finless.outline, 0.5 * len(finless.outline))
    found = medial_axis(finless, contour, LEFT)
    assert found.lobes == pytest.approx([262.0, 150.0], abs=2.0)


def test_a_tail_without_a_fork_has_no_lobes(body_mask: Callable[..., Grey]) -> None:
    finless = _finless(body_mask())
    contour, _ = smooth_contour(finless.outline, 0.5 * len(finless.outline))
    assert np.isnan(medial_axis(finless, contour, LEFT).lobes).all()


def test_the_heavier_half_is_the_heads(body_mask: Callable[..., Grey]) -> None:
    mask = body_mask()
    outline = outline_of(mask).astype(np.int32)
    sighting = Sighting(
        mask, outline, (0, 0), (0, 0, 300, 300), float((mask > 0).sum()), 2.0, False
    )
    assert first_heading([sighting])[0] < -0.99
    assert shape_of(outline).evidence(LEFT) > 0.1


def test_a_heading_never_turns_by_more_than_a_right_angle() -> None:
    before = np.array([0.6, 0.8])
    assert continued(np.array([-0.6, -0.8]), before) @ before > 0.99


def test_a_disc_has_no_direction() -> None:
    mask = np.zeros((100, 100), np.uint8)
    cv2.circle(mask, (50, 50), 30, 255, -1)
    assert shape_of(outline_of(mask).astype(np.int32)).is_round
