"""Which target a name means: a picture, a mesh, or a model that ships with the game."""

from importlib.resources import files
from pathlib import Path
from typing import Final

import numpy as np

from components.arrays import Float64s
from tools.video.retarget.gltf import read_gltf
from tools.video.retarget.mesh import mesh_target
from tools.video.retarget.obj import read_obj
from tools.video.retarget.picture import picture_target
from tools.video.retarget.target import ModelError, Target

PICTURES: Final = (".png", ".jpg", ".jpeg", ".webp", ".bmp", ".tif", ".tiff")
MESHES: Final = (".glb", ".gltf", ".obj")
HEADS: Final = {"up": (0.0, -1.0), "down": (0.0, 1.0), "left": (-1.0, 0.0), "right": (1.0, 0.0)}
"""Where a head may point in a picture, x right and y down."""


def shipped() -> dict[str, Path]:
    """Return the models that ship with the game, by name."""
    folder = Path(str(files("assets"))) / "models"
    return {
        path.stem: path for path in sorted(folder.iterdir()) if path.suffix in (*PICTURES, *MESHES)
    }


def is_file(name: str) -> bool:
    """Return whether a name is meant as a picture's or a mesh's file, or is a shipped model."""
    return Path(name).suffix.lower() in (*PICTURES, *MESHES) or name in shipped()


def target_from(name: str, head: str | None = None, may_be_open: bool = False) -> Target:
    """Return the target in a picture's or mesh's file, or a shipped model by name.

    `head` is one of HEADS: where it points in a picture, or in a mesh seen from above with its z axis down. Raise
    ModelError, one line.
    """
    path = shipped().get(name, Path(name))
    if name in shipped() and head is None:
        # All of ours are drawn with their heads up; the whale swims towards +z.
        head = "down" if path.suffix == ".glb" else "up"
    towards = None if head is None else np.array(HEADS[head])
    if path.suffix.lower() in PICTURES:
        return picture_target(path, towards)
    try:
        mesh = read_obj(path) if path.suffix.lower() == ".obj" else read_gltf(path)
        return mesh_target(mesh, path.stem, _ahead(towards), may_be_open)
    except ModelError as error:
        text = str(error)
        raise ModelError(text if text.startswith(f"{path}:") else f"{path}: {text}") from None


def _ahead(towards: Float64s | None) -> Float64s | None:
    """Return a direction of a picture from above in the mesh's own axes, x right and z down."""
    return None if towards is None else np.array([towards[0], 0.0, towards[1]])
