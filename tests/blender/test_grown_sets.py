"""Rows more and less in the nets of patches that share borders: all of them go along, or none."""

import bmesh
import bpy
import numpy as np
import pytest

from cages import choose, cut, delete, dissolve, extrude, held, mesh, slots, value, vertices
from shapes import add, enter, leave, move, op, points, require_exact
from support import part, splinecore as sc
from test_grown_patches import followed, nurbs, started, taken_up, told

live = part('bridge.net.live')
#: Of 'four around a corner': gaps and rows that go on from one patch to the next.
ALONG = {'u': ((0, 0), (1, 0)), 'v': ((0, 1), (2, 1))}
KIND = 'four around a corner'


def require_joined(before, after):
    """The patches meet where they met, and each is what it was."""
    for old, new in zip(before, after):
        assert nurbs(new).largest_distance(nurbs(old)) < 1e-12 * np.abs(old.points).max()
    assert len(after.seams()) == len(before.seams())


@pytest.mark.parametrize('way', ALONG)
@pytest.mark.parametrize('cuts', (1, 2))
def test_a_loop_through_patches_cuts_all_of_them_and_their_borders_stay_one(way, cuts):
    before = started(KIND)
    (first, axis), (second, other) = ALONG[way]
    for place in (0, 1, 2):
        cut((first, axis, place), (second, other, 2 - place), cuts=cuts)
        after = followed()
        require_joined(before, after)
        assert after[first].points.shape[axis] == after[second].points.shape[other] == 4 + cuts
        assert all(after[i] == before[i] for i in range(4) if i not in (first, second))
        bpy.ops.ed.undo()
        assert followed() == before
        bpy.ops.ed.undo()
    for count, place in ((4, 0), (5, 2), (6, 4)):       # rows that are new are cut again
        cut((first, axis, place), (second, other, count - 2 - place))
        require_joined(before, followed())
    leave()
    require_exact(bpy.data.objects["shape"])


def test_a_border_of_several_patches_is_extruded_and_deleted_as_one():
    before = started(KIND)
    rows = (0, 0, 0), (1, 0, -1)
    extrude(*rows)
    after = followed()
    assert [patch.points.shape[:2] for patch in after] == [(5, 4), (5, 4), (4, 4), (4, 4)]
    assert len(after.seams()) == len(before.seams())
    assert after[2] == before[2] and after[3] == before[3]
    assert np.array_equal(after[0].points[1:], before[0].points) and np.array_equal(after[1].points[:-1], before[1].points)
    extrude(*rows)
    longer = followed()
    delete(*rows)
    assert followed() == after or all(np.array_equal(one.points, other.points) for one, other in zip(value(), after))
    while value() != longer:
        bpy.ops.ed.undo()
    assert followed() == longer
    while value() != before:
        bpy.ops.ed.undo()
    leave()


def require_refused(before, words):
    assert live.problem(held()) and words in live.problem(held())
    assert value() == before
    inner = vertices(3, 0, 1)[1]
    choose(inner)
    move(0, 0, 1)
    assert value() != before and words in live.problem(held())
    for _ in range(8):
        if live.problem(held()):
            bpy.ops.ed.undo()
    assert followed() == before


def test_what_is_done_on_one_side_of_a_shared_border_is_refused_in_words():
    before = started(KIND)
    extrude((0, 0, 0))
    require_refused(before, "share a border")
    cut((0, 0, 1))
    require_refused(before, "on one side only")
    dissolve((0, 0, -1), (1, 0, 0))
    require_refused(before, "")
    delete((0, 0, 0), (1, 0, -1), kind='VERT')
    assert [patch.points.shape[:2] for patch in followed()] == [(3, 4), (3, 4), (4, 4), (4, 4)]
    leave()


def test_borders_that_are_one_curve_with_other_knots_are_not_cut():
    grid = points(4, 7)
    ends = [0, 0, 0, 0, 1, 1, 1, 1], [0, 0, 0, 0, 1, 1, 1, 1]
    left = sc.NurbsPatch((3, 3), ends, grid[:, :4]).insert_knot('u', 0.25)
    right = sc.NurbsPatch((3, 3), ends, grid[:, 3:]).insert_knot('u', 0.25)
    other = sc.NurbsPatch((3, 3), ([0, 0, 0, 0, 0.6, 1, 1, 1, 1], ends[1]), right.points)
    for second, is_cut in ((right, True), (other, False)):
        add(sc.PatchSet.from_patches([left, second]))
        enter()
        before = value()
        cut((0, 0, 1), (1, 0, 1))
        if is_cut:
            require_joined(before, followed())
        else:
            assert "other knots" in live.problem(held()) and value() == before
            while live.problem(held()):
                bpy.ops.ed.undo()
        leave()
        bpy.data.objects.remove(bpy.data.objects["shape"])


def with_a_pole():
    """A patch of which a row is one point."""
    net = points(4, 4)
    net[0] = net[0, 0]
    return sc.PatchSet.from_patches([sc.BezierPatch(net), sc.BezierPatch(points(2, 2) + 5)])


@pytest.mark.parametrize('place', (0, 1, 2))
@pytest.mark.parametrize('axis', (0, 1))
def test_faces_beside_a_pole_are_parted_where_rows_are_cut_in(place, axis):
    add(with_a_pole())
    enter()
    before = value()
    assert len(set(vertices(0, 0, 0))) == 1
    for times in (1, 2):
        cut((0, axis, place))
        if live.is_waiting(held()):
            assert taken_up() == value() != before
        after = followed()
        assert after[0].points.shape[axis] == 4 + times and after[1] == before[1]
        assert nurbs(after[0]).largest_distance(nurbs(before[0])) < 1e-12
    dissolve((0, axis, 2))
    assert followed()[0].points.shape[axis] == 5
    leave()


@pytest.mark.parametrize('place', (1, 2, 3))
def test_a_row_that_goes_through_patches_is_dissolved_in_all(place):
    before = started(KIND)
    cut((0, 0, 1), (1, 0, 1))
    after = followed()
    dissolve((0, 0, place), (1, 0, 4 - place))
    fewer = followed()
    assert [patch.points.shape[:2] for patch in fewer] == [(4, 4)] * 4 and len(fewer.seams()) == len(before.seams())
    far = max(nurbs(one).largest_distance(nurbs(other)) for one, other in zip(fewer, after))
    assert np.isclose(told(), far, rtol=0.05, atol=1e-12)
    bpy.ops.ed.undo()
    assert followed() == after
    leave()


def slid(pairs, fraction):
    """A cut whose new vertices lie at a fraction of the way between pairs of vertices of the net, all at once."""
    starts = {frozenset(pair): pair[0] for pair in slots()[list(pairs)].tolist()}
    edited = mesh()
    count = len(edited.verts)
    edges = [edge for edge in edited.edges if frozenset(vertex.index for vertex in edge.verts) in starts]
    assert len(edges) == len(starts)
    bmesh.ops.subdivide_edges(edited, edges=edges, cuts=1, use_grid_fill=True)
    edited.verts.index_update()
    edited.verts.ensure_lookup_table()
    assert len(edited.verts) == count + len(starts)
    for vertex in edited.verts[count:]:
        beside = [edge.other_vert(vertex) for edge in vertex.link_edges if edge.other_vert(vertex).index < count]
        start = starts[frozenset(other.index for other in beside)]
        one, other = sorted(beside, key=lambda each: each.index != start)
        vertex.co = one.co + (other.co - one.co) * fraction
    bmesh.update_edit_mesh(held().data)
    bpy.context.view_layer.update()


def between(patch, axis, place):
    return list(zip(vertices(patch, axis, place), vertices(patch, axis, place + 1)))


@pytest.mark.parametrize('fraction', (0.2, 0.75))
def test_a_cut_that_was_slid_puts_the_knot_there(fraction):
    before = started('plain nurbs')
    slid(between(0, 0, 2), fraction)
    after = followed()
    assert after.largest_distance(before) < 1e-12
    (new,) = np.setdiff1d(after.knots[0], before.knots[0])
    averages = [before.knots[0][i + 1:i + 4].mean() for i in (2, 3)]
    assert np.isclose(new, averages[0] + (averages[1] - averages[0]) * fraction, atol=1e-6)
    leave()


@pytest.mark.parametrize('way', ALONG)
def test_a_slid_cut_through_patches_that_are_turned_leaves_their_borders_one(way):
    before = started(KIND)
    (first, axis), (second, other) = ALONG[way]
    pairs = {*between(first, axis, 0), *[pair[::-1] for pair in between(second, other, 2)]}
    assert len(pairs) == 7
    slid(pairs, 0.3)
    after = followed()
    require_joined(before, after)
    knots = [np.unique(after[patch].knots[along]) for patch, along in ALONG[way]]
    assert np.allclose(knots, [(0, 0.1, 1), (0, 0.9, 1)], atol=1e-6)
    leave()


def test_several_nets_in_edit_mode_grow_each_on_its_own():
    one, other = sc.BezierPatch(points(4, 4)), sc.BezierPatch(points(3, 3) + 5)
    add(one, "other")
    add(other, "shape")
    for name in ("other", "shape"):
        bpy.data.objects[name].select_set(True)
    enter()
    nets = {part('bridge.cage.net_object').shape_of(ob).name: ob for ob in bpy.context.objects_in_mode}
    assert len(nets) == 2
    bpy.ops.mesh.select_all(action='SELECT')
    op(bpy.ops.mesh.subdivide)
    bpy.context.view_layer.update()
    for name, before in (("other", one), ("shape", other)):
        after = bpy.data.objects[name].data.splinewright.value
        assert live.problem(nets[name]) == "" and after.largest_distance(nurbs(before)) < 1e-12
        assert after.points.shape[0] == 2 * before.points.shape[0] - 1
    bpy.ops.ed.undo()
    assert bpy.data.objects["other"].data.splinewright.value == one and value() == other
    leave()
