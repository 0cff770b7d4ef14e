"""Where a curve or patch lies on the one it came of, in parts of their domains."""

from typing import NamedTuple


class Stretch(NamedTuple):
    """What lies from `start` to `end` along an axis of a patch lies from `first` to `last` along that of another,
    whose speed a Moebius map changed."""

    start: float = 0.0
    end: float = 1.0
    first: float = 0.0
    last: float = 1.0
    rho: float = 1.0

    def of(self, fractions):
        """Where these parts of the former axis lie on the latter."""
        linear = self.first + (fractions - self.start) / (self.end - self.start) * (self.last - self.first)
        return linear / (self.rho * (1 - linear) + linear)


#: Stretches of an axis that stays as it was.
WHOLE = (Stretch(),)


class Place(NamedTuple):
    """Stretches along u and v of the patch that a new one came of; whether they are v and u of the new one."""

    u: tuple = WHOLE
    v: tuple = WHOLE
    is_swapped: bool = False


class Origin(NamedTuple):
    """What a curve, or a part of one, came of: the number of a piece, counted from 0, and stretches of it."""

    piece: int
    stretches: tuple = WHOLE


def cut(stretches, start, end):
    """Of an axis from `start` to `end`."""
    parts = []
    for stretch in stretches:
        first, last = max(stretch.first, start), min(stretch.last, end)
        if first < last:
            speed = (stretch.end - stretch.start) / (stretch.last - stretch.first)
            parts.append(Stretch(stretch.start + (first - stretch.first) * speed,
                                 stretch.start + (last - stretch.first) * speed,
                                 (first - start) / (end - start), (last - start) / (end - start)))
    return tuple(parts)


def opened(stretches, at):
    """Of a closed axis that begins and ends at `at`."""
    after = (part._replace(first=part.first * (1 - at), last=part.last * (1 - at)) for part in cut(stretches, at, 1.0))
    before = (part._replace(first=1 - at + part.first * at, last=1 - at + part.last * at)
              for part in cut(stretches, 0.0, at))
    return (*after, *before)


def reversed_(stretches):
    return tuple(part._replace(first=1 - part.first, last=1 - part.last) for part in stretches)


def sped(stretches, rho):
    return tuple(part._replace(rho=rho) for part in stretches)


def squeezed(stretches, first, last):
    """Of an axis that became the part of another from `first` to `last`."""
    return tuple(part._replace(first=first + part.first * (last - first), last=first + part.last * (last - first))
                 for part in stretches)
