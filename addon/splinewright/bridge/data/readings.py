"""What was read of definitions, for each data-block, as long as its bytes stay the same: to compare them costs a fraction of what
it costs to hash them, and panels and overlays ask many times at each redraw."""

import hashlib
from functools import cached_property

import numpy as np

from .file_state import key, remember, state

#: Data-blocks of which something is kept; the numbers of all their points, and what is kept of each beside its definition.
_KEPT, _NUMBERS, _KNOWN = 512, 2 ** 22, 16
_NAMES = ('version', 'form', 'structure', 'pool', 'indices', 'knots')


class Reading:
    """The contents of a stored group, and what was worked out from them."""

    def __init__(self, group):
        self.contents = contents_of(group)
        self.definition = None          # of store.read()
        self._known = {}

    def is_of(self, group):
        """Whether a stored group has these contents."""
        return all(_is_same(group.get(name), self.contents.get(name)) for name in _NAMES)

    @cached_property
    def digest(self):
        """What differs where contents differ."""
        found = hashlib.blake2b(digest_size=16)
        for name in _NAMES:
            value = self.contents.get(name)
            is_array = isinstance(value, np.ndarray)
            content = value.tobytes() if is_array else repr(value).encode(errors='replace')
            found.update(b"%d %d " % (is_array, len(content)) + content)
        return found.digest()

    @cached_property
    def size(self):
        """How many numbers it has."""
        return sum(value.size for value in self.contents.values() if isinstance(value, np.ndarray))

    def kept(self, what, make):
        """What make() gave, once."""
        if what not in self._known:
            remember(self._known, what, make(), _KNOWN)
        return self._known[what]


def contents_of(group):
    """{name: content} of what a definition is stored as: arrays (n,) that cannot be written, numbers and texts."""
    found = {name: _content(group.get(name)) for name in _NAMES}
    return {name: content for name, content in found.items() if content is not None}


def of(data, group):
    """The Reading of a data-block that stores this group now."""
    name = key(data)
    known = state.readings.get(name)
    return known if known is not None and known.is_of(group) else _remember(name, Reading(group))


def _remember(name, reading):
    state.readings.pop(name, None)
    total = reading.size + sum(known.size for known in state.readings.values())
    while state.readings and total > _NUMBERS:
        total -= state.readings.pop(next(iter(state.readings))).size
    return remember(state.readings, name, reading, _KEPT)


def _content(value):
    """A copy; in place of what no definition has, such as another group, a text."""
    if hasattr(value, 'typecode'):
        numbers = np.array(value)
        numbers.flags.writeable = False
        return numbers
    return value if value is None or isinstance(value, (bool, int, float, str)) or value == [] else repr(value)


def _is_same(value, content):
    if isinstance(content, np.ndarray):
        return hasattr(value, 'typecode') and _are_same(np.asarray(value), content)
    if hasattr(value, 'typecode'):
        return False
    value = _content(value)
    return type(value) is type(content) and (value == content or repr(value) == repr(content))


def _are_same(one, other):
    """Whether arrays (n,) have the same bytes: 0.0 is not -0.0, and NaN equals itself."""
    if one.dtype != other.dtype or one.shape != other.shape:
        return False
    bits = f'u{one.dtype.itemsize}'
    return bool((one.view(bits) == other.view(bits)).all())
