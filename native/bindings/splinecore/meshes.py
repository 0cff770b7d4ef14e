"""Meshes and polylines in the files that everything reads: OBJ, PLY and STL (both binary), and glTF (GLB)."""

import json
from pathlib import Path

import numpy as np

from ._splinecore import BezierPatch, HermitePatch, InvalidShape, NurbsPatch, PatchSet, Tessellation

__all__ = ["glb", "mesh", "obj", "ply", "save", "stl"]

_PATCHES = (NurbsPatch, BezierPatch, HermitePatch)
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
    return positions, normals, _with_end(made.face_starts, made.corner_vertices), made.corner_vertices


def save(path, shapes, *, resolution=None, tolerance=None, angle=None):
    """Write the meshes of surfaces, and the polylines of curves, to a file.

    Parameters
    ----------
    path : path
        A file that ends with .obj, .ply, .stl or .glb; it is written whole or not at all.
    shapes : shape or sequence of shapes
        Curves, patches and sets. STL has no curves.
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
    """
    path = Path(path)
    ending = path.suffix.lower()
    if ending not in _WRITERS:
        raise InvalidShape(f"{path.name}: {', '.join(_WRITERS)} can be written")
    found, lines = [], []
    for shape in shapes if isinstance(shapes, (list, tuple)) else [shapes]:
        if isinstance(shape, (PatchSet, *_PATCHES)):
            found.append(mesh(shape, resolution=resolution, tolerance=tolerance, angle=angle))
        else:
            lines += shape.polylines(_PIECES if resolution is None else resolution)
    if ending == ".stl" and lines:
        raise InvalidShape("STL holds triangles alone, no curves")
    data = stl(found) if ending == ".stl" else _WRITERS[ending](found, lines)
    part = path.with_name(path.name + ".part")
    try:
        part.write_bytes(data)
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


def _with_end(starts, vertices):
    """Where corners of faces start, and their end, whether that was given or not."""
    starts = np.asarray(starts, np.int32)
    end = len(vertices)
    if len(starts) and starts[-1] == end:
        return starts
    if len(starts) and (starts[-1] > end or starts[0] != 0 or np.diff(starts).min(initial=3) < 3):
        raise InvalidShape(f"face starts are 0 and grow by at least 3 up to the {end} corners; these end with {starts[-1]}")
    return np.append(starts, np.int32(end))


def _whole(meshes):
    return [(positions, normals, _with_end(starts, vertices), vertices) for positions, normals, starts, vertices in meshes]


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
        If face starts do not fit the corners.

    Examples
    --------
    >>> mesh = sc.meshes.mesh(sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0)), resolution=1)
    >>> sc.meshes.obj([mesh]).decode().splitlines()[-1].split()[0]
    'f'
    """
    parts, before, normals_before = [], 1, 1
    for positions, normals, starts, vertices in _whole(meshes):
        parts += [f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in positions.tolist()]
        corners = [str(vertex) for vertex in (vertices + before).tolist()]
        if normals is not None:
            parts += [f"vn {x:.6g} {y:.6g} {z:.6g}\n" for x, y, z in normals.tolist()]
            corners = [f"{corner}//{normals_before + i}" for i, corner in enumerate(corners)]
            normals_before += len(normals)
        parts += [f"f {' '.join(corners[a:b])}\n" for a, b in zip(starts[:-1].tolist(), starts[1:].tolist())]
        before += len(positions)
    for positions, is_closed in lines:
        parts += [f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in positions.tolist()]
        places = [*range(before, before + len(positions)), *([before] if is_closed else [])]
        parts.append(f"l {' '.join(map(str, places))}\n")
        before += len(positions)
    return "".join(parts).encode()


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
        If face starts do not fit the corners.
    """
    meshes = _whole(meshes)
    positions = [mesh[0] for mesh in meshes] + [line[0] for line in lines]
    begins = np.cumsum([0, *[len(part) for part in positions]])
    faces = [_ply_faces(mesh[2], mesh[3] + begin) for mesh, begin in zip(meshes, begins)]
    edges = [_edges(len(line[0]), line[1]) + begin for line, begin in zip(lines, begins[len(meshes):])]
    edge_count = sum(len(part) for part in edges)
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {begins[-1]}",
              *[f"property float {axis}" for axis in "xyz"],
              f"element face {sum(len(mesh[2]) - 1 for mesh in meshes)}", "property list uchar int vertex_indices",
              *([f"element edge {edge_count}", "property int vertex1", "property int vertex2"] if edge_count else []),
              "end_header", ""]
    return b"".join(["\n".join(header).encode(), *[np.asarray(part, "<f4").tobytes() for part in positions], *faces,
                     *[part.astype("<i4").tobytes() for part in edges]])


def _ply_faces(starts, vertices):
    counts = np.diff(starts)
    data = np.empty(len(counts) + 4 * len(vertices), np.uint8)
    heads = np.arange(len(counts)) + 4 * starts[:-1]
    mask = np.ones(len(data), bool)
    mask[heads] = False
    data[heads] = counts
    data[mask] = vertices.astype("<i4").view(np.uint8)
    return data.tobytes()


def _edges(count, is_closed):
    places = np.arange(count)
    ends = np.roll(places, -1)
    return np.stack([places, ends], axis=1)[:None if is_closed else -1]


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
        If face starts do not fit the corners.
    """
    none = np.empty((0, 3, 3), np.float32)
    triangles = np.concatenate([none] + [_triangles(np.asarray(mesh[0], np.float32), mesh[2], mesh[3]) for mesh in _whole(meshes)])
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    records = np.zeros(len(triangles), np.dtype([("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("rest", "<u2")]))
    records["normal"] = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    records["points"] = triangles
    return b"splinecore".ljust(80) + np.uint32(len(records)).astype("<u4").tobytes() + records.tobytes()


def _triangles(positions, starts, vertices):
    return positions[_fans(starts, vertices)]


def _fans(starts, vertices):
    """(n, 3): vertices of triangles, each face as a fan about its first corner."""
    counts, found = np.diff(starts), [np.empty((0, 3), np.int32)]
    for step in range(int(counts.max(initial=2)) - 2):
        at = starts[:-1][counts > step + 2]
        found.append(np.asarray(vertices)[np.stack([at, at + step + 1, at + step + 2], axis=1)])
    return np.concatenate(found)


def glb(meshes, lines=()):
    """Write meshes and lines as a binary glTF 2.0 file.

    Faces are fans of triangles, with a vertex for each corner that has a normal.

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
        If face starts do not fit the corners.
    """
    writer = _Gltf()
    for positions, normals, starts, vertices in _whole(meshes):
        corners = np.arange(len(vertices), dtype=np.int32)
        fans = _fans(starts, corners if normals is not None else np.asarray(vertices))
        places = positions if normals is None else np.asarray(positions)[vertices]
        attributes = {"POSITION": writer.vectors(places), **({} if normals is None else {"NORMAL": writer.vectors(normals)})}
        writer.add(attributes, writer.indices(fans.ravel()), 4)
    for positions, is_closed in lines:
        writer.add({"POSITION": writer.vectors(positions)}, writer.indices(_edges(len(positions), is_closed).ravel()), 1)
    return writer.bytes()


class _Gltf:
    """Collects accessors, one for each array, on one buffer."""

    def __init__(self):
        self._data, self._views, self._accessors, self._primitives = bytearray(), [], [], []

    def vectors(self, rows):
        rows = np.asarray(rows, "<f4")
        ends = {"min": rows.min(axis=0).tolist(), "max": rows.max(axis=0).tolist()} if len(rows) else {}
        return self._accessor(rows, 5126, "VEC3", 34962, ends)

    def indices(self, numbers):
        return self._accessor(np.asarray(numbers, "<u4"), 5125, "SCALAR", 34963, {})

    def _accessor(self, rows, component, kind, target, more):
        self._views.append({"buffer": 0, "byteOffset": len(self._data), "byteLength": rows.nbytes, "target": target})
        self._accessors.append({"bufferView": len(self._views) - 1, "componentType": component, "count": len(rows), "type": kind, **more})
        self._data += rows.tobytes()
        return len(self._accessors) - 1

    def add(self, attributes, indices, mode):
        if self._accessors[indices]["count"]:
            self._primitives.append({"attributes": attributes, "indices": indices, "mode": mode})

    def bytes(self):
        top = {"asset": {"version": "2.0", "generator": "splinecore"}}
        if self._primitives:
            top |= {"scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "meshes": [{"primitives": self._primitives}],
                    "accessors": self._accessors, "bufferViews": self._views, "buffers": [{"byteLength": len(self._data)}]}
        text = json.dumps(top, separators=(",", ":")).encode()
        chunks = [(b"JSON", text + b" " * (-len(text) % 4))] + ([(b"BIN\0", bytes(self._data))] if self._primitives else [])
        body = b"".join(np.uint32(len(data)).astype("<u4").tobytes() + kind + data for kind, data in chunks)
        return b"glTF" + np.array([2, 12 + len(body)], "<u4").tobytes() + body


_WRITERS = {".obj": obj, ".ply": ply, ".stl": stl, ".glb": glb}
