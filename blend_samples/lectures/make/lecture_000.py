"""Rational curves, chains that are C2, basis functions: the pictures of the first lecture."""

from math import pi, sqrt

from steps import DONE, EDIT, LABELS, NET, Picture, add, call, choose, click, move

#: One span of degree 3, a Bezier curve, with other weights than 1.
_RATIONAL = (add('nurbs_curve', degree=3, count=4), EDIT, choose(1), call('weight_here', weight=2.0), choose(2), call('weight_here', weight=1.5), DONE)
#: About the axis of x, one below the profile.
_VASE = add('revolve', axis='x', offset_y=-1.0, hide_inputs=False)
SIMPLE, MULTIPLE = "0 1 2 3 4 5", "0 0 1 2 2 3 4 4 4"


def _functions(degree, knots, row=0.0, **more):
    return add('functions', family='bspline', degree=degree, knot_values=knots, width=5.0, height=1.0, location=(0.0, -1.6 * row, 0.0), **more)


def _profile(kind, number, **settings):
    """A profile that stands upright: its x goes up, its y away from the axis."""
    return add(kind, location=(4.0 * number, 0.0, 0.0), rotation=(-pi / 2, -pi / 2, 0.0), **settings)


def _merged(count):
    """Six inner knots u1 to u6 of degree 5: so many of u5, u4, u3, u2 lie on u6."""
    inner = [6 if u > 5 - count else u for u in range(1, 6)] + [6]
    return " ".join(map(str, [0] * 6 + inner + [7] * 6))


PICTURES = (
    Picture("000.9", "A homogeneous curve in space, and the rational curve on W = 1 that it stands for", 9,
            (*_RATIONAL, add('lift', cone=16), LABELS), 'SPACE'),
    Picture("000.24", "A rational Bezier curve and its homogeneous one with both polygons", 9,
            (*_RATIONAL, add('lift', cone=0, plane=False), LABELS), 'SPACE'),
    Picture("000.27", "De Casteljau of the homogeneous curve, and the rational algorithm", 12,
            (*_RATIONAL, add('lift', cone=0, plane=False), add('construction', position=0.4, scheme='casteljau'),
             click(0), add('construction', position=0.4, scheme='rational'), LABELS), 'SPACE'),
    Picture("000.49", "The shorter and the longer arc of one circle", 5,
            (add('conic', weight=sqrt(0.5)), add('conic', weight=-sqrt(0.5)), click(0, 1), NET, LABELS)),
    Picture("000.52", "The middle point of a conic goes to infinity", 6,
            (add('bezier_curve', degree=2), EDIT, choose(1), call('point_to_infinity'), DONE, NET)),
    Picture("000.59", "Two cubic Bezier curves joined with C2, with d and the ratios", 10,
            (add('nurbs_curve', degree=3, count=5), EDIT, choose(1), move(0.0, 1.0), choose(2), move(0.0, 0.8), DONE,
             call('set_knots', knots="0 0 0 0 1 3 3 3 3"), add('chain_points', polygons='both', marker=0.02), LABELS)),
    Picture("000.64", "The points d, f, g, e of the construction on the polygon", 4,
            (add('nurbs_curve', degree=3, count=7), call('set_knots', knots="0 0 0 0 1 3 4 5 5 5 5"),
             add('chain_points', polygons='both', marker=0.015), LABELS)),
    Picture("000.72", "Vases whose profiles have one polygon: a Bezier curve, two of them joined, a B-spline", 9,
            (_profile('bezier_curve', 0, degree=6), _VASE, _profile('nurbs_curve', 1, degree=3, count=7),
             call('set_knots', knots="0 0 0 0 1 1 1 2 2 2 2"), _VASE, _profile('nurbs_curve', 2, degree=3, count=7), _VASE, click(0, 2, 4), NET), 'FRONT'),
    Picture("000.81", "Basis functions of degree 0 and 1, simple knots", 3,
            (_functions(0, SIMPLE), _functions(1, SIMPLE, 1), LABELS)),
    Picture("000.82", "Basis functions of degree 2 and 3, simple knots", 3,
            (_functions(2, SIMPLE), _functions(3, SIMPLE, 1), LABELS)),
    Picture("000.83", "Basis functions of degree 0 and 1, multiple knots", 3,
            (_functions(0, MULTIPLE), _functions(1, MULTIPLE, 1), LABELS)),
    Picture("000.84", "Basis functions of degree 2 and 3, multiple knots", 3,
            (_functions(2, MULTIPLE), _functions(3, MULTIPLE, 1), LABELS)),
    Picture("000.85", "The triangular scheme of basis functions", 2,
            (add('triangle', degree=3, knot_values="0 1 2 3 4 5"), LABELS)),
    Picture("000.87", "The functions N01 and N11 on the knots 0, 1, 2, 3", 2,
            (_functions(1, "0 1 2 3"), LABELS)),
    Picture("000.89", "A triangle back to the first column: the support of N13", 2,
            (add('triangle', degree=3, knot_values="0 1 2 3 4 5 6", chosen="1,3", feeding='support'), LABELS)),
    Picture("000.92", "Which functions use a span: a triangle forward", 2,
            (add('triangle', degree=3, knot_values="0 1 2 3 4 5 6 7 8", spans="4"), LABELS)),
    Picture("000.107", "Degree 5: inner knots move onto u6 one after the other", 5,
            tuple(_functions(5, _merged(count), count, resolution_u=48) for count in range(5))),
)
