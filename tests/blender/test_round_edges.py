"""Round Edge of one shape or more: all edges, some by their numbers, corners of three, rims, what crosses; live and closed."""

import collections

import bpy
import numpy as np
import pytest

from shapes import activate, add, op, require_exact
from support import part, splinecore as sc

recipes, follow, problems, sections_overlay, round_here = (part(name) for name in (
    'bridge.recipes.recipes', 'bridge.follow.follow', 'bridge.data.problems', 'ui.sections_overlay', 'ui.operators.round_here'))
SQUARE = sc.build.contour([(0, 0, 0), (3, 0, 0), (3, 2, 0), (0, 2, 0)], closed=True)


def box(height=1.0):
    return sc.PatchSet.from_patches(sc.build.cap([sc.build.extrude(SQUARE, (0, 0, height))], None).value)


def rounded(*obs, **settings):
    activate(*obs)
    assert op(bpy.ops.splinewright.add_rounded_edge, **settings) == {'FINISHED'}
    return bpy.context.object


def open_edges(ob):
    counts = collections.Counter(key for face in ob.data.polygons for key in face.edge_keys)
    return sum(count == 1 for count in counts.values())


def volume_of(ob):
    return ob.data.splinewright.value.volume()


def steiner(radius, sides=(3, 2, 1)):
    a, b, c = np.array(sides) - 2 * radius
    return a * b * c + 2 * radius * (a * b + b * c + a * c) + np.pi * radius**2 * (a + b + c) + 4 / 3 * np.pi * radius**3


def test_a_box_is_rounded_all_over_hides_it_and_follows(tmp_path):
    source = add(box(), "box")
    ob = rounded(source, radius=0.2)
    assert len(ob.data.splinewright.value) == 26 and open_edges(ob) == 0
    assert volume_of(ob) == pytest.approx(steiner(0.2)) and recipes.read(ob.data).said == "12 edges rounded"
    assert source.hide_get() and not ob.hide_get()
    require_exact(ob)

    source.data.splinewright.value = box(2.0)
    bpy.context.view_layer.update()
    assert volume_of(ob) == pytest.approx(steiner(0.2, (3, 2, 2))) and not follow.problem(ob.data)

    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "round.blend"))
    name, value = ob.name, ob.data.splinewright.value
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "round.blend"))
    assert bpy.data.objects[name].data.splinewright.value == value


def test_undo_takes_it_back_and_shows_what_was_hidden():
    add(box(), "box")
    bpy.ops.ed.undo_push(message="box")
    rounded(bpy.data.objects["box"], radius=0.2)
    bpy.ops.ed.undo()
    assert len(bpy.data.objects) == 1 and not bpy.data.objects["box"].hide_get()
    bpy.ops.ed.redo()
    assert len(bpy.data.objects) == 2 and open_edges(bpy.context.object) == 0


def test_edges_by_number_in_the_operator_and_in_the_panel():
    ob = rounded(add(box(), "box"), radius=0.2, edges="1")
    assert recipes.read(ob.data).said == "1 edge rounded" and open_edges(ob) == 0
    before = volume_of(ob)
    values = ob.data.splinewright_parameters
    values.rounded_edge_edges = "1, 3"
    assert recipes.read(ob.data).said == "2 edges rounded" and volume_of(ob) < before and open_edges(ob) == 0
    kept = ob.data.splinewright.value
    values.rounded_edge_edges = "1, 13"
    assert "there are 12 edges, none of number 13" in problems.of(ob.data, problems.SETTING)
    assert ob.data.splinewright.value == kept and values.rounded_edge_edges == "1, 3"
    values.rounded_edge_radius = 9.0
    assert ob.data.splinewright.value == kept and values.rounded_edge_radius == pytest.approx(0.2)


def test_the_view_shows_the_numbers_of_edges_where_they_are():
    source = add(box(), "box")
    source.location.x = 5.0
    bpy.context.view_layer.update()
    ob = rounded(source, radius=0.2)
    seen = sections_overlay.shown(ob)
    assert [one.number for one in seen] == list(range(1, 13))
    feet = {tuple(np.round(one.foot - (5, 0, 0), 6)) for one in seen}
    assert feet == {(x, y, z) for x in (0, 1.5, 3) for y in (0, 1, 2) for z in (0, 0.5, 1)
                    if (x == 1.5) + (y == 1) + (z == 0.5) == 1}
    number = next(one.number for one in seen if np.allclose(one.foot, (5, 0, 0.5)))
    ob.data.splinewright_parameters.rounded_edge_edges = str(number)
    assert not np.array([vertex.co for vertex in ob.data.vertices])[:, :2].sum(axis=1).min() < 0.1
    ob.location.z += 3.0
    bpy.context.view_layer.update()
    assert np.allclose(sections_overlay.shown(ob)[number - 1].foot, (5, 0, 3.5))


def test_edges_that_are_clicked_lie_where_their_numbers_are_also_after_apply():
    ob = rounded(add(box(), "box"), radius=0.2)
    ob.location, ob.rotation_euler, ob.scale = (2, 1, 0.5), (0.3, 0.2, 0.7), (1, 2, 0.5)
    bpy.context.view_layer.update()
    for _ in range(2):
        lines, chosen = round_here._edges(bpy.context)
        middles = np.array([line[len(line) // 2] for line in lines])
        assert len(lines) == 12 and set(chosen) == set(range(1, 13))
        assert np.allclose(middles, [one.foot for one in sections_overlay.shown(ob)], atol=1e-5)
        bpy.ops.object.transform_apply(location=True, rotation=True, scale=True)
        bpy.context.view_layer.update()


def test_three_walls_of_three_objects_meet_in_a_part_of_a_ball():
    planes = [add(sc.build.plane((0, 0, 0), a, b), name) for name, a, b in
              (("floor", (2, 0, 0), (0, 2, 0)), ("left", (0, 2, 0), (0, 0, 2)), ("back", (0, 0, 2), (2, 0, 0)))]
    ob = rounded(*planes, radius=0.5)
    assert len(ob.data.splinewright.value) == 7 and recipes.read(ob.data).said == "3 edges rounded"
    assert ob.data.splinewright.value.edge_counts()['free'] == 9
    points = np.array([vertex.co for vertex in ob.data.vertices])
    inner = points[(points < 0.5).all(axis=1)]
    assert len(inner) > 20 and np.abs(np.linalg.norm(inner - 0.5, axis=1) - 0.5).max() < 1e-6


def test_a_tube_with_lids_and_surfaces_that_cross():
    tube = sc.PatchSet.from_patches(sc.build.cap([sc.build.cylinder((0, 0, 0), (0, 0, 1), 1, 2)], None).value)
    ob = rounded(add(tube, "tube"), radius=0.25)
    assert open_edges(ob) == 0 and recipes.read(ob.data).said == "2 edges rounded"
    ob = rounded(add(sc.build.plane((0, -1, 0), (2, 0, 0), (0, 3, 0)), "floor"),
                 add(sc.build.plane((0, 0, -0.5), (2, 0, 0), (0, 0, 2)), "wall"), radius=0.25)
    assert recipes.read(ob.data).said == "cut back to where they cross" and len(ob.data.splinewright.value) == 3


@pytest.mark.parametrize('settings, message', (
    ({'radius': 5.0}, "radius is too large"), ({'edges': "99"}, "none of number 99"), ({'edges': "a"}, "not a number of an edge"),
    ({'radius': 0.1, 'end_radius': 0.2}, "Radius and End Radius are one")))
def test_what_cannot_be_rounded_is_said_and_all_stays(settings, message):
    source = add(box(), "box")
    activate(source)
    with pytest.raises(RuntimeError, match=message):
        op(bpy.ops.splinewright.add_rounded_edge, **settings)
    assert list(bpy.data.objects) == [source] and not source.hide_get()


def test_two_edges_that_end_in_a_corner_of_three_meet_there():
    source = add(box(), "box")
    ob = rounded(source, radius=0.2)
    feet = np.array([one.foot for one in sections_overlay.shown(ob)])
    text = ", ".join(str(1 + int(np.abs(feet - place).sum(axis=1).argmin())) for place in ((1.5, 0, 0), (0, 1, 0)))
    source.hide_set(False)
    activate(source)
    ob = rounded(source, radius=0.2, edges=text)
    assert open_edges(ob) == 0
    assert volume_of(ob) == pytest.approx(6 - (1 - np.pi / 4) * 0.04 * 5 + (5 / 3 - np.pi / 2) * 0.008)
    require_exact(ob)


def test_an_extruded_outline_with_caps_is_rounded_and_follows_the_outline():
    assert op(bpy.ops.splinewright.add_contour, closed=True, corner_size=0.3) == {'FINISHED'}
    outline = bpy.context.object
    assert op(bpy.ops.splinewright.add_extrude, caps='both') == {'FINISHED'}
    body = bpy.context.object
    ob = rounded(body, radius=0.1)
    assert recipes.read(ob.data).said == "2 edges rounded" and open_edges(ob) == 0 and recipes.error(ob.data) < 1e-9
    before = volume_of(ob)
    outline.data.splinewright_parameters.contour_corner_size = 0.2
    bpy.context.view_layer.update()
    assert volume_of(ob) > before and open_edges(ob) == 0 and not follow.problem(ob.data)
    kept = ob.data.splinewright.value
    outline.data.splinewright_parameters.contour_corner_size = 0.05
    bpy.context.view_layer.update()
    assert "radius is too large" in follow.problem(ob.data) and ob.data.splinewright.value == kept
