"""Vertex groups: their names belong to an object, their weights to the mesh."""

from typing import NamedTuple

import numpy as np


class Groups(NamedTuple):
    """The vertex groups of an object and their weights."""

    names: list
    locked: list
    active: int
    weights: np.ndarray                 # (vertices, groups)


def of(mesh, owner):
    """The Groups of an object that has the mesh, or None where there are none."""
    if owner is None or not owner.vertex_groups:
        return None
    groups = owner.vertex_groups
    weights = np.zeros((len(mesh.vertices), len(groups)), np.float32)
    for i, vertex in enumerate(mesh.vertices):
        for entry in vertex.groups:
            if entry.group < len(groups):
                weights[i, entry.group] = entry.weight
    names, locked = [group.name for group in groups], [group.lock_weight for group in groups]
    return Groups(names, locked, groups.active_index, weights)


def write(owner, groups, weights, vertices):
    """Give vertices of an object, by their numbers, Groups with other weights, (vertices, groups)."""
    for name, is_locked, weight in zip(groups.names, groups.locked, weights.T):
        group = owner.vertex_groups.get(name) or owner.vertex_groups.new(name=name)
        for i in np.flatnonzero(weight).tolist():
            group.add([int(vertices[i])], float(weight[i]), 'REPLACE')
        group.lock_weight = is_locked
    owner.vertex_groups.active_index = groups.active
