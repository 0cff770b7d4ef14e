"""Surfaces made of surfaces, live: blends, matches, rounded edges, offsets, thick ones, longer ones, fillings of holes."""

import collections
import math

import bmesh
import bpy
import numpy as np
import pytest

from layouts import drawn
from shapes import activate, add, op, require_exact
from support import part, splinecore as sc

follow, recipes, sections_overlay = (part(name) for name in ('bridge.follow.follow', 'bridge.recipes.recipes', 'ui.sections_overlay'))
ARCH = sc.build.extrude(sc.build.polynomial_through([(0, 0, 0), (0, 0.5, 1), (0, 1, 1.2)]), (2, 0, 0))
FAR = sc.build.extrude(sc.build.polynomial_through([(0, 2, 1), (0, 2.5, 0.4), (0, 3, 0.2)]), (2, 0, 0))
FLOOR = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
WALL = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 0, 1))


def make(kind, *obs, **settings):
    activate(*obs)
    assert op(getattr(bpy.ops.splinewright, f"add_{kind}"), **settings) == {'FINISHED'}
    bpy.ops.ed.undo_push(message="add")
    return bpy.context.object


MADE = {
    'surface_blend': lambda: make('surface_blend', add(ARCH, "arch"), add(FAR, "far")),
    'matched': lambda: make('matched', add(ARCH, "arch"), add(FAR, "far"), continuity='G1'),
    'both matched': lambda: make('matched', add(ARCH, "arch"), add(FAR, "far"), continuity='G2', both=True),
    'rounded_edge': lambda: make('rounded_edge', add(FLOOR, "floor"), add(WALL, "wall"), radius=0.25, end_radius=0.25),
    'offset_surface': lambda: make('offset_surface', add(ARCH, "arch"), distance=0.1),
    'thickened': lambda: make('thickened', add(ARCH, "arch"), distance=0.1),
    'extended_surface': lambda: make('extended_surface', add(ARCH, "arch"), length=0.5),
}


@pytest.mark.parametrize('kind', MADE)
def test_it_is_exact_follows_its_surfaces_and_stays_so_in_a_file(kind, tmp_path):
    ob = MADE[kind]()
    name, value = ob.name, ob.data.splinewright.value
    assert ob.type == 'MESH' and recipes.read(ob.data).recipe.kind == kind.split()[-1]
    require_exact(ob)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "made.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "made.blend"))
    ob = bpy.data.objects[name]
    assert ob.data.splinewright.value == value
    for source in recipes.read(ob.data).sources:
        source.data.splinewright.value = source.data.splinewright.value.transformed(np.diag([1.5, 1.5, 1.5, 1.0]))
    bpy.context.view_layer.update()
    assert ob.data.splinewright.value != value and not follow.problem(ob.data)


@pytest.mark.parametrize('continuity, angle, bend', (('G1', 1e-9, math.inf), ('G2', 1e-9, 1e-7), ('G3', 1e-9, 1e-7)))
def test_a_blend_goes_on_from_both_sides_which_are_said(continuity, angle, bend):
    ob = make('surface_blend', add(ARCH, "arch"), add(FAR, "far"), continuity=continuity)
    made = ob.data.splinewright.value
    for patch, side, own in ((ARCH, 'u_end', 'v_start'), (FAR, 'u_start', 'v_end')):
        found = sc.seam_continuity(patch, side, made, own)
        assert found.gap < 1e-12 and found.angle < angle and found.curvature_difference < bend
    assert "angle 0°" in recipes.read(ob.data).said


def test_a_rounded_edge_is_of_three_patches_and_its_radius_that_of_the_ball():
    ob = MADE['rounded_edge']()
    fillet = ob.data.splinewright.value[1]
    points = np.array([fillet.evaluate(u, v) for u in np.linspace(*fillet.domain[0], 7) for v in np.linspace(*fillet.domain[1], 7)])
    assert np.abs(np.hypot(points[:, 1] - 0.25, points[:, 2] - 0.25) - 0.25).max() < 1e-4


def test_a_thick_surface_is_closed():
    ob = MADE['thickened']()
    assert ob.data.splinewright.value.volume() > 0


def test_a_hole_between_surfaces_is_filled_and_goes_on_from_them():
    """A plane in four pieces about a square hole: the filling is the plane."""
    obs = [add(sc.build.plane((x, y, 0), (wide, 0, 0), (0, high, 0)), f"{x}, {y}") for (x, y), (wide, high) in
           (((0, -1), (1, 1)), ((0, 1), (1, 1)), ((-1, 0), (1, 1)), ((1, 0), (1, 1)))]
    ob = make('filling', *obs)
    patch = ob.data.splinewright.value
    points = patch.evaluate_grid(np.linspace(*patch.domain[0], 9), np.linspace(*patch.domain[1], 9)).reshape(-1, 3)
    assert np.abs(points[:, 2]).max() < 1e-9 and np.abs(patch.area() - 1.0) < 1e-9
    assert recipes.read(ob.data).said == "4 sides, angle 0° to them"


@pytest.mark.parametrize('continuity', ('G1', 'G2'))
def test_two_surfaces_along_one_side_of_a_hole(continuity):
    """They are one side: the filling is one patch, and it follows either."""
    places = (((0, -1), (0.4, 1)), ((0.4, -1), (0.6, 1)), ((0, 1), (1, 1)), ((-1, 0), (1, 1)), ((1, 0), (1, 1)))
    obs = [add(sc.build.plane((x, y, 0), (wide, 0, 0), (0, high, 0)), f"{x}, {y}") for (x, y), (wide, high) in places]
    ob = make('filling', *obs, continuity=continuity)
    patch = ob.data.splinewright.value
    assert not isinstance(patch, sc.PatchSet) and abs(patch.area() - 1.0) < 1e-9
    assert recipes.read(ob.data).said.startswith("5 sides, angle 0° to them")

    for one in obs:
        one.location.z = 0.5
    bpy.context.view_layer.update()
    points = corners_of(ob)
    assert np.abs(points[:, 2] - 0.5).max() < 1e-6


@pytest.mark.parametrize('continuity, bulge', (('G1', 1e-6), ('G2', 0.01)))
def test_a_round_hole_is_closed_and_follows(continuity, bulge):
    """A cup of four walls, whose bottom is the shorter way round: a disc goes on from them there; as they bend, with G2."""
    wall = sc.BezierCurve([(0.5, 0, -1), (1, 0, -1), (1, 0, 0)])
    obs = [add(sc.build.revolve(wall, (0, 0, 0), (0, 0, 1), i * math.pi / 2, math.pi / 2), f"wall {i}") for i in range(4)]
    ob = make('filling', *obs, continuity=continuity)
    assert len(ob.data.splinewright.value) == 4
    points = corners_of(ob)
    assert np.abs(points[:, 2] + 1).max() < bulge and np.hypot(points[:, 0], points[:, 1]).max() < 0.5 + 1e-6
    said = "4 sides, angle 0° to them, 0° inside"
    assert recipes.read(ob.data).said.startswith(said) and (recipes.read(ob.data).said == said) == (continuity == 'G1')
    rim = [key for key, count in faces_at_edges(ob.data).items() if count == 1]
    assert np.abs(np.hypot(*points[np.unique(rim)][:, :2].T) - 0.5).max() < 1e-6

    for wall_ob in obs:
        wall_ob.location.z = 0.5
    bpy.context.view_layer.update()
    assert np.abs(corners_of(ob) - points - (0, 0, 0.5)).max() < 1e-6


def test_surfaces_that_a_filling_goes_on_from_have_their_numbers_in_the_view():
    obs = [add(sc.build.plane((x, y, 0), (wide, 0, 0), (0, high, 0)), f"{x}, {y}") for (x, y), (wide, high) in
           (((0, -1), (1, 1)), ((0, 1), (1, 1)), ((-1, 0), (1, 1)))]
    ob = make('filling', *obs, add(sc.BezierCurve([(1, 0, 0), (1, 1, 0)]), "line"))
    seen = {tuple(np.round(one.foot, 6)): one for one in sections_overlay.shown(ob)}
    assert sorted(one.number for one in seen.values()) == [1, 2, 3, 4]
    assert set(seen) == {(0.5, -0.5, 0.0), (0.5, 1.5, 0.0), (-0.5, 0.5, 0.0), (1.0, 0.0, 0.0)}
    assert [tuple(place) for place, one in seen.items() if not np.array_equal(one.foot, one.head)] == [(1.0, 0.0, 0.0)]


def corners_of(ob):
    return np.array([vertex.co for vertex in ob.data.vertices])


def faces_at_edges(mesh):
    return collections.Counter(key for face in mesh.polygons for key in face.edge_keys)


@pytest.mark.parametrize('kind, make_obs, settings, message', (
    ('offset_surface', lambda: (add(sc.build.sphere((0, 0, 0), 1.0)),), {'distance': -1.0}, "radius"),
    ('rounded_edge', lambda: (add(FLOOR), add(FAR)), {}, "edge"),
    ('thickened', lambda: (add(ARCH),), {'distance': 0.0}, "no thickness"),
    ('filling', lambda: (add(FLOOR), add(FAR)), {}, "hole of three to eight"),
))
def test_what_cannot_be_made_is_said_and_nothing_is_left(kind, make_obs, settings, message):
    obs = make_obs()
    activate(*obs)
    with pytest.raises(RuntimeError, match=message):
        op(getattr(bpy.ops.splinewright, f"add_{kind}"), **settings)
    assert len(bpy.data.objects) == len(obs)


def mesh_of(primitive, **settings):
    getattr(bpy.ops.mesh, f"primitive_{primitive}_add")(**settings)
    return bpy.context.object


def test_a_cube_becomes_the_surface_to_which_it_is_subdivided_and_follows_it():
    """Blender's own Subdivision Surface modifier has the limit's points at its vertices, within single precision."""
    cube = mesh_of('cube')
    ob = make('of_mesh', cube)
    value = ob.data.splinewright.value
    modifier = cube.modifiers.new("", 'SUBSURF')
    modifier.levels, modifier.use_limit_surface = 3, True
    limit = cube.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    points = np.array([vertex.co for vertex in limit.vertices])
    nearest = np.min([patch.nearest(points).distances for patch in value], axis=0)
    assert len(value) == 24 and nearest.max() < 2e-3
    for vertex in cube.data.vertices:
        vertex.co.z += 1.0
    cube.data.update()
    bpy.context.view_layer.update()
    assert ob.data.splinewright.value != value and not follow.problem(ob.data)
    require_exact(ob)


def crease(mesh, of):
    """The first edge or vertex of a mesh."""
    if part('bridge.data.versions').marks_are_attributes:
        mesh.attributes.new(f"crease_{of}", 'FLOAT', 'EDGE' if of == 'edge' else 'POINT').data[0].value = 1.0
        return
    bm = bmesh.new()
    bm.from_mesh(mesh)
    items = bm.edges if of == 'edge' else bm.verts
    layer = items.layers.crease.verify()
    items.ensure_lookup_table()
    items[0][layer] = 1.0
    bm.to_mesh(mesh)
    bm.free()


@pytest.mark.parametrize('of', ('edge', 'vert'))
def test_creases_are_no_corners_and_that_is_said(of):
    smooth = make('of_mesh', mesh_of('cube'))
    assert "crease" not in recipes.read(smooth.data).said
    cube = mesh_of('cube')
    crease(cube.data, of)
    creased = make('of_mesh', cube)
    assert "creases count as smooth" in recipes.read(creased.data).said
    assert all(np.array_equal(a.points, b.points)
               for a, b in zip(smooth.data.splinewright.value, creased.data.splinewright.value))


def test_a_grid_is_one_surface_of_regular_patches_and_a_mesh_without_faces_none():
    ob = make('of_mesh', mesh_of('grid', x_subdivisions=4, y_subdivisions=3))
    assert recipes.read(ob.data).said == "12 patches"
    mesh = bpy.data.meshes.new("edge")
    mesh.from_pydata([(0, 0, 0), (1, 0, 0)], [(0, 1)], [])
    other = bpy.data.objects.new("edge", mesh)
    bpy.context.collection.objects.link(other)
    activate(other)
    with pytest.raises(RuntimeError, match="no face"):
        op(bpy.ops.splinewright.add_of_mesh)


def test_the_panel_of_what_is_made_of_a_mesh_says_what_it_does_not_follow():
    bpy.ops.mesh.primitive_monkey_add()
    mesh = bpy.context.object
    mesh.modifiers.new("Bend", 'SIMPLE_DEFORM')
    assert op(bpy.ops.splinewright.add_of_mesh) == {'FINISHED'}
    said = drawn()
    assert "Follows Suzanne" in said and "Not followed: the modifier Bend" in said
    assert "Apply Construction" in said and "Kind" in said


def polygon(corners, radius=1.0, start=0.0):
    angles = start + 2 * np.pi * np.arange(corners + 1) / corners
    return sc.build.contour(np.c_[radius * np.cos(angles), radius * np.sin(angles), 0 * angles][:-1], closed=True)


def turned(curve, at):
    """A closed curve that begins elsewhere."""
    head, tail = curve.to_nurbs().split(at)
    return sc.build.join_curves([tail, head], 1e-9)[0]


FLAT = {
    'circle': (sc.conics.circle((0, 0, 0), 1.0), np.pi), 'ellipse': (sc.conics.ellipse((0, 0, 0), (2, 0, 0), (0, 0.5, 0)), np.pi),
    **{f"{n} corners": (polygon(n), 0.5 * n * np.sin(2 * np.pi / n)) for n in range(3, 9)},
    'begins elsewhere': (turned(polygon(5), 0.37), 2.5 * np.sin(2 * np.pi / 5)),
    'half a disc': (sc.build.join_curves([sc.conics.arc((0, 0, 0), (1, 0, 0), (0, 1, 0), 0.0, np.pi),
                                          sc.BezierCurve([(-1, 0, 0), (1, 0, 0)])], 1e-9)[0], np.pi / 2),
}


@pytest.mark.parametrize('name', FLAT)
def test_one_closed_curve_in_a_plane_is_filled_flat(name):
    curve, area = FLAT[name]
    ob = make('filling', add(curve))
    value = ob.data.splinewright.value
    patches = list(value) if hasattr(value, '__len__') else [value]
    assert abs(sum(patch.area(tolerance=1e-9) for patch in patches) - area) < 1e-3 * area
    points = corners_of(ob)
    assert np.abs(points[:, 2]).max() < 1e-7
    normals = np.concatenate([patch.evaluate_grid_with_normals(*(np.linspace(*d, 9)[1:-1] for d in patch.domain))[1].reshape(-1, 3)
                              for patch in patches])
    assert (normals[:, 2] > 0.9).all() or (normals[:, 2] < -0.9).all()
    require_exact(ob)


def test_a_polygon_of_nine_corners_is_filled_and_an_open_curve_is_refused():
    ob = make('filling', add(polygon(9)))
    area = sum(face.area for face in ob.data.polygons)
    assert area == pytest.approx(4.5 * math.sin(2 * math.pi / 9), rel=1e-5)
    with pytest.raises(RuntimeError, match="not a closed curve and has no closed side"):
        make('filling', add(sc.BezierCurve([(0, 0, 0), (1, 2, 0), (2, 0, 0)])))


@pytest.mark.parametrize('continuity', ('G0', 'G1'))
@pytest.mark.parametrize('other', (False, True))
def test_the_open_end_of_a_tube_is_filled(continuity, other):
    wall = sc.BezierCurve([(0.5, 0, 0), (1.5, 0, 1), (1, 0, 2)])
    tube = sc.build.revolve(wall, (0, 0, 0), (0, 0, 1))
    source = add(tube, "tube")
    ob = make('filling', source, continuity=continuity, other=other)
    points = corners_of(ob)
    radius, height = (1.0, 2.0) if other else (0.5, 0.0)
    rim = np.unique([key for key, count in faces_at_edges(ob.data).items() if count == 1])
    assert np.abs(np.hypot(*points[rim][:, :2].T) - radius).max() < 2e-4 and np.abs(points[rim][:, 2] - height).max() < 2e-4
    source.location.z = 3.0
    bpy.context.view_layer.update()
    assert np.abs(corners_of(ob) - points - (0, 0, 3)).max() < 1e-5


@pytest.mark.parametrize('both', (False, True))
def test_what_is_matched_hides_what_it_lies_on(both):
    """The surface that it is matched to stays beside it, unless it lies in the result, too."""
    arch, far = add(ARCH, "arch"), add(FAR, "far")
    make('matched', arch, far, continuity='G1', both=both)
    assert arch.hide_get() and far.hide_get() == both
