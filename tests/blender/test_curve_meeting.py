"""Corners, fillets, trims, extensions and intersections of curve shapes by operators: what stays on them, and refusals."""

import bpy
import numpy as np
import pytest
from mathutils import Matrix

from shapes import activate, add, op, require_exact
from support import splinecore as sc

SQUARE = sc.build.contour([(0, 0), (4, 0), (4, 3), (0, 3)], closed=True)


def line(*ends):
    return sc.BezierCurve(np.array(ends, float))


def curves(ob):
    value = ob.data.splinewright.value
    return value if isinstance(value, list) else [value]


def ends(ob, number=0):
    curve = curves(ob)[number]
    return curve.evaluate(np.array(curve.domain))


def test_corners_are_filleted_and_chamfered_and_an_undo_has_them_back():
    ob = add(SQUARE)
    assert op(bpy.ops.splinewright.fillet_corners, size=0.5) == {'FINISHED'}
    assert curves(ob)[0].length() == pytest.approx(10 + np.pi)
    require_exact(ob)
    bpy.ops.ed.undo_push(message="filleted")
    bpy.ops.ed.undo()
    ob = add(SQUARE, "other")
    assert op(bpy.ops.splinewright.chamfer_corners, size=0.5) == {'FINISHED'}
    assert curves(ob)[0].length() == pytest.approx(10 + 4 * np.hypot(0.5, 0.5))


def test_corners_that_do_not_fit_are_named_and_nothing_changes():
    ob = add(SQUARE)
    with pytest.raises(RuntimeError, match="does not fit"):
        op(bpy.ops.splinewright.fillet_corners, size=1.6)
    assert curves(ob)[0] == SQUARE
    smooth = add(sc.conics.circle((0, 0, 0), 1))
    activate(smooth)
    with pytest.raises(RuntimeError, match="no corners"):
        op(bpy.ops.splinewright.chamfer_corners, size=0.1)


def test_two_shapes_are_filleted_into_one_in_the_place_of_the_active_one():
    a, b = add(line((0, 0), (4, 0)), "a"), add(line((0, 0), (3, 0)), "b")
    b.matrix_world = Matrix.Translation((0, 0, 0)) @ Matrix.Rotation(np.pi / 2, 4, 'Z')
    bpy.context.view_layer.update()
    material = bpy.data.materials.new("paint")
    a.data.materials.append(material)
    activate(a, b)
    assert bpy.context.object == a
    assert op(bpy.ops.splinewright.fillet_curves, radius=0.5) == {'FINISHED'}
    assert list(bpy.data.objects) == [a] and list(a.data.materials) == [material]
    assert curves(a)[0].length() == pytest.approx(3.5 + 2.5 + 0.25 * np.pi, abs=1e-5)
    assert max(joint.angle for _, joint in curves(a)[0].joints()) < 1e-6
    require_exact(a)


@pytest.mark.parametrize('sides, corner', ((('end', 'end'), (1, 1)), (('start', 'end'), (-1, 1)), (('start', 'start'), (-1, -1))))
def test_the_parts_that_stay_are_chosen(sides, corner):
    ob = add([line((-2, 0), (2, 0)), line((0, -2), (0, 2))])
    assert op(bpy.ops.splinewright.chamfer_curves, first_length=1.0, second_length=0.5, first_kept=sides[0],
              second_kept=sides[1], joined=False) == {'FINISHED'}
    assert len(curves(ob)) == 3
    assert ends(ob, 2)[:, :2] == pytest.approx(np.array([(corner[0], 0), (0, 0.5 * corner[1])]))
    require_exact(ob)


def test_what_is_no_pair_is_refused():
    ob = add(line((-2, 0), (2, 0)))
    with pytest.raises(RuntimeError, match="1 piece|two pieces"):
        op(bpy.ops.splinewright.fillet_curves)
    ob.data.splinewright.value = [line((-2, 0), (2, 0)), line((-2, 1), (2, 1))]
    with pytest.raises(RuntimeError, match="touches both"):
        op(bpy.ops.splinewright.fillet_curves, radius=9.0)
    assert len(curves(ob)) == 2


def test_a_curve_is_trimmed_where_it_meets_what_is_shown():
    bar = add(line((0, 0), (4, 0)), "bar")
    posts = [add(line((0, -1), (0, 1)), f"post {x}") for x in (1, 2, 3)]
    for x, post in zip((1, 2, 3), posts):
        post.location.x = x
    bpy.context.view_layer.update()
    activate(bar)
    assert op(bpy.ops.splinewright.trim_curve, parameter=0.6) == {'FINISHED'}
    assert [tuple(piece.domain) for piece in curves(bar)] == [pytest.approx((0, 0.5)), pytest.approx((0.75, 1))]
    posts[0].hide_set(True)
    with pytest.raises(RuntimeError, match="nothing meets the curve between its ends"):
        op(bpy.ops.splinewright.trim_curve, parameter=0.1, piece=1)
    assert len(curves(bar)) == 2


def test_trimming_keeps_the_material():
    bar = add(line((0, 0), (4, 0)), "bar")
    add(line((1, -1), (1, 1)), "post")
    bar.data.materials.append(bpy.data.materials.new("red"))
    bar.data.materials.append(bpy.data.materials.new("blue"))
    bar.data.splines[0].material_index = 1
    activate(bar)
    op(bpy.ops.splinewright.trim_curve, parameter=0.1)
    assert bar.data.splines[0].material_index == 1 and ends(bar)[0] == pytest.approx((1, 0, 0))


def test_curves_go_on_by_a_length_and_to_others():
    bar = add(line((0, 0), (1, 0)), "bar")
    wall = add(line((3, -1), (3, 1)), "wall")
    activate(bar)
    assert op(bpy.ops.splinewright.extend_curve, to='LENGTH', by=0.5, ends='BOTH', how='straight') == {'FINISHED'}
    assert ends(bar)[:, 0] == pytest.approx((-0.5, 1.5))
    assert op(bpy.ops.splinewright.extend_curve, to='CURVES', ends='END', how='natural') == {'FINISHED'}
    assert ends(bar)[1] == pytest.approx((3, 0, 0))
    bpy.data.objects.remove(wall)
    with pytest.raises(RuntimeError, match="no other curve"):
        op(bpy.ops.splinewright.extend_curve, to='CURVES', ends='START')


def test_curves_part_where_they_meet():
    first, second = add(line((-2, 0), (2, 0)), "first"), add([line((0, -2), (0, 2)), line((1, -2), (1, 2))], "second")
    activate(first, second)
    assert op(bpy.ops.splinewright.split_where_met, meet='SELECTED') == {'FINISHED'}
    assert len(curves(first)) == 3 and len(curves(second)) == 4
    with pytest.raises(RuntimeError, match="meets nothing|no other"):
        activate(first)
        second.hide_set(True)
        op(bpy.ops.splinewright.split_where_met, meet='SELECTED')


def test_a_curve_parts_where_it_meets_itself():
    loop = sc.BezierCurve([(0, 0), (6, 4), (-3, 4), (3, 0)])
    ob = add(loop)
    assert op(bpy.ops.splinewright.split_where_met) == {'FINISHED'}
    assert len(curves(ob)) == 3


def test_a_shape_of_a_recipe_is_not_trimmed():
    op(bpy.ops.splinewright.add_circle)
    with pytest.raises(RuntimeError, match="recipe"):
        op(bpy.ops.splinewright.trim_curve, parameter=0.1)


def test_intersections_are_points_and_curves():
    sphere = add(sc.build.sphere((0, 0, 0), 1), "sphere")
    plane = add(sc.build.plane((-2, -2, 0), (4, 0, 0), (0, 4, 0)), "plane")
    needle = add(line((0.5, 0.25, -3), (0.5, 0.25, 3)), "needle")
    plane.location.z = 0.25
    bpy.context.view_layer.update()
    activate(sphere, plane, needle)
    assert op(bpy.ops.splinewright.intersections) == {'FINISHED'}
    points, found = (next(ob for ob in bpy.context.selected_objects if ob.name.startswith(name))
                     for name in ("Intersections", "Intersection Curves"))
    places = np.array([vertex.co for vertex in points.data.vertices])
    height = np.sqrt(1 - 0.25 - 0.0625)
    assert sorted(places[:, 2]) == pytest.approx([-height, 0.25, height], abs=1e-6)
    curve = curves(found)[0]
    around = curve.evaluate(np.linspace(*curve.domain, 100))
    assert around[:, 2] == pytest.approx(0.25, abs=1e-4)
    assert np.linalg.norm(around, axis=1) == pytest.approx(1, abs=2e-4)


def test_nothing_meets_is_said():
    activate(add(line((0, 0), (1, 0)), "a"), add(line((0, 1), (1, 1)), "b"))
    count = len(bpy.data.objects)
    with pytest.raises(RuntimeError, match="[Nn]othing meets"):
        op(bpy.ops.splinewright.intersections)
    assert len(bpy.data.objects) == count


def test_a_circle_touches_three_curves():
    sides = [add(line(*ends), "side") for ends in (((0, 0), (4, 0)), ((0, 0), (0, 3)), ((4, 0), (0, 3)))]
    activate(*sides)
    assert op(bpy.ops.splinewright.add_touching_circle) == {'FINISHED'}
    circle = bpy.context.object.data.splinewright.value
    points = circle.evaluate(np.linspace(*circle.domain, 50))
    assert np.linalg.norm(points - (1, 1, 0), axis=1) == pytest.approx(1)
    activate(*sides[:2])
    with pytest.raises(RuntimeError, match="three are needed"):
        op(bpy.ops.splinewright.add_touching_circle)


def test_a_drawn_contour_is_its_text():
    text = "0.0 0.0 0.0; segment 4.0 0.0 0.0; arc 4.0 2.0 0.0; segment 0.0 2.0 0.0; closed"
    assert op(bpy.ops.splinewright.draw_contour, contour=text) == {'FINISHED'}
    ob = bpy.context.object
    assert curves(ob)[0].length() == pytest.approx(4 + np.pi + 4 + 2)
    require_exact(ob)
    assert op(bpy.ops.splinewright.draw_contour, contour=text, radius=0.25) == {'FINISHED'}
    rounded = curves(bpy.context.object)[0]
    assert max(joint.angle for _, joint in rounded.joints()) < 1e-6
    for wrong in ("", "1 2", "0 0 0; arc 1 2", "0 0 0", "nan 0 0; 1 1 1", "0 0 0; 0 0 0"):
        with pytest.raises(RuntimeError, match="contour|points"):
            op(bpy.ops.splinewright.draw_contour, contour=wrong)


def test_selected_curves_are_joined_within_a_tolerance():
    rows = [((0, 0), (1, 0)), ((2, 1), (1, 1e-5)), ((2, 1.00001), (0, 2)), ((9, 9), (8, 8))]
    shapes = [add(line(*row), f"part {i}") for i, row in enumerate(rows)]
    activate(*shapes)
    with pytest.raises(RuntimeError, match="no two ends"):
        op(bpy.ops.splinewright.join_curves, tolerance=1e-7)
    assert len(bpy.data.objects) == 4
    assert op(bpy.ops.splinewright.join_curves, tolerance=1e-4) == {'FINISHED'}
    ob, = bpy.data.objects
    assert len(curves(ob)) == 2 and ends(ob)[1] == pytest.approx((0, 2, 0))
    require_exact(ob)


def test_curves_that_are_one_and_those_without_length_are_refused():
    ob = add([line((0, 0), (4, 0)), line((0, 0), (4, 0))])
    for operator in (bpy.ops.splinewright.fillet_curves, bpy.ops.splinewright.chamfer_curves):
        with pytest.raises(RuntimeError):
            op(operator)
    assert len(curves(ob)) == 2
    ob.data.splinewright.value = [line((0, 0), (4, 0)), line((1, 1), (1, 1))]
    for operator in (bpy.ops.splinewright.fillet_curves, bpy.ops.splinewright.chamfer_curves):
        with pytest.raises(RuntimeError):
            op(operator)
    assert len(curves(ob)) == 2
