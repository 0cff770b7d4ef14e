"""What the kept rows should be, in exact arithmetic, and how far they are from it."""

from fractions import Fraction
from itertools import combinations
from math import comb, factorial, isqrt

import numpy as np

import workloads

exactly = np.vectorize(Fraction, otypes=[object])


def span_of(knots, degree, u):
    """The index of the knot before u; the end of the domain belongs to the last span."""
    span = degree
    while span < len(knots) - degree - 2 and u >= knots[span + 1]:
        span += 1
    return span


def basis(knots, degree, u, order):
    """(span, series): the functions that are not zero about u, each as its Taylor coefficients up to order."""
    span, number = span_of(knots, degree, u), type(u)
    series = [[number(1)] + [number(0)] * order]
    for k in range(1, degree + 1):
        following = [[number(0)] * (order + 1) for _ in range(k + 1)]
        for r, values in enumerate(series):
            low, high = knots[span - k + 1 + r], knots[span + 1 + r]
            rise = times_line(values, (u - low) / (high - low), 1 / (high - low))
            following[r + 1] = [a + b for a, b in zip(following[r + 1], rise, strict=True)]
            following[r] = [a + b - c for a, b, c in zip(following[r], values, rise, strict=True)]
        series = following
    return span, series


def times_line(series, constant, slope):
    return [constant * value + (slope * series[i - 1] if i else 0) for i, value in enumerate(series)]


def homogeneous(rows):
    rows = exactly(rows)
    return np.concatenate([rows[..., :3] * rows[..., 3:], rows[..., 3:]], -1)


def quotient_series(series):
    """Of points x, y, z from series of homogeneous ones."""
    result = []
    for k, row in enumerate(series):
        lower = sum((series[j][3] * result[k - j] for j in range(1, k + 1)), np.array([Fraction(0)] * 3))
        result.append((row[:3] - lower) / series[0][3])
    return result


def curve_rows(knots, points, parameters, order, degree=3):
    """Points and derivatives up to order of a rational curve, one row a parameter."""
    knots, points, rows = [Fraction(u) for u in knots], homogeneous(points), []
    for u in parameters:
        span, series = basis(knots, degree, Fraction(u), order)
        sums = [sum(series[i][k] * points[span - degree + i] for i in range(degree + 1)) for k in range(order + 1)]
        rows.append(np.concatenate([factorial(k) * row for k, row in enumerate(quotient_series(sums))]))
    return np.array(rows)


def surface_rows(knots_u, knots_v, points, pairs):
    """Point, derivative along u, along v of a rational bicubic surface, one row a pair."""
    knots_u, knots_v = ([Fraction(u) for u in knots] for knots in (knots_u, knots_v))
    points, rows = homogeneous(points), []
    for u, v in pairs:
        i, along_u = basis(knots_u, 3, Fraction(u), 1)
        j, along_v = basis(knots_v, 3, Fraction(v), 1)
        net = points[i - 3:i + 1, j - 3:j + 1]

        def total(k, l):
            return sum(along_u[a][k] * along_v[b][l] * net[a, b] for a in range(4) for b in range(4))

        point, slope_u = quotient_series([total(0, 0), total(1, 0)])
        _, slope_v = quotient_series([total(0, 0), total(0, 1)])
        rows.append(np.concatenate([point, slope_u, slope_v]))
    return np.array(rows)


def with_normals(rows):
    """Point and unit normal from rows of point and derivatives; a zero normal where there is none."""
    normals = np.cross(rows[:, 3:6], rows[:, 6:9])
    for i, normal in enumerate(normals):
        square = sum(normal * normal)
        normals[i] = normal / root(square) if square else normal
    return np.concatenate([rows[:, :3], normals], 1)


def root(square, bits=80):
    """The square root of a fraction to many more digits than a double has."""
    scale = 1 << (2 * bits + 2 * max(0, square.denominator.bit_length() - square.numerator.bit_length()))
    return Fraction(isqrt(square.numerator * scale // square.denominator), isqrt(scale))


def bezier_rows(points, parameters):
    points, degree, rows = exactly(points), len(points) - 1, []
    for u in map(Fraction, parameters):
        rows.append(sum(comb(degree, i) * u**i * (1 - u) ** (degree - i) * points[i] for i in range(degree + 1)))
    return np.array(rows)


def blossom(knots, points, span, arguments):
    """The polar form of the cubic piece of a span."""
    values = list(points[span - 3:span + 1])
    for k, u in enumerate(arguments, 1):
        for i in range(4 - k):
            low, high = knots[span - 3 + k + i], knots[span + 1 + i]
            values[i] = ((high - u) * values[i] + (u - low) * values[i + 1]) / (high - low)
    return values[0]


def control_point(knots, points, arguments, span):
    """Of a cubic written with as many arguments as its new degree."""
    values = [blossom(knots, points, span, three) for three in combinations(arguments, 3)]
    return sum(values) / len(values)


def new_points(knots, points, new_knots, degree, every):
    """Each `every`-th control point of a cubic on other knots, of the same or a higher degree."""
    knots, points = [Fraction(u) for u in knots], exactly(points)
    new_knots, rows = [Fraction(u) for u in new_knots], []
    for i in range(0, len(new_knots) - degree - 1, every):
        inside = next(k for k in range(i, i + degree + 1) if new_knots[k] < new_knots[k + 1])
        span = span_of(knots, 3, new_knots[inside])
        rows.append(control_point(knots, points, new_knots[i + 1:i + degree + 1], span))
    return np.array(rows)


def arc_length(knots, points):
    """By Gauss's rule in long double, 24 places in each half of a span: to the last digits of a double."""
    places, weights = np.polynomial.legendre.leggauss(24)
    knots, points = knots.astype(np.longdouble), homogeneous(points).astype(np.longdouble)
    ends = np.unique(knots)
    ends = np.concatenate([np.array([a, (a + b) / 2]) for a, b in zip(ends[:-1], ends[1:], strict=True)] + [ends[-1:]])
    total = np.longdouble(0)
    for a, b in zip(ends[:-1], ends[1:], strict=True):
        for place, weight in zip(places, weights, strict=True):
            span, series = basis(list(knots), 3, (a + b) / 2 + (b - a) / 2 * np.longdouble(place), 1)
            sums = [sum(taylor[k] * points[span - 3 + i] for i, taylor in enumerate(series)) for k in (0, 1)]
            slope = (sums[1][:3] - sums[1][3] * sums[0][:3] / sums[0][3]) / sums[0][3]
            total += weight * (b - a) / 2 * np.sqrt(np.sum(slope * slope))
    return total


def refined_knots(knots, inserted):
    return np.sort(np.concatenate([knots, inserted]))


def repeated(knots, each):
    """Every distinct knot, each(multiplicity) times."""
    values, counts = np.unique(knots, return_counts=True)
    return np.repeat(values, each(counts))


def references():
    """The exact rows of every workload that has them, as functions of nothing."""
    data = workloads.inputs()
    step = workloads.SAMPLE_STEP
    knots, points = data["curve.knots"], data["curve.points"]
    sheet = data["surface.knots_u"], data["surface.knots_v"], data["surface.points"]
    long_knots, long_points = data["long.knots"], data["long.points"][:, :3]
    at = np.arange(0, workloads.GRID**2, step)
    grid = data["grid"][np.stack([at // workloads.GRID, at % workloads.GRID], 1)]
    return {
        "W1 sorted": lambda: curve_rows(knots, points, data["sorted"][::step], 0),
        "W1 random": lambda: curve_rows(knots, points, data["random"][::step], 0),
        "W2": lambda: curve_rows(knots, points, data["sorted"][::step], 2),
        "W3 points": lambda: surface_rows(*sheet, grid)[:, :3],
        "W3 normals": lambda: with_normals(surface_rows(*sheet, grid)),
        "W4": lambda: surface_rows(*sheet, data["pairs"][::step]),
        "W5 degree 11": lambda: bezier_rows(data["bezier11.points"], data["sorted"][::step]),
        "W5 degree 25": lambda: bezier_rows(data["bezier25.points"], data["sorted"][::step]),
        "W6 refine": lambda: new_points(long_knots, long_points, refined_knots(long_knots, data["inserted"]), 3, 7),
        "W6 elevate": lambda: new_points(long_knots, long_points, repeated(long_knots, lambda n: n + 2), 5, 7),
        "W6 Beziers": lambda: new_points(long_knots, long_points, repeated(long_knots, lambda n: 0 * n + 4), 3, 7),
        **{f"W7 curve {name}": lambda count=count: exactly(data[f"coil{count}"][::7])
           for name, count in (("1e3", 1000), ("1e4", 10_000), ("1e5", 100_000))},
        "W7 surface": lambda: exactly(data["sheet300"].reshape(-1, 3)[::7]),
        "W7 least squares": lambda: least_squares(data["lsq.knots"], data["lsq.parameters"], data["coil100000"]),
        "W8 curve": lambda: least_distances((knots,), points, data["near_curve"][::workloads.NEAREST_STEP]),
        "W8 patch": lambda: least_distances(sheet[:2], sheet[2], data["near_surface"][::workloads.NEAREST_STEP]),
        "W9 curves": lambda: zigzag_crossings(data["zigzag.knots"], data["zigzag_a"] - data["zigzag_b"]),
        "W9 surfaces": lambda: exactly(np.zeros((workloads.BRANCHES * workloads.BRANCH_SAMPLES, 1))),
        "W13 first": lambda: exactly(np.zeros((workloads.RAYS, 1))),
        "W13 all": lambda: exactly(np.zeros((2 * workloads.RAYS, 1))),
        "W10": lambda: teapot_rows(data["teapot"], data["patch_grid"]),
        "W11": lambda: np.array([[Fraction(float(arc_length(knots, points)))]]),
    }


def functions(knots, u, degree=3):
    """All B-spline functions at parameters, (count, functions), by their recursion."""
    u = np.clip(np.atleast_1d(u), knots[degree], np.nextafter(knots[-degree - 1], knots[0]))
    values = ((knots[:-1] <= u[:, None]) & (u[:, None] < knots[1:])).astype(knots.dtype)
    for p in range(1, degree + 1):
        with np.errstate(divide="ignore", invalid="ignore"):
            rise = np.nan_to_num((u[:, None] - knots[:-p - 1]) / (knots[p:-1] - knots[:-p - 1]), posinf=0, neginf=0)
            fall = np.nan_to_num((knots[p + 1:] - u[:, None]) / (knots[p + 1:] - knots[1:-p]), posinf=0, neginf=0)
        values = rise * values[:, :-1] + fall * values[:, 1:]
    return values


def least_squares(knots, parameters, points, degree=3):
    """Control points by the normal equations, in numbers of 64 bits and more."""
    width = len(knots) - degree - 1
    knots, left, right = knots.astype(np.longdouble), np.zeros((width, width), np.longdouble), 0
    for i in range(0, len(points), 1000):
        rows = functions(knots, parameters[i:i + 1000].astype(np.longdouble), degree)
        right = right + rows.T @ points[i:i + 1000].astype(np.longdouble)
        for k in range(degree + 1):
            sums = (rows[:, k:] * rows[:, :width - k]).sum(0)
            left += np.diag(sums, k) + (np.diag(sums, -k) if k else 0)
    for k in range(width):
        below = slice(k + 1, min(k + degree + 1, width))
        factors = (left[below, k] / left[k, k])[:, None]
        left[below], right[below] = left[below] - factors * left[k], right[below] - factors * right[k]
    for k in reversed(range(width)):
        right[k] = (right[k] - left[k, k + 1:] @ right[k + 1:]) / left[k, k]
    return np.vectorize(lambda number: Fraction(*number.as_integer_ratio()), otypes=[object])(right)


def least_distances(knots, points, places):
    """By dense samples in every direction and ever finer ones about the nearest: one number a row."""
    homogeneous = np.concatenate([points[..., :3] * points[..., 3:], points[..., 3:]], -1)

    def sampled(lines):
        rows = homogeneous
        for axis, line in enumerate(lines):
            rows = np.moveaxis(np.tensordot(functions(knots[axis], line), rows, (1, axis)), 0, axis)
        return rows[..., :3] / rows[..., 3:]

    count = 20_001 if len(knots) == 1 else 601
    lines = [np.linspace(0, 1, count)] * len(knots)
    dense = sampled(lines)
    rows = []
    for place in places:
        around, found, reach = lines, dense, 1 / (count - 1)
        for _ in range(25):
            squares = ((found - place) ** 2).sum(-1)
            best = np.unravel_index(squares.argmin(), squares.shape)
            around = [np.clip(line[i] + reach * np.linspace(-1, 1, 9), 0, 1) for line, i in zip(around, best)]
            found, reach = sampled(around), reach / 3
        rows.append([Fraction(float(np.sqrt(((found - place) ** 2).sum(-1).min())))])
    return np.array(rows)


def zigzag_crossings(knots, differences):
    """Parameters at which curves with one x for one parameter are equally high: one number a row, by halving."""
    knots, heights = knots.astype(np.longdouble), differences[:, 1].astype(np.longdouble)

    def height(u):
        return functions(knots, u) @ heights

    u = np.linspace(0, 1, 20_001).astype(np.longdouble)
    rises = height(u) > 0
    low, high = u[:-1][rises[1:] != rises[:-1]], u[1:][rises[1:] != rises[:-1]]
    sign = np.where(height(low) > 0, 1, -1)
    for _ in range(60):
        middle = (low + high) / 2
        is_before = sign * height(middle) > 0
        low, high = np.where(is_before, middle, low), np.where(is_before, high, middle)
    return np.array([[Fraction(*root.as_integer_ratio())] for root in low])


def teapot_rows(nets, line):
    knots = np.repeat([0.0, 1.0], 4)
    weighted = np.concatenate([nets, np.ones((*nets.shape[:-1], 1))], -1)
    rows, n = [], len(line)
    for at in range(0, len(nets) * n * n, workloads.SAMPLE_STEP):
        patch, u, v = at // (n * n), at // n % n, at % n
        rows.append(surface_rows(knots, knots, weighted[patch], [(line[u], line[v])])[0])
    return with_normals(np.array(rows))


def error(kept, reference):
    """The largest difference of a coordinate; what follows the point is measured by the largest of its kind.

    Rows whose exact normal is zero are not asked for one.
    """
    differences = np.abs(exactly(kept.reshape(reference.shape)) - reference)
    if reference.shape[1] == 6:
        differences[(reference[:, 3:] == 0).all(axis=1), 3:] = Fraction(0)
    largest = [float(differences[:, :3].max())]
    for k in range(3, reference.shape[1], 3):
        largest.append(float(differences[:, k:k + 3].max() / np.abs(reference[:, k:k + 3]).max()))
    return max(largest)
