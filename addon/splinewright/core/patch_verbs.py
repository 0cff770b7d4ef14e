"""Verbs of patches: those of curves, done along an axis, and those that take a patch as a whole.

What a verb is says core.verbs. An axis is 'u' or 'v'; axes are 'u', 'v' or 'uv'.
"""

from . import verbs
from .library import sc

_PAIRS = ('degree', 'domain', 'knots', 'periodic')
_VERBS = ('clamped', 'elevate', 'insert_knot', 'moebius', 'reduce', 'refine', 'remove_knot', 'remove_knots', 'reversed',
          'split', 'to_periodic', 'unclamped', 'with_domain')


class Along:
    """A patch as the verbs of curves see it: as a curve along one of its axes."""

    def __init__(self, patch, axis):
        self.patch, self.axis = patch, axis

    def __getattr__(self, name):
        if name in _PAIRS:
            return getattr(self.patch, name)['uv'.index(self.axis)]
        if name in _VERBS:
            method = getattr(self.patch, name)
            return lambda *arguments: self._of(method(self.axis, *arguments))
        raise AttributeError(f"a patch along {self.axis} has no {name}")

    def __eq__(self, other):
        return self.axis == other.axis and self.patch == other.patch

    def to_nurbs(self):
        return Along(self.patch.to_nurbs(), self.axis)

    def _of(self, result):
        if isinstance(result, tuple):
            return [Along(patch, self.axis) for patch in result]
        if isinstance(result, sc.Approximation):
            return verbs.Near(Along(result.value, self.axis), result.error)
        return Along(result, self.axis)


def along(axes, make):
    """make(axis, spent): the verb of core.verbs for an axis; `spent` is the error that was made along the one before.

    Raises what that raises, naming the axis where there are two.
    """
    def verb(patch):
        patches, errors = [patch], []
        for axis in axes:
            try:
                patches, error = _along_one(patches, axis, make(axis, sum(errors)))
            except (ValueError, ArithmeticError) as error:
                if len(axes) == 1:
                    raise
                raise type(error)(f"along {axis}: {error}") from error
            errors.append(error)
        return patches if len(patches) > 1 else verbs.Near(patches[0], _total(errors, patch, patches[0]))
    return verb


def _along_one(patches, axis, verb):
    """(the patches that stand for these, the largest error)."""
    after, worst = [], 0.0
    for patch in patches:
        result = verb(Along(patch, axis))
        if isinstance(result, verbs.Near):
            result, worst = result.value, max(worst, result.error)
        after += [part.patch for part in (result if isinstance(result, list) else [result])]
    return after, worst


def _total(errors, before, after):
    """The distance of two patches, which those along both axes bound together."""
    if len([error for error in errors if error > 0]) < 2:
        return sum(errors)
    return min(sum(errors), before.to_nurbs().largest_distance(after.to_nurbs()))


def first_parameters(patch, first):
    """(u, v): what a function of core.parameters finds along each axis."""
    return tuple(first(Along(patch, axis)) for axis in 'uv')


# The whole patch -----------------------------------------------------------------------------------


def swap():
    return lambda patch: patch.swapped()


def to_bezier():
    """In rows along v."""
    return lambda patch: [part for row in patch.to_bezier() for part in row]


def to_hermite():
    return lambda patch: patch if isinstance(patch, sc.HermitePatch) else patch.to_hermite()


def to_nurbs():
    return lambda patch: patch.to_nurbs()
