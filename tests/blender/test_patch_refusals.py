"""What the verbs of patch shapes refuse: a word is said and nothing is lost."""

import bpy
import pytest

import shapes
from curves import run
from patches import value_of
from shapes import OF_CURVES, OF_PATCHES, activate, add, by_hand, enter, leave, names_of, op, shown
from support import part, scene_state, splinecore as sc

extract, store = part('ui.operators.extract'), part('bridge.data.store')


def state(ob):
    """Everything that a refusal must leave."""
    return store.read(ob.data).pool.tobytes(), str(ob.data.splinewright.value), shown(ob).tobytes(), scene_state()


BOTH = {'direction': 'BOTH'}
REFUSED = (
    ('insert_knot', {'parameter_u': 1.5}, 'plain nurbs', "u = 1.5 is outside the domain"),
    ('insert_knot', {'parameter_v': 1.5, **BOTH}, 'plain nurbs', "along v: .*outside the domain"),
    ('insert_knot', {'parameter_u': 0.0}, 'plain nurbs', "multiplicity 5"),
    ('insert_knot', {'parameter_u': 1 / 3, 'times': 8}, 'plain nurbs', "times|multiplicity"),
    ('remove_knot', {}, 'bicubic', "no inner knot"),
    ('remove_knot', {'parameter_u': 0.4, 'nearest': False}, 'plain nurbs', "not a knot that can be removed"),
    ('remove_knot', {'times': 5}, 'plain nurbs', "times = 5"),
    ('remove_knot', {'limited': True, 'tolerance': 1e-3}, 'plain nurbs', "within 0.001: the error would be"),
    ('remove_knots', {'tolerance': 1e-3}, 'plain nurbs', "no knot can go"),
    ('remove_knots', {'tolerance': 1e-3, **BOTH}, 'bicubic', "no knot can go"),
    ('lower_degree', {'times': 3}, 'bicubic', "times = 3"),
    ('lower_degree', {'limited': True, 'tolerance': 0.0}, 'bicubic', "the error would be"),
    ('lower_degree', BOTH, 'bilinear', "along u: times = 1"),
    ('raise_degree', {'times': 1000}, 'bicubic', "times = 1000"),
    ('split', {'parameter_u': 2.0}, 'bicubic', "u = 2"),
    ('split', {'parameter_u': 1.0}, 'plain nurbs', "u = 1"),
    ('split', {'where': 'KNOTS'}, 'bicubic', "no inner knot"),
    ('reparameterize', {'start': 1.0, 'end': 1.0}, 'plain nurbs', "domain"),
    ('reparameterize', {'start': 2.0, 'end': 1.0}, 'hermite patch', "domain"),
    ('reparameterize', BOTH, 'plain nurbs', "these already"),
    ('reparameterize', {'how': 'MOEBIUS', 'rho': 0.0}, 'plain nurbs', "rho"),
    ('reparameterize', {'how': 'MOEBIUS', 'rho': -1.0}, 'bicubic', "rho"),
    ('clamp', BOTH, 'plain nurbs', "already"), ('unclamp', BOTH, 'uniform', "already"),
    ('make_periodic', {}, 'bicubic', "do not meet"),
    ('make_periodic', BOTH, 'cylinder', "along v: .*do not meet"),
    ('make_periodic', BOTH, 'both periodic', "already"),
    ('to_bezier', {}, 'biquintic', "already"), ('to_nurbs', {}, 'both periodic', "already"),
    ('to_hermite', {}, 'hermite patch', "already"), ('to_hermite', {}, 'biquintic', "degree = 5"),
    ('to_hermite', {}, 'bezier patch', "weights|rational"),
    ('swap_uv', {'piece': 2}, 'bicubic', "1 piece, there is none of number 2"),
    ('reverse', {'piece': 33}, 'teapot', "32 pieces, there is none of number 33"),
    ('lower_degree', BOTH, 'mixed set', "piece 2: along v: times = 1"),
    ('rebuild', {'count_u': 3}, 'bicubic', "along u: count = 3"),
    ('rebuild', {'degree_v': 999}, 'bicubic', "along v: degree = 999"),
    ('fair', {}, 'bilinear', "degree 1 in both directions"),
    ('fair', {'keep_tangents': True}, 'hermite patch', "no other shape within the tolerance"),
    ('insert_knot', {'parameter_u': 0.4}, 'mixed set', "piece 1: u = 0.4 is outside"))


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
    assert run('remove_knot') == {'FINISHED'}
    assert first.data.splinewright.value == value_of('bicubic')
    assert second.data.splinewright.value.points.shape == (5, 6, 3)
    assert "flat: there is no inner knot" in "".join(capfd.readouterr())


@pytest.mark.parametrize('name, kind, settings', (
    ('make_periodic', 'bicubic', {}), ('remove_knots', 'nurbs patch', {'direction': 'V'})))
def test_a_tolerance_as_large_as_the_shape_is_refused(name, kind, settings):
    ob = add(value_of(kind))
    before = state(ob)
    with pytest.raises(RuntimeError, match="nothing of it would be left"):
        run(name, tolerance=1e3, **settings)
    assert state(ob) == before


NAMES, EXTRACTING = names_of(OF_PATCHES), names_of(extract.CLASSES)


@pytest.mark.parametrize('name', NAMES)
def test_a_recipe_a_follower_and_what_was_changed_by_hand_are_refused(name):
    op(bpy.ops.splinewright.add_torus)
    torus = bpy.context.object
    add(value_of('plain nurbs'))
    op(bpy.ops.splinewright.follow_object)
    follower = bpy.context.object
    touched = add(value_of('plain nurbs'), "touched")
    by_hand(touched)
    for ob, word in ((torus, "Apply Construction"), (follower, "Apply Construction"), (touched, "changed by hand")):
        activate(ob)
        before = state(ob)
        with pytest.raises(RuntimeError, match=word):
            run(name)
        assert state(ob) == before
    activate(torus)
    op(bpy.ops.splinewright.make_editable)
    if name in ('raise_degree', 'reverse', 'swap_uv', 'clamp'):
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
    takes_curves = name in names_of(OF_CURVES)
    assert operator.poll() == takes_curves
    bpy.context.object.select_set(False)
    with pytest.raises(RuntimeError, match="Select a curve or surface shape" if takes_curves else "Select a patch shape"):
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
    assert operator.poll() == takes_curves
    if not takes_curves:
        with pytest.raises(RuntimeError, match="another kind of shape|Leave Edit Mode"):
            operator()
