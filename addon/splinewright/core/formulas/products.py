"""Graphs of products of two functions over a rectangle of parameters (S16, S20): N_i(u) M_j(v), by which a patch is the sum of its points.

A graph of a function is a curve (u, value, 0) with the parameter as its first coordinate, so that the product of two graphs is one
patch: averages of knots along u are x of its control points, those along v are y, products of values are z. It is exact where graphs are.
"""

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from . import functions
from .functions import SUM, Part

#: Most products of a picture.
MOST = 256


def of_patch(patch):
    """(the functions.Family along u, that along v) by which a patch is the sum of its points, without weights. Raises Refusal."""
    if isinstance(patch, sc.BezierPatch):
        return tuple(map(functions.bernstein, patch.degree))
    if isinstance(patch, sc.HermitePatch):
        return tuple(map(functions.hermite, patch.parameters))
    return tuple(functions.of_curve(_row(patch, axis)) for axis in (0, 1))


def _row(patch, axis):
    """A NurbsCurve with the knots of a NurbsPatch along an axis."""
    points = np.zeros((patch.points.shape[axis], 3))
    points[:, 0] = np.arange(len(points))
    return sc.NurbsCurve(patch.degree[axis], patch.knots[axis], points, periodic=patch.periodic[axis])


def name_of(one, other):
    """What the product of two functions is called."""
    return f"{one} {other}"


def factors(name):
    """[(letter, what stands below its line)] of both functions of a product, or of one function; none of another name."""
    words = name.split(" ")
    if len(words) > 2 or not all("_{" in word and word.endswith("}") for word in words):
        return []
    return [tuple(word[:-1].split("_{", 1)) for word in words]


def picture(families, show, chosen, size, height):
    """The Parts of products of two families: their curves are patches. show: 'all', 'chosen' or 'sum'; chosen: the numbers of two functions;
    size: (width, depth) of the rectangle, which begins at 0; height: of the value 1. Raises Refusal."""
    scales = [extent / (family.places[-1] - family.places[0]) for family, extent in zip(families, size)]
    frames = [(families[0].places[0], scales[0], height), (families[1].places[0], scales[1], 1.0)]
    if show == 'sum':
        return _parts(SUM, *(_placed(family.graph(functions.of_points(family)), frame) for family, frame in zip(families, frames)))
    numbers = _numbers(families, show, chosen)
    graphs = [{i: _placed(functions.graphs_of(family, i), frame) for i in {pair[axis] for pair in numbers}}
              for axis, (family, frame) in enumerate(zip(families, frames))]
    found = [part for i, j in numbers for part in _parts(name_of(families[0].names[i], families[1].names[j]), graphs[0][i], graphs[1][j])]
    if not found:
        raise Refusal("all functions are zero: their knots coincide")
    return found


def _numbers(families, show, chosen):
    """[(i, j)]: which products are drawn."""
    counts = [len(family.names) for family in families]
    if show == 'chosen':
        for number, count, axis in zip(chosen, counts, "uv"):
            if number >= count:
                raise Refusal("there is no function {number} along {axis}: the last one is {last}", number=number, axis=axis, last=count - 1)
        return [chosen]
    if counts[0] * counts[1] > MOST:
        raise Refusal("these are {count} products: {most} are the most; choose one of them, or the sum", count=counts[0] * counts[1], most=MOST)
    return [(i, j) for i in range(counts[0]) for j in range(counts[1])]


def _placed(curves, frame):
    return [functions.placed(curve, *frame) for curve in curves]


def _parts(name, along_u, along_v):
    return [Part(name, _product(one, other)) for one in along_u for other in along_v]


def _product(one, other):
    """The NurbsPatch that is the product of two graphs."""
    x, y = np.meshgrid(one.points[:, 0], other.points[:, 0], indexing='ij')
    return sc.NurbsPatch((one.degree, other.degree), (one.knots, other.knots), np.dstack([x, y, np.outer(one.points[:, 1], other.points[:, 1])]))
