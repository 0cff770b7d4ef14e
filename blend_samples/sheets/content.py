"""What the sheets of a lecture have: of each lesson its steps, their figures and questions, and the answers."""

import sys
from pathlib import Path
from typing import NamedTuple

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "lectures/make"))
import figures                                              # noqa: E402
from making import part                                     # noqa: E402

in_words, stage, words = (part(name) for name in ('core.lessons.in_words', 'bridge.lessons.stage', 'core.base.words'))
#: Of figures, in mm.
WIDTH, HEIGHT, MARGIN = 78.0, 62.0, 7.0


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
    for name in {name for step in told for name in step.overlays}:
        setattr(scene.splinewright_sights, name, True)
    view, points = figures.seen(scene)
    return figures.draw(view, points, figures.turn(told, points), WIDTH, HEIGHT, MARGIN).figure
