"""Bodies and swims that cannot be: one clear line says which number, and nothing is written."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import assets
from components.body import Body, Swim
from components.repertoire import Repertoire
from reefgame import cli
from reefgame.content import read_species
from reefgame.content.errors import ContentError
from systems.motor import controllers
from systems.motor.contract import Stroke
from systems.motor.muscle_model import BodyModel, body_model
from tools.capture import escape, faults, turns
from tools.capture.capture import capture
from tools.capture.cut import course
from tools.capture.measure import measure_swim
from tools.capture.record import BlewUpError, Recording, State, at_rest, record
from tools.capture.turns import sharp_turn

NAN, INF = float("nan"), float("inf")
SARDINE = (Path(str(assets.__file__)).parent / "species" / "sardine.yaml").read_text()


@pytest.fixture
def name() -> str:
    return "sardine"


Change = Callable[[Body, Swim], tuple[Body, Swim]]
BAD: dict[str, tuple[Change, str]] = {
    "no width": (
        lambda b, s: (replace(b, half_width=(0.0, *b.half_width[1:])), s),
        "half_width 1 is 0, allowed is 0.001 to 1",
    ),
    "a thousand high": (
        lambda b, s: (replace(b, half_height=(*b.half_height[:4], 1000.0)), s),
        "half_height 5 is 1000, allowed is 0.001 to 1",
    ),
    "crossed stations": (
        lambda b, s: (replace(b, station=(0.1, 0.5, 0.3, 0.7, 0.8)), s),
        "stations must rise from nose to tail: 0.3 does not follow 0.5",
    ),
    "a station at the nose": (
        lambda b, s: (replace(b, station=(0.0, *b.station[1:])), s),
        "stations must rise from nose to tail: 0 does not follow 0",
    ),
    "a tail that is no number": (lambda b, s: (replace(b, tail_span=NAN), s), "tail_span is nan"),
    "endless stiffness": (lambda b, s: (replace(b, stiffness=INF), s), "stiffness is inf"),
    "no beat": (
        lambda b, s: (b, replace(s, frequency_hz=0.0)),
        "frequency_hz is 0, allowed is 0.1 to 15",
    ),
    "a lag that is no number": (lambda b, s: (b, replace(s, lag_deg=NAN)), "lag_deg is nan"),
    "muscles of no length": (
        lambda b, s: (b, replace(s, contraction_rear=1.5)),
        "contraction_rear is 1.5, allowed is 0 to 1",
    ),
}


@pytest.mark.parametrize("case", sorted(BAD))
def test_a_number_that_cannot_be_is_named(body: Body, swim: Swim, case: str) -> None:
    change, says = BAD[case]
    with pytest.raises(ValueError, match=r"allowed|rise") as caught:
        capture(*change(body, swim))
    assert str(caught.value).startswith(says)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("field", "sizes", "says"),
    [
        ("half_width", (1000.0,) * 5, "half_width 1000 is too large, its mass too great"),
        ("half_width", (0.03,) * 4 + (1e4,), "half_width 10000 is too large, its mass too great"),
        ("half_height", (1000.0,) * 5, "half_height 1000 is too large, its mass too great"),
    ],
)
def test_a_simulation_that_blows_up_is_caught_with_its_frame_and_what_is_likely_wrong(
    body: Body,
    swim: Swim,
    field: str,
    sizes: tuple[float, ...],
    says: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(faults, "WIDEST", 1e9)
    with pytest.raises(ValueError, match="blows up") as caught:
        capture(replace(body, **{field: sizes}), swim)  # type: ignore[arg-type]  # five sizes
    assert str(caught.value) == f"the simulation blows up at frame 0: {says}"


def test_what_is_farthest_from_any_fish_is_suspected_first(body: Body, swim: Swim) -> None:
    for wrong, says in (
        (replace(body, half_width=(1e-9,) * 5), "half_width 1e-09 is too thin"),
        (replace(body, stiffness=50.0), "stiffness 50 is too stiff"),
        (replace(body, stiffness=0.02), "stiffness 0.02 is too soft"),
        (replace(body, station=(0.1, 0.3, 0.301, 0.6, 0.8)), "stations 0.001 BL apart are too"),
        (replace(body, tail_span=9.0), "tail_span 9 is too large"),
    ):
        assert faults.suspect(wrong, swim, 1).startswith(says)
    assert (
        faults.suspect(body, replace(swim, frequency_hz=90.0), 1) == "frequency_hz 90 is too high"
    )
    pulling = replace(swim, contraction_rear=70.0)
    assert faults.suspect(body, pulling, 1) == "contraction 70 is too large"


def test_a_fish_that_nothing_tames_is_said_to_be_none(body: Body, swim: Swim) -> None:
    monster = replace(body, half_width=(1e9,) * 5, half_height=(1e9,) * 5)
    assert "far from any fish" in faults.suspect(monster, swim, 1)


def test_the_frame_of_a_blow_up_counts_from_the_strokes_start(body: Body, swim: Swim) -> None:
    model = body_model(body, swim)
    state = at_rest(model)
    record(model, controllers.swim(swim), 7, state)
    state.velocity[3, 1] = NAN
    with pytest.raises(BlewUpError) as caught:
        record(model, controllers.swim(swim), 20, state, 7)
    assert caught.value.frame == 7
    far = at_rest(model)
    far.position[22] = 9.0
    with pytest.raises(BlewUpError):
        record(model, controllers.glide(), 1, far)


def test_tries_that_blow_up_count_for_nothing(
    body: Body, swim: Swim, monkeypatch: pytest.MonkeyPatch
) -> None:
    model, stroke = body_model(body, swim), controllers.swim(swim)
    limit = 0.45

    def fragile(
        model: BodyModel, stroke: Stroke, frames: int, state: State | None = None, begin: int = 0
    ) -> Recording:
        if stroke.turn > limit:
            raise BlewUpError(begin)
        return record(model, stroke, frames, state, begin)

    monkeypatch.setattr(turns, "record", fragile)
    assert sharp_turn(model, stroke, 600).stroke.turn == pytest.approx(0.4)
    limit = -1.0
    with pytest.raises(BlewUpError):
        sharp_turn(model, stroke._replace(turn=0.0), 600)


def test_a_fast_start_that_blows_up_is_the_worst_of_all(
    body: Body, swim: Swim, monkeypatch: pytest.MonkeyPatch
) -> None:
    def burst(*_: object) -> Recording:
        raise BlewUpError(3)

    monkeypatch.setattr(escape, "record", burst)
    assert escape._loss(body_model(body, swim, "firm"), controllers.swim(swim).loops) == INF


def test_a_fish_that_stays_where_it_is_has_no_course(body: Body, swim: Swim) -> None:
    with pytest.raises(ValueError, match="does not swim: it stays where it is"):
        capture(body, replace(swim, contraction_middle=0.0, contraction_rear=0.0))
    still = np.zeros((30, 3))
    with pytest.raises(ValueError, match="stays where it is"):
        course(Recording(np.zeros((30, 23, 3)), still, np.tile(np.eye(3), (30, 1, 1))), 5, 10)


def test_a_body_that_folds_is_a_fault(body: Body, swim: Swim, shipped: Repertoire) -> None:
    still = body_model(body, swim).start
    period = len(shipped.segments[1].translation)
    folded = np.tile(still, (2 * period + 1, 1, 1))
    folded[:, 21:, :2] = (-0.7, 0.4)
    origin = np.zeros((len(folded), 3))
    origin[:, 0] = np.arange(len(folded)) * 0.01
    run = Recording(folded, origin, np.tile(np.eye(3), (len(folded), 1, 1)))
    found = measure_swim(run, shipped.segments[1], 0).faults()
    assert any(fault.startswith("bends a joint by ") for fault in found)


LINES = {
    "at_bl": "[0.11, 0.28, 0.47, 0.66, 0.82]",
    "half_width_bl": "[0.036, 0.050, 0.047, 0.032, 0.013]",
    "contraction_rear": "0.541",
    "lag_deg": "153.9",
    "frequency_hz": "4.0",
}
WRONG = [
    ("at_bl", "[0.11, 0.47, 0.28, 0.66, 0.82]", 0, "stations must rise from nose to tail"),
    ("at_bl", "[0.11, 0.28, 0.281, 0.66, 0.82]", 0, "each at least 0.04 behind the last"),
    ("half_width_bl", "[0.0, 0.050, 0.047, 0.032, 0.013]", 1, "at least 0.004"),
    ("half_width_bl", "[0.001, 0.050, 0.047, 0.032, 0.013]", 1, "at least 0.004"),
    ("half_width_bl", "[1000, 0.050, 0.047, 0.032, 0.013]", 1, "at most 0.4"),
    ("half_width_bl", "[.nan, 0.050, 0.047, 0.032, 0.013]", 1, "finite"),
    ("contraction_rear", "1.5", 0, "at most 0.8"),
    ("lag_deg", ".nan", 0, "finite"),
    ("frequency_hz", ".inf", 0, "finite"),
    ("frequency_hz", "1000", 0, "at most 6"),
]


@pytest.mark.parametrize(("key", "value", "column", "says"), WRONG)
def test_a_species_file_that_cannot_be_is_told_with_its_place(
    tmp_path: Path, key: str, value: str, column: int, says: str
) -> None:
    path = tmp_path / "fish.yaml"
    good = f"{key}: {LINES[key]}"
    assert good in SARDINE
    text = SARDINE.replace(good, f"{key}: {value}")
    path.write_text(text)
    before = text[: text.index(f"{key}: {value}") + len(key) + 2 + column].splitlines()
    with pytest.raises(ContentError) as caught:
        read_species(path)
    message = str(caught.value)
    assert message.startswith(f"{path}:{len(before)}:{len(before[-1]) + 1}: ")
    assert says in message
    assert "\n" not in message


def test_capturing_a_fish_that_does_not_move_is_one_line_and_writes_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "stone.yaml"
    still = SARDINE.replace("contraction_middle: 0.266", "contraction_middle: 0.0")
    path.write_text(still.replace("contraction_rear: 0.541", "contraction_rear: 0.0"))
    assert cli.main(["capture", str(path), "-o", str(tmp_path / "out")]) == 1
    said = capsys.readouterr()
    assert said.err == (
        f"{path}: this body does not swim: the fish does not swim: it stays where it is\n"
    )
    assert list((tmp_path / "out").iterdir()) == []
