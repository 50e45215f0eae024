"""`reefgame bench NAME...`: runs benches, prints a table and writes JSON."""

import json
from collections.abc import Callable, Iterator, Sequence
from importlib import import_module
from pathlib import Path
from typing import Final

from rich.console import Console
from rich.table import Table

from reefgame.bench.case import Case
from reefgame.console import InputError, complain
from reefgame.output import check_output, replacing

NAMES: Final = ("motor", "minds", "fibres", "step", "view", "video", "startup", "memory")


def run(names: Sequence[str], output: Path | None) -> int:
    """Run the named benches, or all of them; return the exit status. Raise InputError for others."""
    wanted = NAMES if "all" in names else tuple(dict.fromkeys(names))
    for name in wanted:
        if name not in NAMES:
            raise InputError(f"no bench is called '{name}'; there are {', '.join(NAMES)} and all")
    check_output(output)
    results = []
    for name in wanted:
        complain(f"measuring {name} ...")
        measure: Callable[[], Iterator[Case]] = import_module(f"reefgame.bench.{name}").measure
        cases = list(measure())
        Console(width=120).print(_table(name, cases))
        results.append({"name": name, "cases": [case.record() for case in cases]})
    if output is not None:
        with replacing(output) as fresh:
            fresh.write_text(json.dumps(results, indent=2) + "\n", encoding="utf-8")
    return 0


def _table(name: str, cases: Sequence[Case]) -> Table:
    table = Table(title=name, title_justify="left")
    for heading in ("case", "value", "unit", "baseline", "ratio", "to hold"):
        table.add_column(heading, justify="left" if heading in ("case", "unit") else "right")
    for case in cases:
        baseline = "" if case.baseline is None else f"{case.baseline:.4g}"
        ratio = "" if case.ratio is None else f"{case.ratio:.4g}"
        table.add_row(case.case, f"{case.value:.4g}", case.unit, baseline, ratio, case.bound)
    return table
