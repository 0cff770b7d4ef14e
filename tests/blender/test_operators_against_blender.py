"""The result of every operator that makes or changes curves and patches, given to Blender: it draws the exact shape and all of it.

A new operator has a case here, or stands among those that make and change no shape.
"""

import inspect

import bpy
import pytest

import curves
import operator_cases as cases
import patches
import test_curve_verbs
import test_patch_verbs
from curves import run
from drawn_by_blender import NEAR_UNCLAMPED, compare, compare_selected, shape
from shapes import activate, add
from support import part

table = part('core.recipes.table')
OPERATORS = set(dir(bpy.ops.splinewright))
#: Blender has no points at infinity.
REFUSED = {'hyperbola': "infinity", 'parabola': "infinity"}
RECIPES = [kind for kind in table.RECIPES if kind not in cases.ELSEWHERE]
ROWS = [(name, settings, kind) for name, settings, kinds in test_curve_verbs.KEEPING for kind in kinds] + list(test_curve_verbs.APPROXIMATING)
PATCH_ROWS = [row for row in test_patch_verbs.KEEPING if row[1].get('direction', 'BOTH') == 'BOTH']
PATCH_ROWS += [(name, {**settings, 'direction': 'BOTH'}, kind) for name, settings, kind in test_patch_verbs.APPROXIMATING]
#: What comes out depends on where the eye is.
MORE_ROWS = [('project_curve', {'eye': (0, 0, 9)}, 'nurbs'), ('project_curve', {'eye': (1, 2, -9)}, 'rational cubic')]
VERBS = {row[0] for row in (*ROWS, *PATCH_ROWS, *MORE_ROWS)}


def rows(*those):
    return [pytest.param(*row, id=f"{row[0]}-{'-'.join(map(str, row[1].values()))}-{row[2]}") for row in those]


def test_every_operator_has_a_case_or_a_reason():
    with_case = {f"add_{kind}" for kind in RECIPES} | set(cases.OTHERS) | set(cases.STAGED) | VERBS | {'point_to_infinity'}
    assert not set(cases.OTHERS) & set(cases.STAGED)
    groups = with_case, set(cases.CALLING), set(cases.LEAVING), set(cases.BECAUSE)
    assert set().union(*groups) == OPERATORS and sum(map(len, groups)) == len(OPERATORS)
    assert set(cases.ELSEWHERE.values()) | set(cases.CALLING.values()) <= with_case


@pytest.mark.parametrize('kind', RECIPES)
def test_a_recipe(kind):
    if kind in cases.FOLLOWED:
        activate(*cases.FOLLOWED[kind]())
    assert run(f"add_{kind}") == {'FINISHED'}
    if kind in REFUSED:
        with pytest.raises(RuntimeError, match=REFUSED[kind]):
            run('to_native')
    else:
        compare_selected()


@pytest.mark.parametrize('name', cases.OTHERS)
def test_an_operator(name):
    sources, settings = cases.OTHERS[name]
    objects = sources()
    if isinstance(objects, list) and objects:
        activate(*objects)
    assert run(name, **settings) == {'FINISHED'}
    compare_selected()


@pytest.mark.parametrize('name', cases.STAGED)
def test_an_operator_among_others(name):
    cases.STAGED[name]()
    compare_selected()


def test_points_at_infinity_are_refused():
    cases.in_net(cases.CORNER, lambda: run('point_to_infinity'))
    with pytest.raises(RuntimeError, match="infinity"):
        run('to_native')


@pytest.mark.parametrize('name, settings, kind', rows(*ROWS, *MORE_ROWS))
def test_a_verb_of_curves(name, settings, kind):
    changed(add(curves.value_of(kind)), name, settings)


@pytest.mark.parametrize('name, settings, kind', rows(*PATCH_ROWS))
def test_a_verb_of_patches(name, settings, kind):
    changed(add(patches.value_of(kind)), name, settings)


def changed(ob, name, settings):
    assert run(name, **settings) == {'FINISHED'}
    try:
        compare(ob, NEAR_UNCLAMPED)
    except RuntimeError as error:
        assert "infinity" in str(error)


@pytest.mark.parametrize('name', cases.CALLING)
def test_what_the_mouse_does_is_done_by_an_operator_with_a_case(name):
    kind = getattr(bpy.types, f"SPLINEWRIGHT_OT_{name}")
    assert cases.CALLING[name] in inspect.getsource(inspect.getmodule(kind))


@pytest.mark.parametrize('name', cases.LEAVING)
def test_others_leave_every_shape(name, tmp_path):
    activate(*cases.FOLLOWED['revolve']())
    run('add_revolve')
    made, profile = bpy.context.object, bpy.data.objects["shape 0"]
    before = {ob.name: ob.data.splinewright.value for ob in (made, profile)}
    if name in ('divide_equally', 'write_formulas', 'key_points'):
        activate(profile)
    assert run(name, **({'filepath': str(tmp_path / "file")} if name == 'export_json' else {})) == {'FINISHED'}
    after = {ob.name: ob.data.splinewright.value for ob in bpy.data.objects if shape.has_shape(ob)}
    assert after.items() <= before.items()
