"""What users put on edges, and what Blender hides among attributes, stays when the faces change."""

import bpy
import numpy as np
import pytest

from curves import run
from patches import value_of
from shapes import activate, add, enter, first_point, leave, move, op, require_exact, select
from support import part, splinecore as sc, vertices

mesh_marks, shape, versions = (part(f'bridge.{name}') for name in ('mesh.mesh_marks', 'shape.shape', 'data.versions'))
OLD = not versions.marks_are_attributes


class Field:
    """A mark that is a field of edges."""

    def __init__(self, name, value):
        self.name, self.value = name, value

    def get(self, mesh):
        found = np.zeros(len(mesh.edges), bool if self.value is True else np.float32)
        mesh.edges.foreach_get(self.name, found)
        return found

    def set(self, mesh, values):
        mesh.edges.foreach_set(self.name, np.ascontiguousarray(values))
        mesh.update()


class Attribute:
    """A mark that is an attribute of edges."""

    def __init__(self, name, data_type, value):
        self.name, self.data_type, self.value = name, data_type, value

    def get(self, mesh):
        attribute = mesh.attributes.get(self.name)
        if attribute is None:
            return np.zeros(len(mesh.edges), np.array(self.value).dtype)
        return np.array([item.value for item in attribute.data])

    def set(self, mesh, values):
        attribute = mesh.attributes.get(self.name) or mesh.attributes.new(self.name, self.data_type, 'EDGE')
        for item, value in zip(attribute.data, values.tolist()):
            item.value = value


MARKS = {'seam': Field('use_seam', True), 'sharp': Field('use_edge_sharp', True),
         'mine': Attribute('mine', 'FLOAT', 0.25), 'counted': Attribute('counted', 'INT', 7),
         'crease': Field('crease', 0.5) if OLD else Attribute('crease_edge', 'FLOAT', 0.5),
         'bevel': Field('bevel_weight', 0.5) if OLD else Attribute('bevel_weight_edge', 'FLOAT', 0.5),
         'freestyle': (Field('use_freestyle_mark', True) if 'use_freestyle_mark' in bpy.types.MeshEdge.bl_rna.properties
                       else Attribute('freestyle_edge', 'BOOLEAN', True))}


def sheet(resolution=4):
    """On [0, 3] x [0, 3], where x is 3 u and y is 3 v."""
    net = np.array([[(x, y, 0.0) for y in range(4)] for x in range(4)])
    net[1, 1, 2] = 2.0
    ob = add(sc.BezierPatch(net))
    ob.data.splinewright.set_resolution(resolution, resolution)
    return ob


def ends(mesh):
    """(edges, 2, 3): where they begin and end."""
    pairs = np.array([tuple(edge.vertices) for edge in mesh.edges])
    return vertices(mesh)[pairs]


def lie_at(mesh, axis, *places):
    """(edges,) whether each lies where x or y is one of these."""
    across = ends(mesh)[:, :, axis]
    return np.any([np.abs(across - place).max(1) < 1e-4 for place in (*places, np.inf)], axis=0)


def put(ob, mark, *places, axis=0):
    mark.set(ob.data, np.where(lie_at(ob.data, axis, *places), mark.value, type(mark.value)(0)))
    bpy.ops.ed.undo_push(message="mark")


def require_marked(ob, mark, *places, axis=0):
    """Edges there have the mark, and no others."""
    found, expected = mark.get(ob.data), lie_at(ob.data, axis, *places)
    # Blender 3.4 saves creases as bytes.
    assert np.array_equal(np.abs(found * 1.0 - mark.value) < 0.01, expected) and not found[~expected].any()
    return expected.sum()


def resolve(ob, *resolutions):
    for resolution in resolutions:
        ob.data.splinewright.set_resolution(resolution, resolution)
        assert ob.data.splinewright.problem == ""
        require_exact(ob)


# Other faces ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize('name', MARKS)
def test_marks_on_lines_that_both_meshes_have_stay_and_others_come_back(name):
    mark, ob = MARKS[name], sheet()
    put(ob, mark, 0.0, 1.5)
    assert require_marked(ob, mark, 0.0, 1.5) == 8
    resolve(ob, 8)
    assert require_marked(ob, mark, 0.0, 1.5) == 16
    resolve(ob, 7)
    assert require_marked(ob, mark, 0.0) == 7, "seven faces have no line in the middle"
    resolve(ob, 5, 3, 1, 2, 4)
    assert require_marked(ob, mark, 0.0, 1.5) == 8


def test_all_marks_at_once_along_both_axes():
    ob = sheet()
    for i, mark in enumerate(MARKS.values()):
        put(ob, mark, 0.75 * (i % 4), axis=i % 2)
    resolve(ob, 5, 12)
    for i, mark in enumerate(MARKS.values()):
        assert require_marked(ob, mark, 0.75 * (i % 4), axis=i % 2) == 12


@pytest.mark.parametrize('name', ('seam', 'crease'))
def test_parts_of_lines_stay_parts(name):
    mark, ob = MARKS[name], sheet()
    lies = lie_at(ob.data, 0, 1.5) & (ends(ob.data)[:, :, 1].max(1) < 0.8)
    mark.set(ob.data, np.where(lies, mark.value, type(mark.value)(0)))
    resolve(ob, 9, 3, 8)
    found = mark.get(ob.data).astype(bool)
    assert np.array_equal(found, lie_at(ob.data, 0, 1.5) & (ends(ob.data)[:, :, 1].max(1) < 0.8)) and found.sum() == 2


@pytest.mark.parametrize('name', MARKS)
def test_what_is_changed_where_the_line_is_shown_counts(name):
    mark, ob = MARKS[name], sheet()
    put(ob, mark, 0.0, 1.5)
    resolve(ob, 5)
    put(ob, mark, 3.0)
    resolve(ob, 8)
    require_marked(ob, mark, 1.5, 3.0)
    put(ob, mark)
    resolve(ob, 4)
    require_marked(ob, mark)


@pytest.mark.parametrize('name', MARKS)
def test_marks_are_there_on_adaptive_faces_and_after_saving(name, tmp_path):
    mark, ob = MARKS[name], sheet()
    put(ob, mark, 0.0, 1.5)
    ob.data.splinewright.tolerance = 0.02
    ob.data.splinewright.mode = 'TOLERANCE'
    require_exact(ob)
    assert require_marked(ob, mark, 0.0, 1.5) > 8
    ob.data.splinewright.mode = 'COUNT'
    resolve(ob, 5)
    path = str(tmp_path / "saved.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    ob = bpy.data.objects["shape"]
    resolve(ob, 4)
    assert require_marked(ob, mark, 0.0, 1.5) == 8


@pytest.mark.parametrize('kind', ('sphere', 'torus', 'cylinder', 'teapot', 'nurbs patch', 'mixed set'))
def test_all_edges_that_are_lines_of_finer_faces_stay_marked(kind):
    ob, mark = add(value_of(kind)), MARKS['seam']
    ob.data.splinewright.set_resolution(3, 3)
    mark.set(ob.data, np.ones(len(ob.data.edges), bool))
    resolve(ob, 6)
    half = mark.get(ob.data)
    resolve(ob, 5, 3)
    assert mark.get(ob.data).all()
    resolve(ob, 6)
    assert np.array_equal(mark.get(ob.data), half) and 0.3 < half.mean() < 0.7


def test_meridians_keep_their_marks_to_the_pole():
    ob, mark = add(value_of('sphere')), MARKS['seam']
    ob.data.splinewright.set_resolution(4, 4)
    ends_now = ends(ob.data)
    assert (np.abs(ends_now[:, :, 1]).max(1) < 1e-5).sum() > 4, "no meridian lies in the plane y = 0"
    put(ob, mark, 0.0, axis=1)
    resolve(ob, 8)
    require_marked(ob, mark, 0.0, axis=1)


@pytest.mark.parametrize('damaged', (3, "x", {'0': 3}, {'0': {'name': "mine"}}, {'certain': True},
                                     {'0': {'name': "use_seam", 'type': "FIELD", 'kind': "|b1", 'numbers': 1,
                                            'lines': [0.0] * 4, 'values': [1.0]}},
                                     {'0': {'name': "x", 'type': "nothing", 'kind': "<f4", 'numbers': 1,
                                            'lines': [0.0] * 5, 'values': [1.0]}}))
def test_a_damaged_note_is_passed_over(damaged):
    mark, ob = MARKS['seam'], sheet()
    put(ob, mark, 0.0, 1.5)
    resolve(ob, 8)
    ob.data[mesh_marks.KEY] = damaged
    resolve(ob, 4)
    require_marked(ob, mark, 0.0, 1.5)
    assert ob.data.splinewright.problem == ""


def test_a_mesh_without_marks_is_noted_nowhere():
    ob = sheet()
    resolve(ob, 5)
    assert mesh_marks.KEY not in ob.data.keys()


# Verbs ----------------------------------------------------------------------------------------------------------------


VERBS = (('reverse', {}), ('reverse', {'direction': 'BOTH'}), ('swap_uv', {}), ('raise_degree', {}),
         ('split', {'where': 'PARAMETER', 'direction': 'U', 'parameter_u': 0.5, 'parameter_v': 0.5}),
         ('split', {'where': 'PARAMETER', 'direction': 'V', 'parameter_u': 0.5, 'parameter_v': 0.25}),
         ('split', {'where': 'PARAMETER', 'direction': 'BOTH', 'parameter_u': 0.25, 'parameter_v': 0.75}),
         ('reparameterize', {'how': 'AFFINE', 'start': 2.0, 'end': 3.0}))


@pytest.mark.parametrize('mark', ('seam', 'crease', 'sharp', 'counted'))
@pytest.mark.parametrize('name, settings', VERBS)
def test_marks_stay_in_their_place_after_a_verb(name, settings, mark):
    mark, ob = MARKS[mark], sheet(8)
    put(ob, mark, 0.0, 1.5)
    resolve(ob, 7)                      # 1.5 is hidden
    names = {p.identifier for p in getattr(bpy.ops.splinewright, name).get_rna_type().properties}
    run(name, **{key: value for key, value in settings.items() if key in names})
    require_exact(ob)
    resolve(ob, 16)
    require_marked(ob, mark, 0.0, 1.5)
    bpy.ops.ed.undo_push(message="resolution")


def test_marks_on_knots_become_those_of_borders_and_of_both_sides():
    knots = [0, 0, 0, 0, 1, 2, 2, 2, 2]
    net = np.array([[(x, y, x * y % 2) for y in range(5)] for x in range(5)], float)
    ob, mark = add(sc.NurbsPatch((3, 3), (knots, knots), net)), MARKS['seam']
    ob.data.splinewright.set_resolution(6, 6)
    middle = [float(value) for value in np.unique(np.round(ends(ob.data)[:, :, 0], 5))][6]
    put(ob, mark, middle)
    count = require_marked(ob, mark, middle)
    run('to_bezier')
    assert require_marked(ob, mark, middle) == count and len(ob.data.splinewright.value) == 4


def test_moebius_there_and_back():
    ob, mark = sheet(8), MARKS['seam']
    put(ob, mark, 0.0, 1.5)
    run('reparameterize', how='MOEBIUS', rho=2.0)
    require_marked(ob, mark, 0.0)
    run('reparameterize', how='MOEBIUS', rho=0.5)
    require_marked(ob, mark, 0.0, 1.5)


def test_marks_stay_where_they_are_if_the_mesh_cannot_be_made(monkeypatch):
    ob, mark = sheet(), MARKS['seam']
    put(ob, mark, 0.0, 1.5)
    resolve(ob, 5)

    def refuse(*_):
        raise ValueError("too much to show")
    with monkeypatch.context() as patch:
        patch.setattr(shape, 'evaluated', refuse)
        with pytest.raises(RuntimeError, match="too much to show"):
            run('reverse')
    require_marked(ob, mark, 0.0)
    resolve(ob, 4)
    require_marked(ob, mark, 0.0, 1.5)


# Sharp edges ----------------------------------------------------------------------------------------------------------


def folded():
    """Two bicubic sheets with a crease where x is 3."""
    nets = [np.array([[(x + 3 * i, y, x * (1 - 2 * i) + 3 * i) for y in range(4)] for x in range(4)], float)
            for i in range(2)]
    ob = add(sc.PatchSet.from_patches([sc.BezierPatch(net) for net in nets]))
    ob.data.splinewright.set_resolution(4, 4)
    return ob


def test_sharp_edges_of_the_surface_and_those_of_the_user_are_both_there():
    ob, mark = folded(), MARKS['sharp']
    require_marked(ob, mark, 3.0)
    marked = mark.get(ob.data) | lie_at(ob.data, 0, 1.5)
    mark.set(ob.data, marked)
    require_marked(ob, mark, 1.5, 3.0)
    resolve(ob, 8, 5)
    require_marked(ob, mark, 3.0)
    resolve(ob, 4)
    require_marked(ob, mark, 1.5, 3.0)
    ob.data.splinewright.sharp_angle = 3.0
    # Before Blender 4.5 custom normals that differ make an edge sharp.
    require_marked(ob, mark, *((1.5,) if bpy.app.version >= (4, 5, 0) else (1.5, 3.0)))
    ob.data.splinewright.sharp_angle = 0.1
    require_marked(ob, mark, 1.5, 3.0)


def test_a_users_sharp_edges_outlast_a_drag_and_a_crease_that_comes_and_goes():
    ob, mark = folded(), MARKS['sharp']
    ob.data.splinewright.sharp_angle = 3.0
    put(ob, mark, 3.0)
    ob.data.splinewright.sharp_angle = 0.1
    ob.data.splinewright.sharp_angle = 3.0
    require_marked(ob, mark, 3.0)
    held = enter()
    select(held, first_point(held))
    move(0, 0, 0.5)
    ob = leave()
    require_marked(ob, mark, 3.0)


def test_edges_that_are_not_sharp_any_more_are_not_taken_for_a_users():
    ob, mark = folded(), MARKS['sharp']
    require_marked(ob, mark, 3.0)
    for resolution in (8, 4):
        resolve(ob, resolution)
        require_marked(ob, mark, 3.0)
    held = enter()
    numbers = [i for i, place in enumerate(np.round(vertices(held.data), 3)) if place[0] > 3.01]
    select(held, *numbers)
    bpy.ops.transform.resize('EXEC_DEFAULT', True, value=(1, 1, -1), center_override=(3, 0, 3))
    ob = leave()
    require_exact(ob)
    require_marked(ob, mark)


# Hidden layers --------------------------------------------------------------------------------------------------------


def test_the_sculpt_mask_and_face_sets_stay():
    ob = sheet(8)
    mesh = ob.data
    mask, sets = mesh.attributes.new('.sculpt_mask', 'FLOAT', 'POINT'), mesh.attributes.new('.sculpt_face_set', 'INT', 'FACE')
    for item, place in zip(mask.data, vertices(mesh)):
        item.value = place[0] / 3
    for item, polygon in zip(sets.data, mesh.polygons):
        item.value = 1 + (polygon.center.x > 1.5)
    resolve(ob, 5, 16)
    masked = np.array([item.value for item in mesh.attributes['.sculpt_mask'].data])
    assert np.abs(masked - vertices(mesh)[:, 0] / 3).max() < 1e-4
    for item, polygon in zip(mesh.attributes['.sculpt_face_set'].data, mesh.polygons):
        assert item.value == 1 + (polygon.center.x > 1.5) or abs(polygon.center.x - 1.5) < 0.4


@pytest.mark.skipif(not OLD, reason="from Blender 4 on these are attributes")
def test_masks_creases_of_vertices_and_face_maps_of_blender_3_stay():
    import bmesh
    ob = sheet(8)
    copy = bmesh.new()
    copy.from_mesh(ob.data)
    mask, crease = copy.verts.layers.paint_mask.verify(), copy.verts.layers.crease.verify()
    maps = copy.faces.layers.face_map.verify()
    for vertex in copy.verts:
        vertex[mask], vertex[crease] = vertex.co.x / 3, vertex.co.y / 3
    for face in copy.faces:
        face[maps] = 3
    copy.to_mesh(ob.data)
    copy.free()
    for vertex in ob.data.vertices:
        vertex.bevel_weight = vertex.co.x / 3
    resolve(ob, 5, 16)
    places = vertices(ob.data)
    for collection, axis in ((ob.data.vertex_paint_masks, 0), (ob.data.vertex_creases, 1)):
        found = np.array([item.value for item in collection[0].data])
        assert np.abs(found - places[:, axis] / 3).max() < 1e-4
    assert np.abs([vertex.bevel_weight - vertex.co.x / 3 for vertex in ob.data.vertices]).max() < 0.01
    assert {item.value for item in ob.data.face_maps[0].data} == {3}
    require_exact(ob)


def test_hidden_faces_stay_hidden_with_what_lies_between_them():
    ob = sheet(8)
    for polygon in ob.data.polygons:
        polygon.hide = polygon.center.x < 1.5
    resolve(ob, 16)
    for polygon in ob.data.polygons:
        assert polygon.hide == (polygon.center.x < 1.5)
    for vertex in ob.data.vertices:
        assert vertex.hide == (vertex.co.x < 1.4)
    assert np.array_equal([edge.hide for edge in ob.data.edges], ends(ob.data)[:, :, 0].min(1) < 1.4)


def pins(mesh):
    """Which corners are pinned, and the name of the field."""
    return (mesh.uv_layers["UVMap"].data, 'pin_uv') if OLD else (mesh.attributes['.pn.UVMap'].data, 'value')


def test_pinned_corners_stay_pinned():
    ob = sheet()
    if not OLD:
        ob.data.attributes.new('.pn.UVMap', 'BOOLEAN', 'CORNER')
    items, name = pins(ob.data)
    for corner, item in zip(ob.data.loops, items):
        setattr(item, name, ob.data.vertices[corner.vertex_index].co.x < 0.1)
    resolve(ob, 8)
    items, name = pins(ob.data)
    places = np.array([ob.data.vertices[corner.vertex_index].co.x for corner in ob.data.loops])
    found = np.array([getattr(item, name) for item in items])
    assert found[places < 0.1].all() and not found[places > 0.8].any()


@pytest.mark.parametrize('name, settings', ((None, {}), ('split', {'direction': 'U', 'parameter_u': 0.5}),
                                            ('reverse', {}), ('swap_uv', {})))
def test_materials_and_shading_of_single_faces_stay_where_they_are(name, settings):
    ob = sheet(8)
    for word in ("red", "blue"):
        ob.data.materials.append(bpy.data.materials.new(word))
    for polygon in ob.data.polygons:
        polygon.material_index, polygon.use_smooth = int(polygon.center.x > 0.75), polygon.center.y > 0.75
    bpy.ops.ed.undo_push(message="dress")
    if name is not None:
        run(name, **settings)
    resolve(ob, 16)
    for polygon in ob.data.polygons:
        assert (polygon.material_index, polygon.use_smooth) == (polygon.center.x > 0.75, polygon.center.y > 0.75)


# Joining --------------------------------------------------------------------------------------------------------------


def test_joined_shapes_keep_what_was_put_on_each():
    first, second = sheet(8), sheet(4)
    second.location.x = 4
    bpy.context.view_layer.update()
    red, blue = (bpy.data.materials.new(name) for name in ("red", "blue"))
    for material in (red, blue):
        second.data.materials.append(material)
    first.data.materials.append(blue)
    for polygon in second.data.polygons:
        polygon.material_index = int(polygon.center.x > 1.5)
    for ob, height in ((first, 1.0), (second, 2.0)):
        color = ob.data.attributes.new("place", 'FLOAT_VECTOR', 'POINT')
        color.data.foreach_set('vector', (vertices(ob.data) * height).ravel())
    MARKS['mine'].set(first.data, np.where(lie_at(first.data, 0, 0.0), 0.25, 0.0))
    MARKS['mine'].set(second.data, np.where(lie_at(second.data, 0, 1.5), 0.25, 0.0))
    MARKS['seam'].set(second.data, lie_at(second.data, 0, 0.0))
    MARKS['sharp'].set(second.data, lie_at(second.data, 0, 3.0))
    second.vertex_groups.new(name="soft").add(list(range(len(second.data.vertices))), 0.5, 'REPLACE')
    other = second.data.attributes.new("word", 'INT', 'FACE')
    other.data.foreach_set('value', np.full(len(second.data.polygons), 3, np.int32))
    activate(first, second)
    assert op(bpy.ops.splinewright.join) == {'FINISHED'}
    resolve(first, 8)
    mesh, places = first.data, vertices(first.data)
    require_marked(first, MARKS['mine'], 0.0, 5.5)
    require_marked(first, MARKS['seam'], 4.0)
    require_marked(first, MARKS['sharp'], 7.0)
    said = np.empty(3 * len(places), np.float32)
    mesh.attributes["place"].data.foreach_get('vector', said)
    said, is_second = said.reshape(-1, 3), np.arange(len(places)) >= len(places) // 2
    assert np.abs(said[~is_second] - places[~is_second]).max() < 1e-5
    assert np.abs(said[is_second][:, :2] / 2 + (4, 0) - places[is_second][:, :2]).max() < 1e-4
    assert [m.name for m in mesh.materials] == ["blue", "red"]
    assert all(polygon.material_index == (4 < polygon.center.x < 5.5) for polygon in mesh.polygons)
    weights = [sum(entry.weight for entry in vertex.groups) for vertex in mesh.vertices]
    assert np.allclose(weights, np.where(is_second, 0.5, 0.0))
    words = np.array([item.value for item in mesh.attributes["word"].data])
    assert set(words[:64]) == {0} and set(words[64:]) == {3}
    assert not shape.is_touched(mesh)


def test_what_blenders_own_surface_cannot_have_is_said():
    ob = sheet()
    for name in ('seam', 'mine'):
        put(ob, MARKS[name], 1.5)
    ob.data.attributes.new("heat", 'FLOAT', 'POINT')
    ob.data.uv_layers.new(name="second")
    outcome, _ = part('bridge.native.to_native').to_native(bpy.context, ob)
    assert outcome.dropped == ["the UV map second", "the attribute heat", "marks of edges"]
    assert part('bridge.native.to_native').to_native(bpy.context, sheet())[0].dropped == []
