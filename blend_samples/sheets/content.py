"""What the sheets of a lecture have: of each lesson its steps, their figures and questions, and the answers."""

import sys
from pathlib import Path
from typing import NamedTuple

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "lectures"))
from making import part                                     # noqa: E402

drawn, piece_materials, store, page, in_words, stage, shape, words = (part(name) for name in (
    'bridge.figures.drawn', 'bridge.shape.piece_materials', 'bridge.data.store', 'core.figures.page', 'core.lessons.in_words',
    'bridge.lessons.stage', 'bridge.shape.shape', 'core.base.words'))
#: Of figures, in mm.
WIDTH, HEIGHT, MARGIN = 78.0, 62.0, 7.0
#: Rows to the right, up, and to the eye.
_TURNS = {
    'TOP': np.eye(3), 'FRONT': np.array([(1.0, 0, 0), (0, 0, 1), (0, -1, 0)]), 'RIGHT': np.array([(0.0, 1, 0), (0, 0, 1), (1, 0, 0)]),
    'FREE': np.array([(0.8, 0.6, 0.0), (-0.3, 0.4, np.sqrt(0.75)), (0.6 * np.sqrt(0.75), -0.8 * np.sqrt(0.75), 0.5)])}


class Step(NamedTuple):
    """Texts are English phrases: what shows them translates them."""

    text: str
    figure: object                      # a core.figures.figure.Figure where the step shows something new, or None
    kind: str                           # of its question, or ""
    choices: tuple
    answer: str


def steps_of(lesson):
    """[Step] of a lesson, in a scene that is removed again."""
    scene = stage.begin(lesson, bpy.context.scene)
    try:
        return [_step(scene, lesson, number) for number in range(len(lesson.steps))]
    finally:
        stage.remove(scene)


def _step(scene, lesson, number):
    step, told = lesson.steps[number], lesson.steps[:number + 1]
    stage.rebuild(scene, lesson, number)
    figure = figure_of(scene, told) if step.make or step.change else None
    if step.ask is None:
        return Step(words.phrase(step.text), figure, "", (), "")
    stage.change(scene, step.solution)
    answer = in_words.answer(step, stage.shapes_of(scene))
    return Step(words.phrase(step.text), figure, step.ask.kind, tuple(map(words.phrase, step.ask.choices)), answer)


def figure_of(scene, told):
    """The Figure of the scene of a lesson as it is after some steps."""
    layer, chosen = scene.view_layers[0], scene.splinewright_sights
    for name in {name for step in told for name in step.overlays}:
        setattr(chosen, name, True)
    layer.update()
    obs = [ob for ob in layer.objects if shape.has_shape(ob)]
    selected = [ob for ob in obs if ob.select_get(view_layer=layer)]
    pictures = [ob for ob in obs if ob.type == 'CURVE' and piece_materials.KEY in ob.data.keys()]
    view = drawn.View(scene, layer, layer.depsgraph, None, tuple(selected) if chosen.polygon else (),
                      tuple(dict.fromkeys([*selected, *pictures])) if chosen.labels else (), tuple(selected))
    points = np.concatenate([_points(ob, ob in view.nets) for ob in obs])
    seen = page.around(points, _turn(told, points), WIDTH, HEIGHT, MARGIN)
    return drawn.figure(view, seen, drawn.Wanted(curves=0.4, isocurves=0.12, letters=2.8, points=1.1)).figure


def _points(ob, with_net):
    """(n, 3): of a shape, and of its control points where they are drawn, in the world."""
    world = np.array(ob.matrix_world, dtype=np.float64)
    pool = store.read(ob.data).pool
    points = np.concatenate([shape.points_of(ob.data), pool[pool[:, 3] != 0.0, :3] if with_net else np.empty((0, 3))])
    return points @ world[:3, :3].T + world[:3, 3]


def _turn(told, points):
    """From where the last step that says it is seen best; flat shapes from above."""
    said = next((step.view for step in reversed(told) if step.view), "")
    return _TURNS[said or ('TOP' if not np.ptp(points[:, 2]) else 'FREE')]
