"""Caps, corners and ends of lofts, and plane fillings, live and in files: the meshes are closed, with normals outwards."""

import math

import bmesh
import bpy
import numpy as np
import pytest

from shapes import activate, add, op, require_exact
from support import part, splinecore as sc

follow, recipes = (part(name) for name in ('bridge.follow.follow', 'bridge.recipes.recipes'))
CIRCLE = sc.conics.circle((0, 0, 0), 1.0)


def polygon(*points, z=0.0):
    rows = [(*p, z) for p in (*points, points[0])]
    at = np.arange(len(rows), dtype=float)
    return sc.NurbsCurve(1, np.r_[at[0], at, at[-1]], rows)


LETTER = polygon((0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (3, 2), (3, 3), (1, 3), (1, 4), (3, 4), (3, 5), (0, 5))
SQUARE = polygon((0, 0), (1, 0), (1, 1), (0, 1))


def make(kind, *objects, **settings):
    activate(*objects)
    assert op(getattr(bpy.ops.splinewright, f"add_{kind}"), **settings) == {'FINISHED'}
    return bpy.context.object


def open_edges(ob):
    counts = np.zeros(len(ob.data.edges), int)
    edge_of = np.empty(len(ob.data.loops), np.int32)
    ob.data.loops.foreach_get('edge_index', edge_of)
    np.add.at(counts, edge_of, 1)
    return int((counts != 2).sum())


def volume(ob):
    mesh = bmesh.new()
    mesh.from_mesh(ob.data)
    found = mesh.calc_volume(signed=True)
    mesh.free()
    return found


def require_closed(ob, wanted=None, rel=0.02):
    assert open_edges(ob) == 0
    assert volume(ob) > 0.0
    if wanted is not None:
        assert volume(ob) == pytest.approx(wanted, rel=rel)


def rings(*heights):
    found = []
    for height in heights:
        found.append(add(CIRCLE, f"at {height}"))
        found[-1].location.z = height
    bpy.context.view_layer.update()
    return found


def line(*points):
    return sc.build.polynomial_through(points)


MADE = {
    'extrude': (lambda: make('extrude', add(CIRCLE, "profile"), z=2.0, caps='both'), 2 * math.pi),
    'extruded letter': (lambda: make('extrude', add(LETTER, "E"), z=2.0, caps='both'), 22.0),
    'extruded down': (lambda: make('extrude', add(SQUARE, "square"), z=-2.0, caps='both'), 2.0),
    'loft': (lambda: make('loft', *rings(0, 1, 3), caps='both'), 3 * math.pi),
    'revolve': (lambda: make('revolve', add(polygon((1, 0), (2, 0), (2, 1), (1, 1)), "profile"), axis='y', sweep=1.0, caps='both'), 1.5),
    'sweep': (lambda: make('sweep', add(line((0, 0, 0), (0, 0, 2), (0, 0, 5)), "rail"), add(CIRCLE, "section"), caps='both'), 5 * math.pi),
    'pipe': (lambda: make('pipe', add(line((0, 0, 0), (1, 0, 0.4), (3, 0, 0)), "rail"), radius=0.2, caps='flat'), None),
}


@pytest.mark.parametrize('name', MADE)
def test_it_is_closed_exact_and_stays_so_in_a_file_and_when_it_follows(name, tmp_path):
    make_it, wanted = MADE[name]
    ob = make_it()
    require_closed(ob, wanted)
    require_exact(ob)
    name, value = ob.name, ob.data.splinewright.value
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "caps.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "caps.blend"))
    ob = bpy.data.objects[name]
    assert ob.data.splinewright.value == value
    source = recipes.read(ob.data).sources[0]
    source.data.splinewright.value = source.data.splinewright.value.transformed(np.diag([1.1, 1.1, 1.1, 1.0])[:3])
    bpy.context.view_layer.update()
    assert ob.data.splinewright.value != value and not follow.problem(ob.data)
    require_closed(ob)


def test_start_end_and_none_are_chosen_in_the_panel():
    ob = MADE['loft'][0]()
    group = ob.data.splinewright_parameters
    opened = {}
    for caps in ('none', 'start', 'end', 'both'):
        group.loft_caps = caps
        opened[caps] = open_edges(ob)
    assert opened['both'] == 0 < opened['start'] == opened['end'] == opened['none'] / 2


def test_an_open_profile_has_no_caps_and_says_so():
    ob = make('extrude', add(line((0, 0, 0), (1, 1, 0), (2, 0, 0)), "bow"))
    value = ob.data.splinewright.value
    ob.data.splinewright_parameters.extrude_caps = 'both'
    assert ob.data.splinewright.value == value and recipes.parameters(ob.data)['caps'] == 'none'


@pytest.mark.parametrize('kind', ('extrude', 'loft', 'revolve', 'sweep', 'two_rails', 'pipe'))
def test_older_files_have_neither_caps_nor_matched_corners(kind):
    recipe = recipes.RECIPES[kind]
    ob = make('loft', *rings(0, 1, 3)) if kind == 'loft' else make('extrude', add(CIRCLE, "profile"))
    group = ob.data[recipes.KEY]
    if recipe.kind != recipes.kind(ob.data):
        values = {parameter.name: parameter.default for parameter in recipe.parameters}
        assert values['caps'] == 'none'
        return
    for name in ('caps', 'match_corners', 'start', 'start_strength', 'end', 'end_strength'):
        if name in group['parameters'].keys():
            del group['parameters'][name]
    found = recipes.parameters(ob.data)
    assert found['caps'] == 'none' and found.get('match_corners', False) is False and found.get('start', 'free') == 'free'


def test_the_operator_closes_what_is_editable_and_sets_caps_of_what_follows():
    ob = make('extrude', add(LETTER, "E"), z=2.0)
    assert op(bpy.ops.splinewright.cap) == {'FINISHED'}
    assert recipes.parameters(ob.data)['caps'] == 'both'
    require_closed(ob, 22.0)
    other = make('extrude', add(CIRCLE.reversed(), "ring"), z=2.0)
    assert op(bpy.ops.splinewright.make_editable) == {'FINISHED'}
    before = open_edges(other)
    assert op(bpy.ops.splinewright.cap, ends='SHORTEST') == {'FINISHED'}
    assert open_edges(other) == before / 2
    assert op(bpy.ops.splinewright.cap) == {'FINISHED'}
    require_closed(other, 2 * math.pi)
    require_exact(other)
    with pytest.raises(RuntimeError, match="no open end"):
        bpy.ops.splinewright.cap()


def test_a_letter_is_capped_when_it_is_editable_too():
    ob = make('extrude', add(LETTER, "E"), z=2.0)
    assert op(bpy.ops.splinewright.make_editable) == {'FINISHED'}
    assert op(bpy.ops.splinewright.cap) == {'FINISHED'}
    require_closed(ob, 22.0)
    require_exact(ob)



def hull(x):
    points = [(x, 0, -1 + 0.1 * x), (x, 1 + 0.2 * x, -0.5), (x, 1.5, 1 + 0.3 * x)]
    at = np.r_[0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
    return add(sc.NurbsCurve(1, np.r_[0, at, at[-1]], points), f"frame {x}")


def test_the_chine_of_a_hull_is_one_edge():
    ob = make('loft', hull(0), hull(1), hull(2.5))
    value = ob.data.splinewright.value
    assert len(np.unique(value.knots[0])) == 3
    ob.data.splinewright_parameters.loft_match_corners = False
    assert len(np.unique(ob.data.splinewright.value.knots[0])) == 5


def test_sections_with_other_numbers_of_corners_are_named():
    ob = make('loft', hull(0), hull(1), add(line((3, 0, 0), (3, 1, 0.2), (3, 2, 0)), "smooth"))
    assert "corners are not matched" in recipes.read(ob.data).said and "none" in recipes.read(ob.data).said


def test_a_loft_closes_in_an_empty_and_is_round_there():
    tip = bpy.data.objects.new("tip", None)
    bpy.context.scene.collection.objects.link(tip)
    tip.location = (0, 0, 4)
    ob = make('loft', *rings(0, 1, 2), tip, caps='both', end='round')
    if recipes.read(ob.data).sources[0] == tip:
        ob.data.splinewright_parameters.loft_start = 'round'
        ob.data.splinewright_parameters.loft_end = 'free'
    require_closed(ob)
    assert [source.name for source in recipes.read(ob.data).sources].count("tip") == 1
    before = ob.data.splinewright.value
    tip.location.z = 5
    bpy.context.view_layer.update()
    assert ob.data.splinewright.value != before and not follow.problem(ob.data)


def test_a_loft_goes_on_from_a_surface_and_leaves_at_right_angles():
    tube = make('extrude', add(CIRCLE, "profile"), z=-2.0)
    ob = make('loft', *rings(1, 2), tube)
    names = [source.name for source in recipes.read(ob.data).sources]
    at = 'start' if names[0] == tube.name else 'end'
    assert names[0 if at == 'start' else -1] == tube.name
    assert recipes.parameters(ob.data)[at] == 'G1'
    other = 'end' if at == 'start' else 'start'
    setattr(ob.data.splinewright_parameters, f"loft_{other}", 'normal')
    assert recipes.parameters(ob.data)[other] == 'normal' and not follow.problem(ob.data)
    setattr(ob.data.splinewright_parameters, f"loft_{other}", 'round')
    assert recipes.parameters(ob.data)[other] == 'normal'


@pytest.mark.parametrize('curve, area', ((CIRCLE, math.pi), (SQUARE, 1.0), (LETTER, 11.0),
                                         (polygon((0, 0), (2, 1), (0, 2), (0.5, 1)), 1.5)))
def test_a_plane_curve_is_filled_without_a_fold(curve, area):
    ob = make('filling', add(curve, "outline"))
    assert sum(face.area for face in ob.data.polygons) == pytest.approx(area, rel=0.02)
    normals = np.array([face.normal for face in ob.data.polygons])
    assert (np.abs(normals[:, 2]) > 0.999).all() and abs(normals[:, 2].sum()) == pytest.approx(len(normals), rel=1e-3)


def test_an_arc_and_its_chord_are_filled():
    arc = add(CIRCLE.split(CIRCLE.domain[0] + 0.5 * (CIRCLE.domain[1] - CIRCLE.domain[0]))[0], "arc")
    start, end = arc.data.splinewright.value.evaluate(np.array(arc.data.splinewright.value.domain))
    ob = make('filling', arc, add(sc.NurbsCurve(1, [0, 0, 1, 1], [start, end]), "chord"))
    assert sum(face.area for face in ob.data.polygons) == pytest.approx(math.pi / 2, rel=0.02)


def test_a_curve_of_one_point_is_a_point():
    data = bpy.data.curves.new("dot", 'CURVE')
    data.dimensions = '3D'
    data.splines.new('POLY').points[0].co = (0, 0, 3, 1)
    dot = bpy.data.objects.new("dot", data)
    bpy.context.scene.collection.objects.link(dot)
    ob = make('loft', *rings(0, 1), dot, caps='both')
    require_closed(ob)
    top = np.array([vertex.co for vertex in ob.data.vertices]) @ np.array(ob.matrix_world)[:3, :3].T + np.array(ob.matrix_world)[:3, 3]
    assert top[:, 2].max() == pytest.approx(3.0, abs=1e-5)


def moved_ring(size, name):
    return add(CIRCLE.transformed(np.diag([size, size, size, 1.0])[:3]), name)


def test_a_profile_in_a_profile_makes_a_closed_body_with_a_hole():
    profile = add([CIRCLE.transformed(np.diag([2.0, 2.0, 2.0, 1.0])[:3]), SQUARE], "both")
    ob = make('extrude', profile, z=3.0)
    activate(ob)
    assert op(bpy.ops.splinewright.cap) == {'FINISHED'}
    require_exact(ob)
    require_closed(ob, 3.0 * (4 * math.pi - 1))
    for count in (3, 9):
        ob.data.splinewright.resolution_u = count
        bpy.context.view_layer.update()
        require_closed(ob)


def test_a_tube_with_an_inner_tube_is_closed():
    outer, inner = (make('extrude', moved_ring(size, f"ring {size}"), z=3.0) for size in (2.0, 1.0))
    activate(outer, inner)
    op(bpy.ops.splinewright.make_editable)
    assert op(bpy.ops.splinewright.join) == {'FINISHED'}
    ob = bpy.context.object
    assert op(bpy.ops.splinewright.cap) == {'FINISHED'}
    require_exact(ob)
    require_closed(ob, 9 * math.pi)
    with pytest.raises(RuntimeError, match="no open end"):
        op(bpy.ops.splinewright.cap)


def logo():
    """A disc with two letters' counters, a bolt hole and what lies in it."""
    outer = add(CIRCLE, "rim")
    outer.scale = (5, 5, 5)
    holes = [add(SQUARE, "counter"), add(polygon((-2, 0), (-1, 0), (-1.5, 2)).reversed(), "A"), add(CIRCLE, "bolt"), add(CIRCLE, "core")]
    holes[2].location.x, holes[3].location.x = 3.0, 3.0
    holes[3].scale = (0.4, 0.4, 0.4)
    bpy.context.view_layer.update()
    return [outer, *holes], math.pi * (25 - 1 + 0.16) - 2


def test_a_logo_with_several_holes_is_filled_plane_and_follows():
    curves, area = logo()
    ob = make('filling', *curves)
    assert ob.data.splinewright.value.area() == pytest.approx(area, rel=1e-9)
    require_exact(ob)
    curves[1].location.x = 0.5
    bpy.context.view_layer.update()
    assert not follow.problem(ob.data) and ob.data.splinewright.value.area() == pytest.approx(area, rel=1e-9)
    curves[1].location.x = 3.3
    bpy.context.view_layer.update()
    assert "cross or touch: what lies between them" in follow.problem(ob.data)


@pytest.mark.parametrize('is_editable', (False, True))
def test_a_plate_with_bolt_holes_is_capped_watertight(is_editable, tmp_path):
    plate = add([polygon((-4, -2), (4, -2), (4, 2), (-4, 2)), *(
        CIRCLE.transformed(np.array([[0.4, 0, 0, x], [0, 0.4, 0, y], [0, 0, 0.4, 0]])) for x in (-3, 0, 3) for y in (-1, 1))], "plate")
    ob = make('extrude', plate, z=1.0)
    if is_editable:
        assert op(bpy.ops.splinewright.make_editable) == {'FINISHED'}
    assert op(bpy.ops.splinewright.cap) == {'FINISHED'}
    require_closed(ob, 32 - 6 * 0.16 * math.pi)
    assert ob.data.splinewright.value.volume() == pytest.approx(32 - 6 * 0.16 * math.pi, rel=1e-9)
    require_exact(ob)
    name, value = ob.name, ob.data.splinewright.value
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "plate.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "plate.blend"))
    assert bpy.data.objects[name].data.splinewright.value == value
