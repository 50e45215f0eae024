"""Peers for benches: the other ways of computing the same thing, that ours is compared with."""
