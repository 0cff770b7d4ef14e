"""Patches that meet."""

import numpy as np

import splinecore as sc


def set_of(*patches):
    return sc.PatchSet.from_patches(list(patches), merge=False)


def random_sheet(seed):
    """A wavy NURBS patch with weights and inner knots of any multiplicity below the gap."""
    random = np.random.default_rng(seed)
    degree = tuple(int(d) for d in random.integers(1, 6, 2))
    knots, shape = [], []
    for d in degree:
        inner = np.repeat(np.cumsum(random.uniform(0.2, 1, 3)), random.integers(1, d + 1, 3))
        knots.append(np.r_[np.zeros(d + 1), inner, np.full(d + 1, inner[-1] + 0.7)])
        shape.append(len(knots[-1]) - d - 1)
    net = np.stack(np.meshgrid(*(np.linspace(0, 4, n) for n in shape), [0], indexing='ij'), -1)[:, :, 0]
    net = net + random.uniform(-0.4, 0.4, net.shape)
    return sc.NurbsPatch(degree, knots, net, random.uniform(0.5, 2, shape))


def halves(part, seed=11):
    """A wavy sheet split at a part of its domain along u."""
    sheet = random_sheet(seed)
    (start, end), _ = sheet.domain
    return sheet.split('u', start + part * (end - start))
