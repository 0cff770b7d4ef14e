"""Distances of shapes from other objects: right, whatever the matrices; measured again when something changed, and not else;
and a sentence where there is nothing to measure to."""

import time

import bpy
import numpy as np
import pytest
from mathutils import Euler, Matrix

from layouts import drawn_by
from shapes import VALUES, activate, add, enter, leave, move, select
from support import part, splinecore as sc

deviations, file_state, handlers, lengths, measures, paint, panel, targets = (part(name) for name in (
    'bridge.analysis.deviations', 'bridge.data.file_state', 'ui.handlers', 'core.base.length_units', 'core.analysis.deviations', 'ui.deviation_paint',
    'ui.analysis_panel', 'bridge.analysis.deviation_targets'))
TURNED = Matrix.Translation((3, -2, 0.5)) @ Euler((0.4, 1.1, -0.3)).to_matrix().to_4x4()


@pytest.fixture
def chosen():
    found = bpy.context.scene.splinewright_sights
    found.deviation = True
    yield found
    for name in ('deviation', 'deviation_object', 'deviation_range'):
        bpy.context.scene.splinewright_sights.property_unset(name)
    file_state.state.targets.clear()


def sphere(radius=2.0):
    return sc.build.sphere((0, 0, 0), radius)


def mesh_object(points, edges=(), faces=(), name="mesh"):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, edges, faces)
    ob = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(ob)
    bpy.context.view_layer.update()
    return ob


def plane(z=0.0, half=50.0):
    return mesh_object([(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)], faces=[(0, 1, 2, 3)])


def measured(ob, other, is_still=True):
    """The Deviation of a shape, as the view comes to have it."""
    bpy.context.view_layer.update()
    target = targets.of(other)
    found = deviations.of(ob, target, False)
    if is_still:
        found = in_the_end(ob, target)
    return found[0]


def in_the_end(ob, target):
    """What is known when nothing changes any more, and how many looks that takes."""
    for looks in range(1, 1000):
        found, share, is_new = deviations.of(ob, target, True)
        assert not is_new
        if share == 1.0:
            return found, looks
    raise AssertionError("no end")


def world_points(ob):
    """Of every row of the Deviation of a patch shape."""
    shown, places, patch_set = deviations.faces_of(ob.data)
    found = np.empty((len(places.parts), 3))
    for number in np.unique(places.patches):
        here = places.patches == number
        patch = patch_set[int(number)]
        (u0, u1), (v0, v1) = patch.domain
        u, v = places.parts[here].T.astype(np.float64)
        found[here] = patch.evaluate(u0 + u * (u1 - u0), v0 + v * (v1 - v0))
    matrix = np.array(ob.matrix_world, np.float64)
    return found @ matrix[:3, :3].T + matrix[:3, 3]


def test_a_patch_has_its_distances_from_a_plain_mesh(chosen):
    other, ob = plane(-3.0), add(VALUES['bezier patch']())
    found = measured(ob, other)
    wanted = world_points(ob)[:, 2] + 3
    assert np.abs(found.values - wanted).max() < 1e-5 and found.largest == found.values.max()
    assert wanted.min() < found.mean < wanted.max()


@pytest.mark.parametrize('matrix', (Matrix(), TURNED, TURNED @ Matrix.Scale(-0.3, 4), Matrix.Diagonal((1, 2, 0.5, 1)),
                                    Matrix.Diagonal((1, 1, 0, 1))))
def test_matrices_of_both_count(chosen, matrix):
    """A plane is a plane under every matrix, and an exact plane too."""
    wire = plane()
    exact = add(sc.BezierPatch([[(x, y, 0) for y in (-50, 50)] for x in (-50, 50)]), "exact")
    ob = add(VALUES['bezier patch']())
    ob.matrix_world = TURNED.inverted() @ Matrix.Diagonal((1, 0.5, 2, 1))
    for other in (wire, exact):
        other.matrix_world = matrix
        found = measured(ob, other)
        normal = np.array(matrix.to_3x3().col[0].cross(matrix.to_3x3().col[1]).normalized())
        wanted = np.abs((world_points(ob) - np.array(other.matrix_world.translation)) @ normal)
        assert np.abs(found.values - wanted).max() < 2e-5


def test_an_exact_sphere_is_as_far_as_its_radius_and_no_mesh(chosen):
    other, ob = add(sphere(), "other"), add(VALUES['bezier patch']())
    other.data.splinewright.set_resolution(1, 1)
    other.matrix_world = TURNED @ Matrix.Scale(2, 4)
    found = measured(ob, other)
    middle = np.array(other.matrix_world.translation)
    wanted = np.abs(np.linalg.norm(world_points(ob) - middle, axis=1) - 4)
    assert np.abs(found.values - wanted).max() < 2e-6 and targets.of(other).geometry.words == "exact"
    other.modifiers.new("solid", 'TRIANGULATE')
    found = measured(ob, other)
    assert np.abs(found.values - wanted).max() > 0.01 and targets.of(other).geometry.words == "faces"


def test_the_same_surface_elsewhere_is_no_distance_from_itself(chosen):
    """Far from the origin, too, with what float32 leaves there."""
    one = add(sc.build.torus((0, 0, 0), (0, 0, 1), 3.0, 1.0), "one")
    other = add(one.data.splinewright.value, "other")
    one.matrix_world = other.matrix_world = Matrix.Translation((1e6, 2e6, -3e6)) @ TURNED
    assert measured(one, other).largest < 1e-13


@pytest.mark.parametrize('size', (1e-12, 1e12))
def test_tiny_and_huge_ones_have_distances(chosen, size):
    other, ob = add(sphere(2 * size), "other"), add(sphere(3 * size))
    assert measured(ob, other).largest / size == pytest.approx(1, abs=1e-6)


def test_curves_have_distances_from_exact_curves_edges_and_points(chosen):
    circle = sc.build.circle((0, 0, 0), 2.0) if hasattr(sc.build, 'circle') else VALUES['periodic']()
    line = add(sc.BezierCurve([(0, 0, 1), (1, 0, 1)]), "line")
    ob = add(sc.BezierCurve([(0, 3, 1), (1, 3, 1)]))
    assert measured(ob, line).largest == pytest.approx(3, abs=1e-12)
    assert targets.of(line).geometry.words == "exact"
    edges = mesh_object([(-9, 0, 1), (9, 0, 1)], [(0, 1)], name="edges")
    assert measured(ob, edges).mean == pytest.approx(3, abs=1e-6) and targets.of(edges).geometry.words == "edges"
    point = mesh_object([(0, 3, 5)], name="point")
    found = measured(ob, point)
    assert found.largest == pytest.approx(np.hypot(4, 1), abs=1e-6) and targets.of(point).geometry.words == "points"
    assert measured(add(circle, "circle"), point).largest > 0
    bpy.ops.object.text_add()
    assert measured(ob, bpy.context.object).largest > 0


def test_nothing_is_measured_again_until_something_changes(chosen):
    other, ob = plane(), add(VALUES['nurbs patch']())
    first = measured(ob, other)
    assert measured(ob, other) is first
    bpy.context.view_layer.update()
    assert deviations.of(ob, targets.of(other), False)[0] is first, "what was measured in the end stays"
    geometry = targets.of(other).geometry
    other.location.z = 2
    assert measured(ob, other) is not first and targets.of(other).geometry is geometry
    other.data.vertices[0].co.z += 5
    other.data.update()
    second = measured(ob, other)
    assert targets.of(other).geometry is not geometry
    modifier = other.modifiers.new("more", 'SUBSURF')
    measured(ob, other)
    assert targets.of(other).geometry is not geometry
    other.modifiers.remove(modifier)
    held = enter_of(ob)
    select(held, 3)
    move(0, 0, 4)
    third = measured(ob, other)
    assert abs(third.mean - second.mean) > 0.1
    leave()


def enter_of(ob):
    activate(ob)
    return enter()


def test_a_change_is_shown_at_once_by_few_places_and_in_the_end_by_many(chosen):
    other, ob = plane(-2.0), add(VALUES['nurbs patch']())
    ob.data.splinewright.set_resolution(24, 24)
    target = targets.of(other)
    calls = []
    distances = target.geometry.distances
    target.geometry.distances = lambda points: calls.append(len(points)) or distances(points)
    quick, share, is_new = deviations.of(ob, target, True)
    assert share == 0.0 and is_new and sum(calls) <= 2500
    assert deviations.of(ob, target, False) == (quick, 0.0, False) and sum(calls) <= 2500
    final, _ = in_the_end(ob, target)
    assert sum(calls) > 2500
    assert np.abs(final.values - quick.values).max() < 0.05 and abs(final.mean - quick.mean) < 0.01


def test_what_takes_long_is_measured_in_many_looks_and_a_change_begins_anew(chosen):
    other, ob = plane(-2.0), add(VALUES['nurbs patch']())
    ob.data.splinewright.set_resolution(24, 24)
    bpy.context.view_layer.update()
    target = targets.of(other)
    distances = target.geometry.distances
    calls = []

    def slow(points):
        calls.append(len(points))
        time.sleep(0.04)
        return distances(points)
    target.geometry.distances = slow
    nothing, share, is_new = deviations.of(ob, target, False)
    assert nothing is None and share == 0.0 and is_new and len(calls) < 5, "what is not quick is not measured at once"
    shares = [deviations.of(ob, target, True)[1] for _ in range(3)]
    assert 0.0 < shares[0] < shares[1] < shares[2] < 1.0
    found, looks = in_the_end(ob, target)
    assert looks > 10 and np.abs(found.values - (world_points(ob)[:, 2] + 2)).max() < 0.01
    count = len(calls)
    assert deviations.of(ob, target, True) == (found, 1.0, False) and len(calls) == count
    ob.location.z = 1.0
    bpy.context.view_layer.update()
    assert deviations.of(ob, target, False)[1:] == (0.0, True)


def test_what_an_object_moves_or_undo_brings_back_counts(chosen):
    empty = bpy.data.objects.new("empty", None)
    bpy.context.scene.collection.objects.link(empty)
    other, ob = plane(), add(sphere(1.0))
    other.parent = empty
    empty.location.z = 7
    bpy.ops.ed.undo_push(message="7")
    assert measured(ob, other).largest == pytest.approx(8, abs=1e-5)
    empty.location.z = 4
    bpy.ops.ed.undo_push(message="4")
    assert measured(ob, other).largest == pytest.approx(5, abs=1e-5)
    bpy.ops.ed.undo()
    assert measured(bpy.data.objects["shape"], bpy.data.objects["mesh"]).largest == pytest.approx(8, abs=1e-5)


def test_an_animated_object_has_its_distances_at_every_frame(chosen):
    other, ob = plane(), add(sphere(1.0))
    other.shape_key_add(name="Basis")
    raised = other.shape_key_add(name="raised")
    for point in raised.data:
        point.co.z = 6.0
    raised.value = 0.0
    raised.keyframe_insert('value', frame=1)
    raised.value = 1.0
    raised.keyframe_insert('value', frame=11)
    scene = bpy.context.scene
    try:
        for frame, wanted in ((1, 1.0), (11, 7.0), (1, 1.0)):
            scene.frame_set(frame)
            assert measured(ob, other).largest == pytest.approx(wanted, abs=1e-5), frame
    finally:
        scene.frame_set(1)


@pytest.mark.parametrize('has_modifier', (False, True))
def test_a_shape_counts_while_its_net_is_edited(chosen, has_modifier):
    ob = add(sc.BezierCurve([(0, 0, 3), (1, 0, 3)]), "line")
    other = add(sc.BezierPatch([[(x, y, 0) for y in (-9, 9)] for x in (-9, 9)]), "other")
    if has_modifier:
        other.modifiers.new("more", 'TRIANGULATE')
        bpy.ops.ed.undo_push(message="modifier")
    assert measured(ob, other).largest == pytest.approx(3, abs=1e-6)
    held = enter_of(other)
    select(held, 0, 1, 2, 3)
    move(0, 0, -2)
    bpy.context.view_layer.update()
    assert measured(ob, other).largest == pytest.approx(5, abs=1e-6)
    leave()
    assert measured(ob, other).largest == pytest.approx(5, abs=1e-6)
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    assert measured(bpy.data.objects["line"], bpy.data.objects["other"]).largest == pytest.approx(3, abs=1e-6)


def test_what_is_missing_empty_gone_itself_or_elsewhere_is_said(chosen):
    scene, ob = bpy.context.scene, add(VALUES['bezier patch']())

    def said(other):
        chosen.deviation_object = other
        bpy.context.view_layer.update()
        found = deviations.problem(scene, [ob])
        shown = drawn_by(panel.SPLINEWRIGHT_PT_sights, bpy.context)
        assert not found or found.split()[-1] in " ".join(map(str, vars(shown).values()))
        return found
    assert "Choose the object" in said(None)
    assert "itself" in said(ob)
    empty = mesh_object([], name="hollow")
    assert said(empty) == "hollow is empty: it has no points to measure to"
    assert "no surface and no lines" in said(bpy.data.objects.new("nothing", None)) or "deleted" in said(
        bpy.data.objects["nothing"])
    lamp = bpy.data.objects.new("lamp", bpy.data.lights.new("lamp", 'POINT'))
    scene.collection.objects.link(lamp)
    assert "no surface and no lines" in said(lamp)
    other = plane()
    assert said(other) == ""
    elsewhere = bpy.data.scenes.new("elsewhere")
    elsewhere.collection.objects.link(other)
    scene.collection.objects.unlink(other)
    assert "another scene" in said(other)
    bpy.data.scenes.remove(elsewhere)
    gone = plane()
    assert said(gone) == ""
    bpy.data.objects.remove(gone)
    assert chosen.deviation_object is None and "Choose" in deviations.problem(scene, [ob])
    last = plane()
    chosen.deviation_object = last
    activate(last)
    bpy.ops.object.delete()
    activate(ob)
    found = deviations.problem(scene, [ob])
    assert "deleted" in found or "Choose" in found


def test_a_damaged_or_flat_one_breaks_nothing(chosen):
    other, ob = add(VALUES['bezier patch'](), "other"), add(VALUES['nurbs patch']())
    other.data[part('bridge.data.store').KEY]['structure'] = "no"
    chosen.deviation_object = other
    assert deviations.problem(bpy.context.scene, [ob])
    good = plane()
    ob.data[part('bridge.data.store').KEY]['structure'] = "no"
    assert deviations.of(ob, targets.of(good), True)[0] is None and in_the_end(ob, targets.of(good)) == (None, 1)
    flat = add(sphere(), "flat")
    flat.scale = (0, 0, 0)
    bpy.context.view_layer.update()
    one = add(VALUES['bezier patch'](), "one")
    assert np.isfinite(measured(one, flat).largest)


def test_nothing_is_kept_and_nothing_done_while_it_is_off(chosen):
    other, ob = plane(), add(VALUES['nurbs patch']())
    measured(ob, other)
    assert file_state.state.targets
    chosen.deviation = False
    assert not file_state.state.targets
    other.data.vertices[0].co.z = 3
    other.data.update()
    bpy.context.view_layer.update()
    assert not file_state.state.targets


def test_the_object_and_the_range_are_kept_with_the_file(chosen, tmp_path):
    chosen.deviation_object, chosen.deviation_range = plane(), 0.25
    add(VALUES['bezier patch']())
    path = str(tmp_path / "kept.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path, copy=True)
    bpy.ops.wm.open_mainfile(filepath=path)
    found = bpy.context.scene.splinewright_sights
    assert found.deviation and found.deviation_object == bpy.data.objects["mesh"] and found.deviation_range == 0.25
    assert measured(bpy.data.objects["shape"], found.deviation_object).largest > 0


def test_the_legend_says_largest_and_mean_in_units_of_the_scene(chosen, monkeypatch):
    """From 3 to 4 units away, of half a millimetre each."""
    units = bpy.context.scene.unit_settings
    units.system, units.length_unit, units.scale_length = 'METRIC', 'MILLIMETERS', 5e-4
    other, ob = plane(-3.0), add(sc.BezierPatch([[(0, 0, 0), (0, 0.5, 0)], [(0.5, 0, 0.5), (0.5, 0.5, 0.5)]]))
    ob.scale = (2, 2, 2)
    measured(ob, other)
    chosen.deviation_object = other
    drawn = []
    monkeypatch.setattr(paint.legend, 'draw', lambda context, head, numbers, colors, notes: drawn.append((head, numbers, notes)))
    monkeypatch.setattr(paint.timers, 'later', lambda *_: None)
    part('ui.ui_state').ui_state.is_still = True
    paint.draw_legend(bpy.context, chosen, [ob])
    (head, numbers, notes), = drawn
    assert head[:2] == ["Distance to", "mesh"] and numbers == ["0 mm", "0.5 mm", "1 mm", "1.5 mm", "2 mm"]
    assert notes == ["Largest 2 mm", "Mean 1.75 mm"]


def test_the_legend_says_what_is_not_measured_in_the_end():
    unit = lengths.unit_for(4.0, 'METRIC', 'MILLIMETERS', 5e-4)
    surface, line = add(VALUES['bezier patch'](), "surface"), add(VALUES['nurbs'](), "line")
    known = measures.Deviation(np.array([3.0, 4.0]), 4.0, 3.5, 1.0)

    def notes(obs, share):
        return paint._notes(paint.Shown([(ob, known) for ob in obs], "exact", 4.0, share), unit)
    assert notes([surface], 0.0) == ["Largest ≈ 2 mm", "Mean ≈ 1.75 mm"]
    assert notes([surface], 0.375) == ["Largest ≈ 2 mm", "Mean ≈ 1.75 mm", "Measuring: 38 %"]
    assert notes([surface, line], 1.0) == ["Largest 2 mm"], "areas and lengths have no mean in common"
    assert notes([], 0.0) == ["Measuring: 0 %"]
