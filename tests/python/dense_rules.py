"""Lengths and areas by another way: B-splines from their recursion, in numpy, and Gauss's rule on many parts."""

import numpy as np

NODES, SHARES = np.polynomial.legendre.leggauss(16)


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


def graded_parts(count, depth=40):
    """Ever shorter towards both ends, where weights have their peaks and curves their cusps."""
    small = 0.5 ** np.linspace(depth, 1, count)
    return np.concatenate([[0.0], small, 1 - small[-2::-1], [1.0]])


def quotient(slope, point):
    return (slope[..., :3] - slope[..., 3:] * point[..., :3] / point[..., 3:]) / point[..., 3:]


def length(degree, knots, points, weights, periodic, places):
    (u,), net = unrolled([degree], [knots], points, weights, [periodic])
    at, shares = rule(u, degree, places)
    values, slopes = basis(u, degree, at)
    return (np.linalg.norm(quotient(slopes @ net, values @ net), axis=-1) * shares).sum()


def surface(degree, knots, points, weights, periodic, places):
    """Points and normals (u, v, 3) at the nodes, as long as S_u x S_v, and the shares of the nodes (u, v)."""
    plain, net = unrolled(degree, knots, points, weights, periodic)
    (u, shares_u), (v, shares_v) = (rule(k, p, places) for k, p in zip(plain, degree))
    (bu, du), (bv, dv) = (basis(k, p, at) for k, p, at in zip(plain, degree, (u, v)))
    at, along_u, along_v = (np.einsum("ui,ijc,vj->uvc", a, net, b, optimize=True)
                                 for a, b in ((bu, bv), (du, bv), (bu, dv)))
    normals = np.cross(quotient(along_u, at), quotient(along_v, at))
    return at[..., :3] / at[..., 3:], normals, np.outer(shares_u, shares_v)


def area(*patch):
    _, normals, shares = surface(*patch)
    return (np.linalg.norm(normals, axis=-1) * shares).sum()


def surface_centroid(*patch):
    points, normals, shares = surface(*patch)
    sizes = np.linalg.norm(normals, axis=-1) * shares
    return (points * sizes[..., None]).sum((0, 1)) / sizes.sum()


def flux(field, *patch):
    """The flux, and what flows through to either side."""
    points, normals, shares = surface(*patch)
    through = (field(points.reshape(-1, 3)).reshape(points.shape) * normals).sum(-1) * shares
    return through.sum(), np.abs(through).sum()
