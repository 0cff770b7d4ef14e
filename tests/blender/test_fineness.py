"""How finely surfaces are shown: by count, tolerance and angle, and what stays when the faces change."""

import math

import bpy
import numpy as np
import pytest
from mathutils.bvhtree import BVHTree

from shapes import VALUES, activate, add, enter, first_point, leave, move, op, require_exact, select
from support import corner_normals, part, splinecore as sc, vertices

editing, live, shape, starters = (part(name) for name in ('ui.editing', 'bridge.net.live', 'bridge.shape.shape', 'core.shape.starters'))


def surface_points(value, count=40):
    """Dense points of a patch or set."""
    patches = value if isinstance(value, sc.PatchSet) else [value]
    grids = [patch.evaluate_grid(*(np.linspace(*range_, count) for range_ in patch.domain)) for patch in patches]
    return np.concatenate([grid.reshape(-1, 3) for grid in grids])


def distance(ob):
    """How far dense points of the surface lie from the mesh, at most."""
    tree = BVHTree.FromPolygons(vertices(ob.data).tolist(), [tuple(face.vertices) for face in ob.data.polygons])
    return max(tree.find_nearest(point)[3] for point in surface_points(ob.data.splinewright.value).tolist())


def require_closed(ob):
    counts = np.zeros(len(ob.data.edges), int)
    for loop in ob.data.loops:
        counts[loop.edge_index] += 1
    assert (counts == 2).all()


@pytest.mark.parametrize('tolerance', (0.05, 0.01))
def test_no_point_of_the_teapot_is_farther_from_its_mesh_than_the_tolerance(tolerance):
    ob = add(starters.teapot())
    settings = ob.data.splinewright
    settings.tolerance = tolerance
    settings.mode = 'TOLERANCE'
    assert distance(ob) <= tolerance * 1.001
    require_exact(ob)


def test_flat_parts_have_few_faces_and_the_panel_knows_how_many_there_were():
    ob = add(sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]]))
    assert len(ob.data.polygons) == 16 and ob.data.splinewright.faces_before == 0
    ob.data.splinewright.mode = 'TOLERANCE'
    assert len(ob.data.polygons) == 1 and ob.data.splinewright.faces_before == 16
    ob.data.splinewright.sharp_angle = 0.5
    assert ob.data.splinewright.faces_before == 16, "the same faces are no change of their number"
    ob.data.splinewright.mode = 'COUNT'
    assert len(ob.data.polygons) == 16 and ob.data.splinewright.faces_before == 1


@pytest.mark.parametrize('angle', (20, 8))
def test_normals_turn_by_no_more_than_the_angle_on_a_face(angle):
    op(bpy.ops.splinewright.add_torus)
    ob = bpy.context.object
    ob.data.splinewright.angle = math.radians(angle)
    ob.data.splinewright.mode = 'ANGLE'
    normals = corner_normals(ob.data)
    for face in ob.data.polygons:
        own = normals[face.loop_start:face.loop_start + face.loop_total].astype(float)
        assert np.degrees(np.arccos(np.clip(own @ own.T, -1, 1)).max()) <= angle + 0.1
    require_closed(ob)


def test_both_promises_take_the_faces_of_the_finer():
    ob = add(starters.teapot())
    counts = {}
    for mode in ('TOLERANCE', 'ANGLE', 'BOTH'):
        ob.data.splinewright.mode = mode
        counts[mode] = len(ob.data.polygons)
    assert counts['BOTH'] >= max(counts['TOLERANCE'], counts['ANGLE'])


def test_a_setting_is_undone_and_kept_in_a_file(tmp_path):
    ob = add(starters.teapot())
    ob.data.splinewright.mode = 'TOLERANCE'
    fine = len(ob.data.polygons)
    bpy.ops.ed.undo_push(message="mode")
    ob.data.splinewright.mode = 'COUNT'
    bpy.ops.ed.undo_push(message="count")
    bpy.ops.ed.undo()
    ob = bpy.data.objects["shape"]
    assert ob.data.splinewright.mode == 'TOLERANCE' and len(ob.data.polygons) == fine
    require_exact(ob)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "fine.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "fine.blend"))
    ob = bpy.data.objects["shape"]
    assert ob.data.splinewright.mode == 'TOLERANCE' and len(ob.data.polygons) == fine
    require_exact(ob)


def test_what_would_be_too_fine_is_said_and_the_mesh_stays():
    op(bpy.ops.splinewright.add_sphere, faces_mode='COUNT')
    ob = bpy.context.object
    before = vertices(ob.data).copy()
    ob.data.splinewright.mode = 'TOLERANCE'
    fine = vertices(ob.data).copy()
    ob.data.splinewright.tolerance = 1e-9
    assert "2^21" in ob.data.splinewright.problem and np.array_equal(vertices(ob.data), fine)
    ob.data.splinewright.tolerance = 0.01
    assert ob.data.splinewright.problem == ""
    ob.data.splinewright.mode = 'COUNT'
    assert np.array_equal(vertices(ob.data), before)


def test_a_drag_keeps_the_faces_and_its_end_gives_those_that_the_shape_asks_for():
    ob = add(sc.BezierPatch([[(x, y, 0.0) for y in range(4)] for x in range(4)]))
    settings = ob.data.splinewright
    settings.tolerance = 0.01
    settings.mode = 'TOLERANCE'
    assert len(ob.data.polygons) == 1
    held = enter()
    select(held, 5)
    move(0, 0, 0.5)
    first = len(ob.data.polygons)
    assert first > 1
    for _ in range(3):
        move(0, 0, 0.5)
        assert len(ob.data.polygons) == first
    editing.finalize()
    settled = len(ob.data.polygons)
    assert settled > first and distance(ob) <= 0.0101
    move(0, 0, -0.1)
    assert len(ob.data.polygons) == settled, "the faces of the last step are taken over"
    leave()
    assert not shape.is_touched(ob.data) and distance(ob) <= 0.0101
    require_exact(ob)


def test_a_setting_changed_while_a_net_is_out_holds_for_the_next_move():
    ob = add(VALUES['nurbs patch']())
    held = enter()
    select(held, first_point(held))
    move(0, 0, 0.5)
    ob.data.splinewright.mode = 'TOLERANCE'
    move(0, 0, 0.5)
    ob.data.splinewright.mode = 'COUNT'
    move(0, 0, 0.5)
    leave()
    require_exact(ob)


def test_undo_after_a_settled_drag_shows_what_was():
    ob = add(starters.teapot())
    ob.data.splinewright.mode = 'TOLERANCE'
    bpy.ops.ed.undo_push(message="mode")
    before = vertices(ob.data).copy()
    held = enter()
    select(held, first_point(held))
    move(0, 0, 1)
    move(0, 0, 1)
    leave()
    while bpy.context.mode != 'OBJECT' or bpy.data.objects["shape"].data.splinewright.value != starters.teapot():
        bpy.ops.ed.undo()
    assert np.array_equal(vertices(bpy.data.objects["shape"].data), before)


# What a user put on the faces ----------------------------------------------------------------------


def sheet():
    """Over [0, 3]², x = 3 u and y = 3 v; it bends, so that a tolerance takes faces of several sizes."""
    net = np.array([[(x, y, 0.0) for y in range(4)] for x in range(4)])
    net[1, 1, 2] = 2.0
    return add(sc.BezierPatch(net))


def read(attribute, field, numbers=1):
    flat = np.empty(numbers * len(attribute.data), np.float32)
    attribute.data.foreach_get(field, flat)
    return flat.reshape(-1, numbers)


def corner_positions(mesh):
    return vertices(mesh)[[loop.vertex_index for loop in mesh.loops]]


def face_positions(mesh):
    return np.array([np.mean([vertices(mesh)[v] for v in face.vertices], axis=0) for face in mesh.polygons])


def refine(ob):
    ob.data.splinewright.tolerance = 0.02
    ob.data.splinewright.mode = 'TOLERANCE'


def test_numbers_on_vertices_and_corners_lie_where_they_lay():
    ob = sheet()
    ob.data.splinewright.set_resolution(9, 7)
    mesh = ob.data
    heat = mesh.attributes.new("heat", 'FLOAT', 'POINT')
    heat.data.foreach_set('value', vertices(mesh)[:, 0] * 2)
    paint = mesh.attributes.new("paint", 'FLOAT_COLOR', 'CORNER')
    colors = np.ones((len(mesh.loops), 4), np.float32)
    colors[:, :2] = corner_positions(mesh)[:, :2] / 3
    paint.data.foreach_set('color', colors.ravel())
    refine(ob)
    assert len(mesh.polygons) != 63
    assert np.allclose(read(mesh.attributes["heat"], 'value')[:, 0], 2 * vertices(mesh)[:, 0], atol=1e-4)
    now = read(mesh.attributes["paint"], 'color', 4)
    assert np.allclose(now[:, :2], corner_positions(mesh)[:, :2] / 3, atol=2e-3) and (now[:, 2:] == 1).all()


def test_whole_numbers_and_switches_are_those_of_the_nearest_place():
    ob = sheet()
    mesh = ob.data
    mesh.attributes.new("half", 'BOOLEAN', 'FACE').data.foreach_set('value', face_positions(mesh)[:, 0] > 1.5)
    mesh.attributes.new("third", 'INT', 'POINT').data.foreach_set('value', (vertices(mesh)[:, 1] > 1.6).astype(np.int32))
    refine(ob)
    centers = face_positions(mesh)
    half = np.array([item.value for item in mesh.attributes["half"].data])
    sure = np.abs(centers[:, 0] - 1.5) > 0.01
    assert (half[sure] == (centers[sure, 0] > 1.5)).all() and half.any() and not half.all()
    third = np.array([item.value for item in mesh.attributes["third"].data])
    y = vertices(mesh)[:, 1]
    assert (third[y < 1.5] == 0).all() and (third[y > 2.3] == 1).all()


def test_vertex_groups_keep_their_weights():
    ob = sheet()
    group = ob.vertex_groups.new(name="soft")
    for i, point in enumerate(vertices(ob.data)):
        group.add([i], float(point[1] / 3), 'REPLACE')
    refine(ob)
    for i, point in enumerate(vertices(ob.data)):
        entries = [entry.weight for entry in ob.data.vertices[i].groups]
        assert (entries[0] if entries else 0.0) == pytest.approx(point[1] / 3, abs=1e-4)
    assert [group.name for group in ob.vertex_groups] == ["soft"]


def test_uv_maps_of_a_user_stay_and_ours_follows_where_it_was_not_touched():
    ob = sheet()
    mesh = ob.data
    own = mesh.uv_layers.new(name="turned", do_init=False)
    flat = (corner_positions(mesh)[:, 1::-1] / 3).ravel()
    set_uvs(own, flat)
    mesh.uv_layers.active = own
    refine(ob)
    assert np.allclose(uvs(mesh.uv_layers["turned"]), corner_positions(mesh)[:, 1::-1] / 3, atol=2e-3)
    assert np.allclose(uvs(mesh.uv_layers["UVMap"]), corner_positions(mesh)[:, :2] / 3, atol=1e-6)
    assert mesh.uv_layers.active.name == "turned"
    set_uvs(mesh.uv_layers["UVMap"], 2 * uvs(mesh.uv_layers["UVMap"]).ravel())
    mesh.splinewright.mode = 'COUNT'
    assert np.allclose(uvs(mesh.uv_layers["UVMap"]), 2 * corner_positions(mesh)[:, :2] / 3, atol=4e-3)


def uvs(layer):
    data, field = (layer.uv, 'vector') if hasattr(layer, 'uv') else (layer.data, 'uv')
    flat = np.empty(2 * len(data), np.float32)
    data.foreach_get(field, flat)
    return flat.reshape(-1, 2)


def set_uvs(layer, flat):
    data, field = (layer.uv, 'vector') if hasattr(layer, 'uv') else (layer.data, 'uv')
    data.foreach_set(field, np.ascontiguousarray(flat, np.float32))


def test_materials_of_patches_modifiers_and_colors_stay_whatever_faces_there_are():
    ob = add(starters.teapot())
    for name in ("china", "gold"):
        ob.data.materials.append(bpy.data.materials.new(name))
    modifier = ob.modifiers.new("thick", 'SOLIDIFY')
    modifier.thickness = 0.07
    assert op(bpy.ops.splinewright.set_patch_material, piece=5, slot=2) == {'FINISHED'}
    for mode in ('TOLERANCE', 'ANGLE', 'BOTH', 'COUNT'):
        ob.data.splinewright.mode = mode
        patches = np.array([item.value for item in ob.data.attributes["patch"].data])
        materials = np.array([face.material_index for face in ob.data.polygons])
        assert ((materials == 1) == (patches == 4)).all() and (materials == 1).any()
    assert ob.modifiers["thick"].thickness == pytest.approx(0.07)


def test_a_patch_or_slot_that_is_not_there_is_refused():
    ob = add(starters.teapot())
    with pytest.raises(RuntimeError, match="0 material slots"):
        op(bpy.ops.splinewright.set_patch_material, piece=1)
    ob.data.materials.append(bpy.data.materials.new("china"))
    with pytest.raises(RuntimeError, match="32 patches, there is none of number 33"):
        op(bpy.ops.splinewright.set_patch_material, piece=33)
    assert op(bpy.ops.splinewright.set_patch_material) == {'FINISHED'}
    add(VALUES['nurbs']())
    assert not bpy.ops.splinewright.set_patch_material.poll()


# The render ----------------------------------------------------------------------------------------


def camera_at(height, **settings):
    """Looks down on the middle, 100 x 50 pixels, 90° wide."""
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location = (0, 0, height)
    camera.data.angle = math.radians(90)
    for name, value in settings.items():
        setattr(camera.data, name, value)
    scene = bpy.context.scene
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 100, 50, 100
    bpy.context.view_layer.update()
    return camera


def test_a_pixel_is_as_long_as_the_camera_sees_it_where_the_shape_is_nearest():
    op(bpy.ops.splinewright.add_sphere, faces_mode='COUNT')
    ob = bpy.context.object
    camera_at(5.0)
    assert op(bpy.ops.splinewright.tolerance_from_render, pixels=0.5) == {'FINISHED'}
    # 4 before the camera, where 8 are 100 pixels.
    assert ob.data.splinewright.mode == 'TOLERANCE' and ob.data.splinewright.tolerance == pytest.approx(0.04, rel=1e-4)
    ob.scale = (2, 2, 2)
    bpy.context.view_layer.update()
    op(bpy.ops.splinewright.tolerance_from_render, pixels=0.5)
    assert ob.data.splinewright.tolerance == pytest.approx(0.5 * 6 / 100 / 2, rel=1e-4)


def test_a_camera_without_perspective_sees_every_place_alike():
    op(bpy.ops.splinewright.add_sphere, faces_mode='COUNT')
    camera_at(5.0, type='ORTHO', ortho_scale=10.0)
    op(bpy.ops.splinewright.tolerance_from_render, pixels=1.0)
    assert bpy.context.object.data.splinewright.tolerance == pytest.approx(0.1, rel=1e-4)


def test_without_a_camera_or_behind_it_nothing_changes():
    op(bpy.ops.splinewright.add_sphere, faces_mode='COUNT')
    ob = bpy.context.object
    bpy.context.scene.camera = None
    with pytest.raises(RuntimeError, match="no camera"):
        op(bpy.ops.splinewright.tolerance_from_render)
    camera_at(-5.0)
    with pytest.raises(RuntimeError, match="behind the camera"):
        op(bpy.ops.splinewright.tolerance_from_render)
    assert ob.data.splinewright.mode == 'COUNT'


def set_scale(ob, scale):
    ob.scale = (scale,) * 3
    bpy.context.view_layer.update()


def test_what_no_tolerance_shows_is_said_and_the_settings_stay():
    op(bpy.ops.splinewright.add_sphere, faces_mode='COUNT')
    ob = bpy.context.object
    camera = camera_at(5.0)
    ob.data.splinewright.tolerance = 0.5
    faces = len(ob.data.polygons)

    def require_refused(word):
        with pytest.raises(RuntimeError, match=word):
            op(bpy.ops.splinewright.tolerance_from_render)
        settings = ob.data.splinewright
        assert (settings.mode, settings.tolerance, settings.problem) == ('COUNT', 0.5, "")
        assert len(ob.data.polygons) == faces
    camera.data.lens = 1e6
    require_refused("2\\^21")
    camera.data.lens = 1e9
    require_refused("less than the least")
    set_scale(ob, 0.0)
    require_refused("has a scale of 0: no camera")
    set_scale(ob, 1.0)
    set_scale(camera, 0.0)
    require_refused("the camera has a scale of 0")


def test_several_shapes_are_set_at_once():
    first = add(VALUES['nurbs patch'](), "first")
    second = add(starters.teapot(), "second")
    camera_at(20.0)
    activate(first, second)
    assert op(bpy.ops.splinewright.tolerance_from_render) == {'FINISHED'}
    assert first.data.splinewright.mode == second.data.splinewright.mode == 'TOLERANCE'


# Facets or smoothness ------------------------------------------------------------------------------


def exact_normals(ob):
    value = ob.data.splinewright.value
    patch_set = value if isinstance(value, sc.PatchSet) else sc.PatchSet.from_patches([value])
    return part('bridge.data.tessellate').tessellated(ob.data, patch_set).evaluate(patch_set)[1]


def largest_angle(a, b):
    return np.degrees(np.arccos(np.clip((a.astype(float) * b).sum(1), -1, 1)).max())


def test_normals_turn_with_the_faces_while_points_move_and_are_exact_at_the_end():
    x, y = np.meshgrid(range(5), range(5), indexing='ij')
    ob = add(sc.BezierPatch(np.stack([x, y, 0 * x], -1)))
    held = enter()
    select(held, 7, 8)
    for _ in range(3):
        before = corner_normals(ob.data)
        move(0, 0, 2)
        assert part('bridge.data.store').is_draft(ob.data)
        exact = exact_normals(ob)
        assert (corner_normals(ob.data) * exact).sum(1).mean() > 0.95 > (before * exact).sum(1).mean()
    editing.finalize()
    assert largest_angle(corner_normals(ob.data), exact_normals(ob)) < 0.1
    assert not part('bridge.data.store').is_draft(ob.data)
    leave()


@pytest.mark.parametrize('smooth', (False, True))
def test_one_definition_gives_a_thousand_faces_or_ten_thousand_flat_or_smooth(smooth):
    ob = add(starters.teapot())
    for face in ob.data.polygons:
        face.use_smooth = smooth
    counts = []
    for resolution in (6, 18):
        ob.data.splinewright.set_resolution(resolution, resolution)
        counts.append(len(ob.data.polygons))
        flags = np.empty(len(ob.data.polygons), bool)
        ob.data.polygons.foreach_get('use_smooth', flags)
        assert (flags == smooth).all()
        normals = corner_normals(ob.data)
        spread = max(np.ptp(normals[face.loop_start:face.loop_start + face.loop_total], axis=0).max()
                     for face in ob.data.polygons)
        assert (spread > 0.01) == smooth
    assert 1000 <= counts[0] <= 1300 and 9_800 <= counts[1] <= 11_000
    assert ob.data.splinewright.value == starters.teapot()
