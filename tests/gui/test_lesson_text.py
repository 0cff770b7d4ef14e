"""A lesson in a window: its text stands in the view and can be switched off, and points are picked in the net."""

import json
import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, into_net, mean_difference, out_of_net, part, redrawn, run, save_picture, select_points, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
stage = part('bridge.lessons.stage')
WORDS = "A cubic curve has four control points, and it ends at two of them. Which ones are between? Select both, then check the answer."
POINTS = [[0, 0, 0, 1], [1, 2, 0, 1], [3, 2, 0, 1], [4, 0, 0, 1]]
LESSON = {'format': 1, 'name': "between", 'title': "Points Between", 'steps': [
    {'text': WORDS, 'view': "TOP", 'ask': {'point': [1, 2], 'of': "curve"},
     'make': [{'shape': "curve", 'value': {'format': "splinecore", 'version': 1, 'kind': "bezier_curve", 'points': POINTS}}]}]}


def upper_left(picture, view):
    """The part of a picture where the text stands."""
    top = picture.shape[0] - (view.region.y + view.region.height)
    return picture[top:top + 260, view.region.x:view.region.x + 600].astype(int)


def steps():
    view = View()
    view.move()
    empty_file()
    bpy.data.texts.new("between.json").from_string(json.dumps(LESSON))
    with view.override():
        assert bpy.ops.splinewright.start_lesson('EXEC_DEFAULT', True, text="between.json") == {'FINISHED'}
    yield from until(lambda: stage.lesson_of(view.window.scene), "the lesson")
    scene = view.window.scene
    view.open_sidebar()
    yield from view.show_tab("NURBS", (1045, 598))
    yield from redrawn()
    shown = upper_left(save_picture(OUTPUT / "lesson-text.png"), view)
    scene.splinewright_lesson_in_view = False
    yield from redrawn()
    assert mean_difference(shown, upper_left(save_picture(OUTPUT / "lesson-without-text.png"), view)) > 2.0, "the view has no text"
    scene.splinewright_lesson_in_view = True
    with view.override():
        assert bpy.ops.splinewright.pick_answer('EXEC_DEFAULT', True) == {'FINISHED'}
    yield from into_net()
    with view.override():
        net = part('bridge.net.live').session(bpy.context.object.data).net
        select_points(*np.flatnonzero(np.isin(net.rows, (1, 2))))
    yield from redrawn()
    save_picture(OUTPUT / "lesson-picked.png")
    with view.override():
        assert bpy.ops.splinewright.check_answer('EXEC_DEFAULT', True) == {'FINISHED'}
    assert stage.answers(scene) == {"0": {'answer': [1, 2], 'right': True, 'tries': 1}}, stage.answers(scene)
    yield from redrawn()
    save_picture(OUTPUT / "lesson-right.png")
    with view.override():
        assert bpy.ops.splinewright.leave_lesson('EXEC_DEFAULT', True) == {'FINISHED'}
    yield from until(lambda: len(bpy.data.scenes) == 1, "one scene")
    yield from out_of_net()


run(steps())
