"""The pictures of docs/minds.md, from the scenes of this folder: `python tests/scenes/plots.py` draws them anew."""

from pathlib import Path

import numpy as np

from components.mind import Courtship
from reefgame.testing import observe, read_scene
from reefgame.testing.picture import panel, place, sheet

HERE = Path(__file__).parent
PICTURES = HERE.parents[1] / "docs" / "pictures"


def draw_split() -> str:
    """A school that parts round a barracuda, from above."""
    o = observe(read_scene(HERE / "school_splits.yaml"), seed=0, seconds=25)
    school, hunter = o.of("sardine"), o.of("barracuda")[0]
    middle = o.position[:, school].mean(axis=1)
    at = int(np.argmin(np.linalg.norm(middle - o.position[:, hunter], axis=1)))
    panels = []
    for index, late in enumerate((-25, 0, 20, 80)):
        t = min(at + late, len(o.seconds) - 1)
        title = f"{late / 10:+.1f} s" if late else "the barracuda comes through: 0 s"
        panels.append(panel(o, t, middle[t], 5.6, title, place(index), tail=12))
    return sheet(panels, "A school of sardines parts round a barracuda and is one again")


def draw_flight() -> str:
    """Five lone sardines of three degrees of wariness as a barracuda comes, from above."""
    scene = read_scene(HERE / "prey_flees.yaml")
    assert scene.file.vary is not None
    panels = []
    for index, value in enumerate(scene.file.vary.values):
        o = observe(scene, seed=0, variant=index, seconds=12)
        prey, hunter = o.of("sardine"), o.of("barracuda")[0]
        far = np.linalg.norm(o.position[:, prey].mean(axis=1) - o.position[:, hunter], axis=1)
        t = int(np.argmax(far < 4.5))
        title = f"wariness_m: {value:g}"
        centre = 0.5 * (o.position[t, prey].mean(axis=0) + o.position[t, hunter])
        panels.append(panel(o, t, centre, 7.5, title, place(index), tail=15))
    return sheet(panels, "The warier sardines are, the earlier they flee from a barracuda")


def draw_courtship() -> str:
    """The four phases of a courtship, from the side."""
    o = observe(read_scene(HERE / "pair_mates.yaml"), seed=0)
    pair, panels = o.of("blue_tang"), []
    for index, phase in enumerate(list(Courtship)[1:]):
        both = np.flatnonzero((o.courtship[:, pair] == phase).all(axis=1))
        t = int(both[-1 if phase == Courtship.ASCENT else (2 * len(both)) // 3])
        title = f"{phase.name.lower()}, {o.seconds[t]:.0f} s"
        up = 2 if phase in (Courtship.ASCENT, Courtship.NUZZLING) else 1
        title += ", from the side" if up == 2 else ", from above"
        centre = o.position[t, pair].mean(axis=0)
        panels.append(panel(o, t, centre, 2.0, title, place(index), tail=25, up=up))
    return sheet(panels, "Two blue tangs court: looping, circling, spawning ascent, nuzzling")


def main() -> None:
    """Draw the pictures of docs/minds.md."""
    for name, draw in (
        ("split", draw_split), ("flight", draw_flight), ("courtship", draw_courtship),
    ):  # fmt: skip
        (PICTURES / f"minds_{name}.svg").write_text(draw(), encoding="utf-8")


if __name__ == "__main__":
    main()
