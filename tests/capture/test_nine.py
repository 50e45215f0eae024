"""Nine bodies of reef fishes swim, turn and flee like living ones (FINDINGS 1b, 3)."""

import re

import pytest

from components.body import Body, Swim
from tools.capture.capture import capture

# Stations; half-widths; half-heights; half-span of the tail; contractions, lag [degrees], frequency [Hz].
NINE = """
sardine | .11 .28 .47 .66 .82 | .036 .050 .047 .032 .013 | .060 .088 .085 .058 .026 | .105 | .341 .554 152.8 4.00
clownfish | .11 .27 .45 .62 .77 | .055 .080 .072 .048 .020 | .105 .180 .180 .125 .070 | .115 | .414 .582 146.4 3.33
blue_tang | .11 .27 .46 .65 .80 | .040 .058 .054 .036 .016 | .120 .180 .185 .125 .042 | .140 | .286 .423 142.7 3.00
butterflyfish | .13 .30 .48 .66 .80 | .035 .056 .055 .036 .015 | .110 .235 .265 .195 .055 | .115 | .228 .354 140.3 3.00
parrotfish | .12 .29 .47 .64 .80 | .052 .075 .070 .048 .022 | .100 .150 .148 .105 .058 | .125 | .416 .576 137.9 2.40
angelfish | .12 .29 .47 .66 .81 | .042 .066 .064 .044 .018 | .125 .220 .240 .190 .062 | .120 | .276 .368 132.0 2.31
anthias | .11 .27 .44 .61 .76 | .040 .057 .052 .035 .014 | .085 .128 .122 .085 .044 | .130 | .398 .599 147.5 3.75
barracuda | .17 .34 .52 .69 .84 | .030 .046 .048 .036 .015 | .038 .060 .062 .050 .028 | .100 | .286 .600 141.4 1.82
reef_shark | .13 .28 .44 .60 .76 | .050 .068 .064 .042 .020 | .045 .072 .072 .048 .026 | .100 | .448 .699 138.9 1.43
"""


def bodies() -> dict[str, tuple[Body, Swim]]:
    """Return body and swim of each species."""
    found = {}
    for line in NINE.strip().splitlines():
        name, *numbers = line.split("|")
        at, width, height, span, swim = ([float(n) for n in part.split()] for part in numbers)
        body = Body(tuple(at), tuple(width), tuple(height), span[0])  # type: ignore[arg-type]
        found[name.strip()] = body, Swim(*swim)
    return found


def figure(text: str, before: str) -> float:
    """Return the number between two words of a provenance line."""
    found = re.search(rf"{before} (-?[\d.]+)", text)
    assert found is not None
    return float(found[1])


@pytest.mark.prove
@pytest.mark.parametrize("name", sorted(bodies()))
def test_each_of_nine_species_turns_sharply_and_starts_fast(name: str) -> None:
    notes = capture(*bodies()[name]).provenance
    gradual, sharp, start = (notes[k] for k in ("turn_left", "turn_sharp_left", "fast_start_left"))
    assert 10 <= figure(gradual, "turn") <= 40
    assert figure(sharp, "turn") >= (40 if name == "reef_shark" else 60)
    assert figure(sharp, "in") <= 1.2
    assert figure(sharp, "end") <= 0.01
    assert figure(sharp, "joints") < 70
    assert figure(start, "turn") >= 80
    assert figure(start, "in") <= 1.0
    assert figure(start, "joints") < 70
    assert "turn" not in notes["warnings"]
    assert "start" not in notes["warnings"]


@pytest.mark.prove
@pytest.mark.parametrize("name", sorted(bodies()))
def test_each_of_nine_species_swims_within_the_ranges_of_fishes(name: str) -> None:
    notes = capture(*bodies()[name]).provenance
    slow, cruise, fast = (notes[f"swim_{gear}"] for gear in ("slow", "medium", "fast"))
    assert 0.2 < figure(cruise, "Strouhal") < 0.45
    assert 0.12 < figure(cruise, "sweep") < 0.24
    assert figure(cruise, "head") < 0.5 * figure(cruise, "sweep")
    for gear in (slow, cruise, fast):
        assert float(gear.split("closure ")[1].split()[0]) < 1e-5
    speeds = [figure(gear, "speed") for gear in (slow, cruise, fast)]
    assert speeds == sorted(speeds)
