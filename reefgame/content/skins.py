"""A skin as a species file says it, turned into the layers that the view paints (components/skin.py)."""

from components import skin
from reefgame.content.schema import skins as said


def colour_of(text: str) -> skin.Colour:
    """Return "#rrggbb" as three numbers from 0 to 1."""
    red, green, blue = (int(text[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
    return red, green, blue


def _or_none(text: str | None) -> skin.Colour | None:
    return None if text is None else colour_of(text)


def _layer(layer: said.SkinLayer) -> skin.Layer:
    match layer:
        case said.GradientLayer():
            colours = tuple(colour_of(colour) for colour in layer.colours)
            return skin.Gradient(colours, layer.run == "nose_to_tail", layer.at)
        case said.StripesLayer():
            return _stripes(layer)
        case said.SpotsLayer():
            return skin.Spots(
                colour_of(layer.colour),
                layer.count,
                layer.size,
                layer.seed,
                layer.height,
                layer.reach,
                layer.in_row,
            )
        case said.PatchLayer():
            return skin.Patch(
                colour_of(layer.colour),
                layer.at,
                layer.size,
                layer.softness,
                layer.hollow,
                layer.tilt_deg,
            )
        case said.BandLayer():
            return skin.Band(
                colour_of(layer.colour),
                layer.points,
                layer.width,
                layer.softness,
                _or_none(layer.edge),
                layer.edge_width,
            )
        case said.HatchLayer():
            return _hatch(layer)
        case said.ScalesLayer():
            return skin.Scales(layer.size, layer.strength, _or_none(layer.rim))


def _stripes(layer: said.StripesLayer) -> skin.Stripes:
    return skin.Stripes(
        colour=colour_of(layer.colour),
        at=layer.at,
        width=layer.width,
        softness=layer.softness,
        along=layer.run == "lines",
        edge=_or_none(layer.edge),
        edge_width=layer.edge_width,
        bow=layer.bow,
        reach=layer.reach,
        wobble=layer.wobble,
    )


def _hatch(layer: said.HatchLayer) -> skin.Hatch:
    return skin.Hatch(
        colour=colour_of(layer.colour),
        spacing=layer.spacing,
        width=layer.width,
        tilt_deg=layer.tilt_deg,
        bow=layer.bow,
        softness=layer.softness,
        reach=layer.reach,
        height=layer.height,
        fade=layer.fade,
        wobble=layer.wobble,
    )


def _mark(mark: said.FinMark) -> skin.FinMark:
    colour = colour_of(mark.colour)
    if isinstance(mark, said.FinLinesMark):
        return skin.FinLines(mark.fin, colour, mark.at, mark.width, mark.softness)
    return skin.FinPatch(mark.fin, colour, mark.at, mark.size, mark.softness)


def skin_of(look: said.SkinLook) -> skin.Skin:
    """Return the skin that a species file describes."""
    eye = look.eye
    return skin.Skin(
        layers=tuple(_layer(layer) for layer in look.layers),
        eye=skin.Eye(eye.at, eye.radius, colour_of(eye.iris), eye.pupil),
        fin=colour_of(look.fins),
        tail=colour_of(look.tail),
        shine=look.shine,
        fin_edge=_or_none(look.fins_edge),
        tail_edge=_or_none(look.tail_edge),
        fin_opacity=look.fins_opacity,
        pectoral=_or_none(look.pectoral),
        gill_at=look.gill_at,
        gill_strength=look.gill_strength,
        gill_slits=look.gill_slits,
        mouth=None if look.mouth is None else skin.Mouth(look.mouth.front, look.mouth.corner),
        dorsal=_or_none(look.dorsal),
        anal=_or_none(look.anal),
        pelvic=_or_none(look.pelvic),
        fin_edge_width=look.fins_edge_width,
        fin_follow=look.fins_follow,
        fin_tip=_or_none(look.fins_tip),
        fin_rays=look.fins_rays,
        fin_marks=tuple(_mark(mark) for mark in look.fin_marks),
    )
