"""A lesson tried from beginning to end, and its faults in words."""

import time

import bpy

from ...core.base.failures import FAILURES, sentence
from ...core.base.words import phrase
from ...core.lessons import checking
from ...core.lessons.measures import measured
from ...core.lessons.lesson import Measure
from ..data import store
from ..recipes import recipes
from . import stage

#: Seconds that a step may take.
LONGEST = 1.0


def faults(lesson, before, overlays):
    """Mistakes of a lesson: sentences. before: the scene that is shown now; overlays: names of those that there are. Its own scene
    is removed again."""
    found = [] if any(step.ask is not None for step in lesson.steps) else ["no step asks anything"]
    for number, step in enumerate(lesson.steps, 1):
        found += [phrase("step {number}: there is no overlay {name!r}",
                         number=number, name=name) for name in step.overlays if name not in overlays]
    known = set(bpy.data.scenes)
    try:
        started = time.perf_counter()
        scene = stage.begin(lesson, before)
    except FAILURES as error:
        return [*found, sentence(error)]
    try:
        return found + list(_of_steps(scene, lesson, started))
    finally:
        for other in set(bpy.data.scenes) - known:
            stage.remove(other)


def _of_steps(scene, lesson, started):
    for number, step in enumerate(lesson.steps):
        try:
            if number:
                started = time.perf_counter()
                stage.advance(scene, lesson)
            taken = time.perf_counter() - started
        except FAILURES as error:
            yield sentence(error)
            return
        if taken > LONGEST:
            yield phrase("step {number} takes {taken:.1f} seconds: {longest:g} are the most",
                         number=number + 1, taken=taken, longest=LONGEST)
        try:
            for what in _of_step(scene, lesson, number, step):
                yield phrase("step {number}: {what}", number=number + 1, what=what)
            stage.rebuild(scene, lesson, number)
        except FAILURES as error:
            yield phrase("step {number}: {error}", number=number + 1, error=sentence(error))
            return


def _of_step(scene, lesson, number, step):
    for watch in step.watch:
        checking.watched(watch, stage.shapes_of(scene))
    for move in step.move:
        yield from _without_points(scene, move.shape, move.points)
    if step.ask is None:
        return
    if step.ask.kind == 'do':
        yield from _of_deed(scene, lesson, number, step)
    elif step.ask.kind == 'number' and isinstance(step.ask.value, Measure):
        measured(step.ask.value, stage.shapes_of(scene))
    elif step.ask.kind == 'point':
        yield from _without_points(scene, step.ask.shape, step.ask.points)
        if recipes.follows(stage.object_of(scene, step.ask.shape).data):
            yield phrase("{shape} follows other shapes: its points cannot be picked", shape=step.ask.shape)


def _without_points(scene, name, points):
    count = len(store.pool(stage.object_of(scene, name).data))
    if points and max(points) >= count:
        yield phrase("{name} has the points 0 to {count}, and none with the number {points}",
                     name=name, count=count - 1, points=max(points))


def _of_deed(scene, lesson, number, step):
    if checking.is_right(step.ask, stage.shapes_of(scene)):
        yield "the question is answered already as the step begins"
    for i, wrong in enumerate(step.wrong, 1):
        stage.change(scene, wrong)
        if checking.is_right(step.ask, stage.shapes_of(scene)):
            yield phrase("the wrong answer {number} is taken for right", number=i)
        stage.rebuild(scene, lesson, number)
    stage.change(scene, step.solution)
    if not checking.is_right(step.ask, stage.shapes_of(scene)):
        yield "the solution does not answer the question"
