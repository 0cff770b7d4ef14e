"""What a step of a lesson speaks of, and the answer to its question in words."""

from ..base.words import listed, phrase
from .lesson import Measure
from .measure_words import named, number


def spoken_of(steps):
    """Names of the shapes that the last of some steps speaks of, or one before it where that names none: those to be moved first."""
    return next((found for step in reversed(steps) if (found := _of_step(step))), ())


def _of_step(step):
    ask = (step.ask.shape, *_of_conditions(step.ask.conditions), *_of_value(step.ask.value)) if step.ask is not None else ()
    watched = (name for watch in step.watch for value in watch.values for name in _of_value(value))
    others = (one.shape for one in (*step.make, *step.change, *step.solution))
    return tuple(dict.fromkeys(name for name in (*(one.shape for one in step.move), *ask, *watched, *others) if name))


def _of_conditions(conditions):
    return [name for one in conditions for value in (one.measure, one.value) for name in _of_value(value)]


def _of_value(value):
    """Names of the shapes of a Measure, if it is one."""
    if not isinstance(value, Measure):
        return []
    others = [value.arguments['to']] if 'to' in value.arguments else []
    return [value.shape, *others, *(name for one in value.arguments.values() for name in _of_value(one))]


def answer(step, shapes):
    """The answer to the question of a step, and its hint; shapes: {name: measures.Shown} after the solution was made. Raises what
    measured() raises."""
    said = _SAID[step.ask.kind](step.ask, shapes)
    return phrase("{answer}. {hint}", answer=said, hint=phrase(step.hint)) if step.hint else phrase("{answer}.", answer=said)


def _deed(ask, shapes):
    found = [phrase("{measure} is {value}", measure=named(one.measure, shapes), value=number(one.measure, shapes)) for one in ask.conditions]
    return phrase("The solution is made: {found}", found=listed(found))


def _points(ask, _shapes):
    points = ", ".join(map(str, sorted(ask.points)))
    if len(ask.points) == 1:
        return phrase("The point is {points}, counted from 0", points=points)
    return phrase("The points are {points}, counted from 0", points=points)


def _choice(ask, _shapes):
    return phrase("The answer is: {choice}", choice=phrase(ask.choices[ask.right].rstrip(".")))


_SAID = {
    'do': _deed, 'number': lambda ask, shapes: phrase("The answer is {value}", value=number(ask.value, shapes)),
    'choose': _choice, 'point': _points}
