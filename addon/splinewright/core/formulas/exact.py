"""Splines in fractions (S4, S6, S13 to S15): matrices, coefficients and points without rounding.

Numbers of a shape are taken as known within four units in the last place, and every result has a bound of what results from that.
"""

from fractions import Fraction
from math import comb
from typing import NamedTuple

import numpy as np

#: Parts of a number of a shape within which it is known.
_KNOWN = 4 * float(np.finfo(np.float64).eps)
#: The largest denominator of a fraction that a number of a shape is read as.
_DENOMINATOR = 1000
#: Of the denominators of fractions that are worked with level by level.
_MOST_BITS = 400


class Number(NamedTuple):
    """A fraction, and within what it is known."""

    value: Fraction
    error: float = 0.0

    def __mul__(self, other):
        error = self.error * abs(float(other.value)) + other.error * abs(float(self.value))
        return Number(self.value * other.value, error)

    def __truediv__(self, other):
        """By a number that is not zero within its error."""
        value, divisor = self.value / other.value, abs(float(other.value))
        return Number(value, (self.error + abs(float(value)) * other.error) / divisor)

    @property
    def is_zero(self):
        return abs(self.value) <= self.error


class Segment(NamedTuple):
    """What makes polynomials of control points between two knots: row k of `matrix` gives the coefficient of t^k, t from 0 to 1."""

    start: Fraction
    end: Fraction
    indices: tuple                      # of the control points, as the columns of the matrix
    matrix: tuple                       # of rows of Fraction
    bounds: tuple                       # the same for float: the matrix as if all terms had one sign
    known: float                        # parts of the bounds within which the matrix is known

    @property
    def length(self):
        return self.end - self.start


def read(number):
    """The Number that a float64 is meant as: a fraction of small denominator where one is as near as it is known."""
    number = float(number)
    exact = Fraction(number)
    simple = exact.limit_denominator(_DENOMINATOR)
    is_meant = abs(simple - exact) <= _KNOWN * abs(exact)
    return Number(simple if is_meant else Fraction(repr(number)), _KNOWN * abs(number))


def read_rows(homogeneous, points, weights):
    """[[X, Y, Z, W]] of Number of control points, in the order of rows. homogeneous: what counts where a weight is 0."""
    def row(direction, point, weight):
        if weight == 0.0:
            return [*map(read, direction[:3]), Number(Fraction(0))]
        w = read(weight)
        return [*(read(x) * w for x in point), w if weight != 1.0 else Number(Fraction(1))]
    return [row(*each) for each in zip(homogeneous, points, weights)]


def read_vectors(vectors):
    """[[X, Y, Z, 0]] of Number of vectors (n, 3)."""
    return [[*map(read, vector), Number(Fraction(0))] for vector in vectors]


def read_knots(knots):
    """Fractions that do not decrease, and parts of the largest within which they are known: 0 where all are simple ones."""
    found = [read(knot).value for knot in knots]
    is_simple = all(knot.denominator <= _DENOMINATOR for knot in found)
    for i in range(1, len(found)):
        found[i] = max(found[i], found[i - 1])
    return found, 0.0 if is_simple else _KNOWN


def combined(coefficients, bounds, known, numbers):
    """The sum of Numbers times Fractions that are known within parts of bounds."""
    value = sum((c * number.value for c, number in zip(coefficients, numbers) if c and number.value), Fraction(0))
    error = sum(bound * (number.error + known * abs(float(number.value))) for bound, number in zip(bounds, numbers))
    return Number(value, error)


def segments(degree, knots, known=0.0):
    """The Segments of a B-spline on its domain, those without length left out. knots: as read_knots() gives them."""
    found = []
    for span in range(degree, len(knots) - degree - 1):
        if knots[span] < knots[span + 1]:
            near = knots[max(span - degree + 1, 0):span + degree + 1]
            gap = min(b - a for a, b in zip(near, near[1:]) if a < b)
            share = 2 * degree * known * float(max(map(abs, near)) / gap)
            indices = tuple(range(span - degree, span + 1))
            matrix, bounds = _polynomials(degree, knots, span, float if known else Fraction)
            found.append(Segment(knots[span], knots[span + 1], indices, matrix, bounds, share))
    return found


def _polynomials(degree, knots, span, kind):
    """The matrix and the bounds of one span, by the recursion of Cox and de Boor on coefficients, in numbers of a kind."""
    start, length = knots[span], knots[span + 1] - knots[span]
    values, bounds = [[kind(1)]], [[1.0]]
    for level in range(1, degree + 1):
        columns, limits = [], []
        for i in range(span - level, span + 1):
            value, bound = [kind(0)] * (level + 1), [0.0] * (level + 1)
            for at, sign in ((i, 1), (i + 1, -1)):
                place = at - (span - level + 1)
                if 0 <= place < level:
                    width = knots[at + level] - knots[at]
                    ahead, slope = kind((start - knots[at] if sign > 0 else knots[at + level] - start) / width), kind(length / width)
                    _add_product(value, values[place], ahead, sign * slope)
                    _add_product(bound, bounds[place], float(ahead), float(slope))
            columns.append(value)
            limits.append(bound)
        values, bounds = columns, limits
    return tuple(tuple(map(Fraction, row)) for row in zip(*values)), tuple(zip(*bounds))


def _add_product(found, polynomial, constant, slope):
    for k, coefficient in enumerate(polynomial):
        found[k] += constant * coefficient
        found[k + 1] += slope * coefficient


#: Row k gives the coefficient of t^k of P, R, P, R: points and derivatives at both ends of a segment.
HERMITE = ((1, 0, 0, 0), (0, 1, 0, 0), (-3, -2, 3, -1), (2, 1, -2, 1))


def hermite_segments(parameters, outgoing, incoming, known=0.0):
    """The Segments of a Hermite chain. outgoing, incoming: the numbers of the first control points that are derivatives."""
    found = []
    for i, (start, end) in enumerate(zip(parameters, parameters[1:])):
        length = end - start
        scale = (Fraction(1), length, Fraction(1), length)
        matrix = tuple(tuple(value * factor for value, factor in zip(row, scale)) for row in HERMITE)
        share = 2 * known * float(max(abs(start), abs(end)) / length)
        indices = (i, outgoing + i, i + 1, incoming + i + 1)
        found.append(Segment(start, end, indices, matrix, tuple(tuple(abs(float(v)) for v in row) for row in matrix), share))
    return found


def coefficients(segment, rows):
    """[[Number]]: for each axis of control points those of 1, s, s^2, …, with s from the start of the segment."""
    used = [rows[i] for i in segment.indices]
    return [[_per(combined(row, bound, segment.known, axis), segment.length ** k)
             for k, (row, bound) in enumerate(zip(segment.matrix, segment.bounds))] for axis in zip(*used)]


def _per(number, divisor):
    return Number(number.value / divisor, number.error / float(divisor))


def patch_coefficients(u, v, grid):
    """[[[Number]]]: for each axis those of s^k t^l, of a patch between knots. grid: grid[i][j] is a control point."""
    def rows(axis):
        across = [[grid[i][j][axis] for i in u.indices] for j in v.indices]
        along = [[combined(row, bound, u.known, line) for line in across] for row, bound in zip(u.matrix, u.bounds)]
        return [[_per(combined(row, bound, v.known, line), u.length ** k * v.length ** m)
                 for m, (row, bound) in enumerate(zip(v.matrix, v.bounds))] for k, line in enumerate(along)]
    return [rows(axis) for axis in range(4)]


def bezier_matrix(degree):
    """As Segment.matrix: that of Bernstein's polynomials."""
    ends = [Fraction(0)] * (degree + 1) + [Fraction(1)] * (degree + 1)
    return segments(degree, ends)[0].matrix


def to_bezier(matrix):
    """The matrix that gives the Bezier points of a segment whose matrix this is; of bounds the bounds of that."""
    degree, number = len(matrix) - 1, type(matrix[0][0])
    return tuple(tuple(sum(number(Fraction(comb(i, k), comb(degree, k))) * matrix[k][j] for k in range(i + 1)) for j in range(degree + 1))
                 for i in range(degree + 1))


def bezier_points(segment, rows):
    """[[Number]]: the homogeneous Bezier points of a segment."""
    used = [rows[i] for i in segment.indices]
    return [[combined(row, bound, segment.known, axis) for axis in zip(*used)]
            for row, bound in zip(to_bezier(segment.matrix), to_bezier(segment.bounds))]


def between(one, other, ratio):
    """(1 - ratio) one + ratio other of rows of Number; ratio: from 0 to 1."""
    part = float(ratio)
    return [_short(Number((1 - ratio) * a.value + ratio * b.value, (1 - part) * a.error + part * b.error)) for a, b in zip(one, other)]


def _short(number):
    """The Number; with a float64 in place of a fraction that would be long to work with."""
    if number.value.denominator.bit_length() <= _MOST_BITS:
        return number
    return Number(Fraction(float(number.value)), number.error + _KNOWN * abs(float(number.value)))


def casteljau(rows, t):
    """[[[Number]]]: the levels of de Casteljau, from the control points on."""
    levels = [rows]
    while len(levels[-1]) > 1:
        levels.append([between(a, b, t) for a, b in zip(levels[-1], levels[-1][1:])])
    return levels


class Step(NamedTuple):
    """A point of de Boor's algorithm."""

    number: int                         # of the control point that it comes of
    ratio: Fraction                     # of its two points before; None for a control point
    row: list


def de_boor(degree, knots, rows, u):
    """[[Step]]: the levels of de Boor's algorithm at u."""
    span = span_of(degree, knots, u)
    levels = [[Step(i, None, rows[i]) for i in range(span - degree, span + 1)]]
    for level in range(1, degree + 1):
        before = levels[-1]
        levels.append([])
        for one, other in zip(before, before[1:]):
            i = other.number
            ratio = (u - knots[i]) / (knots[i + degree - level + 1] - knots[i])
            levels[-1].append(Step(i, ratio, between(one.row, other.row, ratio)))
    return levels


class Function(NamedTuple):
    """A basis function at a parameter: value = left N_i,p-1 + right N_i+1,p-1."""

    number: int
    value: Fraction
    left: Fraction
    right: Fraction


def basis(degree, knots, u):
    """[[Function]]: by degree, from 0 on, those that do not vanish in the span of u. 0/0 counts as 0."""
    span = span_of(degree, knots, u)
    levels = [[Function(span, Fraction(1), Fraction(0), Fraction(0))]]
    for level in range(1, degree + 1):
        below = {function.number: function.value for function in levels[-1]}
        levels.append([])
        for i in range(span - level, span + 1):
            left = _ratio(u - knots[i], knots[i + level] - knots[i])
            right = _ratio(knots[i + level + 1] - u, knots[i + level + 1] - knots[i + 1])
            value = _short(Number(left * below.get(i, 0) + right * below.get(i + 1, 0))).value
            levels[-1].append(Function(i, value, left, right))
    return levels


def _ratio(part, whole):
    return part / whole if whole else Fraction(0)


def span_of(degree, knots, u):
    """The number of the knot that begins the span of a parameter of the domain; of its end, that of the last span."""
    last = len(knots) - degree - 1
    return max(i for i in range(degree, last) if knots[i] < knots[i + 1] and (knots[i] <= u or i == degree))
