"""Seeded damage: to definitions, to the mappings of patches, to texts."""

import dataclasses

import numpy as np

#: What a file may hold where a number is expected.
ODD_NUMBERS = (0, -1, 1, 2, 3, 255, 256, 2**31 - 1, -2**31, 2**31, 2**63, 10**30, 0.5, 1e308, float("nan"), float("inf"),
               True, None, "3", b"3", [], {}, (1, 2))
HARD = (0.0, -0.0, 1.0, -1.0, 1e-300, 5e-324, 1e300, -1e300, 1.7e308, float("nan"), float("inf"), 1 / 3)


def some(random, values):
    return values[random.integers(len(values))]


def damaged_array(random, array):
    """Another array: numbers changed, of another shape, of another type."""
    array = np.array(array)
    how = random.integers(8)
    if array.size and how < 4:
        flat = array.ravel().copy()
        at = random.integers(flat.size)
        if array.dtype.kind == 'f':
            flat[at] = some(random, HARD)
        else:
            flat[at] = some(random, (0, -1, 1, 7, 10**6, 2**31 - 1, -2**31))
        return flat.reshape(array.shape)
    if how == 4:
        return array[:-1]
    if how == 5:
        return array.ravel()
    if how == 6:
        return array[..., None]
    return array[:0]


def damaged_tuple(random, values):
    """A tuple with one entry changed, missing or twice."""
    values, how = list(values), random.integers(4)
    if values and how < 2:
        at = random.integers(len(values))
        is_array = isinstance(values[at], np.ndarray)
        values[at] = damaged_array(random, values[at]) if is_array and how else some(random, ODD_NUMBERS)
    elif how == 2:
        values = values[:-1]
    else:
        values = values + values[:1]
    return tuple(values)


def damaged_piece(random, piece):
    name = some(random, ('kind', 'indices', 'indices', 'degree', 'periodic', 'knots', 'knots'))
    value = getattr(piece, name)
    if name == 'kind':
        value = some(random, ('bezier', 'hermite', 'nurbs', 'power', '', None, 3))
    else:
        value = damaged_array(random, value) if name == 'indices' else damaged_tuple(random, value)
    return dataclasses.replace(piece, **{name: value})


def damaged_definition(random, definition):
    """The definition with one thing changed."""
    name = some(random, ('form', 'pool', 'pieces', 'piece', 'piece', 'piece'))
    pieces = list(definition.pieces)
    if name == 'form':
        return dataclasses.replace(definition, form=some(random, ('curve', 'curves', 'patch', 'patch_set', '', None)))
    if name == 'pool':
        return dataclasses.replace(definition, pool=damaged_array(random, definition.pool))
    if name == 'pieces' or not pieces:
        return dataclasses.replace(definition, pieces=damaged_tuple(random, pieces))
    at = random.integers(len(pieces))
    if dataclasses.is_dataclass(pieces[at]):
        pieces[at] = damaged_piece(random, pieces[at])
    return dataclasses.replace(definition, pieces=tuple(pieces))


def damaged_fields(random, fields):
    """A mapping with an entry changed, missing or added."""
    fields = dict(fields)
    if not fields:
        return fields
    name = some(random, sorted(fields))
    value, how = fields[name], random.integers(6)
    if how == 0:
        del fields[name]
    elif how == 1:
        fields[some(random, ('kind', 'knots', 'degree', 'periodic', 'parameters', 'other', ''))] = value
    elif how == 2 or isinstance(value, str):
        fields[name] = some(random, ODD_NUMBERS)
    else:
        is_array = isinstance(value, np.ndarray) and value.ndim > 0
        row = value if isinstance(value, (tuple, list)) else (value,)
        fields[name] = damaged_array(random, value) if is_array else damaged_tuple(random, row)
    return fields


def damaged_text(random, text):
    """A text with characters changed, cut out, doubled or moved."""
    for _ in range(random.integers(1, 4)):
        at, other = sorted(random.integers(0, len(text) + 1, 2))
        how = random.integers(5)
        if how == 0:
            text = text[:at] + text[other:]
        elif how == 1:
            text = text[:other] + text[at:]
        elif how == 2:
            text = text[:at] + some(random, list('0123456789.-+eE[]{}",: \n\0é\ud800')) + text[at + 1:]
        elif how == 3:
            text = text[:at] + some(random, ("null", "true", "1e999", "-0", "NaN", "[]", "{}", '""')) + text[at:]
        else:
            text = text[at:] + text[:at]
    return text
