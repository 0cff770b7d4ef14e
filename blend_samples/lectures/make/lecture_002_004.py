"""Basis functions by hand; parametric curves and surfaces: the pictures of the third and the fifth lecture. The fourth has none of its own."""

from steps import HERMITE, LABELS, NET, Picture, add, call, click, joined, show


def _functions(degree, knots, row=0.0, **more):
    settings = {'width': 5.0, 'height': 1.0, **more}
    return add('functions', family='bspline', degree=degree, knot_values=knots, location=(0.0, -1.6 * row, 0.0), **settings)


PICTURES = (
    Picture("002.5f", "The three step functions on the knots 0, 1, 2, 3", 2, (_functions(0, "0 1 2 3"), LABELS)),
    Picture("002.6", "The triangular scheme: spans, functions of degree 0, 1, 2", 2, (add('triangle', degree=2, knot_values="0 1 2 3"), LABELS)),
    Picture("002.8f", "The functions N01 and N11", 2, (_functions(1, "0 1 2 3"), LABELS)),
    Picture("002.10", "The three pieces of N02 join smoothly; not so on multiple knots", 3,
            (_functions(2, "0 1 2 3"), _functions(2, "0 1 1 3", 1), LABELS)),
    Picture("002.11f", "N13 and all that it depends on", 2,
            (add('triangle', degree=3, knot_values="0 1 2 3 4 5 6 7", chosen="1,3", feeding='support'), LABELS)),
    Picture("002.14f", "The functions of three spans", 2, (add('triangle', degree=3, knot_values="0 1 2 3 4 5 6 7 8", spans="0 2 4"), LABELS)),
    Picture("002.16f", "Both intervals of the coefficients, and their ratios", 2,
            (add('triangle', degree=2, knot_values="0 1 2 3", chosen="0,2", feeding='parents', across=2.0), LABELS)),
    Picture("004.6", "The twisted cubic", 3,
            (add('formula', x="t", y="t^2", z="t^3", start=-1.0, end=1.0),
             add('axes', x_from=-1.0, x_to=1.5, y_from=-0.5, y_to=1.5, z_from=-1.0, z_to=1.5, spatial=True), LABELS), 'SPACE'),
    Picture("004.7", "A helix", 2,
            (add('helix', radius=1.0, end_radius=1.0, height=2.0, turns=3.0),
             add('axes', x_from=-1.0, x_to=1.5, y_from=-1.0, y_to=1.5, z_from=0.0, z_to=2.5, spatial=True)), 'SPACE'),
    Picture("004.10", "The wooden spline of ship builders", 2, (add('ducks', ends=0.4, spacing='chordal', marker=0.04), LABELS)),
    Picture("004.16", "The derivative is the tangent vector", 4,
            (add('bezier_curve', degree=3), show('HODOGRAPH'), add('marks', steps=4, marker=0.02, derivatives=True), click(0))),
    Picture("004.17", "A Hermite segment by two points and two tangents", 6, (*HERMITE, click(0), NET, LABELS)),
    Picture("004.21", "The Hermite basis functions", 2, (add('functions', family='hermite', knot_values="0 1", width=3.0, height=2.0, show='sum'), LABELS)),
    Picture("004.22", "A cubic Bezier curve by four points", 3, (add('bezier_curve', degree=3), NET, LABELS)),
    Picture("004.28", "G1 and C1 compared", 8,
            (add('bezier_curve', degree=3), call('split', where='PARAMETER', parameter_u=0.3), add('bezier_curve', degree=3, location=(3.0, 0.0, 0.0)),
             add('bezier_curve', degree=3, location=(5.0, 0.7, 0.0), rotation=(0.0, 0.0, 0.9)), click(1, 2), call('join_ends', continuity='C1'),
             click(0, 1), NET)),
    Picture("004.29f", "Joints with C0 and with C1", 10, (*joined(0, 'C0'), *joined(1, 'C1'), click(0, 2), NET)),
    Picture("004.30f", "A Bezier patch with its net", 3, (add('bezier_patch'), NET, show('ISOCURVES')), 'SPACE'),
    Picture("004.32", "Newell's teapot, of 32 patches", 2, (add('teapot'), NET), 'SPACE'),
    Picture("004.37", "The four Bernstein polynomials of degree 3, with their sum", 2,
            (add('functions', family='bernstein', degree=3, show='sum', width=3.0, height=2.0), LABELS)),
    Picture("004.38", "A chain of three pieces with C1", 4, (add('bezier_chain', count=4), call('to_bezier'), NET, LABELS)),
    Picture("004.45", "The functions of a uniform cubic, near Gauss's bells", 3,
            (add('formula', x="t", y="3*sqrt(1.5/pi)*exp(-1.5*(t-3)^2)", z="0", start=0.5, end=5.5),
             _functions(3, "0 1 2 3 4 5 6 7", width=7.0, height=3.0), LABELS)),
    Picture("004.47", "Degree 0 on the knots 0 to 5: N00 to N40", 2, (_functions(0, "0 1 2 3 4 5"), LABELS)),
    Picture("004.48", "Degree 1 on the knots 0 to 5: N01 to N31", 2, (_functions(1, "0 1 2 3 4 5"), LABELS)),
    Picture("004.49", "Degree 2 on the knots 0 to 5: N02, N12, N22", 2, (_functions(2, "0 1 2 3 4 5"), LABELS)),
)
