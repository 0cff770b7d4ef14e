"""The tolerance of the scene: constructions take it where none is typed."""

import bpy
import numpy as np
import pytest

from shapes import activate, add, op
from support import part, splinecore as sc

recipes, scene_tolerance = part('bridge.recipes.recipes'), part('bridge.follow.scene_tolerance')
WAVE = np.array([(0, 0, 0), (1, 2.0, 0), (2, -2.0, 0), (3, 0, 0)])


def wave(size, name="wave"):
    ob = add(sc.BezierCurve(size / 3.0 * WAVE), name)
    bpy.context.view_layer.update()
    return ob


def tolerance_of(ob):
    return recipes.parameters(ob.data)['tolerance']


def offset_of(ob, **more):
    activate(ob)
    assert op(bpy.ops.splinewright.add_offset, **more) == {'FINISHED'}
    return bpy.context.object


@pytest.mark.parametrize('size, wanted', [(0.003, 1e-7), (0.2, 1e-5), (3.0, 1e-4), (1999.0, 0.01), (3e6, 100.0)])
def test_an_automatic_tolerance_suits_the_size(size, wanted):
    ob = wave(size)
    assert scene_tolerance.of(bpy.context.scene) == wanted
    made = offset_of(ob, distance=0.01 * size)
    assert tolerance_of(made) == wanted
    apart = made.data.splinewright.value.nearest(ob.data.splinewright.value.evaluate(np.linspace(0, 1, 50))).distances
    assert abs(apart - 0.01 * size).max() <= 2 * wanted


def test_without_a_shape_it_is_a_tenth_of_a_millimeter():
    scene = bpy.context.scene
    assert scene_tolerance.of(scene) == 1e-4
    scene.unit_settings.scale_length = 0.001
    assert scene_tolerance.of(scene) == 0.1


def test_one_of_its_own_holds_for_all_sizes_and_is_kept_in_the_file(tmp_path):
    chosen = bpy.context.scene.splinewright_tolerance
    chosen.by, chosen.own = 'OWN', 0.002
    assert tolerance_of(offset_of(wave(3.0))) == 0.002
    assert tolerance_of(offset_of(wave(0.5, "small"), distance=0.05)) == 0.002
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "own.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "own.blend"))
    assert scene_tolerance.of(bpy.context.scene) == 0.002


def test_one_that_is_typed_counts_and_is_not_remembered():
    ob = wave(3.0)
    assert tolerance_of(offset_of(ob, tolerance=0.03)) == 0.03
    assert tolerance_of(offset_of(ob)) == 1e-4


def test_what_was_made_keeps_its_own():
    made = offset_of(wave(3.0))
    chosen = bpy.context.scene.splinewright_tolerance
    chosen.by, chosen.own = 'OWN', 0.5
    assert tolerance_of(made) == 1e-4


def test_surfaces_and_what_is_added_take_it():
    bpy.context.scene.splinewright_tolerance.by = 'OWN'
    bpy.context.scene.splinewright_tolerance.own = 0.005
    assert op(bpy.ops.splinewright.add_surface_formula) == {'FINISHED'}
    assert tolerance_of(bpy.context.object) == 0.005
    activate(wave(3.0))
    assert op(bpy.ops.splinewright.add_pipe) == {'FINISHED'}
    assert tolerance_of(bpy.context.object) == 0.005


def test_gaps_are_closed_within_it():
    chosen = bpy.context.scene.splinewright_tolerance
    chosen.by = 'OWN'
    chosen.own = 0.001
    activate(*(add(sc.BezierCurve(points), name) for points, name in (
        ([(0, 0, 0), (1, 0, 0)], "first"), ([(1.01, 0, 0), (2, 1, 0)], "second"))))
    with pytest.raises(RuntimeError, match="no two ends of its pieces lie within 0.001 of each other"):
        op(bpy.ops.splinewright.join_curves)
    chosen.own = 0.1
    assert op(bpy.ops.splinewright.join_curves) == {'FINISHED'}
    assert not isinstance(bpy.context.object.data.splinewright.value, list)


def test_a_tolerance_in_units_of_an_object_is_that_of_the_scene():
    ob = add([sc.BezierCurve([(0, 0, 0), (1, 0, 0)]), sc.BezierCurve([(1.01, 0, 0), (2, 1, 0)])], "scaled")
    ob.scale = (0.001,) * 3
    bpy.context.view_layer.update()
    activate(ob)
    chosen = bpy.context.scene.splinewright_tolerance
    chosen.by, chosen.own = 'OWN', 0.0001
    assert op(bpy.ops.splinewright.join_pieces) == {'FINISHED'}
    assert not isinstance(ob.data.splinewright.value, list)


def network_curves(lift):
    """A frame of four straight curves, of which two pass over the others."""
    rows = [[(0, y, 0), (3, y, 0)] for y in (0, 1, 2)]
    columns = [[(x, 0, lift), (x, 2, lift)] for x in (0, 3)]
    obs = [add(sc.BezierCurve(points), f"curve {i}") for i, points in enumerate(rows + columns)]
    activate(*obs)
    return obs


def test_a_network_forgives_a_gap_without_being_less_accurate():
    network_curves(0.02)
    with pytest.raises(RuntimeError, match="comes to about 0.02 of"):
        op(bpy.ops.splinewright.add_network)
    assert op(bpy.ops.splinewright.add_network, gap=0.03) == {'FINISHED'}
    ob = bpy.context.object
    assert recipes.parameters(ob.data) == {'tolerance': 1e-4, 'gap': 0.03}
    assert 0.01 <= recipes.error(ob.data) <= 0.0402


def test_a_number_that_is_found_out_is_what_is_shown():
    """In a window the work is done beforehand: with the same numbers."""
    cls = next(c for c in part('ui.operators.from_objects').CLASSES if c.bl_idname == "splinewright.add_pipe")
    ob = wave(30.0)
    activate(ob)
    calls = []

    class Asked:
        """Stands for an operator in a window."""
        recipe = cls.recipe
        properties = type('P', (), {'is_property_set': lambda self, name: name in calls})()

        def __setattr__(self, name, value):
            calls.append(name)
            object.__setattr__(self, name, value)

    asked = Asked()
    for name in ('_settle', '_follow', '_suggest', '_inputs'):
        setattr(Asked, name, getattr(cls, name))
    asked._settle(bpy.context, [ob])
    assert asked.radius == asked.end_radius > 0.1 and abs(asked.tolerance - 1e-3) < 1e-9
