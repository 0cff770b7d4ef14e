from collections.abc import Sequence
from os import PathLike

import numpy as np
from numpy.typing import NDArray

from . import BezierCurve, BezierPatch, HermiteCurve, HermitePatch, NurbsCurve, NurbsPatch, PatchSet, PowerCurve

_Surface = NurbsPatch | BezierPatch | HermitePatch | PatchSet
_Shape = _Surface | NurbsCurve | BezierCurve | HermiteCurve | PowerCurve
_Mesh = tuple[NDArray[np.floating], NDArray[np.floating] | None, NDArray[np.int32], NDArray[np.int32]]
_Line = tuple[NDArray[np.floating], bool]

def mesh(surface: _Surface, *, resolution: int | None = None, tolerance: float | None = None,
         angle: float | None = None) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.int32], NDArray[np.int32]]: ...
def save(path: str | PathLike[str], shapes: _Shape | Sequence[_Shape], *, resolution: int | None = None,
         tolerance: float | None = None, angle: float | None = None) -> None: ...
def obj(meshes: Sequence[_Mesh], lines: Sequence[_Line] = ()) -> bytes: ...
def ply(meshes: Sequence[_Mesh], lines: Sequence[_Line] = ()) -> bytes: ...
def stl(meshes: Sequence[_Mesh]) -> bytes: ...
def glb(meshes: Sequence[_Mesh], lines: Sequence[_Line] = ()) -> bytes: ...
