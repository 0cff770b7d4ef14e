"""Patches that share points go on sharing them, keep their looks, and are chosen by number."""

import bpy
import numpy as np
import pytest

import shapes
from curves import run
from patches import DIRECTIONS, farthest, meetings, patches_of, value_of
from shapes import activate, add, op, require_exact
from support import corner_normals, part, splinecore as sc, vertices

patch_verbs, extract, mesh_looks, shape, store = (part(name) for name in (
    'ui.operators.patch_verbs', 'ui.operators.extract', 'bridge.mesh_looks', 'bridge.shape', 'bridge.store'))
AT = {'parameter_u': 0.3, 'parameter_v': 0.3}
KEPT_EDGES = (('patch_insert_knot', {'where': 'SPANS'}), ('patch_raise_degree', {'times': 2}), ('patch_reverse', {}),
              ('patch_reparametrise', {'end': 3.0}),
              ('patch_reparametrise', {'how': 'MOEBIUS', 'rho': 1.0}), ('patch_swap', {}), ('patch_to_nurbs', {}))


def settings_for(name, settings, direction):
    return settings if name in ('patch_swap', 'patch_to_nurbs') else {**settings, 'direction': direction}


@pytest.mark.parametrize('kind', ('teapot', 'four around a corner'))
@pytest.mark.parametrize('name, settings', KEPT_EDGES)
def test_edges_that_were_shared_are_shared_and_no_others(name, settings, kind):
    before = value_of(kind)
    ob = add(before)
    assert run(name, **settings_for(name, settings, 'BOTH')) == {'FINISHED'}
    after = ob.data.splinewright.value
    assert meetings(after).keys() == meetings(before).keys()
    assert after.edge_counts() == before.edge_counts()
    for i in range(len(before)):
        assert farthest(before[i], [after[i]], name, {**settings, 'direction': 'BOTH'}) < 1e-12
    require_exact(ob)
    bpy.ops.ed.undo()
    assert bpy.data.objects["shape"].data.splinewright.value == before


def test_the_teapot_of_higher_degree_has_as_many_points_as_its_patches_edges_and_corners_ask_for():
    ob = add(value_of('teapot'))
    for degree in (4, 5):
        run('patch_raise_degree', direction='BOTH')
        # 52 shared edges, 16 free ones, and 37 corners, of which two are poles
        assert len(ob.data.splinewright.value.points) == 32 * (degree - 1) ** 2 + 68 * (degree - 1) + 37


@pytest.mark.parametrize('direction', DIRECTIONS)
def test_parts_of_a_split_share_the_cut_and_what_the_whole_shared(direction):
    ob = add(value_of('four around a corner'))
    run('patch_split', direction=direction, parameter_u=0.5, parameter_v=0.5)
    cut, counts = ob.data.splinewright.value, 4 if direction == 'BOTH' else 2
    assert len(cut) == 4 * counts
    if direction == 'BOTH':
        assert cut.edge_counts() == {'shared': 24, 'free': 16, 'pole': 0}
        assert len(cut.points) == 13 * 13
    require_exact(ob)


def test_edges_are_shared_wherever_the_points_lie():
    for offset in (1e6, -1e9):
        before = value_of('four around a corner')
        before = before.with_points(before.points + (offset, 0, 3), before.weights)
        ob = add(before)
        run('patch_raise_degree', times=3, direction='BOTH')
        assert set(meetings(ob.data.splinewright.value).values()) == {7}
    far = value_of('four around a corner')
    points = far.points.copy()
    points[far.patches[0]['indices'][-1]] *= 1e6
    ob = add(far.with_points(points, far.weights))
    run('patch_raise_degree', direction='BOTH')
    assert set(meetings(ob.data.splinewright.value).values()) == {5}


def test_a_patch_and_its_bezier_patches_have_one_pool():
    for kind, shared, free in (('plain nurbs', 12, 12), ('torus', 32, 0), ('sphere', 12, 0)):
        ob = add(value_of(kind))
        run('patch_to_bezier')
        counts = ob.data.splinewright.value.edge_counts()
        assert (counts['shared'], counts['free']) == (shared, free), kind


def test_unclamped_patches_meet_no_more_in_points_and_are_where_they_were():
    before = value_of('four around a corner')
    ob = add(before)
    run('patch_unclamp', direction='BOTH')
    after = patches_of(ob)
    assert max(farthest(before[i], [after[i]], 'patch_unclamp', {}) for i in range(4)) < 1e-12
    assert meetings(ob.data.splinewright.value) == {}
    assert ob.data.splinewright.value.edge_counts() == before.edge_counts(), "edges are known by their places"


def test_a_single_patch_keeps_points_apart_that_lie_in_one_place():
    ob = add(value_of('sphere'))
    count = len(store.read(ob.data).pool)
    run('patch_reverse')
    assert len(store.read(ob.data).pool) == count and isinstance(ob.data.splinewright.value, sc.NurbsPatch)


def test_patches_that_touch_and_share_nothing_go_on_sharing_nothing():
    patch = value_of('bicubic')
    other = patch.with_points(patch.points + (0, 0, 1))
    ob = add(sc.PatchSet.from_patches([patch, other, patch], merge=False))
    run('patch_raise_degree', direction='BOTH')
    assert len(ob.data.splinewright.value.points) == 75


def test_one_piece_is_done_and_the_others_keep_their_rows():
    before = value_of('four around a corner')
    ob = add(before)
    run('patch_raise_degree', piece=2, direction='BOTH')
    after = ob.data.splinewright.value
    assert [patch.degree for patch in patches_of(ob)] == [(3, 3), (4, 4), (3, 3), (3, 3)]
    assert all(after[i] == before[i] for i in (0, 2, 3))
    rows = [set(patch['indices'].ravel().tolist()) for patch in after.patches]
    assert len(rows[0] & rows[1]) == 2 and len(rows[1] & rows[3]) == 2, "corners alone, of edges with other points"
    assert len(rows[0] & rows[2]) == 4 and len(rows[0] & rows[3]) == 1
    run('patch_lower_degree', piece=2, direction='BOTH')
    assert meetings(ob.data.splinewright.value) == meetings(before), "they meet again"
    op(bpy.ops.splinewright.patch_raise_degree, piece=3)
    op(bpy.ops.splinewright.patch_reverse)
    assert patches_of(ob)[0] != before[0], "the piece is not remembered"


def test_a_set_of_hermite_patches_shares_points_and_handles():
    net = value_of('ferguson')
    before = sc.PatchSet.from_patches(net.split('u', 1.0))
    ob = add(before)
    run('patch_split', direction='V', parameter_v=0.5)
    after = ob.data.splinewright.value
    assert len(after) == 4 and {(0, 1), (2, 3), (0, 2), (1, 3)} <= meetings(after).keys()
    shapes.enter()
    shapes.leave()
    assert bpy.data.objects["shape"].data.splinewright.value == after


# How it looks -----------------------------------------------------------------------------------------------------


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
    return mesh_looks.Look(i, i % 2 == 0)


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
    ('patch_split', {'piece': 2, **AT}, [0, 1, 1, 2]),
    ('patch_split', {'direction': 'BOTH', **AT}, [0] * 4 + [1] * 4 + [2] * 4),
    ('patch_to_bezier', {'piece': 1}, [0, 0, 0, 1, 2]), ('patch_reverse', {}, [0, 1, 2]), ('patch_swap', {}, [0, 1, 2]),
    ('patch_insert_knot', {'where': 'SPANS'}, [0, 1, 2])))
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


@pytest.mark.parametrize('name, settings', (('patch_reverse', {}), ('patch_swap', {})))
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
    assert resolution == ((5, 3) if name == 'patch_swap' else (3, 5))
    require_exact(ob)
    bpy.ops.ed.undo()
    settings_of = bpy.data.objects["shape"].data.splinewright
    assert (settings_of.resolution_u, settings_of.resolution_v) == (3, 5)


# Which shapes -----------------------------------------------------------------------------------------------------


def test_every_selected_shape_is_done_those_that_share_data_once_and_failures_are_named():
    first, second, third = (add(value_of(kind), kind) for kind in ('plain nurbs', 'bicubic', 'biquintic'))
    twin = bpy.data.objects.new("twin", first.data)
    bpy.context.scene.collection.objects.link(twin)
    curve = add(sc.BezierCurve(shapes.points(3)), "curve")
    activate(twin, first, second, third, curve)
    assert run('patch_raise_degree') == {'FINISHED'}
    assert [ob.data.splinewright.value.degree[0] for ob in (first, twin, second, third)] == [4, 4, 4, 6]
    assert run('patch_lower_degree', times=4) == {'FINISHED'}, "biquintic alone has so many"
    assert [ob.data.splinewright.value.degree[0] for ob in (first, twin, second, third)] == [4, 4, 4, 2]
    with pytest.raises(RuntimeError, match="(?s)(plain nurbs|twin).*bicubic.*biquintic"):
        run('patch_lower_degree', times=9)


def test_every_verb_is_in_the_menu_and_in_the_sidebar():
    tools = part('ui.patch_tools')
    listed = [name for _, names in tools._GROUPS for name in names]
    assert sorted(listed) == sorted(cls.bl_idname.split('.')[1] for cls in (*patch_verbs.CLASSES, *extract.CLASSES))
    drawn = []

    class Layout:
        def operator(self, name, **_):
            drawn.append(name)

        def __getattr__(self, _):
            return lambda *args, **kw: self

    class Self:
        layout = Layout()
    for draw in (tools.SPLINEWRIGHT_MT_patch.draw, tools.SPLINEWRIGHT_PT_patch_tools.draw):
        drawn.clear()
        draw(Self, bpy.context)
        assert drawn == [f"splinewright.{name}" for name in listed]


# The redo panel ---------------------------------------------------------------------------------------------------


CHOICES = {'direction': tuple(DIRECTIONS), 'where': ('PARAMETER', 'KNOTS', 'SPANS'), 'how': ('AFFINE', 'MOEBIUS'),
           'limited': (False, True)}


@pytest.mark.parametrize('cls', (*patch_verbs.CLASSES, *extract.CLASSES), ids=lambda cls: cls.bl_idname)
def test_every_setting_is_described_and_shown(cls):
    rna = getattr(bpy.ops.splinewright, cls.bl_idname.split('.')[1]).get_rna_type()
    properties = {p.identifier: p for p in rna.properties if p.identifier != 'rna_type'}
    assert all(p.name and (p.description or p.type == 'ENUM') for p in properties.values())
    assert {'REGISTER', 'UNDO'} <= cls.bl_options and cls.bl_description and not cls.bl_description.endswith('.')
    shown_names = set()
    for name, values in CHOICES.items():
        for value in values:
            drawn = drawn_by(cls, {**{key: p.default for key, p in properties.items()}, name: value})
            assert set(drawn) <= set(properties) and drawn[-1] == 'piece' and len(set(drawn)) == len(drawn)
            shown_names |= set(drawn)
    assert shown_names == set(properties)


def drawn_by(cls, values):
    """Names of the properties in the redo panel. Operators cannot be made by hand, what they inherit can."""
    names = []

    class Layout:
        def prop(self, _, name, expand=False):
            names.append(name)

        def row(self):
            return self
    own = {key: value for key, value in vars(cls).items() if key == 'settings'}
    bases = tuple(base for base in cls.__bases__ if not issubclass(base, bpy.types.Operator))
    panel = type("Panel", bases, {**own, '__annotations__': dict(cls.__annotations__), **values, 'layout': Layout()})()
    panel.draw(None)
    return names
