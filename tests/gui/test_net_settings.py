"""A user changes how finely a shape is shown while its net is out, and takes it back by Ctrl+Z."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, into_net, out_of_net, part, redrawn, run, save_picture, select_points, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def state(name):
    """(resolution, a coordinate, number of vertices) of the shape, which is what its definition and settings say."""
    ob, shape = bpy.data.objects[name], part('bridge.shape.shape')
    expected = shape.evaluated(ob.data, part('bridge.data.store').read(ob.data)).points
    shown = shape.points_of(ob.data)
    assert len(shown) == len(expected) and np.allclose(shown, expected, atol=1e-6), "the shape is not its definition"
    assert not shape.is_touched(ob.data)
    value = ob.data.splinewright.value
    return ob.data.splinewright.resolution_u, float(np.asarray(value.points).reshape(-1, 3)[0, 2]), len(shown)


def change(view, add, name):
    """Steps: a field by the mouse wheel, a move, the field again; then back and forth by keys."""
    with view.override():
        add('EXEC_DEFAULT', True, resolution_u=8)
    yield from redrawn()
    view.move(view.region.x + view.region.width // 3, view.region.y + view.region.height // 2)
    view.press('TAB')
    yield from into_net()
    with view.override():
        select_points(0)
    yield from view.show_tab("NURBS", (1045, 538))
    ladder = [state(name)]

    yield from view.go_to_field("resolution_u")
    for _ in range(2):
        view.wheel_up(ctrl=True)
        yield from until(lambda: state(name) != ladder[-1], "another resolution by the wheel")
        ladder.append(state(name))
        assert ladder[-1][0] == ladder[-2][0] + 1 and ladder[-1][2] > ladder[-2][2], ladder
    save_picture(OUTPUT / f"net-settings-{name}.png")
    view.move(view.region.x + view.region.width // 3, view.region.y + view.region.height // 2)
    for key, text in (('G', ''), ('Z', ''), ('ONE', '1'), ('RET', '')):
        view.press(key, text)
        yield from redrawn()
    yield from until(lambda: state(name) != ladder[-1], "the move of a point")
    ladder.append(state(name))
    assert ladder[-1][0] == ladder[-2][0] and abs(ladder[-1][1] - ladder[-2][1] - 1) < 1e-6, ladder

    for shift, expected in ((False, ladder[::-1]), (True, ladder)):
        seen = [state(name)]
        for _ in range(len(ladder) - 1):
            view.press('Z', ctrl=True, shift=shift)
            before = seen[-1]
            yield from until(lambda: state(name) != before, "undo or redo")
            seen.append(state(name))
        assert seen == expected, f"{seen} is not {expected}"

    view.press('TAB')
    yield from out_of_net()
    assert state(name) == ladder[-1]
    seen = []
    while bpy.context.mode == 'OBJECT' or seen[-1] != ladder[0]:
        assert len(seen) < 8, seen
        view.press('Z', ctrl=True)
        yield from redrawn()
        seen.append(state(name))
    assert [now for before, now in zip([None, *seen], seen) if now != before] == ladder[::-1], seen
    view.press('TAB')
    yield from out_of_net()
    bpy.data.objects[name].hide_set(True)


def steps():
    view = View()
    empty_file()
    view.open_sidebar()
    yield from redrawn()
    yield from change(view, bpy.ops.splinewright.add_nurbs_patch, "NURBS Patch")
    yield from change(view, bpy.ops.splinewright.add_nurbs_curve, "NURBS Curve")
    print("the settings of a net did what they should:", bpy.app.version_string, flush=True)


run(steps())
