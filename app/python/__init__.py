"""Burl: mesh atlases filled with procedural solid textures. docs/guide/python.md is the guide."""
from typing import NamedTuple as _NamedTuple, Optional as _Optional

import numpy as _numpy


class Error(RuntimeError):
    """What Burl cannot do, in one sentence; `kind` is usage, io, invalid_file, runtime, unsupported or stopped."""

    def __init__(self, sentence, kind="runtime"):
        super().__init__(sentence)
        self.kind = kind


class Evaluated(_NamedTuple):
    """A texture at n points."""

    values: _numpy.ndarray
    gradients: _numpy.ndarray
    colors: _numpy.ndarray


class ProgressState(_NamedTuple):
    """How far work is, as callbacks get it."""

    stage: str
    share: float
    texels_per_second: _Optional[float]
    seconds_left: _Optional[float]


from ._burl import Baked, Mesh, Recipe, bake, evaluate, metrics, simd, version  # noqa: E402

__version__ = version()
__all__ = ["Baked", "Error", "Evaluated", "Mesh", "ProgressState", "Recipe", "bake", "evaluate", "metrics", "simd", "version"]
