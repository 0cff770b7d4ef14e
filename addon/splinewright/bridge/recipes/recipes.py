"""How a definition comes about, kept beside it on the Mesh or Curve: by following another object, or from
the numbers and points of a recipe. A shape without one has its own points.

read() is the one door: what it gives is valid, and anything else that may be stored is refused with a sentence.
"""

import contextlib
import itertools
import math
from typing import NamedTuple

import bpy
import numpy as np

from ...core.base.failures import Refusal
from ...core.recipes.recipe import Recipe
from ...core.recipes.table import RECIPES
from ..data import store
from ..data.file_state import state
from . import parameters as properties
from . import input_drivers

#: No registered property has this name: before Blender 5.0 reading it would put an empty group in place of ours.
KEY = "splinewright_recipe"
VERSION = 2
#: Keys of the pointers to the objects that a shape is made from, of whether each was a shape then, and of whether it is
#: turned; the second ones end in _2, and so on.
_INPUT, _WAS_SHAPE, _TURNED = 'input', 'shape', 'turned'
#: Key of the pointer to an object of which the place and axes alone count; of several the keys are numbered from 1.
_FRAME, _NUMBERED = 'frame', 'frame_'
#: The names of all those objects, one a line: of one that is gone nothing else is left.
_NAMES = 'names'
#: The property that a driver is on which reads the inputs, and its data path.
_WATCHED = "watched"
WATCHED = f'["{KEY}"]["{_WATCHED}"]'


class Stored(NamedTuple):
    """The stored data of a recipe."""

    recipe: Recipe
    values: dict                        # of its parameters, by name
    points: np.ndarray                  # (n, 3) float64; none where it has inputs
    sources: tuple                      # objects that it is made from, None for one that was deleted
    were_shapes: tuple                  # of each: whether it was a shape when it was chosen
    turned: tuple                       # of each: whether it runs the other way
    frames: tuple                       # objects of which the place and axes alone count, None for a deleted one
    error: float                        # how far what it made may lie from what it should be
    said: str                           # what was achieved beside that, in words
    warning: str                        # what is wrong with what it made, in words


def has(data):
    """Whether a recipe is stored, readable or not. An empty group is none: Blender makes one by reading a property."""
    if KEY not in data.keys():
        return False
    stored = data[KEY]
    return not store.is_group(stored) or len(stored.keys()) > 0


def follows(data):
    """Whether the shape is made from other objects, as far as can be told without reading the recipe."""
    return has(data) and store.is_group(data[KEY]) and not {_INPUT, _numbered(0)}.isdisjoint(data[KEY].keys())


def pointers(data):
    """The objects that a shape is made from, as far as can be told without reading the recipe; those deleted are missing."""
    return _pointed(data, _input_keys(data[KEY])) if store.is_group(data[KEY]) else []


def is_from(data, obs):
    """Whether a data-block, of the add-on or not, is made from one of these objects, or goes where they are."""
    if not hasattr(data, 'splinewright_parameters') or not follows(data):
        return False
    return not obs.isdisjoint((*pointers(data), *frames(data)))


def frames(data):
    """The objects whose place and axes alone count, as pointers()."""
    return _pointed(data, _frame_keys(data[KEY])) if store.is_group(data[KEY]) else []


def all_pointers(data):
    """The objects that a shape is made from, and frames, as pointers()."""
    return [*pointers(data), *frames(data)]


def pointed_by_name(data):
    """[(name, object)] of all that a shape is made from and of frames, as far as can be told without reading the recipe: None for
    one that was deleted, with the name that it had last, or ""."""
    group = data[KEY]
    if not store.is_group(group):
        return []
    found = [group.get(pointer) for pointer in (*_input_keys(group), *_frame_keys(group)) if pointer in group.keys()]
    names = _names_in(group)
    names += [""] * (len(found) - len(names))
    return [(ob.name, ob) if isinstance(ob, bpy.types.Object) else (name, None) for name, ob in zip(names, found)]


def _names_in(group):
    names = group.get(_NAMES, "")
    return names.split("\n") if isinstance(names, str) and names else []


def keep_names(data):
    """Keep what the objects that a shape is made from are called now, where another name was kept."""
    names = [name for name, _ in pointed_by_name(data)]
    if names != _names_in(data[KEY]):
        data[KEY][_NAMES] = "\n".join(names)


def _of(name, index):
    return name if index == 0 else f"{name}_{index + 1}"


def _input_keys(group):
    """Of the objects that a shape is made from, in their order."""
    return [key for key in (_of(_INPUT, i) for i in range(len(group.keys()))) if key in group.keys()]


def _numbered(index):
    return f"{_NUMBERED}{index + 1}"


def _frame_keys(group):
    """Of the objects whose place and axes alone count, in their order."""
    return [name for name in group.keys() if name.startswith(_NUMBERED)] or [_FRAME]


def _pointed(data, keys):
    found = map(data[KEY].get, keys) if store.is_group(data[KEY]) else ()
    return [ob for ob in found if isinstance(ob, bpy.types.Object)]


def kind(data):
    """The kind of a recipe, as far as can be told without reading it; "" where there is none that is known."""
    named = data[KEY].get('kind') if has(data) and store.is_group(data[KEY]) else None
    return named if type(named) is str and named in RECIPES else ""


def read(data):
    """The Stored recipe of a data-block, or None. Raises UnreadableDefinition for one that is damaged, or newer."""
    if not has(data):
        return None
    group = data[KEY]
    if not store.is_group(group):
        raise _damaged(data, "it is not a group of properties")
    recipe = _recipe(data, group)
    try:
        sources = _sources(group, recipe)
        return Stored(recipe, _values(group, recipe), _points(group, recipe), sources, _flags(group, _WAS_SHAPE, sources),
                      _flags(group, _TURNED, sources), _frames(group, recipe), _number(group.get('error', 0.0)),
                      str(group.get('said', "")), str(group.get('warning', "")))
    except (TypeError, ValueError, AttributeError, OverflowError) as error:
        raise _damaged(data, error) from error


def _damaged(data, reason):
    return store.UnreadableDefinition("The recipe of {name} is damaged ({reason}): it is shown as it was last, and Apply "
                                      "Construction drops the recipe",
                                      name=data.name, reason=str(reason)[:200])


def _recipe(data, group):
    version, stored_kind = group.get('version', 0), group.get('kind')
    if type(version) is not int or type(stored_kind) is not str:
        raise _damaged(data, "its version or kind is none")
    if version > VERSION or stored_kind not in RECIPES:
        raise store.UnreadableDefinition("{name} has a recipe of a newer Splinewright: it is shown as it was last", name=data.name)
    return RECIPES[stored_kind]


def _values(group, recipe):
    stored = group.get('parameters')
    if not store.is_group(stored):
        raise ValueError("its parameters are no group")
    return {parameter.name: parameter.checked(stored[parameter.name]) if parameter.name in stored.keys()
            else _value_before(parameter) for parameter in recipe.parameters}


def _value_before(parameter):
    """Of a file that is older than the parameter."""
    return parameter.default if parameter.before is None else parameter.before


def _number(stored):
    if not isinstance(stored, (bool, int, float)) or not math.isfinite(stored):
        raise ValueError("a number of it is none")
    return stored


def _points(group, recipe):
    stored = group.get('points', ())
    points = np.array(stored, dtype=np.float64).reshape(-1, 3)
    if not np.isfinite(points).all():
        raise ValueError("its points are not finite")
    if recipe.points and not len(points):
        raise ValueError("its points are missing")
    points.flags.writeable = False
    return points


def _sources(group, recipe):
    if bool(recipe.inputs) != (_INPUT in group.keys()) or recipe.has_places and _numbered(0) not in group.keys():
        raise ValueError("it has other inputs than its kind")
    count = max(len(recipe.inputs), len(_input_keys(group)) if recipe.has_more else 0)
    sources = tuple(group.get(_of(_INPUT, i)) for i in range(count))
    if not all(source is None or isinstance(source, bpy.types.Object) for source in sources):
        raise ValueError("what it is made from is no object")
    return sources


def _flags(group, name, sources):
    return tuple(bool(group.get(_of(name, i), False)) for i in range(len(sources)))


def _frames(group, recipe):
    keys = _frame_keys(group)
    if keys == [_FRAME] and _FRAME not in group.keys():
        return ()
    found = tuple(group.get(pointer) for pointer in keys)
    if not all(frame is None or isinstance(frame, bpy.types.Object) for frame in found):
        raise ValueError("what gives its place is no object")
    wanted = list(map(_numbered, range(len(keys)))) if recipe.has_places else [_FRAME]
    if keys != wanted or not (recipe.frame or recipe.has_places):
        raise ValueError("it has other objects than its kind")
    return found


def has_points(data):
    """Whether the shape is made from its own points, which its net shows."""
    return has(data) and not follows(data) and len(points(data)) > 0


def remove(data):
    if KEY in data.keys():
        input_drivers.stop(data, WATCHED)
        del data[KEY]
        state.causes = None


def require_free(data):
    """Raises Refusal where a recipe would overwrite changes made by other means."""
    if follows(data):
        raise Refusal("{name} follows another object: use Apply Construction first", name=data.name)
    if has(data):
        raise Refusal("{name} is made by a recipe: change its numbers in the panel, or use Apply Construction first", name=data.name)


def of(data):
    """The Recipe, or None. Raises as read()."""
    stored = read(data)
    return stored.recipe if stored else None


def parameters(data):
    """The numbers and texts of a recipe, by name. Raises as read()."""
    return dict(read(data).values)


def points(data):
    """(n, 3) float64: the points of a recipe; none where it has inputs. Raises as read()."""
    return read(data).points


def read_inputs(data):
    """The objects that a shape is made from, None for one that was deleted; [] where there are none. Raises as read()."""
    stored = read(data)
    return list(stored.sources) if stored else []


def input_at(data, index):
    """(an object that a shape is made from, or None for one that was deleted; whether it is turned), without reading the recipe."""
    group = data[KEY]
    source = group.get(_of(_INPUT, index))
    return (source if isinstance(source, bpy.types.Object) else None), bool(group.get(_of(_TURNED, index), False))


def around(data):
    """(n, 3): the points around which curves that may run far are shown; None where they are shown as they are."""
    stored = read(data)
    return stored.points if stored and stored.recipe.is_endless else None


def error(data):
    """How far what a recipe made may lie from what it should be. Raises as read()."""
    return read(data).error


def write_derived(data, recipe, values, sources, result, frames=(), turned=()):
    """Make a shape from objects from now on, as of Stored. result: the core.recipes.recipe.Result that it shows."""
    group = {'version': VERSION, 'kind': recipe.kind, 'parameters': dict(values), **_achieved(result)}
    for i, (source, is_turned) in enumerate(itertools.zip_longest(sources, turned[:len(sources)], fillvalue=False)):
        group.update({_of(_INPUT, i): source, _of(_WAS_SHAPE, i): bool(source.data) and store.has_definition(source.data)})
        group.update({_of(_TURNED, i): True} if is_turned else {})
    group.update(zip(map(_numbered, itertools.count()) if recipe.has_places else (_FRAME,), frames))
    group[_NAMES] = "\n".join(ob.name if ob else "" for ob in (*sources, *frames))
    store.assign(data, KEY, group)
    state.causes = None
    state.overlaid.clear()
    _show(data, recipe, values, frames, len(sources))
    watch(data)


def watch(data):
    """Let Blender evaluate what a shape is made from with it. Whether it did not do so before."""
    if _WATCHED not in data[KEY].keys():
        data[KEY][_WATCHED] = 0.0
    return input_drivers.start(data, WATCHED, pointers(data), frames(data))


def write_achieved(data, result):
    """Keep what a recipe achieved: a core.recipes.recipe.Result."""
    for name, value in _achieved(result).items():
        data[KEY][name] = value


def _achieved(result):
    return {'error': float(result.error), 'said': result.said, 'warning': result.warning}


def write_made(data, recipe, values, rows, result):
    """Keep a recipe with its parameters and points, and what it says of the core.recipes.recipe.Result that the shape shows."""
    store.assign(data, KEY, {'version': VERSION, 'kind': recipe.kind, 'parameters': dict(values), **_achieved(result),
                             'points': np.ascontiguousarray(rows, dtype=np.float64).ravel()})
    properties.show(data, recipe, values)


def show_new(blocks):
    """show() for those of the data-blocks that have a recipe and never were shown: they are of older files."""
    for data in blocks:
        recipe = RECIPES.get(kind(data)) if isinstance(data, (bpy.types.Mesh, bpy.types.Curve)) else None
        if recipe and not properties.are_shown(data, recipe, len(_input_keys(data[KEY]))):
            show(data)


def show(data):
    """Let Blender's properties show the parameters of a recipe, if it has one that can be read."""
    with contextlib.suppress(store.UnreadableDefinition):
        stored = read(data)
        if stored:
            _show(data, stored.recipe, stored.values, stored.frames, len(stored.sources))


def _show(data, recipe, values, frames, count):
    properties.show(data, recipe, values, frames if recipe.frame else (), count if recipe.has_more else 0)
