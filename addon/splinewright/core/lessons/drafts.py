"""Lessons that are being made: what a file says, put together from shapes as they are."""

import json
import re
from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..recipes.table import RECIPES
from . import reading


class Present(NamedTuple):
    """A shape as a lesson says it."""

    recipe: str                         # "" where it is a value
    inputs: tuple                       # names of shapes
    settings: dict
    value: object                       # where it lies in the world
    why_value: str = ""                 # why it is kept as a value though a recipe makes it
    points: tuple = ()                  # rows (x, y, z) that the recipe is made from; () for those that it starts from
    faces: tuple = ()                   # of a surface: how many in each span, for u and v; () where the add-on chooses
    place: tuple = (0.0, 0.0, 0.0)      # of the object that a recipe makes; its value lies around that


def begun(title, step):
    """A lesson of one step, as its file says it. Raises Refusal."""
    name = re.sub(r"[\W_]+", "-", title.lower()).strip("-")
    if not name:
        raise Refusal("the title needs a letter or a digit")
    return {'format': reading.FORMAT, 'name': name, 'title': title, 'steps': [step]}


def step(text, makes=(), changes=(), view="", overlays=()):
    """A step, without empty entries."""
    found = {'text': text, 'make': list(makes), 'change': list(changes), 'view': view, 'overlays': list(overlays)}
    return {name: value for name, value in found.items() if value}


def text_of(draft):
    """A lesson as the text of its file. Raises Refusal where it cannot be read back."""
    text = re.sub(r"\[[\s\d.,eE+-]*\]", lambda found: re.sub(r"\s+", " ", found[0]) if "\n" in found[0] else found[0],
                  json.dumps(draft, indent=1, ensure_ascii=False))
    reading.read(text)
    return text


def make(name, present):
    """What makes a shape, as a step says it."""
    if present.recipe:
        inputs = {'of': list(present.inputs)} if present.inputs else {}
        place = {'place': list(present.place)} if any(present.place) else {}
        points = {'points': _rows(present.points)} if present.points else {}
        return {'shape': name, 'recipe': present.recipe, **inputs, 'set': dict(present.settings), **points, **place, **_faces(present)}
    return {'shape': name, 'value': _said(present.value), **_faces(present)}


def _faces(present):
    return {'faces': list(present.faces)} if present.faces else {}


def _rows(points):
    return [list(point) for point in points]


def _said(value):
    return json.loads(sc.dumps(value))


def state_of(lesson):
    """{name: Present} as the last step of a lesson begins."""
    known = {}
    for each in lesson.steps:
        for one in each.make:
            known[one.shape] = Present(one.recipe, one.inputs, dict(one.settings), one.value, "", one.points, one.faces, one.place)
        for one in each.change:
            before = known[one.shape]
            said = {'value': one.value, 'points': one.points, 'faces': one.faces}
            known[one.shape] = before._replace(settings={**before.settings, **one.settings},
                                               **{key: value for key, value in said.items() if value not in (None, ())})
    return known


def changes(known, present):
    """What leads from {name: Present} to others, as a step says it; shapes that are missing there stay as they are. Raises Refusal where
    no step can say it."""
    found = []
    for name, now in present.items():
        before = known.get(name)
        if before is None:
            continue
        if (before.recipe, before.inputs) != (now.recipe, now.inputs):
            raise Refusal("{name} is made otherwise than the lesson says: {reason}" if now.why_value else
                          "{name} is made otherwise than the lesson says", name=name, reason=now.why_value)
        if before.place != now.place:
            raise Refusal("{name} was moved: a step can change what it is made from, not where it lies", name=name)
        if before.recipe:
            settings = {key: value for key, value in now.settings.items() if key not in before.settings or before.settings[key] != value}
            found += [{'shape': name, 'set': settings}] if settings else []
            found += [{'shape': name, 'points': _rows(_points(now))}] if _points(before) != _points(now) else []
        elif _said(before.value) != _said(now.value):
            found.append({'shape': name, 'value': _said(now.value)})
        found += [{'shape': name, **_faces(now)}] if now.faces and now.faces != before.faces else []
    return found


def _points(present):
    """Those that its recipe is made from."""
    recipe = RECIPES[present.recipe]
    return present.points or tuple(tuple(map(float, point)) for point in recipe.start_for(recipe.completed(present.settings)))


def moves(known, present, changed):
    """What a learner moves, by what changes() gave: settings, and points of a curve that has as many as before."""
    found = []
    for one in changed:
        name = one['shape']
        if 'set' in one:
            found += [{'shape': name, 'setting': setting} for setting in one['set']]
            continue
        if 'faces' in one:
            continue
        before, now = ((_points(each[name]) if each[name].recipe else getattr(each[name].value, 'points', None)) for each in (known, present))
        if before is not None and now is not None and np.shape(before) == np.shape(now):
            moved = np.flatnonzero((np.asarray(before) != np.asarray(now)).reshape(-1, 3).any(1)).tolist()
            found += [{'shape': name, 'points': moved[:reading.MOST_ENTRIES]}] if moved else []
    return found[:reading.MOST_ENTRIES]


def ask(draft, question, hint="", solution=(), may_move=()):
    """The lesson with a question at its last step, in place of the one that is there; conditions of a deed are added to
    those. Raises Refusal."""
    last = dict(draft['steps'][-1])
    if 'do' in question and 'do' in last.get('ask', {}):
        question = {'do': [*last['ask']['do'], *question['do']]}
    for name in ('ask', 'solution', 'wrong', 'move'):
        if 'do' not in question or name != 'wrong':
            last.pop(name, None)
    last['ask'] = question
    last.update({name: value for name, value in (('hint', hint), ('solution', list(solution)), ('move', list(may_move))) if value})
    return {**draft, 'steps': [*draft['steps'][:-1], last]}
