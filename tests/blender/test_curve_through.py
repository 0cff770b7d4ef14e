"""A curve through what is selected: vertices, along edges or as they were chosen, and objects, which it follows."""

from contextlib import contextmanager

import bmesh
import bpy
import numpy as np
import pytest

from blender_objects import annotations, grease_pencil
from layouts import drawn
from shapes import activate, enter, op, require_exact, shown
from support import part, splinecore as sc


follow, recipes, remaking, store = (part(f'bridge.{name}') for name in ('follow.follow', 'recipes.recipes', 'shape.recipe_edit', 'data.store'))

PLACES = np.array([(0, 0, 0), (1, 2, 0), (3, 1, 1), (4, -1, 0.5), (6, 0, -1)], dtype=np.float64)


def empties(places=PLACES, name="P"):
    obs = []
    for i, place in enumerate(places):
        ob = bpy.data.objects.new(f"{name}.{2 * i}", None)
        ob.location = place
        bpy.context.scene.collection.objects.link(ob)
        obs.append(ob)
    bpy.context.view_layer.update()
    activate(*obs)
    return obs


def run(**settings):
    assert op(bpy.ops.splinewright.curve_through_points, **settings) == {'FINISHED'}
    return bpy.context.object


def mesh_object(points, edges=()):
    mesh = bpy.data.meshes.new("wire")
    mesh.from_pydata(points, edges, [])
    ob = bpy.data.objects.new("wire", mesh)
    bpy.context.scene.collection.objects.link(ob)
    activate(ob)
    return ob


def select_vertices(ob, chosen, in_history=True):
    bpy.ops.object.mode_set(mode='EDIT')
    bm = bmesh.from_edit_mesh(ob.data)
    bm.verts.ensure_lookup_table()
    for vertex in bm.verts:
        vertex.select = False
    bm.select_flush(False)
    bm.select_history.clear()
    for i in chosen:
        bm.verts[i].select = True
        if in_history:
            bm.select_history.add(bm.verts[i])
    bm.select_flush(True)
    bmesh.update_edit_mesh(ob.data)


def value(ob):
    return ob.data.splinewright.value


@pytest.mark.parametrize('degree', (1, 2, 3, 4))
def test_it_goes_through_the_objects_in_the_order_of_their_names_and_follows_them(degree):
    obs = empties(np.vstack([PLACES, PLACES[::-1] + 10]))        # P.2 comes before P.10
    ob = run(degree=degree, parametrisation='chordal')
    where = np.array([place.matrix_world.translation for place in obs])
    assert value(ob) == sc.fit.interpolate(where, degree, 'chordal').value
    require_exact(ob)
    obs[2].location.z += 5
    bpy.context.view_layer.update()
    where[2, 2] += 5
    assert value(ob) == sc.fit.interpolate(where, degree, 'chordal').value and follow.problem(ob.data) == ""
    require_exact(ob)


def test_it_follows_in_a_space_of_its_own_through_save_and_open(tmp_path):
    empties()
    ob = run()
    assert op(bpy.ops.splinewright.set_moving, how='WITH_INPUTS') == {'FINISHED'}
    ob.location, ob.scale = (1, 2, 3), (2, 2, 2)
    name = ob.name
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "through.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "through.blend"))
    ob = bpy.data.objects[name]
    bpy.data.objects["P.4"].location = (0, 0, 9)
    bpy.context.view_layer.update()
    where = PLACES.copy()
    where[2] = (0, 0, 9)
    own = sc.fit.interpolate((where - (1, 2, 3)) / 2, 3, 'centripetal').value
    assert np.allclose(value(ob).points, own.points, atol=1e-6) and np.allclose(value(ob).knots, own.knots, rtol=1e-6)
    require_exact(ob)


def test_an_object_that_is_deleted_leaves_the_curve_as_it_was_with_a_word():
    obs = empties()
    ob = run()
    before = value(ob)
    bpy.data.objects.remove(obs[1])
    bpy.context.view_layer.update()
    assert value(ob) == before and "deleted" in follow.problem(ob.data)
    assert op(bpy.ops.splinewright.make_editable) == {'FINISHED'} and value(ob) == before


def test_its_numbers_stay_in_the_panel_which_says_what_it_follows():
    empties()
    ob = run()
    ob.data.splinewright_parameters.through_objects_closed = True
    assert value(ob) == sc.fit.interpolate(PLACES, 3, 'centripetal', closed=True).value
    assert "Follows 5 objects" in drawn()


def test_tab_leads_to_the_objects():
    obs = empties()
    ob = run()
    assert not bpy.ops.splinewright.edit_net.poll() and op(bpy.ops.splinewright.edit_source) == {'FINISHED'}
    assert set(bpy.context.selected_objects) == set(obs) and ob not in bpy.context.selected_objects


def test_it_need_not_follow_and_then_its_net_is_the_points():
    obs = empties()
    ob = run(live=False)
    assert recipes.kind(ob.data) == 'interpolating' and np.array_equal(recipes.points(ob.data), PLACES)
    obs[0].location.x = 9
    bpy.context.view_layer.update()
    assert np.array_equal(recipes.points(ob.data), PLACES)
    activate(ob)
    enter()


def test_the_curve_goes_along_the_edges_of_a_mesh_whatever_the_order_of_its_vertices():
    source = mesh_object(PLACES[[3, 0, 4, 1, 2]], [(1, 3), (3, 4), (4, 0), (0, 2)])
    source.location.x = 7
    select_vertices(source, range(5), in_history=False)
    ob = run()
    assert bpy.context.mode == 'OBJECT' and ob.location.x == 7
    assert np.array_equal(recipes.points(ob.data), PLACES)
    require_exact(ob)


def test_a_loop_of_edges_closes():
    around = np.array([(np.cos(t), np.sin(t), 0) for t in np.arange(8) * np.pi / 4])
    source = mesh_object(around, [(i, (i + 1) % 8) for i in range(8)])
    select_vertices(source, range(8), in_history=False)
    ob = run()
    assert remaking.is_closed(ob.data) and value(ob).periodic and len(ob.data.splines) == 1


def test_chains_are_curves_each():
    source = mesh_object(np.vstack([PLACES, PLACES + 10]), [(i, i + 1) for i in (0, 1, 2, 3, 5, 6, 7, 8)])
    select_vertices(source, range(10), in_history=False)
    before = set(bpy.data.objects)
    run()
    new = set(bpy.data.objects) - before
    assert len(new) == 2 and set(bpy.context.selected_objects) == new


def test_loose_vertices_follow_as_they_were_selected():
    source = mesh_object(PLACES)
    select_vertices(source, (2, 0, 4, 1))
    assert np.array_equal(recipes.points(run().data), PLACES[[2, 0, 4, 1]])


def test_few_points_lower_the_degree_with_a_word(capfd):
    empties(PLACES[:3])
    assert value(run(degree=5)).degree == 2 and "the degree is 2" in capfd.readouterr().out


@pytest.mark.parametrize('points, chosen, word', ((PLACES, (), "no vertices"), (PLACES, (1,), "needs two points"),
                                                  (PLACES[[0, 0, 1, 2]], (0, 1, 2, 3), "too close")))
def test_what_is_no_curve_is_refused_and_nothing_is_lost(points, chosen, word):
    source = mesh_object(points)
    select_vertices(source, chosen)
    before = len(bpy.data.objects), len(bpy.data.curves)
    with pytest.raises(RuntimeError, match=word):
        run()
    assert bpy.context.mode == 'EDIT_MESH' and (len(bpy.data.objects), len(bpy.data.curves)) == before


def test_it_goes_through_all_points_of_each_stroke():
    lines = PLACES.astype(np.float32).astype(np.float64), (PLACES + 1).astype(np.float32).astype(np.float64)
    source = grease_pencil(*lines)
    source.location = (1, 2, 3)
    bpy.context.view_layer.update()
    before = set(bpy.data.objects)
    run()
    made = sorted(set(bpy.data.objects) - before, key=lambda ob: ob.name)
    assert len(made) == 2 and source.name in bpy.data.objects
    for ob, line in zip(made, lines):
        assert np.array_equal(recipes.points(ob.data), line) and tuple(ob.location) == (1, 2, 3)
        assert value(ob).nearest(line).distances.max() < 1e-14
        require_exact(ob)


def test_strokes_of_none_are_said():
    grease_pencil()
    with pytest.raises(RuntimeError, match="no strokes"):
        run()


def test_vertices_in_no_order_are_refused():
    source = mesh_object(PLACES)
    select_vertices(source, range(5), in_history=False)
    with pytest.raises(RuntimeError, match="one after another"):
        run()


def test_nets_and_single_objects_are_told_why_not():
    ob, = empties(PLACES[:1])
    assert not bpy.ops.splinewright.curve_through_points.poll()
    bpy.ops.splinewright.add_nurbs_patch()
    enter()
    assert bpy.context.mode == 'EDIT_MESH' and not bpy.ops.splinewright.curve_through_points.poll()


def test_undo_takes_it_back():
    empties()
    bpy.ops.ed.undo_push(message="empties")
    ob = run()
    name = ob.name
    bpy.ops.ed.undo()
    assert name not in bpy.data.objects and len(bpy.data.objects) == 5


@pytest.mark.parametrize('name', ('curve_through_points', 'fit_curve'))
def test_annotations_are_taken_where_nothing_is_selected(name):
    operator = getattr(bpy.ops.splinewright, name)
    assert not operator.poll()
    annotations(PLACES, PLACES + 5, PLACES[:1])
    assert operator.poll() and not bpy.context.selected_objects
    settings = {} if name == 'curve_through_points' else {'tolerance': 1e-6}
    assert op(operator, **settings) == {'FINISHED'}
    made = sorted(bpy.context.selected_objects, key=lambda ob: value(ob).points[0, 0])
    assert len(made) == 2 == len(bpy.data.objects)
    for ob, places in zip(made, (PLACES, PLACES + 5)):
        assert value(ob).nearest(places).distances.max() < 1e-5 and np.array(ob.matrix_world).tolist() == np.eye(4).tolist()
        assert np.array_equal(recipes.points(ob.data), places)


def test_of_an_object_that_is_selected_annotations_are_not_taken():
    annotations(PLACES)
    empties(PLACES[:1])
    assert not bpy.ops.splinewright.curve_through_points.poll()
    empties(PLACES[1:], "Q")
    assert value(run()).nearest(PLACES[1:]).distances.max() < 1e-5 and recipes.kind(bpy.context.object.data) == 'through_objects'


def test_progress_is_shown_while_curves_are_made(monkeypatch):
    told = []

    @contextmanager
    def shown_here(context, total):
        yield lambda step: told.append((step, total))
    monkeypatch.setattr(part('ui.operators.from_points').progress, 'shown', shown_here)
    grease_pencil(PLACES, PLACES + 5, PLACES - 5)
    run()
    steps = part('bridge.shape.shape').STEPS
    assert told == [(step, 3 * steps) for step in range(1, 3 * steps + 1)]
