"""A definition as ID properties of a Mesh or Curve, float64 and versioned.

read() is the one door: what it gives the library takes, and anything else that may be stored is refused with a sentence.
Version 1 had no stamp of what was written; a shape of that version is taken as it is.
"""

import json
import math

import bpy
import numpy as np
from idprop.types import IDPropertyGroup

from ...core.base.failures import Refusal, WrongKind
from ...core.base.library import sc
from ...core.base.words import phrase
from ...core.shape import definition as definitions
from ...core.shape.definition import Definition, Piece
from . import readings
from .file_state import look_again, remember, state

KEY = "splinewright_definition"
_STAMP = "stamp"
_DRAFT = "draft"
VERSION = 2
#: What a stamp counts is below it.
_MOST = 2.0 ** 53
#: Definitions that are kept by their digests after they were read.
_KEPT = 8

_NOUNS = {bpy.types.Mesh: "a mesh", bpy.types.Curve: "a curve", bpy.types.SurfaceCurve: "a surface of Blender's own",
          bpy.types.TextCurve: "a text"}


class UnreadableDefinition(Refusal):
    """The stored definition is damaged, or was made by a newer Splinewright. Nothing was changed."""


def has_definition(data):
    return KEY in data.keys()


def assign(owner, key, value):
    """owner[key] = value for ID properties. Blender 4.3 and 5.2 overrun memory when an array is
    assigned over one of another length, so what was there goes first."""
    if key in owner.keys():
        del owner[key]
    owner[key] = value


def overwrite(owner, key, values):
    """assign() (n,) float64, into the stored array where its size fits: making a new one takes longer than a step of a drag may."""
    there = owner.get(key)
    if getattr(there, 'typecode', None) == 'd' and len(there) == len(values):
        numbers = np.asarray(there)
        if numbers.flags.writeable:
            numbers[:] = values
            return
    assign(owner, key, values)


def write(data, definition):
    """Keep the definition with the data-block, in place of any before. The stamp goes with the old one."""
    assign(data, KEY, encoded(definition))
    _tell(data)


def _tell(data):
    """Whoever goes by what was written before is to look again."""
    look_again(data)
    state.drag = None


def digest(data):
    """What differs where definitions differ, for use as a key. Raises UnreadableDefinition where none can be told."""
    return reading(data).digest


def reading(data):
    """The readings.Reading of a data-block that has a definition. Raises UnreadableDefinition where something else is stored."""
    return readings.of(data, _group(data))


def _group(data):
    """The stored group. Raises UnreadableDefinition where something else is stored."""
    if not is_group(data[KEY]):
        raise _unreadable("it is not a group of properties")
    return data[KEY]


def is_group(stored):
    """Whether the stored value has keys; a data-block that is pointed to is none."""
    return isinstance(stored, IDPropertyGroup)


def _unreadable(reason):
    words = str(reason)[:200]
    return UnreadableDefinition("The definition of this shape is damaged ({words}): what it shows is left alone", words=words)


def write_draft(data, definition, stamp):
    """write() for a quick display, without exact normals."""
    group = data[KEY]
    if group.get('structure') == _structure(definition) and len(group.get('pool')) == definition.pool.size:
        overwrite(group, 'pool', np.ascontiguousarray(definition.pool, dtype=np.float64).ravel())
    else:
        write(data, definition)
        group = data[KEY]
    group[_DRAFT] = True
    write_stamp(data, stamp)


def is_draft(data):
    """Whether the display lacks exact normals."""
    return KEY in data.keys() and is_group(data[KEY]) and _DRAFT in data[KEY].keys()


def remove(data):
    """Forget the definition of a data-block."""
    if KEY in data.keys():
        del data[KEY]


def write_stamp(data, stamp):
    """Keep what identifies the geometry that was written: a few whole numbers below 2^53."""
    data[KEY]['version'] = VERSION
    overwrite(data[KEY], _STAMP, np.array(stamp, dtype=np.float64))
    _tell(data)


def write_final(data, stamp):
    """write_stamp() where everything is shown as it should be."""
    write_stamp(data, stamp)
    if is_draft(data):
        del data[KEY][_DRAFT]


def read_stamp(data):
    """The stamp as a list, or None where none was kept or it is damaged."""
    group = data[KEY]
    numbers = group.get(_STAMP) if is_group(group) else None
    if getattr(numbers, 'typecode', None) != 'd':
        return None
    numbers = np.array(numbers)
    return numbers.astype(np.int64).tolist() if (np.abs(numbers) < _MOST).all() else None


def encoded(definition):
    """The definition as an ID property group."""
    indices = [piece.indices.ravel() for piece in definition.pieces]
    knots = [knots for piece in definition.pieces for knots in piece.knots]
    return {
        'version': VERSION,
        'form': definition.form,
        'structure': _structure(definition),
        'pool': np.ascontiguousarray(definition.pool, dtype=np.float64).ravel(),
        'indices': np.concatenate(indices).astype(np.int32),
        'knots': np.concatenate(knots).astype(np.float64) if knots else [],
    }


def _structure(definition):
    return f"[{', '.join(piece.layout for piece in definition.pieces)}]"


def read(data):
    """The definition of a data-block, or None where it has none. What was read before is found again.

    Raises UnreadableDefinition with a sentence for the user.
    """
    if KEY not in data.keys():
        return None
    require_known_version(data)
    found = reading(data)
    try:
        if found.definition is None:
            found.definition = _definition(found)
        require_fitting(data, found.definition)
    except UnreadableDefinition:
        raise
    except Refusal as error:
        raise _unreadable(error) from error
    return found.definition


def _definition(found):
    """Of a Reading: undo brings contents back that were read before."""
    if found.digest not in state.definitions:
        remember(state.definitions, found.digest, _valid(lambda: found.contents), _KEPT)
    return state.definitions[found.digest]


def valid(group):
    """decoded() of the stored data, of which the library makes a value. Raises Refusal where it is damaged."""
    return _valid(lambda: readings.contents_of(group))


def _valid(get_contents):
    try:
        definition = decoded(get_contents())
        definitions.to_value(definition)
        return definition
    except (sc.Error, LookupError, TypeError, ValueError, AttributeError, ArithmeticError, RecursionError,
            MemoryError) as error:
        raise Refusal(str(error)) from error


def pool(data):
    """(n, 4): the points of a definition, which may be damaged elsewhere. Raises UnreadableDefinition."""
    found = _group(data).get('pool')
    if getattr(found, 'typecode', None) != 'd' or len(found) % 4:
        raise _unreadable("its points are none")
    return np.array(found).reshape(-1, 4)


def require_known_version(data):
    """Raises UnreadableDefinition where a newer Splinewright wrote what would be lost."""
    version = data[KEY].get('version') if KEY in data.keys() and is_group(data[KEY]) else None
    if isinstance(version, int) and version > VERSION:
        raise UnreadableDefinition("This shape was made by a newer Splinewright (definition version {version}, this one reads "
                                   "{known}): it is shown but cannot be changed here",
                                   version=version, known=VERSION)


def require_fitting(data, definition):
    """Raises WrongKind unless the data-block can show the definition. Texts and surfaces are Curves, too."""
    shows_curves, shows_patches = type(data) is bpy.types.Curve, type(data) is bpy.types.Mesh
    if definition.has_curves and not shows_curves:
        raise WrongKind("{name} is {what}: curves are shown by a curve object", name=data.name, what=_NOUNS.get(type(data), "no curve"))
    if not definition.has_curves and not shows_patches:
        raise WrongKind("{name} is {what}: patches are shown by a mesh", name=data.name, what=_NOUNS.get(type(data), "no mesh"))


def decoded(group):
    """The definition of the readings.contents_of() of what encoded() made, of this version or one before.

    Raises Refusal, KeyError and the like where it is damaged.
    """
    if not isinstance(group['version'], int) or not 1 <= group['version'] <= VERSION:
        raise Refusal("its version is {version!r}", version=group['version'])
    pool = np.asarray(group['pool'], dtype=np.float64).reshape(-1, 4)
    all_indices = np.asarray(group['indices'])
    if all_indices.dtype != np.int32:
        raise ValueError("its indices are no whole numbers")
    all_knots = np.asarray(group['knots'], dtype=np.float64)
    pieces, next_index, next_knot = [], 0, 0
    for entry in json.loads(group['structure']):
        count = math.prod(map(_whole, entry['shape']))
        indices = all_indices[next_index:next_index + count].reshape(entry['shape'])
        next_index += count
        knots = []
        for length in entry['knots']:
            knots.append(all_knots[next_knot:next_knot + _whole(length)])
            next_knot += length
        pieces.append(Piece(entry['kind'], indices, tuple(entry['degree']), tuple(entry['periodic']), tuple(knots),
                            entry.get('name', "")))
    if next_index != len(all_indices) or next_knot != len(all_knots):
        raise Refusal("its lengths disagree")
    for array in (pool, all_indices, all_knots):
        array.flags.writeable = False
    definition = Definition(str(group['form']), pool, tuple(pieces))
    definition.require_consistent()
    return definition


def _whole(number):
    """A count. Raises Refusal for anything else."""
    if type(number) is not int or not 0 <= number < _MOST:
        raise ValueError(phrase("{number!r} is no count", number=number))
    return number
