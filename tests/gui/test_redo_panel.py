"""Rebuild and Fair, whose settings are changed in the panel of the last operator: what comes is of the shape as it was before;
Ctrl+Z, sidebar closed."""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from one_shape import added, value
from window import View, redrawn, run, until


def changed(view, name, first, then, expected):
    """Steps: an operator is called with some settings, others are chosen in its panel, Ctrl+Z takes it back.
    expected: the shape for settings, from the one before."""
    before = value()
    wanted = [expected(before, **settings) for settings in (first, then)]
    assert len({repr(before.points.tolist()), *(repr(each.points.tolist()) for each in wanted)}) == 3
    with view.override():
        getattr(bpy.ops.splinewright, name)('INVOKE_DEFAULT', True, **first)
    yield from until(lambda: value() == wanted[0], f"{name} {first}")
    for name_of, setting in then.items():
        setattr(bpy.context.window_manager.operators[-1].properties, name_of, setting)
    with view.override():
        bpy.ops.ed.undo_redo()
        bpy.ops.ed.undo_push(message="again")
    yield from until(lambda: value() == wanted[1], f"{name} {then} of what was there before")
    while value() != before:
        view.press('Z', ctrl=True)
        yield from redrawn()
    print(name, flush=True)


def rebuilt(curve, count_u):
    return curve.rebuild(count_u, 3).value


def patch_rebuilt(patch, count_u, count_v):
    return patch.rebuild((count_u, count_v)).value


def faired(shape, tolerance):
    return shape.fair(tolerance).value


def steps():
    view = View()
    yield from added(view, bpy.ops.splinewright.add_nurbs_curve)
    yield from changed(view, 'rebuild', {'count_u': 5}, {'count_u': 9}, rebuilt)
    yield from changed(view, 'fair', {'tolerance': 0.0625}, {'tolerance': 0.25}, faired)
    yield from added(view, bpy.ops.splinewright.add_nurbs_patch)
    yield from changed(view, 'rebuild', {'count_u': 5, 'count_v': 6}, {'count_u': 7, 'count_v': 4}, patch_rebuilt)
    yield from changed(view, 'fair', {'tolerance': 0.0625}, {'tolerance': 0.25}, faired)


run(steps())
