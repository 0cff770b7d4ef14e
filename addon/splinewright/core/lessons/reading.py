"""Lessons from JSON. A file is read, never run: what it may say is written here, and anything else is refused with its place."""

import json

from ..base.failures import Refusal
from ..base.library import sc
from ..recipes.table import RECIPES
from ..shape import definition as definitions
from . import places, sizes
from .lesson import VALUE, Ask, Change, Condition, Lesson, Make, Measure, Move, Step, Watch
from .measures import KINDS
from .places import Place

FORMAT = 1
#: Most bytes of a file, steps of a lesson, entries of a list.
MOST_BYTES, MOST_STEPS, MOST_ENTRIES = 2_000_000, 60, places.MOST_ENTRIES
#: Most faces of a span, each way.
MOST_FACES = 100
#: How deep measures of measures may go.
_MOST_DEPTH = 8
_VIEWS = ('TOP', 'FRONT', 'RIGHT', 'FREE')
_RELATIONS = ('near', 'above', 'below')


def read(text):
    """The Lesson of a text. Raises Refusal that says where it is wrong."""
    if len(text) > MOST_BYTES:
        raise Refusal("the file has more than {count:,} characters", count=MOST_BYTES)
    try:
        found = json.loads(text, object_pairs_hook=_object)
    except Refusal:
        raise
    except (ValueError, RecursionError) as error:
        raise Refusal("it is not JSON: {error}", error=error) from None
    return _lesson(Place("lesson", found))


def _object(pairs):
    """Of an object of JSON; elsewhere the last of two values with one name would count."""
    found = {}
    for name, value in pairs:
        if name in found:
            raise Refusal("{name!r} is there twice in one object", name=name[:60])
        found[name] = value
    return found


def _lesson(place):
    found = place.fields(('format', 'name', 'title', 'steps'), ('lectures',))
    if found['format'].found != FORMAT or isinstance(found['format'].found, bool):
        found['format'].fail("it is {found!r}: this version reads {format}", found=found['format'].found, format=FORMAT)
    steps = found['steps'].found
    if not isinstance(steps, list) or not 1 <= len(steps) <= MOST_STEPS:
        found['steps'].fail("a list of 1 to {count} steps is expected", count=MOST_STEPS)
    known, read_steps = {}, []
    for i, step in enumerate(steps):
        read_steps.append(_step(Place(f"step {i + 1}", step), known))
    sizes.require_few(read_steps)
    lectures = tuple(one.text() for one in found['lectures'].entries()) if 'lectures' in found else ()
    return Lesson(found['name'].text(), found['title'].text(), lectures, tuple(read_steps))


def _step(place, known):
    """known: {name: recipe or ""} of the shapes that earlier steps made; those of this one are added."""
    found = place.fields(('text',), ('make', 'change', 'view', 'overlays', 'move', 'watch', 'ask', 'hint', 'solution', 'wrong'))
    make = tuple(_make(one, known) for one in _list(found, 'make'))
    step = Step(
        found['text'].text(), make, _changes(found.get('change'), known),
        found['view'].text(_VIEWS) if 'view' in found else "",
        tuple(one.text() for one in _list(found, 'overlays')),
        tuple(_move(one, known) for one in _list(found, 'move')),
        tuple(_watch(one, known) for one in _list(found, 'watch')),
        _ask(found['ask'], known) if 'ask' in found else None,
        found['hint'].text() if 'hint' in found else "",
        _changes(found.get('solution'), known),
        tuple(_changes(one, known) for one in _list(found, 'wrong')))
    _check_help(place, step)
    return step


def _check_help(place, step):
    """Refuse what a learner would never see."""
    kind = step.ask.kind if step.ask is not None else ""
    if kind == 'do' and not step.solution:
        place.fail("a deed needs a solution")
    if step.hint and not kind:
        place.fail("a hint needs a question")
    if step.solution and kind not in ('do', 'number'):
        place.fail("a solution needs a question for a deed or a number")
    if step.wrong and kind != 'do':
        place.fail("wrong answers need a question for a deed")


def _list(found, name):
    return found[name].entries() if name in found else []


def _make(place, known):
    found = place.fields(('shape',), ('value', 'recipe', 'of', 'set', 'points', 'faces', 'place'))
    name = found['shape'].text()
    if name in known:
        found['shape'].fail("{name!r} is there already", name=name)
    if ('value' in found) == ('recipe' in found):
        place.fail("either a value or a recipe is expected")
    if 'value' in found:
        if 'place' in found:
            found['place'].fail("only what a recipe makes has a place")
        made = Make(name, _value(found['value']), faces=_faces(found))
    else:
        made = _made_by_recipe(found, name, known)
    known[name] = made.recipe
    return made


def _made_by_recipe(found, name, known):
    recipe = found['recipe'].text()
    if recipe not in RECIPES:
        found['recipe'].fail("there is no recipe {recipe!r}", recipe=recipe)
    inputs = tuple(_shape(one, known) for one in _list(found, 'of'))
    if not RECIPES[recipe].takes(len(inputs)):
        found['recipe'].fail("it is made from {wanted}, not from {count}",
                             wanted=RECIPES[recipe].wanted or "no shapes", count=len(inputs))
    points = _points(found['points'], recipe) if 'points' in found else ()
    at = _point(found['place']) if 'place' in found else (0.0, 0.0, 0.0)
    return Make(name, None, recipe, inputs, _settings(found.get('set'), recipe), points, _faces(found), at)


def _points(place, recipe):
    if not recipe or not RECIPES[recipe].points:
        place.fail("the shape has no recipe that is made from points")
    found = tuple(_point(one) for one in place.entries())
    if not found:
        place.fail("a list of points [x, y, z] is expected")
    return found


def _point(place):
    found = tuple(one.number() for one in place.entries())
    if len(found) != 3:
        place.fail("a point [x, y, z] is expected")
    return found


def _faces(found):
    if 'faces' not in found:
        return ()
    faces = tuple(one.whole(1) for one in found['faces'].entries())
    if len(faces) != 2 or max(faces) > MOST_FACES:
        found['faces'].fail("two numbers up to {most_faces} are expected", most_faces=MOST_FACES)
    return faces


def _changes(place, known):
    return tuple(_change(one, known) for one in place.entries()) if place is not None else ()


def _change(place, known):
    found = place.fields(('shape',), ('value', 'set', 'points', 'faces'))
    name = _shape(found['shape'], known)
    if len(found) != 2:
        place.fail("one of value, set, points, faces is expected")
    if 'points' in found:
        return Change(name, points=_points(found['points'], known[name]))
    if 'faces' in found:
        return Change(name, faces=_faces(found))
    if 'value' in found:
        if known[name]:
            place.fail("{name!r} is made by a recipe: it has settings, and no value of a file", name=name)
        return Change(name, _value(found['value']))
    return Change(name, None, _settings(found['set'], known[name]))


def _settings(place, recipe):
    if place is None:
        return {}
    if not recipe:
        place.fail("the shape has no recipe, so it has no settings")
    if not isinstance(place.found, dict):
        place.fail("an object is expected")
    for name, value in place.found.items():
        if isinstance(value, str):
            Place(f"{place.where}, {name}", value).has_characters()
    try:
        return RECIPES[recipe].checked(place.found)
    except (Refusal, TypeError) as error:
        place.fail(str(error))


def _value(place):
    """A splinecore value, as splinecore.dumps() writes it."""
    try:
        found = sc.loads(json.dumps(place.found))
        definitions.from_value(found)
        return found
    except (sc.Error, ValueError, TypeError, RecursionError) as error:
        place.fail("it is not a curve or patch: {error}", error=error)


def _shape(place, known):
    name = place.text()
    if name not in known:
        place.fail("there is no shape {name!r} yet", name=name)
    return name


def _move(place, known):
    found = place.fields(('shape',), ('points', 'setting'))
    name = _shape(found['shape'], known)
    if ('points' in found) == ('setting' in found):
        place.fail("either points or a setting is expected")
    if 'points' in found:
        return Move(name, tuple(one.whole() for one in found['points'].entries()))
    return Move(name, (), _setting(found['setting'], known[name]))


def _setting(place, recipe):
    name = place.text()
    if not recipe or name not in RECIPES[recipe].defaults:
        place.fail("the shape has no setting {name!r}", name=name)
    return name


def _watch(place, known):
    found = place.fields(('text',), ('values',))
    values = tuple(_measure(one, known) for one in _list(found, 'values'))
    text = found['text'].text()
    if any(int(number) >= len(values) for number in VALUE.findall(text)):
        found['text'].fail("{0}, {1} … stand for its values")
    return Watch(text, values)


def _measure(place, known, depth=0):
    if not isinstance(place.found, dict) or place.found.get('measure') not in list(KINDS):
        place.fail("a measure is expected: {kinds}", kinds=', '.join(KINDS))
    if depth >= _MOST_DEPTH:
        place.fail("measures of measures go {most_depth} deep at most", most_depth=_MOST_DEPTH)
    kind = place.found['measure']
    found = place.fields(('measure', 'of', *KINDS[kind].takes), ('piece',) if KINDS[kind].of == 'curve' else ())
    name = _shape(found['of'], known)
    arguments = {}
    for argument in found.keys() - {'measure', 'of'}:
        arguments[argument] = _argument(argument, found[argument], name, known, depth)
    return Measure(kind, name, arguments)


def _argument(name, place, shape, known, depth):
    if name == 'to':
        return _shape(place, known)
    if name == 'name':
        return _setting(place, known[shape])
    if name in ('index', 'order', 'piece'):
        return place.whole(1 if name == 'piece' else 0)
    return _quantity(place, known, depth + 1)


def _quantity(place, known, depth=0):
    """A number or a Measure."""
    return _measure(place, known, depth) if isinstance(place.found, dict) else place.number()


def _ask(place, known):
    readers = {'do': _ask_do, 'number': _ask_number, 'choose': _ask_choice, 'point': _ask_point}
    kind = next((kind for kind in readers if isinstance(place.found, dict) and kind in place.found), None)
    if kind is None:
        place.fail("one of {names} is expected", names=', '.join(readers))
    return readers[kind](place, known)


def _ask_do(place, known):
    conditions = tuple(_condition(one, known) for one in place.fields(('do',))['do'].entries())
    if not conditions:
        place.fail("a condition is expected")
    return Ask('do', conditions)


def _condition(place, known):
    relation = next((one for one in _RELATIONS if isinstance(place.found, dict) and one in place.found), None)
    if relation is None:
        place.fail("one of {names} is expected", names=', '.join(_RELATIONS))
    found = place.fields(('that', relation), ('within',) if relation == 'near' else ())
    within = found['within'].number() if 'within' in found else 0.0
    if relation == 'near' and not within > 0.0:
        place.fail("near needs a number above 0 as within")
    return Condition(_measure(found['that'], known), relation, _quantity(found[relation], known), within)


def _ask_number(place, known):
    found = place.fields(('number', 'within'))
    within = found['within'].number()
    if not within > 0.0:
        found['within'].fail("a number above 0 is expected")
    return Ask('number', value=_quantity(found['number'], known), within=within)


def _ask_point(place, known):
    found = place.fields(('point', 'of'))
    name = _shape(found['of'], known)
    if known[name] and not RECIPES[known[name]].points:
        found['of'].fail("{name!r} is made by a recipe without points: none can be picked", name=name)
    points = frozenset(one.whole() for one in found['point'].entries())
    if not points:
        found['point'].fail("the number of a point is expected, from 0")
    return Ask('point', shape=name, points=points)


def _ask_choice(place, known):
    found = place.fields(('choose', 'right'))
    choices, right = tuple(one.text() for one in found['choose'].entries()), found['right'].whole()
    if len(choices) < 2 or right >= len(choices):
        place.fail("two choices or more are expected, and the number of the right one from 0")
    return Ask('choose', choices=choices, right=right)
