"""What the switches in the Overlays popover show, against closed forms, and kept until the shape changes."""

import bpy
import numpy as np
import pytest

from layouts import drawn_by
from shapes import KINDS, VALUES, activate, add, enter, leave, move, select
from support import part, splinecore as sc

combs, definitions, faces, frames, lines, overlay, paint, panel, polygon, seen, store = (part(name) for name in (
    'core.analysis.combs', 'core.shape.definition', 'core.analysis.faces', 'core.analysis.frames', 'core.analysis.lines',
    'ui.analysis_overlay', 'ui.surface_paint', 'ui.analysis_panel', 'core.analysis.polygon', 'bridge.analysis.overlays',
    'bridge.data.store'))
FLAT = sc.NurbsPatch((2, 1), ([0, 0, 0, 1, 3, 3, 3], [0, 0, 1, 1]),
                     [[(x, y, 0) for y in (0, 4)] for x in (0, 0.5, 2, 3)])


def polygon_of(value):
    return polygon.of(definitions.from_value(value))


def quarter():
    """Of a circle of radius 2."""
    return sc.BezierCurve([(2, 0), (2, 2), (0, 2)], [1, np.sqrt(0.5), 1])


@pytest.fixture
def chosen():
    """The switches, all off again in the end."""
    yield bpy.context.scene.splinewright_sights
    found = bpy.context.scene.splinewright_sights  # another file may be open
    for name in found.bl_rna.properties.keys():
        if name not in ('rna_type', 'name'):
            found.property_unset(name)


def test_the_polygon_of_a_curve_leads_from_point_to_point():
    points = np.array(VALUES['quintic']().points)
    found = polygon_of(sc.BezierCurve(points))
    assert np.array_equal(found.rows[0], np.stack([points[:-1], points[1:]], 1)) and not len(found.rows[1])
    assert np.array_equal(found.points, points) and not found.arrows


def test_that_of_a_plain_cubic_has_its_middle_leg_though_its_net_has_handles():
    points = np.array(VALUES['cubic']().points)
    found = polygon_of(sc.BezierCurve(points))
    assert np.array_equal(found.rows[0], np.stack([points[:-1], points[1:]], 1))
    assert np.array_equal(found.points, points)


def test_that_of_a_periodic_curve_closes():
    points = np.array(VALUES['periodic']().points)
    found = polygon_of(VALUES['periodic']().with_points(points))
    wanted = np.stack([points, np.roll(points, -1, 0)], 1)
    assert np.array_equal(found.rows[0], wanted)


def test_a_hermite_chain_has_its_handles_and_no_legs_between_them():
    chain = sc.HermiteCurve([(0, 0), (3, 0)], [(3, 3), (3, -3)])
    found = polygon_of(chain)
    assert {tuple(map(tuple, pair[:, :2].round(12))) for pair in found.rows[0]} == {
        ((0, 0), (1, 1)), ((2, 1), (3, 0)), ((-1, -1), (0, 0)), ((3, 0), (4, -1))}


def test_a_point_at_infinity_is_an_arrow_and_no_point():
    found = polygon_of(VALUES['semicircle']())
    assert len(found.points) == 2 and np.allclose(found.rows[0], [[(1, 0, 0), (-1, 0, 0)]])
    (foot, head), = found.arrows
    assert np.allclose(foot, 0) and np.allclose(head, (0, 1, 0))


def test_the_net_of_a_patch_has_its_rows_each_way():
    found = polygon_of(FLAT)
    assert len(found.points) == 8 and [len(pairs) for pairs in found.rows] == [6, 4]
    for pairs, other in zip(found.rows, (1, 0)):
        assert (pairs[:, 0, other] == pairs[:, 1, other]).all()


def test_the_curve_itself_lies_on_its_circle_however_coarse_it_is_shown():
    found = lines.curves([quarter()], 1, 10.0, None)
    assert len(found) >= 32 and np.abs(np.linalg.norm(found, axis=-1) - 2).max() < 1e-14
    assert np.linalg.norm(found[:, 1] - found[:, 0], axis=1).max() < 0.5


def test_knots_of_a_curve_are_marked_at_its_ends_and_where_spans_meet():
    curve = sc.NurbsCurve(1, [0, 0, 1, 3, 3], [(0, 0), (1, 5), (3, 0)])
    assert np.array_equal(lines.knots_of_curves([curve]), [(0, 0, 0), (1, 5, 0), (3, 0, 0)])
    double = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), (1, 0), (2, 0), (3, 1), (4, 4)])
    assert len(lines.knots_of_curves([double])) == 3


def test_knots_and_isocurves_of_a_patch_lie_where_they_should():
    knots = lines.knots_of_patches([FLAT])
    along_v = knots[knots[:, 0, 0] == knots[:, 1, 0]]
    assert np.unique(along_v[:, :, 0]).round(12).tolist() == [0, float(FLAT.evaluate(1, 0)[0].round(12)), 3]
    assert np.unique(knots[knots[:, 0, 1] == knots[:, 1, 1]][:, :, 1].round(12)).tolist() == [0, 4]
    found = lines.isocurves([FLAT], 3)
    wanted = FLAT.evaluate(np.array([0.25, 0.5, 0.75, 1.5, 2, 2.5]), 0.0)[:, 0]
    assert np.allclose(np.unique(found[found[:, 0, 0] == found[:, 1, 0]][:, :, 0].round(12)), wanted)
    assert np.unique(found[found[:, 0, 1] == found[:, 1, 1]][:, :, 1].round(12)).tolist() == [1, 2, 3]


def test_lines_stop_at_poles_and_never_cross_infinity():
    sphere = sc.build.sphere((0, 0, 0), 2.0)
    for found in (lines.knots_of_patches([sphere]), lines.isocurves([sphere], 4)):
        assert np.abs(np.linalg.norm(found, axis=-1) - 2).max() < 1e-13
        assert (np.linalg.norm(found[:, 1] - found[:, 0], axis=1) > 0).all()
    through = lines.curves([sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, -2, 1])], 4, 10.0, None)
    assert np.isfinite(through).all() and np.linalg.norm(through[:, 1] - through[:, 0], axis=1).max() < 10


def test_the_comb_of_a_circle_is_a_circle():
    found = combs.of([quarter()], 10, 3.0)
    assert len(found.teeth) == 11 and len(found.back) == 10
    assert np.abs(np.linalg.norm(found.teeth[:, 0], axis=1) - 2).max() < 1e-14
    assert np.abs(found.teeth[:, 1] - found.teeth[:, 0] * (2 + 3 / 2) / 2).max() < 1e-13
    assert np.array_equal(found.back, np.stack([found.teeth[:-1, 1], found.teeth[1:, 1]], 1))


def test_the_comb_of_a_parabola_has_its_curvature():
    found = combs.of([sc.BezierCurve([(-1, 1), (0, -1), (1, 1)])], 8, 1.0)      # y = x²
    x = found.teeth[:, 0, 0]
    lengths = np.linalg.norm(found.teeth[:, 1] - found.teeth[:, 0], axis=1)
    assert np.allclose(lengths, 2 / (1 + 4 * x * x) ** 1.5, atol=1e-13)
    assert (found.teeth[1:-1, 1, 1] < found.teeth[1:-1, 0, 1]).all()


def test_where_curvature_jumps_there_are_two_teeth_and_the_back_is_open():
    chain = sc.HermiteCurve([(0, 0), (1, 0), (2, 0)], [(1, 0), (1, 1), (1, 0)])
    found = combs.of([chain], 4, 1.0)
    assert len(found.teeth) == 10 and len(found.back) == 8
    before, after = found.teeth[4], found.teeth[5]
    assert np.allclose(before[0], after[0]) and not np.allclose(before[1], after[1])
    assert np.allclose(np.linalg.norm(before[1] - before[0]), chain.curvature(1.0, side='left'))
    assert np.allclose(np.linalg.norm(after[1] - after[0]), chain.curvature(1.0))


def test_where_nothing_moves_or_all_is_infinite_the_comb_has_no_tooth():
    cusp = combs.of([sc.BezierCurve([(0, 0), (0, 0), (1, 1)])], 4, 1.0)
    assert len(cusp.teeth) == 4 and np.isfinite(cusp.back).all()
    through = combs.of([sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, -1, 1])], 4, 1.0)
    assert 2 <= len(through.teeth) < 5
    assert len(combs.of([sc.BezierCurve([(0, 0), (1, 1)])], 4, 1.0).back) == 4


def test_the_osculating_circle_of_a_circle_is_that_circle():
    found = frames.frames([quarter()], 0.3, 0.7)
    assert np.abs(np.linalg.norm(found.circles, axis=-1) - 2).max() < 1e-13 and len(found.circles) == 128
    tangent, normal, binormal = (pairs[0] for pairs in found.axes)
    assert np.allclose(tangent[0], quarter().evaluate(0.3)) and np.allclose(normal[1], normal[0] * (2 - 0.7) / 2)
    assert np.allclose(binormal[1] - binormal[0], (0, 0, 0.7))
    assert (tangent[1] - tangent[0]) @ normal[0] == pytest.approx(0)


def test_a_straight_curve_has_a_tangent_and_no_circle_and_a_halt_has_none():
    line = frames.frames([sc.BezierCurve([(0, 0), (2, 0)])], 0.5, 1.0)
    assert np.allclose(line.axes[0], [[(1, 0, 0), (2, 0, 0)]]) and not len(line.axes[1]) and not len(line.circles)
    assert not any(map(len, frames.frames([sc.BezierCurve([(0, 0), (0, 0), (1, 1)])], 0.0, 1.0).axes))


def test_the_hodograph_of_a_parabola_is_a_line_and_of_a_chain_it_jumps():
    found = frames.hodographs([sc.BezierCurve([(-1, 1), (0, -1), (1, 1)])], 0.75, 0.5)      # x = 2 t - 1, y = x²
    assert np.allclose(found.lines[:, :, 0], 1) and np.allclose(found.lines[[0, -1], [0, 1], 1], (-2, 2))
    assert np.allclose(found.arrows, [[(0, 0, 0), (1, 1, 0)]])
    chain = sc.HermiteCurve([(0, 0), (1, 0), (2, 0)], [[(1, 0), (1, 0)], [(1, 1), (1, -1)], [(1, 0), (1, 0)]])
    lines_ = frames.hodographs([chain], 0.0, 1.0).lines
    assert len(lines_) == 64 and np.allclose(lines_[31, 1], (1, 1, 0)) and np.allclose(lines_[32, 0], (1, -1, 0))


def test_normals_of_a_sphere_point_away_from_its_middle():
    found = lines.normals([sc.build.sphere((0, 0, 0), 2.0)], 3, 0.5)
    assert np.abs(found[:, 1] - found[:, 0] * 2.5 / 2).max() < 1e-12 and len(found) > 50


def faces_of(patch, resolution, value=None):
    patch_set = sc.PatchSet.from_patches([patch])
    tessellation = sc.Tessellation(patch_set, resolution)
    return faces.colored(tessellation, patch_set, value) if value else faces.shaded(tessellation, patch_set)


@pytest.mark.parametrize('value, wanted', (('GAUSS', 0.25), ('MEAN', -0.5), ('LARGEST', -0.5), ('SMALLEST', -0.5)))
def test_a_sphere_has_one_curvature_everywhere_its_poles_too(value, wanted):
    found = faces_of(sc.build.sphere((0, 0, 0), 2.0), (6, 5), value)
    assert len(found.values) and np.abs(found.values - wanted).max() < 1e-5


def test_a_cylinder_has_its_principal_curvatures_and_a_torus_both_signs():
    cylinder = sc.build.cylinder((0, 0, 0), (0, 0, 1), 0.5, 1.0)
    assert np.abs(faces_of(cylinder, 4, 'GAUSS').values).max() < 1e-5
    both = [np.abs(faces_of(cylinder, 4, value).values) for value in ('LARGEST', 'SMALLEST')]
    assert np.allclose(np.sort([both[0].max(), both[1].max()]), [0, 2], atol=1e-5)
    torus = faces_of(sc.build.torus((0, 0, 0), (0, 0, 1), 3.0, 1.0), 8, 'GAUSS')
    radius = np.linalg.norm(torus.positions[:, :2], axis=1)
    assert np.allclose(torus.values, (radius - 3) / radius, atol=2e-4)      # cos θ / (r (R + r cos θ))


def test_at_a_knot_each_side_has_its_own_curvature():
    patch = sc.NurbsPatch((2, 1), ([0, 0, 0, 1, 2, 2, 2], [0, 0, 1, 1]),
                          [[(x, y, z) for y in (0, 1)] for x, z in ((0, 0), (0.5, 0), (1.5, 0), (2, 1))])
    found = faces_of(patch, 4, 'LARGEST' if patch.curvatures(1.5, 0.5).mean > 0 else 'SMALLEST')
    there = np.abs(found.values[np.abs(found.positions[:, 0] - 1) < 1e-6])
    sides = [np.abs(patch.curvatures(1.0, 0.5, side=(side, 'right')).principal).max() for side in ('left', 'right')]
    assert sides[0] < 1e-12 < 1.9 < sides[1]
    assert np.minimum(np.abs(there - sides[0]), np.abs(there - sides[1])).max() < 1e-2
    assert (there < 0.1).any() and (there > 1.9).any()


def test_normals_are_exact_inside_of_large_faces_too():
    """On z = x² + y², where the parameters are x and y."""
    found = faces_of(sc.BezierPatch([[(u, v, (u == 1) + (v == 1)) for v in (0, 0.5, 1)] for u in (0, 0.5, 1)]), 2)
    assert len(found.triangles) == 8 * 36
    x, y, z = found.positions.T.astype(np.float64)
    wanted = np.stack([-2 * x, -2 * y, np.ones(len(x))], 1)
    assert np.abs(found.normals - wanted / np.linalg.norm(wanted, axis=1, keepdims=True)).max() < 1e-6
    assert (z - x * x - y * y).max() > 0.02         # places lie on the faces, where Blender draws them


def test_poles_and_points_around_them_have_normals():
    found = faces_of(sc.build.sphere((0, 0, 0), 2.0), (5, 3))
    along = found.positions / np.linalg.norm(found.positions, axis=1, keepdims=True)
    assert np.isfinite(found.normals).all() and (along * found.normals).sum(1).min() > 0.95
    is_pole = np.abs(found.positions[:, 2]) > 2 - 1e-6
    assert is_pole.any() and np.allclose(found.normals[is_pole], along[is_pole], atol=1e-5)


def test_at_a_crease_each_side_has_its_own_normals():
    folded = sc.NurbsPatch((1, 1), ([0, 0, 1, 2, 2], [0, 0, 1, 1]),
                           [[(x, y, z) for y in (0, 1)] for x, z in ((0, 0), (1, 0), (1, 1))])
    found = faces_of(folded, 2)
    flat = found.positions[:, 2] == 0
    flat_faces = found.triangles[flat[found.triangles].all(1)]
    assert len(flat_faces) and np.allclose(np.abs(found.normals[flat_faces]), (0, 0, 1))
    upright = found.triangles[(found.positions[:, 0] == 1)[found.triangles].all(1)]
    assert len(upright) and np.allclose(np.abs(found.normals[upright]), (1, 0, 0))


def test_half_of_a_cylinder_and_a_plane_have_the_range_of_what_is_larger_on_a_tenth():
    cylinder = faces_of(sc.build.cylinder((0, 0, 0), (0, 0, 1), 0.5, 1.0), 4, 'MEAN')
    assert faces.reach(cylinder) == pytest.approx(1, abs=1e-5)
    few = cylinder.values.copy()
    few[0] = 50.0
    assert faces.reach(cylinder._replace(values=few)) == pytest.approx(1, abs=1e-5)
    assert faces.reach(cylinder._replace(values=np.full_like(few, np.nan))) == 0.0


def test_small_faces_are_whole_and_have_the_normals_of_the_mesh():
    patch = VALUES['nurbs patch']()
    patch_set = sc.PatchSet.from_patches([patch])
    tessellation = sc.Tessellation(patch_set, 40)
    positions, normals = tessellation.evaluate(patch_set)
    found = faces.shaded(tessellation, patch_set)
    corners = tessellation.corner_vertices.reshape(-1, 4)
    wanted = positions[np.stack([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]], 1).reshape(-1, 3)]
    assert np.array_equal(found.positions[found.triangles], wanted)
    slots = np.arange(corners.size).reshape(-1, 4)
    slots = np.stack([slots[:, [0, 1, 2]], slots[:, [0, 2, 3]]], 1).reshape(-1, 3)
    assert np.array_equal(found.normals[found.triangles], normals[slots])
    assert len(found.positions) < corners.size


def test_numbers_of_the_legend_are_short():
    assert [paint.text_of(number) for number in (-0.0, -0.125, 1 / 3, 12345.6)] == ["0", "-0.125", "0.333", "1.23e+04"]


@pytest.mark.parametrize('name', KINDS)
def test_every_kind_of_shape_has_its_sights(name):
    ob = add(VALUES[name]())
    found = seen.kept(ob.data, 'polygon', (), seen.polygon_of)
    assert len(found.points) and all(np.isfinite(pairs).all() for pairs in found.rows)
    assert len(seen.knots_of(ob.data))
    drawn = seen.curves_of(ob.data) if ob.type == 'CURVE' else seen.isocurves_of(ob.data, 2)
    assert len(drawn) and np.isfinite(drawn).all()
    scale = seen.axes_of(ob.data)
    assert len(scale.grid) and len(scale.labels) > 4 and np.isfinite(scale.lines).all()
    if ob.type == 'MESH':
        painted = seen.faces_of(ob.data, 'GAUSS')
        assert np.isfinite(painted.positions).all() and painted.triangles.max() == len(painted.values) - 1


def test_what_is_seen_is_worked_out_once_until_the_shape_changes():
    ob, made = add(VALUES['nurbs patch']()), []

    def make(data, number):
        made.append(number)
        return number
    for number in (1, 1, 2, 2):
        assert seen.kept(ob.data, 'thing', (number,), make) == number
    assert made == [1, 2]
    held = enter()
    select(held, 3)
    seen.kept(ob.data, 'thing', (2,), make)
    known = len(made)
    move(0, 0, 1)                       # every step of a drag comes this way
    seen.kept(ob.data, 'thing', (2,), make)
    assert len(made) == known + 1
    leave()
    seen.kept(ob.data, 'thing', (2,), make)
    known = len(made)
    bpy.ops.ed.undo()
    ob = bpy.data.objects["shape"]
    seen.kept(ob.data, 'thing', (2,), make)
    assert len(made) == known + 1
    ob.data.splinewright.value = ob.data.splinewright.value.elevate('u')     # the mesh may stay as it is in every bit
    seen.kept(ob.data, 'thing', (2,), make)
    assert len(made) == known + 2


def test_another_shape_that_takes_the_name_has_sights_of_its_own():
    one, other = add(VALUES['bezier patch'](), "one"), add(VALUES['nurbs patch'](), "other")
    assert len(seen.kept(one.data, 'polygon', (), seen.polygon_of).points) == 12
    one.data.name, other.data.name = "away", "one"
    assert len(seen.kept(other.data, 'polygon', (), seen.polygon_of).points) == 24


def test_a_damaged_shape_shows_nothing_and_raises_nothing():
    ob = add(VALUES['bezier patch']())
    ob.data[store.KEY]['structure'] = "no"
    assert seen.kept(ob.data, 'polygon', (), seen.polygon_of) is None
    assert all(part('ui.analysis_lines').prepared(sight, ob.data, bpy.context.scene.splinewright_sights) == ()
               for sight in part('ui.analysis_lines').SIGHTS)


def test_shapes_in_hand_are_the_selected_ones_and_that_whose_net_is_out():
    one, other = add(VALUES['bezier patch'](), "one"), add(VALUES['nurbs'](), "other")
    assert overlay.active_shapes(bpy.context) == [other]
    one.select_set(True)
    assert set(overlay.active_shapes(bpy.context)) == {one, other}
    other.hide_set(True)
    assert overlay.active_shapes(bpy.context) == [one]
    other.hide_set(False)
    bpy.context.view_layer.objects.active = one
    other.select_set(False)
    enter()
    assert overlay.active_shapes(bpy.context) == [one]
    leave()


def test_switches_are_off_until_wanted_and_kept_with_the_file(chosen, tmp_path):
    switches = [known.identifier for known in chosen.bl_rna.properties if known.type == 'BOOLEAN']
    assert switches and not any(getattr(chosen, name) for name in switches)
    for name in switches:
        assert chosen.bl_rna.properties[name].description
        setattr(chosen, name, True)
    chosen.isocurve_count = 7
    add(VALUES['bezier patch']())
    path = str(tmp_path / "kept.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path, copy=True)
    bpy.ops.wm.open_mainfile(filepath=path)
    found = bpy.context.scene.splinewright_sights
    assert all(getattr(found, name) for name in switches) and found.isocurve_count == 7


def changed_value(prop):
    """Another value than the default one."""
    if prop.type == 'ENUM':
        return prop.enum_items[-1].identifier
    if prop.type == 'POINTER':
        return bpy.data.objects["shape"]
    if getattr(prop, 'is_array', False):
        return (1.0, 0.0, 0.0)
    return {'BOOLEAN': True, 'INT': prop.default + 1 if prop.type == 'INT' else 0,
            'FLOAT': 0.75 if prop.type == 'FLOAT' else 0}[prop.type]


def test_every_number_beside_a_switch_is_kept_with_the_file_too(chosen, tmp_path):
    add(VALUES['bezier patch']())
    wanted = {known.identifier: changed_value(known) for known in chosen.bl_rna.properties
              if known.identifier not in ('rna_type', 'name')}
    for name, value in wanted.items():
        setattr(chosen, name, value)
    wanted['deviation_object'] = "shape"
    path = str(tmp_path / "kept.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path, copy=True)
    bpy.ops.wm.open_mainfile(filepath=path)
    found = bpy.context.scene.splinewright_sights
    for name, value in wanted.items():
        known = getattr(found, name)
        known = known.name if name == 'deviation_object' else known
        assert tuple(known) == value if isinstance(value, tuple) else known == value, name


def test_points_behind_are_shown_only_when_asked_for(chosen):
    add(VALUES['nurbs patch']())
    held = enter()
    assert not held.show_in_front
    chosen.points_behind = True
    assert held.show_in_front
    leave()
    assert enter().show_in_front
    leave()


def test_the_popover_has_every_switch(chosen):
    """Those of what is selected; on as many rows as Blender leaves on a usual screen."""
    switches = {known.identifier for known in chosen.bl_rna.properties if known.type == 'BOOLEAN'}
    of_one = {}
    for kind in ('nurbs', 'nurbs patch'):
        of_one[kind] = add(VALUES[kind](), kind)
        activate(of_one[kind])
        drawn = drawn_by(panel.SPLINEWRIGHT_PT_sights, bpy.context).props
        assert len(drawn) <= 12 and ("comb" in drawn) == (kind == 'nurbs') and ("stripes" in drawn) == (kind == 'nurbs patch')
    activate(*of_one.values())
    assert panel.SPLINEWRIGHT_PT_sights.poll(bpy.context)
    assert set(drawn_by(panel.SPLINEWRIGHT_PT_sights, bpy.context).props) == switches
    bpy.context.view_layer.objects.active = None
    assert not panel.SPLINEWRIGHT_PT_sights.poll(bpy.context)


def test_analysis_has_every_switch_by_groups_with_the_settings_of_those_that_are_on(chosen):
    obs = [add(VALUES[kind](), kind) for kind in ('nurbs', 'nurbs patch')]
    activate(*obs)
    known = {one.identifier: one.type for one in chosen.bl_rna.properties if one.identifier not in ('rna_type', 'name')}
    switches = {name for name, kind in known.items() if kind == 'BOOLEAN'}
    layout = drawn_by(panel.SPLINEWRIGHT_PT_analysis, bpy.context)
    assert set(layout.props) == switches and len(layout.props) == len(switches)
    assert [text for text in layout.texts if text] == ["Structure", "Curvature", "Deviation"]
    for switch in switches:
        setattr(chosen, switch, True)
    layout = drawn_by(panel.SPLINEWRIGHT_PT_analysis, bpy.context)
    assert set(layout.props) == set(known) and len(layout.props) == len(known), "each once"
    chosen.hodograph = chosen.comb = False
    drawn = drawn_by(panel.SPLINEWRIGHT_PT_analysis, bpy.context).props
    assert "place" in drawn and not {"comb_scale", "hodograph_scale"} & set(drawn)
