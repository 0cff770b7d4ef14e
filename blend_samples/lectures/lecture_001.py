"""Curves by formulas, Hermite, Bezier and uniform B-splines: the pictures of the second lecture."""

from math import pi

from steps import DONE, EDIT, HERMITE, KNOTS, LABELS, NET, Picture, add, bent, call, choose, click, joined, show, together

_UNIFORM = "0 1 2 3 4 5 6 7"


def _graph(x, y, start, end):
    return add('formula', x=x, y=y, z="0", start=start, end=end)


def _axes(x, y):
    return add('axes', x_from=x[0], x_to=x[1], y_from=y[0], y_to=y[1])


def _family(factor):
    """A Hermite segment from (0, 0) to (3, 0) whose tangent at the start is (factor, 2 factor), at the end (2, -2)."""
    return add('formula', x="3*(3*t^2-2*t^3)+k*(t^3-2*t^2+t)+2*(t^3-t^2)", y="2*k*(t^3-2*t^2+t)-2*(t^3-t^2)", z="0", start=0.0, end=1.0,
               constants=f"k = {factor}")


def _level(level):
    return add('bezier_curve', degree=3), add('construction', position=0.5, scheme='casteljau', first_level=0, last_level=level), LABELS


def _teapot(x, steps, is_flat):
    return (add('teapot', resolution_u=steps, resolution_v=steps, location=(x, 0.0, 0.0)),
            call('object.shade_flat' if is_flat else 'object.shade_smooth'))


PICTURES = (
    Picture("001.1", "One model as 1,000 and as 10,000 faces, each flat and smooth", 8,
            (*_teapot(0.0, 6, True), *_teapot(3.6, 6, False), *_teapot(7.2, 18, True), *_teapot(10.8, 18, False)), 'FRONT'),
    Picture("001.2", "A parametric curve", 1, (_graph("cos(3*t)", "sin(2*t)", 0.0, 2 * pi),)),
    Picture("001.6", "Interpolation is forced, and oscillates", 2,
            (add('polynomial', count=11, parametrisation='uniform', spline=True), add('axes', x_from=-1.0, x_to=1.0, y_from=0.0, y_to=2.0))),
    Picture("001.15", "The graph of y = 2x", 3, (_graph("t", "2*t", -1.0, 1.5), _axes((-2.0, 2.0), (-2.0, 3.0)), LABELS)),
    Picture("001.16", "The graph of y = sin x", 3, (_graph("t", "sin(t)", 0.0, 2 * pi), _axes((-1.0, 7.0), (-2.0, 2.0)), LABELS)),
    Picture("001.20", "An implicit line and an implicit circle", 4,
            (add('equation', a=0.0, b=0.0, c=0.0, d=1.0, e=2.0, f=-1.0), add('equation', a=1.0, b=0.0, c=1.0, d=0.0, e=0.0, f=-4.0),
             _axes((-3.0, 3.0), (-3.0, 3.0)), LABELS)),
    Picture("001.26", "The tangent of a smooth curve, and both tangents at a corner", 8,
            (add('nurbs_curve', degree=3, count=7), call('set_knots', knots="0 0 0 0 1 1 1 2 2 2 2"), *bent(3, 0.0, 0.6),
             add('marks', steps=0, tangents=True, derivatives=True), LABELS)),
    Picture("001.29", "Curves joined with G0, G1 and G2, with combs", 14,
            (*joined(0, 'C0'), *joined(1, 'G1'), *joined(2, 'C2'), click(0, 2, 4), show('COMB'))),
    Picture("001.38", "Ducks hold a strip, which draws a curve", 2, (add('ducks', ends=0.3, marker=0.04), LABELS)),
    Picture("001.40", "A Hermite curve", 4, (*HERMITE, LABELS)),
    Picture("001.43", "What a Hermite segment is given by: two points and two tangents", 6, (*HERMITE, click(0, 1), LABELS, NET)),
    Picture("001.49", "The four Hermite functions", 2,
            (add('functions', family='hermite', knot_values="0 1", width=3.0, height=2.0), LABELS)),
    Picture("001.50", "Hermite curves whose first tangent grows", 4, tuple(map(_family, (1, 3, 6, 10)))),
    Picture("001.51", "Two Hermite cubics with tangents of one direction and other lengths", 5,
            (add('bezier_curve', degree=3), call('split', where='PARAMETER', parameter_u=0.3), call('to_hermite'),
             add('marks', steps=0, marker=0.02, derivatives=True), LABELS)),
    Picture("001.57", "The blending functions of Bezier: positive, with the sum 1", 2,
            (add('functions', family='bernstein', degree=3, show='sum', width=3.0, height=2.0), LABELS)),
    Picture("001.60", "A Bezier curve", 3, (add('bezier_curve', degree=3), NET, LABELS)),
    Picture("001.61", "Pieces: the points beside a joint lie on one line with it", 4,
            (add('bezier_chain', count=3), call('to_bezier'), NET, LABELS)),
    Picture("001.62", "A Bezier curve of degree 5", 3, (add('bezier_curve', degree=5), NET, LABELS)),
    Picture("001.63", "Cubics of the same four points in other orders", 3, (add('bezier_curve', degree=3), add('orders', columns=4, polygons=True), LABELS)),
    Picture("001.64", "Bezier curves of three, four and five points", 5,
            (*(add('bezier_curve', degree=degree, location=(2.6 * i, 0.0, 0.0)) for i, degree in enumerate((2, 3, 4))), click(0, 1, 2), NET)),
    Picture("001.65a", "De Casteljau, the first step: M01, M12, M23", 3, _level(1)),
    Picture("001.65b", "De Casteljau, the second step: M012, M123", 3, _level(2)),
    Picture("001.65c", "De Casteljau, the third step: M0123", 3, _level(3)),
    Picture("001.65d", "Repeated halving makes the polygon smooth", 2,
            (add('bezier_curve', degree=3), add('halving', steps=3, distance=2.4))),
    Picture("001.66", "Hermite and Bezier compared", 7,
            (add('bezier_curve', degree=3), add('bezier_curve', degree=3, location=(2.8, 0.0, 0.0)), call('to_hermite'),
             add('marks', steps=0, marker=0.02, derivatives=True), click(0, 1), NET, LABELS)),
    Picture("001.68", "A B-spline of four points out of a sequence touches none of them", 3,
            (add('nurbs_curve', degree=3, count=4, knots='UNCLAMPED'), NET, LABELS)),
    Picture("001.71", "Uniform B-spline functions", 2,
            (add('functions', family='bspline', degree=3, knot_values="0 1 2 3 4 5 6 7 8 9", width=6.0, height=2.0), LABELS)),
    Picture("001.72", "The curve begins where four functions are active", 2,
            (add('functions', family='bspline', degree=3, knot_values=_UNIFORM, show='sum', domain=True, width=6.0, height=2.0), LABELS)),
    Picture("001.75", "The first span, its four points and their hull", 5,
            (add('nurbs_curve', degree=3, count=4, knots='UNCLAMPED'), add('hulls', show='hulls'), click(0), NET, LABELS)),
    Picture("001.76", "Two spans and both hulls; the joint lies in what they have in common", 5,
            (add('nurbs_curve', degree=3, count=5, knots='UNCLAMPED'), add('hulls', show='both'), click(0), KNOTS, LABELS)),
    Picture("001.77", "A doubled control point: hulls meet in a line", 9,
            (add('nurbs_curve', degree=3, count=6, knots='UNCLAMPED'), EDIT, choose(1, 2), together(), DONE, add('hulls', show='both'), click(0), KNOTS, LABELS)),
    Picture("001.78", "A tripled control point: hulls become segments, and a corner", 9,
            (add('nurbs_curve', degree=3, count=7, knots='UNCLAMPED'), EDIT, choose(1, 2, 3), together(), DONE, add('hulls', show='both'), click(0), KNOTS, LABELS)),
    Picture("001.79", "The basis of a cubic B-spline", 2,
            (add('functions', family='bspline', degree=3, knot_values="0 1 2 3 4", width=4.0, height=3.0), LABELS)),
    Picture("001.81", "One curve as B-spline and as Bezier curves with both polygons", 3,
            (add('nurbs_curve', degree=3, count=6), add('chain_points', polygons='both', marker=0.02), LABELS)),
)
