"""What a step of a lesson speaks of, and the answer to its question in words."""

from .lesson import Measure
from .measures import measured


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
    return f"{said}. {step.hint}" if step.hint else f"{said}."


def _deed(ask, shapes):
    found = [f"{_named(one.measure, shapes)} is {_number(one.measure, shapes)}" for one in ask.conditions]
    return f"The solution is made: {', '.join(found)}"


def _points(ask, _shapes):
    text = "The point is" if len(ask.points) == 1 else "The points are"
    return f"{text} {', '.join(map(str, sorted(ask.points)))}, counted from 0"


_SAID = {
    'do': _deed, 'number': lambda ask, shapes: f"The answer is {_number(ask.value, shapes)}",
    'choose': lambda ask, _shapes: f"The answer is: {ask.choices[ask.right].rstrip('.')}", 'point': _points}


def _number(value, shapes):
    return f"{(measured(value, shapes) if isinstance(value, Measure) else value) + 0.0:.4g}"


def _named(measure, shapes):
    """A Measure in words: weight of point 1 of arc."""
    given, words = measure.arguments, measure.kind.replace("_", " ")
    if measure.kind == 'setting':
        words = given['name'].replace("_", " ")
    elif 'index' in given:
        kind = "knot" if measure.kind == 'knot' else "function" if measure.kind == 'basis' else "point"
        words = f"{kind} {given['index']}" if kind == "knot" else f"{words.removeprefix('point ')} of {kind} {given['index']}"
    places = ", ".join(_number(given[name], shapes) for name in ('at', 'at_v') if name in given)
    return "".join((words, f" of {measure.shape}", f", piece {given['piece']}," if 'piece' in given else "",
                    f" to {given['to']}" if 'to' in given else "", f" at {places}" if places else ""))
