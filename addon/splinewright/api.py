"""The public interface of Splinewright for scripts: exact values, recipes, and what follows what.

    from splinewright import api                            # installed as an add-on
    from bl_ext.user_default.splinewright import api        # installed as an extension (Blender 4.2 and later)

Names in `__all__` are stable: they keep their meaning, and new versions only add to them. Everything else in the add-on may
change at any time.

Objects are Blender's, of `bpy.data.objects`. A value is a curve, a list of curves, a patch, or a PatchSet of `splinecore`:

- curves: `points` (n, 3), `weights` (n,), `knots` (m,), `degree`, `periodic`;
- patches: `points` (nu, nv, 3), `weights` (nu, nv), `knots` a pair, `degree` a pair, `periodic` a pair.

Arrays are NumPy's, float64, with every digit. Points are in the space of the object, in Blender's units; angles are in radians.

Where something cannot be done a function raises `Refusal`, which is a ValueError, or `splinecore.Error`, with one sentence, and
changes nothing. A value of the wrong type raises a TypeError. Call these functions in Object Mode, and from the main thread. They
add no undo step: an operator that calls them adds one.
"""

from typing import NamedTuple

import bpy
import numpy as np

from . import __version__ as version
from .bridge.data import settings as display
from .bridge.data import problems
from .bridge.follow import follow, making
from .bridge.keys import point_keys
from .bridge.net import keyed
from .bridge.recipes import recipes
from .bridge.shape import recipe_edit, shape
from .core.base import library
from .core.base.failures import Refusal, WrongKind
from .core.base.library import sc as splinecore
from .core.base.words import phrase
from .core.recipes.table import RECIPES

if library.problem:
    raise ImportError(library.problem)
if 'splinewright' not in bpy.types.Mesh.bl_rna.properties:
    raise ImportError("Enable Splinewright in Blender's preferences before you import its interface for scripts")


__all__ = ('version', 'splinecore', 'Refusal',
           'is_shape', 'value', 'set_value', 'new_shape', 'is_changed_by_hand', 'restore', 'make_editable', 'detach',
           'Recipe', 'Setting', 'recipe_names', 'describe', 'make', 'loft', 'revolve', 'extrude', 'sweep', 'pipe', 'offset',
           'recipe', 'settings', 'set_settings', 'points', 'set_points',
           'inputs', 'set_inputs', 'axis_object', 'set_axis_object', 'followers', 'problem', 'update')


# Values -------------------------------------------------------------------------------------------

def is_shape(object):
    """Whether an object shows a shape: a mesh or curve with an exact definition."""
    return shape.has_shape(object)


def value(object):
    """The exact value of an object: a curve, a list of curves, a patch, or a PatchSet. None where it has no definition.

    It is a copy: to change the shape, give the new value to set_value(). Call update() first where inputs changed.
    """
    _require_object(object)
    return shape.value_of(object.data) if shape.has_shape(object) else None


def set_value(object, value):
    """Give a shape another value, and show it. All objects that share its data change.

    A mesh takes patches, a curve object takes curves. Refusal for a shape that a recipe makes: change its settings or inputs, or
    call make_editable() first.
    """
    display.of(_data(object)).value = value


def new_shape(name, value, collection=None):
    """A new object that shows a value, at the origin of the world.

    collection: where it goes; None for the active collection.
    """
    place = _place(collection)
    data = shape.new_data(name, value, (12, 12, display.AUTOMATIC))
    return _linked(bpy.data.objects.new(name, data), place)


def is_changed_by_hand(object):
    """Whether the mesh or curve was changed since Splinewright wrote it, in Edit Mode for example. restore() brings it back."""
    return shape.is_touched(_data(object))


def restore(object):
    """Make the mesh or curve again from the definition. What was changed by hand is lost."""
    shape.restore(_data(object))


def make_editable(object):
    """Drop the recipe of a shape: it follows nothing any more, and its value can be set."""
    _require_recipe(object)
    recipe_edit.end(_data(object))


def detach(object):
    """Leave a plain mesh or curve: what it shows stays, and the definition goes."""
    data = _data(object)
    point_keys.tell_lost(data, point_keys.count(data))
    shape.detach(data)


# Recipes ------------------------------------------------------------------------------------------

class Setting(NamedTuple):
    """A number, switch, choice or text of a recipe."""

    name: str
    label: str
    description: str
    default: object                     #: its type is that of the setting: float, int, bool or str
    least: float                        #: numbers are from here
    most: float                         #: to here
    choices: tuple                      #: the texts that it takes; () for any
    unit: str                           #: 'LENGTH' in Blender's units, 'ROTATION' in radians, or 'NONE'


class Recipe(NamedTuple):
    """What a recipe takes, as describe() tells it."""

    name: str
    label: str
    description: str
    inputs: tuple                       #: what each input must be, in words: ("one curve", "another curve")
    takes_more: bool                    #: whether any number of objects like the last one may follow
    takes_axis_object: bool             #: whether an object may give the axis or plane
    points: np.ndarray                  #: (n, 3): the points that it starts from; (0, 3) where it takes none
    settings: tuple                     #: of Setting


def recipe_names():
    """The names of all recipes: 'loft', 'revolve', 'circle' and so on."""
    return tuple(RECIPES)


def describe(name):
    """The Recipe of a name: its inputs and settings."""
    found = _recipe(name)
    wanted = ("one object", "more objects") if found.has_places else found.inputs
    return Recipe(found.kind, found.label, found.description, wanted, found.has_more or found.has_places, bool(found.frame),
                  found.start, tuple(_setting(parameter) for parameter in found.parameters))


def make(name, inputs=(), settings=None, points=None, axis_object=None, collection=None):
    """A new object that a recipe makes. It follows its inputs as soon as they change.

    name: of recipe_names(); inputs: the objects that it is made from, in their order; settings: values by name, where those that
    are missing have their defaults, or suit the inputs; points: (n, 3), for recipes that are made from points, None for those that
    they start from; axis_object: the object that gives the axis or plane, where the recipe takes one; collection: as of
    new_shape(). The inputs must be in the scene, and shown. A shape made from objects lies where the first of them lies.
    """
    found, given, place = _recipe(name), dict(settings or {}), _place(collection)
    sources = [inputs] if isinstance(inputs, bpy.types.Object) else list(inputs)
    for source in (*sources, *([] if axis_object is None else [axis_object])):
        _require_object(source)
    if found.inputs or found.has_places:
        if points is not None:
            raise Refusal("{label} is made from objects: it takes no points", label=phrase(found.label))
        ob = making.from_objects(found, sources, given, axis_object, bpy.context.scene, _depsgraph())
    elif sources or axis_object is not None:
        raise Refusal("{label} is made from numbers and points: it takes no objects", label=phrase(found.label))
    else:
        data = making.from_points(found, points, given, bpy.context.scene)
        ob = bpy.data.objects.new(data.name, data)
    return _linked(ob, place)


def loft(curves, **settings):
    """make('loft'): the surface through two or more curves, in this order; the first and last may be points, or surfaces that it
    continues."""
    return make('loft', curves, settings)


def revolve(profile, axis_object=None, **settings):
    """make('revolve'): the surface of a curve that turns about an axis: `axis` 'x', 'y' or 'z' of the axis object, or of the profile;
    `sweep` is the angle in radians."""
    return make('revolve', profile, settings, axis_object=axis_object)


def extrude(profile, direction=(0.0, 0.0, 1.0), **settings):
    """make('extrude'): the surface of a curve that moves along a vector (3,)."""
    return make('extrude', profile, {**dict(zip("xyz", map(float, direction))), **settings})


def sweep(rail, sections, **settings):
    """make('sweep'): the surface of one or more curves that move along a rail."""
    return make('sweep', [rail, *sections], settings)


def pipe(curve, radius, **settings):
    """make('pipe'): a round pipe about a curve."""
    return make('pipe', curve, {'radius': radius, **settings})


def offset(object, distance, **settings):
    """make('offset') of a curve, make('offset_surface') of a surface: what lies at a distance from it."""
    _require_object(object)
    name = 'offset' if object.type == 'CURVE' else 'offset_surface'
    return make(name, object, {'distance': distance, **settings})


def recipe(object):
    """The name of the recipe that makes a shape; "" for one that has none."""
    return recipes.kind(_data(object))


def settings(object):
    """The settings of the recipe that makes a shape, by name, with every digit."""
    _require_recipe(object)
    return recipes.parameters(_data(object))


def set_settings(object, **changes):
    """Change settings of the recipe that makes a shape; the others stay."""
    _require_recipe(object)
    data = _data(object)
    keyed.set_parameters(data, recipes.of(data).checked(changes), _depsgraph())


def points(object):
    """(n, 3) float64: the points that a recipe makes a shape from; (0, 3) where it takes none."""
    _require_recipe(object)
    return recipes.points(_data(object))


def set_points(object, points):
    """Give the recipe of a shape other points (n, 3)."""
    _require_recipe(object)
    data = _data(object)
    stored = recipes.read(data)
    recipe_edit.set_points(data, making.points_for(stored.recipe, points, stored.values))


# What follows what --------------------------------------------------------------------------------

def inputs(object):
    """The objects that a shape is made from, in their order; None stands for one that was deleted. [] for a shape that follows
    nothing."""
    data = _data(object)
    stored = recipes.read(data)
    return [] if stored is None else list(stored.frames if stored.recipe.has_places else stored.sources)


def set_inputs(object, inputs, turned=()):
    """Make a shape from other objects than now, or in another order, where its recipe takes any number of them.

    turned: for each input whether it runs the other way.
    """
    _require_recipe(object)
    wanted = list(inputs)
    for source in wanted:
        _require_object(source)
    flags = [bool(each) for each in turned]
    follow.set_inputs(_data(object), wanted, (flags + [False] * len(wanted))[:len(wanted)], _depsgraph())


def axis_object(object):
    """The object that gives a shape its axis or plane, or None."""
    stored = recipes.read(_data(object))
    return next(iter(stored.frames), None) if stored and stored.recipe.frame else None


def set_axis_object(object, axis_object):
    """Give a shape another object for its axis or plane; None for the axes of its first input."""
    _require_recipe(object)
    if axis_object is not None:
        _require_object(axis_object)
    follow.set_frame(_data(object), axis_object, _depsgraph())


def followers(object):
    """The objects whose shapes are made from an object, or take their axis from it. Those that follow these are not among them."""
    _require_object(object)
    found = follow.followers_of(object)
    return [other for other in bpy.data.objects if other.data in found]


def problem(object):
    """Why a shape is not up to date, as one sentence, or ""."""
    data = _data(object)
    return follow.problem(data) or problems.of(data, problems.KEYED) or problems.of(data, problems.SETTING)


def update():
    """Bring every shape up to date with what it follows; {object: problem} of those that cannot be.

    Blender does this before it draws, and after each step of a script that calls operators. A script that has just moved or changed
    an input calls it before it reads what follows.
    """
    bpy.context.view_layer.update()
    follow.refresh_all(set(), _depsgraph())
    bpy.context.view_layer.update()
    stopped = follow.stopped()
    return {ob: problem(ob) for ob in bpy.data.objects if ob.data in stopped}


def __dir__():
    return list(__all__)


# Helpers ------------------------------------------------------------------------------------------

def _depsgraph():
    return bpy.context.evaluated_depsgraph_get()


def _place(collection):
    """The collection for a new object. Raises Refusal where it takes none."""
    place = bpy.context.collection if collection is None else collection
    if not isinstance(place, bpy.types.Collection):
        raise WrongKind("a collection of Blender's is expected, not {place!r}", place=place)
    if place.library or place.override_library or bpy.context.scene.library:
        raise Refusal("the collection {name} is linked from another file", name=place.name)
    return place


def _linked(ob, place):
    place.objects.link(ob)
    return ob


def _require_object(given):
    if not isinstance(given, bpy.types.Object):
        raise WrongKind("an object of Blender's is expected, not {given!r}", given=given)


def _data(given):
    """The data-block of a shape."""
    _require_object(given)
    if not shape.has_shape(given):
        raise Refusal("{name} is not a Splinewright shape", name=given.name)
    return given.data


def _require_recipe(given):
    if not recipes.has(_data(given)):
        raise Refusal("{name} has no recipe", name=given.name)


def _recipe(name):
    if name not in RECIPES:
        raise Refusal("there is no recipe {name!r}: recipe_names() lists them", name=name)
    return RECIPES[name]


def _setting(parameter):
    return Setting(parameter.name, parameter.label, parameter.description, parameter.default, parameter.least, parameter.most,
                   tuple(choice[0] for choice in parameter.choices), parameter.unit)
