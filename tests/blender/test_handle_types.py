"""Handle types of chains: kept from Convert to Splinewright to Make Native, acting live in the net as in Blender's own curves, kept when
they are set."""

import itertools

import bpy
import numpy as np
import pytest

from layouts import sidebar
from natives import exact, native, select as select_objects
from shapes import add, enter, leave, op, require_exact
from support import part, splinecore as sc
from test_files import reopen, save

handles, live, store, shape_part, replacing = (part(name) for name in (
    'bridge.curve.handles', 'bridge.net.live', 'bridge.data.store', 'bridge.shape.shape', 'bridge.edit.replace_pieces'))
TYPES = ('FREE', 'AUTO', 'VECTOR', 'ALIGNED')
FIELDS = ('handle_left', 'co', 'handle_right')
PLACES = np.array([(0, 0, 0), (1, 2, 0), (3, 1, 1), (7, 2, 0), (8, 5, 1), (6, 6, 0.5), (2, 5, 0), (1, 4, 0)])


def bezier(pairs, closed=False, places=PLACES, name="chain"):
    """A Bezier curve of Blender's own, whose handles are free where the pairs say so."""
    data = bpy.data.curves.new(name, 'CURVE')
    data.dimensions = '3D'
    spline = data.splines.new('BEZIER')
    spline.bezier_points.add(len(pairs) - 1)
    for i, (point, place) in enumerate(zip(spline.bezier_points, places)):
        point.co = place
        point.handle_left, point.handle_right = place - (1, 0.2 * i, 0.3), place + (0.7, 0.3, 0.1 * i)
    spline.use_cyclic_u = closed
    for point, (left, right) in zip(spline.bezier_points, pairs):
        point.handle_left_type, point.handle_right_type = left, right
    ob = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(ob)
    select_objects(ob)
    bpy.ops.ed.undo_push(message="bezier")
    return ob


def types_of(ob, number=0):
    return [(point.handle_left_type, point.handle_right_type) for point in ob.data.splines[number].bezier_points]


def triples_of(ob, number=0):
    return np.array([[getattr(point, name) for name in FIELDS] for point in ob.data.splines[number].bezier_points])


def mixed(count=8):
    """Pairs of types, all of which are among them twice."""
    pairs = [*itertools.product(TYPES, TYPES)]
    return pairs[:count], pairs[count:]


def pairs_of(letter_pairs):
    names = {'F': 'FREE', 'A': 'AUTO', 'V': 'VECTOR', 'L': 'ALIGNED'}
    return [(names[a], names[b]) for a, b in letter_pairs.split()]


def kept(ob):
    return handles.read(ob.data)


def choose(ob, *parts):
    """Select (point, part) of the first spline, or all parts of a point; part: 0, 1 or 2."""
    bpy.ops.curve.select_all(action='DESELECT')
    for one in parts:
        number, sides = one if isinstance(one, tuple) else (one, (0, 1, 2))
        point = ob.data.splines[0].bezier_points[number]
        for side, name in enumerate(('select_left_handle', 'select_control_point', 'select_right_handle')):
            if side in np.atleast_1d(sides):
                setattr(point, name, True)
    ob.data.update_tag()
    bpy.ops.ed.undo_push(message="choose")


def followed():
    bpy.context.object.data.update_tag()
    bpy.context.view_layer.update()
    assert live.problem(bpy.context.object) == ""


# In and out ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize('closed', (False, True))
@pytest.mark.parametrize('pairs', mixed())
def test_made_exact_and_native_again_a_curve_has_its_types(pairs, closed):
    ob = bezier(pairs, closed)
    types, triples = types_of(ob), triples_of(ob)
    exact(ob)
    require_exact(ob)
    native(ob)
    assert types_of(ob) == types
    assert np.allclose(triples_of(ob), triples, atol=1e-6)
    assert handles.KEY not in ob.data.keys()


@pytest.mark.parametrize('name', ('primitive_bezier_curve_add', 'primitive_bezier_circle_add'))
def test_blenders_primitives_keep_their_types(name):
    getattr(bpy.ops.curve, name)(radius=1e-3, location=(1e3, 0, 0))
    ob = bpy.context.object
    types = types_of(ob)
    exact(ob)
    native(ob)
    assert types_of(ob) == types


def test_types_that_are_not_true_any_more_are_not_given_back():
    ob = bezier(pairs_of("AA AA AA AA"))
    exact(ob)
    curve = ob.data.splinewright.value
    tangents = curve.tangents.copy()
    tangents[1] *= 0.5
    tangents[2, 0] += (0, 0, 1)
    ob.data.splinewright.value = sc.HermiteCurve(curve.points, tangents)
    native(ob)
    assert types_of(ob) == pairs_of("AA LL FA AA")


# Live ----------------------------------------------------------------------------------------------------------------


MOVES = (
    ((2,), (0.5, -0.4, 1)), (((1, 0),), (0.2, 0.6, -0.5)), (((4, 2),), (-0.3, 0.6, 0.5)), (((3, 1), (5, 1)), (0, 0, 2)), ((0, 7), (-1, 0, 1)),
    (((6, (0, 1)),), (0.1, 0.2, 0.3)))


@pytest.mark.parametrize('closed', (False, True))
@pytest.mark.parametrize('pairs', (*mixed(), [('AUTO', 'AUTO')] * 8, [('ALIGNED', 'ALIGNED')] * 8, [('VECTOR', 'VECTOR')] * 8))
def test_a_net_is_moved_as_blenders_own_curve_is(pairs, closed):
    own, ours = bezier(pairs, closed, name="own"), bezier(pairs, closed, name="ours")
    exact(ours)
    for parts, way in MOVES:
        select_objects(own)
        bpy.ops.object.mode_set(mode='EDIT')
        choose(own, *parts)
        op(bpy.ops.transform.translate, value=way)
        bpy.ops.object.mode_set(mode='OBJECT')
        select_objects(ours)
        held = enter()
        choose(held, *parts)
        op(bpy.ops.transform.translate, value=way)
        assert live.problem(held) == ""
        leave()
        ours = bpy.data.objects["ours"]
        require_exact(ours)
        own = bpy.data.objects["own"]
    native(ours)
    assert types_of(ours) == types_of(own)
    assert np.allclose(triples_of(ours), triples_of(own), atol=3e-5)


@pytest.mark.parametrize('way', ('undo', 'reopen'))
def test_types_that_are_set_in_the_net_are_kept(way, tmp_path):
    add(sc.HermiteCurve(PLACES[:5], np.ones((5, 2, 3))), name="shape")
    ob = bpy.context.object
    assert kept(ob) == ()
    before = ob.data.splinewright.value
    held = enter()
    choose(held, 1, 2)
    op(bpy.ops.curve.handle_type_set, type='AUTOMATIC')
    followed()
    after = bpy.data.objects["shape"].data.splinewright.value
    assert after != before and kept(bpy.data.objects["shape"])[0][2:6] == "AAAA"
    if way == 'undo':
        bpy.ops.ed.undo()
        assert bpy.data.objects["shape"].data.splinewright.value == before and kept(bpy.data.objects["shape"]) in ((), ("L" * 10,))
        bpy.ops.ed.redo()
        assert bpy.data.objects["shape"].data.splinewright.value == after
        leave()
    else:
        leave()
        path = str(tmp_path / "kept.blend")
        save(path)
        reopen(path)
    assert kept(bpy.data.objects["shape"])[0][2:6] == "AAAA"
    select_objects(bpy.data.objects["shape"])
    held = enter()
    assert types_of(held)[1:3] == [('AUTO', 'AUTO')] * 2
    choose(held, 3)
    op(bpy.ops.transform.translate, value=(0, 0, 2))
    leave()
    curve = bpy.data.objects["shape"].data.splinewright.value
    assert (curve.tangents[2] != after.tangents[2]).any() and np.array_equal(curve.tangents[0], after.tangents[0])


def test_opening_and_leaving_a_net_changes_no_digit():
    ob = bezier([('AUTO', 'AUTO')] * 8)
    exact(ob)
    before = ob.data.splinewright.value, kept(ob)
    held = enter()
    choose(held, 0)
    followed()
    op(bpy.ops.transform.translate, value=(0, 0, 1))
    op(bpy.ops.transform.translate, value=(0, 0, -1))
    leave()
    ob = bpy.data.objects["chain"]
    assert (ob.data.splinewright.value, kept(ob)) == before


def test_handles_of_a_scaled_shape_are_automatic_no_more():
    ob = bezier([('AUTO', 'AUTO')] * 5)
    exact(ob)
    ob.scale = (2, 1, 1)
    op(bpy.ops.splinewright.apply_transform)
    before = ob.data.splinewright.value
    held = enter()
    assert types_of(held)[1:4] == [('ALIGNED', 'ALIGNED')] * 3
    followed()
    assert bpy.data.objects["chain"].data.splinewright.value == before


# Points more and less ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize('kind', ('AUTO', 'VECTOR', 'ALIGNED'))
def test_a_point_between_two_leaves_the_shape(kind):
    ob = bezier([(kind, kind)] * 5)
    exact(ob)
    before = ob.data.splinewright.value
    held = enter()
    choose(held, 1, 2)
    op(bpy.ops.curve.subdivide)
    followed()
    after = bpy.data.objects["chain"].data.splinewright.value
    assert len(after.points) == 6
    assert before.to_nurbs().largest_distance(after.to_nurbs()) < 1e-6
    types = types_of(bpy.context.object)
    assert types[0] == types[5] == types[4] == (kind, kind)
    leave()
    assert bpy.data.objects["chain"].data.splinewright.value == after


@pytest.mark.parametrize('kind', ('AUTO', 'VECTOR'))
def test_a_point_less_changes_no_more_than_it_must(kind):
    ob = bezier([(kind, kind)] * 5)
    exact(ob)
    before = ob.data.splinewright.value
    held = enter()
    choose(held, 2)
    op(bpy.ops.curve.delete, type='VERT')
    followed()
    after = bpy.data.objects["chain"].data.splinewright.value
    assert np.array_equal(after.points, np.delete(before.points, 2, 0))
    assert np.allclose(after.tangents, np.delete(before.tangents, 2, 0), atol=1e-5)


def test_free_handles_in_line_stay_free_where_points_are_appended():
    ob = bezier(pairs_of("FF FF FF FF"))
    point = ob.data.splines[0].bezier_points[1]
    point.handle_left, point.handle_right = (0, 2, 0), (3, 2, 0)
    exact(ob)
    choose(enter(), 3)
    op(bpy.ops.curve.extrude_move, TRANSFORM_OT_translate={'value': (1, 0, 2)})
    followed()
    assert kept(bpy.data.objects["chain"]) == ("F" * 10,)
    leave()
    native(bpy.data.objects["chain"])
    assert types_of(bpy.data.objects["chain"])[1] == ('FREE', 'FREE')


def test_a_cubic_alone_keeps_what_is_set():
    add(sc.BezierCurve(PLACES[:4]), name="chain")
    choose(enter(), 0)
    op(bpy.ops.curve.handle_type_set, type='VECTOR')
    followed()
    leave()
    assert kept(bpy.data.objects["chain"])[0][:2] == "VV"
    native(bpy.data.objects["chain"])
    assert types_of(bpy.data.objects["chain"]) == pairs_of("VV FF")


def test_an_appended_point_is_automatic_as_in_blender():
    own, ours = bezier([('AUTO', 'AUTO')] * 4, name="own"), bezier([('AUTO', 'AUTO')] * 4, name="ours")
    exact(ours)
    for name in ("own", "ours"):
        select_objects(bpy.data.objects[name])
        held = enter() if name == "ours" else bpy.data.objects[name]
        if name == "own":
            bpy.ops.object.mode_set(mode='EDIT')
        choose(held, 3)
        op(bpy.ops.curve.extrude_move, TRANSFORM_OT_translate={'value': (1, 0, 2)})
        leave() if name == "ours" else bpy.ops.object.mode_set(mode='OBJECT')
    native(bpy.data.objects["ours"])
    own, ours = bpy.data.objects["own"], bpy.data.objects["ours"]
    assert types_of(ours) == types_of(own) and np.allclose(triples_of(ours), triples_of(own), atol=1e-5)


@pytest.mark.parametrize('kind', ('AUTO', 'VECTOR'))
def test_what_stays_of_a_chain_that_is_opened_stays_as_it_was(kind):
    exact(bezier([(kind, kind)] * 5, True))
    before = bpy.data.objects["chain"].data.splinewright.value
    enter()
    bpy.ops.curve.select_all(action='SELECT')
    op(bpy.ops.curve.cyclic_toggle)
    followed()
    after = bpy.data.objects["chain"].data.splinewright.value
    assert np.array_equal(after.points, before.points[:-1])
    assert np.allclose(after.tangents.reshape(-1, 3)[1:-1], before.tangents.reshape(-1, 3)[1:-3], atol=1e-5)
    assert types_of(bpy.context.object)[1:4] == [(kind, kind)] * 3
    leave()
    assert bpy.data.objects["chain"].data.splinewright.value == after


@pytest.mark.parametrize('closed, kind', ((False, 'AUTO'), (False, 'VECTOR'), (False, 'ALIGNED'), (True, 'ALIGNED')))
def test_closed_or_opened_and_turned_it_is_as_blenders_own(closed, kind):
    for name in ("own", "ours"):
        ob = bezier([(kind, kind)] * 5, closed, name=name)
        if name == "ours":
            exact(ob)
            ob = enter()
        else:
            bpy.ops.object.mode_set(mode='EDIT')
        bpy.ops.curve.select_all(action='SELECT')
        op(bpy.ops.curve.cyclic_toggle)
        op(bpy.ops.curve.switch_direction)
        choose(bpy.context.object, 1)
        op(bpy.ops.transform.translate, value=(0.5, 1, 1))
        if name == "ours":
            assert live.problem(bpy.context.object) == ""
            leave()
        else:
            bpy.ops.object.mode_set(mode='OBJECT')
    ours = bpy.data.objects["ours"]
    require_exact(ours)
    native(ours)
    theirs = bpy.data.objects["own"]
    if triples_of(ours)[0, 1].tolist() != triples_of(theirs)[0, 1].tolist():        # the shape goes the way that it went
        assert np.allclose(triples_of(ours)[::-1, ::-1], triples_of(theirs), atol=1e-5)
        assert [pair[::-1] for pair in types_of(ours)[::-1]] == types_of(theirs)
    else:
        assert np.allclose(triples_of(ours), triples_of(theirs), atol=1e-5) and types_of(ours) == types_of(theirs)


# Carried along -------------------------------------------------------------------------------------------------------


def test_types_go_with_what_shapes_become():
    ob = bezier(pairs_of("FA AA VV LL FA"))
    exact(ob)
    letters, = kept(ob)
    op(bpy.ops.splinewright.reverse)
    assert kept(ob) == (letters[::-1],)
    op(bpy.ops.splinewright.reverse)
    op(bpy.ops.splinewright.split, parameter_u=2.0)
    assert kept(ob) == (letters[:6], letters[4:])
    bpy.ops.object.duplicate()
    assert kept(bpy.context.object) == (letters[:6], letters[4:])
    op(bpy.ops.object.select_all, action='SELECT')
    op(bpy.ops.splinewright.join)
    assert kept(bpy.context.object) == (letters[:6], letters[4:]) * 2
    op(bpy.ops.splinewright.to_nurbs)
    assert kept(bpy.context.object) == ()
    op(bpy.ops.splinewright.detach)
    assert handles.KEY not in bpy.context.object.data.keys()


def test_a_baked_curve_has_none():
    ob = bezier([('AUTO', 'AUTO')] * 4)
    exact(ob)
    baking = part('bridge.edit.baking')
    for take in baking.record(bpy.context.scene, [ob.data], [1, 2]):
        pass
    baked = ob.data.copy()
    shape_part.detach(baked)
    assert handles.KEY not in baked.keys() and kept(ob) == ("A" * 8,)


@pytest.mark.parametrize('damaged', ("x", "[]", "{}", '["AA"]', '["AAAAAAAX"]', "[3]", '["AAAAAAAA", ""]', "[" * 100_000, "null"))
def test_damaged_types_are_told_and_lost_by_nothing_else(damaged):
    ob = bezier([('AUTO', 'AUTO')] * 4)
    exact(ob)
    before = ob.data.splinewright.value
    ob.data[handles.KEY] = damaged
    with pytest.raises(store.UnreadableDefinition, match="The handle types of chain are damaged"):
        handles.read(ob.data)
    held = enter()
    followed()
    ob = bpy.data.objects["chain"]
    assert ob.data.splinewright.value == before and handles.problem(ob.data)
    choose(held, 1)
    op(bpy.ops.curve.handle_type_set, type='VECTOR')
    followed()
    assert kept(bpy.data.objects["chain"])[0][2:4] == "VV"
    leave()


def test_the_panel_says_the_types_of_selected_joints():
    ob = bezier(pairs_of("AA VF LL AA"))
    exact(ob)
    held = enter()
    for parts, said in (((0,), "Handles: Automatic"), ((1,), "Handles: Vector, Free"), (((2, 0), 3), "Handles: Automatic, Aligned")):
        choose(held, *parts)
        drawn = sidebar(bpy.context)
        assert said in drawn.texts and drawn.operators.count("curve.handle_type_set") == 4
    choose(held)
    assert not any("Handles" in text for text in sidebar(bpy.context).texts)
    bpy.data.objects["chain"].data[handles.KEY] = "x"
    assert "handle types of chain are damaged" in " ".join(sidebar(bpy.context).texts)
    leave()
    add(sc.BezierCurve(PLACES[:5]), name="polygon")
    enter()
    bpy.ops.curve.select_all(action='SELECT')
    assert "curve.handle_type_set" not in sidebar(bpy.context).operators
    leave()


def test_make_native_names_damaged_types():
    ob = bezier([('AUTO', 'AUTO')] * 4)
    exact(ob)
    ob.data[handles.KEY] = "x"
    outcome, _ = part('bridge.native.to_native').to_native(bpy.context, ob)
    assert "the handle types, which are damaged" in outcome.dropped and len(types_of(ob)) == 4


def test_what_is_no_text_is_damaged():
    ob = bezier([('AUTO', 'AUTO')] * 4)
    exact(ob)
    ob.data[handles.KEY] = 3
    assert "damaged" in handles.problem(ob.data) and handles.known(ob.data) == ()


# By numbers and by pulling -------------------------------------------------------------------------------------------


def test_a_number_for_a_handle_makes_it_what_blender_makes_of_it():
    ob = bezier(pairs_of("AA AA VV AA AA"))
    exact(ob)
    held = enter()
    choose(held, (1, 2))
    data = held.data
    numbers = list(data.splinewright_points.numbers)
    numbers[2] += 1.0
    data.splinewright_points.numbers = numbers
    followed()
    types = types_of(bpy.context.object)
    assert types[1] == ('ALIGNED', 'ALIGNED') and types[0] == types[3] == ('AUTO', 'AUTO')
    triple = triples_of(bpy.context.object)[1]
    assert np.allclose(triple[2], numbers[:3], atol=1e-6)
    assert np.allclose(np.cross(triple[2] - triple[1], triple[1] - triple[0]), 0, atol=1e-5)
    choose(bpy.context.object, (3, 1))
    numbers = list(data.splinewright_points.numbers)
    numbers[2] += 2.0
    data.splinewright_points.numbers = numbers
    followed()
    assert types_of(bpy.context.object)[3] == ('AUTO', 'AUTO')
    before = bpy.data.objects["chain"].data.splinewright.value
    require_exact(bpy.data.objects["chain"])
    leave()
    assert bpy.data.objects["chain"].data.splinewright.value == before


def test_a_pull_that_is_called_off_puts_types_back():
    ob = bezier([('AUTO', 'AUTO')] * 5)
    exact(ob)
    before = ob.data.splinewright.value
    held = enter()
    pulled = part('bridge.net.pulling').HeldNet(held)
    core_pulling = part('core.shape.definition')
    curve = core_pulling.to_value(pulled.definition)
    other = core_pulling.from_value(sc.HermiteCurve(curve.points, curve.tangents * [[[1.5]], [[1]], [[0.7]], [[1]], [[1]]]))
    pulled.show(other)
    followed()
    assert bpy.data.objects["chain"].data.splinewright.value != before
    assert types_of(held)[2] == ('ALIGNED', 'ALIGNED')
    pulled.put_back()
    followed()
    assert bpy.data.objects["chain"].data.splinewright.value == before
    assert types_of(bpy.context.object) == [('AUTO', 'AUTO')] * 5 and kept(bpy.data.objects["chain"]) == ("A" * 10,)
    leave()
