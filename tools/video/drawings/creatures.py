"""Models that are no fishes: mermaid, flower and lobster, with their heads up (papers/003, fig. 7)."""

import numpy as np

from tools.video.drawings.sheet import Sheet
from tools.video.retarget.target import Texture


def mermaid() -> Texture:
    """Return a mermaid: arms for fins, a fluke for a tail."""
    sheet = Sheet()
    skin, hair, green, teal = (244, 200, 168), (166, 62, 38), (46, 172, 138), (22, 118, 116)
    sheet.shape(
        [
            (0, 640),
            (50, 664),
            (130, 668),
            (168, 716),
            (92, 738),
            (30, 728),
            (0, 706),
            (-30, 728),
            (-92, 738),
            (-168, 716),
            (-130, 668),
            (-50, 664),
        ],
        teal,
        volume=0.3,
    )
    for x in (-130, -96, -60, 60, 96, 130):
        sheet.line([(0.1 * x, 670), (0.6 * x, 692), (x, 716)], (120, 214, 196), 2.4)
    sheet.pair(
        [
            (62, 200),
            (112, 226),
            (168, 286),
            (214, 356),
            (204, 374),
            (188, 368),
            (140, 314),
            (92, 272),
            (58, 254),
        ],
        skin,
        volume=0.25,
    )
    sheet.shape(
        [
            (0, 24),
            (52, 38),
            (76, 90),
            (82, 150),
            (76, 206),
            (40, 226),
            (-40, 226),
            (-76, 206),
            (-82, 150),
            (-76, 90),
            (-52, 38),
        ],
        hair,
        volume=0.35,
    )
    sheet.shape(
        [
            (-66, 194),
            (0, 178),
            (66, 194),
            (72, 240),
            (58, 310),
            (66, 380),
            (-66, 380),
            (-58, 310),
            (-72, 240),
        ],
        skin,
        volume=0.3,
    )
    sheet.shape(
        [
            (-70, 366),
            (0, 352),
            (70, 366),
            (76, 420),
            (62, 510),
            (36, 600),
            (18, 672),
            (-18, 672),
            (-36, 600),
            (-62, 510),
            (-76, 420),
        ],
        green,
        volume=0.4,
    )
    for row, y in enumerate(range(384, 660, 20)):
        for x in range(-84 + 12 * (row % 2), 85, 24):
            sheet.line([(x - 12, y), (x, y + 13), (x + 12, y)], teal, 1.8)
    sheet.pair([(34, 236), (58, 246), (56, 276), (32, 284), (12, 266)], (150, 96, 200), volume=0.3)
    sheet.shape(
        [(0, 56), (40, 74), (48, 122), (28, 166), (0, 178), (-28, 166), (-48, 122), (-40, 74)],
        skin,
        volume=0.15,
    )
    sheet.shape([(-52, 112), (-44, 62), (0, 40), (44, 62), (52, 112), (20, 78), (-24, 82)], hair)
    for side in (-1, 1):
        sheet.disc(side * 20, 120, 6, (44, 60, 78))
    sheet.line([(-14, 148), (0, 154), (14, 148)], (188, 60, 70), 3.5)
    return sheet.finished()


def flower() -> Texture:
    """Return a flower: its blossom is the head, two leaves the fins, the stem the rest."""
    sheet = Sheet()
    stem, leaf, petal = (70, 150, 62), (92, 178, 74), (240, 96, 136)
    sheet.shape(
        [
            (-16, 150),
            (16, 150),
            (17, 400),
            (15, 640),
            (20, 744),
            (-20, 744),
            (-15, 640),
            (-17, 400),
        ],
        stem,
        volume=0.3,
    )
    sheet.pair(
        [
            (10, 420),
            (60, 352),
            (140, 318),
            (206, 330),
            (176, 388),
            (110, 430),
            (44, 452),
            (12, 462),
        ],
        leaf,
        volume=0.3,
    )
    sheet.lines([(14, 444), (90, 392), (190, 338)], (54, 128, 52), 3)
    for turn in np.linspace(0.0, 2.0 * np.pi, 9)[:-1]:
        x, y = 62.0 * np.sin(turn), 116.0 - 62.0 * np.cos(turn)
        sheet.disc(x, y, 40, petal, volume=0.35)
    sheet.disc(0, 116, 46, (250, 196, 60), volume=0.4)
    for turn in np.linspace(0.0, 2.0 * np.pi, 13)[:-1]:
        sheet.disc(26 * np.sin(turn), 116 - 26 * np.cos(turn), 5, (206, 130, 32))
    return sheet.finished()


def lobster() -> Texture:
    """Return a lobster from above: claws for fins, the fan for a tail."""
    sheet = Sheet()
    red, dark, pale = (214, 58, 40), (142, 26, 26), (240, 120, 84)
    sheet.pair([(14, 640), (44, 650), (84, 690), (92, 736), (52, 744), (16, 716)], red, volume=0.4)
    sheet.shape([(-20, 640), (20, 640), (26, 720), (0, 748), (-26, 720)], pale, volume=0.3)
    claw = [
        (52, 216), (92, 228), (120, 204), (132, 160), (124, 108), (144, 62), (168, 96), (176, 70), (206, 108),
        (208, 168), (188, 216), (150, 250), (110, 276), (58, 262),
    ]  # fmt: skip
    sheet.pair(claw, red, volume=0.4)
    sheet.lines([(150, 110), (160, 132), (172, 104)], dark, 3)
    sheet.shape(
        [
            (0, 70),
            (30, 92),
            (58, 150),
            (70, 230),
            (66, 310),
            (52, 356),
            (-52, 356),
            (-66, 310),
            (-70, 230),
            (-58, 150),
            (-30, 92),
        ],
        red,
        volume=0.4,
    )
    for number in range(6):
        y, half = 350 + 50 * number, 60 - 5.5 * number
        sheet.shape(
            [
                (-half, y),
                (0, y - 8),
                (half, y),
                (half - 2, y + 48),
                (0, y + 58),
                (-half + 2, y + 48),
            ],
            red if number % 2 else pale,
            volume=0.35,
        )
    sheet.lines([(52, 250), (30, 262), (0, 266)], dark, 3)
    sheet.line([(0, 110), (0, 220), (0, 330)], dark, 2.5)
    for side in (-1, 1):
        sheet.disc(side * 26, 116, 9, (24, 20, 24))
    return sheet.finished()
