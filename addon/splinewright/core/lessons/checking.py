"""Whether an answer is right, and texts with numbers that follow the shapes."""

from ..base.words import say
from .lesson import VALUE, Measure
from .measures import measured


def is_right(ask, shapes, answer=None):
    """Whether a question is answered: by the shapes {name: measures.Shown} as they are, by a typed number, by the number of a choice
    from 0, or by numbers of points. Raises what measured() raises."""
    if ask.kind == 'do':
        return all(holds(condition, shapes) for condition in ask.conditions)
    if answer is None:
        return False
    if ask.kind == 'choose':
        return answer == ask.right
    if ask.kind == 'point':
        return set(answer) == ask.points
    return bool(abs(answer - _number(ask.value, shapes)) <= ask.within)


def holds(condition, shapes):
    """Whether a Condition holds."""
    found, wanted = measured(condition.measure, shapes), _number(condition.value, shapes)
    if condition.relation == 'near':
        return abs(found - wanted) <= condition.within
    return found > wanted if condition.relation == 'above' else found < wanted


def _number(value, shapes):
    return measured(value, shapes) if isinstance(value, Measure) else value


def watched(watch, shapes):
    """The text of a Watch with its numbers, in four digits."""
    numbers = [f"{measured(value, shapes) + 0.0:.4g}" for value in watch.values]
    return VALUE.sub(lambda found: numbers[int(found[1])], say(watch.text))
