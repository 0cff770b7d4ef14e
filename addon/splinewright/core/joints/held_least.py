"""The least motion of free rows of a pool by which equations hold on while other rows are moved by hand.

What all rows move by alike meets the equations of core.joints.held_strips: so a push of the hand never takes more than a push of all.
"""

import numpy as np

#: What is left of an equation beside others is rounding, as a part of it, below this.
_DEPENDENT = 1e-12
#: How exactly the equations are met, as a part of the largest motion.
_MET = 1e-9


def least_motion(equations, moved, is_free):
    """(n, 3): what the free rows of a pool move by; None where they cannot meet the equations.

    equations: core.joints.held_strips.Equations. moved (n, 3): what the rows have moved by already since those held. is_free: (n,).
    """
    most = np.abs(moved).max(initial=0.0)
    motion = np.zeros_like(moved)
    rows, factors, columns = _rows_of(equations)
    if most == 0 or not len(rows):
        return motion
    moved = moved / most
    rests = -np.einsum('ij,ijk->ik', factors, moved[rows])
    chosen = _reached(rows, factors, rests, is_free)
    if not chosen.any():
        return motion
    rows, factors, rests, columns = rows[chosen], factors[chosen], rests[chosen], columns[chosen]
    unknown = np.unique(rows[(is_free[rows]) & (factors != 0)])
    matrix = np.zeros((len(rows), len(unknown)))
    at = np.minimum(np.searchsorted(unknown, rows), max(len(unknown) - 1, 0))
    for column in range(rows.shape[1] if len(unknown) else 0):
        counts = np.where(unknown[at[:, column]] == rows[:, column], factors[:, column], 0.0)
        np.add.at(matrix, (np.arange(len(rows)), at[:, column]), counts)
    if not len(unknown) or not _set_upright(matrix, rests, columns):
        return None
    found = np.linalg.lstsq(matrix, rests, rcond=_DEPENDENT)[0]
    if not np.isfinite(found).all() or np.abs(matrix @ found - rests).max() > _MET * max(1.0, np.abs(found).max()):
        return None
    motion[unknown] = found * most
    return motion


def _rows_of(equations):
    """(m, 6) rows, (m, 6) factors of length 1, and (m,) the column of each equation, that of order 1 first."""
    rows, factors, columns, count = [np.empty((0, 6), int)], [np.empty((0, 6))], [np.empty(0, int)], 0
    for one in equations:
        for factor in one.factors:
            rows.append(one.rows)
            factors.append(factor / np.linalg.norm(factor, axis=1, keepdims=True))
            columns.append(np.arange(len(one.rows)) + count)
        count += len(one.rows)
    return tuple(np.concatenate(parts) for parts in (rows, factors, columns))


def _reached(rows, factors, rests, is_free):
    """(m,) bool: equations that do not hold, and those that share free rows with them, and so on."""
    chosen = (np.abs(rests) > _MET * 1e-3).any(1)
    counts = is_free[rows] & (factors != 0)
    while chosen.any():
        is_touched = np.zeros(len(is_free), bool)
        is_touched[rows[chosen][counts[chosen]]] = True
        more = chosen | (is_touched[rows] & counts).any(1)
        if (more == chosen).all():
            break
        chosen = more
    return chosen


def _set_upright(matrix, rests, columns):
    """Bring the second equation of each column to right angles with its first, and all to length 1. False where one has no free
    row."""
    first = {}
    for i, column in enumerate(columns.tolist()):
        if not _to_length_one(matrix, rests, i, 0.0):
            return False
        before = first.setdefault(column, i)
        for _ in range(2 if before != i else 0):    # once leaves rounding where the angle is small
            share = matrix[i] @ matrix[before]
            matrix[i] -= share * matrix[before]
            rests[i] -= share * rests[before]
            if not _to_length_one(matrix, rests, i, _DEPENDENT):
                return False
    return True


def _to_length_one(matrix, rests, i, least):
    length = np.linalg.norm(matrix[i])
    if not length > least:
        return False
    matrix[i] /= length
    rests[i] /= length
    return True
