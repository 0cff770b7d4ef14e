"""Normals that Blender takes by lists: those of vertices give the bits that those of all corners give."""

import gc

import numpy as np
import pytest

from shapes import VALUES, add
from support import part, splinecore as sc

definition, fineness, mesh_layers, store, write_mesh = (part(name) for name in (
    'core.shape.definition', 'bridge.data.tessellate', 'bridge.mesh.mesh_layers', 'bridge.data.store', 'bridge.mesh.write_mesh'))


def shown(mesh):
    flat = np.empty(3 * len(mesh.loops), np.float32)
    if hasattr(mesh, 'calc_normals_split'):
        mesh.calc_normals_split()
        mesh.loops.foreach_get('normal', flat)
    else:
        mesh.corner_normals.foreach_get('vector', flat)
    return flat.reshape(-1, 3)


def exact(mesh):
    patch_set = definition.to_patch_set(store.read(mesh))
    return fineness.tessellated(mesh, patch_set).evaluate(patch_set)[1]


def agree(mesh, normals):
    vertices = mesh_layers.corner_vertices(mesh)
    first = np.unique(vertices, return_index=True)[1]
    return np.array_equal(normals[first][vertices], normals)


@pytest.mark.parametrize('name', ('nurbs patch', 'bezier patch', 'teapot', 'mixed set'))
def test_both_ways_to_give_them_give_the_same_bits(name):
    mesh = add(VALUES[name]()).data
    if 'custom_normal' in mesh.attributes and mesh.attributes['custom_normal'].data_type == 'FLOAT_VECTOR':
        mesh.attributes.remove(mesh.attributes['custom_normal'])
    normals = exact(mesh)
    mesh.normals_split_custom_set(normals.tolist())
    of_corners = shown(mesh)
    write_mesh._set_split_normals(mesh, normals, mesh_layers.corner_vertices(mesh))
    assert np.array_equal(shown(mesh), of_corners)
    assert np.abs(of_corners - normals).max() < 0.01


def test_one_is_smooth_and_one_is_not():
    assert {agree(mesh, exact(mesh)) for mesh in (add(VALUES[name]()).data for name in ('nurbs patch', 'teapot'))} == {
        True, False}


@pytest.mark.parametrize('is_enabled', (True, False))
def test_garbage_is_collected_afterwards_as_before(is_enabled):
    mesh = add(sc.BezierPatch(np.random.default_rng(1).normal(size=(3, 3, 3)))).data
    was_enabled = gc.isenabled()
    try:
        (gc.enable if is_enabled else gc.disable)()
        write_mesh._set_split_normals(mesh, exact(mesh), mesh_layers.corner_vertices(mesh))
        assert gc.isenabled() == is_enabled
        with pytest.raises(ZeroDivisionError), write_mesh._uncollected():
            1 / 0
        assert gc.isenabled() == is_enabled
    finally:
        (gc.enable if was_enabled else gc.disable)()
