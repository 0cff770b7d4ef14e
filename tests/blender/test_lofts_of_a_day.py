"""What a designer does with lofts, patches and meshes on one day: a hull with a chine, sections added and sorted, ends, meshes."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from mathutils.bvhtree import BVHTree

from layouts import Layout, sidebar
from patches import value_of
from shapes import activate, add, enter, leave, op, require_exact
from support import part, splinecore as sc, vertices

follow, problems, recipes = (part(name) for name in ('bridge.follow.follow', 'bridge.data.problems', 'bridge.recipes.recipes'))
CIRCLE = sc.conics.circle((0, 0, 0), 1.0)


def frame(points, z):
    """A polygon whose knots are lengths, as Draw Contour gives it."""
    rows = [(*p, z) for p in points]
    at = np.r_[0, np.cumsum(np.linalg.norm(np.diff(np.array(rows, float), axis=0), axis=1))]
    return sc.NurbsCurve(1, np.r_[at[0], at, at[-1]], rows)


def ring(z, name):
    ob = add(CIRCLE, name)
    ob.location.z = z
    return ob


def heights(ob):
    return [source.location.z for source in recipes.read(ob.data).sources]


def loft(*obs, **settings):
    activate(*obs)
    assert op(bpy.ops.splinewright.add_loft, **settings) == {'FINISHED'}
    return bpy.context.object


def take_in(ob, *others):
    activate(ob, *others)
    return op(bpy.ops.splinewright.add_inputs)


def test_the_chine_of_a_hull_is_one_edge():
    ob = loft(*(add(frame([(0, 0), (1 + 0.2 * i, 0.3), (1.3 + 0.1 * i, 1.2)], 2.0 * i), f"frame {i}") for i in range(4)))
    value = ob.data.splinewright.value
    along = value.degree.index(1)
    assert len(np.unique(value.knots[along])) == value.points.shape[along] == 3 and recipes.read(ob.data).said == ""


@pytest.mark.parametrize('at, new', (((0, 1, 3, 4), 2), ((0, 1, 2, 3), -1), ((0, 1, 2, 3), 9), ((3, 2, 1, 0), 1.5)))
def test_a_section_comes_where_it_belongs_and_the_order_is_sorted_and_reversed(at, new):
    ob = loft(*(ring(z, f"ring {z}") for z in at))
    assert take_in(ob, ring(new, "new")) == {'FINISHED'}
    found = heights(ob)
    assert found in (sorted(found), sorted(found)[::-1]) and new in found
    op(bpy.ops.splinewright.reverse_inputs)
    assert heights(ob) == found[::-1]
    op(bpy.ops.splinewright.move_input, index=0, way='DOWN')
    op(bpy.ops.splinewright.sort_inputs)
    assert heights(ob) in (found, found[::-1])


def test_an_empty_that_is_added_is_a_point_at_its_end_and_round():
    ob = loft(ring(0, "a"), ring(1, "b"))
    bpy.ops.object.empty_add(location=(0, 0, 2))
    point = bpy.context.object
    assert take_in(ob, point) == {'FINISHED'} and recipes.read(ob.data).sources[-1] == point
    ob.data.splinewright_parameters.loft_end = 'round'
    ob.data.splinewright_parameters.loft_caps = 'both'
    assert recipes.read(ob.data).values['end'] == 'round' and recipes.read(ob.data).values['caps'] == 'both'
    require_exact(ob)


def test_open_and_closed_ones_are_refused_by_name_at_first_and_when_added():
    closed, opened = ring(0, "closed one"), add(frame([(0, 0), (1, 1)], 1.0), "open one")
    activate(closed, opened)
    with pytest.raises(RuntimeError, match="closed one is closed and open one is open"):
        op(bpy.ops.splinewright.add_loft)
    ob = loft(ring(0, "x"), ring(1, "y"))
    with pytest.raises(RuntimeError, match="open one"):
        take_in(ob, opened)
    assert len(recipes.read(ob.data).sources) == 2


def test_tangency_of_its_ends_is_in_the_panel_and_what_is_missing_is_said():
    ob = loft(*(ring(z, f"ring {z}") for z in (0, 1, 3)))
    assert {'Start', 'End'} <= set(sidebar(bpy.context).texts)
    ob.data.splinewright_parameters.loft_start = 'normal'
    assert recipes.read(ob.data).values['start'] == 'normal'
    ob.data.splinewright_parameters.loft_start = 'G1'
    assert recipes.read(ob.data).values['start'] == 'normal' and "surface" in problems.of(ob.data, problems.SETTING)


@pytest.mark.parametrize('kind', ('cube', 'grid', 'cone'))
def test_the_panel_of_what_is_made_of_a_mesh_is_whole_and_the_mesh_is_named_where_it_ends(kind):
    getattr(bpy.ops.mesh, f"primitive_{kind}_add")()
    source = bpy.context.object
    assert op(bpy.ops.splinewright.add_of_mesh) == {'FINISHED'}
    ob = bpy.context.object
    drawn = sidebar(bpy.context)
    assert f"Follows {source.name}" in drawn.texts and {'Apply Construction', 'Kind', 'Degrees'} <= set(drawn.texts)
    require_exact(ob)
    source.data.vertices[0].co.z += 0.3
    source.data.update()
    bpy.context.view_layer.update()
    assert follow.problem(ob.data) == ""
    source.data.clear_geometry()
    bpy.context.view_layer.update()
    assert follow.problem(ob.data).startswith(f"{source.name}: the mesh has no face")


def test_the_menu_of_x_takes_a_patch_out_of_a_net():
    ob = add(value_of('four around a corner'))
    assert "splinewright.delete_pieces" not in _of_x()
    enter()
    assert "splinewright.delete_pieces" in _of_x()
    leave()


def _of_x():
    """Operators that are added to Blender's menu of X."""
    menus, layout = part('ui.menus'), Layout()
    dict(menus._FIRST)["VIEW3D_MT_edit_mesh_delete"](SimpleNamespace(layout=layout), bpy.context)
    return layout.operators


def test_a_loft_of_few_sections_is_smooth_and_thick_without_very_many_faces():
    """By default faces are within a thousandth of the size, and a thick surface has about twice as many."""
    rings = [ring(z, f"at {z}") for z in (0.0, 1.0, 2.0, 3.0)]
    for each, scale in zip(rings, (1.0, 1.6, 0.8, 1.2)):
        each.scale = scale, scale, 1.0
    skin = loft(*rings)
    assert skin.data.splinewright.mode == 'AUTOMATIC'
    assert op(bpy.ops.splinewright.add_thickened, distance=0.05) == {'FINISHED'}
    thick = bpy.context.object
    assert 500 < len(skin.data.vertices) < 6_000 and len(thick.data.vertices) < 15_000
    count = 40
    u, v = (np.linspace(*domain, count) for domain in skin.data.splinewright.value.domain)
    tree = BVHTree.FromPolygons(vertices(skin.data).tolist(), [tuple(face.vertices) for face in skin.data.polygons])
    points = skin.data.splinewright.value.evaluate_grid(u, v).reshape(-1, 3)
    size = np.linalg.norm(np.ptp(points, axis=0))
    assert max(tree.find_nearest(point)[3] for point in points.tolist()) <= 1.1e-3 * size


def test_the_list_of_its_sections_moves_turns_adds_and_removes():
    rings = [ring(z, f"ring {z}") for z in (0, 1, 3)]
    ob = loft(*rings)
    group = ob.data.splinewright_parameters
    assert len(group.inputs) == 3
    drawn = sidebar(bpy.context)
    assert drawn.props.count("name") == 3 and drawn.operators.count("splinewright.turn_input") == 3
    group.active_input = 2
    op(bpy.ops.splinewright.move_input, index=2, way='UP')
    assert [source.name for source in recipes.read(ob.data).sources] == ["ring 0", "ring 3", "ring 1"] and group.active_input == 1
    op(bpy.ops.splinewright.turn_input, index=1)
    assert recipes.input_at(ob.data, 1) == (rings[2], True)
    op(bpy.ops.splinewright.remove_input, index=2)
    assert len(group.inputs) == 2 and recipes.input_at(ob.data, 1) == (rings[2], True)
    take_in(ob, rings[1])
    assert len(group.inputs) == 3 and not problems.of(ob.data, problems.SETTING)
    group.inputs.clear()                # as in files of before there was a list
    recipes.show_new([ob.data])
    assert len(group.inputs) == 3
