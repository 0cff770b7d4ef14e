"""Meshes and polylines in the files that everything reads: OBJ, PLY (binary) and STL (binary, triangles)."""

import numpy as np

__all__ = ["obj", "ply", "stl"]


def obj(meshes, lines=()):
    """The bytes of an OBJ file.

    `meshes` are of (positions, normals, starts, vertices): positions (n, 3), one normal for each corner or None, where the
    corners of each face start and their end, (faces + 1,), and the vertex of each corner. `lines` are of (positions, is_closed).
    """
    parts, before, normals_before = [], 1, 1
    for positions, normals, starts, vertices in meshes:
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
    """The bytes of a binary PLY file: faces, and edges of the lines; arguments as of obj()."""
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
    """The bytes of a binary STL file, faces as fans of triangles; `meshes` as of obj()."""
    none = np.empty((0, 3, 3), np.float32)
    triangles = np.concatenate([none] + [_triangles(np.asarray(mesh[0], np.float32), mesh[2], mesh[3]) for mesh in meshes])
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    records = np.zeros(len(triangles), np.dtype([("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("rest", "<u2")]))
    records["normal"] = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    records["points"] = triangles
    return b"splinecore".ljust(80) + np.uint32(len(records)).astype("<u4").tobytes() + records.tobytes()


def _triangles(positions, starts, vertices):
    counts = np.diff(starts)
    found = []
    for step in range(int(counts.max(initial=2)) - 2):
        at = starts[:-1][counts > step + 2]
        found.append(vertices[np.stack([at, at + step + 1, at + step + 2], axis=1)])
    return positions[np.concatenate(found)] if found else np.empty((0, 3, 3), np.float32)
