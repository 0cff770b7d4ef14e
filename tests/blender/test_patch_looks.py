"""How patches look after their verbs: materials, shading, normals, and what users painted on them."""

import bpy
import numpy as np
import pytest

import shapes
from curves import run
from patches import patches_of, value_of
from shapes import activate, add, op, require_exact
from support import corner_normals, part, splinecore as sc, vertices

Look = part('bridge.data.shading').Look
mesh_layers, mesh_looks, shape = (part(f'bridge.{name}') for name in ('mesh.mesh_layers', 'mesh.mesh_looks', 'shape.shape'))
AT = {'parameter_u': 0.3, 'parameter_v': 0.3}


def dressed(value, name="shape"):
    """A shape whose patches differ in material and shading."""
    ob = add(value, name)
    for i in range(len(patches_of(ob))):
        ob.data.materials.append(bpy.data.materials.new(str(i)))
    mesh_looks.set_looks(ob.data, {i: look(i) for i in range(len(ob.data.materials))})
    shape.rewrite(ob.data)
    bpy.ops.ed.undo_push(message="dress")
    return ob


def look(i):
    return Look(i, i % 2 == 0)


def looks_of(ob):
    return [look for _, look in sorted(mesh_looks.looks_by_patch(ob.data).items())]


def require_flat_normals(ob):
    """The corners of flat faces, of which there are some, have the normals of their faces."""
    flat, normals = [polygon for polygon in ob.data.polygons if not polygon.use_smooth], corner_normals(ob.data)
    assert flat
    for polygon in flat:
        corners = np.s_[polygon.loop_start:polygon.loop_start + polygon.loop_total]
        assert np.allclose(normals[corners], polygon.normal, atol=1e-3)


def test_flat_patches_that_are_joined_stay_flat():
    first, second = dressed(value_of('bicubic'), "first"), dressed(value_of('four around a corner'), "second")
    activate(first, second)
    op(bpy.ops.splinewright.join)
    assert [look.use_smooth for look in looks_of(first)] == [True, True, False, True, False]
    require_flat_normals(first)


@pytest.mark.parametrize('name, settings, expected', (
    ('split', {'piece': 2, **AT}, [0, 1, 1, 2]),
    ('split', {'direction': 'BOTH', **AT}, [0] * 4 + [1] * 4 + [2] * 4),
    ('to_bezier', {'piece': 1}, [0, 0, 0, 1, 2]), ('reverse', {}, [0, 1, 2]), ('swap_uv', {}, [0, 1, 2]),
    ('insert_knot', {'where': 'SPANS'}, [0, 1, 2])))
def test_material_and_shading_stay_with_each_patch(name, settings, expected):
    first = sc.NurbsPatch((3, 3), (shapes.CLAMPED, [0, 0, 0, 0, 1, 1, 1, 1]), shapes.points(6, 4))
    ob = dressed(sc.PatchSet.from_patches([first, value_of('bicubic'), value_of('bezier patch')]))
    run(name, **settings)
    assert looks_of(ob) == [look(i) for i in expected]
    assert len(ob.data.materials) == 3
    require_flat_normals(ob)
    assert not shape.is_touched(ob.data)
    bpy.ops.ed.undo()
    assert looks_of(bpy.data.objects["shape"]) == [look(i) for i in range(3)]


@pytest.mark.parametrize('name, settings', (('reverse', {}), ('swap_uv', {})))
def test_a_turned_patch_shows_the_same_points_and_its_normals_are_turned(name, settings):
    ob = add(value_of('plain nurbs'))
    ob.data.splinewright.set_resolution(3, 5)
    bpy.ops.ed.undo_push(message="resolution")
    before = {tuple(co) for co in np.round(vertices(ob.data), 5).tolist()}
    normal = np.array(ob.data.polygons[0].normal), ob.data.polygons[0].center.copy()
    run(name, **settings)
    assert {tuple(co) for co in np.round(vertices(ob.data), 5).tolist()} == before
    nearest = min(ob.data.polygons, key=lambda polygon: (polygon.center - normal[1]).length)
    assert np.allclose(nearest.normal, -normal[0], atol=1e-4)
    resolution = ob.data.splinewright.resolution_u, ob.data.splinewright.resolution_v
    assert resolution == ((5, 3) if name == 'swap_uv' else (3, 5))
    require_exact(ob)
    bpy.ops.ed.undo()
    settings_of = bpy.data.objects["shape"].data.splinewright
    assert (settings_of.resolution_u, settings_of.resolution_v) == (3, 5)


CARRIED = (('reverse', {'direction': 'BOTH'}), ('reverse', {}), ('swap_uv', {}), ('to_bezier', {}),
           ('split', {'direction': 'BOTH', **AT}), ('split', {'where': 'KNOTS'}),
           ('raise_degree', {}), ('insert_knot', {'direction': 'V', **AT}),
           ('reparameterize', {'how': 'MOEBIUS', 'rho': 3.0}))


def painted(ob):
    """Colors, vertex groups and a UV map that say where a point lies."""
    mesh, places = ob.data, vertices(ob.data)
    colors = mesh.attributes.new("place", 'FLOAT_VECTOR', 'POINT')
    colors.data.foreach_set('vector', places.ravel())
    group = ob.vertex_groups.new(name="height")
    for i, place in enumerate(places):
        group.add([i], float(0.5 + place[2] / 4), 'REPLACE')
    bpy.ops.ed.undo_push(message="paint")


def farthest_paint(ob):
    """How far points lie from where what is painted says, colors and weights."""
    places, said = vertices(ob.data), np.empty(3 * len(ob.data.vertices), np.float32)
    ob.data.attributes["place"].data.foreach_get('vector', said)
    weights = [vertex.groups[0].weight for vertex in ob.data.vertices]
    return np.abs(said.reshape(-1, 3) - places).max(), np.abs(np.array(weights) - 0.5 - places[:, 2] / 4).max()


@pytest.mark.parametrize('kind', ('plain nurbs', 'nurbs patch'))
@pytest.mark.parametrize('name, settings', CARRIED)
def test_what_is_painted_stays_in_its_place(name, settings, kind):
    ob = add(value_of(kind))
    ob.data.splinewright.set_resolution(24, 24)
    painted(ob)
    run(name, **settings)
    color, weight = farthest_paint(ob)
    # Faces across a cut are those of one part; the other has what lies nearest to it.
    most = 0.25 if name == 'split' and 'where' not in settings else 0.02
    assert color < most and weight < most / 3
    uvs = np.empty(2 * len(ob.data.loops), np.float32)
    ob.data.uv_layers["UVMap"].data.foreach_get('uv', uvs)
    assert np.array_equal(uvs.reshape(-1, 2), mesh_layers.parameters(ob.data)[:, :2]), "the UV map of a shape is its parameters"


def test_what_is_painted_stays_where_it_is_if_the_mesh_cannot_be_made(monkeypatch):
    ob = add(value_of('bicubic'))
    painted(ob)

    def lying():
        return [tuple(entry.vector) for entry in ob.data.attributes["parameters"].data], farthest_paint(ob)

    def refuse(*_):
        raise ValueError("too much to show")
    before = lying()
    monkeypatch.setattr(shape, 'evaluated', refuse)
    with pytest.raises(RuntimeError, match="too much to show"):
        run('reverse')
    assert lying() == before and before[1][0] == 0
