"""Curves as verbs see them, with where they lie on the curve that a verb was asked to change."""

from typing import NamedTuple

from ..base.library import sc
from . import parameters, places
from .definition import CURVES


class Near(NamedTuple):
    """A curve or patch that stands for another, as splinecore's Approximation."""

    value: object
    error: float


class Traced:
    """A curve with its methods, whose results are Traced, too. stretches: of core.shape.places."""

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

    def _extended(self, *arguments):
        return self._longer(self.curve.extended(*arguments))

    def _extended_to(self, *arguments, **settings):
        return self._longer(self.curve.extended_to(*arguments, **settings))

    def _parts(self, *arguments):
        return [self._part(part) for part in self.curve.parts(*arguments)]

    def _trimmed(self, *arguments, **settings):
        return [self._part(part) for part in self.curve.trimmed(*arguments, **settings)]

    def _longer(self, made):
        """A curve that continues by the same parameter."""
        (start, end), (first, last) = self.curve.domain, made.domain
        return Traced(made, places.squeezed(self.stretches, (start - first) / (last - first), (end - first) / (last - first)))

    def _part(self, made):
        """A part over its part of the domain, or of a closed curve over the seam."""
        start, end = self.curve.domain
        first, last = ((u - start) / (end - start) for u in made.domain)
        if last > 1:
            return Traced(made, places.cut(places.opened(self.stretches, first), 0.0, last - first))
        return Traced(made, places.cut(self.stretches, first, last))

    def _to_bezier(self):
        return [Traced(part, places.cut(self.stretches, *ends))
                for part, ends in zip(self.curve.to_bezier(), parameters.spans_of(self.curve), strict=True)]

    def _of(self, result):
        if isinstance(result, sc.Approximation):
            return Near(self._of(result.value), result.error)
        return Traced(result, self.stretches) if isinstance(result, CURVES) else result


def bare(value):
    """The value of a Traced, or anything else as it is."""
    return value.curve if isinstance(value, Traced) else value
