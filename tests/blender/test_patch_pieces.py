"""Patches that share points go on sharing them, and are chosen by number; menus and the redo panel."""

from types import SimpleNamespace

import bpy
import pytest

import shapes
from curves import run
from patches import DIRECTIONS, farthest, meetings, patches_of, value_of
from shapes import activate, add, op, require_exact
from support import part, splinecore as sc

extract, store = part('ui.operators.extract'), part('bridge.data.store')
KEPT_EDGES = (('insert_knot', {'where': 'SPANS'}), ('raise_degree', {'times': 2}), ('reverse', {}),
              ('reparameterize', {'end': 3.0}),
              ('reparameterize', {'how': 'MOEBIUS', 'rho': 1.0}), ('swap_uv', {}), ('to_nurbs', {}))


def settings_for(name, settings, direction):
    return settings if name in ('swap_uv', 'to_nurbs') else {**settings, 'direction': direction}


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
        run('raise_degree', direction='BOTH')
        # 52 shared edges, 16 free ones, and 37 corners, of which two are poles
        assert len(ob.data.splinewright.value.points) == 32 * (degree - 1) ** 2 + 68 * (degree - 1) + 37


@pytest.mark.parametrize('direction', DIRECTIONS)
def test_parts_of_a_split_share_the_cut_and_what_the_whole_shared(direction):
    ob = add(value_of('four around a corner'))
    run('split', direction=direction, parameter_u=0.5, parameter_v=0.5)
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
        run('raise_degree', times=3, direction='BOTH')
        assert set(meetings(ob.data.splinewright.value).values()) == {7}
    far = value_of('four around a corner')
    points = far.points.copy()
    points[far.patches[0]['indices'][-1]] *= 1e6
    ob = add(far.with_points(points, far.weights))
    run('raise_degree', direction='BOTH')
    assert set(meetings(ob.data.splinewright.value).values()) == {5}


def test_a_patch_and_its_bezier_patches_have_one_pool():
    for kind, shared, free in (('plain nurbs', 12, 12), ('torus', 32, 0), ('sphere', 12, 0)):
        ob = add(value_of(kind))
        run('to_bezier')
        counts = ob.data.splinewright.value.edge_counts()
        assert (counts['shared'], counts['free']) == (shared, free), kind


def test_unclamped_patches_meet_no_more_in_points_and_are_where_they_were():
    before = value_of('four around a corner')
    ob = add(before)
    run('unclamp', direction='BOTH')
    after = patches_of(ob)
    assert max(farthest(before[i], [after[i]], 'unclamp', {}) for i in range(4)) < 1e-12
    assert meetings(ob.data.splinewright.value) == {}
    assert ob.data.splinewright.value.edge_counts() == before.edge_counts(), "edges are known by their places"


def test_a_single_patch_keeps_points_apart_that_lie_in_one_place():
    ob = add(value_of('sphere'))
    count = len(store.read(ob.data).pool)
    run('reverse')
    assert len(store.read(ob.data).pool) == count and isinstance(ob.data.splinewright.value, sc.NurbsPatch)


def test_patches_that_touch_and_share_nothing_go_on_sharing_nothing():
    patch = value_of('bicubic')
    other = patch.with_points(patch.points + (0, 0, 1))
    ob = add(sc.PatchSet.from_patches([patch, other, patch], merge=False))
    run('raise_degree', direction='BOTH')
    assert len(ob.data.splinewright.value.points) == 75


def test_one_piece_is_done_and_the_others_keep_their_rows():
    before = value_of('four around a corner')
    ob = add(before)
    run('raise_degree', piece=2, direction='BOTH', neighbors=False)
    after = ob.data.splinewright.value
    assert [patch.degree for patch in patches_of(ob)] == [(3, 3), (4, 4), (3, 3), (3, 3)]
    assert all(after[i] == before[i] for i in (0, 2, 3))
    rows = [set(patch['indices'].ravel().tolist()) for patch in after.patches]
    assert len(rows[0] & rows[1]) == 2 and len(rows[1] & rows[3]) == 2, "corners alone, of edges with other points"
    assert len(rows[0] & rows[2]) == 4 and len(rows[0] & rows[3]) == 1
    run('lower_degree', piece=2, direction='BOTH')
    assert meetings(ob.data.splinewright.value) == meetings(before), "they meet again"
    op(bpy.ops.splinewright.raise_degree, piece=3)
    op(bpy.ops.splinewright.reverse)
    assert patches_of(ob)[0] != before[0], "the piece is not remembered"


def test_a_set_of_hermite_patches_shares_points_and_handles():
    net = value_of('ferguson')
    before = sc.PatchSet.from_patches(net.split('u', 1.0))
    ob = add(before)
    run('split', direction='V', parameter_v=0.5)
    after = ob.data.splinewright.value
    assert len(after) == 4 and {(0, 1), (2, 3), (0, 2), (1, 3)} <= meetings(after).keys()
    shapes.enter()
    shapes.leave()
    assert bpy.data.objects["shape"].data.splinewright.value == after


# Which shapes -----------------------------------------------------------------------------------------------------


def test_every_selected_shape_is_done_those_that_share_data_once_and_failures_are_named():
    first, second, third = (add(value_of(kind), kind) for kind in ('plain nurbs', 'bicubic', 'biquintic'))
    twin = bpy.data.objects.new("twin", first.data)
    bpy.context.scene.collection.objects.link(twin)
    curve = add(sc.BezierCurve(shapes.points(3)), "curve")
    activate(twin, first, second, third, curve)
    assert run('raise_degree') == {'FINISHED'}
    assert [ob.data.splinewright.value.degree[0] for ob in (first, twin, second, third)] == [4, 4, 4, 6]
    assert run('lower_degree', times=4) == {'FINISHED'}, "biquintic alone has so many"
    assert [ob.data.splinewright.value.degree[0] for ob in (first, twin, second, third)] == [4, 4, 4, 2]
    with pytest.raises(RuntimeError, match="(?s)(plain nurbs|twin).*bicubic.*biquintic"):
        run('lower_degree', times=9)


# The redo panel ---------------------------------------------------------------------------------------------------


CHOICES = {'direction': tuple(DIRECTIONS), 'where': ('PARAMETER', 'KNOTS', 'SPANS'), 'how': ('AFFINE', 'MOEBIUS'),
           'limited': (False, True)}


@pytest.mark.parametrize('cls', extract.CLASSES, ids=lambda cls: cls.bl_idname)
def test_every_setting_is_described_and_shown(cls):
    rna = getattr(bpy.ops.splinewright, cls.bl_idname.split('.')[1]).get_rna_type()
    properties = {p.identifier: p for p in rna.properties if p.identifier != 'rna_type' and not p.is_hidden}
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

        def row(self, align=False):
            return self

        def column(self, align):
            return self

        def operator(self, name, **_):
            return SimpleNamespace()
    own = {key: value for key, value in vars(cls).items() if key == 'settings'}
    bases = tuple(base for base in cls.__bases__ if not issubclass(base, bpy.types.Operator))
    own |= {'__annotations__': dict(cls.__annotations__), **values, 'result': "", 'is_refused': False, 'layout': Layout()}
    panel = type("Panel", bases, own)()
    panel.draw(None)
    return names
