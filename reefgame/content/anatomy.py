"""A checked species file turned into what the game works with (components/species.py)."""

from typing import Final

from components.body import Body, Fin, Swim
from components.fault import FaultError
from components.mind import Role
from components.repertoire import Repertoire
from components.senses import FISH_GRAMS
from components.singularity import SingularityKind
from components.species import Species, Stirs, Temper
from reefgame.content.schema.species import MedianFin, SpeciesFile
from reefgame.content.skins import skin_of

_MEALS_A_WEIGHT: Final = 400.0
_LIKING: Final = {"bright": 1, "dark": -1, "warm": 1, "cold": -1, None: 0}

UNTUNED: Final = "has no `swim` yet, find it with: reefgame capture --tune"
"""What is wrong with a species that no level can show; the file's name follows."""


class UntunedError(FaultError):
    """A species that is to swim has no `swim` yet."""


def _fin(fin: MedianFin | None) -> Fin | None:
    if fin is None:
        return None
    return Fin(fin.from_bl, fin.to_bl, fin.height_bl, fin.lean_bl, fin.profile)


def body_of(file: SpeciesFile) -> Body:
    """Return the body that the file describes, lengths in BL."""
    shape, fins = file.body, file.fins
    return Body(
        station=shape.at_bl,
        half_width=shape.half_width_bl,
        half_height=shape.half_height_bl,
        tail_span=fins.tail.half_span_bl,
        tail_fork=fins.tail.fork_bl,
        dorsal=_fin(fins.dorsal),
        anal=_fin(fins.anal),
        pectoral_at=fins.pectoral.at_bl,
        pectoral_length=fins.pectoral.length_bl,
        pectoral_height=fins.pectoral.height,
        stiffness=shape.stiffness,
        snout=shape.snout,
        tail_upper=fins.tail.upper,
        tail_lower=fins.tail.lower,
        tail_slender=fins.tail.slender,
        pectoral_held=fins.pectoral.held_out,
        pelvic_at=None if fins.pelvic is None else fins.pelvic.at_bl,
        pelvic_length=None if fins.pelvic is None else fins.pelvic.length_bl,
    )


def swim_of(file: SpeciesFile) -> Swim:
    """Return how the file's species swims. Raise UntunedError where the file does not say."""
    swim = file.swim
    if swim is None:
        raise UntunedError(f"the species '{file.title}' {UNTUNED} SPECIES.yaml")
    return Swim(
        float(swim.contraction_middle),
        float(swim.contraction_rear),
        float(swim.lag_deg),
        float(swim.frequency_hz),
    )


def temper_of(file: SpeciesFile) -> Temper:
    """Return how the file's species feels and decides; its diet names species in full."""
    mind = file.mind
    weight = FISH_GRAMS * (file.size_cm / 100.0) ** 3
    return Temper(
        diet=mind.diet,
        grazes=file.role != "predator" if mind.grazes is None else mind.grazes,
        meal=weight / _MEALS_A_WEIGHT if mind.meal_g is None else float(mind.meal_g),
        appetite=float(mind.appetite_meals),
        digestion=60.0 * mind.digests_min,
        breeding=60.0 * mind.breeds_min,
        wariness=float(mind.wariness_m),
        curiosity=float(mind.curiosity),
        bright=_LIKING[mind.likes.light],
        warm=_LIKING[mind.likes.water],
        at_home=mind.shelters == "anemones",
    )


def stirs_of(file: SpeciesFile) -> Stirs:
    """Return what the file's species is to anemones and weeds."""
    stirs = file.stirs
    kind = SingularityKind.SOURCE if stirs.kind == "source" else SingularityKind.HOLE
    reach = 0.0 if stirs.kind == "none" else float(stirs.reach_m)
    return Stirs(kind, float(stirs.speed_m_per_s), float(stirs.core_m), reach)


def species_of(name: str, file: SpeciesFile, repertoire: Repertoire) -> Species:
    """Return the species `name` as its file describes it, with its repertoire."""
    return Species(
        name=name,
        title=file.title,
        role=Role[file.role.upper()],
        schooling=file.school.joins,
        length=file.size_cm / 100.0,
        length_spread=file.size_spread_percent / 100.0,
        sight=float(file.sight_m),
        spacing=float(file.school.spacing_bl),
        depth=file.depth_m,
        body=body_of(file),
        swim=swim_of(file),
        skin=skin_of(file.skin),
        repertoire=repertoire,
        temper=temper_of(file),
        stirs=stirs_of(file),
    )
