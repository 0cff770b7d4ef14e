"""The net of curves as a Curve. Points are numbered by their tilt and marked by their radius, which show nothing here.

What can be selected has a slot: each point, and of a Bezier point its left handle, itself and its right handle, spline
by spline.
"""

import bpy
import numpy as np

from ...core.net import handles, strays
from ...core.net.grown import Run, STRAY, copy_of
from ...core.net.reading import Present

#: The tilt of points that were passed over once for all: no number of a point reaches it.
_STRAY = np.float32(2 ** 24)
_HANDLES = ('handle_left', 'co', 'handle_right')
_COMPUTED = (handles.AUTO, handles.VECTOR, handles.ALIGNED)
_FLAGS = ('select_left_handle', 'select_control_point', 'select_right_handle')

#: Into so many pieces Blender cuts segments that it draws itself.
_SHOWN = 64


def make(name, net, letters):
    """A new Curve that shows the net of curves, whose points carry the numbers from 0 on. letters: as of
    core.net.handles.of_net()."""
    curve = bpy.data.curves.new(f"{name} Net", 'CURVE')
    curve.dimensions = '3D'
    first = number = 0
    seals = strays.seals(len(net.spline_points[0]))
    for part in net.splines:
        spline = curve.splines.new(part.kind)
        if part.kind == 'BEZIER':
            last = first + 3 * part.count
            spline.resolution_u = _SHOWN
            _fill_bezier(spline, part, net.single[first:last].reshape(-1, 3, 3), letters[first:last].reshape(-1, 3))
        else:
            last = first + part.count
            spline.points.add(part.count - 1)
            rows = np.column_stack([net.single[first:last], net.single_weights[first:last]])
            spline.points.foreach_set('co', rows.ravel())
        spline.use_cyclic_u = part.closed
        numbers = np.arange(number, number + part.count)
        _points_of(spline).foreach_set('tilt', numbers.astype(np.float32))
        _points_of(spline).foreach_set('radius', seals[numbers])
        first, number = last, number + part.count
    curve.update_tag()
    return curve


def _fill_bezier(spline, part, triples, letters):
    spline.bezier_points.add(part.count - 1)
    for point, pair in zip(spline.bezier_points, letters[:, ::2]):
        _set_types(point, pair)
    for i, name in enumerate(_HANDLES):
        spline.bezier_points.foreach_set(name, np.ascontiguousarray(triples[:, i]).ravel())


def _points_of(spline):
    return spline.bezier_points if spline.type == 'BEZIER' else spline.points


def present(curve, net):
    """The Present points and handles of a Curve that was made of a net."""
    seals = strays.seals(len(net.spline_points[0]), net.first)
    vertices = np.concatenate([np.empty(0, np.int64), *(_numbered(spline, net, seals) for spline in curve.splines)])
    rows = np.concatenate([np.empty((0, 4), np.float32), *map(_rows, curve.splines)])
    types = letters(curve)
    return Present(vertices, lambda: rows[:, :3], lambda: rows[:, 3], lambda: _links(curve), _void(curve, net, vertices, types),
                   np.isin(types, _COMPUTED))


def letters(curve):
    """(m,) by slot: of handles the letters of their types, "" of points."""
    found = [np.empty(0, '<U1')]
    for spline in curve.splines:
        own = np.zeros((len(_points_of(spline)), 3 if spline.type == 'BEZIER' else 1), '<U1')
        if spline.type == 'BEZIER':
            own[:, ::2] = [_types(point) for point in spline.bezier_points]
        found.append(own.ravel())
    return np.concatenate(found)


def letters_of(curve, slots):
    """The letters of the types of the handles with these slots, each once."""
    found, first = set(), 0
    for spline in curve.splines:
        last = first + (3 if spline.type == 'BEZIER' else 1) * len(_points_of(spline))
        for slot in slots:
            if spline.type == 'BEZIER' and first <= slot < last:
                found.add(_types(spline.bezier_points[(slot - first) // 3])[(slot - first) % 3 // 2])
        first = last
    return found


def _void(curve, net, vertices, types):
    """(m,) bool: handles of which Blender alone decided where they are: those that lead to points that are new, and of points
    whose neighbors are others those that it computes. None where there are none."""
    void, first = np.zeros(len(vertices), bool), 0
    for spline in curve.splines:
        last = first + (3 if spline.type == 'BEZIER' else 1) * len(_points_of(spline))
        if spline.type == 'BEZIER':
            own, points = vertices[first:last].reshape(-1, 3), void[first:last].reshape(-1, 3)
            tilts = _values(spline.bezier_points, 'tilt', 1)[:, 0]
            is_new = (own[:, 1] < 0) & (tilts != _STRAY)
            before, after = np.roll(is_new, 1), np.roll(is_new, -1)
            if not spline.use_cyclic_u:
                before[:1] = after[-1:] = False
            points[:, 0], points[:, 2] = before, after
            has_others = before | after | _has_lost(net, own[:, 1], spline.use_cyclic_u)
            points |= has_others[:, None] & np.isin(types[first:last].reshape(-1, 3), (handles.AUTO, handles.VECTOR))
        first = last
    return void if void.any() else None


def _has_lost(net, vertices, is_closed):
    """(k,) bool: which points of a spline, by their vertices, had a neighbor in the net that is not beside them now."""
    beside = np.stack([np.roll(vertices, 1), np.roll(vertices, -1)])
    if not is_closed:
        beside[0, :1] = beside[1, -1:] = -1
    lost = np.zeros(len(vertices), bool)
    for first, spline in net.chains:
        last = first + 3 * spline.count
        for step in (-3, 3):
            wanted = vertices + step
            if spline.closed:
                wanted = first + (wanted - first) % (last - first)
            had = (vertices >= first) & (vertices < last) & (wanted >= first) & (wanted < last)
            lost |= had & ~(beside == wanted).any(0)
    return lost


def _numbered(spline, net, seals):
    """The vertices of the net that the points and handles of a spline carry, -1 for none."""
    is_bezier = spline.type == 'BEZIER'
    first = net.spline_points[0]
    numbers, turned = _point_numbers(spline, net, seals)
    known = numbers >= 0
    vertices = np.full((len(numbers), 3 if is_bezier else 1), -1)
    vertices[known] = first[numbers[known], None]
    if is_bezier:                       # switching the direction turns tilts over, and exchanges the handles
        vertices[known] += np.where(turned[known, None], (2, 1, 0), (0, 1, 2))
    return vertices.ravel()


def _point_numbers(spline, net, seals):
    """(the points of the net that those of a spline carry the numbers of, -1 for none; whether each was turned over)."""
    tilts, radii = (_values(_points_of(spline), name, 1)[:, 0] for name in ('tilt', 'radius'))
    whole = np.isfinite(tilts) & (tilts == np.rint(tilts))
    numbers = strays.of_net(np.where(whole, np.abs(tilts) - net.first, -1).astype(np.int64), radii, seals)
    for i in np.flatnonzero((numbers < 0) & whole & (np.abs(tilts) < net.first)):
        same = np.flatnonzero(seals == radii[i])        # a drag brings back the tilt that its points had when it began
        numbers[i] = same[0] if len(same) == 1 else -1
    known = numbers >= 0
    are_bezier = net.spline_points[1]
    known[known] = are_bezier[numbers[known]] == (spline.type == 'BEZIER')      # otherwise it is of another type now
    return np.where(known, numbers, -1), np.signbit(tilts)


def carried(curve):
    """(n,) the numbers that the points of a net carry, whatever they stand for; those of strays among them."""
    tilts = np.concatenate([np.empty(0, np.float32), *(_values(_points_of(spline), 'tilt', 1)[:, 0]
                                                       for spline in curve.splines)])
    return np.abs(tilts[np.isfinite(tilts)]).astype(np.int64)


def everything(curve):
    """Bytes of all that a net says."""
    for spline in curve.splines:
        yield f"{spline.type} {spline.use_cyclic_u} {len(_points_of(spline))}".encode()
        yield _rows(spline).tobytes()
        for name in ('tilt', 'radius'):
            yield _values(_points_of(spline), name, 1).tobytes()


def runs(curve, net, found):
    """A core.net.grown.Run for each spline. found: (n,) of each vertex of the net the slot of its point, or -1."""
    seals, owned, result, slot = strays.seals(len(net.spline_points[0]), net.first), set(found.tolist()), [], 0
    for spline in curve.splines:
        is_bezier = spline.type == 'BEZIER'
        numbers, turned = _point_numbers(spline, net, seals)
        step = 3 if is_bezier else 1
        slots = slot + step * np.arange(len(numbers)) + is_bezier       # of a Bezier point itself
        slot += step * len(numbers)
        own = np.array([each in owned for each in slots.tolist()], bool)
        rows = _rows(spline)
        positions = rows[:, :3].reshape(-1, 3, 3) if is_bezier else rows[:, :3]
        numbers = np.where(own | (numbers < 0), numbers, copy_of(numbers))
        numbers[_values(_points_of(spline), 'tilt', 1)[:, 0] == _STRAY] = STRAY
        result.append(Run(numbers, positions, rows[::step, 3],
                          bool(spline.use_cyclic_u), turned))
    return result


def renumber(curve, net, numbers, runs):
    """Let the points of a Curve be those of a net, where they are: numbers of each spline's points there, -1 for none,
    and smaller ones for copies; runs: runs() of it."""
    seals = strays.seals(len(net.spline_points[0]), net.first)
    for spline, own, over in zip(curve.splines, numbers, (run.is_turned for run in runs)):
        points = _points_of(spline)
        carried = np.where(own == STRAY, -1, np.where(own < -1, copy_of(own), own))
        tilts = (np.maximum(carried, 0) + net.first).astype(np.float32)
        points.foreach_set('tilt', np.where(own == STRAY, _STRAY, -tilts if over else tilts))
        points.foreach_set('radius', np.where(carried < 0, 1, seals[np.maximum(carried, 0)]).astype(np.float32))
    curve.update_tag()


def place(curve, net, numbers, runs, new):
    """Put the points of a Curve to where a net has them; as of renumber(). new: points that had no handles before. Types of
    handles that are not true there are others then."""
    first, letters = net.spline_points[0], _letters_there(curve, net, numbers, runs, new)
    for spline, own, over in zip(curve.splines, numbers, (run.is_turned for run in runs)):
        points = _points_of(spline)
        there = np.flatnonzero(own >= 0).tolist()
        if spline.type == 'BEZIER':
            vertices = first[own[there]][:, None] + ((2, 1, 0) if over else (0, 1, 2))
            _place_triples(points, there, net.single[vertices], letters[vertices[:, ::2]].tolist())
            continue
        for i in there:
            vertex = int(first[own[i]])
            if not np.array_equal(points[i].co, (*net.single[vertex], net.single_weights[vertex])):
                points[i].co = (*net.single[vertex], net.single_weights[vertex])
    curve.update_tag()


def _letters_there(curve, net, numbers, runs, new):
    """core.net.handles.of_net() of the types that the points of a Curve have."""
    first, letters = net.spline_points[0], np.full(len(net.rows), '', '<U1')
    for spline, own, over in zip(curve.splines, numbers, (run.is_turned for run in runs)):
        if spline.type == 'BEZIER':
            for i in np.flatnonzero(own >= 0).tolist():
                if own[i] not in new:
                    letters[first[own[i]]:first[own[i]] + 3:2] = _types(spline.bezier_points[i])[::-1 if over else 1]
    return handles.true_of_net(net, letters)


def _types(point):
    return handles.LETTERS[point.handle_left_type], handles.LETTERS[point.handle_right_type]


def _set_types(point, letters):
    """Blender computes all handles of the spline again where one is given another type."""
    for name, now, letter in zip(('handle_left_type', 'handle_right_type'), _types(point), letters):
        if letter != now:
            setattr(point, name, handles.NAMES[letter])


def _place_triples(points, numbers, triples, types):
    """Put Bezier points with these numbers to triples (k, 3, 3), and give their handles these types, pairs of letters."""
    others = []
    for i, triple, pair in zip(numbers, triples, types):
        if list(_types(points[i])) != pair or not all(
                np.array_equal(getattr(points[i], name), row) for name, row in zip(_HANDLES, triple)):
            others.append((points[i], triple, pair))
            _set_types(points[i], (handles.FREE,) * 2)
    for point, triple, _ in others:
        for name, row in zip(_HANDLES, triple):
            setattr(point, name, row)
    for point, _, pair in others:
        _set_types(point, pair)


def _rows(spline):
    """(k, 4) float32: the positions of a spline and their weights."""
    if spline.type != 'BEZIER':
        return _values(spline.points, 'co', 4)
    triples = np.stack([_values(spline.bezier_points, name, 3) for name in _HANDLES], 1)
    return np.column_stack([triples.reshape(-1, 3), np.ones(3 * len(triples), np.float32)])


def _values(points, name, width):
    flat = np.empty(width * len(points), np.float32)
    points.foreach_get(name, flat)
    return flat.reshape(-1, width)


def _links(curve):
    pairs, first = [np.empty((0, 2), np.int64)], 0
    for spline in curve.splines:
        step = 3 if spline.type == 'BEZIER' else 1
        last = first + step * len(_points_of(spline))
        before = np.arange(first, last)
        after = before + step
        if spline.use_cyclic_u and last > first:
            after = first + (after - first) % (last - first)
        pairs.append(np.stack([before, after], -1)[after < last])
        first = last
    return np.concatenate(pairs)


def flags(curve):
    """(m,) bool: the selection, by its slot."""
    found = [np.empty(0, bool)]
    for spline in curve.splines:
        columns = []
        for name in _FLAGS if spline.type == 'BEZIER' else ('select',):
            columns.append(np.empty(len(_points_of(spline)), bool))
            _points_of(spline).foreach_get(name, columns[-1])
        found.append(np.stack(columns, -1).ravel())
    return np.concatenate(found)


def set_flags(curve, chosen):
    """Select what has a slot where chosen (m,) is True."""
    first = 0
    for spline in curve.splines:
        names = _FLAGS if spline.type == 'BEZIER' else ('select',)
        last = first + len(names) * len(_points_of(spline))
        for name, column in zip(names, chosen[first:last].reshape(-1, len(names)).T):
            _points_of(spline).foreach_set(name, np.ascontiguousarray(column))
        first = last
    curve.update_tag()


def move(curve, rows):
    """Give points and handles positions and weights. rows: x, y, z, w by the slot of each. A point takes its handles along;
    those that are computed from their neighbors are computed, and are so no more where they are given places."""
    first = 0
    for spline in curve.splines:
        points, is_bezier = _points_of(spline), spline.type == 'BEZIER'
        step = 3 if is_bezier else 1
        own = {slot - first: row for slot, row in rows.items() if first <= slot < first + step * len(points)}
        if is_bezier:
            _move_triples(points, own)
        else:
            for i, row in own.items():
                points[i].co = row
        first += step * len(points)
    curve.update_tag()


def _move_triples(points, rows):
    """move() of Bezier points."""
    numbers, triples, types = sorted({slot // 3 for slot in rows}), [], []
    for i in numbers:
        given = {part: np.array(rows[3 * i + part][:3]) for part in range(3) if 3 * i + part in rows}
        triple, pair = handles.moved(np.array([getattr(points[i], name) for name in _HANDLES], np.float64),
                                     _types(points[i]), given)
        triples.append(triple)
        types.append(list(pair))
    _place_triples(points, numbers, triples, types)


def give_letters(curve, types):
    """Let the handles of a Curve have types by slot, as of letters()."""
    first = 0
    for spline in curve.splines:
        count = len(_points_of(spline))
        if spline.type == 'BEZIER':
            for point, pair in zip(spline.bezier_points, types[first:first + 3 * count].reshape(-1, 3)[:, ::2]):
                _set_types(point, pair)
        first += (3 if spline.type == 'BEZIER' else 1) * count
    curve.update_tag()
