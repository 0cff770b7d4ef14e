"""A patch as the lectures write it: points by rows, matrices of both directions, power basis (S19, S20)."""

from fractions import Fraction

import numpy as np

from ..base.library import sc
from . import exact, spline, triangles, written

#: Segments of which the power basis is written, and the terms that one has at most.
MOST_SEGMENTS, MOST_TERMS = 9, 16
_ONE = exact.Number(Fraction(1))


def parts(patch, position):
    """Lists of lines; position: from 0 to 1, in both directions."""
    if isinstance(patch, sc.HermitePatch):
        across, grid = _of_hermite(patch)
        described = _hermite_nets(patch, across)
    else:
        across, grid = _of_points(patch)
        described = _net(patch, across)
    found = [described, _power(patch, across, grid)]
    at = [way.domain[0] + Fraction(str(position)) * (way.domain[1] - way.domain[0]) for way in across]
    for letter, way, u in zip("uv", across, at):
        found.append([f"Along {letter}:", *_matrices(way, letter)])
        found.append(triangles.basis_lines(way, u, letter) if way.degree <= spline.MATRIX_DEGREE else [])
    return [*found, _steps(patch, across, grid, at)]


def _of_points(patch):
    """(the Splines of u and v, control points as grid[i][j])."""
    grid = [exact.read_rows(*each) for each in zip(patch.homogeneous_points, patch.points, patch.weights)]
    if isinstance(patch, sc.BezierPatch):
        return tuple(map(spline.of_bezier, patch.degree)), grid
    ways = [_way(*each) for each in zip(patch.degree, patch.knots, patch.periodic, patch.points.shape)]
    rows = [grid[i] for i in ways[0][1]]
    return tuple(way for way, _ in ways), [[row[j] for j in ways[1][1]] for row in rows]


def _way(degree, knots, periodic, count):
    """(the Spline of a direction, the numbers of its control points)."""
    if not periodic:
        return spline.of_knots(degree, knots), range(count)
    whole = sc.NurbsCurve(degree, knots, np.zeros((count, 3)), periodic=True).unrolled()
    return spline.of_knots(degree, whole.knots), [i % count for i in range(len(whole.points))]


def _of_hermite(patch):
    """As _of_points(): points and derivatives along v in a row, then derivatives along u and twists."""
    above = [_places(points) + exact.read_vectors(along_v) for points, along_v in zip(patch.points, patch.tangents_v)]
    below = [exact.read_vectors(along_u) + exact.read_vectors(twists) for along_u, twists in zip(patch.tangents_u, patch.twists)]
    ways = tuple(spline.of_hermite(parameters, len(parameters), len(parameters)) for parameters in patch.parameters)
    return ways, above + below


def _places(points):
    return [[*map(exact.read, point), _ONE] for point in points]


def _net(patch, across):
    u, v = across
    size = patch.points.shape[:2]
    lines = [f"{u.kind} patch of degree {u.degree} x {v.degree}, {size[0]} x {size[1]} control points"]
    if u.kind == 'NURBS':
        periodic = [", periodic" if each else "" for each in patch.periodic]
        lines += [f"Knots of {letter}{more}: " + " ".join(written.number(exact.read(knot), way.allowed) for knot in knots)
                  for letter, way, knots, more in zip("uv", across, patch.knots, periodic)]
    lines.append("Control points P_i,j (x, y, z)" + (" and weights" if patch.is_rational else "") + ", i along u, by rows of j along v:")
    return lines + _rows("P", patch.points, patch.weights if patch.is_rational else None)


def _hermite_nets(patch, across):
    size = patch.points.shape[:2]
    lines = [f"Hermite patch of degree 3 x 3, {size[0]} x {size[1]} points"]
    lines += [f"Parameters of {letter}: " + " ".join(written.number(each, way.allowed) for each in way.knots)
              for letter, way in zip("uv", across)]
    nets = (("P", "Points", patch.points), ("U", "Derivatives along u", patch.tangents_u),
            ("V", "Derivatives along v", patch.tangents_v), ("T", "Twists", patch.twists))
    return lines + [line for letter, name, net in nets for line in (f"{name} {letter}_i,j, i along u, by rows of j along v:", *_rows(letter, net))]


def _rows(letter, net, weights=None):
    allowed = written.allowed_for(net)

    def one(i, j):
        weight = "" if weights is None else f" w = {written.number(exact.read(weights[i, j]))}"
        infinite = "  (at infinity)" if weights is not None and weights[i, j] == 0 else ""
        return f"{letter}{i},{j} {written.vector(map(exact.read, net[i, j]), allowed)}{weight}{infinite}"
    return ["  " + "   ".join(one(i, j) for j in range(net.shape[1])) for i in range(net.shape[0])]


def _matrices(way, letter):
    return spline.matrix_lines(way, letter, lambda indices: f"rows {indices[0]} to {indices[-1]}")


def _steps(patch, across, grid, at):
    """Lecture row S20: the algorithm of curves along u in each row of points, then along v on what these give."""
    if across[0].kind == 'Hermite':
        return []
    name = "de Casteljau's" if across[0].kind == 'Bezier' else "de Boor's"
    if max(way.degree for way in across) > spline.MATRIX_DEGREE:
        return [f"{name} algorithm is written up to degree {spline.MATRIX_DEGREE}"]
    (u_way, v_way), (u, v), (count, row_count) = across, at, patch.points.shape[:2]
    allowed = written.allowed_for(patch.points)
    u_text, v_text = (written.number(place, way.allowed) for place, way in zip(at, across))
    lines = [f"{name} algorithm at u = {u_text}, v = {v_text}, along u in each row j of points that acts there, then along v: {triangles.STEPS}:"]
    span, found = exact.span_of(v_way.degree, v_way.knots, v), {}
    for j in range(span - v_way.degree, span + 1):
        levels = exact.de_boor(u_way.degree, u_way.knots, [row[j] for row in grid], u)
        found[j] = levels[-1][0].row
        row = j % row_count
        lines += [f"  row {row}, which gives Q{row}:", *triangles.step_lines(levels, lambda i, row=row: f"P{i % count},{row}", allowed, "    ")]
    levels = exact.de_boor(v_way.degree, v_way.knots, found, v)
    return [*lines, "  along v, of these:", *triangles.step_lines(levels, lambda j: f"Q{j % row_count}", allowed, "    ")]


def _power(patch, across, grid):
    u, v = across
    terms, pairs = (u.degree + 1) * (v.degree + 1), [(a, b) for a in u.segments for b in v.segments]
    if terms > MOST_TERMS:
        return [f"The power basis is written for at most {MOST_TERMS} terms: here are {terms}"]

    def part(a, b):
        return lambda: _segment(across, a, b, grid, patch.is_rational)
    return ["Power basis, segment by segment:", *written.listed([part(*pair) for pair in pairs], MOST_SEGMENTS, "segments")]


def _segment(across, a, b, grid, is_rational):
    (s, where_s), (t, where_t) = (written.from_start(name, local, each.start, way.allowed)
                                  for name, local, each, way in zip("uv", "st", (a, b), across))
    meant = " and ".join(filter(None, (where_s, where_t)))
    lines = [f"  on {across[0].on(a)} x {across[1].on(b)}{', with ' + meant if meant else ''}"]
    order = [(k, m) for k in range(len(a.matrix)) for m in range(len(b.matrix))]
    scales = [a.length ** k * b.length ** m for k, m in order]
    for name, rows in zip("XYZW" if is_rational else "xyz", exact.patch_coefficients(a, b, grid)):
        numbers = [rows[k][m] for k, m in order]
        allowed = 0.0 if is_rational else written.share_of(numbers, scales)
        texts = written.numbers(numbers, [allowed / float(scale) for scale in scales])
        names = (" ".join(filter(None, (written.power(s, k), written.power(t, m)))) for k, m in order)
        lines.append(f"    {name} = {written.summed(zip(texts, names))}")
    return lines
