"""The exact mathematics of one shape: pieces on one pool of points.

A piece names rows of the pool. Points are (x, y, z, w) as given; tangents and twists of Hermite
pieces are rows with w = 0. Everything is float64 and survives a round trip bit for bit.
"""

import json
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from ..base.failures import Refusal, WrongKind
from ..base.library import sc

CURVES = (sc.BezierCurve, sc.HermiteCurve, sc.NurbsCurve)
#: What from_value() takes: a power curve is kept as the NURBS curve that it is.
ANY_CURVES = (*CURVES, sc.PowerCurve)
PATCHES = (sc.BezierPatch, sc.HermitePatch, sc.NurbsPatch)


@dataclass(frozen=True)
class Piece:
    """One curve or patch. Curves have one axis, patches two."""

    kind: str                       # 'bezier', 'hermite' or 'nurbs'
    indices: np.ndarray             # int32; curves (n,) or (3, n), patches (nu, nv) or (4, nu, nv)
    degree: tuple = ()              # NURBS: of each axis
    periodic: tuple = ()            # NURBS: of each axis
    knots: tuple = ()               # NURBS: knots, Hermite: parameters, of each axis
    name: str = ""                  # what it is in a picture, for example the function N_{0,3}

    @cached_property
    def layout(self):
        """What it is beside its numbers, and how many it has of them, as JSON."""
        name = {'name': self.name} if self.name else {}
        return json.dumps({'kind': self.kind, 'shape': list(self.indices.shape), 'degree': list(self.degree),
                           'periodic': [bool(p) for p in self.periodic], 'knots': [len(k) for k in self.knots], **name})

    def require_consistent(self, axes, pool_size):
        """Raises Refusal unless the counts of a piece with this number of axes fit each other and the pool."""
        if type(self.name) is not str:
            raise Refusal("the name of a piece is not a text")
        if self.kind not in ('bezier', 'hermite', 'nurbs'):
            raise Refusal("'{kind}' is no kind of piece", kind=self.kind)
        nets = () if self.kind != 'hermite' else (3,) if axes == 1 else (4,)
        counts = self.indices.shape[len(nets):]
        if self.indices.shape[:len(nets)] != nets or len(counts) != axes:
            raise Refusal("a piece has points of shape {shape}", shape=self.indices.shape)
        if self.indices.size == 0 or self.indices.min() < 0 or self.indices.max() >= pool_size:
            raise Refusal("a piece names points that are not there")
        if self.kind == 'nurbs':
            self._require_knots(counts)
        elif self.degree or self.periodic or [len(k) for k in self.knots] != (list(counts) if nets else []):
            raise Refusal("a piece has degrees or knots that its kind has not")

    def _require_knots(self, counts):
        if not all(type(p) is bool for p in self.periodic) or not all(type(d) is int and d > 0 for d in self.degree):
            raise Refusal("a piece has a degree or a period that is none")
        expected = [count + 1 if periodic else count + degree + 1
                    for count, degree, periodic in zip(counts, self.degree, self.periodic)]
        if len(self.degree) != len(counts) or [len(k) for k in self.knots] != expected:
            raise Refusal("the knots of a piece do not fit its points")


@dataclass(frozen=True)
class Definition:
    """What a shape is. `form` says what value it came from: 'curve', 'curves', 'patch', 'patch_set'."""

    form: str
    pool: np.ndarray                # (n, 4) float64
    pieces: tuple = field(default=())

    @property
    def has_curves(self):
        return self.form in ('curve', 'curves')

    @property
    def size(self):
        """The diagonal of the box around the points that are finite."""
        finite = self.pool[self.pool[:, 3] != 0, :3]
        return float(np.linalg.norm(np.ptp(finite, axis=0))) if len(finite) else 0.0

    @property
    def spread(self):
        """How far the points that are finite lie from their middle, in square mean; never 0."""
        finite = self.pool[self.pool[:, 3] != 0, :3]
        return max(float(np.sqrt(((finite - finite.mean(axis=0)) ** 2).sum(axis=1).mean())), np.finfo(float).tiny)

    @property
    def runs_to_infinity(self):
        """Whether it may: curves with weights that are not all above 0."""
        used = [piece.indices.ravel() for piece in self.pieces if piece.kind != 'hermite']
        return self.has_curves and bool(used) and bool((self.pool[np.concatenate(used), 3] <= 0).any())

    def is_near(self, other, share):
        """Whether another one has the same pieces on points and knots that differ by a share of their size at most."""
        def structure(each):
            return each.form, each.pool.shape, [(piece.layout, piece.indices.tobytes()) for piece in each.pieces]

        def knots(each):
            return [knots for piece in each.pieces for knots in piece.knots]
        return (structure(self) == structure(other)
                and all(np.abs(a - b).max() <= share * np.ptp(b) for a, b in zip(knots(self), knots(other)))
                and np.abs(self.pool - other.pool).max() <= share * max(other.size, np.abs(other.pool).max()))

    def require_consistent(self):
        """Raises Refusal or TypeError unless this could have come from a value."""
        if self.form not in ('curve', 'curves', 'patch', 'patch_set') or not self.pieces:
            raise Refusal("its form is '{form}' with {count} pieces",
                          "its form is '{form}' with {count} piece", form=self.form, count=len(self.pieces))
        if self.form in ('curve', 'patch') and len(self.pieces) != 1:
            raise Refusal("it is one curve with {count} pieces" if self.form == 'curve' else "it is one patch with {count} pieces",
                          count=len(self.pieces))
        if not np.isfinite(self.pool).all() or not self.pool[:, 3].any():
            raise Refusal("its points are not finite")
        for piece in self.pieces:
            piece.require_consistent(1 if self.has_curves else 2, len(self.pool))


def from_value(value):
    """The definition of a splinecore value: a curve, a list of curves, a patch or a PatchSet."""
    if isinstance(value, ANY_CURVES):
        return _from_curves('curve', [_kept(value)])
    if isinstance(value, PATCHES):
        return _from_patch_set('patch', sc.PatchSet.from_patches([value], merge=False))
    if isinstance(value, sc.PatchSet):
        return _from_patch_set('patch_set', value)
    if isinstance(value, (list, tuple)):
        for i, item in enumerate(value):
            if not isinstance(item, ANY_CURVES):
                raise WrongKind("value[{i}] is a {name}, a list holds curves only", i=i, name=type(item).__name__)
        if not value:
            raise Refusal("value is an empty list: a shape needs one curve or more")
        return _from_curves('curves', list(map(_kept, value)))
    raise WrongKind("value is of type {name}: a curve, a list of curves, a patch or a PatchSet is expected",
                    name=type(value).__name__)


def named(definition, names):
    """A definition with other names of its pieces."""
    return replace(definition, pieces=tuple(replace(piece, name=name) for piece, name in zip(definition.pieces, names, strict=True)))


def with_names_of(definition, before):
    """A definition with the names of the pieces of another one: in their order where there are as many, else of pieces that are equal."""
    if len(definition.pieces) == len(before.pieces):
        return named(definition, [piece.name for piece in before.pieces])
    known = {}
    for piece in before.pieces:
        known.setdefault(_bits(before, piece), []).append(piece.name)
    found = (known.get(_bits(definition, piece)) for piece in definition.pieces)
    return named(definition, [names.pop(0) if names else "" for names in found])


def _bits(definition, piece):
    """What two pieces have in common that are equal."""
    plain = replace(piece, name="")
    return plain.layout, definition.pool[piece.indices].tobytes(), *(np.asarray(knots).tobytes() for knots in piece.knots)


def _kept(curve):
    return curve.to_nurbs() if isinstance(curve, sc.PowerCurve) else curve


def to_value(definition):
    """The splinecore value that from_value() was given."""
    if definition.has_curves:
        curves = [_curve(definition.pool, piece) for piece in definition.pieces]
        return curves[0] if definition.form == 'curve' else curves
    patch_set = to_patch_set(definition)
    return patch_set[0] if definition.form == 'patch' else patch_set


def are_same(one, other):
    """Whether two definitions agree in every number."""
    return np.array_equal(one.pool, other.pool) and have_same_pieces(one, other)


def have_same_pieces(one, other):
    """Whether two definitions agree in all but where their points are."""
    return one.form == other.form and len(one.pieces) == len(other.pieces) and all(
        a.kind == b.kind and a.name == b.name and a.degree == b.degree and a.periodic == b.periodic and np.array_equal(a.indices, b.indices)
        and len(a.knots) == len(b.knots) and all(map(np.array_equal, a.knots, b.knots))
        for a, b in zip(one.pieces, other.pieces))


def to_patch_set(definition):
    """The patches of a definition as one PatchSet, also where it is a single patch."""
    patches = []
    for piece in definition.pieces:
        fields = {'kind': piece.kind, 'indices': piece.indices}
        if piece.kind == 'nurbs':
            fields.update(degree=piece.degree, periodic=piece.periodic, knots=piece.knots)
        elif piece.kind == 'hermite':
            fields.update(parameters=piece.knots)
        patches.append(fields)
    return sc.PatchSet(definition.pool[:, :3], patches, definition.pool[:, 3])


def _from_patch_set(form, patch_set):
    pieces = tuple(
        Piece(kind=patch['kind'], indices=patch['indices'], degree=patch.get('degree', ()),
              periodic=patch.get('periodic', ()),
              knots=tuple(patch.get('knots', patch.get('parameters', ()))))
        for patch in patch_set.patches)
    return Definition(form, np.column_stack([patch_set.points, patch_set.weights]), pieces)


def _from_curves(form, curves):
    pool, pieces, count = [], [], 0
    for curve in curves:
        rows, piece = _from_curve(curve, count)
        pool.append(rows)
        pieces.append(piece)
        count += len(rows)
    return Definition(form, np.concatenate(pool), tuple(pieces))


def _from_curve(curve, first):
    """The rows that a curve adds to the pool, and its piece, whose indices start at `first`.

    What must stay equal when it is edited is one row: the ends of a closed curve, and both
    tangents of a smooth joint.
    """
    if isinstance(curve, sc.HermiteCurve):
        return _from_hermite(curve, first)
    rows = np.column_stack([curve.points, curve.weights])
    rows, indices = _shared(rows, np.arange(len(rows)), [(-1, 0)] if _touches_ends(curve) else [])
    indices = (first + indices).astype(np.int32)
    if isinstance(curve, sc.BezierCurve):
        return rows, Piece('bezier', indices)
    return rows, Piece('nurbs', indices, (curve.degree,), (curve.periodic,), (np.array(curve.knots),))


def _touches_ends(curve):
    """Whether a Bezier or NURBS curve begins and ends in its outer points."""
    if isinstance(curve, sc.BezierCurve):
        return True
    knots, degree = curve.knots, curve.degree
    return not curve.periodic and knots[0] == knots[degree] and knots[-1] == knots[-1 - degree]


def _from_hermite(curve, first):
    count = len(curve.points)
    incoming, outgoing = curve.tangents[:, 0], curve.tangents[:, 1]
    none = np.zeros(count)
    rows = np.concatenate([np.column_stack([curve.points, np.ones(count)]),
                           np.column_stack([incoming, none]), np.column_stack([outgoing, none])])
    indices = np.arange(3 * count)
    pairs = [(count + i, 2 * count + i) for i in range(count)]
    if _equal(rows[0], rows[count - 1]):
        pairs += [(count - 1, 0), (2 * count - 1, count), (3 * count - 1, 2 * count)]
    rows, indices = _shared(rows, indices, pairs)
    indices = (first + indices.reshape(3, count)).astype(np.int32)
    return rows, Piece('hermite', indices, knots=(np.array(curve.parameters),))


def _shared(rows, indices, pairs):
    """The rows in use, and the indices, where the rows of each pair became one if they are equal."""
    for later, earlier in pairs:
        if _equal(rows[indices[later]], rows[indices[earlier]]):
            indices[indices == indices[later]] = indices[earlier]
    used, indices = np.unique(indices, return_inverse=True)
    return rows[used], indices


def _equal(a, b):
    """In every bit: zeros of both signs differ."""
    return a.tobytes() == b.tobytes()


def _curve(pool, piece):
    rows = pool[piece.indices]
    if piece.kind == 'hermite':
        return sc.HermiteCurve(rows[0, :, :3], np.stack([rows[1, :, :3], rows[2, :, :3]], 1), piece.knots[0])
    if piece.kind == 'bezier':
        return sc.BezierCurve(rows[:, :3], rows[:, 3])
    return sc.NurbsCurve(piece.degree[0], piece.knots[0], rows[:, :3], rows[:, 3], piece.periodic[0])
