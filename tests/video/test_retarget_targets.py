"""Targets from pictures, meshes and species (papers/003, sections 3.2 and 5)."""

from pathlib import Path

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from reefgame.content import load_species
from tools.video.drawings.fishes import carp as drawn_carp
from tools.video.drawings.whale import whale, whale_mesh
from tools.video.retarget.areas import signed_areas
from tools.video.retarget.choose import shipped, target_from
from tools.video.retarget.mesh import welded
from tools.video.retarget.picture import read_picture, target_of
from tools.video.retarget.species import species_target
from tools.video.retarget.target import ModelError, Target
from tools.video.retarget.triangulation import open_edges, triangulated

MODELS = ("carp", "cartoon", "flower", "lobster", "mermaid", "whale")


def carp() -> np.ndarray:
    """Return the carp that ships with the game, (h, w, 4)."""
    return read_picture(shipped()["carp"])


def on_ground(picture: np.ndarray, ground: int) -> np.ndarray:
    """Return a drawing laid on a plain opaque ground, red, green and blue."""
    share = picture[..., 3:] / 255.0
    return (picture[..., :3] * share + ground * (1.0 - share)).astype(np.uint8)


def smallest_angle(target: Target) -> float:
    p = target.vertices[target.triangles][:, :, :2]
    least = np.pi
    for i in range(3):
        u, v = p[:, (i + 1) % 3] - p[:, i], p[:, (i + 2) % 3] - p[:, i]
        cosine = (u * v).sum(axis=1) / np.sqrt((u**2).sum(axis=1) * (v**2).sum(axis=1))
        least = min(least, float(np.arccos(np.clip(cosine, -1, 1)).min()))
    return float(np.degrees(least))


@pytest.mark.parametrize("name", MODELS)
def test_the_six_models_have_an_axis_two_fins_and_the_papers_size(name: str) -> None:
    assert set(shipped()) == set(MODELS)
    target = target_from(name)
    assert 2300 < len(target.vertices) < 6100
    ends = target.controls[[4, -1]]
    assert np.abs(ends[:, 0]).max() < 0.04 * target.skeleton.body_length
    extent = np.ptp(target.vertices[:, 1])
    assert 0.9 < target.skeleton.body_length / extent < 1.1
    for side, fin in enumerate(target.fins):
        assert fin is not None
        assert (fin.tip[0] > 0.0) == (side == 1)
        assert fin.top[1] > fin.bottom[1]
        assert 20 < len(fin.vertices) < 0.3 * len(target.vertices)


def test_the_committed_models_are_what_the_code_draws() -> None:
    assert np.abs(carp().astype(int) - drawn_carp()).mean() < 0.5
    assert len(whale()) > 50_000
    target = target_from("whale")
    assert len(target.vertices) == len(whale_mesh()[0])


@pytest.mark.parametrize("ground", [255, 20])
def test_canny_finds_on_a_plain_ground_what_opacity_says(tmp_path: Path, ground: int) -> None:
    path = tmp_path / "carp.png"
    cv2.imwrite(str(path), cv2.cvtColor(on_ground(carp(), ground), cv2.COLOR_RGB2BGR))
    found, known = target_from(str(path), "up"), target_from("carp")
    assert np.abs(found.controls - known.controls).max() < 0.03 * known.skeleton.body_length
    assert all(fin is not None for fin in found.fins)


def test_the_heavier_half_is_the_head_and_a_hint_is_stronger(tmp_path: Path) -> None:
    path = tmp_path / "lying.png"
    lying = np.ascontiguousarray(np.rot90(carp()))
    cv2.imwrite(str(path), cv2.cvtColor(lying, cv2.COLOR_RGBA2BGRA))
    free, hinted, wrong = (target_from(str(path), head) for head in (None, "left", "right"))
    assert np.allclose(free.controls, hinted.controls)
    assert np.abs(free.controls - wrong.controls).max() > 0.05 * free.skeleton.body_length


def test_a_mesh_of_a_picture_has_no_hole_and_no_sliver() -> None:
    target = target_of(carp(), "carp", np.array([0.0, -1.0]))
    border = open_edges(target.triangles)
    _, uses = np.unique(border, return_counts=True)
    assert (uses == 2).all()
    assert (signed_areas(target.vertices[:, :2], target.triangles) != 0.0).all()
    assert smallest_angle(target) > 12.0


@settings(max_examples=15)
@given(st.lists(st.floats(20.0, 100.0), min_size=5, max_size=12))
def test_any_star_shaped_contour_is_meshed_whole(radii: list[float]) -> None:
    turn = np.linspace(0.0, 2.0 * np.pi, len(radii), endpoint=False)
    contour = np.stack((np.cos(turn), np.sin(turn)), axis=1) * np.array(radii)[:, None]
    points, triangles, border = triangulated(contour, 7.0)
    area = np.abs(signed_areas(points, triangles)).sum()
    edge = points[:border]
    shoelace = 0.5 * abs(
        np.sum(edge[:, 0] * np.roll(edge[:, 1], -1) - edge[:, 1] * np.roll(edge[:, 0], -1))
    )
    assert np.isclose(area, shoelace, rtol=1e-6)
    assert len(open_edges(triangles)) == border


def test_a_species_is_seen_from_above_with_its_pectoral_fins() -> None:
    shark = load_species("reef_shark")
    target = species_target(shark.name, shark.body, shark.skin)
    assert abs(target.skeleton.body_length - 1.0) < 0.01
    left, right = target.fins
    assert left is not None
    assert right is not None
    assert left.tip[0] < -0.1 < 0.1 < right.tip[0]
    assert np.ptp(target.vertices[:, 2]) > 0.2


def write_obj(path: Path, triangles: np.ndarray) -> None:
    points, _ = whale_mesh()
    lines = [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in points]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in triangles]
    path.write_text("\n".join(lines) + "\n")


def test_obj_and_gltf_of_one_mesh_are_one_target(tmp_path: Path) -> None:
    path = tmp_path / "whale.obj"
    write_obj(path, whale_mesh()[1])
    read, known = target_from(str(path), "down"), target_from("whale")
    corners = [target.vertices[target.triangles] for target in (read, known)]
    assert np.abs(corners[0] - corners[1]).max() < 1e-4


def test_faces_of_many_corners_negative_numbers_and_colours_are_read(tmp_path: Path) -> None:
    path = tmp_path / "box.obj"
    (tmp_path / "box.mtl").write_text("newmtl red\nKd 1 0 0\n")
    corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 4)]
    text = "mtllib box.mtl\nusemtl red\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in corners)
    faces = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
    text += "".join("f " + " ".join(str(n - 9) for n in face) + "\n" for face in faces)
    path.write_text(text)
    target = target_from(str(path))
    assert len(target.triangles) == 12
    u, v = np.round(target.uv[0]).astype(int)
    assert tuple(target.texture[v, u]) == (255, 0, 0, 255)
    assert len(open_edges(welded(target.vertices, target.triangles))) == 0


def told(name: str, head: str | None = None) -> str:
    with pytest.raises(ModelError) as error:
        target_from(name, head)
    (line,) = str(error.value).splitlines()
    assert line.startswith(name)
    return line


def test_a_mesh_with_holes_is_told_unless_it_is_allowed(tmp_path: Path) -> None:
    path = tmp_path / "torn.obj"
    write_obj(path, whale_mesh()[1][:-5])
    assert "open edges" in told(str(path))
    assert len(target_from(str(path), None, may_be_open=True).triangles) == len(whale_mesh()[1]) - 5


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("v 0 0\n", ":1: "),
        ("v 0 0 0\nf 1 2 3\n", ":2: "),
        ("v 0 0 0\nv 1 0 0\n\nf 1 2\n", ":4: "),
        ("v a b c\n", ":1: "),
        ("# nothing\n", "no faces"),
        ("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "line or a point"),
    ],
)
def test_a_faulty_obj_names_its_line(tmp_path: Path, content: str, says: str) -> None:
    path = tmp_path / "faulty.obj"
    path.write_text(content)
    assert says in told(str(path))


@pytest.mark.parametrize("cut", [0, 3, 11, 30, 400, 5000, 100_000])
def test_a_cut_glb_is_one_line(tmp_path: Path, cut: int) -> None:
    path = tmp_path / "cut.glb"
    path.write_bytes(whale()[:cut])
    assert told(str(path))


@pytest.mark.parametrize(
    "text",
    [
        "{}",
        "[]",
        '{"nodes": [{"children": [0]}]}',
        '{"extensionsRequired": ["KHR_draco_mesh_compression"]}',
        '{"buffers": [{"uri": "../../../etc/passwd", "byteLength": 1}]}',
        '{"nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {}}]}]}',
    ],
)
def test_a_faulty_gltf_is_one_line(tmp_path: Path, text: str) -> None:
    path = tmp_path / "faulty.gltf"
    path.write_text(text)
    assert told(str(path))


def test_pictures_that_show_no_outline_are_told(tmp_path: Path) -> None:
    rng = np.random.default_rng(1)
    pictures = {
        "plain.png": np.full((200, 300, 3), 90, np.uint8),
        "clear.png": np.zeros((200, 300, 4), np.uint8),
        "tiny.png": np.zeros((8, 8, 3), np.uint8),
        "speck.png": cv2.circle(
            np.full((400, 400, 3), 240, np.uint8), (200, 200), 6, (0, 0, 0), -1
        ),
    }
    for name, picture in pictures.items():
        cv2.imwrite(str(tmp_path / name), picture)
        assert told(str(tmp_path / name))
    (tmp_path / "noise.png").write_bytes(rng.bytes(500))
    assert "no picture" in told(str(tmp_path / "noise.png"))
    assert "cannot be read" in told(str(tmp_path / "absent.png"))


@pytest.mark.parametrize("kind", ["grey", "deep", "see-through grey"])
def test_grey_and_sixteen_bit_pictures_are_read(tmp_path: Path, kind: str) -> None:
    path = tmp_path / "fish.png"
    grey = cv2.cvtColor(on_ground(carp(), 20), cv2.COLOR_RGB2GRAY)
    picture = {
        "grey": grey,
        "deep": grey.astype(np.uint16) * 257,
        "see-through grey": carp()[..., [2, 1, 0, 3]],
    }[kind]
    cv2.imwrite(str(path), picture)
    assert len(target_from(str(path), "up").triangles) > 3000
