"""What bridge/data/versions.py says of this Blender is so, and since the version that it says."""

import bpy
import numpy as np
import pytest

import blender_objects
from support import corner_normals, part

versions, mesh_edges, native = part('bridge.data.versions'), part('bridge.mesh.mesh_edges'), part('core.native.native')
SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
NORMALS = np.array([(0.1, 0.2, 1.0), (0.3, -0.1, 1.0), (0.0, 0.4, 1.0), (-0.2, 0.2, 1.0)])
NORMALS /= np.linalg.norm(NORMALS, axis=1)[:, None]


def square():
    mesh = bpy.data.meshes.new("square")
    mesh.from_pydata(SQUARE, [], [(0, 1, 2, 3)])
    mesh.polygons[0].use_smooth = True
    return mesh


def vertices_of_a_curve(flags, resolution, count=7, degree=3):
    ob = blender_objects.curve_object()
    net = np.random.default_rng(1).uniform(-1, 1, (count, 4)).astype(np.float32).astype(float)
    net[:, 3] = 1
    blender_objects.set_nurbs_spline(ob, net, native.Direction(count, degree, flags), resolution)
    return net[:, :3], blender_objects.evaluated_vertices(ob)


def samples_by_span():
    _, found = vertices_of_a_curve(native.Flags(), 2)
    assert len(found) in (9, 12)            # four spans, or seven points
    return len(found) == 9


def shows_the_polygon():
    net, found = vertices_of_a_curve(native.Flags(cyclic=True), 1)
    return np.array_equal(net, found)


def keeps_exact_normals():
    mesh = square()
    mesh.attributes.new('custom_normal', 'FLOAT_VECTOR', 'CORNER').data.foreach_set('vector', NORMALS.astype(np.float32).ravel())
    mesh.update()
    return np.abs(corner_normals(mesh) - NORMALS).max() < 1e-6


def needs_auto_smooth():
    """For custom normals to show."""
    mesh = square()
    mesh.normals_split_custom_set(NORMALS.tolist())
    return np.abs(corner_normals(mesh) - NORMALS).max() > 0.1


def leaves_faces_without_totals():
    mesh = bpy.data.meshes.new("square")
    mesh.vertices.add(4)
    mesh.loops.add(4)
    mesh.polygons.add(1)
    mesh.polygons.foreach_set('loop_start', [0])
    return mesh.polygons[0].loop_total != 4


def uv_maps_are_attributes():
    mesh = square()
    return mesh.uv_layers.new(name="map").name in mesh.attributes


def creases_are_attributes():
    mesh = square()
    try:
        mesh.edges[0].crease = 1
    except AttributeError:
        return True
    return False


def keys_lie_in_layers():
    ob = bpy.data.objects.new("keyed", None)
    ob.keyframe_insert('location', frame=1)
    return bool(getattr(ob.animation_data.action, 'layers', None))


def knows_what_presets_skip():
    members = {'probe': bpy.props.StringProperty(options={'SKIP_PRESET'})}
    probe = type('SPLINEWRIGHT_Probe', (bpy.types.PropertyGroup,), {'__annotations__': members})
    try:
        bpy.utils.register_class(probe)
    except ValueError:
        return False
    bpy.utils.unregister_class(probe)
    return True


#: A fact, how it shows, and the versions from which on and until which it holds.
FACTS = {'by span': (versions.sampling.by_span, samples_by_span, (5, 0, 0), None),
         'polygon': (versions.sampling.polygon_at_1, shows_the_polygon, (4, 2, 0), (5, 0, 0)),
         'normals': (versions.keeps_exact_normals, keeps_exact_normals, (4, 5, 0), None),
         'auto smooth': (versions.has_auto_smooth, needs_auto_smooth, None, (4, 2, 0)),
         'totals': (versions.wants_face_totals, leaves_faces_without_totals, None, (4, 2, 0)),
         'uvs': (versions.uvs_are_attributes, uv_maps_are_attributes, (4, 2, 0), None),
         'marks': (versions.marks_are_attributes, creases_are_attributes, (4, 2, 0), None),
         'layers': (versions.actions_have_layers, keys_lie_in_layers, (4, 4, 0), None),
         'presets': (versions.has_skip_preset, knows_what_presets_skip, (4, 2, 0), None),
         'files': (versions.drops_files, lambda: hasattr(bpy.types, 'SPLINEWRIGHT_FH_bpt'), (4, 2, 0), None),
         'failed saves': (versions.tells_of_failed_saves, lambda: 'save_post_fail' in dir(bpy.app.handlers), (4, 2, 0), None),
         'folders': (versions.has_extension_folders, lambda: 'extension_path_user' in dir(bpy.utils), (4, 2, 0), None),
         'modal': (versions.knows_modal_operators, lambda: hasattr(bpy.context.window, 'modal_operators'), (4, 2, 0), None)}


@pytest.mark.parametrize('fact, measured, start, end', FACTS.values(), ids=FACTS)
def test_a_fact_is_as_measured_and_its_boundary_is_known(fact, measured, start, end):
    assert fact == measured()
    version = bpy.app.version
    assert fact == ((start is None or version >= start) and (end is None or version < end))


def test_every_fact_is_measured():
    public = {name for name in vars(versions) if not name.startswith('_')} - {'bpy', 'gpu', 'cache', 'native', 'name'}
    assert public == {'sampling', 'keeps_exact_normals', 'has_auto_smooth', 'wants_face_totals', 'uvs_are_attributes',
                      'marks_are_attributes', 'actions_have_layers', 'has_skip_preset', 'drops_files', 'tells_of_failed_saves',
                      'has_extension_folders', 'knows_modal_operators', 'point_shader'}          # of which a window tells
    assert versions.sampling._fields == ('by_span', 'polygon_at_1')


def test_calculated_edges_have_a_selection_of_the_right_type_or_none():
    """5.0.0 and 5.0.1 give them pairs of numbers; whoever selected one of them crashed."""
    mesh = bpy.data.meshes.new("square")
    mesh.vertices.add(4)
    mesh.loops.add(4)
    mesh.polygons.add(1)
    mesh.loops.foreach_set('vertex_index', [0, 1, 2, 3])
    mesh.polygons.foreach_set('loop_start', [0])
    if versions.wants_face_totals:
        mesh.polygons.foreach_set('loop_total', [4])
    mesh_edges.calculate(mesh)
    assert len(mesh.edges) == 4
    for flag in (True, False):
        mesh.edges.foreach_set('select', np.full(4, flag))
        assert [edge.select for edge in mesh.edges] == [flag] * 4
    mesh.edges[2].select = True
    assert [edge.select for edge in mesh.edges] == [False, False, True, False]


@pytest.mark.parametrize('add', ['add_teapot', 'add_nurbs_patch', 'add_sphere'])
def test_edges_of_a_shape_can_be_selected(add):
    getattr(bpy.ops.splinewright, add)()
    mesh = bpy.context.object.data
    mesh.edges.foreach_set('select', np.ones(len(mesh.edges), bool))
    assert all(edge.select for edge in mesh.edges)
    selection = mesh.attributes.get('.select_edge')
    assert selection is None or selection.data_type == 'BOOLEAN'
