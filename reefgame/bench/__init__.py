"""Benches: what the game costs, measured side by side in one run (DESIGN 8). One file a bench.

A bench is a function that yields cases; a case is named by its parameters, `fishes=10000 threads=2 against=ckdtree`.
"""
