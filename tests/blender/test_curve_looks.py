"""Which curves the verbs change, how these look afterwards, and what the redo panel shows."""

from itertools import product
from types import SimpleNamespace

import bpy
import numpy as np
import pytest

import shapes
from curves import curves_of, run, value_of, value_of_patch
from shapes import OF_CURVES, OF_PATCHES, activate, add, op, require_exact, shown
from support import part, splinecore as sc


# Which curves -----------------------------------------------------------------------------------------------------


def test_one_piece_or_all_of_them_and_the_piece_is_not_remembered():
    ob = add([value_of('nurbs'), value_of('cubic')])
    op(bpy.ops.splinewright.raise_degree, times=1, piece=2)
    assert [curve.degree for curve in curves_of(ob)] == [3, 4]
    assert curves_of(ob)[0] == value_of('nurbs')
    op(bpy.ops.splinewright.raise_degree, times=1)
    assert [curve.degree for curve in curves_of(ob)] == [4, 5]


def test_a_list_of_one_stays_a_list_and_a_curve_becomes_one_where_it_must():
    ob = add([value_of('nurbs')])
    run('reverse')
    assert isinstance(ob.data.splinewright.value, list)
    ob = add(value_of('nurbs'), "single")
    run('reverse')
    assert isinstance(ob.data.splinewright.value, sc.NurbsCurve)
    run('split', parameter_u=0.5)
    assert isinstance(ob.data.splinewright.value, list)


def test_every_selected_shape_is_done_those_that_share_data_once_and_failures_are_named():
    first, second, third = (add(value_of(kind), kind) for kind in ('nurbs', 'cubic', 'quintic'))
    twin = bpy.data.objects.new("twin", first.data)
    bpy.context.scene.collection.objects.link(twin)
    patch = add(value_of_patch(), "patch")
    activate(twin, first, second, third, patch)
    assert run('raise_degree') == {'FINISHED'}
    assert [ob.data.splinewright.value.degree for ob in (first, second, third)] == [4, 4, 6]
    assert run('lower_degree', times=4) == {'FINISHED'}, "quintic alone has so many"
    assert [ob.data.splinewright.value.degree for ob in (first, second, third)] == [4, 4, 2]
    with pytest.raises(RuntimeError, match="(?s)(nurbs|twin).*cubic.*quintic"):
        run('lower_degree', times=9)


# How it looks -----------------------------------------------------------------------------------------------------


def dressed(value, reach=10.0):
    """A shape whose splines differ in material, radius, tilt and shading."""
    ob = add(value)
    ob.data.splinewright.reach = reach
    for i, spline in enumerate(ob.data.splines):
        ob.data.materials.append(bpy.data.materials.new(str(i)))
        spline.material_index, spline.use_smooth = i, bool(i % 2)
        for point in spline.points:
            point.radius, point.tilt = 1 + i, i / 4
    ob.data.bevel_depth = 0.1
    bpy.ops.ed.undo_push(message="dress")
    return ob


def looks(ob):
    return [(spline.material_index, spline.use_smooth, {point.radius for point in spline.points},
             {point.tilt for point in spline.points}) for spline in ob.data.splines]


def look(i):
    return i, bool(i % 2), {1.0 + i}, {i / 4}


@pytest.mark.parametrize('name, settings, expected', (
    ('reverse', {}, [0, 1, 2]), ('raise_degree', {}, [0, 1, 2]), ('to_bezier', {}, [0, 0, 0, 1, 2, 2]),
    ('split', {'piece': 2, 'parameter_u': 0.5}, [0, 1, 1, 2]),
    ('insert_knot', {'where': 'SPANS'}, [0, 1, 2])))
def test_material_radius_tilt_and_shading_stay_with_each_piece(name, settings, expected):
    ob = dressed([value_of('nurbs'), value_of('cubic'), sc.HermiteCurve(shapes.points(3), shapes.points(3))])
    run(name, **settings)
    turned = -1 if name == 'reverse' else 1     # as Blender's Switch Direction does
    assert looks(ob) == [(*look(i)[:3], {turned * i / 4}) for i in expected]
    assert ob.data.bevel_depth == np.float32(0.1) and len(ob.data.materials) == 3
    bpy.ops.ed.undo()
    assert looks(bpy.data.objects["shape"]) == [look(i) for i in range(3)]


@pytest.mark.parametrize('reach, arms', ((3.0, 3), (0.1, 2)))
def test_the_arms_of_a_hyperbola_that_are_within_reach_keep_their_looks(reach, arms):
    ob = dressed([value_of('hyperbola'), value_of('cubic')], reach)
    assert looks(ob) == [look(i) for i in range(arms + 1)]
    before = curves_of(ob)[0]
    run('raise_degree')
    require_exact(ob)
    assert looks(ob) == [look(i) for i in range(arms + 1)]
    at = np.linspace(0, 1, 41)
    points, was = (curve.evaluate(at, at_infinity='nan') for curve in (curves_of(ob)[0], before))
    assert np.allclose(points, was, rtol=1e-12, atol=1e-12, equal_nan=True)
    run('split', piece=1, parameter_u=0.5)
    require_exact(ob)
    assert looks(ob)[-1] == look(arms) and all(worn in [look(i) for i in range(arms)] for worn in looks(ob)[:-1])


# The redo panel ---------------------------------------------------------------------------------------------------


CHOICES = {'direction': ('U', 'V', 'BOTH'), 'where': ('PARAMETER', 'KNOTS', 'SPANS', 'FLAT'), 'how': ('AFFINE', 'MOEBIUS'),
           'limited': (False, True), 'by': ('COUNT', 'TOLERANCE')}
#: What a class says about how its settings are shown.
SHOWING = ('settings', 'all_settings', 'draw', 'allowed', 'limits', 'of_curves', 'of_patches', 'expanded')


@pytest.mark.parametrize('cls', sorted({*OF_CURVES, *OF_PATCHES}, key=lambda cls: cls.bl_idname), ids=lambda cls: cls.bl_idname)
def test_every_setting_is_described_and_shown(cls):
    rna = getattr(bpy.ops.splinewright, cls.bl_idname.split('.')[1]).get_rna_type()
    properties = {p.identifier: p for p in rna.properties if p.identifier != 'rna_type' and not p.is_hidden}
    assert all(p.name and (p.description or p.type == 'ENUM') for p in properties.values())
    assert {'REGISTER', 'UNDO'} <= cls.bl_options and cls.bl_description and not cls.bl_description.endswith('.')
    shown_names = set()
    for name, values in CHOICES.items():
        allowed = [value for value in values if name not in properties or properties[name].type != 'ENUM'
                   or value in properties[name].enum_items]
        for value, kinds in product(allowed, ({True}, {False}, {True, False})):
            drawn = drawn_by(cls, {**{key: p.default for key, p in properties.items()}, name: value}, kinds)
            assert set(drawn) <= set(properties) and drawn[-1] == 'piece' and len(set(drawn)) == len(drawn)
            assert False in kinds or not {'direction', 'neighbors', 'parameter_v', 'count_v', 'degree_v'} & set(drawn)
            shown_names |= set(drawn)
    assert shown_names == set(properties)


def drawn_by(cls, values, kinds):
    """Names of the properties in the redo panel, with curves selected (True), with patches. Operators cannot be made by hand, what
    they inherit can."""
    names = []

    class Layout:
        def prop(self, _, name, text="", expand=False):
            names.append(name)

        def row(self, align=False):
            return self

        def column(self, align):
            return self

        def operator(self, name, **_):
            return SimpleNamespace()
    own = {key: value for key, value in vars(cls).items() if key in SHOWING}
    bases = tuple(base for base in cls.__bases__ if not issubclass(base, bpy.types.Operator))
    own |= {'__annotations__': dict(cls.__annotations__), **values, 'result': "", 'is_refused': False, 'layout': Layout(),
            'kinds': lambda self: kinds}
    panel = type("Panel", bases, own)()
    panel.draw(None)
    return names
