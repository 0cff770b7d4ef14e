"""What the verbs of curve shapes refuse: a word is said and nothing is lost."""

import bpy
import pytest

from curves import run, value_of, value_of_patch
from shapes import OF_CURVES, OF_PATCHES, activate, add, by_hand, enter, leave, names_of, op, shown
from support import part

store = part('bridge.data.store')


def state(ob):
    """Everything that a refusal must leave."""
    value = ob.data.splinewright.value
    return store.read(ob.data).pool.tobytes(), str(value), shown(ob).tobytes(), len(ob.data.splines)


REFUSED = (
    ('insert_knot', {'parameter_u': 1.5}, 'nurbs', "outside the domain"),
    ('insert_knot', {'parameter_u': 0.0}, 'nurbs', "multiplicity 5"),
    ('insert_knot', {'parameter_u': 1 / 3, 'times': 8}, 'nurbs', "times|multiplicity"),
    ('remove_knot', {}, 'cubic', "no inner knot"),
    ('remove_knot', {'parameter_u': 0.4, 'nearest': False}, 'nurbs', "not a knot that can be removed"),
    ('remove_knot', {'times': 5}, 'nurbs', "times = 5"),
    ('remove_knot', {'limited': True, 'tolerance': 1e-3}, 'nurbs', "within 0.001: the error would be"),
    ('remove_knots', {'tolerance': 1e-3}, 'nurbs', "no knot can go"),
    ('lower_degree', {'times': 3}, 'cubic', "times = 3"),
    ('lower_degree', {'limited': True, 'tolerance': 0.0}, 'cubic', "the error would be"),
    ('lower_degree', {}, 'semicircle', "weights"),
    ('raise_degree', {'times': 1000}, 'cubic', "times = 1000"),
    ('split', {'parameter_u': 2.0}, 'cubic', "u = 2"), ('split', {'parameter_u': 1.0}, 'nurbs', "u = 1"),
    ('split', {'where': 'KNOTS'}, 'cubic', "no inner knot"),
    ('split', {'where': 'FLAT', 'tolerance': 100.0}, 'cubic', "flat already"),
    ('split', {'where': 'FLAT'}, 'hyperbola', "infinity"), ('project_curve', {'eye': (1, 2, 0)}, 'cubic', "eye"),
    ('reparameterize', {'start': 1.0, 'end': 1.0}, 'nurbs', "domain"),
    ('reparameterize', {'start': 2.0, 'end': 1.0}, 'hermite', "domain"),
    ('reparameterize', {'start': 0.0, 'end': 1.0}, 'nurbs', "these already"),
    ('reparameterize', {'how': 'MOEBIUS', 'rho': 0.0}, 'nurbs', "rho"),
    ('reparameterize', {'how': 'MOEBIUS', 'rho': -1.0}, 'cubic', "rho"),
    ('standard_form', {}, 'cubic', "1 already"), ('standard_form', {}, 'uniform', "clamped"),
    ('clamp', {}, 'nurbs', "already"), ('unclamp', {}, 'uniform', "already"),
    ('make_periodic', {}, 'cubic', "do not meet"), ('make_periodic', {}, 'periodic', "already"),
    ('to_bezier', {}, 'quintic', "already"), ('to_nurbs', {}, 'periodic', "already"),
    ('to_hermite', {}, 'hermite', "already"), ('to_hermite', {}, 'quintic', "degree = 5"),
    ('to_hermite', {}, 'rational cubic', "not rational"), ('to_hermite', {}, 'hyperbola', "infinity"),
    ('to_hermite', {'tolerance': 1e-12}, 'large circle', "cannot approximate"),
    ('reverse', {'piece': 2}, 'cubic', "1 piece, there is none of number 2"),
    ('reverse', {'piece': 5}, 'many curves', "4 pieces, there is none of number 5"),
    ('insert_knot', {'parameter_u': 0.3}, 'many curves', "piece 2: u = 0.3 is outside"),
    ('lower_degree', {}, 'many curves', "piece 3: weights"),
    ('rebuild', {'count_u': 3}, 'cubic', "count = 3 control points are fewer"),
    ('rebuild', {'degree_u': 999}, 'cubic', "degree = 999"), ('rebuild', {}, 'hyperbola', "infinity"),
    ('fair', {}, 'hyperbola', "infinity"))


@pytest.mark.parametrize('name, settings, kind, word', REFUSED)
def test_what_cannot_be_done_is_said_and_nothing_is_lost(name, settings, kind, word):
    ob = add(value_of(kind))
    before = state(ob)
    with pytest.raises(RuntimeError, match=f"shape: .*({word})"):
        run(name, **settings)
    assert state(ob) == before


NAMES = names_of(OF_CURVES)


@pytest.mark.parametrize('name', (*NAMES, 'join_ends'))
def test_a_recipe_a_follower_and_what_was_changed_by_hand_are_refused(name):
    op(bpy.ops.splinewright.add_circle)
    circle = bpy.context.object
    original = add([value_of('nurbs'), value_of('cubic')])
    follower = add([value_of('nurbs'), value_of('cubic')], "follower")
    activate(original)
    op(bpy.ops.splinewright.follow_object)
    follower = bpy.context.object
    touched = add([value_of('nurbs'), value_of('cubic')], "touched")
    by_hand(touched)
    for ob, word in ((circle, "Apply Construction"), (follower, "Apply Construction"), (touched, "changed by hand")):
        activate(ob)
        before = state(ob)
        with pytest.raises(RuntimeError, match=word):
            run(name)
        assert state(ob) == before
    activate(circle)
    op(bpy.ops.splinewright.make_editable)
    if name in ('raise_degree', 'reverse', 'unclamp'):
        assert run(name) == {'FINISHED'}


@pytest.mark.parametrize('name', (*NAMES, 'join_ends'))
def test_linked_and_overridden_shapes_and_newer_ones_are_refused(name, tmp_path):
    add([value_of('nurbs'), value_of('cubic')])
    path = str(tmp_path / "library.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(path, link=True) as (_, target):
        target.objects = ["shape"]
    linked = target.objects[0]
    bpy.context.scene.collection.objects.link(linked)
    bpy.context.view_layer.update()
    overridden = linked.override_create(remap_local_usages=True)
    newer = add([value_of('nurbs'), value_of('cubic')], "newer")
    newer.data[store.KEY]['version'] = 99
    for ob, word in ((overridden, "linked"), (newer, "newer Splinewright")):
        activate(ob)
        before = shown(ob).tobytes()
        with pytest.raises(RuntimeError, match=word):
            run(name)
        assert shown(ob).tobytes() == before


@pytest.mark.parametrize('name', NAMES)
def test_an_operator_wants_a_selected_curve_shape_or_its_net(name):
    operator = getattr(bpy.ops.splinewright, name)
    assert not operator.poll()
    add(value_of_patch())
    takes_patches = name in names_of(OF_PATCHES)
    assert operator.poll() == takes_patches
    activate(bpy.data.objects["shape"])
    bpy.context.object.select_set(False)
    with pytest.raises(RuntimeError, match="Select a curve" + (" or surface" if takes_patches else "") + " shape"):
        operator()
    bpy.ops.curve.primitive_bezier_curve_add()
    assert not operator.poll()
    add(value_of('nurbs'), "curve")
    assert operator.poll()
    enter()
    assert operator.poll()
    leave()
    add(value_of_patch())
    enter()
    assert operator.poll() == takes_patches
    if not takes_patches:
        with pytest.raises(RuntimeError, match="another kind of shape"):
            operator()
