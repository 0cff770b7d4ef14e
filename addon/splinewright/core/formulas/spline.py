"""A curve, or a direction of a patch, as formulas take it: its segments in fractions."""

from fractions import Fraction
from typing import NamedTuple

from ..base.library import sc
from . import exact, written

#: Different matrices that are written, and the highest degree of one.
MOST_MATRICES, MATRIX_DEGREE = 10, 9


class Spline(NamedTuple):
    """Polynomials of control points, between knots."""

    kind: str                           # 'Bezier', 'Hermite' or 'NURBS'
    degree: int
    knots: list                         # of Fraction; of Hermite chains the parameters
    segments: list                      # of exact.Segment

    @property
    def allowed(self):
        """What knots as decimals may differ by."""
        return 1e-11 * min(float(segment.length) for segment in self.segments)

    @property
    def letter(self):
        """What its parameter is called."""
        return "t" if self.kind == 'Bezier' else "u"

    @property
    def domain(self):
        return self.segments[0].start, self.segments[-1].end

    def segment_at(self, u):
        """Of the end, the last one."""
        return max((each for each in self.segments if each.start <= u), key=lambda each: each.start, default=self.segments[0])

    def on(self, segment):
        return written.interval(segment.start, segment.end, self.allowed)


def of_bezier(degree):
    knots = [Fraction(0)] * (degree + 1) + [Fraction(1)] * (degree + 1)
    return Spline('Bezier', degree, knots, exact.segments(degree, knots))


def of_hermite(parameters, outgoing, incoming):
    """outgoing, incoming: as exact.hermite_segments()"""
    knots, known = exact.read_knots(parameters)
    return Spline('Hermite', 3, knots, exact.hermite_segments(knots, outgoing, incoming, known))


def of_knots(degree, knots):
    knots, known = exact.read_knots(knots)
    return Spline('NURBS', degree, knots, exact.segments(degree, knots, known))


def of_curve(curve):
    """(the Spline of a curve, its control points as rows of exact.Number)."""
    if isinstance(curve, sc.HermiteCurve):
        count, (incoming, outgoing) = len(curve.points), (curve.tangents[:, 0], curve.tangents[:, 1])
        rows = [[*map(exact.read, point), exact.Number(Fraction(1))] for point in curve.points]
        rows += exact.read_vectors(incoming) + exact.read_vectors(outgoing)
        return of_hermite(curve.parameters, 2 * count, count), rows
    if isinstance(curve, sc.BezierCurve):
        return of_bezier(curve.degree), _rows(curve)
    whole = curve.unrolled() if curve.periodic else curve
    return of_knots(curve.degree, whole.knots), _rows(whole)


def _rows(curve):
    return exact.read_rows(curve.homogeneous_points, curve.points, curve.weights)


def matrix_lines(spline, letter, of_points):
    """Lecture rows S4, S6 and S13: matrices by which the control points of a segment become coefficients of powers of t.

    letter: of the parameter. of_points: (indices) -> what the control points of a segment are called.
    """
    powers = written.powers(spline.degree)
    if spline.kind == 'Hermite':
        return [f"Hermite matrix M_H of a segment: {powers} M_H [P R P R], of its start and its end the point P and the derivative R times",
                "the length of the segment; t from 0 to 1 in it:", *written.matrix(exact.HERMITE[::-1], "  ")]
    if spline.degree > MATRIX_DEGREE:
        return [f"Matrices are written up to degree {MATRIX_DEGREE}: this is degree {spline.degree}"]
    by_matrix = {}
    for segment in spline.segments:
        by_matrix.setdefault(segment.matrix, []).append(segment)
    parts = [_of_matrix(spline, matrix, those, of_points) for matrix, those in by_matrix.items()]
    meant = "t from 0 to 1" if spline.kind == 'Bezier' else f"t = ({letter} - start) / (end - start)"
    head = f"Matrices M of segments: {powers} M [control points], with {meant}:"
    return [head, *written.listed(parts, MOST_MATRICES, "matrices")]


def _of_matrix(spline, matrix, those, of_points):
    def lines():
        name = _name_of(spline.degree, matrix)
        places = ", ".join(f"{spline.on(segment)} of {of_points(segment.indices)}" for segment in those)
        bounds, known = those[0].bounds, those[0].known
        found = [f"  {name} matrix on {places}:", *written.matrix(matrix[::-1], "    ", _times(bounds[::-1], known))]
        if name == "Bezier":
            return found
        return [*found, "  and the matrix of its Bezier points, of the same control points:",
                *written.matrix(exact.to_bezier(matrix), "    ", _times(exact.to_bezier(bounds), known))]
    return lines


def _times(rows, factor):
    return [[value * factor for value in row] for row in rows]


def _name_of(degree, matrix):
    if matrix == exact.bezier_matrix(degree):
        return "Bezier"
    uniform = exact.segments(degree, list(map(Fraction, range(2 * degree + 2))))[0].matrix
    return "uniform B-spline" if matrix == uniform else "B-spline"
