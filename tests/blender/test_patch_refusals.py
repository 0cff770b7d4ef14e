"""What the verbs of patch shapes refuse: a word is said and nothing is lost."""

import bpy
import pytest

import shapes
from curves import run
from patches import value_of
from shapes import activate, add, by_hand, enter, leave, op, shown
from support import part, scene_state, splinecore as sc

patch_verbs, extract, store = (part(name) for name in (
    'ui.operators.patch_verbs', 'ui.operators.extract', 'bridge.store'))


def state(ob):
    """Everything that a refusal must leave."""
    return store.read(ob.data).pool.tobytes(), str(ob.data.splinewright.value), shown(ob).tobytes(), scene_state()


BOTH = {'direction': 'BOTH'}
REFUSED = (
    ('patch_insert_knot', {'parameter_u': 1.5}, 'plain nurbs', "u = 1.5 is outside the domain"),
    ('patch_insert_knot', {'parameter_v': 1.5, **BOTH}, 'plain nurbs', "along v: .*outside the domain"),
    ('patch_insert_knot', {'parameter_u': 0.0}, 'plain nurbs', "multiplicity 5"),
    ('patch_insert_knot', {'parameter_u': 1 / 3, 'times': 8}, 'plain nurbs', "times|multiplicity"),
    ('patch_remove_knot', {}, 'bicubic', "no inner knot"),
    ('patch_remove_knot', {'parameter_u': 0.4, 'nearest': False}, 'plain nurbs', "no knot that can be removed"),
    ('patch_remove_knot', {'times': 5}, 'plain nurbs', "times = 5"),
    ('patch_remove_knot', {'limited': True, 'tolerance': 1e-3}, 'plain nurbs', "within 0.001: the error would be"),
    ('patch_remove_knots', {'tolerance': 1e-3}, 'plain nurbs', "no knot can go"),
    ('patch_remove_knots', {'tolerance': 1e-3, **BOTH}, 'bicubic', "no knot can go"),
    ('patch_lower_degree', {'times': 3}, 'bicubic', "times = 3"),
    ('patch_lower_degree', {'limited': True, 'tolerance': 0.0}, 'bicubic', "the error would be"),
    ('patch_lower_degree', BOTH, 'bilinear', "along u: times = 1"),
    ('patch_raise_degree', {'times': 1000}, 'bicubic', "times = 1000"),
    ('patch_split', {'parameter_u': 2.0}, 'bicubic', "u = 2"),
    ('patch_split', {'parameter_u': 1.0}, 'plain nurbs', "u = 1"),
    ('patch_split', {'where': 'KNOTS'}, 'bicubic', "no inner knot"),
    ('patch_reparametrise', {'start': 1.0, 'end': 1.0}, 'plain nurbs', "domain"),
    ('patch_reparametrise', {'start': 2.0, 'end': 1.0}, 'hermite patch', "domain"),
    ('patch_reparametrise', BOTH, 'plain nurbs', "these already"),
    ('patch_reparametrise', {'how': 'MOEBIUS', 'rho': 0.0}, 'plain nurbs', "rho"),
    ('patch_reparametrise', {'how': 'MOEBIUS', 'rho': -1.0}, 'bicubic', "rho"),
    ('patch_clamp', BOTH, 'plain nurbs', "already"), ('patch_unclamp', BOTH, 'uniform', "already"),
    ('patch_make_periodic', {}, 'bicubic', "do not meet"),
    ('patch_make_periodic', BOTH, 'cylinder', "along v: .*do not meet"),
    ('patch_make_periodic', BOTH, 'both periodic', "already"),
    ('patch_to_bezier', {}, 'biquintic', "already"), ('patch_to_nurbs', {}, 'both periodic', "already"),
    ('patch_to_hermite', {}, 'hermite patch', "already"), ('patch_to_hermite', {}, 'biquintic', "degree = 5"),
    ('patch_to_hermite', {}, 'bezier patch', "weights|rational"),
    ('patch_swap', {'piece': 2}, 'bicubic', "1 piece, there is none of number 2"),
    ('patch_reverse', {'piece': 33}, 'teapot', "32 pieces, there is none of number 33"),
    ('patch_lower_degree', BOTH, 'mixed set', "piece 2: along v: times = 1"),
    ('patch_rebuild', {'count_u': 3}, 'bicubic', "along u: count = 3"),
    ('patch_rebuild', {'degree_v': 999}, 'bicubic', "along v: degree = 999"),
    ('patch_fair', {}, 'bilinear', "degree 1 in both directions"),
    ('patch_fair', {'keep_tangents': True}, 'hermite patch', "no other patch within the tolerance"),
    ('patch_insert_knot', {'parameter_u': 0.4}, 'mixed set', "piece 1: u = 0.4 is outside"))


@pytest.mark.parametrize('name, settings, kind, word', REFUSED)
def test_what_cannot_be_done_is_said_and_nothing_is_lost(name, settings, kind, word):
    ob = add(value_of(kind))
    before = state(ob)
    with pytest.raises(RuntimeError, match=f"shape: .*({word})"):
        run(name, **settings)
    assert state(ob) == before


def test_of_several_shapes_those_that_can_are_done_and_the_others_are_named(capfd):
    first, second = add(value_of('bicubic'), "flat"), add(value_of('plain nurbs'), "knotted")
    activate(second, first)
    assert run('patch_remove_knot') == {'FINISHED'}
    assert first.data.splinewright.value == value_of('bicubic')
    assert second.data.splinewright.value.points.shape == (5, 6, 3)
    assert "flat: there is no inner knot" in "".join(capfd.readouterr())


@pytest.mark.parametrize('name, kind, settings', (
    ('patch_make_periodic', 'bicubic', {}), ('patch_remove_knots', 'nurbs patch', {'direction': 'V'})))
def test_a_tolerance_as_large_as_the_shape_is_refused(name, kind, settings):
    ob = add(value_of(kind))
    before = state(ob)
    with pytest.raises(RuntimeError, match="nothing of it would be left"):
        run(name, tolerance=1e3, **settings)
    assert state(ob) == before


NAMES = [cls.bl_idname.split('.')[1] for cls in patch_verbs.CLASSES]
EXTRACTING = [cls.bl_idname.split('.')[1] for cls in extract.CLASSES]


@pytest.mark.parametrize('name', NAMES)
def test_a_recipe_a_follower_and_what_was_changed_by_hand_are_refused(name):
    op(bpy.ops.splinewright.add_torus)
    torus = bpy.context.object
    add(value_of('plain nurbs'))
    op(bpy.ops.splinewright.follow_object)
    follower = bpy.context.object
    touched = add(value_of('plain nurbs'), "touched")
    by_hand(touched)
    for ob, word in ((torus, "Make Editable"), (follower, "Make Editable"), (touched, "changed by hand")):
        activate(ob)
        before = state(ob)
        with pytest.raises(RuntimeError, match=word):
            run(name)
        assert state(ob) == before
    activate(torus)
    op(bpy.ops.splinewright.make_editable)
    if name in ('patch_raise_degree', 'patch_reverse', 'patch_swap', 'patch_clamp'):
        assert run(name) == {'FINISHED'}


@pytest.mark.parametrize('name', NAMES)
def test_linked_and_overridden_shapes_and_newer_ones_are_refused(name, tmp_path):
    add(value_of('plain nurbs'))
    path = str(tmp_path / "library.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(path, link=True) as (_, target):
        target.objects = ["shape"]
    linked = target.objects[0]
    bpy.context.scene.collection.objects.link(linked)
    bpy.context.view_layer.update()
    overridden = linked.override_create(remap_local_usages=True)
    newer = add(value_of('plain nurbs'), "newer")
    newer.data[store.KEY]['version'] = 99
    for ob, word in ((overridden, "linked"), (newer, "newer Splinewright")):
        activate(ob)
        before = shown(ob).tobytes()
        with pytest.raises(RuntimeError, match=word):
            run(name)
        assert shown(ob).tobytes() == before


@pytest.mark.parametrize('name', (*NAMES, *EXTRACTING))
def test_an_operator_wants_a_selected_patch_shape_or_its_net(name):
    operator = getattr(bpy.ops.splinewright, name)
    assert not operator.poll()
    add(sc.BezierCurve(shapes.points(3)))
    assert not operator.poll()
    with pytest.raises(RuntimeError, match="Select a patch shape"):
        operator()
    bpy.ops.mesh.primitive_cube_add()
    assert not operator.poll()
    add(value_of('plain nurbs'), "patch")
    assert operator.poll()
    enter()
    assert operator.poll() == (name not in EXTRACTING)
    if name in EXTRACTING:
        with pytest.raises(RuntimeError, match="Leave Edit Mode"):
            operator()
    leave()
    add(sc.BezierCurve(shapes.points(3)))
    enter()
    assert not operator.poll()
    with pytest.raises(RuntimeError, match="another kind of shape|Leave Edit Mode"):
        operator()
