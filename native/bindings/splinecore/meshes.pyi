from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

_Mesh = tuple[NDArray[np.floating], NDArray[np.floating] | None, NDArray[np.int32], NDArray[np.int32]]
_Line = tuple[NDArray[np.floating], bool]

def obj(meshes: Sequence[_Mesh], lines: Sequence[_Line] = ()) -> bytes: ...
def ply(meshes: Sequence[_Mesh], lines: Sequence[_Line] = ()) -> bytes: ...
def stl(meshes: Sequence[_Mesh]) -> bytes: ...
