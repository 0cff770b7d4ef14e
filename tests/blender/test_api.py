"""splinewright.api: what scripts call, without any other import."""

import inspect
import math
import re
import runpy
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest

from support import ADDON, part, scene_state, splinecore as sc

PROJECT = Path(__file__).resolve().parents[2]
api = part('api')

#: Names that scripts use. New ones are added; none of these goes or changes what it takes.
KEPT = {
    'version': None, 'splinecore': None, 'Refusal': None,
    'is_shape': "object", 'value': "object", 'set_value': "object, value", 'new_shape': "name, value, collection",
    'is_changed_by_hand': "object", 'restore': "object", 'make_editable': "object", 'detach': "object",
    'Recipe': "name, label, description, inputs, takes_more, takes_axis_object, points, settings",
    'Setting': "name, label, description, default, least, most, choices, unit",
    'recipe_names': "", 'describe': "name", 'make': "name, inputs, settings, points, axis_object, collection",
    'loft': "curves, settings", 'revolve': "profile, axis_object, settings", 'extrude': "profile, direction, settings",
    'sweep': "rail, sections, settings", 'pipe': "curve, radius, settings", 'offset': "object, distance, settings",
    'recipe': "object", 'settings': "object", 'set_settings': "object, changes", 'points': "object",
    'set_points': "object, points", 'inputs': "object", 'set_inputs': "object, inputs, turned", 'axis_object': "object",
    'set_axis_object': "object, axis_object", 'followers': "object", 'problem': "object", 'update': ""}

LINE = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0, 0), (0, 0, 1)])


def curve(height=0.0, name="Curve", scale=1.0):
    points = [(0, 0, height), (1, 1 / 3, height), (2, 0, height), (3, 1, height)]
    return api.new_shape(name, sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 1, 1], np.array(points) * (scale, scale, 1.0)))


@pytest.mark.parametrize('name', KEPT)
def test_names_that_scripts_use_stay(name):
    assert name in api.__all__ and name in dir(api)
    found = getattr(api, name)
    if KEPT[name] is not None:
        taken = list(inspect.signature(found).parameters)
        assert taken[:len(KEPT[name].split(", "))] == [each for each in KEPT[name].split(", ") if each]


def test_every_name_is_documented():
    assert set(dir(api)) == set(api.__all__) == set(KEPT)
    for name in api.__all__:
        found = getattr(api, name)
        if callable(found):
            assert len(found.__doc__ or "") > 20, name


def test_the_manual_lists_every_name():
    text = (PROJECT / "addon/manual/python.md").read_text()
    for name in api.__all__:
        assert re.search(rf"`(api\.)?{name}\b", text), name


def test_a_value_comes_back_in_every_bit():
    value = sc.NurbsCurve(2, [0, 0, 0, 1 / 3, 1, 1, 1], [(0, 0, 0), (1 / 3, 1, 0), (2, 1, 0), (3, math.pi, 0)], [1, 0.1, 2, 1])
    ob = api.new_shape("Curve", value)
    assert api.is_shape(ob) and api.value(ob) == value and ob.name == "Curve"
    assert ob.name in bpy.context.scene.objects
    other = value.with_points(value.points + 1 / 7)
    api.set_value(ob, other)
    assert api.value(ob) == other and not api.is_changed_by_hand(ob)


def test_a_new_shape_goes_where_it_is_told_and_a_bad_one_leaves_nothing():
    home = bpy.data.collections.new("Home")
    bpy.context.scene.collection.children.link(home)
    assert api.new_shape("Patch", sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0)), home).name in home.objects
    before = scene_state()
    for bad in (7, [], "curve", [LINE, 7]):
        with pytest.raises((TypeError, ValueError)):
            api.new_shape("Bad", bad)
    assert scene_state() == before


def test_a_collection_of_another_file_takes_nothing(tmp_path):
    bpy.context.scene.collection.children.link(bpy.data.collections.new("Theirs"))
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "library.blend"))
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(str(tmp_path / "library.blend"), link=True) as (_, wanted):
        wanted.collections = ["Theirs"]
    profile, before = curve(), scene_state()
    for call in (lambda: api.new_shape("Line", LINE, wanted.collections[0]),
                 lambda: api.make('extrude', profile, collection=wanted.collections[0])):
        with pytest.raises(api.Refusal, match="Theirs is linked"):
            call()
        assert scene_state() == before
    with pytest.raises(TypeError, match="a collection"):
        api.new_shape("Line", LINE, "Theirs")


def test_what_is_no_shape_is_refused_in_words():
    bpy.ops.mesh.primitive_cube_add()
    cube = bpy.context.object
    assert not api.is_shape(cube) and api.value(cube) is None
    for function in (api.settings, api.recipe, api.inputs, api.restore, api.problem, lambda ob: api.set_value(ob, LINE)):
        with pytest.raises(api.Refusal, match="Cube is not a Splinewright shape"):
            function(cube)
    for given in (None, "Cube", cube.data):
        with pytest.raises(TypeError, match="an object of Blender's is expected"):
            api.value(given)
    ob = curve()
    for function in (api.settings, api.points, api.make_editable, lambda ob: api.set_settings(ob, caps="none")):
        with pytest.raises(api.Refusal, match="Curve has no recipe"):
            function(ob)


def test_a_loft_follows_its_curves_as_soon_as_it_is_asked():
    curves = [curve(height) for height in (0.0, 1.0, 2.0)]
    made = api.loft(curves, style='loose')
    assert api.recipe(made) == 'loft' and api.inputs(made) == curves and api.settings(made)['style'] == 'loose'
    assert [api.followers(ob) for ob in curves] == [[made]] * 3 and api.followers(made) == []
    assert isinstance(api.value(made), sc.NurbsPatch) and made.type == 'MESH' and made.data.polygons
    before = api.value(made)
    api.set_value(curves[1], api.value(curves[1]).with_points(api.value(curves[1]).points + (0, 5, 0)))
    curves[2].location.x = 3.0
    assert api.update() == {} and api.value(made) != before
    end = api.value(made).boundary('v_end' if np.allclose(api.value(made).boundary('v_start').points[0], (0, 0, 0)) else 'v_start')
    assert np.abs(end.evaluate(end.domain[1])[0]) <= 6.0 + 1e-6


def test_settings_are_exact_where_properties_round():
    made = api.extrude(curve(), (0.0, 0.0, 1 / 3))
    assert api.settings(made)['z'] == 1 / 3
    api.set_settings(made, z=math.pi)
    assert api.settings(made)['z'] == math.pi
    points = api.value(made).points
    assert set(points[..., 2].ravel().tolist()) == {0.0, math.pi}


@pytest.mark.parametrize('changes, kind, said', (
    ({'height': 1.0}, TypeError, "Pipe has no setting 'height': it has radius, end_radius"),
    ({'radius': "1"}, TypeError, "must be a number"), ({'caps': 1}, TypeError, "must be a text"),
    ({'caps': 'Round'}, ValueError, "one of none, flat, round"), ({'radius': -1.0}, ValueError, "must be from 1e-06"),
    ({'radius': float('nan')}, ValueError, "not a finite number"), ({'radius': 10 ** 400}, ValueError, "finite"), ({'radius': 1e12}, ValueError, "must be from")))
def test_wrong_settings_are_refused_and_nothing_changes(changes, kind, said):
    axis = curve()
    made = api.pipe(axis, 0.1)
    before, state = api.settings(made), scene_state()
    with pytest.raises(kind, match=said):
        api.set_settings(made, **changes)
    with pytest.raises(kind, match=said):
        api.make('pipe', [axis], {'radius': 0.2, **changes})
    assert api.settings(made) == before and scene_state() == state


def test_one_radius_makes_no_cone():
    assert api.settings(api.pipe(curve(), 0.3))['end_radius'] == 0.3
    assert api.settings(api.pipe(curve(), 0.3, end_radius=0.1))['end_radius'] == 0.1


def test_an_axis_object_turns_a_profile_and_is_followed():
    profile, axis = curve(1.0), bpy.data.objects.new("Axis", None)
    bpy.context.collection.objects.link(axis)
    made = api.revolve(profile, axis, axis='z')
    assert api.axis_object(made) == axis and api.followers(axis) == [made] and api.inputs(made) == [profile]
    before = api.value(made)
    axis.location.x = 1.0
    assert api.update() == {} and api.value(made) != before
    api.set_axis_object(made, None)
    assert api.axis_object(made) is None and api.followers(axis) == []
    with pytest.raises(api.Refusal, match="Extrude has no axis"):
        api.make('extrude', profile, axis_object=axis)


def test_offsets_of_curves_and_surfaces():
    flat = api.offset(curve(), 0.25, tolerance=1e-3)
    surface = api.offset(api.extrude(curve()), 0.25)
    assert api.recipe(flat) == 'offset' and api.recipe(surface) == 'offset_surface'
    assert (flat.type, surface.type) == ('CURVE', 'MESH')


def test_inputs_change_order_and_number():
    curves = [curve(height) for height in (0.0, 1.0, 2.0)]
    made = api.loft(curves[:2])
    api.set_inputs(made, curves[::-1], [True] * 3)
    assert api.inputs(made) == curves[::-1]
    before = api.value(made)
    with pytest.raises(api.Refusal, match="Loft|made from"):
        api.set_inputs(made, curves[:1])
    with pytest.raises(api.Refusal, match="follow itself"):
        api.set_inputs(made, [*curves, made])
    assert api.value(made) == before and api.inputs(made) == curves[::-1]


def test_points_of_a_recipe():
    wanted = np.array([(0, 0, 0), (1, 1 / 3, 0), (2, 0, 1), (3, 0, 0), (4, 1, 1)])
    made = api.make('interpolating', points=wanted, settings={'degree': 2})
    assert np.array_equal(api.points(made), wanted) and api.value(made).nearest(wanted).distances.max() < 1e-12
    api.set_points(made, wanted[:3])
    assert np.array_equal(api.points(made), wanted[:3]) and api.value(made).nearest(wanted[:3]).distances.max() < 1e-12
    for bad, said in (([(0, 0)], "shape"), ([(0, 0, math.inf)] * 3, "finite"), ([(0, 0, 0)], "")):
        with pytest.raises(ValueError, match=said):
            api.set_points(made, bad)
    assert np.array_equal(api.points(made), wanted[:3])
    with pytest.raises(api.Refusal, match="5 points, not 2"):
        api.make('five_points', points=wanted[:2])
    with pytest.raises(api.Refusal, match="takes no points"):
        api.make('circle', points=wanted)


def test_a_curve_through_objects_follows_them():
    empties = [bpy.data.objects.new(f"P{i}", None) for i in range(4)]
    for i, ob in enumerate(empties):
        bpy.context.collection.objects.link(ob)
        ob.location = (i, i * i / 3, 0)
    made = api.make('through_objects', empties)
    assert api.inputs(made) == empties and api.followers(empties[2]) == [made]
    empties[2].location.z = 1.0
    api.update()
    assert api.value(made).nearest([(2, np.float32(4 / 3), 1.0)]).distances[0] < 1e-6


@pytest.mark.parametrize('name', api.recipe_names())
def test_each_recipe_says_what_it_takes_and_is_made_with_its_defaults(name):
    found = api.describe(name)
    assert found.name == name and found.label and found.description
    for setting in found.settings:
        assert type(setting.default) in (float, int, bool, str) and setting.label and setting.description
        assert not setting.choices or setting.default in setting.choices
    if not found.inputs:
        made = api.make(name, settings={setting.name: setting.default for setting in found.settings})
        assert api.recipe(made) == name and api.inputs(made) == [] and api.update() == {}


def test_what_does_not_fit_a_recipe_is_refused_and_leaves_nothing():
    profile, axis = curve(), bpy.data.objects.new("Loose", None)
    before = scene_state()
    for call, said in ((lambda: api.make('lofts'), "there is no recipe 'lofts'"), (lambda: api.loft([profile]), "made from one curve"),
                       (lambda: api.make('circle', profile), "takes no objects"), (lambda: api.revolve(axis), "cannot be an input"),
                       (lambda: api.revolve(profile, axis), "not in this view layer"),
                       (lambda: api.make('revolve', profile, points=[(0, 0, 0)]), "takes no points"),
                       (lambda: api.make('through_objects', [profile]), "two objects or more")):
        with pytest.raises(api.Refusal, match=said):
            call()
    for call in (lambda: api.loft([profile, None]), lambda: api.loft([profile, "Curve"])):
        with pytest.raises(TypeError):
            call()
    assert scene_state() == before


def test_a_deleted_input_is_none_and_the_problem_is_told():
    curves = [curve(height, f"Section {height}") for height in (0.0, 1.0)]
    made = api.loft(curves)
    bpy.data.objects.remove(curves[1])
    stopped = api.update()
    assert api.inputs(made) == [curves[0], None]
    assert stopped == {made: api.problem(made)} and "Section 1.0" in api.problem(made)


def test_a_recipe_is_dropped_and_a_shape_ends():
    made = api.loft([curve(0.0), curve(1.0)])
    value = api.value(made)
    with pytest.raises(api.Refusal, match="Loft.*(recipe|follows|made from)"):
        api.set_value(made, value)
    api.make_editable(made)
    assert api.recipe(made) == "" and api.inputs(made) == [] and api.value(made) == value
    made.data.vertices[0].co.z += 1.0
    assert api.is_changed_by_hand(made)
    api.restore(made)
    assert not api.is_changed_by_hand(made)
    api.detach(made)
    assert not api.is_shape(made) and made.data.polygons


def test_it_is_imported_as_the_manual_says():
    names = {'splinewright': "splinewright", 'extension': "bl_ext.user_default.splinewright"}
    assert ADDON in names.values()
    space = {}
    exec(f"from {ADDON} import api", space)
    assert space['api'] is api and api.version and api.splinecore is sc


def test_the_example_makes_a_hull_that_is_up_to_date_and_saves_it(monkeypatch, tmp_path, capsys):
    path = tmp_path / "hull.blend"
    monkeypatch.setattr(sys, 'argv', ["blender", "--", str(path)])
    space = runpy.run_path(str(PROJECT / "examples/hull.py"))
    assert "Frame 4 is used by Frame 1 Loft" in capsys.readouterr().out
    wide = api.value(space['half']).nearest(api.value(space['frames'][3]).evaluate(np.linspace(0, 1, 9)[:-1])).distances
    assert wide.max() < 1e-6 and path.is_file() and space['problems'] == {}
    bpy.ops.wm.open_mainfile(filepath=str(path))
    hull = next(ob for ob in bpy.data.objects if api.is_shape(ob) and api.recipe(ob) == 'mirror')
    assert api.update() == {} and [api.recipe(ob) for ob in api.inputs(hull)] == ['loft']
