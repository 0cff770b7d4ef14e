"""A shape and its image, live; images of Blender's own mirrors in overlays."""

import bpy
import numpy as np
import pytest
from mathutils import Matrix

from shapes import activate, add, op
from support import part, splinecore as sc

recipes, images, continuity = part('bridge.recipes.recipes'), part('bridge.shape.images'), part('core.joints.continuity')
HALF = sc.NurbsPatch((2, 2), ([0, 0, 0, 0.5, 1, 1, 1], [0, 0, 0, 1, 1, 1]),
                     [[(x, y, 0.3 * (2 - x) * (y + 0.2 * x)) for y in range(3)] for x in range(4)])
CURVE = sc.BezierCurve([(0, 0, 0), (1, 0.3, 0), (2, 1, 0), (2, 2, 0)])


def mirror_of(*obs, **settings):
    activate(*obs)
    bpy.ops.ed.undo_push(message="before")
    assert op(bpy.ops.splinewright.add_mirror, **settings) == {'FINISHED'}
    return bpy.context.object


def vertices(ob):
    return np.array([ob.matrix_world @ vertex.co for vertex in ob.data.vertices])


def open_border(ob):
    faces = {}
    for polygon in ob.data.polygons:
        for edge in polygon.edge_keys:
            faces[edge] = faces.get(edge, 0) + 1
    points = vertices(ob)
    return sum(np.linalg.norm(points[a] - points[b]) for (a, b), count in faces.items() if count == 1)


def test_a_surface_and_its_image_are_one_mesh():
    half = add(HALF, "half")
    ob = mirror_of(half)
    assert recipes.parameters(ob.data)['axis'] == 'x' and "1 border on the plane" in recipes.read(ob.data).said
    points = vertices(ob)
    there = {tuple(row) for row in np.round(points, 5)}
    assert {(-x + 0.0, y, z) for x, y, z in there} == there
    assert abs(points[:, 0]).min() == 0.0 and points[:, 0].min() == -points[:, 0].max()
    normals = np.array([polygon.normal for polygon in ob.data.polygons])
    assert (np.sign(normals[:, 2]) == np.sign(normals[0, 2])).all()


def test_curves_are_joined_with_theirs():
    ob = mirror_of(add(CURVE, "half"))
    value = ob.data.splinewright.value
    assert ob.type == 'CURVE' and not isinstance(value, list)
    assert sorted(np.round([value.evaluate(at)[0] for at in value.domain], 9)) == [-2.0, 2.0]


def test_it_follows_the_half_and_is_smooth_again():
    half = add(HALF, "half")
    ob = mirror_of(half)
    points = HALF.points + [0, 0, 0.5] * (np.arange(4)[:, None, None] == 1)
    half.data.splinewright.value = HALF.with_points(points)
    bpy.context.view_layer.update()
    found = ob.data.splinewright.value
    assert "moved by" in recipes.read(ob.data).said and len(found.patches) == 2
    first, second = part('core.verbs.verbs').pieces_of(part('bridge.data.store').read(ob.data))
    seam = sc.seam_continuity(first, 'u_start', second, 'v_start')
    assert seam.gap == 0.0 and seam.g >= 2


def test_a_shape_in_the_plane_has_no_image():
    activate(add(CURVE, "flat"))
    with pytest.raises(RuntimeError, match="it lies in the plane"):
        op(bpy.ops.splinewright.add_mirror, axis='z')


def test_an_empty_gives_the_plane_and_is_followed():
    half = add(HALF, "half")
    empty = bpy.data.objects.new("plane", None)
    bpy.context.collection.objects.link(empty)
    empty.location.x = -1.0
    bpy.context.view_layer.update()
    ob = mirror_of(half, empty, axis='x')
    assert vertices(ob)[:, 0].min() == pytest.approx(-5.0) and "the halves are apart" in recipes.read(ob.data).said
    empty.location.x = 0.0
    bpy.context.view_layer.update()
    assert vertices(ob)[:, 0].min() == pytest.approx(-3.0) and "1 border" in recipes.read(ob.data).said


def test_the_second_plane_makes_four_patches():
    corner = HALF.with_points(HALF.points * [1, 1, 0] + [0, 0, 1])
    quarter = add(corner, "quarter")
    whole = mirror_of(mirror_of(quarter), axis='y')
    assert len(whole.data.splinewright.value.patches) == 4
    assert open_border(whole) == pytest.approx(2 * (6 + 4), rel=1e-6)


def test_it_moves_with_its_half_and_alone():
    half = add(HALF, "half")
    ob = mirror_of(half)
    before = vertices(ob)
    ob.location.z += 3.0
    bpy.context.view_layer.update()
    assert np.allclose(vertices(ob), before + [0, 0, 3], atol=1e-5)


def test_it_is_undone_with_one_step():
    half = add(HALF, "half")
    mirror_of(half)
    bpy.ops.ed.undo()
    assert [ob.name for ob in bpy.data.objects] == ["half"]


@pytest.mark.parametrize('axes, count', [((True, False, False), 2), ((True, True, False), 4), ((True, True, True), 8)])
def test_mirror_modifiers_have_images(axes, count):
    ob = add(HALF, "half")
    ob.matrix_world = Matrix.Translation((5, 0, 0)) @ Matrix.Rotation(0.5, 4, 'Z')
    modifier = ob.modifiers.new("mirror", 'MIRROR')
    modifier.use_axis = axes
    modifier.use_clip = False
    modifier.use_mirror_merge = False
    bpy.context.view_layer.update()
    found = images.of(ob, bpy.context.view_layer)
    shown = ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    there = np.array([ob.matrix_world @ vertex.co for vertex in shown.vertices])
    assert len(found) == count and len(there) == count * len(ob.data.vertices)
    ours = np.concatenate([[matrix @ vertex.co for vertex in ob.data.vertices] for matrix in found])
    assert np.allclose(sorted(map(tuple, np.round(ours, 4))), sorted(map(tuple, np.round(there, 4))), atol=2e-4)


def test_images_lie_about_the_object_that_the_modifier_names():
    ob, about = add(HALF, "half"), bpy.data.objects.new("about", None)
    bpy.context.collection.objects.link(about)
    about.location.x = 10.0
    modifier = ob.modifiers.new("mirror", 'MIRROR')
    modifier.mirror_object = about
    bpy.context.view_layer.update()
    assert [tuple(matrix @ ob.data.vertices[0].co) for matrix in images.of(ob, bpy.context.view_layer)][1] == pytest.approx((20, *ob.data.vertices[0].co[1:]))
    modifier.show_viewport = False
    assert len(images.of(ob, bpy.context.view_layer)) == 1
