"""Meshes and polylines in the files that everything reads: OBJ, PLY and STL (both binary), and glTF (GLB)."""

from pathlib import Path

import numpy as np

from ._splinecore import BezierPatch, HermitePatch, InvalidShape, NurbsPatch, PatchSet, Region, Tessellation, _mesh_file

__all__ = ["glb", "mesh", "obj", "ply", "save", "stl"]

_PATCHES = (NurbsPatch, BezierPatch, HermitePatch)
_ENDINGS = (".obj", ".ply", ".stl", ".glb")
_FACES, _PIECES = 8, 32


def mesh(surface, *, resolution=None, tolerance=None, angle=None):
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
    if resolution is not None and (tolerance is not None or angle is not None):
        raise InvalidShape("resolution counts faces, tolerance and angle measure them: give one or the others")
    patches = surface if isinstance(surface, PatchSet) else PatchSet.from_patches([surface])
    if tolerance is None and angle is None:
        made = Tessellation(patches, _FACES if resolution is None else resolution)
    else:
        made = Tessellation.adaptive(patches, tolerance=tolerance, angle=angle)
    positions, normals = made.evaluate(patches)
    return positions, normals, np.append(made.face_starts, np.int32(len(made.corner_vertices))), made.corner_vertices


def save(path, shapes, *, resolution=None, tolerance=None, angle=None):
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
    path = Path(path)
    ending = path.suffix.lower()
    if ending not in _ENDINGS:
        raise InvalidShape(f"{path.name}: {', '.join(_ENDINGS)} can be written")
    found, lines = [], []
    for shape in shapes if isinstance(shapes, (list, tuple)) else [shapes]:
        if isinstance(shape, (PatchSet, *_PATCHES)):
            found.append(mesh(shape, resolution=resolution, tolerance=tolerance, angle=angle))
        else:
            curves = shape.outlines if isinstance(shape, Region) else [shape]
            lines += [line for curve in curves for line in curve.polylines(_PIECES if resolution is None else resolution)]
    if ending == ".stl" and lines:
        raise InvalidShape("STL holds triangles alone, no curves")
    data = _mesh_file(ending, found, lines)
    part = path.with_name(path.name + ".part")
    try:
        part.write_bytes(data)
        part.replace(path)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from None
    finally:
        part.unlink(missing_ok=True)


def obj(meshes, lines=()):
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
    return _mesh_file(".obj", meshes, lines)


def ply(meshes, lines=()):
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
    return _mesh_file(".ply", meshes, lines)


def stl(meshes):
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
    return _mesh_file(".stl", meshes, ())


def glb(meshes, lines=()):
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
    return _mesh_file(".glb", meshes, lines)
