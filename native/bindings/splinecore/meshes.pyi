from collections.abc import Sequence
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import BezierCurve, BezierPatch, HermiteCurve, HermitePatch, NurbsCurve, NurbsPatch, PatchSet, PowerCurve

_Surface = NurbsPatch | BezierPatch | HermitePatch | PatchSet
_Shape = _Surface | NurbsCurve | BezierCurve | HermiteCurve | PowerCurve
_Mesh = tuple[NDArray[np.floating[Any]], NDArray[np.floating[Any]] | None, NDArray[np.int32], NDArray[np.int32]]
_Line = tuple[NDArray[np.floating[Any]], bool]

def mesh(surface: _Surface, *, resolution: int | None = None, tolerance: float | None = None,
         angle: float | None = None) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.int32], NDArray[np.int32]]:
    """Make the mesh of a patch or a set of patches.

    Parameters
    ----------
    surface : patch or PatchSet
        The surface.
    resolution : int, optional
        Faces in every span along u and v, 8 where nothing is given.
    tolerance : float, optional
        A length: no point of the surface lies farther from the mesh.
    angle : float, optional
        Radians: normals on one face are no farther apart. tolerance and angle exclude resolution.

    Returns
    -------
    tuple
        Positions (n, 3) float32, corner normals (c, 3) float32, face starts (f + 1,) int32 and vertices of corners (c,) int32.

    Raises
    ------
    InvalidShape
        If resolution is given beside tolerance or angle.

    Examples
    --------
    >>> positions, normals, starts, vertices = sc.meshes.mesh(sc.build.sphere((0, 0, 0), 1.0), resolution=4)
    >>> len(starts) - 1
    128
    """
def save(path: str | PathLike[str], shapes: _Shape | Sequence[_Shape], *, resolution: int | None = None,
         tolerance: float | None = None, angle: float | None = None) -> None:
    """Write the meshes of surfaces, and the polylines of curves, to a file.

    Parameters
    ----------
    path : path
        A file that ends with .obj, .ply, .stl or .glb; it is written whole or not at all.
    shapes : shape or sequence of shapes
        Curves, patches, sets, and regions, whose outlines are written. STL has no curves.
    resolution : int, optional
        Faces, or pieces of a curve, in every span: 8 and 32 where nothing is given.
    tolerance : float, optional
        A length: no point of a surface lies farther from the mesh.
    angle : float, optional
        Radians: normals on one face are no farther apart. tolerance and angle exclude resolution.

    Returns
    -------
    None
        The file is written.

    Raises
    ------
    InvalidShape
        If the ending is another one, a curve is to be written to STL, or resolution is given beside tolerance or angle.

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder) / "ball.stl"
    ...     sc.meshes.save(path, sc.build.sphere((0, 0, 0), 1.0), tolerance=0.01)
    ...     path.stat().st_size > 1000
    True
    """
def obj(meshes: Sequence[_Mesh], lines: Sequence[_Line] = ()) -> bytes:
    """Write meshes and lines as an OBJ file.

    Parameters
    ----------
    meshes : sequence of tuples
        (positions (n, 3), normals (c, 3) of corners or None, face starts, vertices (c,) of corners), as of `mesh`. Face starts
        are (faces,), or (faces + 1,) with their end.
    lines : sequence of tuples
        (positions (n, 3), whether the line is closed), as of `polylines`.

    Returns
    -------
    bytes
        The file.

    Raises
    ------
    InvalidShape
        If arrays do not fit each other, or a coordinate is not finite.

    Examples
    --------
    >>> mesh = sc.meshes.mesh(sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0)), resolution=1)
    >>> sc.meshes.obj([mesh]).decode().splitlines()[-1].split()[0]
    'f'
    """
def ply(meshes: Sequence[_Mesh], lines: Sequence[_Line] = ()) -> bytes:
    """Write meshes and lines as a binary PLY file: faces and edges.

    Parameters
    ----------
    meshes : sequence of tuples
        (positions (n, 3), normals (c, 3) of corners or None, face starts, vertices (c,) of corners), as of `mesh`. Face starts
        are (faces,), or (faces + 1,) with their end.
    lines : sequence of tuples
        (positions (n, 3), whether the line is closed), as of `polylines`.

    Returns
    -------
    bytes
        The file.

    Raises
    ------
    InvalidShape
        If arrays do not fit each other, or a coordinate is not finite.

    Examples
    --------
    >>> mesh = sc.meshes.mesh(sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0)), resolution=1)
    >>> sc.meshes.ply([mesh]).startswith(b"ply")
    True
    """
def stl(meshes: Sequence[_Mesh]) -> bytes:
    """Write meshes as a binary STL file: faces as fans of triangles.

    Parameters
    ----------
    meshes : sequence of tuples
        (positions (n, 3), normals (c, 3) of corners or None, face starts, vertices (c,) of corners), as of `mesh`. Face starts
        are (faces,), or (faces + 1,) with their end.

    Returns
    -------
    bytes
        The file.

    Raises
    ------
    InvalidShape
        If arrays do not fit each other, or a coordinate is not finite.

    Examples
    --------
    >>> mesh = sc.meshes.mesh(sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0)), resolution=1)
    >>> len(sc.meshes.stl([mesh])) == 84 + 2 * 50      # a head, and two triangles
    True
    """
def glb(meshes: Sequence[_Mesh], lines: Sequence[_Line] = ()) -> bytes:
    """Write meshes and lines as a binary glTF 2.0 file.

    Faces are fans of triangles, with a vertex for each corner where there are normals, which get their length of 1; where the
    surface has none it is that of the face.

    Parameters
    ----------
    meshes : sequence of tuples
        (positions (n, 3), normals (c, 3) of corners or None, face starts, vertices (c,) of corners), as of `mesh`. Face starts
        are (faces,), or (faces + 1,) with their end.
    lines : sequence of tuples
        (positions (n, 3), whether the line is closed), as of `polylines`.

    Returns
    -------
    bytes
        The file.

    Raises
    ------
    InvalidShape
        If arrays do not fit each other, or a coordinate is not finite.

    Examples
    --------
    >>> mesh = sc.meshes.mesh(sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0)), resolution=1)
    >>> sc.meshes.glb([mesh])[:4]
    b'glTF'
    """
