"""Splines in exact fractions, by Cox, de Boor and Boehm and by linear systems: no blossoms, as the library has them."""

from fractions import Fraction

import numpy as np


def exact(values):
    """Nested lists of the fractions that the numbers are."""
    return [exact(value) for value in values] if np.ndim(values) else Fraction(float(values))


def rounded(rows):
    return np.array([[float(value) for value in row] for row in rows])


def functions(degree, knots, u):
    """All basis functions at u; the last one of them is 1 at the end of a clamped domain."""
    last = max(i for i in range(degree, len(knots) - degree - 1) if knots[i] < knots[i + 1] and knots[i] <= u)
    values = [Fraction(int(i == last)) for i in range(len(knots) - 1)]
    for p in range(1, degree + 1):
        values = [share(u, knots[i], knots[i + p]) * values[i]
                  + share(-u, -knots[i + p + 1], -knots[i + 1]) * values[i + 1] for i in range(len(values) - 1)]
    return values


def share(u, start, end):
    return (u - start) / (end - start) if start != end else Fraction(0)


def value(degree, knots, points, u):
    return product([functions(degree, knots, u)], points)[0]


def product(matrix, points):
    return [[sum(weight * point[axis] for weight, point in zip(row, points) if weight)
             for axis in range(len(points[0]))] for row in matrix]


def inserted(degree, knots, points, u):
    """Boehm's algorithm: the knots and points with one knot more."""
    k = max(i for i, knot in enumerate(knots) if knot <= u)
    new = []
    for i in range(len(points) + 1):
        if i <= k - degree:
            new.append(points[i])
        elif i > k:
            new.append(points[i - 1])
        else:
            t = share(u, knots[i], knots[i + degree])
            new.append([(1 - t) * a + t * b for a, b in zip(points[i - 1], points[i])])
    return knots[:k + 1] + [u] + knots[k + 1:], new


def insertion_matrix(degree, knots, u, times):
    count = len(knots) - degree - 1
    rows = [[Fraction(int(i == j)) for j in range(count)] for i in range(count)]
    for _ in range(times):
        knots, rows = inserted(degree, knots, rows, u)
    return rows


def elevation_matrix(degree, knots):
    """By interpolation in as many parameters as there are points, and the knots it leads to."""
    raised = sorted(knots + sorted(set(knots)))
    count = len(raised) - degree - 2
    sites = [sum(raised[i + 1:i + degree + 2]) / (degree + 1) for i in range(count)]
    rows = [functions(degree + 1, raised, u) for u in sites]
    return raised, solved(rows, [functions(degree, knots, u) for u in sites])


def solved(rows, right):
    """Gauss, with any number of right sides."""
    rows = [list(row) + list(more) for row, more in zip(rows, right)]
    size = len(rows)
    for k in range(size):
        pivot = next(i for i in range(k, size) if rows[i][k])
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [value / rows[k][k] for value in rows[k]]
        for i in range(size):
            if i != k and rows[i][k]:
                factor = rows[i][k]
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    return [row[size:] for row in rows]


def nearest(matrix, points, fixed):
    """The old points whose image under the matrix is nearest to points; `fixed` says which are known already."""
    free = [i for i in range(len(matrix[0])) if i not in fixed]
    known = product([[row[i] for i in fixed] for row in matrix], list(fixed.values())) if fixed else None
    rest = [[a - b for a, b in zip(*pair)] for pair in zip(points, known)] if fixed else points
    columns = [[row[i] for row in matrix] for i in free]
    normal = [[sum(a * b for a, b in zip(one, other)) for other in columns] for one in columns]
    found = {**fixed, **dict(zip(free, solved(normal, product(columns, rest))))} if free else fixed
    return [found[i] for i in range(len(found))]
