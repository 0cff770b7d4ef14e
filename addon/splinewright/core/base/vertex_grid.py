"""In which rows and columns the corners of faces lie."""

from collections import deque

import numpy as np

from .failures import Refusal

_NO_GRID = "the selected faces are no grid of rows and columns"


def in_grid(faces):
    """((rows, columns) of vertices, (whether rows close, whether columns close)) of quads.

    faces: four vertices each, in their order around; all of them hang together.
    Raises Refusal where they make no full grid.
    """
    if not faces:
        raise Refusal("select faces that make a grid")
    if any(len(set(face)) != 4 for face in faces):
        raise Refusal("the selected faces are not all of four corners")
    places, steps = _laid_out(faces)
    periods = _periods(steps)
    where = {}
    for vertex, place in places.items():
        key = tuple(at % period if period else at for at, period in zip(place, periods))
        if where.setdefault(key, vertex) != vertex:
            raise Refusal(_NO_GRID)
    keys = np.array(list(where))
    low, counts = keys.min(axis=0), np.ptp(keys, axis=0) + 1
    if counts.prod() != len(where) or len(faces) != np.prod([n if period else n - 1 for n, period in zip(counts, periods)]):
        raise Refusal("{no_grid}: some are missing", no_grid=_NO_GRID)
    rows = np.empty(counts, dtype=np.int64)
    rows[tuple((keys - low).T)] = list(where.values())
    return rows, tuple(map(bool, periods))


def _laid_out(faces):
    """({vertex: its place in whole numbers}, the steps between places of vertices that were met again elsewhere)."""
    beside = {}
    for number, face in enumerate(faces):
        for side in _sides(face):
            beside.setdefault(frozenset(side), []).append(number)
    places = dict(zip(faces[0], ((0, 0), (1, 0), (1, 1), (0, 1))))
    waiting, seen, steps = deque([(0, dict(places))]), {0}, set()
    while waiting:
        number, corners = waiting.popleft()
        for first, second in _sides(faces[number]):
            for other in beside[frozenset((first, second))]:
                if other in seen:
                    continue
                seen.add(other)
                found = _across(faces[number], faces[other], corners, first, second)
                for vertex, place in found.items():
                    known = places.setdefault(vertex, place)
                    if known != place:
                        steps.add((place[0] - known[0], place[1] - known[1]))
                waiting.append((other, found))
    if len(seen) != len(faces):
        raise Refusal("the selected faces do not hang together")
    return places, steps


def _sides(face):
    return [(face[i], face[(i + 1) % 4]) for i in range(4)]


def _across(face, other, corners, first, second):
    """Places of the corners of the face on the other side of an edge."""
    found = {first: corners[first], second: corners[second]}
    for vertex, end in ((first, second), (second, first)):
        behind, ahead = (_neighbor(each, vertex, end) for each in (face, other))
        found[ahead] = tuple(2 * at - back for at, back in zip(corners[vertex], corners[behind]))
    return found


def _neighbor(face, vertex, not_this):
    i = face.index(vertex)
    return next(each for each in (face[i - 1], face[(i + 1) % 4]) if each != not_this)


def _periods(steps):
    """How many rows and columns there are until they come back; 0 where they do not."""
    periods = [int(np.gcd.reduce([step[axis] for step in steps if not step[1 - axis]] or [0])) for axis in (0, 1)]
    if any(at % period if period else at for step in steps for at, period in zip(step, periods)):
        raise Refusal(_NO_GRID)
    return periods
