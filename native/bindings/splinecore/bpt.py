"""BPT: Bezier patches as text, the format of the classic tea set.

A count of patches; for each the degrees in u and v, then its points, row after row.
"""

import re

import numpy as np

from . import _splinecore as _sc

__all__ = ["LIMIT", "dumps", "loads"]

#: More points than this in one file are taken for a damaged count.
LIMIT = 10_000_000


#: What Python takes for a number is wider: digits of other scripts, underscores.
_NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?|nan|[+-]?inf")


class _Words:
    """The words of a text, with the line each stands on."""

    def __init__(self, text):
        self._words = [(word, number) for number, line in enumerate(text.splitlines(), 1) for word in line.split()]
        self._next = 0

    def take(self, kind, what):
        if self._next >= len(self._words):
            raise _sc.InvalidShape(f"BPT: the file ends where {what} is expected")
        word, line = self._words[self._next]
        self._next += 1
        try:
            if not _NUMBER.fullmatch(word):
                raise ValueError(word)
            return kind(word)
        except ValueError:
            raise _sc.InvalidShape(f"BPT line {line}: '{word[:40]}' is not {what}") from None

    @property
    def left(self):
        return len(self._words) - self._next

    @property
    def line(self):
        return self._words[min(self._next, len(self._words) - 1)][1]


def loads(text, flip=False):
    r"""Read Bezier patches from BPT text.

    Parameters
    ----------
    text : str
        The text.
    flip : bool, default False
        Whether u and v of every patch are exchanged.

    Returns
    -------
    PatchSet
        The patches; equal points become one.

    Raises
    ------
    InvalidShape
        If the text is not BPT or ends early; the message has the line.

    Examples
    --------
    >>> patches = sc.bpt.loads("1\n1 1\n0 0 0  0 1 0  1 0 0  1 1 0")
    >>> len(patches), patches[0].degree
    (1, (1, 1))
    """
    words = _Words(text)
    count = words.take(int, "the count of patches")
    if not 1 <= count <= LIMIT:
        raise _sc.InvalidShape(f"BPT: the count of patches is {count}")
    patches = [_read_patch(words, i) for i in range(count)]
    if words.left:
        raise _sc.InvalidShape(f"BPT line {words.line}: {words.left} words follow the last patch")
    patch_set = _sc.PatchSet.from_patches(patches)
    return patch_set.flipped() if flip else patch_set


def _read_patch(words, index):
    degree_u = words.take(int, f"the degree in u of patch {index}")
    degree_v = words.take(int, f"the degree in v of patch {index}")
    for name, degree in (("u", degree_u), ("v", degree_v)):
        if not 1 <= degree <= 255:
            raise _sc.InvalidShape(f"BPT: patch {index} has degree {degree} in {name}, 1 to 255 is expected")
    size = 3 * (degree_u + 1) * (degree_v + 1)
    if words.left < size:
        raise _sc.InvalidShape(f"BPT: the file ends inside patch {index}: {size - words.left} numbers are missing")
    numbers = [words.take(float, f"a coordinate of patch {index}") for _ in range(size)]
    # Zeros of both signs are one point.
    points = np.array(numbers).reshape(degree_u + 1, degree_v + 1, 3) + 0.0
    try:
        return _sc.BezierPatch(points)
    except _sc.InvalidShape as error:
        raise _sc.InvalidShape(f"BPT: patch {index}: {error}") from None


def dumps(value):
    """Write patches as BPT text.

    Parameters
    ----------
    value : patch or PatchSet
        Patches; those that are not Bezier patches become exact Bezier patches.

    Returns
    -------
    str
        The text.

    Raises
    ------
    InvalidShape
        If a patch is rational, which the format cannot hold.

    Examples
    --------
    >>> plane = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
    >>> sc.bpt.loads(sc.bpt.dumps(plane))[0].degree
    (1, 1)
    """
    patches = [value[i] for i in range(len(value))] if isinstance(value, _sc.PatchSet) else [value]
    beziers = []
    for i, patch in enumerate(patches):
        if patch.is_rational:
            raise _sc.InvalidShape(f"patch {i} is rational: BPT holds no weights")
        beziers += [patch] if isinstance(patch, _sc.BezierPatch) else [b for row in patch.to_bezier() for b in row]
    lines = [str(len(beziers))]
    for patch in beziers:
        lines.append("{} {}".format(*patch.degree))
        lines += [f"{x!r} {y!r} {z!r}" for x, y, z in patch.points.reshape(-1, 3).tolist()]
    return "\n".join(lines) + "\n"
