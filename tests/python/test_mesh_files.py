"""splinecore.meshes: from a shape to a file in one call, face starts with and without their end, glTF."""

import json

import numpy as np
import pytest

import splinecore as sc
from splinecore import build, meshes


def ball():
    return build.sphere((1.0, 2.0, 3.0), 2.0)


def volume_of(triangles):
    return np.einsum("ij,ij->i", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])).sum() / 6


def stl_triangles(data):
    records = np.frombuffer(data, np.dtype([("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("rest", "<u2")]), offset=84)
    assert len(records) == int.from_bytes(data[80:84], "little")
    return records["points"].astype(float)


def glb_parts(data):
    """The top object of a GLB file, and its accessors as arrays."""
    magic, version, length = data[:4], *np.frombuffer(data, "<u4", 2, 4)
    assert magic == b"glTF" and version == 2 and length == len(data)
    sizes, at, chunks = [], 12, []
    while at < len(data):
        size = int.from_bytes(data[at:at + 4], "little")
        chunks.append((data[at + 4:at + 8], data[at + 8:at + 8 + size]))
        sizes.append(size)
        at += 8 + size
    assert all(size % 4 == 0 for size in sizes) and chunks[0][0] == b"JSON"
    top = json.loads(chunks[0][1])
    arrays = []
    for accessor in top.get("accessors", ()):
        view = top["bufferViews"][accessor["bufferView"]]
        kind, columns = {5126: ("<f4", 3), 5125: ("<u4", 1)}[accessor["componentType"]]
        rows = np.frombuffer(chunks[1][1], kind, accessor["count"] * columns, view["byteOffset"]).reshape(-1, columns)
        if "min" in accessor:
            assert np.allclose(rows.min(0), accessor["min"]) and np.allclose(rows.max(0), accessor["max"])
        arrays.append(rows)
    return top, arrays


@pytest.mark.parametrize("how", ({"resolution": 40}, {"tolerance": 1e-3}, {"angle": 0.05}, {}))
def test_a_ball_has_its_volume_in_each_file(tmp_path, how):
    exact = 4 / 3 * np.pi * 8
    allowed = 0.2 if not how else 0.02
    meshes.save(tmp_path / "ball.stl", ball(), **how)
    assert volume_of(stl_triangles((tmp_path / "ball.stl").read_bytes()) - (1, 2, 3)) == pytest.approx(exact, rel=allowed)
    meshes.save(tmp_path / "ball.glb", [ball()], **how)
    top, arrays = glb_parts((tmp_path / "ball.glb").read_bytes())
    primitive, = top["meshes"][0]["primitives"]
    positions, normals, fans = (arrays[i] for i in (*primitive["attributes"].values(), primitive["indices"]))
    triangles = positions[fans.reshape(-1, 3)].astype(float) - (1, 2, 3)
    assert volume_of(triangles) == pytest.approx(exact, rel=allowed)
    assert np.einsum("ij,ij->i", normals, positions - (1, 2, 3)).min() > 1.9, "outwards, of length 1"


def test_starts_are_taken_with_and_without_their_end():
    patches = sc.PatchSet.from_patches([ball()])
    made = sc.Tessellation(patches, 3)
    positions, normals = made.evaluate(patches)
    corners = made.corner_vertices
    whole = np.append(made.face_starts, np.int32(len(corners)))
    for write in (meshes.obj, meshes.ply, meshes.stl, meshes.glb):
        assert write([(positions, normals, made.face_starts, corners)]) == write([(positions, normals, whole, corners)])
    assert len(stl_triangles(meshes.stl([(positions, None, made.face_starts, corners)]))) == len(corners) - 2 * len(made.face_starts)
    for wrong in (whole + 1, whole[::-1], np.array([0, 1], np.int32)):
        with pytest.raises(sc.InvalidShape, match="face starts"):
            meshes.obj([(positions, None, wrong, corners)])


def test_curves_are_lines_and_none_in_stl(tmp_path):
    curve = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 2), (2, 0)])
    meshes.save(tmp_path / "a.glb", [curve, ball()], resolution=5)
    top, arrays = glb_parts((tmp_path / "a.glb").read_bytes())
    lines = [one for one in top["meshes"][0]["primitives"] if one["mode"] == 1]
    assert len(lines) == 1 and len(arrays[lines[0]["indices"]]) == 10
    with pytest.raises(sc.InvalidShape, match="STL"):
        meshes.save(tmp_path / "a.stl", curve)
    with pytest.raises(sc.InvalidShape, match=r"a.step: .obj, .ply, .stl, .glb can be written"):
        meshes.save(tmp_path / "a.step", ball())
    with pytest.raises(sc.InvalidShape, match="one or the others"):
        meshes.save(tmp_path / "a.obj", ball(), resolution=3, tolerance=0.1)
    assert [path.name for path in tmp_path.iterdir()] == ["a.glb"]


def test_nothing_is_a_file_of_nothing(tmp_path):
    for ending in ("obj", "ply", "stl", "glb"):
        meshes.save(tmp_path / f"a.{ending}", [])
    assert glb_parts((tmp_path / "a.glb").read_bytes())[0] == {"asset": {"version": "2.0", "generator": "splinecore"}}


def test_arrays_that_do_not_fit_are_refused():
    corners = np.array([(0, 0, 0), (3, 0, 0), (0, 3, 0)], np.float32)
    good = (corners, None, [0, 3], [0, 1, 2])
    assert meshes.obj([good]) == b"v 0 0 0\nv 3 0 0\nv 0 3 0\nf 1 2 3\n"
    assert meshes.obj([(corners.astype(float), None, [0], np.array([0, 1, 2], np.uint8))]) == meshes.obj([good])
    for place, wrong, word in ((3, [0, 1, 3], "vertex 3 of corner 2"), (3, [0, 1, 2**40], "too large"), (3, [[0, 1, 2]], "expected"),
                               (0, corners[:, :2], "expected"), (0, np.where(corners == 3, np.nan, corners), "finite"),
                               (1, corners[:2], "2 normals for 3 corners"), (2, [0, 2], "face starts"), (2, [], "face starts")):
        mesh = [*good]
        mesh[place] = wrong
        for write in (meshes.obj, meshes.ply, meshes.stl, meshes.glb):
            with pytest.raises(sc.InvalidShape, match=word):
                write([tuple(mesh)])
    for wrong in (3, good, [good[:3]], [(*good[:3], [0.0, 1.0, 2.0])], [("abc", *good[1:])]):
        with pytest.raises((sc.InvalidShape, TypeError)):
            meshes.stl(wrong)
    with pytest.raises(sc.InvalidShape, match="two points"):
        meshes.glb([], [(corners[:1], False)])
