"""BPT and JSON, in and out."""

import bpy
import numpy as np
import pytest

from support import part, scene_state, splinecore as sc

SADDLE = np.array([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]], float)
NEXT = np.array([[(1, 0, 1), (1, 1, 0)], [(2, 0, 0), (2, 1, 1)]], float)


def write_bpt(path, *patches):
    lines = [str(len(patches))]
    for patch in patches:
        lines.append(f"{patch.shape[0] - 1} {patch.shape[1] - 1}")
        lines += [' '.join(map(repr, point)) for point in patch.reshape(-1, 3).tolist()]
    path.write_text('\n'.join(lines))
    return str(path)


def test_bpt_comes_in_as_one_object_with_shared_points(tmp_path):
    path = write_bpt(tmp_path / "two.bpt", SADDLE, NEXT)
    assert bpy.ops.splinewright.import_bpt(filepath=path) == {'FINISHED'}
    value = bpy.context.object.data.splinewright.value
    assert len(value) == 2 and len(value.points) == 6
    assert np.array_equal(value[1].points, NEXT)
    assert value.edge_counts()['shared'] == 1
    assert bpy.context.object.name == "two"


def test_flip_turns_the_normals_over(tmp_path):
    path = write_bpt(tmp_path / "saddle.bpt", SADDLE)
    bpy.ops.splinewright.import_bpt(filepath=path)
    straight = bpy.context.object.data.polygons[0].normal.copy()
    bpy.ops.splinewright.import_bpt(filepath=path, flip=True)
    assert straight.dot(bpy.context.object.data.polygons[0].normal) < -0.9


def test_bpt_goes_out_and_comes_in_with_every_digit(tmp_path):
    bpy.ops.splinewright.add_teapot(size=1 / 3)
    value = bpy.context.object.data.splinewright.value
    path = str(tmp_path / "teapot.bpt")
    assert bpy.ops.splinewright.export_bpt(filepath=path) == {'FINISHED'}
    bpy.ops.splinewright.import_bpt(filepath=path)
    again = bpy.context.object.data.splinewright.value
    assert len(again) == 32 and all(np.array_equal(again[i].points, value[i].points) for i in range(32))
    assert again.edge_counts() == value.edge_counts()


def test_other_kinds_go_out_as_exact_bezier_patches(tmp_path):
    for name in ('add_hermite_patch', 'add_nurbs_patch'):
        getattr(bpy.ops.splinewright, name)()
        source = bpy.context.object.data.splinewright.value
        path = str(tmp_path / f"{name}.bpt")
        bpy.ops.splinewright.export_bpt(filepath=path)
        bpy.ops.splinewright.import_bpt(filepath=path)
        patches = bpy.context.object.data.splinewright.value
        expected = [bezier for row in source.to_bezier() for bezier in row]
        assert len(patches) == len(expected)
        assert all(np.array_equal(patches[i].points, expected[i].points) for i in range(len(patches)))


@pytest.mark.parametrize('name', ('add_bezier_curve', 'add_hermite_curve', 'add_nurbs_curve', 'add_bezier_patch',
                                  'add_hermite_patch', 'add_nurbs_patch', 'add_teapot'))
def test_json_goes_out_and_comes_in_equal_in_every_bit(name, tmp_path):
    getattr(bpy.ops.splinewright, name)(size=1 / 3)
    source = bpy.context.object
    path = str(tmp_path / "shape.json")
    assert bpy.ops.splinewright.export_json(filepath=path) == {'FINISHED'}
    assert bpy.ops.splinewright.import_json(filepath=path) == {'FINISHED'}
    ob = bpy.context.object
    assert ob is not source and ob.type == source.type
    assert ob.data.splinewright.value.dumps() == source.data.splinewright.value.dumps()


def test_a_list_of_curves_comes_in_as_one_object_and_patches_as_their_own(tmp_path):
    curve = sc.BezierCurve([(0, 0), (1, 1)])
    path = tmp_path / "list.json"
    path.write_text(sc.dumps([curve, curve.reversed(), sc.BezierPatch(SADDLE)]))
    bpy.ops.splinewright.import_json(filepath=str(path))
    kinds = sorted(ob.type for ob in bpy.data.objects)
    assert kinds == ['CURVE', 'MESH'] and len(bpy.context.selected_objects) == 2
    values = {ob.type: ob.data.splinewright.value for ob in bpy.data.objects}
    assert values['CURVE'] == [curve, curve.reversed()]


GOOD = "1\n1 1\n0 0 0\n0 1 1\n1 0 1\n1 1 0\n"
BAD_BPT = {
    'empty': ("", "the file ends where the count of patches"),
    'no number': ("teapot", "line 1: 'teapot' is not the count"),
    'no patches': ("0", "count of patches is 0"),
    'absurd count': ("99999999999", "count of patches is 99999999999"),
    'truncated': (GOOD[:-8], "ends inside patch 0"),
    'degree 0': (GOOD.replace("1 1\n", "0 1\n", 1), "degree 0 in u"),
    'absurd degree': (GOOD.replace("1 1\n", "9999999 9999999\n", 1), "degree 9999999"),
    'word for a number': (GOOD.replace("1 0 1", "1 zero 1"), "line 5: 'zero'"),
    'nan': (GOOD.replace("1 0 1", "1 nan 1"), "not finite"),
    'infinity': (GOOD.replace("1 0 1", "1 1e999 1"), "not finite"),
    'more than announced': (GOOD + "7", "1 words follow"),
}
BAD_JSON = {
    'empty': ("", "damaged"),
    'truncated': (sc.BezierCurve([(0, 0), (1, 1)]).dumps()[:-9], "damaged"),
    'another format': ('{"a": 1}', "not a splinecore file"),
    'no text': ("\x00", "damaged"),
    'newer': (sc.BezierCurve([(0, 0), (1, 1)]).dumps().replace('"version":1', '"version":99'), "newer"),
    'one point': ('{"format":"splinecore","version":1,"kind":"bezier_curve","points":[[0,0,0,1]]}', "needs 2"),
    'unknown kind': ('{"format":"splinecore","version":1,"kind":"cube"}', "cube"),
}


@pytest.mark.parametrize('text, said', BAD_BPT.values(), ids=BAD_BPT)
def test_a_bad_bpt_file_is_reported_and_the_scene_is_unchanged(text, said, tmp_path):
    refused(bpy.ops.splinewright.import_bpt, tmp_path / "bad.bpt", text, said)


@pytest.mark.parametrize('text, said', BAD_JSON.values(), ids=BAD_JSON)
def test_a_bad_json_file_is_reported_and_the_scene_is_unchanged(text, said, tmp_path):
    refused(bpy.ops.splinewright.import_json, tmp_path / "bad.spw.json", text, said)


@pytest.mark.parametrize('text', ('{"a": 1}', '[]', '', '{"asset": {"generator": "splinecore"}}', '{"format": "gltf"}', '"format"',
                                  '{"format": "splinecores"}', '\xff\xfe' * 99, ' ' * (1 << 20) + '{"format": "splinecore"}'))
def test_json_of_others_is_refused_by_what_it_holds(text, tmp_path):
    refused(bpy.ops.splinewright.import_json, tmp_path / "scene.json", text, "scene.json: it holds no curves or patches")


@pytest.mark.parametrize('name', ("a.json", "a.spw.json", "A.JSON", "a.SPW.JSON", "a"))
def test_json_of_ours_comes_in_under_any_name(name, tmp_path):
    (tmp_path / name).write_text('\ufeff {"version": 1, \n"format" : "splinecore", ' + sc.BezierCurve([(0, 0), (1, 1)]).dumps().partition('"version":1,')[2])
    assert bpy.ops.splinewright.import_json(filepath=str(tmp_path / name)) == {'FINISHED'}
    assert bpy.context.object.name in ("a", "A")


@pytest.mark.parametrize('typed, wanted', (
    ("a", "a.spw.json"), ("a.spw", "a.spw.json"), ("a.spw.json", "a.spw.json"), ("a.json", "a.json"), ("A.JSON", "A.JSON"),
    ("part 1.2", "part 1.2.spw.json"), ("a.bpt", "a.bpt.spw.json"), ("", "")))
def test_names_of_exported_files_get_our_ending_once(typed, wanted):
    class Browser:
        filepath, filename_ext = f"/folder/{typed}", ".spw.json"
    check = part('ui.operators.exchange').SPLINEWRIGHT_OT_export_json.check
    assert check(Browser, None) is (typed != wanted) and not check(Browser, None)
    assert Browser.filepath == f"/folder/{wanted}"


@pytest.mark.parametrize('kind', ('json', 'bpt'))
def test_export_warns_of_what_was_changed_by_hand_and_names_it(kind, tmp_path, capfd):
    bpy.ops.splinewright.add_bezier_patch()
    ob, path = bpy.context.object, str(tmp_path / f"a.{kind}")
    export = getattr(bpy.ops.splinewright, f"export_{kind}")
    export(filepath=path)
    assert "Warning" not in capfd.readouterr().out
    ob.name = "Bent"
    ob.data.vertices[0].co.z += 1.0
    value = ob.data.splinewright.value
    assert export(filepath=path) == {'FINISHED'}
    assert f"Warning: Exported a.{kind}; Bent: changes made by hand are not in the file" in capfd.readouterr().out
    getattr(bpy.ops.splinewright, f"import_{kind}")(filepath=path)
    again = bpy.context.object.data.splinewright.value
    assert np.array_equal(again.points if kind == 'json' else again[0].points, value.points)


def refused(operator, path, text, said):
    path.write_text(text)
    before = scene_state()
    with pytest.raises(RuntimeError, match=said):
        operator(filepath=str(path))
    assert scene_state() == before


def test_a_missing_a_binary_and_an_unwritable_file_are_reported(tmp_path):
    before = scene_state()
    with pytest.raises(RuntimeError, match="No such file"):
        bpy.ops.splinewright.import_bpt(filepath=str(tmp_path / "none.bpt"))
    (tmp_path / "binary.json").write_bytes(bytes(range(256)))
    with pytest.raises(RuntimeError, match="binary.json"):
        bpy.ops.splinewright.import_json(filepath=str(tmp_path / "binary.json"))
    assert scene_state() == before
    bpy.ops.splinewright.add_bezier_patch()
    with pytest.raises(RuntimeError, match="No such file"):
        bpy.ops.splinewright.export_bpt(filepath=str(tmp_path / "no" / "folder.bpt"))


def test_curves_and_rational_patches_do_not_fit_bpt(tmp_path):
    bpy.ops.splinewright.add_bezier_curve()
    with pytest.raises(RuntimeError, match="BPT holds patches"):
        bpy.ops.splinewright.export_bpt(filepath=str(tmp_path / "x.bpt"))
    bpy.ops.splinewright.add_bezier_patch(degree_u=1, degree_v=1)
    data = bpy.context.object.data
    data.splinewright.value = data.splinewright.value.with_weights([[1, 2], [1, 1]])
    with pytest.raises(RuntimeError, match="BPT holds no weights"):
        bpy.ops.splinewright.export_bpt(filepath=str(tmp_path / "x.bpt"))
    assert not (tmp_path / "x.bpt").exists()


def test_export_needs_a_shape():
    bpy.context.view_layer.objects.active = None
    assert not bpy.ops.splinewright.export_json.poll()
    assert not bpy.ops.splinewright.export_bpt.poll()


def three_shapes():
    """A curve, a patch beside the origin, a set of two patches; all selected."""
    bpy.ops.splinewright.add_line()
    curve = bpy.context.object
    bpy.ops.splinewright.add_bezier_patch(location=(5, 0, 0))
    patch = bpy.context.object
    bpy.ops.splinewright.add_bezier_patch(degree_u=2)
    bpy.ops.splinewright.split()
    for ob in (curve, patch):
        ob.select_set(True)
    bpy.context.view_layer.update()
    return curve, patch, bpy.context.object


def test_json_of_all_selected_comes_in_as_as_many_objects(tmp_path):
    made = three_shapes()
    values = [ob.data.splinewright.value for ob in made]
    path = str(tmp_path / "all.json")
    assert bpy.ops.splinewright.export_json(filepath=path) == {'FINISHED'}
    known = set(bpy.data.objects)
    bpy.ops.splinewright.import_json(filepath=path)
    again = [ob.data.splinewright.value for ob in set(bpy.data.objects) - known]
    assert len(again) == 3 and all(any(type(a) is type(b) and a == b for b in again) for a in values[1:])
    assert [values[0]] in again or values[0] in again


def test_bpt_of_all_selected_leaves_curves_out_with_a_word(tmp_path, capfd):
    three_shapes()
    path = str(tmp_path / "all.bpt")
    assert bpy.ops.splinewright.export_bpt(filepath=path) == {'FINISHED'}
    assert "Exported 2 objects" in (said := capfd.readouterr().out) and "Line: BPT holds patches" in said
    bpy.ops.splinewright.import_bpt(filepath=path)
    assert len(bpy.context.object.data.splinewright.value) == 3


@pytest.mark.parametrize('kind', ('json', 'bpt'))
def test_transforms_are_written_on_request(kind, tmp_path):
    _, patch, _ = three_shapes()
    for ob in bpy.data.objects:
        ob.select_set(ob == patch)
    points = patch.data.splinewright.value.points
    for wanted in (False, True):
        path = str(tmp_path / f"{wanted}.{kind}")
        getattr(bpy.ops.splinewright, f"export_{kind}")(filepath=path, transform=wanted)
        getattr(bpy.ops.splinewright, f"import_{kind}")(filepath=path)
        again = bpy.context.object.data.splinewright.value
        found = again.points if kind == 'json' or len(again.points) == len(points) else again[0].points
        assert np.array_equal(found.reshape(-1, 3), (points + ((5, 0, 0) if wanted else 0)).reshape(-1, 3))
        bpy.data.objects.remove(bpy.context.object)
        patch.select_set(True)
        bpy.context.view_layer.objects.active = patch


def test_what_a_format_cannot_hold_names_its_object(tmp_path):
    three_shapes()
    bpy.ops.splinewright.add_cylinder()
    for ob in bpy.data.objects:
        ob.select_set(True)
    path = tmp_path / "weights.bpt"
    with pytest.raises(RuntimeError, match="Cylinder: it is rational, and BPT holds no weights"):
        bpy.ops.splinewright.export_bpt(filepath=str(path))
    assert not path.exists() and not list(tmp_path.iterdir())
