"""Checksums of the simulation's state, a table at a time, so that a desync is named by its table
(DESIGN 7).

Four lanes of a 64-bit integer mix run side by side over the bytes of every column: the same on
every machine.
"""

import numpy as np

from components.arrays import UInt64s
from components.chance import mix
from components.kernels import row
from components.table import Table

_LANES = 4
_PRIME = np.uint64(0x9E3779B97F4A7C15)
_SHIFT = np.uint64(29)


@row
def _absorb(lane: np.uint64, word: np.uint64) -> np.uint64:
    lane = (lane ^ word) * _PRIME
    return lane ^ (lane >> _SHIFT)


@row
def hash_words(words: UInt64s, seed: np.uint64) -> np.uint64:
    """Return a 64-bit hash of `words` (n,), starting from `seed`."""
    a, b, c, d = seed, seed + np.uint64(1), seed + np.uint64(2), seed + np.uint64(3)
    whole = len(words) - len(words) % _LANES
    for at in range(0, whole, _LANES):
        a = _absorb(a, words[at])
        b = _absorb(b, words[at + 1])
        c = _absorb(c, words[at + 2])
        d = _absorb(d, words[at + 3])
    for at in range(whole, len(words)):
        a = _absorb(a, words[at])
    return mix(mix(mix(mix(a) ^ b) ^ c) ^ d) ^ np.uint64(len(words))


def table_checksum(table: Table) -> int:
    """Return the 64-bit checksum of all columns of the living rows."""
    seed = np.uint64(table.count)
    for name in table.columns:
        data = np.ascontiguousarray(table.live(name)).reshape(-1).view(np.uint8)
        spare = -len(data) % 8
        if spare:
            data = np.concatenate([data, np.zeros(spare, np.uint8)])
        seed = np.uint64(hash_words(data.view(np.uint64), seed))
    return int(seed)
