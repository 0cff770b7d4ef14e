"""Definitions and recipes that are damaged in a file: each is a sentence in the panel, and nothing else stops."""

import json

import bpy
import numpy as np
import pytest

from layouts import drawn
from shapes import activate, add, points, shown
from support import part, splinecore as sc

editing, follow, handlers, live, recipes, store = (part(name) for name in (
    'ui.editing', 'bridge.follow.follow', 'ui.handlers', 'bridge.net.live', 'bridge.recipes.recipes', 'bridge.data.store'))

SHAPES = {
    'curve': lambda: sc.NurbsCurve(3, [0, 0, 0, 0, 0.5, 1, 1, 1, 1], points(5)),
    'hermite': lambda: sc.HermiteCurve(points(3), points(3)),
    'patch': lambda: sc.NurbsPatch((1, 2), ([0, 0, 1, 1], [0, 1, 2, 3]), points(2, 3), periodic=(False, True)),
}
#: Takes a key away.
GONE = object()
VALUES = (GONE, "", "text", "9" * 400, 0, -1, 2, 2_000_000_000, 2.5, 1e300, float('inf'), float('nan'), True, [], [1], [1, 2, 3],
          [0.5, float('nan')], [float('inf')] * 4, [-5] * 8, [1e300] * 12, {}, {'a': 1}, 'object', 'scene')
STRUCTURES = ('', '[', '[]', '{}', '[{}]', '[[]]', 'null', '3', '"text"', '[' * 100_000, '[null]')
ENTRY_VALUES = (None, "text", -1, 0, 3, 2.5, 1e999, -1e999, 10 ** 30, True, [], [1], [0], [-1, 3], [1e999], [10 ** 30], [2.5, 2],
                ["a", "b"], [None, None], [True, False], [[2], [3]], {}, {"a": 1}, [4, 4, 4], [1] * 50)


def stored(value, ob):
    return {'object': ob, 'scene': bpy.context.scene}.get(value, value) if isinstance(value, str) else value


def put(group, name, value, ob):
    if name in group.keys():
        del group[name]
    if value is not GONE:
        group[name] = stored(value, ob)


def definition_damages(data):
    """Functions that each do one damage to a stored definition."""
    names = ('version', 'form', 'structure', 'pool', 'indices', 'knots', 'stamp', 'draft')
    for name in names:
        for value in VALUES:
            yield lambda ob, name=name, value=value: put(data[store.KEY], name, value, ob)
    entries = json.loads(data[store.KEY]['structure'])
    for text in STRUCTURES:
        yield lambda ob, text=text: put(data[store.KEY], 'structure', text, ob)
    for name in entries[0]:
        for value in ENTRY_VALUES:
            damaged = json.dumps([{**entries[0], name: value}])
            yield lambda ob, damaged=damaged: put(data[store.KEY], 'structure', damaged, ob)
        missing = json.dumps([{key: value for key, value in entries[0].items() if key != name}])
        yield lambda ob, missing=missing: put(data[store.KEY], 'structure', missing, ob)
    for value in VALUES[1:]:
        yield lambda ob, value=value: put(data, store.KEY, value, ob)
    yield lambda ob: put(data[store.KEY], 'knots', list(range(len(data[store.KEY]['knots'])))[::-1], ob)


def recipe_damages(data):
    for value in VALUES:
        yield lambda ob, value=value: put(data, recipes.KEY, value, ob)
    for name in ('version', 'kind', 'parameters', 'points', 'error', 'input', 'shape', 'turned', 'said', 'input_2', 'turned_2', 'frame', 'frame_1', 'frame_3'):
        for value in VALUES:
            yield lambda ob, name=name, value=value: put(data[recipes.KEY], name, value, ob)
    for name in list(data[recipes.KEY]['parameters'].keys()):
        for value in VALUES:
            yield lambda ob, name=name, value=value: put(data[recipes.KEY]['parameters'], name, value, ob)


def use(ob):
    """Everything that looks at a shape of its own accord, and a user who looks at it. Returns what the panels say."""
    activate(ob)
    text = drawn()
    for operator in operators():
        operator.poll()
    ob.data.splinewright.resolution_u = 5 if ob.data.splinewright.resolution_u == 4 else 4
    depsgraph = bpy.context.evaluated_depsgraph_get()
    handlers.frame_changed(bpy.context.scene, depsgraph)
    handlers.undone()
    return text


def operators():
    names = [name for name in dir(bpy.ops.splinewright) if not name.startswith('_')]
    return [getattr(bpy.ops.splinewright, name) for name in names]


def copy_of(group):
    return group.to_dict() if hasattr(group, 'to_dict') else group


@pytest.fixture
def witness():
    """A curve of Blender's, and a shape that follows it."""
    bpy.ops.curve.primitive_nurbs_path_add()
    source = bpy.context.object
    bpy.ops.splinewright.follow_object()
    return source, bpy.context.object


def require_following(witness, step):
    """The other follower of the file is brought up to date."""
    source, follower = witness
    source.data.splines[0].points[0].co = (step, 1, 2, 1)
    source.data.update_tag()
    bpy.context.view_layer.update()
    assert np.isclose(store.read(follower.data).pool[0, 0], step), f"the other follower stood still at {step}"


def try_all(ob, key, damages, witness):
    whole, said = copy_of(ob.data[key]), 0
    for step, damage in enumerate(damages, 1):
        store.assign(ob.data, key, whole)
        damage(witness[0])
        text = use(ob)
        said += "damaged" in text or "newer" in text
        require_following(witness, step)
        assert len(shown(ob)) > 0
    return step, said


@pytest.mark.parametrize('kind', SHAPES)
def test_no_damaged_definition_stops_anything(kind, witness, capfd):
    ob = add(SHAPES[kind]())
    tried, said = try_all(ob, store.KEY, definition_damages(ob.data), witness)
    assert tried > 300 and said > tried / 2
    assert "Traceback" not in capfd.readouterr().err


@pytest.mark.parametrize('kind', ('catmull_rom', 'conic', 'helix', 'sphere'))
def test_no_damaged_recipe_stops_anything(kind, witness, capfd):
    getattr(bpy.ops.splinewright, f"add_{kind}")()
    ob = bpy.context.object
    tried, said = try_all(ob, recipes.KEY, recipe_damages(ob.data), witness)
    assert tried > 200 and said > tried / 4
    assert "Traceback" not in capfd.readouterr().err


def test_no_damaged_follower_stops_anything(witness, capfd):
    activate(witness[0])
    bpy.ops.splinewright.follow_object()
    ob = bpy.context.object
    tried, said = try_all(ob, recipes.KEY, recipe_damages(ob.data), witness)
    assert tried > 200 and said > tried / 4
    assert "Traceback" not in capfd.readouterr().err


def test_no_damaged_curve_through_objects_stops_anything(witness, capfd):
    for ob in witness:
        ob.select_set(False)
    for place in ((0, 0, 0), (1, 1, 0), (2, 0, 1), (3, 1, 1), (4, 0, 0)):
        bpy.ops.object.empty_add(location=place)
    activate(*(ob for ob in bpy.context.scene.objects if ob.type == 'EMPTY'))
    bpy.ops.splinewright.curve_through_points()
    ob = bpy.context.object
    tried, said = try_all(ob, recipes.KEY, recipe_damages(ob.data), witness)
    assert tried > 200 and said > tried / 4
    assert "Traceback" not in capfd.readouterr().err


def test_a_curve_through_objects_of_which_one_is_missing_in_the_file_says_so():
    for place in ((0, 0, 0), (1, 1, 0), (2, 0, 1)):
        bpy.ops.object.empty_add(location=place)
    activate(*(ob for ob in bpy.context.scene.objects if ob.type == 'EMPTY'))
    bpy.ops.splinewright.curve_through_points()
    data = bpy.context.object.data
    before = data.splinewright.value
    del data[recipes.KEY]['frame_2']
    assert "damaged" in drawn() and data.splinewright.value == before


def test_a_scene_as_what_is_followed_is_a_sentence_and_make_editable_the_way_out(witness):
    ob = witness[1]
    ob.data[recipes.KEY]['input'] = bpy.context.scene
    activate(ob)
    assert "damaged" in drawn() and "Apply Construction" in drawn()
    bpy.ops.splinewright.make_editable()
    assert not recipes.has(ob.data) and "damaged" not in drawn()
    bpy.ops.splinewright.edit_net()
    bpy.ops.splinewright.leave_net()


def test_reading_every_property_leaves_what_is_stored(witness):
    """Before Blender 5.0 a registered property and a stored one of the same name are one: reading made an empty group."""
    ob = add(SHAPES['patch']())
    stored_before = set(ob.data.keys())
    for name in dir(ob.data):
        getattr(ob.data, name, None)
    for key in (store.KEY, recipes.KEY):
        assert (key in ob.data.keys()) == (key in stored_before)
    ob.data.splinewright.resolution_u = 3
    bpy.ops.splinewright.edit_net()
    bpy.ops.splinewright.leave_net()


def test_no_stored_key_has_the_name_of_a_property():
    keys = {store.KEY, recipes.KEY, part('bridge.cage.net_object').KEY, part('bridge.cage.net_object').EDITED_BY}
    for owner in (bpy.types.Mesh, bpy.types.Curve, bpy.types.Object):
        assert not keys & set(owner.bl_rna.properties.keys())


def test_an_empty_group_in_place_of_a_recipe_is_none():
    """What the console's completion made of shapes that have no recipe."""
    ob = add(SHAPES['curve']())
    ob.data[recipes.KEY] = {}
    bpy.ops.splinewright.edit_net()
    bpy.ops.splinewright.leave_net()
    ob.data.splinewright.resolution_u = 3
    assert ob.data.splinewright.problem == ""
