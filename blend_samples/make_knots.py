"""Degree 5, six inner knots: u5, then u4, u3 and u2, are moved onto u6, which has multiplicity 5 at last (lecture row S14).

Five pictures one below the other, each function in its color. One function after the other is left with [u6, u7]; the last one of
unshortened support has a corner at u6 at last. The knots of the first picture have keys: as a film it becomes the others in turn.
"""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
import stage

MOST = 4
FRAMES = 24
WIDTH, HEIGHT, ROW = 9.0, 1.0, 1.5


def knots_of(moved):
    """So many of u5, u4, u3 and u2 lie on u6."""
    inner = [6 if u > 5 - moved else u for u in range(1, 7)]
    return " ".join(map(str, [0] * 6 + inner + [7] * 6))


def label_of(u, moved):
    if u < 6 or u == 7 or moved == 0:
        return "" if 6 - moved <= u < 6 else f"u{u}"
    return " = ".join(f"u{each}" for each in range(6 - moved, 7))


def picture(moved):
    y = -ROW * moved
    ob = stage.add('add_functions', f"Functions {moved + 1}", (-WIDTH / 2, y, 0.02), degree=5, knot_values=knots_of(moved), width=WIDTH,
                   height=HEIGHT, resolution_u=48)
    ob.data.materials.pop()             # its functions have materials of their own
    for u in range(8):
        stage.label(label_of(u, moved), (-WIDTH / 2 + u * WIDTH / 7, y - 0.4), 0.15, 'CENTER')
    return stage.tube(ob, 0.016)


def move_by_keys(ob):
    scene, values = bpy.context.scene, ob.data.splinewright_parameters
    for step, u in enumerate((5, 4, 3, 2)):
        for frame, value in ((1 + step * FRAMES, u), (1 + (step + 1) * FRAMES, 6)):
            scene.frame_set(frame)
            values.functions_knot_values_list[5 + u] = value
            values.keyframe_insert('functions_knot_values_list', index=5 + u, frame=frame)
    scene.frame_end = 1 + MOST * FRAMES
    scene.frame_set(1)


stage.begin()
move_by_keys([picture(moved) for moved in range(MOST + 1)][0])
bpy.context.view_layer.update()
stage.drawing((0, -ROW * MOST / 2 + 0.4), 10.4)
stage.finish("knots", samples=16, size=(1000, 800))
