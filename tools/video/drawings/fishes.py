"""The carp, seen from above, and the cartoon fish, seen from the side, both with their heads up."""

from typing import Final

from tools.video.drawings.sheet import Points, Sheet
from tools.video.retarget.target import Texture

_BODY: Final[Points] = (
    (0, 40), (46, 62), (74, 110), (88, 180), (90, 260), (80, 350), (58, 440), (34, 520), (20, 580), (0, 620),
    (-20, 580), (-34, 520), (-58, 440), (-80, 350), (-90, 260), (-88, 180), (-74, 110), (-46, 62),
)  # fmt: skip


def carp() -> Texture:
    """Return a koi carp from above."""
    sheet = Sheet()
    fin, ray = (246, 226, 206), (222, 178, 146)
    sheet.shape(
        [
            (0, 560),
            (34, 590),
            (62, 660),
            (84, 740),
            (40, 728),
            (0, 700),
            (-40, 728),
            (-84, 740),
            (-62, 660),
            (-34, 590),
        ],
        fin,
    )
    for x in (-60, -36, -12, 12, 36, 60):
        sheet.line([(0.2 * x, 600), (0.6 * x, 660), (x, 730)], ray, 2)
    sheet.pair(
        [(76, 196), (130, 214), (196, 262), (232, 326), (190, 332), (136, 306), (82, 256)], fin
    )
    for reach in ((215, 318), (196, 328), (168, 320), (212, 290)):
        sheet.lines([(80, 226), (0.5 * (84 + reach[0]), 0.5 * (220 + reach[1]) - 4), reach], ray, 2)
    sheet.shape(_BODY, (250, 244, 234), volume=0.4)
    sheet.shape(
        [(-62, 150), (20, 140), (66, 176), (78, 240), (30, 284), (-40, 262), (-78, 210)],
        (238, 106, 40),
        inside=True,
    )
    sheet.shape(
        [(-76, 350), (-20, 334), (40, 360), (64, 420), (16, 470), (-40, 452)],
        (232, 92, 34),
        inside=True,
    )
    sheet.shape([(-22, 66), (24, 62), (36, 100), (0, 122), (-34, 104)], (238, 106, 40), inside=True)
    sheet.shape([(10, 508), (34, 520), (22, 566), (-6, 556)], (44, 40, 44), inside=True)
    sheet.line([(0, 240), (4, 330), (0, 420)], (214, 190, 172), 5)
    for y in range(190, 540, 26):
        for x in range(-72, 73, 24):
            sheet.line([(x - 10, y), (x, y + 8), (x + 10, y)], (214, 176, 150), 1.2)
    for side in (-1, 1):
        sheet.disc(side * 56, 102, 11, (252, 250, 244))
        sheet.disc(side * 58, 100, 7, (26, 24, 28))
    return sheet.finished()


def cartoon() -> Texture:
    """Return a cartoon fish from the side, its back to the left."""
    sheet = Sheet()
    blue, dark, pale = (46, 158, 224), (22, 92, 160), (252, 214, 92)
    sheet.shape(
        [
            (0, 560),
            (40, 600),
            (110, 640),
            (136, 730),
            (60, 716),
            (0, 680),
            (-60, 716),
            (-136, 730),
            (-110, 640),
            (-40, 600),
        ],
        pale,
        volume=0.2,
    )
    for x in (-96, -64, -32, 32, 64, 96):
        sheet.line([(0.25 * x, 600), (0.7 * x, 650), (x, 705)], (230, 164, 46), 3)
    sheet.shape(
        [(-96, 250), (-170, 270), (-226, 330), (-236, 410), (-180, 400), (-102, 390)],
        pale,
        volume=0.2,
    )
    sheet.shape(
        [(100, 330), (160, 356), (206, 420), (196, 474), (146, 452), (92, 420)], pale, volume=0.2
    )
    for y in (0, 34, 68):
        sheet.line([(-100, 280 + y), (-160, 296 + y), (-226, 350 + y)], (230, 164, 46), 3)
        sheet.line(
            [(96, 352 + 0.7 * y), (150, 386 + 0.7 * y), (196, 436 + 0.6 * y)], (230, 164, 46), 3
        )
    body = [
        (0, 30), (66, 62), (110, 140), (126, 240), (120, 350), (92, 460), (52, 550), (28, 610), (-28, 610),
        (-52, 550), (-92, 460), (-120, 350), (-126, 240), (-110, 140), (-66, 62),
    ]  # fmt: skip
    sheet.shape(body, blue, volume=0.35)
    sheet.shape(
        [(130, 170), (132, 300), (100, 470), (40, 600), (60, 440), (78, 300), (84, 180)],
        (196, 234, 250),
        inside=True,
    )
    for y, back in ((320, -108), (420, -92), (510, -62)):
        sheet.shape(
            [
                (back, y),
                (0.5 * back, y + 12),
                (0, y + 18),
                (60, y + 12),
                (62, y + 38),
                (0, y + 46),
                (0.5 * back, y + 40),
                (back, y + 26),
            ],
            dark,
            inside=True,
        )
    sheet.line([(-118, 216), (-40, 250), (40, 246), (110, 206)], dark, 5)
    sheet.disc(-14, 134, 44, (255, 255, 255))
    sheet.disc(-8, 124, 22, (20, 24, 40))
    sheet.disc(-16, 114, 8, (255, 255, 255))
    sheet.line([(38, 46), (66, 70), (60, 112)], (150, 40, 60), 6)
    return sheet.finished()
