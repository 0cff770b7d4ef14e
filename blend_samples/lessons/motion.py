"""What the film of a lesson shows: each step, and how its question is solved."""

import sys
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "lectures/make"))
import figures                                              # noqa: E402
from making import part                                     # noqa: E402

checking, failures, follow, recipes, shape, stage, store = (part(name) for name in (
    'core.lessons.checking', 'core.base.failures', 'bridge.follow.follow', 'bridge.recipes.recipes', 'bridge.shape.shape', 'bridge.lessons.stage',
    'bridge.data.store'))
#: Of figures, in mm.
WIDTH, HEIGHT, MARGIN = 130.0, 86.0, 9.0
#: Seconds of a film, about; the least and the most for which it stands still; frames of one motion, and its seconds.
_LENGTH, _LEAST, _MOST = 15.0, 0.6, 2.0
FRAMES, SECONDS = 12, 1.0


class Frame(NamedTuple):
    figure: object                      # a core.figures.figure.Figure
    number: int                         # of its step, from 0
    lines: tuple                        # texts with the numbers that the lesson watches
    seconds: float


def hold(lesson):
    """The seconds for which a film stands still at each step, and once more where that is solved."""
    motions = sum(bool(step.solution) for step in lesson.steps)
    return min(max((_LENGTH - motions * SECONDS) / (len(lesson.steps) + motions), _LEAST), _MOST)


def frames_of(lesson):
    """The Frames of a lesson, in a scene that is removed again."""
    scene = stage.begin(lesson, bpy.context.scene)
    try:
        for number in range(len(lesson.steps)):
            yield from _step(scene, lesson, number, hold(lesson))
    finally:
        stage.remove(scene)


def _step(scene, lesson, number, still):
    step, told = lesson.steps[number], lesson.steps[:number + 1]
    for name in {name for each in told for name in each.overlays}:
        setattr(scene.splinewright_sights, name, True)
    stage.rebuild(scene, lesson, number)
    places = figures.seen(scene)[1]
    moving = _Motion(scene, step.solution)
    if step.solution:
        stage.change(scene, step.solution)
        places = np.concatenate([places, figures.seen(scene)[1]])
        moving.note_end()
        stage.rebuild(scene, lesson, number)
    turn = figures.turn(told, places)

    def frame(seconds):
        view, _ = figures.seen(scene)
        drawing = figures.draw(view, places, turn, WIDTH, HEIGHT, MARGIN)
        return Frame(drawing.figure, number, _lines(scene, step), seconds)
    yield frame(still)
    if step.solution:
        for at in np.linspace(0.0, 1.0, FRAMES + 1)[1:-1] if moving.is_smooth else ():
            moving.go(at * at * (3.0 - 2.0 * at))
            yield frame(SECONDS / FRAMES)
        stage.rebuild(scene, lesson, number)
        stage.change(scene, step.solution)
        yield frame(still)


def _lines(scene, step):
    """The lines that the step watches, or why one has no numbers, as the panel has them."""
    found = []
    for watch in step.watch:
        try:
            found.append(str(checking.watched(watch, stage.shapes_of(scene))))
        except failures.FAILURES as error:
            found.append(str(failures.sentence(error)))
    return tuple(found)


class _Motion:
    """How shapes go from what they are to what the solution of a step makes of them."""

    def __init__(self, scene, solution):
        self._scene, self._names = scene, [one.shape for one in solution if not one.faces]
        self._starts = self._state()
        self.is_smooth = False

    def note_end(self):
        self._ends = self._state()
        self.is_smooth = all(self._is_smooth(name) for name in self._names) and bool(self._names)

    def go(self, at):
        """Show the shapes a part of the way."""
        for name in self._names:
            data = stage.object_of(self._scene, name).data
            try:
                self._change(data, *self._starts[name], *self._ends[name], at)
            except failures.FAILURES:
                continue                # on its way there is no such shape, as an offset by 0: it stays for this moment
            follow.refresh({data}, stage.graph(self._scene))

    def _change(self, data, start, settings, end, others, at):
        if recipes.follows(data):
            follow.set_parameters(data, {key: _between(value, others[key], at) for key, value in settings.items()
                                         if _is_number(value) and value != others[key]}, stage.graph(self._scene))
        else:
            shape.set_definition(data, _definition(start, end, at))

    def _state(self):
        """{name: (definition, settings)}."""
        blocks = {name: stage.object_of(self._scene, name).data for name in self._names}
        return {name: (store.read(data), recipes.parameters(data) if recipes.has(data) else {}) for name, data in blocks.items()}

    def _is_smooth(self, name):
        (start, settings), (end, others) = self._starts[name], self._ends[name]
        if recipes.follows(stage.object_of(self._scene, name).data):
            return any(_is_number(value) and value != others[key] for key, value in settings.items())
        return start.form == end.form and start.pool.shape == end.pool.shape and all(
            one.layout == other.layout and np.array_equal(one.indices, other.indices) for one, other in zip(start.pieces, end.pieces)
        ) and len(start.pieces) == len(end.pieces)


def _definition(start, end, at):
    """Of one structure, with points and knots a part of the way."""
    pieces = tuple(replace(one, knots=tuple(_between(a, b, at) for a, b in zip(one.knots, other.knots)))
                   for one, other in zip(start.pieces, end.pieces))
    return replace(start, pool=_between(start.pool, end.pool, at), pieces=pieces)


def _between(start, end, at):
    return (1.0 - at) * start + at * end


def _is_number(value):
    return isinstance(value, float)
