"""The curves that the same control points make in other orders (001.63)."""

from itertools import permutations

import numpy as np

from ..base.failures import Refusal
from . import signs
from .functions import Part

ORDER, POLYGON = "order", "polygon"
#: Most curves of a picture.
MOST = 120
#: How far curves lie apart, as a part of their size.
_GAP = 0.3


def typed(text, count):
    """Orders of a number of points, as tuples, from a text such as "0 2 1 3, 1 0 2 3"; all that make different curves for none. Raises
    Refusal."""
    found = []
    for part in filter(str.strip, text.replace(";", ",").split(",")):
        words = part.split() if " " in part.strip() else list(part.strip())
        if not all(word.isdecimal() for word in words) or sorted(map(int, words)) != list(range(count)):
            raise Refusal("\"{strip}\" is not an order of the points 0 to {count}", strip=part.strip(), count=count - 1)
        found.append(tuple(map(int, words)))
    if len(found) > MOST:
        raise Refusal("these are {count} orders: {most} are the most", count=len(found), most=MOST)
    return found


def all_of(curve):
    """All orders of the points of a curve that make different ones: of an order and its reverse one, where knots are symmetric. Of more
    than five points the first orders in which two neighbors are swapped."""
    count = len(curve.points)
    if count > 5:
        swaps = ((*range(i), i + 1, i, *range(i + 2, count)) for i in range(min(count - 1, MOST - 1)))
        return [tuple(range(count)), *swaps]
    found = list(permutations(range(count)))
    return [order for order in found if order <= order[::-1]] if _is_symmetric(curve) else found


def _is_symmetric(curve):
    """Whether the curve runs backward where its points do."""
    knots = np.array(curve.unrolled().knots)
    widths = np.diff(knots)
    return not curve.periodic and bool(np.abs(widths - widths[::-1]).max() <= 1e-12 * (knots[-1] - knots[0]))


def picture(curve, orders, columns, has_polygons):
    """The Parts of the curves of a NurbsCurve's points in orders, in rows of this many; 0 draws them over each other."""
    rows, parts = curve.homogeneous_points, []
    finite = rows[rows[:, 3] != 0.0]
    size = np.ptp(finite[:, :3] / finite[:, 3:], axis=0)
    step = size + _GAP * max(size.max(), 1e-9)
    for number, order in enumerate(orders):
        own = rows[list(order)]
        if columns > 0:
            own[:, 0] += number % columns * step[0] * own[:, 3]
            own[:, 1] -= number // columns * step[1] * own[:, 3]
        name = f"{ORDER} {''.join(map(str, order)) if len(order) <= 10 else ' '.join(map(str, order))}"
        parts.append(Part(name, type(curve).from_homogeneous(curve.degree, curve.knots, own, curve.periodic)))
        closed = np.concatenate([own, own[:1]]) if curve.periodic else own
        parts += [Part(POLYGON, one) for one in signs.polygon(closed)] if has_polygons else []
    return parts
