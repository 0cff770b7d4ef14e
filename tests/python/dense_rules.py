"""Lengths and areas by another way: B-splines from their recursion, in numpy, and Gauss's rule on many parts."""

import numpy as np

NODES, SHARES = np.polynomial.legendre.leggauss(16)
LAST = np.polynomial.legendre.legvander(NODES, 15)[:, 14:] * SHARES[:, None]  # the last polynomials that the nodes tell


def unrolled(degree, knots, points, weights, axes):
    """Knots and homogeneous points as those of plain splines. axes: for each direction whether it is periodic."""
    net = np.concatenate([points * weights[..., None], weights[..., None]], -1)
    plain = []
    for axis, (p, u, periodic) in enumerate(zip(degree, knots, axes)):
        u = np.asarray(u, float)
        if periodic:
            period, count = u[-1] - u[0], len(u) - 1
            index = np.arange(-p, count + p + 1)
            u = u[index % count] + period * (index // count)
            net = np.take(net, np.arange(count + p) % count, axis)
        plain.append(u)
    return plain, net


def basis(knots, degree, u):
    """The B-splines at parameters inside spans, and their derivatives: Cox and de Boor, without 0 / 0."""
    span = np.clip(np.searchsorted(knots, u, side="right") - 1, degree, len(knots) - degree - 2)
    values = np.zeros((len(u), len(knots) - 1))
    values[np.arange(len(u)), span] = 1.0
    slopes = np.zeros_like(values)
    for d in range(1, degree + 1):
        low, high = knots[:-1 - d], knots[1 + d:]
        before, after = knots[d:-1] - low, high - knots[1:len(knots) - d]
        rise = np.where(before > 0, 1 / np.where(before > 0, before, 1), 0)
        fall = np.where(after > 0, 1 / np.where(after > 0, after, 1), 0)
        first, second = values[:, :-1], values[:, 1:]
        slopes = d * (first * rise - second * fall)
        values = first * (u[:, None] - low) * rise + second * (high - u[:, None]) * fall
    return values, slopes


def rule(knots, degree, places):
    """Nodes and shares of Gauss's rule on the parts of every span of the domain."""
    spans = np.unique(knots[degree:len(knots) - degree])
    edges = np.unique((spans[:-1, None] + np.diff(spans)[:, None] * places).ravel())
    half = np.diff(edges)[:, None] / 2
    return (edges[:-1, None] + half * (1 + NODES)).ravel(), (half * SHARES).ravel()


def even_parts(count):
    return np.linspace(0.0, 1.0, count + 1)


def quotient(slope, point):
    return (slope[..., :3] - slope[..., 3:] * point[..., :3] / point[..., 3:]) / point[..., 3:]


def boxes_of(plain, degree):
    """The boxes (n, directions, 2) between the knots of a domain."""
    spans = [np.unique(u[p:len(u) - p]) for u, p in zip(plain, degree)]
    edges = [np.stack([each[:-1], each[1:]], -1) for each in spans]
    chosen = np.meshgrid(*(np.arange(len(each)) for each in edges), indexing="ij")
    return np.stack([each[index.ravel()] for each, index in zip(edges, chosen)], 1)


def halved(boxes):
    """Boxes (n, directions, 2) halved in every direction; the parts of one follow each other."""
    for axis in range(boxes.shape[1]):
        middle = boxes[:, axis].mean(-1)
        boxes = np.repeat(boxes, 2, 0)
        boxes[0::2, axis, 1] = boxes[1::2, axis, 0] = middle
    return boxes


def settled(integral, boxes, rounds=60, most=4000):
    """The sum of an integral over boxes that are halved where this changes it, and what the last changes amount to.

    Two rules on all of a domain may be wrong by more than they differ, where the speed or the normal comes near to
    zero: by chance the errors of parts cancel. Here each part answers for itself, and no two errors cancel. Of a
    hundred thousand parts one may agree with its halves by chance, too: so each doubts itself as well. Coefficients of
    Legendre's polynomials fall as powers do, and the rule's error is one of twice the degree of the last that it sees;
    a thousand times that, because beside a fold they fall more slowly.
    @param integral  of boxes: what it is, and how large those last ones are
    """
    whole, _ = integral(boxes)
    allowed = 1e-14 * whole.sum()
    found = unsure = 0.0
    for last in range(rounds, -1, -1):
        boxes = halved(boxes)
        parts, tails = (each.reshape(len(whole), -1) for each in integral(boxes))
        doubt = np.maximum(np.abs(parts.sum(1) - whole), (1e3 * tails**2 / np.maximum(parts, 1e-300)).sum(1))
        is_wrong = (doubt > allowed) & (last > 0 and np.count_nonzero(doubt > allowed) <= most)
        found += parts[~is_wrong].sum()
        unsure += doubt[~is_wrong].sum()
        boxes = boxes.reshape(*parts.shape, *boxes.shape[1:])[is_wrong].reshape(-1, *boxes.shape[1:])
        whole = parts[is_wrong].ravel()
        if not len(whole):
            return found, unsure / found


def at_boxes(knots, degree, boxes):
    """The functions (n, degree + 1) in (n, 2) boxes, their values and slopes at Gauss's nodes, and half the widths."""
    half = np.diff(boxes) / 2
    nodes = boxes[:, :1] + half * (1 + NODES)
    there = np.searchsorted(knots, nodes[:, 0], side="right")[:, None] - 1 - degree + np.arange(degree + 1)
    both = (np.take_along_axis(each.reshape(*nodes.shape, -1), there[:, None], 2)
            for each in basis(knots, degree, nodes.ravel()))
    return there, *both, half


def settled_length(degree, knots, points, weights, periodic):
    """The length, and how far it may be off by, relative to it."""
    plain, net = unrolled([degree], [knots], points, weights, [periodic])

    def of_boxes(boxes):
        there, values, slopes, half = at_boxes(plain[0], degree, boxes[:, 0])
        speed = np.linalg.norm(quotient(slopes @ net[there], values @ net[there]), axis=-1) * half
        return speed @ SHARES, np.abs(speed @ LAST).sum(-1)

    return settled(of_boxes, boxes_of(plain, [degree]))


def settled_area(degree, knots, points, weights, periodic):
    """The area, and how far it may be off by, relative to it."""
    plain, net = unrolled(degree, knots, points, weights, periodic)

    def of_few(boxes):
        (i, bu, du, half_u), (j, bv, dv, half_v) = (at_boxes(plain[k], degree[k], boxes[:, k]) for k in range(2))
        near = net[i[:, :, None], j[:, None]].reshape(*i.shape, -1)
        at, along_u, along_v = (b[:, None] @ (a @ near).reshape(*a.shape[:2], *j.shape[1:], 4)
                                for a, b in ((bu, bv), (du, bv), (bu, dv)))
        normals = np.cross(quotient(along_u, at), quotient(along_v, at))
        sizes = np.linalg.norm(normals, axis=-1) * (half_u * half_v)[..., None]
        tails = [np.abs(each @ LAST).sum(-1) @ SHARES for each in (sizes, np.swapaxes(sizes, 1, 2))]
        return sizes @ SHARES @ SHARES, sum(tails)

    def of_boxes(boxes):
        few = [of_few(boxes[i:i + 64]) for i in range(0, len(boxes), 64)]
        return [np.concatenate(each) for each in zip(*few)]

    return settled(of_boxes, boxes_of(plain, degree))


def surface(degree, knots, points, weights, periodic, places):
    """Points and normals (u, v, 3) at the nodes, as long as S_u x S_v, and the shares of the nodes (u, v)."""
    plain, net = unrolled(degree, knots, points, weights, periodic)
    (u, shares_u), (v, shares_v) = (rule(k, p, places) for k, p in zip(plain, degree))
    (bu, du), (bv, dv) = (basis(k, p, at) for k, p, at in zip(plain, degree, (u, v)))
    at, along_u, along_v = (np.einsum("ui,ijc,vj->uvc", a, net, b, optimize=True)
                                 for a, b in ((bu, bv), (du, bv), (bu, dv)))
    normals = np.cross(quotient(along_u, at), quotient(along_v, at))
    return at[..., :3] / at[..., 3:], normals, np.outer(shares_u, shares_v)


def surface_centroid(*patch):
    points, normals, shares = surface(*patch)
    sizes = np.linalg.norm(normals, axis=-1) * shares
    return (points * sizes[..., None]).sum((0, 1)) / sizes.sum()


def flux(field, *patch):
    """The flux, and what flows through to either side."""
    points, normals, shares = surface(*patch)
    through = (field(points.reshape(-1, 3)).reshape(points.shape) * normals).sum(-1) * shares
    return through.sum(), np.abs(through).sum()
