"""Equal parts: their ends lie on the curve, as far apart as is said, in the scene; what stands there stands so."""

import bpy
import numpy as np
import pytest
from mathutils import Matrix

from curves import value_of
from shapes import activate, add, op
from support import part, splinecore as sc

dividing = part('core.verbs.dividing')


def run(**settings):
    assert op(bpy.ops.splinewright.divide_equally, **settings) == {'FINISHED'}
    return bpy.context.object


def points(ob):
    found = np.empty(3 * len(ob.data.vertices), np.float32)
    ob.data.vertices.foreach_get('co', found)
    return found.reshape(-1, 3) @ np.array(ob.matrix_world.to_3x3()).T + np.array(ob.matrix_world.translation)


def in_world(ob, kind):
    return value_of(kind).to_nurbs().transformed(np.array(ob.matrix_world))


def placed(kind):
    """A shape moved, turned and scaled unevenly."""
    ob = add(value_of(kind))
    ob.matrix_world = Matrix.LocRotScale((3, -2, 1), Matrix.Rotation(0.7, 3, 'X').to_quaternion(), (2, 0.5, 1))
    bpy.context.view_layer.update()
    return ob


@pytest.mark.parametrize('kind', ('nurbs', 'cubic', 'hermite', 'semicircle', 'periodic'))
def test_parts_are_of_one_length_in_the_scene(kind):
    ob = placed(kind)
    curve = in_world(ob, kind)
    at = curve.divide(7)
    made = run(count=7)
    assert made.type == 'MESH' and len(made.data.vertices) == len(at) == (7 if kind == 'periodic' else 8)
    np.testing.assert_allclose(points(made), curve.evaluate(at), atol=2e-6)
    lengths = [curve.length(a, b, tolerance=1e-9) for a, b in zip(at, at[1:])]
    np.testing.assert_allclose(lengths, curve.length(tolerance=1e-9) / 7, rtol=1e-8)


def test_by_length_and_without_ends():
    ob = placed('nurbs')
    curve = in_world(ob, 'nurbs')
    made = run(by='LENGTH', length=0.5)
    assert len(made.data.vertices) == int(curve.length() / 0.5) + 1
    activate(ob)
    np.testing.assert_allclose(points(run(by='COUNT', count=4, with_ends=False)), curve.evaluate(curve.divide(4)[1:-1]), atol=2e-6)


def test_all_curves_of_a_shape_are_divided():
    add(value_of('many curves'))
    curves = value_of('many curves')
    wanted = sum(len(curve.to_nurbs().divide(3)) for curve in curves)
    assert len(run(count=3).data.vertices) == wanted


@pytest.mark.parametrize('along', 'XYZ')
@pytest.mark.parametrize('turned', ('upright', 'minimal', 'frenet'))
def test_copies_stand_with_their_axis_ahead(along, turned):
    post = bpy.data.objects.new("post", bpy.data.meshes.new("post"))
    bpy.context.scene.collection.objects.link(post)
    post.scale = (1, 2, 3)
    helix = sc.fit.interpolate([(np.cos(t), np.sin(t), 0.1 * t) for t in np.linspace(0, 9, 40)]).value
    ob = add(helix)
    bpy.context.view_layer.update()
    run(make='COPIES', source="post", count=12, turned=turned, along=along)
    copies = sorted((each for each in bpy.context.selected_objects), key=lambda each: each.matrix_world.translation.z)
    assert len(copies) == 13 and all(each.data == post.data for each in copies) and post.name in bpy.data.objects
    at = helix.divide(12)
    tangents = helix.frames(at)[:, 0]
    for copy, place, tangent in zip(copies, helix.evaluate(at), tangents):
        turn = copy.matrix_world.to_3x3()
        scale = [column.length for column in turn.col]
        assert np.allclose(scale, (1, 2, 3), rtol=1e-5) and turn.determinant() > 0
        assert np.allclose(copy.matrix_world.translation, place, atol=1e-5)
        column = np.array(turn.col['XYZ'.index(along)])
        assert np.allclose(column / np.linalg.norm(column), tangent, atol=1e-5)
        if turned == 'upright':
            up = np.array(turn.col[1 if along == 'Z' else 2])
            assert up[2] / np.linalg.norm(up) > 0.9
    assert len({each.users_collection for each in copies}) == 1


def test_posts_stand_also_where_the_curve_climbs():
    line = sc.BezierCurve([(0, 0, 0), (3, 4, 5)]).to_nurbs()
    found = dividing.places(line, line.divide(3), 'standing', 'X')
    np.testing.assert_allclose(found[:, :3, 0], [(0.6, 0.8, 0)] * 4, atol=1e-12)
    np.testing.assert_allclose(found[:, :3, 2], [(0, 0, 1)] * 4, atol=1e-12)
    upwards = sc.BezierCurve([(0, 0, 0), (0, 0, 5)]).to_nurbs()
    np.testing.assert_allclose(np.linalg.det(dividing.places(upwards, upwards.divide(3), 'standing', 'X')[:, :3, :3]), 1.0)


def test_straight_up_and_round_there_is_an_upper_side():
    line = sc.BezierCurve([(0, 0, 0), (0, 0, 5)]).to_nurbs()
    found = dividing.places(line, line.divide(3), 'upright', 'X')
    np.testing.assert_allclose(found[:, :3, 0], [(0, 0, 1)] * 4, atol=1e-12)
    np.testing.assert_allclose(np.linalg.det(found[:, :3, :3]), 1.0)
    circle = value_of('circle').to_nurbs()
    found = dividing.places(circle, circle.divide(8), 'minimal', 'Y')
    np.testing.assert_allclose(np.linalg.det(found[:, :3, :3]), 1.0)


@pytest.mark.parametrize('wanted', ({'count': 20_000}, {'length': 0.5}))
def test_it_ends_where_it_is_cancelled(wanted):
    at = np.arange(20_000)
    curve = sc.fit.interpolate(np.stack([np.cos(at), np.sin(at), 0.01 * at], -1)).value
    with pytest.raises(sc.Cancelled):
        dividing.parameters(curve, **wanted, cancel=lambda: True)
    for turned in ('minimal', 'frenet'):
        with pytest.raises(sc.Cancelled):
            dividing.places(curve, np.linspace(*curve.domain, 20_000), turned, 'X', cancel=lambda: True)


def test_empties_and_what_is_turned_not():
    add(value_of('nurbs'))
    run(make='EMPTIES', turned='not', count=5)
    made = bpy.context.selected_objects
    assert len(made) == 6 and all(each.type == 'EMPTY' for each in made)
    assert all(np.allclose(each.matrix_world.to_3x3(), np.eye(3)) for each in made)


@pytest.mark.parametrize('settings, word', (
    ({'by': 'LENGTH', 'length': 1e6}, "shorter than one part"), ({'make': 'COPIES'}, "choose the object"),
    ({'make': 'COPIES', 'source': "nobody"}, "choose the object"), ({'count': 1, 'with_ends': False}, "no place"),
    ({'make': 'EMPTIES', 'count': 20_000}, "too many"), ({'by': 'LENGTH', 'length': 1e-9}, "more than|2\\^22|length")))
def test_what_cannot_be_is_said_and_nothing_is_lost(settings, word):
    add(value_of('nurbs'))
    before = len(bpy.data.objects), len(bpy.data.meshes), len(bpy.data.collections)
    with pytest.raises(RuntimeError, match=word):
        run(**settings)
    assert (len(bpy.data.objects), len(bpy.data.meshes), len(bpy.data.collections)) == before


def test_too_many_objects_are_refused_before_places_are_sought(monkeypatch):
    add(value_of('nurbs'))
    monkeypatch.setattr(dividing, 'parameters', None)
    with pytest.raises(RuntimeError, match="too many objects"):
        run(make='EMPTIES', count=20_000)


def test_a_curve_is_needed_and_undo_takes_it_back():
    curve = add(value_of('nurbs')).name
    bpy.ops.ed.undo_push(message="curve")
    name = run(make='EMPTIES').name
    bpy.ops.ed.undo()
    assert name not in bpy.data.objects and curve in bpy.data.objects
    for each in list(bpy.data.objects):
        bpy.data.objects.remove(each)
    bpy.ops.splinewright.add_teapot()
    assert not bpy.ops.splinewright.divide_equally.poll()
