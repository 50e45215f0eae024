"""Lists of singularities by clump: complete, in rising order, the same from the octree, and lossless."""

from types import ModuleType

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.arrays import Float32s, Float64s
from components.field import pack
from components.garden import Garden
from systems.sea import gather as gathering
from systems.sea.bend import NumbaBender
from systems.sea.gather import Lists, gather

SPHERES = 25


def _scene(number: int, seed: int, across: float) -> tuple[Float64s, Float32s]:
    """Return spheres and packed singularities; each tenth has no bounds, some are off, many lie on one spot."""
    chance = np.random.default_rng(seed)
    packed = np.zeros((number, 16), np.float32)
    packed[:, :3] = chance.uniform(-across, across, (number, 3))
    packed[: number // 3, :3] = packed[:1, :3]
    packed[:, 3] = chance.uniform(0.1, 3.0, number)
    packed[::10, 3] = np.inf
    packed[:, 8] = chance.integers(-1, 3, number)
    sphere = chance.uniform(-across, across, (SPHERES, 4))
    sphere[:, 3] = chance.uniform(0.0, 3.0, SPHERES)
    return sphere, packed


def _sets(lists: Lists) -> list[list[int]]:
    ends = zip(lists.first, lists.first[1:], strict=False)
    return [lists.member[a:b].tolist() for a, b in ends]


def _by_octree(monkeypatch: pytest.MonkeyPatch, sphere: Float64s, packed: Float32s) -> Lists:
    monkeypatch.setattr(gathering, "MANY", 0)
    return gather(sphere, packed)


@settings(max_examples=25)
@given(st.integers(1, 700), st.integers(0, 1_000), st.sampled_from([0.0, 1.0, 30.0, 5e4]))
def test_the_octree_lists_what_a_plain_search_lists(number: int, seed: int, across: float) -> None:
    sphere, packed = _scene(number, seed, across)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(gathering, "MANY", number)
        plain = _sets(gather(sphere, packed))
        assert _sets(_by_octree(patch, sphere, packed)) == plain
    q = sphere[:, None, :3] - packed[None, :, :3].astype(float)
    touches = np.sqrt((q**2).sum(2)) <= sphere[:, 3:] + packed[:, 3].astype(float)
    touches &= packed[:, 8] != 0.0
    for listed, touched in zip(plain, touches, strict=True):
        assert listed == sorted(listed)
        assert set(np.flatnonzero(touched)) <= set(listed)


def test_lists_leave_out_what_is_far() -> None:
    sphere, packed = _scene(400, 0, 30.0)
    lists = gather(sphere, packed)
    assert 0 < lists.first[-1] < 0.3 * SPHERES * len(packed)
    assert gather(sphere, packed, culled=False).first[-1] == SPHERES * len(packed)


def test_lists_grow_where_they_must_and_are_used_again() -> None:
    sphere, packed = _scene(400, 0, 0.5)
    short = Lists(np.zeros(SPHERES + 1, np.int32), np.zeros(1, np.int32))
    lists = gather(sphere, packed, short)
    assert _sets(lists) == _sets(gather(sphere, packed))
    assert gather(sphere, packed, lists).member is lists.member


@pytest.mark.parametrize("number", [0, 1])
def test_few_or_no_singularities_and_spheres_make_lists(
    monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    sphere, packed = _scene(number, 1, 1.0)
    assert gather(sphere, packed).first[-1] == _by_octree(monkeypatch, sphere, packed).first[-1]
    assert gather(np.zeros((0, 4)), packed).first.tolist() == [0]


def test_ten_thousand_singularities_bend_as_without_culling(bed: ModuleType) -> None:
    table = bed.water(10_000, across=40.0)
    table.kind[:10_000] = np.arange(10_000) % 3
    table.reach[:10_000] = 0.8
    packed = pack(table, 0)
    culled, plain = Garden(bed.anemone()), Garden(bed.anemone())
    for _ in range(3):
        NumbaBender(parallel=False).step(culled, packed, bed.FRAME)
        NumbaBender(parallel=False, culled=False).step(plain, packed, bed.FRAME)
    assert np.array_equal(culled.position, plain.position)
    assert not np.array_equal(culled.position, Garden(bed.anemone()).position)
    assert bed.rod_errors(culled).max() < 1e-6
