"""python -m splinecore: what is printed and written, exit codes, and files that are wrong."""

import os
import subprocess
import sys
from collections import Counter

import numpy as np
import pytest

import splinecore as sc
from shapes import circle, closed_cubic, hermite_chain, sphere_octant, torus, wavy_patch
from splinecore import command


def call(capsys, *arguments):
    """The exit code, the output and the error output."""
    code = command.main([str(argument) for argument in arguments])
    said = capsys.readouterr()
    return code, said.out, said.err


@pytest.fixture
def file(tmp_path):
    """Writes values into a JSON file."""
    def write(name, *values):
        path = tmp_path / name
        path.write_text(sc.dumps(list(values) if len(values) != 1 else values[0]))
        return path
    return write


def test_the_module_runs_as_a_program(file):
    path = file("a.json", circle())
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run([sys.executable, "-m", "splinecore", "info", path], capture_output=True, text=True, env=environment)
    assert (done.returncode, done.stderr) == (0, "")
    assert "0: NurbsCurve: degree 2" in done.stdout and "length 6.28318531" in done.stdout
    for wrong in ([], ["info"], ["melt", path], ["compare", path]):
        assert subprocess.run([sys.executable, "-m", "splinecore", *wrong], capture_output=True, env=environment).returncode == 2


def test_info_tells_of_every_kind(capsys, file):
    values = [circle(), closed_cubic(), hermite_chain(), sc.PowerCurve([[0, 0, 0], [1, 0, 0], [0, 2, 0]]), wavy_patch(),
              torus(), sc.PatchSet.from_patches([wavy_patch(), torus()])]
    code, out, err = call(capsys, "info", file("a.json", *values))
    lines = out.splitlines()
    assert (code, err, len(lines)) == (0, "", len(values) + 1)
    for value, line in zip(values, lines[1:]):
        assert type(value).__name__ in line and ("area" in line or "length" in line)
    assert "periodic" in lines[2] and "rational" in lines[6] and "2 patches" in lines[7]


def test_a_shape_at_infinity_is_told_of(capsys, file):
    line = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0, 0), (1, 0, 0)], [1, 0])
    code, out, _ = call(capsys, "info", file("a.json", line))
    assert code == 0 and "infinit" in out


def test_json_and_bpt_become_each_other(capsys, file, tmp_path):
    flat = sc.BezierPatch(np.arange(48.0).reshape(4, 4, 3) % 7)
    bpt, back = tmp_path / "a.bpt", tmp_path / "b.json"
    assert call(capsys, "convert", file("a.json", flat), bpt)[0] == 0
    assert call(capsys, "convert", bpt, back)[0] == 0
    made = sc.loads(back.read_text())
    assert isinstance(made, sc.PatchSet) and np.array_equal(made[0].points, flat.points)


def test_info_goes_on_after_a_file_that_is_wrong(capsys, file, tmp_path):
    damaged = tmp_path / "b.json"
    damaged.write_text("{")
    code, out, err = call(capsys, "info", file("a.json", circle()), damaged, tmp_path / "missing.json", file("c.json", torus()))
    assert code == 2 and "a.json: 1 shape" in out and "c.json: 1 shape" in out
    assert "b.json: JSON: the text is damaged at byte 2, line 1, column 2: it ends before the value does" in err and "missing.json" in err


def test_two_kinds_of_fineness_are_refused(capsys, file, tmp_path):
    code, _, err = call(capsys, "tessellate", file("a.json", torus()), tmp_path / "a.obj", "--resolution", 4, "--tolerance", 0.1)
    assert code == 2 and "one or the others" in err and not (tmp_path / "a.obj").exists()


@pytest.mark.parametrize("kind, types", [("nurbs", (sc.NurbsCurve, sc.NurbsPatch)), ("bezier", (sc.BezierCurve, sc.BezierPatch))])
def test_shapes_become_of_one_kind(capsys, file, tmp_path, kind, types):
    values = [circle(), closed_cubic(), hermite_chain(), wavy_patch(), sc.PatchSet.from_patches([torus()])]
    path, made = file("a.json", *values), tmp_path / "b.json"
    assert call(capsys, "convert", path, made, "--to", kind)[0] == 0
    found = sc.loads(made.read_text())
    assert all(isinstance(value, types) for value in found) and len(found) >= len(values)


def test_a_rational_patch_is_no_bpt(capsys, file, tmp_path):
    code, out, err = call(capsys, "convert", file("a.json", torus()), tmp_path / "a.bpt")
    assert (code, out) == (2, "") and "BPT holds no weights" in err
    code, _, err = call(capsys, "convert", file("b.json", circle()), tmp_path / "a.bpt")
    assert code == 2 and "no surface" in err
    assert not (tmp_path / "a.bpt").exists()


def obj_of(path):
    """Positions, faces and lines of an OBJ file."""
    words = [line.split() for line in path.read_text().splitlines()]
    positions = np.array([line[1:] for line in words if line[0] == "v"], float)
    faces = [[int(corner.split("/")[0]) - 1 for corner in line[1:]] for line in words if line[0] == "f"]
    lines = [[int(place) - 1 for place in line[1:]] for line in words if line[0] == "l"]
    normals = np.array([line[1:] for line in words if line[0] == "vn"], float)
    return positions, faces, lines, normals


@pytest.mark.parametrize("fineness", [["--resolution", 6], ["--tolerance", 0.01], ["--angle", 10], []])
def test_obj_is_the_mesh(capsys, file, tmp_path, fineness):
    path = tmp_path / "a.obj"
    code, out, _ = call(capsys, "tessellate", file("a.json", torus(), sphere_octant(), circle()), path, *fineness)
    positions, faces, lines, normals = obj_of(path)
    assert code == 0 and f"{len(positions)} vertices, {len(faces)} faces, 1 lines" in out
    assert len(normals) == sum(map(len, faces)) and np.allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-5)
    edges = Counter(frozenset(pair) for face in faces for pair in zip(face, face[1:] + face[:1]))
    ring = [count for edge, count in edges.items() if max(np.linalg.norm(positions[list(edge)], axis=1)) > 1.5]
    assert len(ring) > 50 and set(ring) == {2}, "the torus is closed"
    assert sorted({i for face in faces + lines for i in face}) == list(range(len(positions)))
    assert lines[0][0] == lines[0][-1]
    assert np.abs(np.linalg.norm(positions[lines[0]], axis=1) - 1).max() < 1e-6


def test_ply_holds_what_obj_holds(capsys, file, tmp_path):
    source = file("a.json", torus(), sphere_octant(), circle())
    for ending in ("obj", "ply"):
        assert call(capsys, "tessellate", source, tmp_path / f"a.{ending}", "--tolerance", 0.05)[0] == 0
    positions, faces, lines, _ = obj_of(tmp_path / "a.obj")
    header, data = (tmp_path / "a.ply").read_bytes().split(b"end_header\n", 1)
    assert f"element vertex {len(positions)}" in header.decode() and f"element face {len(faces)}" in header.decode()
    found = np.frombuffer(data, "<f4", 3 * len(positions)).reshape(-1, 3)
    assert np.allclose(found, positions, rtol=1e-6, atol=1e-9)
    at = found.nbytes
    for face in faces:
        assert data[at] == len(face) and np.frombuffer(data, "<i4", len(face), at + 1).tolist() == face
        at += 1 + 4 * len(face)
    edges = np.frombuffer(data, "<i4", offset=at).reshape(-1, 2)
    assert edges.tolist() == [list(pair) for pair in zip(lines[0][:-1], lines[0][1:])]


def test_stl_is_closed_and_has_the_volume(capsys, file, tmp_path):
    path = tmp_path / "a.stl"
    assert call(capsys, "tessellate", file("a.json", torus()), path, "--tolerance", 0.001)[0] == 0
    data = path.read_bytes()
    count = int.from_bytes(data[80:84], "little")
    records = np.frombuffer(data, np.dtype([("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("rest", "<u2")]), offset=84)
    points = records["points"].astype(float)
    volume = abs(np.einsum("ij,ij->i", points[:, 0], np.cross(points[:, 1], points[:, 2])).sum()) / 6
    assert count == len(records) > 100 and abs(volume / (2 * np.pi**2 * 3) - 1) < 0.002
    code, _, err = call(capsys, "tessellate", file("b.json", circle()), path)
    assert code == 2 and "curves" in err and path.read_bytes() == data


@pytest.mark.parametrize("ending", ["obj", "ply", "stl"])
def test_a_file_of_nothing_becomes_a_mesh_of_nothing(capsys, tmp_path, ending):
    path = tmp_path / "a.json"
    path.write_text(sc.dumps([]))
    code, out, err = call(capsys, "tessellate", path, tmp_path / f"a.{ending}")
    assert (code, err) == (0, "") and "0 vertices, 0 faces, 0 lines" in out


@pytest.mark.parametrize("value", [hermite_chain(), sc.PowerCurve([[0, 0, 0], [1, 0, 0], [0, 2, 0]]), wavy_patch(), torus(),
                                   circle()], ids=lambda value: type(value).__name__)
def test_bezier_pieces_are_those_of_the_shape(value):
    made = command.converted(value, "bezier")
    assert all(isinstance(part, (sc.BezierCurve, sc.BezierPatch)) for part in made)
    assert [again for part in made for again in command.converted(part, "bezier")] == made


def test_compare_tells_what_differs(capsys, file):
    a = file("a.json", circle(), torus())
    assert call(capsys, "compare", a, file("b.json", circle(), torus()))[:2] == (0, "the same\n")
    moved = circle().with_points(circle().points + (0, 0, 1e-3))
    other = file("c.json", moved, torus())
    code, out, _ = call(capsys, "compare", a, other)
    assert code == 1 and "0: up to 0.001 apart" in out and out.endswith("different\n")
    assert call(capsys, "compare", a, other, "--tolerance", 0.0011)[0] == 0
    one = file("d.json", circle())
    assert call(capsys, "compare", one, a)[:2] == (1, f"{one} holds 1 shape, {a} 2\n")
    assert "NurbsCurve and a NurbsPatch" in call(capsys, "compare", a, file("e.json", torus(), torus()))[1]


def test_info_tells_what_is_closed_and_its_volume(capsys, file):
    ball = sc.build.sphere((0, 0, 0), 1.0)
    half = ball.split("v", 1.0)[0]
    lines = call(capsys, "info", file("a.json", circle(), circle().part(0.0, 0.5), ball, half))[1].splitlines()[1:]
    assert lines[0].endswith("; closed") and lines[1].endswith("; open") and lines[3].endswith("; open")
    assert lines[2].endswith("; closed; volume 4.18879")


def test_compare_finds_one_geometry_in_other_pieces(capsys, file):
    ball = sc.build.sphere((0, 0, 0), 1.0)
    pieces = [patch for row in ball.to_bezier() for patch in row]
    whole, cut = file("a.json", ball), file("b.json", *reversed(pieces))
    assert call(capsys, "compare", whole, cut)[0] == 1
    code, out, _ = call(capsys, "compare", whole, cut, "--geometry", "--tolerance", 1e-12)
    assert code == 0 and out.startswith("surfaces: up to") and out.endswith("the same\n")
    part = file("c.json", *pieces[:-1])
    for pair in ((whole, part), (part, whole)):
        assert call(capsys, "compare", *pair, "--geometry", "--tolerance", 0.1)[0] == 1
    code, out, _ = call(capsys, "compare", whole, file("d.json", ball, circle()), "--geometry")
    assert code == 1 and "d.json alone holds curves" in out


def test_help_says_what_every_argument_is(capsys):
    for verb in ("info", "convert", "tessellate", "compare"):
        with pytest.raises(SystemExit):
            command.main([verb, "--help"])
        lines = capsys.readouterr().out.split("positional arguments:")[1].split("options:")[0].splitlines()
        assert all(len(line.split()) > 3 for line in lines if line.strip()), verb


def test_one_shape_in_two_forms_is_the_same(capsys, file):
    finer = circle().refine([0.1, 0.3])
    assert call(capsys, "compare", file("a.json", circle()), file("b.json", finer), "--tolerance", 1e-14)[0] == 0


def test_progress_is_on_the_error_output_where_it_is_wanted(capsys, file):
    path = file("a.json", *[circle()] * 3)
    assert call(capsys, "compare", path, path, "--progress")[1:] == ("the same\n", "\r1 of 3\r2 of 3\r3 of 3\n")
    assert call(capsys, "compare", path, path)[2] == ""


@pytest.mark.parametrize("content, words", [("", "a.json"), ("{", "a.json"), ("[1, 2]", "a.json"), ("\udcff", "not a text file")])
def test_a_damaged_file_is_told_of(capsys, tmp_path, content, words):
    path = tmp_path / "a.json"
    path.write_bytes(content.encode(errors="surrogateescape"))
    code, out, err = call(capsys, "info", path)
    assert (code, out) == (2, "") and err.startswith("splinecore: ") and words in err and err.count("\n") == 1


def test_regions_are_told_of_and_written_by_their_outlines(capsys, file, tmp_path):
    ring = sc.Region.of([sc.conics.circle((0, 0, 0), 2.0), sc.conics.circle((0, 0, 0), 1.0)])
    path, disk = file("ring.json", ring), file("disk.json", sc.Region.of([sc.conics.circle((0, 0, 0), 2.0)]))
    assert "Region: 2 outlines; area 9.42477796" in call(capsys, "info", path)[1]
    assert call(capsys, "compare", path, path)[0] == 0 and "2 and 1 outlines" in call(capsys, "compare", path, disk)[1]
    assert call(capsys, "convert", path, tmp_path / "a.json", "--to", "nurbs")[0] == 0
    assert len(sc.loads((tmp_path / "a.json").read_text())) == 2
    assert "2 lines" in call(capsys, "tessellate", path, tmp_path / "a.obj")[1]


def test_wrong_places_and_endings_are_told_of(capsys, file, tmp_path):
    path = file("a.json", torus())
    for arguments, words in (
            (["info", tmp_path / "none.json"], "cannot be read"), (["info", tmp_path], "cannot be read"),
            (["tessellate", path, tmp_path / "none/a.obj"], "cannot be written"),
            (["tessellate", path, tmp_path / "a.step"], ".obj, .ply, .stl, .glb can be written"),
            (["convert", path, tmp_path / "a.iges"], "a.iges: .json, .bpt can be written\n"),
            (["convert", path, tmp_path / "a.stl"], ".json, .bpt can be written; tessellate writes .stl"),
            (["tessellate", path, tmp_path / "b.json"], "can be written; convert writes .json"),
            (["tessellate", path, tmp_path / "a.obj", "--resolution", 0], "resolution"),
            (["tessellate", path, tmp_path / "a.obj", "--tolerance", "nan"], "tolerance")):
        code, out, err = call(capsys, *arguments)
        assert (code, out) == (2, "") and words in err, err
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.json"]


def test_an_interruption_has_a_code_of_its_own(capsys, file, monkeypatch):
    def interrupted(value):
        raise KeyboardInterrupt
    monkeypatch.setattr(command, "describe", interrupted)
    assert call(capsys, "info", file("a.json", circle()))[0] == 130
