"""Flora as its files say it, turned into what grows and what play judges by: SI units, linear colours."""

from collections.abc import Sequence

from components.flora import (
    Anemone,
    Colour,
    Coral,
    Flora,
    Form,
    Kelp,
    Limb,
    Look,
    LookKind,
    Seagrass,
)
from reefgame.content.schema import flora as said

_CM = 0.01
_NO_POLYPS = Limb(2, (0.01, 0.01), (0.001,), 1.0)


def flora_of(name: str, file: said.FloraFile) -> Flora:
    """Return the species of plant `name`."""
    form, looks = _form(file)
    return Flora(name, file.title, form, looks, file.room_cm * _CM, file.stands)


def _form(file: said.FloraFile) -> tuple[Form, dict[str, Look]]:
    match file.anemone or file.seagrass or file.kelp or file.sea_fan or file.soft_coral:
        case said.AnemoneForm() as anemone:
            return _anemone(anemone)
        case said.SeagrassForm() as grass:
            return _seagrass(grass), {"blade": _look("blade", grass.blade)}
        case said.KelpForm() as kelp:
            return _kelp(kelp)
        case said.SeaFanForm(branches=branches):
            return _coral(branches, None), {"branch": _look("branch", branches)}
        case said.SoftCoralForm(branches=branches, polyps=polyps):
            looks = {"branch": _look("branch", branches), "polyp": _look("tentacle", polyps)}
            return _coral(branches, polyps), looks
        case _:
            raise ValueError("a flora file without a form has passed the check")


def _anemone(form: said.AnemoneForm) -> tuple[Form, dict[str, Look]]:
    disc, tentacles = form.disc, form.tentacles
    looks = {
        "tentacle": _look("tentacle", tentacles),
        "foot": _look("foot", form.foot),
        "disc": _look("disc", disc),
    }
    anemone = Anemone(
        radius=disc.radius_cm * _CM,
        mouth=disc.mouth_cm * _CM,
        base=tentacles.base_cm * _CM,
        dome=disc.dome,
        foot=_limb(form.foot),
        tentacle=_limb(tentacles),
        splay=tentacles.splay_deg,
        stings=form.stings,
        holds=form.holds_cm * _CM,
    )
    return anemone, looks


def _seagrass(form: said.SeagrassForm) -> Seagrass:
    across = form.across_cm * _CM
    return Seagrass(form.blades, form.guides, across, _limb(form.blade), form.lean_deg)


def _kelp(form: said.KelpForm) -> tuple[Form, dict[str, Look]]:
    looks = {"stipe": _look("branch", form.stipe), "frond": _look("frond", form.fronds)}
    if form.bladder:
        looks["bladder"] = _look("branch", form.bladder)
    kelp = Kelp(
        stipes=form.stipes,
        across=form.across_cm * _CM,
        stipe=_limb(form.stipe),
        fronds=form.fronds.number,
        frond=_limb(form.fronds),
        rise=form.fronds.rise_deg,
        bladder=form.bladder.radius_cm * _CM if form.bladder else 0.0,
    )
    return kelp, looks


def _coral(branches: said.Branches, polyps: said.Polyps | None) -> Coral:
    return Coral(
        flat=polyps is None,
        stem=_limb(branches),
        branches=branches.number,
        orders=branches.orders,
        spread=branches.spread_deg,
        shrink=branches.shrink,
        polyps=polyps.number if polyps else 0,
        polyp=_limb(polyps) if polyps else _NO_POLYPS,
    )


def _limb(fibres: said.Fibres) -> Limb:
    low, high = fibres.length_cm
    return Limb(
        nodes=fibres.nodes,
        length=(low * _CM, high * _CM),
        radii=tuple(radius * _CM for radius in fibres.radius_cm),
        modulus=fibres.stiffness,
        exponent=fibres.exponent,
        curl=fibres.curl_deg,
        variety=fibres.variety,
    )


def _look(kind: LookKind, painted: said.Painted) -> Look:
    root, tip = painted.colours
    return Look(
        kind=kind,
        root=_linear(root),
        tip=_linear(tip),
        pattern_colour=_linear(painted.pattern_colour),
        pattern=painted.pattern,
        pattern_scale=painted.marks,
        translucency=painted.translucency,
    )


def _linear(text: str) -> Colour:
    """Return "#rrggbb" as linear light (IEC 61966-2-1)."""
    steps: Sequence[float] = [int(text[i : i + 2], 16) / 255.0 for i in (1, 3, 5)]
    red, green, blue = (
        float(c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4) for c in steps
    )
    return red, green, blue
