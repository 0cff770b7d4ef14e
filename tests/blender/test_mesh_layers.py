"""What users put on a mesh, of every type that this Blender has, stays when the faces change."""

import bpy
import numpy as np
import pytest

from patches import value_of
from shapes import activate, add, op, require_exact
from support import part, splinecore as sc, vertices

mesh_layers, shape = part('bridge.mesh.mesh_layers'), part('bridge.shape.shape')
#: For each type a value and how it is read.
VALUES = {'FLOAT': ('value', 0.5), 'INT': ('value', 70_000), 'INT8': ('value', -7), 'BOOLEAN': ('value', True),
          'FLOAT_VECTOR': ('vector', (1.0, 2.0, 3.0)), 'FLOAT_COLOR': ('color', (0.25, 0.5, 0.75, 0.5)),
          'BYTE_COLOR': ('color', (0.0, 1.0, 0.0, 1.0)), 'FLOAT2': ('vector', (0.5, 2.0)), 'STRING': ('value', "clay"),
          'INT16_2D': ('value', (-3, 300)), 'INT32_2D': ('value', (-3, 70_000)),
          'QUATERNION': ('value', (0.0, 1.0, 0.0, 0.0)), 'FLOAT4': ('vector', (0.5, 1.0, 2.0, 4.0)),
          'FLOAT4X4': ('value', tuple(range(16)))}
TYPES = [item.identifier for item in bpy.types.Attribute.bl_rna.properties['data_type'].enum_items]


def sheet():
    net = np.array([[(x, y, 0.0) for y in range(4)] for x in range(4)])
    net[1, 1, 2] = 2.0
    return add(sc.BezierPatch(net))


def refine(ob):
    before = len(ob.data.polygons)
    ob.data.splinewright.tolerance = 0.02
    ob.data.splinewright.mode = 'TOLERANCE'
    assert len(ob.data.polygons) != before
    require_exact(ob)


def plain(value):
    """As a tuple of numbers, or what it is."""
    if isinstance(value, (str, bytes, bool, int, float)):
        return value
    return tuple(np.array(value, dtype=float).ravel().tolist())


def text_of(attribute, text):
    """As this Blender takes it: bytes in newer ones."""
    return text.encode() if isinstance(attribute.data[0].value, bytes) else text


def fill(attribute, name, value):
    if attribute.data_type == 'STRING':
        value = text_of(attribute, value)
    for item in attribute.data:
        if attribute.data_type == 'FLOAT4X4':
            setattr(item, name, np.reshape(value, (4, 4)).tolist())
        else:
            setattr(item, name, value)


def test_the_table_knows_every_type_of_this_blender():
    assert not set(TYPES) - set(VALUES)
    assert not set(TYPES) - set(part('bridge.mesh.mesh_layers').ATTRIBUTES)


@pytest.mark.parametrize('domain', ('POINT', 'FACE', 'CORNER'))
@pytest.mark.parametrize('data_type', TYPES)
def test_a_layer_of_one_value_has_it_on_other_faces(data_type, domain):
    ob = sheet()
    attribute = ob.data.attributes.new("mine", data_type, domain)
    name, value = VALUES[data_type]
    fill(attribute, name, value)
    expected = plain(getattr(attribute.data[0], name))
    refine(ob)
    attribute = ob.data.attributes["mine"]
    assert (attribute.data_type, attribute.domain) == (data_type, domain) and len(attribute.data)
    for item in attribute.data:
        found = plain(getattr(item, name))
        assert found == (pytest.approx(expected, abs=1e-5) if isinstance(found, (tuple, float)) else expected)


def test_texts_are_those_of_the_nearest_place():
    ob = sheet()
    attribute = ob.data.attributes.new("side", 'STRING', 'POINT')
    left, right = (text_of(attribute, text) for text in ("left", "right"))
    for item, place in zip(attribute.data, vertices(ob.data)):
        item.value = left if place[0] < 1.5 else right
    refine(ob)
    for item, place in zip(ob.data.attributes["side"].data, vertices(ob.data)):
        if abs(place[0] - 1.5) > 0.8:
            assert item.value == (left if place[0] < 1.5 else right)


def test_the_layers_that_are_shown_and_rendered_stay_so():
    ob = sheet()
    mesh = ob.data
    for name in ("second", "third"):
        mesh.uv_layers.new(name=name)
    mesh.uv_layers.active = mesh.uv_layers["second"]
    mesh.uv_layers["third"].active_render = True
    for name in ("first", "other", "last"):
        mesh.color_attributes.new(name, 'FLOAT_COLOR', 'POINT')
    mesh.color_attributes.active_color = mesh.color_attributes["other"]
    mesh.color_attributes.render_color_index = mesh.color_attributes.keys().index("last")
    refine(ob)
    assert mesh.uv_layers.active.name == "second"
    assert [layer.name for layer in mesh.uv_layers if layer.active_render] == ["third"]
    assert (mesh.color_attributes.active_color_name, mesh.color_attributes.default_color_name) == ("other", "last")


def test_locked_groups_the_active_one_and_their_order_stay():
    ob = sheet()
    for name in ("c", "a", "b"):
        ob.vertex_groups.new(name=name).add([0], 0.5, 'REPLACE')
    ob.vertex_groups["a"].lock_weight = True
    ob.vertex_groups.active_index = 2
    refine(ob)
    assert [(group.name, group.lock_weight) for group in ob.vertex_groups] == [("c", False), ("a", True), ("b", False)]
    assert ob.vertex_groups.active_index == 2


def test_groups_of_linked_duplicates_stay_with_both():
    ob = sheet()
    ob.vertex_groups.new(name="soft").add([0, 1, 2], 1.0, 'REPLACE')
    twin = ob.copy()
    bpy.context.scene.collection.objects.link(twin)
    twin.modifiers.new("mask", 'MASK').vertex_group = "soft"
    activate(ob)
    refine(ob)
    assert [group.name for group in twin.vertex_groups] == ["soft"] and twin.modifiers["mask"].vertex_group == "soft"
    assert any(vertex.groups for vertex in ob.data.vertices)


@pytest.mark.parametrize('name', ("patch", "parameters"))
@pytest.mark.parametrize('data_type, domain', (
    ('FLOAT_VECTOR', 'POINT'), ('BOOLEAN', 'CORNER'), ('FLOAT_COLOR', 'FACE')))
def test_a_layer_that_only_has_the_name_of_ours_does_no_harm(name, data_type, domain):
    ob = sheet()
    ob.data.attributes.remove(ob.data.attributes[name])
    ob.data.attributes.new(name, data_type, domain)
    assert bpy.ops.splinewright.reverse('EXEC_DEFAULT', True) == {'FINISHED'}
    refine(ob)
    assert not shape.is_touched(ob.data)
    ob.data.materials.append(bpy.data.materials.new("clay"))
    assert bpy.ops.splinewright.set_patch_material('EXEC_DEFAULT', True, piece=1) == {'FINISHED'}


def test_there_may_be_as_many_uv_maps_as_blender_takes():
    ob = sheet()
    ob.data.uv_layers["UVMap"].name = "renamed"
    names = ["renamed"] + [f"map {i}" for i in range(7)]
    for name in names[1:]:
        ob.data.uv_layers.new(name=name)
    refine(ob)
    assert {layer.name for layer in ob.data.uv_layers} - {"UVMap"} == set(names)


def test_where_corners_lie_is_kept_for_vertices_where_that_is_enough():
    """A patch alone needs a quarter of the room; where patches meet, or one is closed, corners of a vertex differ."""
    def domain_of(value):
        ob = add(value)
        refine(ob)
        corners = mesh_layers.parameters(ob.data)
        assert corners.shape == (len(ob.data.loops), 3) and 0 <= corners[:, :2].min() and corners[:, :2].max() <= 1
        assert [attribute.name for attribute in ob.data.attributes].count("parameters") == 1
        return ob.data.attributes["parameters"].domain
    patch = sc.BezierPatch(np.random.default_rng(1).random((4, 4, 3)))
    assert domain_of(patch) == 'POINT'
    assert domain_of(sc.PatchSet.from_patches(patch.to_nurbs().split('u', 0.5))) == 'CORNER'
    assert domain_of(sc.build.sphere((0, 0, 0), 1.0)) == 'CORNER'
    ob = add(patch)
    run = bpy.ops.splinewright.split
    assert run('EXEC_DEFAULT', True, direction='U') == {'FINISHED'}
    assert ob.data.attributes["parameters"].domain == 'CORNER'


def test_texts_on_both_shapes_stay_when_they_are_joined():
    first, second = add(value_of('bicubic'), "first"), add(value_of('bicubic'), "second")
    for ob in (first, second):
        attribute = ob.data.attributes.new("side", 'STRING', 'POINT')
        for item in attribute.data:
            item.value = text_of(attribute, ob.name)
    second.location.x = 50
    activate(second, first)
    bpy.context.view_layer.objects.active = first
    bpy.context.view_layer.update()
    assert op(bpy.ops.splinewright.join) == {'FINISHED'}
    attribute = first.data.attributes["side"]
    for item, place in zip(attribute.data, vertices(first.data)):
        assert item.value == text_of(attribute, "second" if place[0] > 25 else "first")
