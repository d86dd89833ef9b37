"""Burl: mesh atlases filled with procedural solid textures. Arrays that are returned cannot be written to; copy them to change them."""
import os
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

Doubles = npt.NDArray[np.float64]
Indices = npt.NDArray[np.uint32]
Path = Union[str, "os.PathLike[str]"]

class Error(RuntimeError):
    """What Burl cannot do, in one sentence. Wrong shapes of arrays are a ValueError, wrong types a TypeError."""

    kind: str
    """usage, io, invalid_file, runtime, unsupported or stopped."""
    def __init__(self, sentence: str, kind: str = ...) -> None: ...

class ProgressState(NamedTuple):
    """How far work is, as callbacks get it."""

    stage: str
    """The stage that runs; "done" at the end."""
    share: float
    """Of the work, 0 to 1, never less than before."""
    texels_per_second: Optional[float]
    """Of the stage; None where it counts no texels."""
    seconds_left: Optional[float]
    """An estimate; None where it is not known."""

Progress = Optional[Callable[[ProgressState], Optional[bool]]]
"""Is called when a stage begins and every 50 ms, and stops the work with False."""

class Mesh:
    """A triangle mesh, which does not change."""

    def __init__(self, positions: npt.ArrayLike, triangles: npt.ArrayLike, uvs: Optional[npt.ArrayLike] = None, name: str = "mesh") -> None:
        """Shapes (points, 3) in mesh units, (triangles, 3) and (triangles, 3, 2), v = 0 at an image's row 0. Copied."""
    @staticmethod
    def read(path: Path, *, weld: float = 0.0, up: str = "y", scale: float = 1.0, uv_set: int = 0, progress: Progress = None) -> Mesh:
        """Reads .obj, .ply, .stl, .off, .gltf or .glb, or a sample, such as "sample:teapot"."""
    @property
    def name(self) -> str: ...
    @property
    def positions(self) -> Doubles:
        """Shape (points, 3), in mesh units."""
    @property
    def triangles(self) -> Indices:
        """Shape (triangles, 3)."""
    @property
    def uvs(self) -> Optional[Doubles]:
        """The mesh's own texture coordinates, shape (triangles, 3, 2), or None."""
    @property
    def notes(self) -> List[str]:
        """What reading repaired or left out."""

class Recipe:
    """A recipe, which does not change."""

    @staticmethod
    def load(path_or_preset: Path) -> Recipe: ...
    @staticmethod
    def parse(json: str, origin: str = "recipe") -> Recipe: ...
    @staticmethod
    def names() -> List[str]: ...
    @property
    def name(self) -> str: ...
    @property
    def notes(self) -> List[str]: ...
    def to_json(self) -> str: ...
    def set(self, path: str, value: Union[str, float]) -> Recipe:
        """The recipe with the value at a dotted path, or of a control, changed."""
    def at(self, seconds: float) -> Recipe:
        """The recipe at a time, without keys."""

class Baked:
    """The result of a bake. Its arrays keep it alive."""

    @property
    def positions(self) -> Doubles:
        """Points of the mesh that the atlas places, shape (points, 3), in mesh units."""
    @property
    def triangles(self) -> Indices:
        """Shape (triangles, 3)."""
    @property
    def uvs(self) -> Doubles:
        """Texture coordinates per corner, shape (triangles, 3, 2), 0 to 1, v = 0 at row 0."""
    @property
    def names(self) -> List[str]:
        """Names of the images, "color" first."""
    @property
    def factors(self) -> Dict[str, float]:
        """The material's numbers, 1 for channels that have an image."""
    @property
    def notes(self) -> List[str]: ...
    def level_count(self, name: str) -> int: ...
    def image(self, name: str, level: int = 0) -> npt.NDArray[Any]:
        """Shape (rows, columns) or (rows, columns, components); uint8, uint16 or float32."""
    def __getitem__(self, name: str) -> npt.NDArray[Any]: ...
    def is_srgb(self, name: str) -> bool:
        """Whether red, green and blue are sRGB codes; otherwise numbers are linear."""
    def write(self, path: Path) -> List[str]:
        """Writes the mesh, or its images; returns sentences on what is not kept.

        A glTF's rig, nodes and other materials are not: `burl bake` keeps them. A file that the
        mesh or the recipe was read from is not replaced."""

class Evaluated(NamedTuple):
    """A texture at n points."""

    values: Doubles
    """Shape (n,); of a colour its luminance."""
    gradients: Doubles
    """Shape (n, 3)."""
    colors: Doubles
    """Shape (n, 3), linear light."""

def bake(
    mesh: Union[Mesh, Path],
    recipe: Union[Recipe, Path],
    *,
    size: int = 0,
    atlas: str = "",
    depth: int = 8,
    levels: int = 0,
    packing: str = "gltf",
    masks: Sequence[str] = (),
    normals: bool = True,
    crease: float = 40.0,
    threads: int = 0,
    progress: Progress = None,
) -> Baked:
    """Bakes a mesh."""

def evaluate(recipe: Union[Recipe, Path], points: npt.ArrayLike, *, channel: str = "", mesh: Union[Mesh, Path, None] = None, progress: Progress = None) -> Evaluated:
    """The texture, or a channel, at points of shape (n, 3) in solid space, in float64."""

def metrics(
    mesh: Union[Mesh, Path], recipe: Union[Recipe, Path], *, atlas: str = "", size: int = 0, own_uvs: bool = False, lookups: bool = False, progress: Progress = None
) -> Dict[str, Any]:
    """The figures of `burl metrics --json`."""

def version() -> str: ...
def simd() -> str: ...

__version__: str
