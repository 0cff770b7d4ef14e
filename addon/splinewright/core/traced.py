"""Curves as verbs see them, with where they lie on the curve that a verb was asked to change."""

from typing import NamedTuple

from . import parameters, places
from .definition import CURVES
from .library import sc


class Near(NamedTuple):
    """A curve or patch that stands for another, as splinecore's Approximation."""

    value: object
    error: float


class Traced:
    """A curve with its methods, whose results are Traced, too. stretches: of core.places."""

    def __init__(self, curve, stretches=places.WHOLE):
        self.curve, self.stretches = curve, stretches

    def __getattr__(self, name):
        found = getattr(self.curve, name)
        if not callable(found):
            return found
        return getattr(self, f"_{name}", lambda *arguments, **settings: self._of(found(*map(bare, arguments), **settings)))

    def __eq__(self, other):
        return self.curve == bare(other)

    def _reversed(self):
        return Traced(self.curve.reversed(), places.reversed_(self.stretches))

    def _moebius(self, rho):
        return Traced(self.curve.moebius(rho), places.sped(self.stretches, rho))

    def _standard_form(self):
        first, last = self.curve.weights[[0, -1]]
        made = self.curve.standard_form()
        return Traced(made, places.sped(self.stretches, (first / last) ** (1 / made.degree)))

    def _split(self, at):
        parts, (start, end) = self.curve.split(at), self.curve.domain
        fraction = (at - start) / (end - start)
        if len(parts) == 1:
            return [Traced(parts[0], places.opened(self.stretches, fraction))]
        return [Traced(part, places.cut(self.stretches, *ends))
                for part, ends in zip(parts, ((0.0, fraction), (fraction, 1.0)))]

    def _to_bezier(self):
        return [Traced(part, places.cut(self.stretches, *ends))
                for part, ends in zip(self.curve.to_bezier(), parameters.spans_of(self.curve), strict=True)]

    def _of(self, result):
        if isinstance(result, sc.Approximation):
            return Near(self._of(result.value), result.error)
        return Traced(result, self.stretches) if isinstance(result, CURVES) else result


def bare(value):
    """What is Traced, or anything else as it is."""
    return value.curve if isinstance(value, Traced) else value
