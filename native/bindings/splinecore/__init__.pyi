"""Exact NURBS, Bezier and Hermite curves and patches on a native library."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, SupportsIndex, TypedDict, TypeVar, final

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import basis, bpt, build, conics, fit, meshes, plot

__all__ = [
    "Approximation",
    "BezierCurve",
    "BezierPatch",
    "Cancelled",
    "Continuity",
    "Curvatures",
    "Error",
    "Filling",
    "Formula",
    "FormulaError",
    "HermiteCurve",
    "HermitePatch",
    "Intersections",
    "InvalidShape",
    "JoinedPatches",
    "LeastDistance",
    "LoftSurface",
    "Nearest",
    "NearestAmong",
    "NetworkSurface",
    "NurbsCurve",
    "NurbsPatch",
    "PatchIntersections",
    "PatchSet",
    "PointAtInfinity",
    "PowerCurve",
    "RayHits",
    "Region",
    "RoundedEdge",
    "SeamContinuity",
    "Sections",
    "StationaryPoints",
    "SubdivisionPatches",
    "Tessellation",
    "ToleranceNotReached",
    "basis",
    "bpt",
    "build",
    "conics",
    "dumps",
    "fit",
    "loads",
    "meshes",
    "nearest",
    "plot",
    "seam_continuity",
]

__version__: str
__instruction_set__: str

_Side = Literal["left", "right"]
_Sides = _Side | tuple[_Side, _Side]
_AtInfinity = Literal["raise", "nan"]
_Axis = Literal["u", "v"]
_Border = Literal["u_start", "u_end", "v_start", "v_end"]
_PatchSmoothness = Literal["C0", "G1", "C1", "G2", "C2"]
_Smoothness = Literal["C0", "G1", "C1", "C2"]
_Pair = Sequence[SupportsIndex]
_Knots = Sequence[ArrayLike]
_Cancel = Callable[[], object]
_Extension = Literal["natural", "arc", "straight"]
_Interval = tuple[float, float]
_Floats = NDArray[np.float64]
_Curve = NurbsCurve | BezierCurve | HermiteCurve | PowerCurve
_Patch = NurbsPatch | BezierPatch | HermitePatch
_Points = NDArray[Any]  # float64, or float32 where dtype or out ask for it

class Error(Exception):
    """Base class of all exceptions raised by the library.

    Examples
    --------
    >>> try:
    ...     sc.loads("no shape")
    ... except sc.Error as error:
    ...     print(type(error).__name__)
    InvalidShape
    """

class InvalidShape(Error, ValueError):
    """Bad input: the message names the argument, the first offending index and its value.

    Examples
    --------
    >>> try:
    ...     sc.BezierCurve([(0, 0)], weights=[1, 2])
    ... except sc.InvalidShape as error:
    ...     print(isinstance(error, ValueError))
    True
    """

class FormulaError(InvalidShape):
    """Text that is not a formula: the message ends with the place, and `position` is the character, counted
    from 0.

    Examples
    --------
    >>> try:
    ...     sc.Formula("2 * sin(")
    ... except sc.FormulaError as error:
    ...     print(error.position)
    8
    """

    position: int

class PointAtInfinity(Error, ArithmeticError):
    """A point was asked for where the homogeneous weight is zero.

    Examples
    --------
    >>> line = sc.BezierCurve([(0, 0), (1, 0)], weights=[1, 0])
    >>> try:
    ...     line.evaluate(1.0)
    ... except sc.PointAtInfinity as error:
    ...     print(isinstance(error, ArithmeticError))
    True
    >>> line.evaluate(1.0, at_infinity="nan")
    array([nan, nan, nan])
    """

class ToleranceNotReached(Error, ArithmeticError):
    """The tolerance cannot be reached: the message says which error can.

    Examples
    --------
    >>> curve = sc.BezierCurve([(0, 0), (1, 1), (2, 0)])
    >>> try:
    ...     curve.reduce(tolerance=0.1)
    ... except sc.ToleranceNotReached as error:
    ...     print(isinstance(error, ArithmeticError))
    True
    """

class Cancelled(Error, RuntimeError):
    """A long call was ended by its `cancel` argument.

    Examples
    --------
    >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
    >>> try:
    ...     curve.evaluate(np.linspace(0, 1, 1_000_000), cancel=lambda: True)
    ... except sc.Cancelled:
    ...     print("ended")
    ended
    """

@final
class Continuity:
    """The continuity of a curve where two of its pieces, or two curves, meet.

    References
    ----------
    Lecture row S16.

    Examples
    --------
    >>> a = sc.BezierCurve([(0, 0), (1, 0)])
    >>> b = sc.BezierCurve([(1, 0), (1, 1)])
    >>> joint = a.continuity_to(b)
    >>> joint.gap, round(joint.angle / np.pi, 9), joint.curvature_difference, joint.c, joint.g
    (0.0, 0.5, 0.0, 0, 0)
    """

    @property
    def gap(self) -> float:
        """Distance of the ends, a length."""
    @property
    def angle(self) -> float:
        """Angle between the tangents, in radians, 0 to pi."""
    @property
    def curvature_difference(self) -> float:
        """Length of the difference of both curvature vectors, in 1 / length."""
    @property
    def c(self) -> int:
        """Number of derivatives that agree: -1 for a gap, the degree where there is no joint."""
    @property
    def g(self) -> int:
        """Geometric continuity: -1 for a gap, 0, 1, 2, or `c` where that is more."""
    def __copy__(self) -> Continuity: ...
    def __deepcopy__(self, memo: object, /) -> Continuity: ...

@final
class Filling:
    """The patches that fill a hole, and how well they continue its sides.

    References
    ----------
    Lecture row S21.

    Examples
    --------
    >>> corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    >>> filling = sc.build.fill([sc.BezierCurve([corners[i - 1], corners[i]]) for i in range(4)])
    >>> len(filling.patches), filling.gap < 1e-12
    (1, True)
    >>> filling.angle, filling.curvature_difference, filling.inner_angle
    (0.0, 0.0, 0.0)
    """

    @property
    def patches(self) -> tuple[NurbsPatch, ...]:
        """The patches."""
    @property
    def gap(self) -> float:
        """Largest distance from a side, a length."""
    @property
    def angle(self) -> float:
        """Largest angle between tangent planes along neighbors with 'G1' and 'G2', in radians."""
    @property
    def curvature_difference(self) -> float:
        """Largest difference of normal curvatures across neighbors with 'G2', in 1 / length."""
    @property
    def inner_angle(self) -> float:
        """Largest angle between tangent planes of two patches of the filling, in radians."""
    def __copy__(self) -> Filling: ...
    def __deepcopy__(self, memo: object, /) -> Filling: ...

@final
class SubdivisionPatches:
    """Patches of a subdivision surface, one for each face of the subdivided mesh, in its order.

    Examples
    --------
    >>> points = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> cube = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    >>> made = sc.build.catmull_clark(points, cube)
    >>> len(made.patches), made.rounds, made.irregular, made.angle < 0.1
    (24, 1, 24, True)
    """

    @property
    def patches(self) -> tuple[NurbsPatch, ...]:
        """The patches."""
    @property
    def rounds(self) -> int:
        """How often the mesh was subdivided."""
    @property
    def irregular(self) -> int:
        """Number of patches beside extraordinary points; these are not exactly the surface."""
    @property
    def angle(self) -> float:
        """Largest angle between tangent planes across a side of one of those, in radians."""
    def __copy__(self) -> SubdivisionPatches: ...
    def __deepcopy__(self, memo: object, /) -> SubdivisionPatches: ...

@final
class LoftSurface(tuple[NurbsPatch, float]):
    """The surface through sections, and how far sections were moved.

    Unpacks as `value, error = …`.

    Examples
    --------
    >>> sections = [sc.BezierCurve([(0, 0, z), (1, 0, z)]) for z in (0, 2)]
    >>> surface, error = sc.build.loft(sections, degree=1)
    >>> round(surface.area(), 9), error
    (2.0, 0.0)
    """

    @property
    def value(self) -> NurbsPatch:
        """The surface.

        Examples
        --------
        >>> sections = [sc.BezierCurve([(0, 0, z), (1, 0, z)]) for z in (0, 2)]
        >>> sc.build.loft(sections, degree=1).value
        NurbsPatch(degree=(1, 1), points=(2, 2))
        """
    @property
    def error(self) -> float:
        """The error, a length in units of the points; 0 where nothing but rounding was lost.

        Examples
        --------
        >>> round(sc.BezierCurve([(0, 0), (1, 1), (2, 0)]).reduce().error, 9)
        0.5
        """
    @property
    def followed(self) -> float:
        """The part of their strengths with which the surface follows its neighbors: less than 1 where it would
        have swung out.

        Examples
        --------
        >>> sections = [sc.BezierCurve([(0, 0, z), (1, 0, z)]) for z in (0, 2)]
        >>> sc.build.loft(sections, degree=1).followed
        1.0
        """
    def __copy__(self) -> LoftSurface: ...
    def __deepcopy__(self, memo: object, /) -> LoftSurface: ...

@final
class NetworkSurface(tuple[NurbsPatch, float]):
    """The surface through a network of curves, and the largest distance from a curve.

    Unpacks as `value, error = …`.

    Examples
    --------
    >>> along_u = [sc.BezierCurve([(0, y, 0), (1, y, 0)]) for y in (0, 2)]
    >>> along_v = [sc.BezierCurve([(x, 0, 0), (x, 2, 0)]) for x in (0, 1)]
    >>> made = sc.build.network(along_u, along_v)
    >>> round(made.value.area(), 9), made.error < 1e-12, max(made.paces) < 1e-12
    (2.0, True, True)
    """

    @property
    def value(self) -> NurbsPatch:
        """The surface.

        Examples
        --------
        >>> sections = [sc.BezierCurve([(0, 0, z), (1, 0, z)]) for z in (0, 2)]
        >>> sc.build.loft(sections, degree=1).value
        NurbsPatch(degree=(1, 1), points=(2, 2))
        """
    @property
    def error(self) -> float:
        """The largest distance from a curve, a length."""
    @property
    def paces(self) -> tuple[float | None, float | None, float | None, float | None]:
        """Distances of the sides u_start, u_end, v_start and v_end from the outermost curves at the same share
        of their parameters.

        Lengths, 0 but for rounding where a side shares the parameters of its curve; None where a direction is
        closed.
        """
    def __copy__(self) -> NetworkSurface: ...
    def __deepcopy__(self, memo: object, /) -> NetworkSurface: ...

@final
class RoundedEdge:
    """What replaces the edge of two patches: the rest of both, and the fillet between them.

    Examples
    --------
    >>> floor = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 3, 0))
    >>> wall = sc.build.plane((0, 0, 0), (0, 3, 0), (0, 0, 2))
    >>> edge = sc.build.fillet_patches(floor, "u_start", wall, "v_start", 0.5)
    >>> [round(patch.area(), 6) for patch in (edge.first, edge.fillet, edge.second)], edge.error < 1e-5
    ([4.5, 2.356194, 4.5], True)
    """

    @property
    def first(self) -> NurbsPatch:
        """The rest of the first patch."""
    @property
    def fillet(self) -> NurbsPatch:
        """The fillet."""
    @property
    def second(self) -> NurbsPatch:
        """The rest of the second patch."""
    @property
    def error(self) -> float:
        """The largest distance, a length, of one of these from where it should be."""
    def __copy__(self) -> RoundedEdge: ...
    def __deepcopy__(self, memo: object, /) -> RoundedEdge: ...

@final
class SeamContinuity:
    """The continuity of two patches across a side of each.

    Numbers are the largest found along the seam; arrays belong to n places along it, NaN where there is
    nothing to measure.

    References
    ----------
    Lecture rows S16, S21.

    Examples
    --------
    >>> a = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
    >>> b = sc.build.plane((1, 0, 0), (2, 0, 0), (0, 1, 0))
    >>> seam = sc.seam_continuity(a, "u_end", b, "u_start")
    >>> seam.gap, seam.angle, seam.curvature_difference, seam.reversed
    (0.0, 0.0, 0.0, False)
    >>> seam.first_difference, seam.second_difference
    (0.5, 0.0)
    >>> seam.c, seam.g      # the second patch is twice as fast
    (0, 2)
    >>> seam.points.shape == (len(seam.parameters), 3)
    True
    >>> [float(part.max()) for part in (seam.gaps, seam.angles, seam.curvature_differences)]
    [0.0, 0.0, 0.0]
    """

    @property
    def gap(self) -> float:
        """Largest distance of both sides, a length."""
    @property
    def angle(self) -> float:
        """Largest angle between tangent planes, in radians: 0 where the second patch continues the first, pi
        where it folds back.
        """
    @property
    def curvature_difference(self) -> float:
        """Largest difference of normal curvatures at right angles to the seam, in 1 / length."""
    @property
    def first_difference(self) -> float:
        """Largest difference of first derivatives across the seam, relative to the largest of them."""
    @property
    def second_difference(self) -> float:
        """Largest difference of second derivatives across the seam, relative to the largest of them."""
    @property
    def c(self) -> int:
        """Number of derivatives across the seam that agree, at most 2; -1 for a gap."""
    @property
    def g(self) -> int:
        """Geometric continuity: -1 for a gap, 0, 1 for tangent planes, 2 for curvatures."""
    @property
    def reversed(self) -> bool:
        """Whether the second side runs against the first one."""
    @property
    def parameters(self) -> _Floats:
        """Parameters (n,) of the places along the first side, in [0, 1]; twice at knots. Read-only."""
    @property
    def points(self) -> _Floats:
        """Points (n, 3) of the places, read-only."""
    @property
    def gaps(self) -> _Floats:
        """Distances (n,), read-only."""
    @property
    def angles(self) -> _Floats:
        """Angles (n,) in radians, read-only."""
    @property
    def curvature_differences(self) -> _Floats:
        """Differences (n,) of normal curvatures, read-only."""
    def __copy__(self) -> SeamContinuity: ...
    def __deepcopy__(self, memo: object, /) -> SeamContinuity: ...

@final
class Curvatures:
    """How patches bend at places (...,), positive towards the normal along S_u x S_v.

    Examples
    --------
    >>> found = sc.build.cylinder((0, 0, 0), (0, 0, 1), 2.0, 1.0).curvatures(0.0, 0.5)
    >>> found.gauss.round(9).item() + 0.0, found.mean.round(9).item(), found.principal.round(9).tolist()
    (0.0, -0.25, [0.0, -0.5])
    >>> abs(found.directions[0]).round(9).tolist()      # straight lines along the axis
    [0.0, 0.0, 1.0]
    """

    @property
    def gauss(self) -> _Floats:
        """Gaussian curvatures (...,), in 1 / length²."""
    @property
    def mean(self) -> _Floats:
        """Mean curvatures (...,), in 1 / length."""
    @property
    def principal(self) -> _Floats:
        """Principal curvatures (..., 2), the larger one first, in 1 / length."""
    @property
    def directions(self) -> _Floats:
        """Principal directions (..., 2, 3): unit vectors at right angles, the second is the normal times the
        first.
        """
    def __copy__(self) -> Curvatures: ...
    def __deepcopy__(self, memo: object, /) -> Curvatures: ...

@final
class Nearest:
    """The nearest points of a shape to given points (..., 3).

    Examples
    --------
    >>> line = sc.BezierCurve([(0, 0), (4, 0)])
    >>> found = line.nearest([(1, 2), (5, 0)])
    >>> found.parameters.tolist(), found.points.tolist(), found.distances.tolist()
    ([0.25, 1.0], [[1.0, 0.0, 0.0], [4.0, 0.0, 0.0]], [2.0, 1.0])
    """

    @property
    def parameters(self) -> _Floats:
        """Parameters (...,) on a curve; (..., 2), u and v, on a patch."""
    @property
    def points(self) -> _Floats:
        """Points (..., 3) of the shape."""
    @property
    def distances(self) -> _Floats:
        """Distances (...,) from the given points."""
    def __copy__(self) -> Nearest: ...
    def __deepcopy__(self, memo: object, /) -> Nearest: ...

@final
class NearestAmong:
    """The nearest points of several shapes to given points (..., 3).

    Examples
    --------
    >>> lines = [sc.BezierCurve([(0, y), (4, y)]) for y in (0, 3)]
    >>> found = sc.nearest(lines, [(1, 1), (2, 4)])
    >>> found.shapes.tolist(), found.parameters.tolist(), found.points.tolist(), found.distances.tolist()
    ([0, 1], [0.25, 0.5], [[1.0, 0.0, 0.0], [2.0, 3.0, 0.0]], [1.0, 1.0])
    """

    @property
    def shapes(self) -> NDArray[np.int64]:
        """Numbers (...,) int64 of the shapes that are nearest, from 0."""
    @property
    def parameters(self) -> _Floats:
        """Parameters (...,) on these curves; (..., 2), u and v, on these patches."""
    @property
    def points(self) -> _Floats:
        """Points (..., 3) of the shapes."""
    @property
    def distances(self) -> _Floats:
        """Distances (...,) from the given points."""
    def __copy__(self) -> NearestAmong: ...
    def __deepcopy__(self, memo: object, /) -> NearestAmong: ...

@final
class Intersections:
    """The n places where two curves meet, and the m stretches that they have in common.

    Examples
    --------
    >>> a = sc.BezierCurve([(0, 0), (4, 0)])
    >>> b = sc.BezierCurve([(1, -1), (1, 3)])
    >>> met = a.intersections(b)
    >>> met.parameters.round(9).tolist(), met.points.round(9).tolist()
    ([[0.25, 0.25]], [[1.0, 0.0, 0.0]])
    >>> met.touches.tolist(), met.distances.round(9).tolist()
    ([False], [0.0])
    >>> met = a.intersections(sc.BezierCurve([(6, 0), (2, 0)]))
    >>> met.overlaps.round(9).tolist(), met.reversed.tolist()
    ([[[0.5, 1.0], [0.5, 1.0]]], [True])
    """

    @property
    def parameters(self) -> _Floats:
        """Parameters (n, 2) on the first and the second curve."""
    @property
    def points(self) -> _Floats:
        """Points (n, 3) in the middle between both curves."""
    @property
    def distances(self) -> _Floats:
        """Distances (n,) of the curves."""
    @property
    def touches(self) -> NDArray[np.bool_]:
        """Whether the tangents are parallel (n,)."""
    @property
    def overlaps(self) -> _Floats:
        """Stretches (m, 2, 2): start and end on the first curve and on the second."""
    @property
    def reversed(self) -> NDArray[np.bool_]:
        """Whether the curves run against each other on a stretch (m,)."""
    def __copy__(self) -> Intersections: ...
    def __deepcopy__(self, memo: object, /) -> Intersections: ...

@final
class LeastDistance:
    """Where two shapes are nearest to each other.

    Examples
    --------
    >>> a = sc.BezierCurve([(0, 0), (4, 0)])
    >>> b = sc.BezierCurve([(1, 2), (1, 5)])
    >>> found = a.least_distance(b)
    >>> round(found.distance, 9), found.patches, found.points.round(9).tolist()
    (2.0, (None, None), [[1.0, 0.0, 0.0], [1.0, 2.0, 0.0]])
    >>> [round(u, 9) for u in found.parameters]
    [0.25, 0.0]
    """

    @property
    def distance(self) -> float:
        """The distance, a length."""
    @property
    def parameters(self) -> tuple[float | tuple[float, float], float | tuple[float, float]]:
        """Of each shape its parameter; of a patch a pair (u, v)."""
    @property
    def patches(self) -> tuple[int | None, int | None]:
        """Of each shape the number of its patch where it is a set, or None."""
    @property
    def points(self) -> _Floats:
        """Points (2, 3), one on each shape."""
    def __copy__(self) -> LeastDistance: ...
    def __deepcopy__(self, memo: object, /) -> LeastDistance: ...

@final
class RayHits:
    """Places where rays meet a shape: arrays (...,) of the shape of the rays for first hits, (n,) for all
    hits.

    Examples
    --------
    >>> ball = sc.build.sphere((0, 0, 0), 1.0)
    >>> met = ball.rays((0, 0.5, -4), (0, 0, 2), hits="all")
    >>> met.rays.tolist(), met.along.round(9).tolist(), met.until.round(9).tolist(), met.touches.tolist()
    ([0, 0], [1.566987298, 2.433012702], [1.566987298, 2.433012702], [False, False])
    >>> met.points.round(9).tolist()
    [[0.0, 0.5, -0.866025404], [0.0, 0.5, 0.866025404]]
    >>> met.parameters.shape, sc.PatchSet.from_patches([ball]).rays((0, 0.5, -4), (0, 0, 2)).patches.tolist()
    ((2, 2), 0)
    """

    @property
    def rays(self) -> NDArray[np.int64]:
        """Number of the ray of each place (...,)."""
    @property
    def along(self) -> _Floats:
        """Where each place lies on its ray (...,): origin + along * direction; NaN where the ray misses."""
    @property
    def until(self) -> _Floats:
        """Where the ray leaves the shape on which it lies (...,); equal to `along` where it only meets it."""
    @property
    def patches(self) -> NDArray[np.int64]:
        """Number of the patch of a set (...,), -1 where a ray misses."""
    @property
    def parameters(self) -> _Floats:
        """Parameters (..., 2): u and v."""
    @property
    def points(self) -> _Floats:
        """Points (..., 3) on the shape."""
    @property
    def touches(self) -> NDArray[np.bool_]:
        """Whether the ray does not pass through the surface (...,)."""
    def __copy__(self) -> RayHits: ...
    def __deepcopy__(self, memo: object, /) -> RayHits: ...

@final
class PatchIntersections:
    """The n places where a curve meets a patch or a plane, and the m stretches that lie on it.

    Examples
    --------
    >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 2, 0))
    >>> met = sc.BezierCurve([(1, 1, -1), (1, 1, 3)]).patch_intersections(plane)
    >>> met.parameters.round(9).tolist(), met.points.round(9).tolist()
    ([[0.25, 0.5, 0.5]], [[1.0, 1.0, 0.0]])
    >>> met.touches.tolist(), met.distances.round(9).tolist()
    ([False], [0.0])
    >>> sc.BezierCurve([(0.5, 1, 0), (1.5, 1, 0)]).patch_intersections(plane).overlaps.round(9).tolist()
    [[0.0, 1.0]]
    """

    @property
    def parameters(self) -> _Floats:
        """Parameters (n, 3): t of the curve, u and v of the patch."""
    @property
    def points(self) -> _Floats:
        """Points (n, 3) in the middle between both."""
    @property
    def distances(self) -> _Floats:
        """Distances (n,) of both."""
    @property
    def touches(self) -> NDArray[np.bool_]:
        """Whether the curve does not pass through the patch (n,)."""
    @property
    def overlaps(self) -> _Floats:
        """Stretches (m, 2): start and end on the curve."""
    def __copy__(self) -> PatchIntersections: ...
    def __deepcopy__(self, memo: object, /) -> PatchIntersections: ...

@final
class Region:
    """A part of a plane within closed curves: outer borders and borders of holes, in any number.

    Immutable. Seen against the normal the region lies to the left of all its outlines, which do not
    cross. An empty region has none, and is false.

    References
    ----------
    Lecture row S18.

    Examples
    --------
    >>> square = sc.Region.of([sc.NurbsCurve(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (2, 0), (2, 2), (0, 2), (0, 0)])])
    >>> disk = sc.Region.of([sc.conics.circle((2, 0, 0), 1.0)])
    >>> round((square - disk).area(), 9), round((square | disk).area() + (square & disk).area() - square.area(), 9)
    (3.214601837, 3.141592654)
    """

    @staticmethod
    def of(
        curves: Sequence[_Curve],
        normal: ArrayLike | None = None,
        *,
        rule: Literal["even-odd", "nonzero"] = "even-odd",
        tolerance: float | None = None,
        cancel: _Cancel | None = None,
    ) -> Region:
        """Make the region that closed curves of one plane enclose.

        Curves that cross, touch or overlap themselves or each other are cut there, and parts of them put
        together; others stay as they are, reversed where they run the wrong way.

        Parameters
        ----------
        curves : sequence of curves
            Closed curves of any kinds; none make an empty region.
        normal : array_like, optional
            Vector (3,) at right angles to the plane; by default that of the curves, towards +z.
        rule : {'even-odd', 'nonzero'}, default 'even-odd'
            Which places are inside: those around which curves run an odd number of times, or another
            number than 0, where turns to the right are negative.
        tolerance : float, optional
            Places so near are one, a length; by default 2^-33 of the size.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Region
            The region.

        Raises
        ------
        InvalidShape
            If a curve is open, not in the plane or encloses nothing, or if curves run along each other so
            that the tolerance does not tell what lies between them.
        PointAtInfinity
            If a curve runs to infinity.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> ring = sc.Region.of([sc.conics.circle((0, 0, 0), 2.0), sc.conics.circle((0, 0, 0), 1.0)])
        >>> round(ring.area() / np.pi, 9)
        3.0
        """
    @property
    def outlines(self) -> tuple[NurbsCurve, ...]:
        """The closed curves that bound the region, which lies to their left.

        Examples
        --------
        >>> disk = sc.Region.of([sc.conics.circle((0, 0, 0), 1.0)])
        >>> [round(outline.length() / np.pi, 9) for outline in disk.outlines]
        [2.0]
        """
    @property
    def normal(self) -> _Floats:
        """The unit vector (3,) that the region is seen against.

        Examples
        --------
        >>> sc.Region.of([sc.conics.circle((0, 0, 0), 1.0)]).normal
        array([0., 0., 1.])
        """
    def union(
        self, other: Region, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Region:
        """Unite two regions: `a | b`.

        Outlines of the result are exact: parts of those of both, closed in every bit.

        Parameters
        ----------
        other : Region
            A region of the same plane.
        tolerance : float, optional
            Places so near are one, a length; by default 2^-33 of the size.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Region
            Places in one of them or in both.

        Raises
        ------
        InvalidShape
            If the planes differ, or outlines run along each other so that the tolerance does not tell
            what lies between them.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> a = sc.Region.of([sc.build.contour([(0, 0), (2, 0), (2, 1), (0, 1)], closed=True)])
        >>> b = sc.Region.of([sc.build.contour([(1, 0), (3, 0), (3, 1), (1, 1)], closed=True)])
        >>> round(a.union(b).area(), 9), a.union(b) == (a | b)
        (3.0, True)
        """
    def intersection(
        self, other: Region, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Region:
        """Find what two regions have in common: `a & b`.

        Parameters
        ----------
        other : Region
            A region of the same plane.
        tolerance : float, optional
            Places so near are one, a length; by default 2^-33 of the size.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Region
            Places in both.

        Raises
        ------
        InvalidShape
            If the planes differ, or outlines run along each other so that the tolerance does not tell
            what lies between them.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> a = sc.Region.of([sc.build.contour([(0, 0), (2, 0), (2, 1), (0, 1)], closed=True)])
        >>> b = sc.Region.of([sc.build.contour([(1, 0), (3, 0), (3, 1), (1, 1)], closed=True)])
        >>> round(a.intersection(b).area(), 9)
        1.0
        """
    def difference(
        self, other: Region, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Region:
        """Take a region away from another one: `a - b`.

        Parameters
        ----------
        other : Region
            A region of the same plane.
        tolerance : float, optional
            Places so near are one, a length; by default 2^-33 of the size.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Region
            Places in the first one alone.

        Raises
        ------
        InvalidShape
            If the planes differ, or outlines run along each other so that the tolerance does not tell
            what lies between them.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> a = sc.Region.of([sc.build.contour([(0, 0), (2, 0), (2, 1), (0, 1)], closed=True)])
        >>> b = sc.Region.of([sc.build.contour([(1, 0), (3, 0), (3, 1), (1, 1)], closed=True)])
        >>> a.difference(b).centroid().round(9).tolist()
        [0.5, 0.5, 0.0]
        """
    def symmetric_difference(
        self, other: Region, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Region:
        """Find the parts of two regions that they do not have in common: `a ^ b`.

        Parameters
        ----------
        other : Region
            A region of the same plane.
        tolerance : float, optional
            Places so near are one, a length; by default 2^-33 of the size.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Region
            Places in one, but not in both.

        Raises
        ------
        InvalidShape
            If the planes differ, or outlines run along each other so that the tolerance does not tell
            what lies between them.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> a = sc.Region.of([sc.build.contour([(0, 0), (2, 0), (2, 1), (0, 1)], closed=True)])
        >>> b = sc.Region.of([sc.build.contour([(1, 0), (3, 0), (3, 1), (1, 1)], closed=True)])
        >>> round((a ^ b).area(), 9), len((a ^ b).outlines)
        (2.0, 2)
        """
    def offset(
        self,
        distance: float,
        tolerance: float | None = None,
        *,
        corner: Literal["round", "sharp"] = "round",
        cancel: _Cancel | None = None,
    ) -> Region:
        """Widen or narrow a region.

        Holes close, outlines merge, and narrow parts are cut or vanish: the result may be empty. Lines and
        arcs of circles are moved exactly, other spans within the tolerance.

        Parameters
        ----------
        distance : float
            How far outlines move away from the region, into it where it is negative.
        tolerance : float, optional
            The largest error, a length; by default 2^-20 of the size of each outline.
        corner : {'round', 'sharp'}, default 'round'
            Where outlines turn away from the offset an arc, or the corner of both tangents up to four
            times the distance away.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Region
            Places that are no farther than the distance from the region; of a negative distance those in
            it that are farther than that from its outlines.

        Raises
        ------
        InvalidShape
            If the distance is not finite, or the offset of an outline does not close.
        ToleranceNotReached
            If the tolerance is not reached.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> square = sc.Region.of([sc.NurbsCurve(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (2, 0), (2, 2), (0, 2), (0, 0)])])
        >>> round(square.offset(1.0).area(), 9), round(square.offset(-0.5).area(), 9), bool(square.offset(-1.5))
        (15.141592654, 1.0, False)
        """
    def contains(self, points: ArrayLike) -> NDArray[np.bool_]:
        """Tell which points, seen against the normal, are in the region or on its border.

        Parameters
        ----------
        points : array_like
            Points (..., 2 or 3).

        Returns
        -------
        numpy.ndarray
            Whether each is (...,).

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.Region.of([sc.conics.circle((0, 0, 0), 1.0)]).contains([(0.5, 0.5), (1, 0), (1, 1)]).tolist()
        [True, True, False]
        """
    def area(self, *, tolerance: float = 1e-12) -> float:
        """Measure the area.

        Parameters
        ----------
        tolerance : float, default 1e-12
            The largest error, relative to what lines from a middle to the outlines sweep.

        Returns
        -------
        float
            The area, in units of length squared.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        ToleranceNotReached
            If the tolerance takes too much work.

        References
        ----------
        Green's theorem.

        Examples
        --------
        >>> round(sc.Region.of([sc.conics.circle((0, 0, 0), 2.0)]).area() / np.pi, 9)
        4.0
        """
    def centroid(self, *, tolerance: float = 1e-12) -> _Floats:
        """Find the centroid of the area.

        Parameters
        ----------
        tolerance : float, default 1e-12
            The largest error, relative to half the diagonal of the box of the points.

        Returns
        -------
        numpy.ndarray
            Point (3,).

        Raises
        ------
        InvalidShape
            If the region is empty.
        ToleranceNotReached
            If the tolerance takes too much work.

        Examples
        --------
        >>> sc.Region.of([sc.build.contour([(0, 0), (3, 0), (0, 3)], closed=True)]).centroid().round(9).tolist()
        [1.0, 1.0, 0.0]
        """
    def second_moments(self, about: ArrayLike | None = None, *, tolerance: float = 1e-12) -> _Floats:
        """Integrate d d^T over the area, where d is the vector from a point.

        Parameters
        ----------
        about : array_like, optional
            Point (3,); by default the centroid.
        tolerance : float, default 1e-12
            The largest error, relative to the trace about the centroid.

        Returns
        -------
        numpy.ndarray
            A symmetric matrix (3, 3), in units of length to the fourth power.

        Raises
        ------
        InvalidShape
            If the region is empty, or a moment is too large for a number.
        ToleranceNotReached
            If the tolerance takes too much work.

        Examples
        --------
        >>> disk = sc.Region.of([sc.conics.circle((0, 0, 0), 1.0)])
        >>> (disk.second_moments() / np.pi).round(9).diagonal().tolist()
        [0.25, 0.25, 0.0]
        """
    def __or__(self, other: Region, /) -> Region: ...
    def __and__(self, other: Region, /) -> Region: ...
    def __sub__(self, other: Region, /) -> Region: ...
    def __xor__(self, other: Region, /) -> Region: ...
    def transformed(self, matrix: ArrayLike) -> Region:
        """Apply a linear or affine map. Of a mirrored region the normal points the other way.

        Parameters
        ----------
        matrix : array_like
            Matrix (3, 3), (3, 4) or (4, 4) that is applied to columns.

        Returns
        -------
        Region
            The image of the region.

        Raises
        ------
        InvalidShape
            If the map is projective, or flattens the region.

        Examples
        --------
        >>> disk = sc.Region.of([sc.conics.circle((0, 0, 0), 1.0)])
        >>> ellipse = disk.transformed([[2, 0, 0], [0, 1, 0], [0, 0, 1]])
        >>> round(ellipse.area() / np.pi, 9)
        2.0
        """
    def translated(self, by: ArrayLike) -> Region:
        """Move the shape by a vector.

        Parameters
        ----------
        by : array_like
            Vector (2 or 3,).

        Returns
        -------
        Region
            The moved shape.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).translated((5, 0, 1)).points.tolist()
        [[5.0, 0.0, 1.0], [6.0, 2.0, 1.0]]
        """
    def rotated(self, angle: float, axis: ArrayLike = (0, 0, 1), about: ArrayLike = (0, 0, 0)) -> Region:
        """Rotate the shape about an axis, counterclockwise as seen from its tip.

        Parameters
        ----------
        angle : float
            Angle in radians.
        axis : array_like, default (0, 0, 1)
            Vector (3,) along the axis; only its direction counts.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) on the axis.

        Returns
        -------
        Region
            The rotated shape.

        Raises
        ------
        InvalidShape
            If the axis is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).rotated(np.pi, about=(1, 0)).points.round(9)[1].tolist()
        [1.0, -2.0, 0.0]
        """
    def scaled(self, factor: ArrayLike, about: ArrayLike = (0, 0, 0)) -> Region:
        """Scale the shape about a point.

        Parameters
        ----------
        factor : array_like
            A number, or one for each coordinate (3,); a negative one mirrors.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) that stays.

        Returns
        -------
        Region
            The scaled shape.

        Raises
        ------
        InvalidShape
            If a factor is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).scaled((2, -1, 1)).points[1].tolist()
        [2.0, -2.0, 0.0]
        """
    def dumps(self) -> str:
        """Write the shape as JSON text.

        Returns
        -------
        str
            Text that `loads` reads back equal in every bit.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> sc.loads(curve.dumps()) == curve
        True
        """
    def __bool__(self) -> bool: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Region: ...
    def __deepcopy__(self, memo: object, /) -> Region: ...

@final
class Sections:
    """The n curves that two surfaces have in common, and the m points where they touch.

    Examples
    --------
    >>> a = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 2, 0))
    >>> b = sc.build.plane((1, 0, -1), (0, 2, 0), (0, 0, 2))
    >>> met = a.sections(b)
    >>> [round(curve.length(), 9) for curve in met.curves], list(met.kinds), met.closed.tolist(), met.are_one
    ([2.0], ['crossing'], [False], False)
    >>> met.on_a[0].evaluate(0.0).round(9).tolist()[0], met.on_b[0].evaluate(0.0).round(9).tolist()[1]
    (0.5, 0.5)
    >>> met.points.shape, met.parameters.shape
    ((0, 3), (0, 2, 2))
    """

    @property
    def curves(self) -> tuple[NurbsCurve, ...]:
        """The curves."""
    @property
    def on_a(self) -> tuple[NurbsCurve, ...]:
        """Images of the curves in the parameters of the first surface: points (u, v, 0) by the same parameter."""
    @property
    def on_b(self) -> tuple[NurbsCurve, ...]:
        """Images of the curves in the parameters of the second surface."""
    @property
    def closed(self) -> NDArray[np.bool_]:
        """Whether each curve ends where it begins (n,)."""
    @property
    def kinds(self) -> tuple[Literal["crossing", "touching", "border"], ...]:
        """For each curve 'crossing', 'touching', or 'border' of a part where both surfaces are one."""
    @property
    def are_one(self) -> bool:
        """Whether both surfaces have a part in common."""
    @property
    def points(self) -> _Floats:
        """Points (m, 3) where the surfaces touch."""
    @property
    def parameters(self) -> _Floats:
        """Parameters (m, 2, 2) of those points: u and v on the first surface, and on the second."""
    def __copy__(self) -> Sections: ...
    def __deepcopy__(self, memo: object, /) -> Sections: ...

@final
class StationaryPoints:
    """The n places of a shape where the distance from a point is stationary.

    Examples
    --------
    >>> found = sc.BezierCurve([(0, 0), (4, 0)]).stationary_points((1, 2))
    >>> found.parameters.round(9).tolist(), found.kinds
    ([0.0, 0.25, 1.0], ('maximum', 'minimum', 'maximum'))
    >>> found.points[1].round(9).tolist(), found.distances[1].round(9).item()
    ([1.0, 0.0, 0.0], 2.0)
    """

    @property
    def parameters(self) -> _Floats:
        """Parameters (n,) on a curve; (n, 2), u and v, on a patch."""
    @property
    def points(self) -> _Floats:
        """Points (n, 3) of the shape."""
    @property
    def distances(self) -> _Floats:
        """Distances (n,) from the point."""
    @property
    def kinds(self) -> tuple[Literal["minimum", "maximum", "saddle"], ...]:
        """For each place 'minimum', 'maximum', or 'saddle' where it is neither."""
    def __copy__(self) -> StationaryPoints: ...
    def __deepcopy__(self, memo: object, /) -> StationaryPoints: ...

@final
class JoinedPatches:
    """Two patches that meet in a side of each: points and weights along it are equal.

    Examples
    --------
    >>> a = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
    >>> b = sc.build.plane((1.5, 0, 0), (1, 0, 0), (0, 1, 0))
    >>> joined = sc.build.join_patches(a, "u_end", b, "u_start")
    >>> joined.first.evaluate(1.0, 0.0).tolist(), joined.second.evaluate(0.0, 0.0).tolist()
    ([1.0, 0.0, 0.0], [1.0, 0.0, 0.0])
    >>> joined.first_error, joined.second_error, joined.reversed
    (0.0, 0.5, False)
    """

    @property
    def first(self) -> BezierPatch | NurbsPatch:
        """The first patch: a Bezier patch if both were."""
    @property
    def second(self) -> BezierPatch | NurbsPatch:
        """The second patch: a Bezier patch if both were."""
    @property
    def first_error(self) -> float:
        """How far the first patch moved, a length."""
    @property
    def second_error(self) -> float:
        """How far the second patch moved, a length."""
    @property
    def reversed(self) -> bool:
        """Whether the second side runs against the first one."""
    def __copy__(self) -> JoinedPatches: ...
    def __deepcopy__(self, memo: object, /) -> JoinedPatches: ...

_Kind = TypeVar("_Kind")

@final
class Approximation(tuple[_Kind, float]):
    """A result, and an upper bound of its error.

    Unpacks as `value, error = …`.

    Examples
    --------
    >>> curve = sc.BezierCurve([(0, 0), (1, 1), (2, 0)])
    >>> line, error = curve.reduce()
    >>> line.degree, round(error, 9)
    (1, 0.5)
    """

    @property
    def value(self) -> _Kind:
        """The value.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 1), (2, 0)]).reduce().value
        BezierCurve(degree=1)
        """
    @property
    def error(self) -> float:
        """The error, a length in units of the points; 0 where nothing but rounding was lost.

        Examples
        --------
        >>> round(sc.BezierCurve([(0, 0), (1, 1), (2, 0)]).reduce().error, 9)
        0.5
        """
    def __copy__(self) -> Approximation[_Kind]: ...
    def __deepcopy__(self, memo: object, /) -> Approximation[_Kind]: ...

@final
class NurbsCurve:
    """A NURBS curve: control points with weights on a knot vector.

    Immutable; arrays that it gives are read-only views.

    Parameters
    ----------
    degree : int
        Degree, 1 to 255.
    knots : array_like
        Knots that do not decrease: (n + degree + 1,), or (n + 1,) for one period of a periodic curve.
    points : array_like
        Control points (n, 2 or 3), in any unit of length; two coordinates lie in the xy plane.
    weights : array_like, optional
        Weights (n,), 1 where none are given; 0 makes a point a direction, negative ones are allowed.
    periodic : bool, default False
        Whether the curve is closed and takes any parameter, modulo its period.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    The NURBS Book, chapter 4; lecture rows S11, S15.

    Examples
    --------
    >>> curve = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
    >>> curve
    NurbsCurve(degree=2, points=3, rational)
    >>> round(curve.length(), 12)      # a quarter of the unit circle
    1.570796326795
    """

    def __init__(
        self,
        degree: SupportsIndex,
        knots: ArrayLike,
        points: ArrayLike,
        weights: ArrayLike | None = None,
        periodic: bool = False,
    ) -> None: ...
    @staticmethod
    def from_homogeneous(
        degree: SupportsIndex, knots: ArrayLike, points: ArrayLike, periodic: bool = False
    ) -> NurbsCurve:
        """Make a curve from homogeneous control points.

        Parameters
        ----------
        degree : int
            Degree, 1 to 255.
        knots : array_like
            Knots, as of the constructor.
        points : array_like
            Rows (n, 4) of wx, wy, wz, w; w = 0 makes a direction.
        periodic : bool, default False
            Whether the curve is periodic.

        Returns
        -------
        NurbsCurve
            The curve.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> curve = sc.NurbsCurve.from_homogeneous(1, [0, 0, 1, 1], [(0, 0, 0, 1), (4, 0, 0, 2)])
        >>> curve.points.tolist(), curve.weights.tolist()
        ([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]], [1.0, 2.0])
        """
    @property
    def degree(self) -> int:
        """The degree.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).degree
        2
        """
    @property
    def domain(self) -> _Interval:
        """First and last parameter (start, end).

        Examples
        --------
        >>> sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)]).domain
        (0.0, 2.0)
        """
    @property
    def is_rational(self) -> bool:
        """True unless every weight is 1.

        Examples
        --------
        >>> sc.conics.circle((0, 0, 0), 1.0).is_rational, sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).is_rational
        (True, False)
        """
    @property
    def periodic(self) -> bool:
        """Whether the curve is periodic.

        Examples
        --------
        >>> sc.NurbsCurve(3, range(6), [(0, 0), (2, 0), (3, 2), (1, 3), (-1, 2)], periodic=True).periodic
        True
        """
    @property
    def knots(self) -> _Floats:
        """The knots as given, a read-only float64 array.

        Examples
        --------
        >>> sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)]).knots
        array([0., 0., 1., 2., 2.])
        """
    @property
    def knot_vector(self) -> basis.KnotVector:
        """The `basis.KnotVector` of the curve.

        Examples
        --------
        >>> sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)]).knot_vector.greville
        array([0., 1., 2.])
        """
    @property
    def points(self) -> _Floats:
        """Control points (n, 3) float64, as given, read-only.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).points.tolist()
        [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [2.0, 0.0, 0.0]]
        """
    @property
    def weights(self) -> _Floats:
        """Weights (n,) float64, read-only. A point of weight 0 is a direction: a point at infinity.

        Examples
        --------
        >>> sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], weights=[1, 0, 1]).weights
        array([1., 0., 1.])
        """
    @property
    def homogeneous_points(self) -> _Floats:
        """Rows (n, 4) of wx, wy, wz, w; a direction keeps its coordinates. InvalidShape where one is too large
        for a number.

        Examples
        --------
        >>> sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], weights=[2, 0, 1]).homogeneous_points.tolist()
        [[2.0, 0.0, 0.0, 2.0], [0.0, 1.0, 0.0, 0.0], [-1.0, 0.0, 0.0, 1.0]]
        """
    def with_points(self, points: ArrayLike) -> NurbsCurve:
        """Replace the control points, keep weights and knots.

        Parameters
        ----------
        points : array_like
            As many control points (n, 2 or 3).

        Returns
        -------
        NurbsCurve
            The new curve.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> curve.with_points(curve.points + (0, 0, 1)).evaluate(0.5).tolist()
        [1.0, 1.0, 1.0]
        """
    def with_weights(self, weights: ArrayLike) -> NurbsCurve:
        """Replace the weights, keep control points and knots.

        Parameters
        ----------
        weights : array_like
            As many weights (n,).

        Returns
        -------
        NurbsCurve
            The new curve.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> curve = sc.BezierCurve([(1, 0), (1, 1), (0, 1)])
        >>> round(curve.with_weights([1, 0.5**0.5, 1]).length() / np.pi, 9)      # a quarter circle
        0.5
        """
    def evaluate(
        self,
        u: ArrayLike,
        *,
        side: _Side = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: _Points | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Points:
        """Evaluate points of the curve.

        A parameter has the same result in every bit in any batch and on any number of threads.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Points (..., 3) of the same units as the control points; float32 where `dtype` or `out` ask
            for it.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S6, S9, S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> arc.evaluate([0.0, 0.5, 1.0]).round(6)
        array([[1.      , 0.      , 0.      ],
               [0.707107, 0.707107, 0.      ],
               [0.      , 1.      , 0.      ]])
        """
    def derivatives(
        self,
        u: ArrayLike,
        order: SupportsIndex,
        *,
        side: _Side = "right",
        at_infinity: _AtInfinity = "raise",
        out: _Floats | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate points and their derivatives by the parameter.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        order : int
            Highest order of derivatives, 0 or more.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (..., order + 1, 3): `[..., 0, :]` are the points of `evaluate`, in every bit.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain, or a derivative is too large for a number.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        The NURBS Book, A4.2.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> curve.derivatives(0.5, 1)
        array([[1., 1., 0.],
               [2., 0., 0.]])
        """
    def pieces(self) -> list[_Interval]:
        """Find the intervals on which the curve is finite and connected.

        It is cut where the weight is zero and at knots of multiplicity degree + 1.

        Returns
        -------
        list of tuple (float, float)
            Intervals (start, end) in order.

        Examples
        --------
        >>> sc.conics.hyperbola((0, 0, 0), (1, 0, 0), (0, 1, 0))[0].pieces()
        [(0.0, 1.0)]
        >>> sc.BezierCurve([(0, 0), (1, 1), (2, 0)], weights=[1, 0, -1]).pieces()
        [(0.0, 0.5), (0.5, 1.0)]
        """
    def polylines(
        self, resolution: SupportsIndex, reach: float | None = None, around: ArrayLike | None = None
    ) -> list[tuple[_Floats, bool]]:
        """Sample the curve evenly in its parameter, one polyline for each of `pieces`.

        With a reach, a curve whose weights differ in sign ends where it leaves the box of its finite control
        points by that length in a coordinate; without one, at its last sample before infinity.

        Parameters
        ----------
        resolution : int
            Steps in every span.
        reach : float, optional
            A length beyond the box of the control points at which a curve through infinity is cut.
        around : array_like, optional
            Points (n, 2 or 3) whose box stands for that of the control points; any curve is cut there.

        Returns
        -------
        list of tuple (numpy.ndarray, bool)
            Pairs (points (m, 3), whether the polyline is closed).

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (2, 0)])
        >>> points, closed = line.polylines(2)[0]
        >>> points.tolist(), closed
        ([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], False)
        """
    def split(self, u: float) -> tuple[NurbsCurve, ...]:
        """Cut the curve at a parameter.

        Parameters
        ----------
        u : float
            A parameter inside the domain; a periodic curve takes any.

        Returns
        -------
        tuple of NurbsCurve
            (before, after), each on its part of the domain; of a periodic curve (opened,), one plain
            curve from u once around.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> curve = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (4, 0)])
        >>> before, after = curve.split(0.25)
        >>> round(before.length(), 9), after.domain
        (1.0, (0.25, 1.0))
        """
    def transformed(self, matrix: ArrayLike) -> NurbsCurve:
        """Apply a linear, affine or projective map.

        Under a projective map the weights change; a point that goes to infinity gets the weight 0.

        Parameters
        ----------
        matrix : array_like
            Matrix (3, 3), (3, 4) or (4, 4) that is applied to columns.

        Returns
        -------
        NurbsCurve
            The image of the curve.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S9, S15.

        Examples
        --------
        >>> line = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (1, 0)])
        >>> line.transformed([[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0]]).points.tolist()
        [[5.0, 0.0, 0.0], [6.0, 0.0, 0.0]]
        """
    def translated(self, by: ArrayLike) -> NurbsCurve:
        """Move the shape by a vector.

        Parameters
        ----------
        by : array_like
            Vector (2 or 3,).

        Returns
        -------
        NurbsCurve
            The moved shape.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).translated((5, 0, 1)).points.tolist()
        [[5.0, 0.0, 1.0], [6.0, 2.0, 1.0]]
        """
    def rotated(self, angle: float, axis: ArrayLike = (0, 0, 1), about: ArrayLike = (0, 0, 0)) -> NurbsCurve:
        """Rotate the shape about an axis, counterclockwise as seen from its tip.

        Parameters
        ----------
        angle : float
            Angle in radians.
        axis : array_like, default (0, 0, 1)
            Vector (3,) along the axis; only its direction counts.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) on the axis.

        Returns
        -------
        NurbsCurve
            The rotated shape.

        Raises
        ------
        InvalidShape
            If the axis is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).rotated(np.pi, about=(1, 0)).points.round(9)[1].tolist()
        [1.0, -2.0, 0.0]
        """
    def scaled(self, factor: ArrayLike, about: ArrayLike = (0, 0, 0)) -> NurbsCurve:
        """Scale the shape about a point.

        Parameters
        ----------
        factor : array_like
            A number, or one for each coordinate (3,); a negative one mirrors.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) that stays.

        Returns
        -------
        NurbsCurve
            The scaled shape.

        Raises
        ------
        InvalidShape
            If a factor is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).scaled((2, -1, 1)).points[1].tolist()
        [2.0, -2.0, 0.0]
        """
    def join(self, other: _Curve, continuity: _Smoothness = "C0") -> Approximation[NurbsCurve]:
        """Append another curve of any kind.

        Points next to the joint move as little as the continuity asks. For 'C1' and 'C2' the domain of the
        other curve is scaled first.

        Parameters
        ----------
        other : curve
            The curve that follows.
        continuity : {'C0', 'G1', 'C1', 'C2'}, default 'C0'
            The continuity wanted at the joint.

        Returns
        -------
        Approximation of NurbsCurve
            Both as one curve, and the distance by which they moved, a length.

        Raises
        ------
        InvalidShape
            If a curve is periodic or an end lies at infinity.

        References
        ----------
        Lecture row S7.

        Examples
        --------
        >>> a = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (1, 0)])
        >>> b = sc.NurbsCurve(1, [0, 0, 1, 1], [(1, 0), (1, 1)])
        >>> joined, error = a.join(b)
        >>> joined.domain, error
        ((0.0, 2.0), 0.0)
        """
    def continuity_to(self, other: _Curve, tolerance: float = 1e-8) -> Continuity:
        """Measure the continuity between the end of this curve and the start of another one, of any kind.

        Parameters
        ----------
        other : curve
            The curve that follows.
        tolerance : float, default 1e-08
            Relative differences below it count as none.

        Returns
        -------
        Continuity
            The continuity.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S16.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (1, 0)])
        >>> [a.continuity_to(sc.BezierCurve([(1, 0), end])).g for end in ((3, 0), (1, 1))]
        [2, 0]
        """
    @property
    def is_closed(self) -> bool:
        """Whether the curve is in one piece and ends exactly where it begins.

        Examples
        --------
        >>> sc.conics.circle((0, 0, 0), 1.0).is_closed, sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).is_closed
        (True, False)
        """
    def reversed(self) -> NurbsCurve:
        """Reverse the direction of the curve over the same domain.

        Over [-end, -start] where rounding of start + end - u would spoil short spans far from zero.

        Returns
        -------
        NurbsCurve
            The same points in the opposite direction.

        Examples
        --------
        >>> curve = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (4, 0)])
        >>> curve.reversed().evaluate(0.25).tolist()
        [3.0, 0.0, 0.0]
        """
    def to_bezier(self) -> list[BezierCurve]:
        """Convert to Bezier curves, one for each span.

        Returns
        -------
        list of BezierCurve
            Bezier curves in order.

        References
        ----------
        The NURBS Book, A5.6.

        Examples
        --------
        >>> curve = sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0), (1, 1), (2, 1), (3, 0)])
        >>> len(curve.to_bezier())
        2
        """
    def to_hermite(self) -> HermiteCurve:
        """Convert to a chain of cubics.

        Returns
        -------
        HermiteCurve
            The same curve.

        Raises
        ------
        InvalidShape
            If it is rational, has a gap, or its degree is above 3.

        Examples
        --------
        >>> chain = sc.BezierCurve([(0, 0), (1, 3), (2, 3), (3, 0)]).to_hermite()
        >>> chain.tangents[:, 1].tolist()
        [[3.0, 9.0, 0.0], [3.0, -9.0, 0.0]]
        """
    def to_nurbs(self) -> NurbsCurve:
        """Give the curve itself.

        Returns
        -------
        NurbsCurve
            The curve.

        Examples
        --------
        >>> curve = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (4, 0)])
        >>> curve.to_nurbs() == curve
        True
        """
    def to_power(self) -> list[PowerCurve]:
        """Convert to powers of the parameter, one curve for each span.

        Returns
        -------
        list of PowerCurve
            Curves in order, in powers of the parameter from the start of each span.

        References
        ----------
        Lecture row S2.

        Examples
        --------
        >>> curve = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 2)])
        >>> [part.coefficients.tolist() for part in curve.to_power()]
        [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]], [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0]]]
        """
    def insert_knot(self, u: float, times: SupportsIndex = 1) -> NurbsCurve:
        """Add a knot without changing the curve.

        Control points that need not move keep every digit.

        Parameters
        ----------
        u : float
            A parameter inside the domain.
        times : int, default 1
            How often.

        Returns
        -------
        NurbsCurve
            The same curve with more knots.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Boehm 1980; The NURBS Book, A5.1.

        Examples
        --------
        >>> curve = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 2), (2, 0)])
        >>> curve.insert_knot(0.5).points.tolist()
        [[0.0, 0.0, 0.0], [0.5, 1.0, 0.0], [1.5, 1.0, 0.0], [2.0, 0.0, 0.0]]
        """
    def refine(self, knots: ArrayLike) -> NurbsCurve:
        """Add several knots without changing the curve.

        Parameters
        ----------
        knots : array_like
            Parameters (n,) inside the domain.

        Returns
        -------
        NurbsCurve
            The same curve with more knots.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> curve = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (4, 0)])
        >>> curve.refine([0.25, 0.5]).points.tolist()
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [4.0, 0.0, 0.0]]
        """
    def unrolled(self) -> NurbsCurve:
        """Convert a periodic curve to a plain one whose knots and points are repeated.

        Returns
        -------
        NurbsCurve
            The same curve.

        Examples
        --------
        >>> ring = sc.NurbsCurve(1, [0, 1, 2, 3], [(0, 0), (1, 0), (0, 1)], periodic=True)
        >>> ring.unrolled().knots.tolist(), len(ring.unrolled().points)
        ([-1.0, 0.0, 1.0, 2.0, 3.0, 4.0], 4)
        """
    def remove_knot(
        self, u: float, times: SupportsIndex = 1, tolerance: float | None = None
    ) -> Approximation[NurbsCurve]:
        """Remove an inner knot, with the nearest control points.

        Control points that the knot does not affect keep every digit.

        Parameters
        ----------
        u : float
            An inner knot.
        times : int, default 1
            How many copies of it.
        tolerance : float, optional
            The largest error allowed, a length; by default any.

        Returns
        -------
        Approximation of NurbsCurve
            The new curve, and the largest distance at equal parameters, at most 1 % above the truth.

        Raises
        ------
        InvalidShape
            If u is not an inner knot.
        ToleranceNotReached
            If the error exceeds the tolerance.

        References
        ----------
        The NURBS Book, 5.4; lecture row S15.

        Examples
        --------
        >>> curve = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 2), (2, 0)]).insert_knot(0.5)
        >>> simpler, error = curve.remove_knot(0.5)
        >>> len(simpler.points), error < 1e-15
        (3, True)
        """
    def bezier_points(self) -> _Floats:
        """Homogeneous control points of all Bezier pieces.

        Returns
        -------
        numpy.ndarray
            Array (pieces, degree + 1, 4) of wx, wy, wz, w: the control points of `to_bezier`.

        Raises
        ------
        InvalidShape
            Where one is too large for a number.

        Examples
        --------
        >>> sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)]).bezier_points().shape
        (2, 2, 4)
        """
    def remove_knots(self, tolerance: float, *, cancel: _Cancel | None = None) -> Approximation[NurbsCurve]:
        """Remove all inner knots that are not needed within a tolerance.

        Knots that nothing needs are removed before those that shape the curve.

        Parameters
        ----------
        tolerance : float
            The largest error allowed, a length in units of the points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsCurve
            The new curve, and the largest distance at equal parameters.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        The NURBS Book, A5.9; lecture row S15.

        Examples
        --------
        >>> curve = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 2), (2, 0)])
        >>> simpler, error = curve.refine([0.25, 0.5, 0.75]).remove_knots(1e-9)
        >>> len(simpler.points), error < 1e-9
        (3, True)
        """
    def elevate(self, times: SupportsIndex = 1) -> NurbsCurve:
        """Raise the degree without changing the curve; every distinct knot gains as many copies.

        Parameters
        ----------
        times : int, default 1
            By how much.

        Returns
        -------
        NurbsCurve
            The same curve.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        The NURBS Book, 5.5; lecture row S15.

        Examples
        --------
        >>> curve = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (2, 0)])
        >>> curve.elevate().points.tolist()
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]
        """
    def reduce(self, times: SupportsIndex = 1, tolerance: float | None = None) -> Approximation[NurbsCurve]:
        """Lower the degree, with the nearest control points.

        Exact where the degree was raised before. A plain curve keeps its ends, clamped.

        Parameters
        ----------
        times : int, default 1
            By how much.
        tolerance : float, optional
            The largest error allowed, a length; by default any.

        Returns
        -------
        Approximation of NurbsCurve
            The new curve, and the largest distance at equal parameters, at most 1 % above the truth.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        ToleranceNotReached
            If the error exceeds the tolerance.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> curve = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (2, 0)])
        >>> simpler, error = curve.elevate(2).reduce(2, tolerance=1e-9)
        >>> simpler.degree, error < 1e-9
        (1, True)
        """
    def with_domain(self, domain: ArrayLike) -> NurbsCurve:
        """Map the knots to another domain; the points stay.

        Parameters
        ----------
        domain : array_like
            First and last parameter (2,), start < end.

        Returns
        -------
        NurbsCurve
            The same curve over another domain.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> curve = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)])
        >>> curve.with_domain((0, 1)).knots.tolist()
        [0.0, 0.0, 0.5, 1.0, 1.0]
        """
    def clamped(self) -> NurbsCurve:
        """Clamp both ends, so that the curve begins and ends in its outer control points; a periodic curve is
        cut at its seam.

        Returns
        -------
        NurbsCurve
            The same curve.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> curve = sc.NurbsCurve(2, [0, 1, 2, 3, 4, 5, 6], [(0, 0), (2, 0), (2, 2), (0, 2)])
        >>> curve.clamped().points[[0, -1]].tolist()
        [[1.0, 0.0, 0.0], [1.0, 2.0, 0.0]]
        """
    def unclamped(self) -> NurbsCurve:
        """Continue the knots outside the domain; a periodic curve becomes a plain one.

        Returns
        -------
        NurbsCurve
            The same curve.

        Raises
        ------
        InvalidShape
            Where weights at an end differ so much that rounding would move the curve.

        References
        ----------
        The NURBS Book, A12.1; lecture row S15.

        Examples
        --------
        >>> curve = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)])
        >>> curve.unclamped().knots.tolist()
        [-1.0, 0.0, 1.0, 2.0, 3.0]
        """
    def to_periodic(self, tolerance: float | None = None) -> Approximation[NurbsCurve]:
        """Make a closed curve periodic, as smooth at its seam as it is within the tolerance.

        Parameters
        ----------
        tolerance : float, optional
            The largest distance of the ends, a length; by default a few roundings.

        Returns
        -------
        Approximation of NurbsCurve
            The periodic curve and its error.

        Raises
        ------
        InvalidShape
            If the weights of the ends differ or an end lies at infinity.
        ToleranceNotReached
            If the ends are farther apart.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> square = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)])
        >>> ring, error = square.to_periodic()
        >>> ring.periodic, len(ring.points), error
        (True, 4, 0.0)
        """
    def largest_distance(self, other: NurbsCurve) -> float:
        """Bound the distance from another curve at equal parameters.

        Parameters
        ----------
        other : NurbsCurve
            A curve over the same domain.

        Returns
        -------
        float
            An upper bound, a length, at most 1 % above the truth; inf where one curve alone runs to
            infinity.

        Raises
        ------
        InvalidShape
            If the domains differ.

        Examples
        --------
        >>> a = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (4, 0)])
        >>> abs(a.largest_distance(a.translated((0, 2))) - 2) < 0.02
        True
        """
    def continuity(self, u: float, tolerance: float = 1e-8) -> Continuity:
        """Measure the continuity at a parameter inside the domain.

        Parameters
        ----------
        u : float
            A parameter; a periodic curve takes any, modulo its period.
        tolerance : float, default 1e-08
            Relative differences below it count as none.

        Returns
        -------
        Continuity
            The continuity.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S16.

        Examples
        --------
        >>> corner = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)])
        >>> corner.continuity(1.0).g, round(corner.continuity(1.0).angle, 6)
        (0, 1.570796)
        """
    def joints(self, tolerance: float = 1e-8) -> list[tuple[float, Continuity]]:
        """Measure the continuity at every inner knot, and at the seam of a closed curve.

        Joints at infinity are left out.

        Parameters
        ----------
        tolerance : float, default 1e-08
            Relative differences below it count as none.

        Returns
        -------
        list of tuple (float, Continuity)
            Pairs (parameter, continuity).

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S16.

        Examples
        --------
        >>> corner = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)])
        >>> [(u, joint.g, round(joint.angle, 6)) for u, joint in corner.joints()]
        [(1.0, 0, 1.570796)]
        """
    def finite_arcs(self, length: float) -> list[NurbsCurve]:
        """Clip a curve that runs to infinity to a box around its finite control points.

        Every arc is the curve itself on a part of its domain, with positive weights and no control point
        farther outside than twice the length.

        Parameters
        ----------
        length : float
            How far the box reaches beyond the finite control points, in each coordinate.

        Returns
        -------
        list of NurbsCurve
            The arcs in order.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S10, S11.

        Examples
        --------
        >>> right, left = sc.conics.hyperbola((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> arcs = right.finite_arcs(3.0)
        >>> len(arcs), bool(np.all(arcs[0].weights > 0))
        (1, True)
        """
    def moebius(self, rho: float) -> NurbsCurve:
        """Change the parameter to t = rho u / ((1 - u) + rho u); domain and points stay, knots and weights
        change.

        A periodic curve becomes a plain one.

        Parameters
        ----------
        rho : float
            A positive number; 1 changes nothing.

        Returns
        -------
        NurbsCurve
            The same curve under another parameter.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lee and Lucian 1991; lecture row S12.

        Examples
        --------
        >>> line = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (4, 0)])
        >>> line.moebius(3.0).evaluate(0.5).tolist()
        [3.0, 0.0, 0.0]
        """
    def multiplied(self, start: float, end: float) -> NurbsCurve:
        """Multiply the homogeneous coordinates by a linear function; the degree grows by one, weights change,
        the curve stays.

        A periodic curve becomes a plain one.

        Parameters
        ----------
        start : float
            The function at the start of the domain, a number from 1e-100 to 1e100.
        end : float
            The function at the end, such a number.

        Returns
        -------
        NurbsCurve
            The same curve.

        Raises
        ------
        InvalidShape
            If a number is not within these limits, if a weight would leave the range of numbers, and if
            the degree would exceed 255.

        References
        ----------
        Lecture row S9.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (2, 0)]).multiplied(1, 3).weights.tolist()
        [1.0, 2.0, 3.0]
        """
    def standard_form(self) -> NurbsCurve:
        """Change the parameter so that the weights of both ends are 1.

        Returns
        -------
        NurbsCurve
            The same curve.

        Raises
        ------
        InvalidShape
            Unless both end weights have one sign and the curve is clamped.

        References
        ----------
        Lecture row S12.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 1), (2, 0)], weights=[1, 2, 4]).standard_form().weights.tolist()
        [1.0, 1.0, 1.0]
        """
    def length(self, start: float | None = None, end: float | None = None, *, tolerance: float = 1e-13,
               cancel: _Cancel | None = None) -> float:
        """Measure the length between two parameters.

        Adaptive quadrature of Gauss and Kronrod on every span, also through cusps. On a periodic curve start
        and end may be any numbers in order: turns are counted.

        Parameters
        ----------
        start : float, optional
            Where to begin; by default the start of the domain.
        end : float, optional
            Where to end; by default the end of the domain.
        tolerance : float, default 1e-13
            The largest relative error; rounding of the coordinates may be more.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        float
            The length, in units of the points.

        Raises
        ------
        InvalidShape
            Unless start <= end, in the domain of a curve that is not periodic.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work; the message names an error that can be had.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> round(arc.length(), 12), round(arc.length(0.0, 0.5), 12)
        (1.570796326795, 0.785398163397)
        """
    def parameter_at_length(
        self, s: ArrayLike, *, tolerance: float = 1e-10, cancel: _Cancel | None = None
    ) -> _Floats:
        """Find the parameters at given lengths from the start.

        Parameters
        ----------
        s : array_like
            Lengths (...,) from the start of the domain; a periodic curve takes any.
        tolerance : float, default 1e-10
            The largest error of the length, relative to that of the curve.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Parameters (...,).

        Raises
        ------
        InvalidShape
            If a length is below 0 or above that of the curve.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).parameter_at_length([1.0, 2.0]).round(9)
        array([0.25, 0.5 ])
        """
    def divide(self, count: int, *, tolerance: float = 1e-10, cancel: _Cancel | None = None) -> _Floats:
        """Divide the curve into parts of equal length.

        Parameters
        ----------
        count : int
            How many parts, 1 to 2^22.
        tolerance : float, default 1e-10
            The largest error of the length, relative to that of the curve.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Parameters (count + 1,) with both ends; (count,) where the curve closes.

        Raises
        ------
        InvalidShape
            If the count is out of range or the curve has no length.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).divide(4).round(9)
        array([0.  , 0.25, 0.5 , 0.75, 1.  ])
        """
    def divide_by_length(self, step: float, *, tolerance: float = 1e-10, cancel: _Cancel | None = None) -> _Floats:
        """Divide the curve by steps of a given length from its start.

        Parameters
        ----------
        step : float
            Length of a step.
        tolerance : float, default 1e-10
            The largest error of the length, relative to that of the curve.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Parameters (n,) at 0, step, 2 step, … up to the length of the curve, without the end of a
            closed curve.

        Raises
        ------
        InvalidShape
            Unless step > 0, or if there are more than 2^22 steps.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).divide_by_length(1.5).round(9)
        array([0.   , 0.375, 0.75 ])
        """
    def curvature(self, u: ArrayLike, *, side: _Side = "right") -> _Floats:
        """Measure the curvature |C' x C''| / |C'|³.

        Where C' falls to zero it is the limit, inf at a sharp cusp; NaN where the curve is a point.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Curvatures (...,), in 1 / length.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S15, S16.

        Examples
        --------
        >>> arc = sc.BezierCurve([(2, 0), (2, 2), (0, 2)], weights=[1, 0.5**0.5, 1])
        >>> arc.curvature([0.0, 0.5]).round(12)
        array([0.5, 0.5])
        """
    def signed_curvature(
        self, u: ArrayLike, normal: ArrayLike | None = None, *, side: _Side = "right",
    ) -> _Floats:
        """Measure the curvature of a plane curve, positive where it bends to its left.

        Of a curve that is not plane it is the part of the curvature about the normal. Limits as of
        `curvature`.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        normal : array_like, optional
            Vector (3,) that the curve is seen against; by default the normal of its plane, towards +z.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Curvatures (...,), in 1 / length.

        Raises
        ------
        InvalidShape
            If no normal is given and the curve lies in no plane.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(2, 0), (2, 2), (0, 2)], weights=[1, 0.5**0.5, 1])
        >>> arc.reversed().signed_curvature([0.0, 0.5]).round(12)
        array([-0.5, -0.5])
        """
    def nearest(
        self, points: ArrayLike, *, threads: int = 0, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find the nearest point of the curve to each of several points.

        The global minimum: ends, corners and gaps are included. Of several places at one distance the one
        with the smallest parameter is taken. Where the curve passes through infinity its finite part counts.
        A point has the same result in any batch.

        Parameters
        ----------
        points : array_like
            Points (..., 2 or 3).
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            Parameters, points and distances, right to a few roundings of the size of the curve.

        Raises
        ------
        InvalidShape
            If a point is not finite.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998; lecture row S15.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> found = line.nearest([(1, 3), (9, 0)])
        >>> found.parameters, found.distances
        (array([0.25, 1.  ]), array([3., 5.]))
        """
    def intersections(
        self, other: _Curve, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Intersections:
        """Find where the curve meets another one.

        Places where the distance of both is least and within the tolerance, ends included, and stretches that
        both have in common.

        Parameters
        ----------
        other : curve
            A curve of any kind.
        tolerance : float, optional
            The largest distance of both curves, a length; by default 2^-33 of the extent of the control
            points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Intersections
            The places in the order of the parameters of this curve, and the stretches.

        Raises
        ------
        InvalidShape
            If more than 2^22 pairs of parts are within the tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Sederberg and Meyers 1988; lecture row S18.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (2, 2)])
        >>> b = sc.BezierCurve([(0, 2), (2, 0)])
        >>> a.intersections(b).points.round(9)
        array([[1., 1., 0.]])
        """
    def self_intersections(
        self, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Intersections:
        """Find where the curve meets itself.

        Places next to each other along the curve, as at a cusp, and the seam of a closed curve do not count.

        Parameters
        ----------
        tolerance : float, optional
            The largest distance, a length; by default 2^-33 of the extent of the control points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Intersections
            The places as of `intersections`: the first parameter is the smaller one.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> loop = sc.BezierCurve([(0, 0), (3, 2), (-2, 2), (1, 0)])
        >>> loop.self_intersections().points[:, 0].round(9).tolist()
        [0.5]
        """
    def patch_intersections(
        self, patch: _Patch, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> PatchIntersections:
        """Find where the curve meets a patch.

        Places where the distance of both is least and within the tolerance, ends of the curve included, and
        stretches that lie on the patch.

        Parameters
        ----------
        patch : patch
            A patch of any kind.
        tolerance : float, optional
            The largest distance of both, a length; by default 2^-33 of the extent of the control points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        PatchIntersections
            The places in the order of the parameters of the curve, and the stretches.

        Raises
        ------
        InvalidShape
            If more than 2^20 pairs of parts are within the tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0.5, 0.5, -1), (0.5, 0.5, 1)])
        >>> plane = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> line.patch_intersections(plane).parameters.round(9)
        array([[0.5, 0.5, 0.5]])
        """
    def plane_intersections(
        self, origin: ArrayLike, normal: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> PatchIntersections:
        """Find where the curve meets a plane.

        Parameters on the plane are its coordinates, with axes by the rule of DXF files: x and y where the
        normal is z.

        Parameters
        ----------
        origin : array_like
            Point (3,) of the plane.
        normal : array_like
            Vector (3,) at right angles to the plane.
        tolerance : float, optional
            The largest distance, a length; by default 2^-33 of the extent of the control points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        PatchIntersections
            The places and stretches, as of `patch_intersections`.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0, -1), (0, 0, 3)])
        >>> curve.plane_intersections((0, 0, 0), (0, 0, 1)).parameters[:, 0].round(9)
        array([0.25])
        """
    def part(self, start: float, end: float) -> NurbsCurve:
        """Cut out the part between two parameters, over that part of the domain.

        Parameters
        ----------
        start : float
            Where to begin.
        end : float
            Where to end; on a closed curve up to a turn behind the start.

        Returns
        -------
        NurbsCurve
            The part.

        Raises
        ------
        InvalidShape
            Unless start < end in the domain, or over the seam of a closed curve.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).part(0.25, 0.75).domain
        (0.25, 0.75)
        """
    def parts(self, parameters: ArrayLike) -> list[NurbsCurve]:
        """Cut the curve at several parameters.

        The ends of an open curve cut nothing. The last part of a closed curve continues over the seam.

        Parameters
        ----------
        parameters : array_like
            Parameters (n,) in the domain.

        Returns
        -------
        list of NurbsCurve
            The parts in order.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> [round(part.length(), 9) for part in sc.BezierCurve([(0, 0), (4, 0)]).parts([0.25, 0.5])]
        [1.0, 1.0, 2.0]
        """
    def split_by(self, others: Sequence[_Curve], *, cancel: _Cancel | None = None) -> list[NurbsCurve]:
        """Cut the curve where it meets other curves.

        Parameters
        ----------
        others : sequence of curves
            Curves of any kinds.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        list of NurbsCurve
            The parts in order.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> [round(part.length(), 9) for part in line.split_by([sc.BezierCurve([(1, -1), (1, 1)])])]
        [1.0, 3.0]
        """
    def trimmed(self, others: Sequence[_Curve], at: float, *, cancel: _Cancel | None = None) -> list[NurbsCurve]:
        """Remove the part of the curve about a parameter, between where it meets other curves.

        Parameters
        ----------
        others : sequence of curves
            Curves of any kinds.
        at : float
            A parameter of the part that is removed.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        list of NurbsCurve
            One or two curves.

        Raises
        ------
        InvalidShape
            If they do not meet, or a closed curve meets them in one place alone.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> others = [sc.BezierCurve([(x, -1), (x, 1)]) for x in (1, 3)]
        >>> [round(part.length(), 9) for part in line.trimmed(others, 0.5)]
        [1.0, 1.0]
        """
    def extended(
        self, length: float, at: Literal["start", "end"] = "end", how: _Extension = "natural"
    ) -> NurbsCurve:
        """Extend the curve at one end by a length.

        Parameters stay, the domain grows.

        Parameters
        ----------
        length : float
            How far, above 0.
        at : {'start', 'end'}, default 'end'
            The end.
        how : {'natural', 'arc', 'straight'}, default 'natural'
            By the polynomials of the last span ('natural'), along the circle of curvature ('arc'), or
            along the tangent ('straight').

        Returns
        -------
        NurbsCurve
            The longer curve.

        Raises
        ------
        InvalidShape
            If the curve is closed or has a zero derivative at its end, an arc would exceed its circle, or
            the curve runs to infinity before that length.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> round(sc.BezierCurve([(0, 0), (4, 0)]).extended(1.0).length(), 9)
        5.0
        """
    def extended_to(
        self,
        others: Sequence[_Curve],
        at: Literal["start", "end"] = "end",
        how: _Extension = "natural",
        *,
        cancel: _Cancel | None = None,
    ) -> NurbsCurve:
        """Extend the curve at one end to where it first meets other curves.

        Parameters
        ----------
        others : sequence of curves
            Curves of any kinds.
        at : {'start', 'end'}, default 'end'
            The end.
        how : {'natural', 'arc', 'straight'}, default 'natural'
            As of `extended`.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        NurbsCurve
            The longer curve.

        Raises
        ------
        InvalidShape
            If it meets none of them within four times the size of all, or as of `extended`.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> round(line.extended_to([sc.BezierCurve([(6, -1), (6, 1)])]).length(), 9)
        6.0
        """
    def rounded(self, radius: float, *, shrink: bool = False, cancel: _Cancel | None = None) -> NurbsCurve:
        """Replace every corner by an arc that touches both sides.

        Parameters
        ----------
        radius : float
            Radius of the arcs, above 0.
        shrink : bool, default False
            Whether an arc that does not fit gets the largest radius that does, instead of an error: it
            takes at most half of the curve up to the next corner, or all of it up to an end. Where the
            curve turns back the corner stays.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        NurbsCurve
            The curve with arcs, at the seam of a closed curve too.

        Raises
        ------
        InvalidShape
            If no such arc fits between the neighbors of a corner, or the curve turns back or is not plane
            there.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> corner = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (4, 0), (4, 4)])
        >>> round(corner.rounded(1.0).length() - np.pi / 2, 9)
        6.0
        >>> round(corner.rounded(9.0, shrink=True).length() / np.pi, 9)
        2.0
        """
    def chamfered(self, length: float, *, shrink: bool = False, cancel: _Cancel | None = None) -> NurbsCurve:
        """Replace every corner by a line.

        Parameters
        ----------
        length : float
            How far the line begins before the corner and ends behind it, measured along the curve.
        shrink : bool, default False
            Whether it begins and ends nearer to a corner that has no room, as of `rounded`, instead of an
            error.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        NurbsCurve
            The curve with lines.

        Raises
        ------
        InvalidShape
            If a corner has no room for it.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> corner = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (4, 0), (4, 4)])
        >>> round(corner.chamfered(1.0).length() - 2**0.5, 9)
        6.0
        """
    def offset(
        self,
        distance: float,
        normal: ArrayLike = (0, 0, 1),
        *,
        tolerance: float | None = None,
        corner: Literal["round", "sharp"] = "round",
        trimmed: bool = False,
        cancel: _Cancel | None = None,
    ) -> list[NurbsCurve]:
        """Offset a plane curve to its left.

        Lines and arcs of circles are moved exactly; other spans become cubics within the tolerance.

        Parameters
        ----------
        distance : float
            How far, to the left seen against the normal, to the right where it is negative.
        normal : array_like, default (0, 0, 1)
            Normal (3,) of the plane of the curve.
        tolerance : float, optional
            The largest error, a length; by default 2^-20 of the size.
        corner : {'round', 'sharp'}, default 'round'
            At corners an arc, or the corner of both tangents up to four times the distance away.
        trimmed : bool, default False
            Whether parts that are nearer to the curve than the distance are removed.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        list of NurbsCurve
            The offset; several curves where the curve has gaps or the offset is trimmed.

        Raises
        ------
        InvalidShape
            If the curve is not in a plane with that normal, the distance is zero or not finite, or
            nothing is left.
        ToleranceNotReached
            If the tolerance is not reached.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Tiller and Hanson 1984; lecture row S18.

        Examples
        --------
        >>> circle = sc.conics.circle((0, 0, 0), 2.0)
        >>> round(circle.offset(0.5)[0].length() / (2 * np.pi), 9)      # inwards
        1.5
        """
    def least_distance(
        self, other: _Curve | _Patch | PatchSet, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> LeastDistance:
        """Find where this shape and another one are nearest to each other.

        The global minimum, ends and borders included. Of several places at one distance it is any of them.

        Parameters
        ----------
        other : curve or patch or PatchSet
            A curve or patch of any kind, or a set of patches.
        tolerance : float, optional
            How much nearer they may be elsewhere, a length; by default 2^-33 of the size of both.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        LeastDistance
            The distance, with parameters and points on both shapes, and which patches of sets they are
            on.

        Raises
        ------
        InvalidShape
            If the tolerance is negative, or bent shapes are at one distance all along: give a larger
            tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998; lecture row S18.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (4, 0)])
        >>> b = sc.BezierCurve([(1, 3), (3, 1)])
        >>> a.least_distance(b).distance
        1.0
        """
    def stationary_points(self, point: ArrayLike, *, cancel: _Cancel | None = None) -> StationaryPoints:
        """Find all places where the distance from a point is stationary.

        These are the feet of all normals through the point, the ends of the curve and of its pieces, and
        corners where the distance is a minimum or a maximum.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        StationaryPoints
            The places in the order of their parameters, each once.

        Raises
        ------
        InvalidShape
            If the point is not finite or too far away, or where the distance is constant, as from the
            center of a circle.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lane and Riesenfeld 1981; lecture row S15.

        Examples
        --------
        >>> found = sc.BezierCurve([(0, 0), (4, 0)]).stationary_points((1, 2))
        >>> found.parameters.round(9).tolist(), found.kinds
        ([0.0, 0.25, 1.0], ('maximum', 'minimum', 'maximum'))
        """
    def nearest_all(
        self, point: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find all places where the distance from a point is a minimum that is nearly the least one.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        tolerance : float, optional
            By how much the distance may exceed the least one, a length; by default a few roundings.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            The places in the order of their parameters (n,).

        Raises
        ------
        InvalidShape
            If the point is not finite, or where the distance is constant.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> bow = sc.BezierCurve([(-1, 1), (0, -1), (1, 1)])
        >>> bow.nearest_all((0, 2)).points[:, 0].round(6).tolist()
        [-1.0, 1.0]
        """
    def rebuild(
        self,
        count: SupportsIndex | None = None,
        degree: SupportsIndex | None = None,
        *,
        tolerance: float | None = None,
        ends: Literal["points", "tangents"] = "points",
        cancel: _Cancel | None = None,
    ) -> Approximation[NurbsCurve]:
        """Approximate by a polynomial curve with even knots over the same domain.

        It is nearest in the integral of the squared distance at equal parameters, and periodic if the curve
        is.

        Parameters
        ----------
        count : int, optional
            Number of control points; with a tolerance the most.
        degree : int, optional
            Degree; by default that of the curve.
        tolerance : float, optional
            As few control points as come within it, a length.
        ends : {'points', 'tangents'}, default 'points'
            Of an open curve the end points stay, or the tangents there too.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsCurve
            The new curve, and the largest distance at equal parameters, at most 1 % above the truth.

        Raises
        ------
        InvalidShape
            If the count is below the number that the degree needs.
        ToleranceNotReached
            If the tolerance is not reached.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S17.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> curve, error = arc.rebuild(degree=3, tolerance=1e-4)
        >>> curve.is_rational, error <= 1e-4
        (False, True)
        """
    def fair(
        self, tolerance: float, *, ends: Literal["points", "tangents"] = "points", cancel: _Cancel | None = None
    ) -> Approximation[NurbsCurve]:
        """Smooth the curve within a tolerance.

        Knots and weights stay; the integral of the squared second derivative becomes as small as the
        tolerance allows.

        Parameters
        ----------
        tolerance : float
            The largest distance at equal parameters, a length above 0.
        ends : {'points', 'tangents'}, default 'points'
            Of an open curve the end points stay, or the tangents there too.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsCurve
            The new curve and the largest distance at equal parameters, at most 1 % above the truth.

        Raises
        ------
        InvalidShape
            Unless the tolerance is positive and the degree is 2 at least.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Reinsch 1967; lecture row S17.

        Examples
        --------
        >>> noisy = sc.BezierCurve([(0, 0), (1, 0.1), (2, -0.1), (3, 0)])
        >>> smooth, error = noisy.fair(0.01)
        >>> bool(np.ptp(smooth.points[:, 1]) < np.ptp(noisy.points[:, 1])), error <= 0.01
        (True, True)
        """
    def torsion(self, u: ArrayLike, *, side: _Side = "right") -> _Floats:
        """Measure the torsion det(C', C'', C''') / |C' x C''|², positive for a right-handed screw.

        At an inflection or a cusp it is the limit; NaN on a straight line.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Torsions (...,), in 1 / length.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]).torsion(0.0).item()
        3.0
        """
    def inflections(self, direction: ArrayLike | None = None) -> _Floats:
        """Find the parameters where the curve begins to bend to the other side.

        All sign changes of the signed curvature; the middle of a straight part between two bends. Corners do
        not count.

        Parameters
        ----------
        direction : array_like, optional
            Vector (3,) that the curve is seen against; by default the normal of its plane.

        Returns
        -------
        numpy.ndarray
            Parameters (n,) in order.

        Raises
        ------
        InvalidShape
            If no direction is given and the curve lies in no plane.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 1), (2, -1), (3, 0)]).inflections().round(9)
        array([0.5])
        """
    def extrema(self, direction: ArrayLike) -> _Floats:
        """Find the parameters where the curve has an extremum along a direction.

        All zeros of the derivative along it, both ends of a part at right angles to it, corners where it
        changes sign, and the ends of the curve and of its pieces.

        Parameters
        ----------
        direction : array_like
            Vector (3,).

        Returns
        -------
        numpy.ndarray
            Parameters (n,) in order.

        Raises
        ------
        InvalidShape
            If the direction is zero.
        PointAtInfinity
            If the curve runs to infinity.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).extrema((0, 1, 0))
        array([0. , 0.5, 1. ])
        """
    def bounding_box(self) -> _Floats:
        """Find the smallest box along the axes that contains the curve.

        Not that of the control points: right to a few roundings of the largest coordinate.

        Returns
        -------
        numpy.ndarray
            Array (2, 3) of the lowest and the highest corner.

        Raises
        ------
        PointAtInfinity
            If the curve runs to infinity.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).bounding_box().tolist()
        [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0]]
        """
    def signed_area(self, normal: ArrayLike = (0.0, 0.0, 1.0), *, tolerance: float = 1e-12) -> float:
        """Measure the area inside a closed curve, positive where it lies to the left.

        Parts enclosed twice count twice. For a curve that is not plane it is the area of its projection along
        the normal. Exact, but for rounding, for polynomial curves.

        Parameters
        ----------
        normal : array_like, default (0.0, 0.0, 1.0)
            Vector (3,) that the curve is seen against.
        tolerance : float, default 1e-12
            The largest relative error for rational curves.

        Returns
        -------
        float
            The area, in square units of the points.

        Raises
        ------
        InvalidShape
            If the ends are apart by more than 1e-9 of the size or the curve is in several pieces.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> round(sc.conics.circle((0, 0, 0), 2.0).signed_area(), 9)
        12.566370614
        """
    def winding_number(self, point: ArrayLike, normal: ArrayLike = (0.0, 0.0, 1.0)) -> int | NDArray[np.int64]:
        """Count how often a closed curve winds around a point, or each of several points, to the left.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,), or points (..., 2 or 3).
        normal : array_like, default (0.0, 0.0, 1.0)
            Vector (3,) that the curve is seen against.

        Returns
        -------
        int or numpy.ndarray
            The winding number, 0 outside; of points an int64 array (...,).

        Raises
        ------
        InvalidShape
            If a point lies on the curve up to 1e-12 of its size, or the curve is not closed.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> circle = sc.conics.circle((0, 0, 0), 2.0)
        >>> circle.winding_number((1, 0, 0)), circle.winding_number((3, 0, 0))
        (1, 0)
        >>> circle.winding_number([(1, 0), (3, 0)])
        array([1, 0])
        """
    def frenet_frame(self, u: ArrayLike, *, side: _Side = "right") -> _Floats:
        """Evaluate tangent, normal and binormal of Frenet's frame.

        Limits are taken where a derivative falls to zero. Normal and binormal are NaN where the curve is
        straight.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Unit vectors (..., 3, 3), one in each row.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> tangent, normal, binormal = arc.frenet_frame(0.0)
        >>> normal.round(12).tolist()[0]
        -1.0
        """
    def frames(
        self, u: ArrayLike, kind: Literal["frenet", "rotation_minimizing"] = "rotation_minimizing", *,
        start: ArrayLike | None = None, closed: bool = False, side: _Side = "right", cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate frames of tangent, normal and binormal along the curve.

        Rotation-minimizing frames turn around the tangent as little as possible, from the start of the
        domain, to about 1e-9. Straight parts keep the frame; at a corner it turns as little as it can.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        kind : {'frenet', 'rotation_minimizing'}, default 'rotation_minimizing'
            Rotation-minimizing frames, or those of `frenet_frame`.
        start : array_like, optional
            Vector (3,) along which the normal points at the start, as far as it is at right angles to the
            curve; by default the normal there.
        closed : bool, default False
            Whether the turn of the frame at the end of a closed curve is taken back, evenly by length.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Unit vectors (..., 3, 3), one in each row.

        Raises
        ------
        InvalidShape
            If the curve is a point; with 'frenet', where it is straight or has a zero derivative; with
            `closed`, unless it closes smoothly.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If a span turns so wildly that 2^17 steps are not enough.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Wang, Jüttler, Zheng and Liu 2008; lecture row S15.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0, 0), (2, 0, 0)])
        >>> line.frames(0.5, start=(0, 0, 1)).tolist()
        [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]
        """
    def dragged(
        self,
        u: float,
        by: ArrayLike,
        tangent_by: ArrayLike | None = None,
        second_by: ArrayLike | None = None,
        *,
        factors: ArrayLike | None = None,
        locality: float = 0.0,
    ) -> NurbsCurve:
        """Move the point at a parameter by moving the control points as little as possible.

        The sum of squares of the motions is least, each divided by its factor. To bring the point to a place,
        give place - evaluate(u). Weights, knots and points at infinity stay; ends that meet move together.

        Parameters
        ----------
        u : float
            The parameter of the point.
        by : array_like
            Vector (3,) by which the point moves.
        tangent_by : array_like, optional
            Vector (3,) added to the first derivative at u; zero keeps it, None leaves it free.
        second_by : array_like, optional
            The same for the second derivative; needs `tangent_by`.
        factors : array_like, optional
            Factors (n,) of how easily each control point moves; 0 holds it. 1 where none are given.
        locality : float, default 0.0
            The larger it is, the fewer control points follow: factors are multiplied by the influence of
            a point to this power.

        Returns
        -------
        NurbsCurve
            The new curve.

        Raises
        ------
        InvalidShape
            If nothing that the point depends on may move, or too little to choose the derivatives.

        References
        ----------
        The NURBS Book, 11.5.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> curve.dragged(0.5, (0, 1, 0)).evaluate(0.5).round(9)
        array([1., 2., 0.])
        """
    def dumps(self) -> str:
        """Write the shape as JSON text.

        Returns
        -------
        str
            Text that `loads` reads back equal in every bit.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> sc.loads(curve.dumps()) == curve
        True
        """
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> NurbsCurve: ...
    def __deepcopy__(self, memo: object, /) -> NurbsCurve: ...

@final
class BezierCurve:
    """A Bezier curve over [0, 1].

    Immutable; arrays that it gives are read-only views.

    Parameters
    ----------
    points : array_like
        Control points (degree + 1, 2 or 3), in any unit of length; two coordinates lie in the xy
        plane.
    weights : array_like, optional
        Weights (degree + 1,), 1 where none are given; 0 makes a point a direction.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    The NURBS Book, chapter 1; lecture rows S6, S9, S11.

    Examples
    --------
    >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
    >>> curve.degree, curve.domain
    (2, (0.0, 1.0))
    >>> curve.evaluate(0.5)
    array([1., 1., 0.])
    """

    def __init__(self, points: ArrayLike, weights: ArrayLike | None = None) -> None: ...
    @staticmethod
    def from_homogeneous(points: ArrayLike) -> BezierCurve:
        """Make a curve from homogeneous control points.

        Parameters
        ----------
        points : array_like
            Rows (degree + 1, 4) of wx, wy, wz, w; w = 0 makes a direction.

        Returns
        -------
        BezierCurve
            The curve.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> half_circle = sc.BezierCurve.from_homogeneous([(1, 0, 0, 1), (0, 1, 0, 0), (-1, 0, 0, 1)])
        >>> half_circle.evaluate(0.5)
        array([0., 1., 0.])
        """
    @property
    def degree(self) -> int:
        """The degree.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).degree
        2
        """
    @property
    def domain(self) -> _Interval:
        """First and last parameter (start, end).

        Examples
        --------
        >>> sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)]).domain
        (0.0, 2.0)
        """
    @property
    def is_rational(self) -> bool:
        """True unless every weight is 1.

        Examples
        --------
        >>> sc.conics.circle((0, 0, 0), 1.0).is_rational, sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).is_rational
        (True, False)
        """
    @property
    def points(self) -> _Floats:
        """Control points (n, 3) float64, as given, read-only.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).points.tolist()
        [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [2.0, 0.0, 0.0]]
        """
    @property
    def weights(self) -> _Floats:
        """Weights (n,) float64, read-only. A point of weight 0 is a direction: a point at infinity.

        Examples
        --------
        >>> sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], weights=[1, 0, 1]).weights
        array([1., 0., 1.])
        """
    @property
    def homogeneous_points(self) -> _Floats:
        """Rows (n, 4) of wx, wy, wz, w; a direction keeps its coordinates. InvalidShape where one is too large
        for a number.

        Examples
        --------
        >>> sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], weights=[2, 0, 1]).homogeneous_points.tolist()
        [[2.0, 0.0, 0.0, 2.0], [0.0, 1.0, 0.0, 0.0], [-1.0, 0.0, 0.0, 1.0]]
        """
    def with_points(self, points: ArrayLike) -> BezierCurve:
        """Replace the control points, keep weights and knots.

        Parameters
        ----------
        points : array_like
            As many control points (n, 2 or 3).

        Returns
        -------
        BezierCurve
            The new curve.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> curve.with_points(curve.points + (0, 0, 1)).evaluate(0.5).tolist()
        [1.0, 1.0, 1.0]
        """
    def with_weights(self, weights: ArrayLike) -> BezierCurve:
        """Replace the weights, keep control points and knots.

        Parameters
        ----------
        weights : array_like
            As many weights (n,).

        Returns
        -------
        BezierCurve
            The new curve.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> curve = sc.BezierCurve([(1, 0), (1, 1), (0, 1)])
        >>> round(curve.with_weights([1, 0.5**0.5, 1]).length() / np.pi, 9)      # a quarter circle
        0.5
        """
    def evaluate(
        self,
        u: ArrayLike,
        *,
        side: _Side = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: _Points | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Points:
        """Evaluate points of the curve.

        A parameter has the same result in every bit in any batch and on any number of threads.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Points (..., 3) of the same units as the control points; float32 where `dtype` or `out` ask
            for it.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S6, S9, S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> arc.evaluate([0.0, 0.5, 1.0]).round(6)
        array([[1.      , 0.      , 0.      ],
               [0.707107, 0.707107, 0.      ],
               [0.      , 1.      , 0.      ]])
        """
    def derivatives(
        self,
        u: ArrayLike,
        order: SupportsIndex,
        *,
        side: _Side = "right",
        at_infinity: _AtInfinity = "raise",
        out: _Floats | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate points and their derivatives by the parameter.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        order : int
            Highest order of derivatives, 0 or more.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (..., order + 1, 3): `[..., 0, :]` are the points of `evaluate`, in every bit.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain, or a derivative is too large for a number.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        The NURBS Book, A4.2.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> curve.derivatives(0.5, 1)
        array([[1., 1., 0.],
               [2., 0., 0.]])
        """
    def pieces(self) -> list[_Interval]:
        """Find the intervals on which the curve is finite and connected.

        It is cut where the weight is zero and at knots of multiplicity degree + 1.

        Returns
        -------
        list of tuple (float, float)
            Intervals (start, end) in order.

        Examples
        --------
        >>> sc.conics.hyperbola((0, 0, 0), (1, 0, 0), (0, 1, 0))[0].pieces()
        [(0.0, 1.0)]
        >>> sc.BezierCurve([(0, 0), (1, 1), (2, 0)], weights=[1, 0, -1]).pieces()
        [(0.0, 0.5), (0.5, 1.0)]
        """
    def polylines(
        self, resolution: SupportsIndex, reach: float | None = None, around: ArrayLike | None = None
    ) -> list[tuple[_Floats, bool]]:
        """Sample the curve evenly in its parameter, one polyline for each of `pieces`.

        With a reach, a curve whose weights differ in sign ends where it leaves the box of its finite control
        points by that length in a coordinate; without one, at its last sample before infinity.

        Parameters
        ----------
        resolution : int
            Steps in every span.
        reach : float, optional
            A length beyond the box of the control points at which a curve through infinity is cut.
        around : array_like, optional
            Points (n, 2 or 3) whose box stands for that of the control points; any curve is cut there.

        Returns
        -------
        list of tuple (numpy.ndarray, bool)
            Pairs (points (m, 3), whether the polyline is closed).

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (2, 0)])
        >>> points, closed = line.polylines(2)[0]
        >>> points.tolist(), closed
        ([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], False)
        """
    def split(self, u: float) -> tuple[BezierCurve, BezierCurve]:
        """Cut the curve at a parameter by de Casteljau's algorithm.

        Parameters
        ----------
        u : float
            A parameter inside the domain.

        Returns
        -------
        tuple (BezierCurve, BezierCurve)
            (before, after), each over [0, 1].

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> before, after = sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).split(0.5)
        >>> before.points.tolist(), after.points.tolist()
        ([[0.0, 0.0, 0.0], [0.5, 1.0, 0.0], [1.0, 1.0, 0.0]], [[1.0, 1.0, 0.0], [1.5, 1.0, 0.0], [2.0, 0.0, 0.0]])
        """
    def transformed(self, matrix: ArrayLike) -> BezierCurve:
        """Apply a linear, affine or projective map.

        Under a projective map the weights change; a point that goes to infinity gets the weight 0.

        Parameters
        ----------
        matrix : array_like
            Matrix (3, 3), (3, 4) or (4, 4) that is applied to columns.

        Returns
        -------
        BezierCurve
            The image of the curve.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S9, S15.

        Examples
        --------
        >>> line = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (1, 0)])
        >>> line.transformed([[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0]]).points.tolist()
        [[5.0, 0.0, 0.0], [6.0, 0.0, 0.0]]
        """
    def translated(self, by: ArrayLike) -> BezierCurve:
        """Move the shape by a vector.

        Parameters
        ----------
        by : array_like
            Vector (2 or 3,).

        Returns
        -------
        BezierCurve
            The moved shape.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).translated((5, 0, 1)).points.tolist()
        [[5.0, 0.0, 1.0], [6.0, 2.0, 1.0]]
        """
    def rotated(self, angle: float, axis: ArrayLike = (0, 0, 1), about: ArrayLike = (0, 0, 0)) -> BezierCurve:
        """Rotate the shape about an axis, counterclockwise as seen from its tip.

        Parameters
        ----------
        angle : float
            Angle in radians.
        axis : array_like, default (0, 0, 1)
            Vector (3,) along the axis; only its direction counts.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) on the axis.

        Returns
        -------
        BezierCurve
            The rotated shape.

        Raises
        ------
        InvalidShape
            If the axis is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).rotated(np.pi, about=(1, 0)).points.round(9)[1].tolist()
        [1.0, -2.0, 0.0]
        """
    def scaled(self, factor: ArrayLike, about: ArrayLike = (0, 0, 0)) -> BezierCurve:
        """Scale the shape about a point.

        Parameters
        ----------
        factor : array_like
            A number, or one for each coordinate (3,); a negative one mirrors.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) that stays.

        Returns
        -------
        BezierCurve
            The scaled shape.

        Raises
        ------
        InvalidShape
            If a factor is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).scaled((2, -1, 1)).points[1].tolist()
        [2.0, -2.0, 0.0]
        """
    def join(self, other: _Curve, continuity: _Smoothness = "C0") -> Approximation[NurbsCurve]:
        """Append another curve of any kind.

        Points next to the joint move as little as the continuity asks. For 'C1' and 'C2' the domain of the
        other curve is scaled first.

        Parameters
        ----------
        other : curve
            The curve that follows.
        continuity : {'C0', 'G1', 'C1', 'C2'}, default 'C0'
            The continuity wanted at the joint.

        Returns
        -------
        Approximation of NurbsCurve
            Both as one curve, and the distance by which they moved, a length.

        Raises
        ------
        InvalidShape
            If a curve is periodic or an end lies at infinity.

        References
        ----------
        Lecture row S7.

        Examples
        --------
        >>> a = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (1, 0)])
        >>> b = sc.NurbsCurve(1, [0, 0, 1, 1], [(1, 0), (1, 1)])
        >>> joined, error = a.join(b)
        >>> joined.domain, error
        ((0.0, 2.0), 0.0)
        """
    def continuity_to(self, other: _Curve, tolerance: float = 1e-8) -> Continuity:
        """Measure the continuity between the end of this curve and the start of another one, of any kind.

        Parameters
        ----------
        other : curve
            The curve that follows.
        tolerance : float, default 1e-08
            Relative differences below it count as none.

        Returns
        -------
        Continuity
            The continuity.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S16.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (1, 0)])
        >>> [a.continuity_to(sc.BezierCurve([(1, 0), end])).g for end in ((3, 0), (1, 1))]
        [2, 0]
        """
    @property
    def is_closed(self) -> bool:
        """Whether the curve is in one piece and ends exactly where it begins.

        Examples
        --------
        >>> sc.conics.circle((0, 0, 0), 1.0).is_closed, sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).is_closed
        (True, False)
        """
    def reversed(self) -> BezierCurve:
        """Reverse the direction of the curve.

        Returns
        -------
        BezierCurve
            The same points in the opposite direction.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).reversed().points.tolist()
        [[2.0, 0.0, 0.0], [1.0, 2.0, 0.0], [0.0, 0.0, 0.0]]
        """
    def to_bezier(self) -> list[BezierCurve]:
        """Convert to Bezier curves, one for each span.

        Returns
        -------
        list of BezierCurve
            Bezier curves in order.

        References
        ----------
        The NURBS Book, A5.6.

        Examples
        --------
        >>> curve = sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0), (1, 1), (2, 1), (3, 0)])
        >>> len(curve.to_bezier())
        2
        """
    def to_hermite(self) -> HermiteCurve:
        """Convert to a chain of cubics.

        Returns
        -------
        HermiteCurve
            The same curve.

        Raises
        ------
        InvalidShape
            If it is rational, has a gap, or its degree is above 3.

        Examples
        --------
        >>> chain = sc.BezierCurve([(0, 0), (1, 3), (2, 3), (3, 0)]).to_hermite()
        >>> chain.tangents[:, 1].tolist()
        [[3.0, 9.0, 0.0], [3.0, -9.0, 0.0]]
        """
    def to_nurbs(self) -> NurbsCurve:
        """Convert to a NURBS curve.

        Returns
        -------
        NurbsCurve
            The same curve.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).to_nurbs().knots
        array([0., 0., 0., 1., 1., 1.])
        """
    def to_power(self, origin: float = 0.0) -> PowerCurve:
        """Convert to powers of t - origin.

        Exact but for rounding of the coefficients, which cancel: relative to the points that costs 1e-15 at
        degree 10 about the middle 0.5, 1e-12 about an end and 1e-2 about 10; at degree 20 1e-14, 1e-8 and all
        digits.

        Parameters
        ----------
        origin : float, default 0.0
            The parameter at which the powers are zero.

        Returns
        -------
        PowerCurve
            The same curve.

        Raises
        ------
        InvalidShape
            If a coefficient overflows.

        References
        ----------
        Lecture row S2.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).to_power().coefficients
        array([[ 0.,  0.,  0.],
               [ 2.,  4.,  0.],
               [ 0., -4.,  0.]])
        """
    def elevate(self, times: SupportsIndex = 1) -> BezierCurve:
        """Raise the degree without changing the curve.

        Parameters
        ----------
        times : int, default 1
            By how much.

        Returns
        -------
        BezierCurve
            The same curve.

        Raises
        ------
        InvalidShape
            If `times` is below 0 or the degree would exceed 255.

        References
        ----------
        The NURBS Book, eq. 5.36; lecture row S6.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (2, 0)]).elevate().points.tolist()
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]
        """
    def reduce(self, times: SupportsIndex = 1, tolerance: float | None = None) -> Approximation[BezierCurve]:
        """Lower the degree, with the same ends.

        Each step takes the nearest such curve, by the constrained Chebyshev polynomial.

        Parameters
        ----------
        times : int, default 1
            By how much.
        tolerance : float, optional
            The largest error allowed, a length; by default any.

        Returns
        -------
        Approximation of BezierCurve
            The new curve and its error: exact for one step on a polynomial curve, otherwise an upper
            bound.

        Raises
        ------
        InvalidShape
            If the weights have different signs.
        ToleranceNotReached
            If the error exceeds the tolerance.

        References
        ----------
        Lachance 1988; lecture row S6.

        Examples
        --------
        >>> curve, error = sc.BezierCurve([(0, 0), (1, 1), (2, 0)]).reduce()
        >>> curve.degree, round(error, 9)
        (1, 0.5)
        """
    def flatten(self, tolerance: float) -> tuple[_Floats, _Floats]:
        """Approximate the curve by a polyline within a tolerance.

        Parts are halved until their hulls are flat enough, which also holds for rational curves.

        Parameters
        ----------
        tolerance : float
            The largest error allowed, a length in units of the points.

        Returns
        -------
        tuple (numpy.ndarray, numpy.ndarray)
            Parameters (m,) and points (m, 3).

        Raises
        ------
        InvalidShape
            If 2^18 points do not reach the tolerance.
        PointAtInfinity
            If the curve runs to infinity.

        References
        ----------
        Lecture row S6.

        Examples
        --------
        >>> parameters, points = sc.BezierCurve([(0, 0), (1, 1), (2, 0)]).flatten(0.2)
        >>> parameters
        array([0.  , 0.25, 0.5 , 0.75, 1.  ])
        """
    def finite_arcs(self, length: float) -> list[NurbsCurve]:
        """Clip a curve that runs to infinity to a box around its finite control points.

        Every arc is the curve itself on a part of its domain, with positive weights and no control point
        farther outside than twice the length.

        Parameters
        ----------
        length : float
            How far the box reaches beyond the finite control points, in each coordinate.

        Returns
        -------
        list of NurbsCurve
            The arcs in order.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S10, S11.

        Examples
        --------
        >>> right, left = sc.conics.hyperbola((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> arcs = right.finite_arcs(3.0)
        >>> len(arcs), bool(np.all(arcs[0].weights > 0))
        (1, True)
        """
    def moebius(self, rho: float) -> BezierCurve:
        """Change the parameter to t = rho u / ((1 - u) + rho u): weights are multiplied by rho**i.

        Parameters
        ----------
        rho : float
            A positive number; 1 changes nothing.

        Returns
        -------
        BezierCurve
            The same curve under another parameter.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S12.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> line.moebius(3.0).weights.tolist(), line.moebius(3.0).evaluate(0.5).tolist()
        ([1.0, 3.0], [3.0, 0.0, 0.0])
        """
    def multiplied(self, start: float, end: float) -> BezierCurve:
        """Multiply the homogeneous coordinates by a linear function; the degree grows by one, weights change,
        the curve stays.

        A periodic curve becomes a plain one.

        Parameters
        ----------
        start : float
            The function at the start of the domain, a number from 1e-100 to 1e100.
        end : float
            The function at the end, such a number.

        Returns
        -------
        BezierCurve
            The same curve.

        Raises
        ------
        InvalidShape
            If a number is not within these limits, if a weight would leave the range of numbers, and if
            the degree would exceed 255.

        References
        ----------
        Lecture row S9.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (2, 0)]).multiplied(1, 3).weights.tolist()
        [1.0, 2.0, 3.0]
        """
    def standard_form(self) -> BezierCurve:
        """Change the parameter so that the weights of both ends are 1.

        Returns
        -------
        BezierCurve
            The same curve.

        Raises
        ------
        InvalidShape
            Unless both end weights have one sign and the curve is clamped.

        References
        ----------
        Lecture row S12.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 1), (2, 0)], weights=[1, 2, 4]).standard_form().weights.tolist()
        [1.0, 1.0, 1.0]
        """
    def casteljau_triangle(self, u: float) -> list[_Floats]:
        """All rows of de Casteljau's algorithm on homogeneous points.

        Parameters
        ----------
        u : float
            Any finite parameter; outside [0, 1] it extrapolates.

        Returns
        -------
        list of numpy.ndarray
            Arrays (k, 4) of wx, wy, wz, w for k = degree + 1, degree, …, 1.

        Raises
        ------
        InvalidShape
            If a number would be too large.

        References
        ----------
        Lecture row S9.

        Examples
        --------
        >>> rows = sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).casteljau_triangle(0.5)
        >>> [row[:, :2].tolist() for row in rows]
        [[[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]], [[0.5, 1.0], [1.5, 1.0]], [[1.0, 1.0]]]
        """
    def rational_casteljau_triangle(self, u: float) -> tuple[list[_Floats], tuple[int, int, str] | None]:
        """All rows of the rational de Casteljau algorithm.

        Parameters
        ----------
        u : float
            Any finite parameter; outside [0, 1] it extrapolates.

        Returns
        -------
        tuple (list of numpy.ndarray, tuple (int, int, str) or None)
            Arrays (k, 4) of x, y, z, w, and None; or the rows before a division by zero or an overflow,
            and (row, index, reason).

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Farin 1983; lecture row S9.

        Examples
        --------
        >>> rows, stopped = sc.BezierCurve([(0, 0), (4, 0)], weights=[1, 3]).rational_casteljau_triangle(0.5)
        >>> rows[-1].tolist(), stopped
        ([[3.0, 0.0, 0.0, 2.0]], None)
        """
    def length(self, start: float | None = None, end: float | None = None, *, tolerance: float = 1e-13,
               cancel: _Cancel | None = None) -> float:
        """Measure the length between two parameters.

        Adaptive quadrature of Gauss and Kronrod on every span, also through cusps. On a periodic curve start
        and end may be any numbers in order: turns are counted.

        Parameters
        ----------
        start : float, optional
            Where to begin; by default the start of the domain.
        end : float, optional
            Where to end; by default the end of the domain.
        tolerance : float, default 1e-13
            The largest relative error; rounding of the coordinates may be more.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        float
            The length, in units of the points.

        Raises
        ------
        InvalidShape
            Unless start <= end, in the domain of a curve that is not periodic.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work; the message names an error that can be had.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> round(arc.length(), 12), round(arc.length(0.0, 0.5), 12)
        (1.570796326795, 0.785398163397)
        """
    def parameter_at_length(
        self, s: ArrayLike, *, tolerance: float = 1e-10, cancel: _Cancel | None = None
    ) -> _Floats:
        """Find the parameters at given lengths from the start.

        Parameters
        ----------
        s : array_like
            Lengths (...,) from the start of the domain; a periodic curve takes any.
        tolerance : float, default 1e-10
            The largest error of the length, relative to that of the curve.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Parameters (...,).

        Raises
        ------
        InvalidShape
            If a length is below 0 or above that of the curve.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).parameter_at_length([1.0, 2.0]).round(9)
        array([0.25, 0.5 ])
        """
    def divide(self, count: int, *, tolerance: float = 1e-10, cancel: _Cancel | None = None) -> _Floats:
        """Divide the curve into parts of equal length.

        Parameters
        ----------
        count : int
            How many parts, 1 to 2^22.
        tolerance : float, default 1e-10
            The largest error of the length, relative to that of the curve.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Parameters (count + 1,) with both ends; (count,) where the curve closes.

        Raises
        ------
        InvalidShape
            If the count is out of range or the curve has no length.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).divide(4).round(9)
        array([0.  , 0.25, 0.5 , 0.75, 1.  ])
        """
    def divide_by_length(self, step: float, *, tolerance: float = 1e-10, cancel: _Cancel | None = None) -> _Floats:
        """Divide the curve by steps of a given length from its start.

        Parameters
        ----------
        step : float
            Length of a step.
        tolerance : float, default 1e-10
            The largest error of the length, relative to that of the curve.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Parameters (n,) at 0, step, 2 step, … up to the length of the curve, without the end of a
            closed curve.

        Raises
        ------
        InvalidShape
            Unless step > 0, or if there are more than 2^22 steps.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).divide_by_length(1.5).round(9)
        array([0.   , 0.375, 0.75 ])
        """
    def curvature(self, u: ArrayLike, *, side: _Side = "right") -> _Floats:
        """Measure the curvature |C' x C''| / |C'|³.

        Where C' falls to zero it is the limit, inf at a sharp cusp; NaN where the curve is a point.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Curvatures (...,), in 1 / length.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S15, S16.

        Examples
        --------
        >>> arc = sc.BezierCurve([(2, 0), (2, 2), (0, 2)], weights=[1, 0.5**0.5, 1])
        >>> arc.curvature([0.0, 0.5]).round(12)
        array([0.5, 0.5])
        """
    def signed_curvature(
        self, u: ArrayLike, normal: ArrayLike | None = None, *, side: _Side = "right",
    ) -> _Floats:
        """Measure the curvature of a plane curve, positive where it bends to its left.

        Of a curve that is not plane it is the part of the curvature about the normal. Limits as of
        `curvature`.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        normal : array_like, optional
            Vector (3,) that the curve is seen against; by default the normal of its plane, towards +z.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Curvatures (...,), in 1 / length.

        Raises
        ------
        InvalidShape
            If no normal is given and the curve lies in no plane.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(2, 0), (2, 2), (0, 2)], weights=[1, 0.5**0.5, 1])
        >>> arc.reversed().signed_curvature([0.0, 0.5]).round(12)
        array([-0.5, -0.5])
        """
    def nearest(
        self, points: ArrayLike, *, threads: int = 0, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find the nearest point of the curve to each of several points.

        The global minimum: ends, corners and gaps are included. Of several places at one distance the one
        with the smallest parameter is taken. Where the curve passes through infinity its finite part counts.
        A point has the same result in any batch.

        Parameters
        ----------
        points : array_like
            Points (..., 2 or 3).
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            Parameters, points and distances, right to a few roundings of the size of the curve.

        Raises
        ------
        InvalidShape
            If a point is not finite.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998; lecture row S15.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> found = line.nearest([(1, 3), (9, 0)])
        >>> found.parameters, found.distances
        (array([0.25, 1.  ]), array([3., 5.]))
        """
    def intersections(
        self, other: _Curve, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Intersections:
        """Find where the curve meets another one.

        Places where the distance of both is least and within the tolerance, ends included, and stretches that
        both have in common.

        Parameters
        ----------
        other : curve
            A curve of any kind.
        tolerance : float, optional
            The largest distance of both curves, a length; by default 2^-33 of the extent of the control
            points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Intersections
            The places in the order of the parameters of this curve, and the stretches.

        Raises
        ------
        InvalidShape
            If more than 2^22 pairs of parts are within the tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Sederberg and Meyers 1988; lecture row S18.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (2, 2)])
        >>> b = sc.BezierCurve([(0, 2), (2, 0)])
        >>> a.intersections(b).points.round(9)
        array([[1., 1., 0.]])
        """
    def self_intersections(
        self, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Intersections:
        """Find where the curve meets itself.

        Places next to each other along the curve, as at a cusp, and the seam of a closed curve do not count.

        Parameters
        ----------
        tolerance : float, optional
            The largest distance, a length; by default 2^-33 of the extent of the control points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Intersections
            The places as of `intersections`: the first parameter is the smaller one.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> loop = sc.BezierCurve([(0, 0), (3, 2), (-2, 2), (1, 0)])
        >>> loop.self_intersections().points[:, 0].round(9).tolist()
        [0.5]
        """
    def patch_intersections(
        self, patch: _Patch, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> PatchIntersections:
        """Find where the curve meets a patch.

        Places where the distance of both is least and within the tolerance, ends of the curve included, and
        stretches that lie on the patch.

        Parameters
        ----------
        patch : patch
            A patch of any kind.
        tolerance : float, optional
            The largest distance of both, a length; by default 2^-33 of the extent of the control points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        PatchIntersections
            The places in the order of the parameters of the curve, and the stretches.

        Raises
        ------
        InvalidShape
            If more than 2^20 pairs of parts are within the tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0.5, 0.5, -1), (0.5, 0.5, 1)])
        >>> plane = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> line.patch_intersections(plane).parameters.round(9)
        array([[0.5, 0.5, 0.5]])
        """
    def plane_intersections(
        self, origin: ArrayLike, normal: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> PatchIntersections:
        """Find where the curve meets a plane.

        Parameters on the plane are its coordinates, with axes by the rule of DXF files: x and y where the
        normal is z.

        Parameters
        ----------
        origin : array_like
            Point (3,) of the plane.
        normal : array_like
            Vector (3,) at right angles to the plane.
        tolerance : float, optional
            The largest distance, a length; by default 2^-33 of the extent of the control points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        PatchIntersections
            The places and stretches, as of `patch_intersections`.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0, -1), (0, 0, 3)])
        >>> curve.plane_intersections((0, 0, 0), (0, 0, 1)).parameters[:, 0].round(9)
        array([0.25])
        """
    def part(self, start: float, end: float) -> NurbsCurve:
        """Cut out the part between two parameters, over that part of the domain.

        Parameters
        ----------
        start : float
            Where to begin.
        end : float
            Where to end; on a closed curve up to a turn behind the start.

        Returns
        -------
        NurbsCurve
            The part.

        Raises
        ------
        InvalidShape
            Unless start < end in the domain, or over the seam of a closed curve.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).part(0.25, 0.75).domain
        (0.25, 0.75)
        """
    def parts(self, parameters: ArrayLike) -> list[NurbsCurve]:
        """Cut the curve at several parameters.

        The ends of an open curve cut nothing. The last part of a closed curve continues over the seam.

        Parameters
        ----------
        parameters : array_like
            Parameters (n,) in the domain.

        Returns
        -------
        list of NurbsCurve
            The parts in order.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> [round(part.length(), 9) for part in sc.BezierCurve([(0, 0), (4, 0)]).parts([0.25, 0.5])]
        [1.0, 1.0, 2.0]
        """
    def split_by(self, others: Sequence[_Curve], *, cancel: _Cancel | None = None) -> list[NurbsCurve]:
        """Cut the curve where it meets other curves.

        Parameters
        ----------
        others : sequence of curves
            Curves of any kinds.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        list of NurbsCurve
            The parts in order.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> [round(part.length(), 9) for part in line.split_by([sc.BezierCurve([(1, -1), (1, 1)])])]
        [1.0, 3.0]
        """
    def trimmed(self, others: Sequence[_Curve], at: float, *, cancel: _Cancel | None = None) -> list[NurbsCurve]:
        """Remove the part of the curve about a parameter, between where it meets other curves.

        Parameters
        ----------
        others : sequence of curves
            Curves of any kinds.
        at : float
            A parameter of the part that is removed.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        list of NurbsCurve
            One or two curves.

        Raises
        ------
        InvalidShape
            If they do not meet, or a closed curve meets them in one place alone.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> others = [sc.BezierCurve([(x, -1), (x, 1)]) for x in (1, 3)]
        >>> [round(part.length(), 9) for part in line.trimmed(others, 0.5)]
        [1.0, 1.0]
        """
    def extended(
        self, length: float, at: Literal["start", "end"] = "end", how: _Extension = "natural"
    ) -> NurbsCurve:
        """Extend the curve at one end by a length.

        Parameters stay, the domain grows.

        Parameters
        ----------
        length : float
            How far, above 0.
        at : {'start', 'end'}, default 'end'
            The end.
        how : {'natural', 'arc', 'straight'}, default 'natural'
            By the polynomials of the last span ('natural'), along the circle of curvature ('arc'), or
            along the tangent ('straight').

        Returns
        -------
        NurbsCurve
            The longer curve.

        Raises
        ------
        InvalidShape
            If the curve is closed or has a zero derivative at its end, an arc would exceed its circle, or
            the curve runs to infinity before that length.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> round(sc.BezierCurve([(0, 0), (4, 0)]).extended(1.0).length(), 9)
        5.0
        """
    def extended_to(
        self,
        others: Sequence[_Curve],
        at: Literal["start", "end"] = "end",
        how: _Extension = "natural",
        *,
        cancel: _Cancel | None = None,
    ) -> NurbsCurve:
        """Extend the curve at one end to where it first meets other curves.

        Parameters
        ----------
        others : sequence of curves
            Curves of any kinds.
        at : {'start', 'end'}, default 'end'
            The end.
        how : {'natural', 'arc', 'straight'}, default 'natural'
            As of `extended`.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        NurbsCurve
            The longer curve.

        Raises
        ------
        InvalidShape
            If it meets none of them within four times the size of all, or as of `extended`.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> round(line.extended_to([sc.BezierCurve([(6, -1), (6, 1)])]).length(), 9)
        6.0
        """
    def rounded(self, radius: float, *, shrink: bool = False, cancel: _Cancel | None = None) -> NurbsCurve:
        """Replace every corner by an arc that touches both sides.

        Parameters
        ----------
        radius : float
            Radius of the arcs, above 0.
        shrink : bool, default False
            Whether an arc that does not fit gets the largest radius that does, instead of an error: it
            takes at most half of the curve up to the next corner, or all of it up to an end. Where the
            curve turns back the corner stays.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        NurbsCurve
            The curve with arcs, at the seam of a closed curve too.

        Raises
        ------
        InvalidShape
            If no such arc fits between the neighbors of a corner, or the curve turns back or is not plane
            there.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> corner = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (4, 0), (4, 4)])
        >>> round(corner.rounded(1.0).length() - np.pi / 2, 9)
        6.0
        >>> round(corner.rounded(9.0, shrink=True).length() / np.pi, 9)
        2.0
        """
    def chamfered(self, length: float, *, shrink: bool = False, cancel: _Cancel | None = None) -> NurbsCurve:
        """Replace every corner by a line.

        Parameters
        ----------
        length : float
            How far the line begins before the corner and ends behind it, measured along the curve.
        shrink : bool, default False
            Whether it begins and ends nearer to a corner that has no room, as of `rounded`, instead of an
            error.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        NurbsCurve
            The curve with lines.

        Raises
        ------
        InvalidShape
            If a corner has no room for it.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> corner = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (4, 0), (4, 4)])
        >>> round(corner.chamfered(1.0).length() - 2**0.5, 9)
        6.0
        """
    def offset(
        self,
        distance: float,
        normal: ArrayLike = (0, 0, 1),
        *,
        tolerance: float | None = None,
        corner: Literal["round", "sharp"] = "round",
        trimmed: bool = False,
        cancel: _Cancel | None = None,
    ) -> list[NurbsCurve]:
        """Offset a plane curve to its left.

        Lines and arcs of circles are moved exactly; other spans become cubics within the tolerance.

        Parameters
        ----------
        distance : float
            How far, to the left seen against the normal, to the right where it is negative.
        normal : array_like, default (0, 0, 1)
            Normal (3,) of the plane of the curve.
        tolerance : float, optional
            The largest error, a length; by default 2^-20 of the size.
        corner : {'round', 'sharp'}, default 'round'
            At corners an arc, or the corner of both tangents up to four times the distance away.
        trimmed : bool, default False
            Whether parts that are nearer to the curve than the distance are removed.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        list of NurbsCurve
            The offset; several curves where the curve has gaps or the offset is trimmed.

        Raises
        ------
        InvalidShape
            If the curve is not in a plane with that normal, the distance is zero or not finite, or
            nothing is left.
        ToleranceNotReached
            If the tolerance is not reached.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Tiller and Hanson 1984; lecture row S18.

        Examples
        --------
        >>> circle = sc.conics.circle((0, 0, 0), 2.0)
        >>> round(circle.offset(0.5)[0].length() / (2 * np.pi), 9)      # inwards
        1.5
        """
    def least_distance(
        self, other: _Curve | _Patch | PatchSet, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> LeastDistance:
        """Find where this shape and another one are nearest to each other.

        The global minimum, ends and borders included. Of several places at one distance it is any of them.

        Parameters
        ----------
        other : curve or patch or PatchSet
            A curve or patch of any kind, or a set of patches.
        tolerance : float, optional
            How much nearer they may be elsewhere, a length; by default 2^-33 of the size of both.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        LeastDistance
            The distance, with parameters and points on both shapes, and which patches of sets they are
            on.

        Raises
        ------
        InvalidShape
            If the tolerance is negative, or bent shapes are at one distance all along: give a larger
            tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998; lecture row S18.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (4, 0)])
        >>> b = sc.BezierCurve([(1, 3), (3, 1)])
        >>> a.least_distance(b).distance
        1.0
        """
    def stationary_points(self, point: ArrayLike, *, cancel: _Cancel | None = None) -> StationaryPoints:
        """Find all places where the distance from a point is stationary.

        These are the feet of all normals through the point, the ends of the curve and of its pieces, and
        corners where the distance is a minimum or a maximum.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        StationaryPoints
            The places in the order of their parameters, each once.

        Raises
        ------
        InvalidShape
            If the point is not finite or too far away, or where the distance is constant, as from the
            center of a circle.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lane and Riesenfeld 1981; lecture row S15.

        Examples
        --------
        >>> found = sc.BezierCurve([(0, 0), (4, 0)]).stationary_points((1, 2))
        >>> found.parameters.round(9).tolist(), found.kinds
        ([0.0, 0.25, 1.0], ('maximum', 'minimum', 'maximum'))
        """
    def nearest_all(
        self, point: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find all places where the distance from a point is a minimum that is nearly the least one.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        tolerance : float, optional
            By how much the distance may exceed the least one, a length; by default a few roundings.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            The places in the order of their parameters (n,).

        Raises
        ------
        InvalidShape
            If the point is not finite, or where the distance is constant.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> bow = sc.BezierCurve([(-1, 1), (0, -1), (1, 1)])
        >>> bow.nearest_all((0, 2)).points[:, 0].round(6).tolist()
        [-1.0, 1.0]
        """
    def rebuild(
        self,
        count: SupportsIndex | None = None,
        degree: SupportsIndex | None = None,
        *,
        tolerance: float | None = None,
        ends: Literal["points", "tangents"] = "points",
        cancel: _Cancel | None = None,
    ) -> Approximation[NurbsCurve]:
        """Approximate by a polynomial curve with even knots over the same domain.

        It is nearest in the integral of the squared distance at equal parameters, and periodic if the curve
        is.

        Parameters
        ----------
        count : int, optional
            Number of control points; with a tolerance the most.
        degree : int, optional
            Degree; by default that of the curve.
        tolerance : float, optional
            As few control points as come within it, a length.
        ends : {'points', 'tangents'}, default 'points'
            Of an open curve the end points stay, or the tangents there too.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsCurve
            The new curve, and the largest distance at equal parameters, at most 1 % above the truth.

        Raises
        ------
        InvalidShape
            If the count is below the number that the degree needs.
        ToleranceNotReached
            If the tolerance is not reached.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S17.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> curve, error = arc.rebuild(degree=3, tolerance=1e-4)
        >>> curve.is_rational, error <= 1e-4
        (False, True)
        """
    def fair(
        self, tolerance: float, *, ends: Literal["points", "tangents"] = "points", cancel: _Cancel | None = None
    ) -> Approximation[NurbsCurve]:
        """Smooth the curve within a tolerance.

        Knots and weights stay; the integral of the squared second derivative becomes as small as the
        tolerance allows.

        Parameters
        ----------
        tolerance : float
            The largest distance at equal parameters, a length above 0.
        ends : {'points', 'tangents'}, default 'points'
            Of an open curve the end points stay, or the tangents there too.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsCurve
            The new curve and the largest distance at equal parameters, at most 1 % above the truth.

        Raises
        ------
        InvalidShape
            Unless the tolerance is positive and the degree is 2 at least.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Reinsch 1967; lecture row S17.

        Examples
        --------
        >>> noisy = sc.BezierCurve([(0, 0), (1, 0.1), (2, -0.1), (3, 0)])
        >>> smooth, error = noisy.fair(0.01)
        >>> bool(np.ptp(smooth.points[:, 1]) < np.ptp(noisy.points[:, 1])), error <= 0.01
        (True, True)
        """
    def torsion(self, u: ArrayLike, *, side: _Side = "right") -> _Floats:
        """Measure the torsion det(C', C'', C''') / |C' x C''|², positive for a right-handed screw.

        At an inflection or a cusp it is the limit; NaN on a straight line.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Torsions (...,), in 1 / length.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]).torsion(0.0).item()
        3.0
        """
    def inflections(self, direction: ArrayLike | None = None) -> _Floats:
        """Find the parameters where the curve begins to bend to the other side.

        All sign changes of the signed curvature; the middle of a straight part between two bends. Corners do
        not count.

        Parameters
        ----------
        direction : array_like, optional
            Vector (3,) that the curve is seen against; by default the normal of its plane.

        Returns
        -------
        numpy.ndarray
            Parameters (n,) in order.

        Raises
        ------
        InvalidShape
            If no direction is given and the curve lies in no plane.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 1), (2, -1), (3, 0)]).inflections().round(9)
        array([0.5])
        """
    def extrema(self, direction: ArrayLike) -> _Floats:
        """Find the parameters where the curve has an extremum along a direction.

        All zeros of the derivative along it, both ends of a part at right angles to it, corners where it
        changes sign, and the ends of the curve and of its pieces.

        Parameters
        ----------
        direction : array_like
            Vector (3,).

        Returns
        -------
        numpy.ndarray
            Parameters (n,) in order.

        Raises
        ------
        InvalidShape
            If the direction is zero.
        PointAtInfinity
            If the curve runs to infinity.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).extrema((0, 1, 0))
        array([0. , 0.5, 1. ])
        """
    def bounding_box(self) -> _Floats:
        """Find the smallest box along the axes that contains the curve.

        Not that of the control points: right to a few roundings of the largest coordinate.

        Returns
        -------
        numpy.ndarray
            Array (2, 3) of the lowest and the highest corner.

        Raises
        ------
        PointAtInfinity
            If the curve runs to infinity.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).bounding_box().tolist()
        [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0]]
        """
    def signed_area(self, normal: ArrayLike = (0.0, 0.0, 1.0), *, tolerance: float = 1e-12) -> float:
        """Measure the area inside a closed curve, positive where it lies to the left.

        Parts enclosed twice count twice. For a curve that is not plane it is the area of its projection along
        the normal. Exact, but for rounding, for polynomial curves.

        Parameters
        ----------
        normal : array_like, default (0.0, 0.0, 1.0)
            Vector (3,) that the curve is seen against.
        tolerance : float, default 1e-12
            The largest relative error for rational curves.

        Returns
        -------
        float
            The area, in square units of the points.

        Raises
        ------
        InvalidShape
            If the ends are apart by more than 1e-9 of the size or the curve is in several pieces.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> round(sc.conics.circle((0, 0, 0), 2.0).signed_area(), 9)
        12.566370614
        """
    def winding_number(self, point: ArrayLike, normal: ArrayLike = (0.0, 0.0, 1.0)) -> int | NDArray[np.int64]:
        """Count how often a closed curve winds around a point, or each of several points, to the left.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,), or points (..., 2 or 3).
        normal : array_like, default (0.0, 0.0, 1.0)
            Vector (3,) that the curve is seen against.

        Returns
        -------
        int or numpy.ndarray
            The winding number, 0 outside; of points an int64 array (...,).

        Raises
        ------
        InvalidShape
            If a point lies on the curve up to 1e-12 of its size, or the curve is not closed.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> circle = sc.conics.circle((0, 0, 0), 2.0)
        >>> circle.winding_number((1, 0, 0)), circle.winding_number((3, 0, 0))
        (1, 0)
        >>> circle.winding_number([(1, 0), (3, 0)])
        array([1, 0])
        """
    def frenet_frame(self, u: ArrayLike, *, side: _Side = "right") -> _Floats:
        """Evaluate tangent, normal and binormal of Frenet's frame.

        Limits are taken where a derivative falls to zero. Normal and binormal are NaN where the curve is
        straight.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Unit vectors (..., 3, 3), one in each row.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> tangent, normal, binormal = arc.frenet_frame(0.0)
        >>> normal.round(12).tolist()[0]
        -1.0
        """
    def frames(
        self, u: ArrayLike, kind: Literal["frenet", "rotation_minimizing"] = "rotation_minimizing", *,
        start: ArrayLike | None = None, closed: bool = False, side: _Side = "right", cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate frames of tangent, normal and binormal along the curve.

        Rotation-minimizing frames turn around the tangent as little as possible, from the start of the
        domain, to about 1e-9. Straight parts keep the frame; at a corner it turns as little as it can.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        kind : {'frenet', 'rotation_minimizing'}, default 'rotation_minimizing'
            Rotation-minimizing frames, or those of `frenet_frame`.
        start : array_like, optional
            Vector (3,) along which the normal points at the start, as far as it is at right angles to the
            curve; by default the normal there.
        closed : bool, default False
            Whether the turn of the frame at the end of a closed curve is taken back, evenly by length.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Unit vectors (..., 3, 3), one in each row.

        Raises
        ------
        InvalidShape
            If the curve is a point; with 'frenet', where it is straight or has a zero derivative; with
            `closed`, unless it closes smoothly.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If a span turns so wildly that 2^17 steps are not enough.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Wang, Jüttler, Zheng and Liu 2008; lecture row S15.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0, 0), (2, 0, 0)])
        >>> line.frames(0.5, start=(0, 0, 1)).tolist()
        [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]
        """
    def dragged(
        self,
        u: float,
        by: ArrayLike,
        tangent_by: ArrayLike | None = None,
        second_by: ArrayLike | None = None,
        *,
        factors: ArrayLike | None = None,
        locality: float = 0.0,
    ) -> BezierCurve:
        """Move the point at a parameter by moving the control points as little as possible.

        The sum of squares of the motions is least, each divided by its factor. To bring the point to a place,
        give place - evaluate(u). Weights, knots and points at infinity stay; ends that meet move together.

        Parameters
        ----------
        u : float
            The parameter of the point.
        by : array_like
            Vector (3,) by which the point moves.
        tangent_by : array_like, optional
            Vector (3,) added to the first derivative at u; zero keeps it, None leaves it free.
        second_by : array_like, optional
            The same for the second derivative; needs `tangent_by`.
        factors : array_like, optional
            Factors (n,) of how easily each control point moves; 0 holds it. 1 where none are given.
        locality : float, default 0.0
            The larger it is, the fewer control points follow: factors are multiplied by the influence of
            a point to this power.

        Returns
        -------
        BezierCurve
            The new curve.

        Raises
        ------
        InvalidShape
            If nothing that the point depends on may move, or too little to choose the derivatives.

        References
        ----------
        The NURBS Book, 11.5.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> curve.dragged(0.5, (0, 1, 0)).evaluate(0.5).round(9)
        array([1., 2., 0.])
        """
    def dumps(self) -> str:
        """Write the shape as JSON text.

        Returns
        -------
        str
            Text that `loads` reads back equal in every bit.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> sc.loads(curve.dumps()) == curve
        True
        """
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> BezierCurve: ...
    def __deepcopy__(self, memo: object, /) -> BezierCurve: ...

@final
class HermiteCurve:
    """A chain of cubics through points with given derivatives.

    Immutable; arrays that it gives are read-only views.

    Parameters
    ----------
    points : array_like
        Points (n, 2 or 3), in any unit of length.
    tangents : array_like
        Derivatives by the parameter: (n, 2 or 3), or (n, 2, 3) for incoming and outgoing ones.
    parameters : array_like, optional
        Increasing parameters (n,); 0, 1, 2, … where none are given.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S4.

    Examples
    --------
    >>> curve = sc.HermiteCurve([(0, 0), (1, 0)], [(0, 1), (0, 1)])
    >>> curve.evaluate(0.5)
    array([0.5, 0. , 0. ])
    """

    def __init__(
        self, points: ArrayLike, tangents: ArrayLike, parameters: ArrayLike | None = None
    ) -> None: ...
    @property
    def degree(self) -> int:
        """The degree.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).degree
        2
        """
    @property
    def domain(self) -> _Interval:
        """First and last parameter (start, end).

        Examples
        --------
        >>> sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)]).domain
        (0.0, 2.0)
        """
    @property
    def is_rational(self) -> bool:
        """True unless every weight is 1.

        Examples
        --------
        >>> sc.conics.circle((0, 0, 0), 1.0).is_rational, sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).is_rational
        (True, False)
        """
    @property
    def points(self) -> _Floats:
        """Points (n, 3) float64, read-only.

        Examples
        --------
        >>> sc.HermiteCurve([(0, 0), (1, 0)], [(0, 1), (0, 1)]).points.tolist()
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]
        """
    @property
    def tangents(self) -> _Floats:
        """Derivatives (n, 2, 3) float64, incoming and outgoing, read-only.

        Examples
        --------
        >>> sc.HermiteCurve([(0, 0), (1, 0)], [(0, 1), (0, 1)]).tangents.shape
        (2, 2, 3)
        """
    @property
    def parameters(self) -> _Floats:
        """Parameters (n,) float64 of the points, read-only.

        Examples
        --------
        >>> sc.HermiteCurve([(0, 0), (1, 0)], [(0, 1), (0, 1)]).parameters
        array([0., 1.])
        """
    def evaluate(
        self,
        u: ArrayLike,
        *,
        side: _Side = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: _Points | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Points:
        """Evaluate points of the curve.

        A parameter has the same result in every bit in any batch and on any number of threads.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Points (..., 3) of the same units as the control points; float32 where `dtype` or `out` ask
            for it.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S6, S9, S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> arc.evaluate([0.0, 0.5, 1.0]).round(6)
        array([[1.      , 0.      , 0.      ],
               [0.707107, 0.707107, 0.      ],
               [0.      , 1.      , 0.      ]])
        """
    def derivatives(
        self,
        u: ArrayLike,
        order: SupportsIndex,
        *,
        side: _Side = "right",
        at_infinity: _AtInfinity = "raise",
        out: _Floats | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate points and their derivatives by the parameter.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        order : int
            Highest order of derivatives, 0 or more.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (..., order + 1, 3): `[..., 0, :]` are the points of `evaluate`, in every bit.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain, or a derivative is too large for a number.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        The NURBS Book, A4.2.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> curve.derivatives(0.5, 1)
        array([[1., 1., 0.],
               [2., 0., 0.]])
        """
    def pieces(self) -> list[_Interval]:
        """Find the intervals on which the curve is finite and connected.

        It is cut where the weight is zero and at knots of multiplicity degree + 1.

        Returns
        -------
        list of tuple (float, float)
            Intervals (start, end) in order.

        Examples
        --------
        >>> sc.conics.hyperbola((0, 0, 0), (1, 0, 0), (0, 1, 0))[0].pieces()
        [(0.0, 1.0)]
        >>> sc.BezierCurve([(0, 0), (1, 1), (2, 0)], weights=[1, 0, -1]).pieces()
        [(0.0, 0.5), (0.5, 1.0)]
        """
    def polylines(
        self, resolution: SupportsIndex, reach: float | None = None, around: ArrayLike | None = None
    ) -> list[tuple[_Floats, bool]]:
        """Sample the curve evenly in its parameter, one polyline for each of `pieces`.

        With a reach, a curve whose weights differ in sign ends where it leaves the box of its finite control
        points by that length in a coordinate; without one, at its last sample before infinity.

        Parameters
        ----------
        resolution : int
            Steps in every span.
        reach : float, optional
            A length beyond the box of the control points at which a curve through infinity is cut.
        around : array_like, optional
            Points (n, 2 or 3) whose box stands for that of the control points; any curve is cut there.

        Returns
        -------
        list of tuple (numpy.ndarray, bool)
            Pairs (points (m, 3), whether the polyline is closed).

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (2, 0)])
        >>> points, closed = line.polylines(2)[0]
        >>> points.tolist(), closed
        ([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], False)
        """
    def split(self, u: float) -> tuple[HermiteCurve, HermiteCurve]:
        """Cut the curve at a parameter.

        Parameters
        ----------
        u : float
            A parameter inside the domain.

        Returns
        -------
        tuple (HermiteCurve, HermiteCurve)
            (before, after), each on its part of the domain.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> before, after = sc.HermiteCurve([(0, 0), (1, 0)], [(0, 1), (0, 1)]).split(0.5)
        >>> before.domain, after.domain
        ((0.0, 0.5), (0.5, 1.0))
        """
    def transformed(self, matrix: ArrayLike) -> HermiteCurve:
        """Apply a linear, affine or projective map.

        Under a projective map the weights change; a point that goes to infinity gets the weight 0.

        Parameters
        ----------
        matrix : array_like
            Matrix (3, 3), (3, 4) or (4, 4) that is applied to columns.

        Returns
        -------
        HermiteCurve
            The image of the curve.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S9, S15.

        Examples
        --------
        >>> line = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (1, 0)])
        >>> line.transformed([[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0]]).points.tolist()
        [[5.0, 0.0, 0.0], [6.0, 0.0, 0.0]]
        """
    def translated(self, by: ArrayLike) -> HermiteCurve:
        """Move the shape by a vector.

        Parameters
        ----------
        by : array_like
            Vector (2 or 3,).

        Returns
        -------
        HermiteCurve
            The moved shape.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).translated((5, 0, 1)).points.tolist()
        [[5.0, 0.0, 1.0], [6.0, 2.0, 1.0]]
        """
    def rotated(self, angle: float, axis: ArrayLike = (0, 0, 1), about: ArrayLike = (0, 0, 0)) -> HermiteCurve:
        """Rotate the shape about an axis, counterclockwise as seen from its tip.

        Parameters
        ----------
        angle : float
            Angle in radians.
        axis : array_like, default (0, 0, 1)
            Vector (3,) along the axis; only its direction counts.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) on the axis.

        Returns
        -------
        HermiteCurve
            The rotated shape.

        Raises
        ------
        InvalidShape
            If the axis is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).rotated(np.pi, about=(1, 0)).points.round(9)[1].tolist()
        [1.0, -2.0, 0.0]
        """
    def scaled(self, factor: ArrayLike, about: ArrayLike = (0, 0, 0)) -> HermiteCurve:
        """Scale the shape about a point.

        Parameters
        ----------
        factor : array_like
            A number, or one for each coordinate (3,); a negative one mirrors.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) that stays.

        Returns
        -------
        HermiteCurve
            The scaled shape.

        Raises
        ------
        InvalidShape
            If a factor is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).scaled((2, -1, 1)).points[1].tolist()
        [2.0, -2.0, 0.0]
        """
    def join(self, other: _Curve, continuity: _Smoothness = "C0") -> Approximation[NurbsCurve]:
        """Append another curve of any kind.

        Points next to the joint move as little as the continuity asks. For 'C1' and 'C2' the domain of the
        other curve is scaled first.

        Parameters
        ----------
        other : curve
            The curve that follows.
        continuity : {'C0', 'G1', 'C1', 'C2'}, default 'C0'
            The continuity wanted at the joint.

        Returns
        -------
        Approximation of NurbsCurve
            Both as one curve, and the distance by which they moved, a length.

        Raises
        ------
        InvalidShape
            If a curve is periodic or an end lies at infinity.

        References
        ----------
        Lecture row S7.

        Examples
        --------
        >>> a = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (1, 0)])
        >>> b = sc.NurbsCurve(1, [0, 0, 1, 1], [(1, 0), (1, 1)])
        >>> joined, error = a.join(b)
        >>> joined.domain, error
        ((0.0, 2.0), 0.0)
        """
    def continuity_to(self, other: _Curve, tolerance: float = 1e-8) -> Continuity:
        """Measure the continuity between the end of this curve and the start of another one, of any kind.

        Parameters
        ----------
        other : curve
            The curve that follows.
        tolerance : float, default 1e-08
            Relative differences below it count as none.

        Returns
        -------
        Continuity
            The continuity.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S16.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (1, 0)])
        >>> [a.continuity_to(sc.BezierCurve([(1, 0), end])).g for end in ((3, 0), (1, 1))]
        [2, 0]
        """
    @property
    def is_closed(self) -> bool:
        """Whether the curve is in one piece and ends exactly where it begins.

        Examples
        --------
        >>> sc.conics.circle((0, 0, 0), 1.0).is_closed, sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).is_closed
        (True, False)
        """
    def reversed(self) -> HermiteCurve:
        """Reverse the direction of the curve over the same domain.

        Over [-end, -start] where rounding of start + end - u would spoil short spans far from zero.

        Returns
        -------
        HermiteCurve
            The same points in the opposite direction.

        Examples
        --------
        >>> curve = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (4, 0)])
        >>> curve.reversed().evaluate(0.25).tolist()
        [3.0, 0.0, 0.0]
        """
    def to_bezier(self) -> list[BezierCurve]:
        """Convert to Bezier curves, one for each span.

        Returns
        -------
        list of BezierCurve
            Bezier curves in order.

        References
        ----------
        The NURBS Book, A5.6.

        Examples
        --------
        >>> curve = sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0), (1, 1), (2, 1), (3, 0)])
        >>> len(curve.to_bezier())
        2
        """
    def to_hermite(self) -> HermiteCurve:
        """Convert to a chain of cubics.

        Returns
        -------
        HermiteCurve
            The same curve.

        Raises
        ------
        InvalidShape
            If it is rational, has a gap, or its degree is above 3.

        Examples
        --------
        >>> chain = sc.BezierCurve([(0, 0), (1, 3), (2, 3), (3, 0)]).to_hermite()
        >>> chain.tangents[:, 1].tolist()
        [[3.0, 9.0, 0.0], [3.0, -9.0, 0.0]]
        """
    def to_nurbs(self) -> NurbsCurve:
        """Convert to a cubic NURBS curve with triple knots.

        Returns
        -------
        NurbsCurve
            The same curve.

        Examples
        --------
        >>> sc.HermiteCurve([(0, 0), (1, 0)], [(0, 3), (0, 3)]).to_nurbs().points.round(9).tolist()
        [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 0.0, 0.0]]
        """
    def to_power(self) -> list[PowerCurve]:
        """Convert to powers of the parameter, one curve for each span.

        Returns
        -------
        list of PowerCurve
            Curves in order, in powers of the parameter from the start of each span.

        References
        ----------
        Lecture row S2.

        Examples
        --------
        >>> curve = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 2)])
        >>> [part.coefficients.tolist() for part in curve.to_power()]
        [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]], [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0]]]
        """
    def length(self, start: float | None = None, end: float | None = None, *, tolerance: float = 1e-13,
               cancel: _Cancel | None = None) -> float:
        """Measure the length between two parameters.

        Adaptive quadrature of Gauss and Kronrod on every span, also through cusps. On a periodic curve start
        and end may be any numbers in order: turns are counted.

        Parameters
        ----------
        start : float, optional
            Where to begin; by default the start of the domain.
        end : float, optional
            Where to end; by default the end of the domain.
        tolerance : float, default 1e-13
            The largest relative error; rounding of the coordinates may be more.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        float
            The length, in units of the points.

        Raises
        ------
        InvalidShape
            Unless start <= end, in the domain of a curve that is not periodic.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work; the message names an error that can be had.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> round(arc.length(), 12), round(arc.length(0.0, 0.5), 12)
        (1.570796326795, 0.785398163397)
        """
    def parameter_at_length(
        self, s: ArrayLike, *, tolerance: float = 1e-10, cancel: _Cancel | None = None
    ) -> _Floats:
        """Find the parameters at given lengths from the start.

        Parameters
        ----------
        s : array_like
            Lengths (...,) from the start of the domain; a periodic curve takes any.
        tolerance : float, default 1e-10
            The largest error of the length, relative to that of the curve.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Parameters (...,).

        Raises
        ------
        InvalidShape
            If a length is below 0 or above that of the curve.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).parameter_at_length([1.0, 2.0]).round(9)
        array([0.25, 0.5 ])
        """
    def divide(self, count: int, *, tolerance: float = 1e-10, cancel: _Cancel | None = None) -> _Floats:
        """Divide the curve into parts of equal length.

        Parameters
        ----------
        count : int
            How many parts, 1 to 2^22.
        tolerance : float, default 1e-10
            The largest error of the length, relative to that of the curve.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Parameters (count + 1,) with both ends; (count,) where the curve closes.

        Raises
        ------
        InvalidShape
            If the count is out of range or the curve has no length.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).divide(4).round(9)
        array([0.  , 0.25, 0.5 , 0.75, 1.  ])
        """
    def divide_by_length(self, step: float, *, tolerance: float = 1e-10, cancel: _Cancel | None = None) -> _Floats:
        """Divide the curve by steps of a given length from its start.

        Parameters
        ----------
        step : float
            Length of a step.
        tolerance : float, default 1e-10
            The largest error of the length, relative to that of the curve.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Parameters (n,) at 0, step, 2 step, … up to the length of the curve, without the end of a
            closed curve.

        Raises
        ------
        InvalidShape
            Unless step > 0, or if there are more than 2^22 steps.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).divide_by_length(1.5).round(9)
        array([0.   , 0.375, 0.75 ])
        """
    def curvature(self, u: ArrayLike, *, side: _Side = "right") -> _Floats:
        """Measure the curvature |C' x C''| / |C'|³.

        Where C' falls to zero it is the limit, inf at a sharp cusp; NaN where the curve is a point.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Curvatures (...,), in 1 / length.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S15, S16.

        Examples
        --------
        >>> arc = sc.BezierCurve([(2, 0), (2, 2), (0, 2)], weights=[1, 0.5**0.5, 1])
        >>> arc.curvature([0.0, 0.5]).round(12)
        array([0.5, 0.5])
        """
    def signed_curvature(
        self, u: ArrayLike, normal: ArrayLike | None = None, *, side: _Side = "right",
    ) -> _Floats:
        """Measure the curvature of a plane curve, positive where it bends to its left.

        Of a curve that is not plane it is the part of the curvature about the normal. Limits as of
        `curvature`.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        normal : array_like, optional
            Vector (3,) that the curve is seen against; by default the normal of its plane, towards +z.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Curvatures (...,), in 1 / length.

        Raises
        ------
        InvalidShape
            If no normal is given and the curve lies in no plane.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(2, 0), (2, 2), (0, 2)], weights=[1, 0.5**0.5, 1])
        >>> arc.reversed().signed_curvature([0.0, 0.5]).round(12)
        array([-0.5, -0.5])
        """
    def nearest(
        self, points: ArrayLike, *, threads: int = 0, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find the nearest point of the curve to each of several points.

        The global minimum: ends, corners and gaps are included. Of several places at one distance the one
        with the smallest parameter is taken. Where the curve passes through infinity its finite part counts.
        A point has the same result in any batch.

        Parameters
        ----------
        points : array_like
            Points (..., 2 or 3).
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            Parameters, points and distances, right to a few roundings of the size of the curve.

        Raises
        ------
        InvalidShape
            If a point is not finite.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998; lecture row S15.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> found = line.nearest([(1, 3), (9, 0)])
        >>> found.parameters, found.distances
        (array([0.25, 1.  ]), array([3., 5.]))
        """
    def intersections(
        self, other: _Curve, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Intersections:
        """Find where the curve meets another one.

        Places where the distance of both is least and within the tolerance, ends included, and stretches that
        both have in common.

        Parameters
        ----------
        other : curve
            A curve of any kind.
        tolerance : float, optional
            The largest distance of both curves, a length; by default 2^-33 of the extent of the control
            points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Intersections
            The places in the order of the parameters of this curve, and the stretches.

        Raises
        ------
        InvalidShape
            If more than 2^22 pairs of parts are within the tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Sederberg and Meyers 1988; lecture row S18.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (2, 2)])
        >>> b = sc.BezierCurve([(0, 2), (2, 0)])
        >>> a.intersections(b).points.round(9)
        array([[1., 1., 0.]])
        """
    def self_intersections(
        self, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Intersections:
        """Find where the curve meets itself.

        Places next to each other along the curve, as at a cusp, and the seam of a closed curve do not count.

        Parameters
        ----------
        tolerance : float, optional
            The largest distance, a length; by default 2^-33 of the extent of the control points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Intersections
            The places as of `intersections`: the first parameter is the smaller one.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> loop = sc.BezierCurve([(0, 0), (3, 2), (-2, 2), (1, 0)])
        >>> loop.self_intersections().points[:, 0].round(9).tolist()
        [0.5]
        """
    def patch_intersections(
        self, patch: _Patch, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> PatchIntersections:
        """Find where the curve meets a patch.

        Places where the distance of both is least and within the tolerance, ends of the curve included, and
        stretches that lie on the patch.

        Parameters
        ----------
        patch : patch
            A patch of any kind.
        tolerance : float, optional
            The largest distance of both, a length; by default 2^-33 of the extent of the control points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        PatchIntersections
            The places in the order of the parameters of the curve, and the stretches.

        Raises
        ------
        InvalidShape
            If more than 2^20 pairs of parts are within the tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0.5, 0.5, -1), (0.5, 0.5, 1)])
        >>> plane = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> line.patch_intersections(plane).parameters.round(9)
        array([[0.5, 0.5, 0.5]])
        """
    def plane_intersections(
        self, origin: ArrayLike, normal: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> PatchIntersections:
        """Find where the curve meets a plane.

        Parameters on the plane are its coordinates, with axes by the rule of DXF files: x and y where the
        normal is z.

        Parameters
        ----------
        origin : array_like
            Point (3,) of the plane.
        normal : array_like
            Vector (3,) at right angles to the plane.
        tolerance : float, optional
            The largest distance, a length; by default 2^-33 of the extent of the control points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        PatchIntersections
            The places and stretches, as of `patch_intersections`.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0, -1), (0, 0, 3)])
        >>> curve.plane_intersections((0, 0, 0), (0, 0, 1)).parameters[:, 0].round(9)
        array([0.25])
        """
    def part(self, start: float, end: float) -> NurbsCurve:
        """Cut out the part between two parameters, over that part of the domain.

        Parameters
        ----------
        start : float
            Where to begin.
        end : float
            Where to end; on a closed curve up to a turn behind the start.

        Returns
        -------
        NurbsCurve
            The part.

        Raises
        ------
        InvalidShape
            Unless start < end in the domain, or over the seam of a closed curve.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).part(0.25, 0.75).domain
        (0.25, 0.75)
        """
    def parts(self, parameters: ArrayLike) -> list[NurbsCurve]:
        """Cut the curve at several parameters.

        The ends of an open curve cut nothing. The last part of a closed curve continues over the seam.

        Parameters
        ----------
        parameters : array_like
            Parameters (n,) in the domain.

        Returns
        -------
        list of NurbsCurve
            The parts in order.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> [round(part.length(), 9) for part in sc.BezierCurve([(0, 0), (4, 0)]).parts([0.25, 0.5])]
        [1.0, 1.0, 2.0]
        """
    def split_by(self, others: Sequence[_Curve], *, cancel: _Cancel | None = None) -> list[NurbsCurve]:
        """Cut the curve where it meets other curves.

        Parameters
        ----------
        others : sequence of curves
            Curves of any kinds.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        list of NurbsCurve
            The parts in order.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> [round(part.length(), 9) for part in line.split_by([sc.BezierCurve([(1, -1), (1, 1)])])]
        [1.0, 3.0]
        """
    def trimmed(self, others: Sequence[_Curve], at: float, *, cancel: _Cancel | None = None) -> list[NurbsCurve]:
        """Remove the part of the curve about a parameter, between where it meets other curves.

        Parameters
        ----------
        others : sequence of curves
            Curves of any kinds.
        at : float
            A parameter of the part that is removed.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        list of NurbsCurve
            One or two curves.

        Raises
        ------
        InvalidShape
            If they do not meet, or a closed curve meets them in one place alone.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> others = [sc.BezierCurve([(x, -1), (x, 1)]) for x in (1, 3)]
        >>> [round(part.length(), 9) for part in line.trimmed(others, 0.5)]
        [1.0, 1.0]
        """
    def extended(
        self, length: float, at: Literal["start", "end"] = "end", how: _Extension = "natural"
    ) -> NurbsCurve:
        """Extend the curve at one end by a length.

        Parameters stay, the domain grows.

        Parameters
        ----------
        length : float
            How far, above 0.
        at : {'start', 'end'}, default 'end'
            The end.
        how : {'natural', 'arc', 'straight'}, default 'natural'
            By the polynomials of the last span ('natural'), along the circle of curvature ('arc'), or
            along the tangent ('straight').

        Returns
        -------
        NurbsCurve
            The longer curve.

        Raises
        ------
        InvalidShape
            If the curve is closed or has a zero derivative at its end, an arc would exceed its circle, or
            the curve runs to infinity before that length.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> round(sc.BezierCurve([(0, 0), (4, 0)]).extended(1.0).length(), 9)
        5.0
        """
    def extended_to(
        self,
        others: Sequence[_Curve],
        at: Literal["start", "end"] = "end",
        how: _Extension = "natural",
        *,
        cancel: _Cancel | None = None,
    ) -> NurbsCurve:
        """Extend the curve at one end to where it first meets other curves.

        Parameters
        ----------
        others : sequence of curves
            Curves of any kinds.
        at : {'start', 'end'}, default 'end'
            The end.
        how : {'natural', 'arc', 'straight'}, default 'natural'
            As of `extended`.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        NurbsCurve
            The longer curve.

        Raises
        ------
        InvalidShape
            If it meets none of them within four times the size of all, or as of `extended`.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> round(line.extended_to([sc.BezierCurve([(6, -1), (6, 1)])]).length(), 9)
        6.0
        """
    def rounded(self, radius: float, *, shrink: bool = False, cancel: _Cancel | None = None) -> NurbsCurve:
        """Replace every corner by an arc that touches both sides.

        Parameters
        ----------
        radius : float
            Radius of the arcs, above 0.
        shrink : bool, default False
            Whether an arc that does not fit gets the largest radius that does, instead of an error: it
            takes at most half of the curve up to the next corner, or all of it up to an end. Where the
            curve turns back the corner stays.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        NurbsCurve
            The curve with arcs, at the seam of a closed curve too.

        Raises
        ------
        InvalidShape
            If no such arc fits between the neighbors of a corner, or the curve turns back or is not plane
            there.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> corner = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (4, 0), (4, 4)])
        >>> round(corner.rounded(1.0).length() - np.pi / 2, 9)
        6.0
        >>> round(corner.rounded(9.0, shrink=True).length() / np.pi, 9)
        2.0
        """
    def chamfered(self, length: float, *, shrink: bool = False, cancel: _Cancel | None = None) -> NurbsCurve:
        """Replace every corner by a line.

        Parameters
        ----------
        length : float
            How far the line begins before the corner and ends behind it, measured along the curve.
        shrink : bool, default False
            Whether it begins and ends nearer to a corner that has no room, as of `rounded`, instead of an
            error.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        NurbsCurve
            The curve with lines.

        Raises
        ------
        InvalidShape
            If a corner has no room for it.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> corner = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (4, 0), (4, 4)])
        >>> round(corner.chamfered(1.0).length() - 2**0.5, 9)
        6.0
        """
    def offset(
        self,
        distance: float,
        normal: ArrayLike = (0, 0, 1),
        *,
        tolerance: float | None = None,
        corner: Literal["round", "sharp"] = "round",
        trimmed: bool = False,
        cancel: _Cancel | None = None,
    ) -> list[NurbsCurve]:
        """Offset a plane curve to its left.

        Lines and arcs of circles are moved exactly; other spans become cubics within the tolerance.

        Parameters
        ----------
        distance : float
            How far, to the left seen against the normal, to the right where it is negative.
        normal : array_like, default (0, 0, 1)
            Normal (3,) of the plane of the curve.
        tolerance : float, optional
            The largest error, a length; by default 2^-20 of the size.
        corner : {'round', 'sharp'}, default 'round'
            At corners an arc, or the corner of both tangents up to four times the distance away.
        trimmed : bool, default False
            Whether parts that are nearer to the curve than the distance are removed.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        list of NurbsCurve
            The offset; several curves where the curve has gaps or the offset is trimmed.

        Raises
        ------
        InvalidShape
            If the curve is not in a plane with that normal, the distance is zero or not finite, or
            nothing is left.
        ToleranceNotReached
            If the tolerance is not reached.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Tiller and Hanson 1984; lecture row S18.

        Examples
        --------
        >>> circle = sc.conics.circle((0, 0, 0), 2.0)
        >>> round(circle.offset(0.5)[0].length() / (2 * np.pi), 9)      # inwards
        1.5
        """
    def least_distance(
        self, other: _Curve | _Patch | PatchSet, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> LeastDistance:
        """Find where this shape and another one are nearest to each other.

        The global minimum, ends and borders included. Of several places at one distance it is any of them.

        Parameters
        ----------
        other : curve or patch or PatchSet
            A curve or patch of any kind, or a set of patches.
        tolerance : float, optional
            How much nearer they may be elsewhere, a length; by default 2^-33 of the size of both.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        LeastDistance
            The distance, with parameters and points on both shapes, and which patches of sets they are
            on.

        Raises
        ------
        InvalidShape
            If the tolerance is negative, or bent shapes are at one distance all along: give a larger
            tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998; lecture row S18.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (4, 0)])
        >>> b = sc.BezierCurve([(1, 3), (3, 1)])
        >>> a.least_distance(b).distance
        1.0
        """
    def stationary_points(self, point: ArrayLike, *, cancel: _Cancel | None = None) -> StationaryPoints:
        """Find all places where the distance from a point is stationary.

        These are the feet of all normals through the point, the ends of the curve and of its pieces, and
        corners where the distance is a minimum or a maximum.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        StationaryPoints
            The places in the order of their parameters, each once.

        Raises
        ------
        InvalidShape
            If the point is not finite or too far away, or where the distance is constant, as from the
            center of a circle.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lane and Riesenfeld 1981; lecture row S15.

        Examples
        --------
        >>> found = sc.BezierCurve([(0, 0), (4, 0)]).stationary_points((1, 2))
        >>> found.parameters.round(9).tolist(), found.kinds
        ([0.0, 0.25, 1.0], ('maximum', 'minimum', 'maximum'))
        """
    def nearest_all(
        self, point: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find all places where the distance from a point is a minimum that is nearly the least one.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        tolerance : float, optional
            By how much the distance may exceed the least one, a length; by default a few roundings.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            The places in the order of their parameters (n,).

        Raises
        ------
        InvalidShape
            If the point is not finite, or where the distance is constant.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> bow = sc.BezierCurve([(-1, 1), (0, -1), (1, 1)])
        >>> bow.nearest_all((0, 2)).points[:, 0].round(6).tolist()
        [-1.0, 1.0]
        """
    def rebuild(
        self,
        count: SupportsIndex | None = None,
        degree: SupportsIndex | None = None,
        *,
        tolerance: float | None = None,
        ends: Literal["points", "tangents"] = "points",
        cancel: _Cancel | None = None,
    ) -> Approximation[NurbsCurve]:
        """Approximate by a polynomial curve with even knots over the same domain.

        It is nearest in the integral of the squared distance at equal parameters, and periodic if the curve
        is.

        Parameters
        ----------
        count : int, optional
            Number of control points; with a tolerance the most.
        degree : int, optional
            Degree; by default that of the curve.
        tolerance : float, optional
            As few control points as come within it, a length.
        ends : {'points', 'tangents'}, default 'points'
            Of an open curve the end points stay, or the tangents there too.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsCurve
            The new curve, and the largest distance at equal parameters, at most 1 % above the truth.

        Raises
        ------
        InvalidShape
            If the count is below the number that the degree needs.
        ToleranceNotReached
            If the tolerance is not reached.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S17.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> curve, error = arc.rebuild(degree=3, tolerance=1e-4)
        >>> curve.is_rational, error <= 1e-4
        (False, True)
        """
    def fair(
        self, tolerance: float, *, ends: Literal["points", "tangents"] = "points", cancel: _Cancel | None = None
    ) -> Approximation[NurbsCurve]:
        """Smooth the curve within a tolerance.

        Knots and weights stay; the integral of the squared second derivative becomes as small as the
        tolerance allows.

        Parameters
        ----------
        tolerance : float
            The largest distance at equal parameters, a length above 0.
        ends : {'points', 'tangents'}, default 'points'
            Of an open curve the end points stay, or the tangents there too.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsCurve
            The new curve and the largest distance at equal parameters, at most 1 % above the truth.

        Raises
        ------
        InvalidShape
            Unless the tolerance is positive and the degree is 2 at least.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Reinsch 1967; lecture row S17.

        Examples
        --------
        >>> noisy = sc.BezierCurve([(0, 0), (1, 0.1), (2, -0.1), (3, 0)])
        >>> smooth, error = noisy.fair(0.01)
        >>> bool(np.ptp(smooth.points[:, 1]) < np.ptp(noisy.points[:, 1])), error <= 0.01
        (True, True)
        """
    def torsion(self, u: ArrayLike, *, side: _Side = "right") -> _Floats:
        """Measure the torsion det(C', C'', C''') / |C' x C''|², positive for a right-handed screw.

        At an inflection or a cusp it is the limit; NaN on a straight line.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Torsions (...,), in 1 / length.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]).torsion(0.0).item()
        3.0
        """
    def inflections(self, direction: ArrayLike | None = None) -> _Floats:
        """Find the parameters where the curve begins to bend to the other side.

        All sign changes of the signed curvature; the middle of a straight part between two bends. Corners do
        not count.

        Parameters
        ----------
        direction : array_like, optional
            Vector (3,) that the curve is seen against; by default the normal of its plane.

        Returns
        -------
        numpy.ndarray
            Parameters (n,) in order.

        Raises
        ------
        InvalidShape
            If no direction is given and the curve lies in no plane.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 1), (2, -1), (3, 0)]).inflections().round(9)
        array([0.5])
        """
    def extrema(self, direction: ArrayLike) -> _Floats:
        """Find the parameters where the curve has an extremum along a direction.

        All zeros of the derivative along it, both ends of a part at right angles to it, corners where it
        changes sign, and the ends of the curve and of its pieces.

        Parameters
        ----------
        direction : array_like
            Vector (3,).

        Returns
        -------
        numpy.ndarray
            Parameters (n,) in order.

        Raises
        ------
        InvalidShape
            If the direction is zero.
        PointAtInfinity
            If the curve runs to infinity.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).extrema((0, 1, 0))
        array([0. , 0.5, 1. ])
        """
    def bounding_box(self) -> _Floats:
        """Find the smallest box along the axes that contains the curve.

        Not that of the control points: right to a few roundings of the largest coordinate.

        Returns
        -------
        numpy.ndarray
            Array (2, 3) of the lowest and the highest corner.

        Raises
        ------
        PointAtInfinity
            If the curve runs to infinity.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).bounding_box().tolist()
        [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0]]
        """
    def signed_area(self, normal: ArrayLike = (0.0, 0.0, 1.0), *, tolerance: float = 1e-12) -> float:
        """Measure the area inside a closed curve, positive where it lies to the left.

        Parts enclosed twice count twice. For a curve that is not plane it is the area of its projection along
        the normal. Exact, but for rounding, for polynomial curves.

        Parameters
        ----------
        normal : array_like, default (0.0, 0.0, 1.0)
            Vector (3,) that the curve is seen against.
        tolerance : float, default 1e-12
            The largest relative error for rational curves.

        Returns
        -------
        float
            The area, in square units of the points.

        Raises
        ------
        InvalidShape
            If the ends are apart by more than 1e-9 of the size or the curve is in several pieces.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> round(sc.conics.circle((0, 0, 0), 2.0).signed_area(), 9)
        12.566370614
        """
    def winding_number(self, point: ArrayLike, normal: ArrayLike = (0.0, 0.0, 1.0)) -> int | NDArray[np.int64]:
        """Count how often a closed curve winds around a point, or each of several points, to the left.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,), or points (..., 2 or 3).
        normal : array_like, default (0.0, 0.0, 1.0)
            Vector (3,) that the curve is seen against.

        Returns
        -------
        int or numpy.ndarray
            The winding number, 0 outside; of points an int64 array (...,).

        Raises
        ------
        InvalidShape
            If a point lies on the curve up to 1e-12 of its size, or the curve is not closed.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> circle = sc.conics.circle((0, 0, 0), 2.0)
        >>> circle.winding_number((1, 0, 0)), circle.winding_number((3, 0, 0))
        (1, 0)
        >>> circle.winding_number([(1, 0), (3, 0)])
        array([1, 0])
        """
    def frenet_frame(self, u: ArrayLike, *, side: _Side = "right") -> _Floats:
        """Evaluate tangent, normal and binormal of Frenet's frame.

        Limits are taken where a derivative falls to zero. Normal and binormal are NaN where the curve is
        straight.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Unit vectors (..., 3, 3), one in each row.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> tangent, normal, binormal = arc.frenet_frame(0.0)
        >>> normal.round(12).tolist()[0]
        -1.0
        """
    def frames(
        self, u: ArrayLike, kind: Literal["frenet", "rotation_minimizing"] = "rotation_minimizing", *,
        start: ArrayLike | None = None, closed: bool = False, side: _Side = "right", cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate frames of tangent, normal and binormal along the curve.

        Rotation-minimizing frames turn around the tangent as little as possible, from the start of the
        domain, to about 1e-9. Straight parts keep the frame; at a corner it turns as little as it can.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        kind : {'frenet', 'rotation_minimizing'}, default 'rotation_minimizing'
            Rotation-minimizing frames, or those of `frenet_frame`.
        start : array_like, optional
            Vector (3,) along which the normal points at the start, as far as it is at right angles to the
            curve; by default the normal there.
        closed : bool, default False
            Whether the turn of the frame at the end of a closed curve is taken back, evenly by length.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Unit vectors (..., 3, 3), one in each row.

        Raises
        ------
        InvalidShape
            If the curve is a point; with 'frenet', where it is straight or has a zero derivative; with
            `closed`, unless it closes smoothly.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If a span turns so wildly that 2^17 steps are not enough.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Wang, Jüttler, Zheng and Liu 2008; lecture row S15.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0, 0), (2, 0, 0)])
        >>> line.frames(0.5, start=(0, 0, 1)).tolist()
        [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]
        """
    def dragged(
        self,
        u: float,
        by: ArrayLike,
        tangent_by: ArrayLike | None = None,
        second_by: ArrayLike | None = None,
        *,
        factors: ArrayLike | None = None,
        locality: float = 0.0,
    ) -> HermiteCurve:
        """Move the point at a parameter by moving points and tangents as little as possible.

        The motion of a tangent is measured at a third of the span. Tangents that are equal at a point remain
        equal.

        Parameters
        ----------
        u : float
            The parameter of the point.
        by : array_like
            Vector (3,) by which the point moves.
        tangent_by : array_like, optional
            Vector (3,) added to the first derivative at u; zero keeps it, None leaves it free.
        second_by : array_like, optional
            The same for the second derivative; needs `tangent_by`.
        factors : array_like, optional
            Factors (3, n) of points, incoming and outgoing tangents; 0 holds one.
        locality : float, default 0.0
            The larger it is, the fewer control points follow: factors are multiplied by the influence of
            a point to this power.

        Returns
        -------
        HermiteCurve
            The new chain.

        Raises
        ------
        InvalidShape
            If nothing that the point depends on may move, or too little to choose the derivatives.

        Examples
        --------
        >>> chain = sc.HermiteCurve([(0, 0), (1, 0)], [(0, 1), (0, 1)])
        >>> chain.dragged(0.5, (0, 1, 0)).evaluate(0.5).round(9).tolist()
        [0.5, 1.0, 0.0]
        """
    def dumps(self) -> str:
        """Write the shape as JSON text.

        Returns
        -------
        str
            Text that `loads` reads back equal in every bit.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> sc.loads(curve.dumps()) == curve
        True
        """
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> HermiteCurve: ...
    def __deepcopy__(self, memo: object, /) -> HermiteCurve: ...

@final
class PowerCurve:
    """A polynomial, or rational, curve by its coefficients: Q(t) = sum c_k (t - origin)^k.

    It is evaluated through its Bernstein form on the domain, whose points are right to an ulp of the
    largest.

    Parameters
    ----------
    coefficients : array_like
        Coefficients (degree + 1, 2 or 3), lowest power first.
    origin : float, default 0.0
        The parameter at which the powers are zero.
    domain : array_like, default (0.0, 1.0)
        First and last parameter (2,).

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S2.

    Examples
    --------
    >>> curve = sc.PowerCurve([(0, 0), (1, 0), (0, 1)])      # (t, t²)
    >>> curve.evaluate([0.5, 1.0])
    array([[0.5 , 0.25, 0.  ],
           [1.  , 1.  , 0.  ]])
    """

    def __init__(
        self, coefficients: ArrayLike, origin: float = 0.0, domain: ArrayLike = (0.0, 1.0)
    ) -> None: ...
    @staticmethod
    def from_homogeneous(
        coefficients: ArrayLike, origin: float = 0.0, domain: ArrayLike = (0.0, 1.0)
    ) -> PowerCurve:
        """Make a rational curve from coefficients of its numerator and denominator.

        Parameters
        ----------
        coefficients : array_like
            Rows (n, 4) of wx, wy, wz and the denominator w, lowest power first.
        origin : float, default 0.0
            The parameter at which the powers are zero.
        domain : array_like, default (0.0, 1.0)
            First and last parameter (2,).

        Returns
        -------
        PowerCurve
            The curve.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> quarter_circle = sc.PowerCurve.from_homogeneous([(1, 0, 0, 1), (0, 2, 0, 0), (-1, 0, 0, 1)])
        >>> quarter_circle.evaluate(1.0)      # (1 - t², 2t) / (1 + t²)
        array([0., 1., 0.])
        """
    @property
    def degree(self) -> int:
        """The degree.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).degree
        2
        """
    @property
    def domain(self) -> _Interval:
        """First and last parameter (start, end).

        Examples
        --------
        >>> sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)]).domain
        (0.0, 2.0)
        """
    @property
    def is_rational(self) -> bool:
        """True unless every weight is 1.

        Examples
        --------
        >>> sc.conics.circle((0, 0, 0), 1.0).is_rational, sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).is_rational
        (True, False)
        """
    @property
    def coefficients(self) -> _Floats:
        """Coefficients (degree + 1, 3) float64, lowest power first, read-only; those of the numerator of a
        rational curve.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0), (1, 0), (0, 1)]).coefficients.tolist()
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
        """
    @property
    def weights(self) -> _Floats:
        """Coefficients (degree + 1,) float64 of the denominator, read-only: 1, 0, 0, … of a polynomial.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0), (1, 0), (0, 1)]).weights
        array([1., 0., 0.])
        """
    @property
    def homogeneous_coefficients(self) -> _Floats:
        """Rows (degree + 1, 4) float64 as `from_homogeneous` takes them, read-only.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0), (1, 0)]).homogeneous_coefficients.tolist()
        [[0.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, 0.0]]
        """
    @property
    def origin(self) -> float:
        """The parameter at which the powers are zero.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0), (1, 0)], origin=0.5).origin
        0.5
        """
    def evaluate(
        self,
        u: ArrayLike,
        *,
        side: _Side = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: _Points | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Points:
        """Evaluate points of the curve.

        A parameter has the same result in every bit in any batch and on any number of threads.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Points (..., 3) of the same units as the control points; float32 where `dtype` or `out` ask
            for it.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S6, S9, S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> arc.evaluate([0.0, 0.5, 1.0]).round(6)
        array([[1.      , 0.      , 0.      ],
               [0.707107, 0.707107, 0.      ],
               [0.      , 1.      , 0.      ]])
        """
    def derivatives(
        self,
        u: ArrayLike,
        order: SupportsIndex,
        *,
        side: _Side = "right",
        at_infinity: _AtInfinity = "raise",
        out: _Floats | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate points and their derivatives by the parameter.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        order : int
            Highest order of derivatives, 0 or more.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (..., order + 1, 3): `[..., 0, :]` are the points of `evaluate`, in every bit.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain, or a derivative is too large for a number.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        The NURBS Book, A4.2.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> curve.derivatives(0.5, 1)
        array([[1., 1., 0.],
               [2., 0., 0.]])
        """
    def pieces(self) -> list[_Interval]:
        """Find the intervals on which the curve is finite and connected.

        It is cut where the weight is zero and at knots of multiplicity degree + 1.

        Returns
        -------
        list of tuple (float, float)
            Intervals (start, end) in order.

        Examples
        --------
        >>> sc.conics.hyperbola((0, 0, 0), (1, 0, 0), (0, 1, 0))[0].pieces()
        [(0.0, 1.0)]
        >>> sc.BezierCurve([(0, 0), (1, 1), (2, 0)], weights=[1, 0, -1]).pieces()
        [(0.0, 0.5), (0.5, 1.0)]
        """
    def polylines(
        self, resolution: SupportsIndex, reach: float | None = None, around: ArrayLike | None = None
    ) -> list[tuple[_Floats, bool]]:
        """Sample the curve evenly in its parameter, one polyline for each of `pieces`.

        With a reach, a curve whose weights differ in sign ends where it leaves the box of its finite control
        points by that length in a coordinate; without one, at its last sample before infinity.

        Parameters
        ----------
        resolution : int
            Steps in every span.
        reach : float, optional
            A length beyond the box of the control points at which a curve through infinity is cut.
        around : array_like, optional
            Points (n, 2 or 3) whose box stands for that of the control points; any curve is cut there.

        Returns
        -------
        list of tuple (numpy.ndarray, bool)
            Pairs (points (m, 3), whether the polyline is closed).

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (2, 0)])
        >>> points, closed = line.polylines(2)[0]
        >>> points.tolist(), closed
        ([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], False)
        """
    def split(self, u: float) -> tuple[PowerCurve, PowerCurve]:
        """Cut the curve at a parameter.

        Parameters
        ----------
        u : float
            A parameter inside the domain.

        Returns
        -------
        tuple (PowerCurve, PowerCurve)
            (before, after): the same coefficients, each on its part of the domain.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> before, after = sc.PowerCurve([(0, 0), (1, 0), (0, 1)]).split(0.25)
        >>> before.domain, after.domain, before.coefficients.tolist() == after.coefficients.tolist()
        ((0.0, 0.25), (0.25, 1.0), True)
        """
    def transformed(self, matrix: ArrayLike) -> PowerCurve:
        """Apply a linear, affine or projective map.

        Under a projective map the weights change; a point that goes to infinity gets the weight 0.

        Parameters
        ----------
        matrix : array_like
            Matrix (3, 3), (3, 4) or (4, 4) that is applied to columns.

        Returns
        -------
        PowerCurve
            The image of the curve.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S9, S15.

        Examples
        --------
        >>> line = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (1, 0)])
        >>> line.transformed([[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0]]).points.tolist()
        [[5.0, 0.0, 0.0], [6.0, 0.0, 0.0]]
        """
    def translated(self, by: ArrayLike) -> PowerCurve:
        """Move the shape by a vector.

        Parameters
        ----------
        by : array_like
            Vector (2 or 3,).

        Returns
        -------
        PowerCurve
            The moved shape.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).translated((5, 0, 1)).points.tolist()
        [[5.0, 0.0, 1.0], [6.0, 2.0, 1.0]]
        """
    def rotated(self, angle: float, axis: ArrayLike = (0, 0, 1), about: ArrayLike = (0, 0, 0)) -> PowerCurve:
        """Rotate the shape about an axis, counterclockwise as seen from its tip.

        Parameters
        ----------
        angle : float
            Angle in radians.
        axis : array_like, default (0, 0, 1)
            Vector (3,) along the axis; only its direction counts.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) on the axis.

        Returns
        -------
        PowerCurve
            The rotated shape.

        Raises
        ------
        InvalidShape
            If the axis is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).rotated(np.pi, about=(1, 0)).points.round(9)[1].tolist()
        [1.0, -2.0, 0.0]
        """
    def scaled(self, factor: ArrayLike, about: ArrayLike = (0, 0, 0)) -> PowerCurve:
        """Scale the shape about a point.

        Parameters
        ----------
        factor : array_like
            A number, or one for each coordinate (3,); a negative one mirrors.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) that stays.

        Returns
        -------
        PowerCurve
            The scaled shape.

        Raises
        ------
        InvalidShape
            If a factor is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).scaled((2, -1, 1)).points[1].tolist()
        [2.0, -2.0, 0.0]
        """
    def join(self, other: _Curve, continuity: _Smoothness = "C0") -> Approximation[NurbsCurve]:
        """Append another curve of any kind.

        Points next to the joint move as little as the continuity asks. For 'C1' and 'C2' the domain of the
        other curve is scaled first.

        Parameters
        ----------
        other : curve
            The curve that follows.
        continuity : {'C0', 'G1', 'C1', 'C2'}, default 'C0'
            The continuity wanted at the joint.

        Returns
        -------
        Approximation of NurbsCurve
            Both as one curve, and the distance by which they moved, a length.

        Raises
        ------
        InvalidShape
            If a curve is periodic or an end lies at infinity.

        References
        ----------
        Lecture row S7.

        Examples
        --------
        >>> a = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (1, 0)])
        >>> b = sc.NurbsCurve(1, [0, 0, 1, 1], [(1, 0), (1, 1)])
        >>> joined, error = a.join(b)
        >>> joined.domain, error
        ((0.0, 2.0), 0.0)
        """
    def continuity_to(self, other: _Curve, tolerance: float = 1e-8) -> Continuity:
        """Measure the continuity between the end of this curve and the start of another one, of any kind.

        Parameters
        ----------
        other : curve
            The curve that follows.
        tolerance : float, default 1e-08
            Relative differences below it count as none.

        Returns
        -------
        Continuity
            The continuity.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S16.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (1, 0)])
        >>> [a.continuity_to(sc.BezierCurve([(1, 0), end])).g for end in ((3, 0), (1, 1))]
        [2, 0]
        """
    @property
    def is_closed(self) -> bool:
        """Whether the curve is in one piece and ends exactly where it begins.

        Examples
        --------
        >>> sc.conics.circle((0, 0, 0), 1.0).is_closed, sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).is_closed
        (True, False)
        """
    def reversed(self) -> PowerCurve:
        """Reverse the direction of the curve over the same domain, about the mirrored origin.

        Returns
        -------
        PowerCurve
            The same points in the opposite direction.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0), (4, 0)]).reversed().evaluate(0.25).tolist()
        [3.0, 0.0, 0.0]
        """
    def derivative(self) -> PowerCurve:
        """Differentiate the curve by its parameter.

        Returns
        -------
        PowerCurve
            The derivative; of a rational curve of twice the degree.

        Raises
        ------
        InvalidShape
            If the degree would exceed 255.

        References
        ----------
        Lecture row S2.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0), (1, 0), (0, 1)]).derivative().coefficients
        array([[1., 0., 0.],
               [0., 2., 0.]])
        """
    def with_origin(self, origin: float) -> PowerCurve:
        """Expand about another origin.

        About a distant origin the coefficients are large and cancel.

        Parameters
        ----------
        origin : float
            The parameter at which the powers are zero.

        Returns
        -------
        PowerCurve
            The same curve.

        Raises
        ------
        InvalidShape
            If a coefficient overflows.

        References
        ----------
        Knuth, The Art of Computer Programming, 4.6.4; lecture row S2.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0), (1, 0), (0, 1)]).to_power(0.5).coefficients.tolist()
        [[0.5, 0.25, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]
        """
    def with_domain(self, domain: ArrayLike) -> PowerCurve:
        """Keep the coefficients, replace the domain.

        Parameters
        ----------
        domain : array_like
            First and last parameter (2,).

        Returns
        -------
        PowerCurve
            The new curve.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0), (1, 0), (0, 1)]).with_domain((0, 3)).evaluate(3.0).tolist()
        [3.0, 9.0, 0.0]
        """
    def to_bezier(self) -> list[BezierCurve]:
        """Convert to Bezier curves, one for each span.

        Returns
        -------
        list of BezierCurve
            Bezier curves in order.

        References
        ----------
        The NURBS Book, A5.6.

        Examples
        --------
        >>> curve = sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0), (1, 1), (2, 1), (3, 0)])
        >>> len(curve.to_bezier())
        2
        """
    def to_hermite(self) -> HermiteCurve:
        """Convert to a chain of cubics.

        Returns
        -------
        HermiteCurve
            The same curve.

        Raises
        ------
        InvalidShape
            If it is rational, has a gap, or its degree is above 3.

        Examples
        --------
        >>> chain = sc.BezierCurve([(0, 0), (1, 3), (2, 3), (3, 0)]).to_hermite()
        >>> chain.tangents[:, 1].tolist()
        [[3.0, 9.0, 0.0], [3.0, -9.0, 0.0]]
        """
    def to_nurbs(self) -> NurbsCurve:
        """Convert to a NURBS curve of one clamped span.

        Returns
        -------
        NurbsCurve
            The same curve.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0), (2, 0), (0, 4)]).to_nurbs().points.tolist()
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 4.0, 0.0]]
        """
    def to_power(self, origin: float = 0.0) -> PowerCurve:
        """Expand about another origin.

        About a distant origin the coefficients are large and cancel.

        Parameters
        ----------
        origin : float, default 0.0
            The parameter at which the powers are zero.

        Returns
        -------
        PowerCurve
            The same curve.

        Raises
        ------
        InvalidShape
            If a coefficient overflows.

        References
        ----------
        Knuth, The Art of Computer Programming, 4.6.4; lecture row S2.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0), (1, 0), (0, 1)]).to_power(0.5).coefficients.tolist()
        [[0.5, 0.25, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]
        """
    def length(self, start: float | None = None, end: float | None = None, *, tolerance: float = 1e-13,
               cancel: _Cancel | None = None) -> float:
        """Measure the length between two parameters.

        Adaptive quadrature of Gauss and Kronrod on every span, also through cusps. On a periodic curve start
        and end may be any numbers in order: turns are counted.

        Parameters
        ----------
        start : float, optional
            Where to begin; by default the start of the domain.
        end : float, optional
            Where to end; by default the end of the domain.
        tolerance : float, default 1e-13
            The largest relative error; rounding of the coordinates may be more.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        float
            The length, in units of the points.

        Raises
        ------
        InvalidShape
            Unless start <= end, in the domain of a curve that is not periodic.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work; the message names an error that can be had.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> round(arc.length(), 12), round(arc.length(0.0, 0.5), 12)
        (1.570796326795, 0.785398163397)
        """
    def parameter_at_length(
        self, s: ArrayLike, *, tolerance: float = 1e-10, cancel: _Cancel | None = None
    ) -> _Floats:
        """Find the parameters at given lengths from the start.

        Parameters
        ----------
        s : array_like
            Lengths (...,) from the start of the domain; a periodic curve takes any.
        tolerance : float, default 1e-10
            The largest error of the length, relative to that of the curve.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Parameters (...,).

        Raises
        ------
        InvalidShape
            If a length is below 0 or above that of the curve.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).parameter_at_length([1.0, 2.0]).round(9)
        array([0.25, 0.5 ])
        """
    def divide(self, count: int, *, tolerance: float = 1e-10, cancel: _Cancel | None = None) -> _Floats:
        """Divide the curve into parts of equal length.

        Parameters
        ----------
        count : int
            How many parts, 1 to 2^22.
        tolerance : float, default 1e-10
            The largest error of the length, relative to that of the curve.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Parameters (count + 1,) with both ends; (count,) where the curve closes.

        Raises
        ------
        InvalidShape
            If the count is out of range or the curve has no length.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).divide(4).round(9)
        array([0.  , 0.25, 0.5 , 0.75, 1.  ])
        """
    def divide_by_length(self, step: float, *, tolerance: float = 1e-10, cancel: _Cancel | None = None) -> _Floats:
        """Divide the curve by steps of a given length from its start.

        Parameters
        ----------
        step : float
            Length of a step.
        tolerance : float, default 1e-10
            The largest error of the length, relative to that of the curve.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Parameters (n,) at 0, step, 2 step, … up to the length of the curve, without the end of a
            closed curve.

        Raises
        ------
        InvalidShape
            Unless step > 0, or if there are more than 2^22 steps.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).divide_by_length(1.5).round(9)
        array([0.   , 0.375, 0.75 ])
        """
    def curvature(self, u: ArrayLike, *, side: _Side = "right") -> _Floats:
        """Measure the curvature |C' x C''| / |C'|³.

        Where C' falls to zero it is the limit, inf at a sharp cusp; NaN where the curve is a point.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Curvatures (...,), in 1 / length.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S15, S16.

        Examples
        --------
        >>> arc = sc.BezierCurve([(2, 0), (2, 2), (0, 2)], weights=[1, 0.5**0.5, 1])
        >>> arc.curvature([0.0, 0.5]).round(12)
        array([0.5, 0.5])
        """
    def signed_curvature(
        self, u: ArrayLike, normal: ArrayLike | None = None, *, side: _Side = "right",
    ) -> _Floats:
        """Measure the curvature of a plane curve, positive where it bends to its left.

        Of a curve that is not plane it is the part of the curvature about the normal. Limits as of
        `curvature`.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        normal : array_like, optional
            Vector (3,) that the curve is seen against; by default the normal of its plane, towards +z.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Curvatures (...,), in 1 / length.

        Raises
        ------
        InvalidShape
            If no normal is given and the curve lies in no plane.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(2, 0), (2, 2), (0, 2)], weights=[1, 0.5**0.5, 1])
        >>> arc.reversed().signed_curvature([0.0, 0.5]).round(12)
        array([-0.5, -0.5])
        """
    def nearest(
        self, points: ArrayLike, *, threads: int = 0, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find the nearest point of the curve to each of several points.

        The global minimum: ends, corners and gaps are included. Of several places at one distance the one
        with the smallest parameter is taken. Where the curve passes through infinity its finite part counts.
        A point has the same result in any batch.

        Parameters
        ----------
        points : array_like
            Points (..., 2 or 3).
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            Parameters, points and distances, right to a few roundings of the size of the curve.

        Raises
        ------
        InvalidShape
            If a point is not finite.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998; lecture row S15.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> found = line.nearest([(1, 3), (9, 0)])
        >>> found.parameters, found.distances
        (array([0.25, 1.  ]), array([3., 5.]))
        """
    def intersections(
        self, other: _Curve, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Intersections:
        """Find where the curve meets another one.

        Places where the distance of both is least and within the tolerance, ends included, and stretches that
        both have in common.

        Parameters
        ----------
        other : curve
            A curve of any kind.
        tolerance : float, optional
            The largest distance of both curves, a length; by default 2^-33 of the extent of the control
            points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Intersections
            The places in the order of the parameters of this curve, and the stretches.

        Raises
        ------
        InvalidShape
            If more than 2^22 pairs of parts are within the tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Sederberg and Meyers 1988; lecture row S18.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (2, 2)])
        >>> b = sc.BezierCurve([(0, 2), (2, 0)])
        >>> a.intersections(b).points.round(9)
        array([[1., 1., 0.]])
        """
    def self_intersections(
        self, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Intersections:
        """Find where the curve meets itself.

        Places next to each other along the curve, as at a cusp, and the seam of a closed curve do not count.

        Parameters
        ----------
        tolerance : float, optional
            The largest distance, a length; by default 2^-33 of the extent of the control points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Intersections
            The places as of `intersections`: the first parameter is the smaller one.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> loop = sc.BezierCurve([(0, 0), (3, 2), (-2, 2), (1, 0)])
        >>> loop.self_intersections().points[:, 0].round(9).tolist()
        [0.5]
        """
    def patch_intersections(
        self, patch: _Patch, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> PatchIntersections:
        """Find where the curve meets a patch.

        Places where the distance of both is least and within the tolerance, ends of the curve included, and
        stretches that lie on the patch.

        Parameters
        ----------
        patch : patch
            A patch of any kind.
        tolerance : float, optional
            The largest distance of both, a length; by default 2^-33 of the extent of the control points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        PatchIntersections
            The places in the order of the parameters of the curve, and the stretches.

        Raises
        ------
        InvalidShape
            If more than 2^20 pairs of parts are within the tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0.5, 0.5, -1), (0.5, 0.5, 1)])
        >>> plane = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> line.patch_intersections(plane).parameters.round(9)
        array([[0.5, 0.5, 0.5]])
        """
    def plane_intersections(
        self, origin: ArrayLike, normal: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> PatchIntersections:
        """Find where the curve meets a plane.

        Parameters on the plane are its coordinates, with axes by the rule of DXF files: x and y where the
        normal is z.

        Parameters
        ----------
        origin : array_like
            Point (3,) of the plane.
        normal : array_like
            Vector (3,) at right angles to the plane.
        tolerance : float, optional
            The largest distance, a length; by default 2^-33 of the extent of the control points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        PatchIntersections
            The places and stretches, as of `patch_intersections`.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0, -1), (0, 0, 3)])
        >>> curve.plane_intersections((0, 0, 0), (0, 0, 1)).parameters[:, 0].round(9)
        array([0.25])
        """
    def part(self, start: float, end: float) -> NurbsCurve:
        """Cut out the part between two parameters, over that part of the domain.

        Parameters
        ----------
        start : float
            Where to begin.
        end : float
            Where to end; on a closed curve up to a turn behind the start.

        Returns
        -------
        NurbsCurve
            The part.

        Raises
        ------
        InvalidShape
            Unless start < end in the domain, or over the seam of a closed curve.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (4, 0)]).part(0.25, 0.75).domain
        (0.25, 0.75)
        """
    def parts(self, parameters: ArrayLike) -> list[NurbsCurve]:
        """Cut the curve at several parameters.

        The ends of an open curve cut nothing. The last part of a closed curve continues over the seam.

        Parameters
        ----------
        parameters : array_like
            Parameters (n,) in the domain.

        Returns
        -------
        list of NurbsCurve
            The parts in order.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> [round(part.length(), 9) for part in sc.BezierCurve([(0, 0), (4, 0)]).parts([0.25, 0.5])]
        [1.0, 1.0, 2.0]
        """
    def split_by(self, others: Sequence[_Curve], *, cancel: _Cancel | None = None) -> list[NurbsCurve]:
        """Cut the curve where it meets other curves.

        Parameters
        ----------
        others : sequence of curves
            Curves of any kinds.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        list of NurbsCurve
            The parts in order.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> [round(part.length(), 9) for part in line.split_by([sc.BezierCurve([(1, -1), (1, 1)])])]
        [1.0, 3.0]
        """
    def trimmed(self, others: Sequence[_Curve], at: float, *, cancel: _Cancel | None = None) -> list[NurbsCurve]:
        """Remove the part of the curve about a parameter, between where it meets other curves.

        Parameters
        ----------
        others : sequence of curves
            Curves of any kinds.
        at : float
            A parameter of the part that is removed.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        list of NurbsCurve
            One or two curves.

        Raises
        ------
        InvalidShape
            If they do not meet, or a closed curve meets them in one place alone.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> others = [sc.BezierCurve([(x, -1), (x, 1)]) for x in (1, 3)]
        >>> [round(part.length(), 9) for part in line.trimmed(others, 0.5)]
        [1.0, 1.0]
        """
    def extended(
        self, length: float, at: Literal["start", "end"] = "end", how: _Extension = "natural"
    ) -> NurbsCurve:
        """Extend the curve at one end by a length.

        Parameters stay, the domain grows.

        Parameters
        ----------
        length : float
            How far, above 0.
        at : {'start', 'end'}, default 'end'
            The end.
        how : {'natural', 'arc', 'straight'}, default 'natural'
            By the polynomials of the last span ('natural'), along the circle of curvature ('arc'), or
            along the tangent ('straight').

        Returns
        -------
        NurbsCurve
            The longer curve.

        Raises
        ------
        InvalidShape
            If the curve is closed or has a zero derivative at its end, an arc would exceed its circle, or
            the curve runs to infinity before that length.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> round(sc.BezierCurve([(0, 0), (4, 0)]).extended(1.0).length(), 9)
        5.0
        """
    def extended_to(
        self,
        others: Sequence[_Curve],
        at: Literal["start", "end"] = "end",
        how: _Extension = "natural",
        *,
        cancel: _Cancel | None = None,
    ) -> NurbsCurve:
        """Extend the curve at one end to where it first meets other curves.

        Parameters
        ----------
        others : sequence of curves
            Curves of any kinds.
        at : {'start', 'end'}, default 'end'
            The end.
        how : {'natural', 'arc', 'straight'}, default 'natural'
            As of `extended`.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        NurbsCurve
            The longer curve.

        Raises
        ------
        InvalidShape
            If it meets none of them within four times the size of all, or as of `extended`.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0), (4, 0)])
        >>> round(line.extended_to([sc.BezierCurve([(6, -1), (6, 1)])]).length(), 9)
        6.0
        """
    def rounded(self, radius: float, *, shrink: bool = False, cancel: _Cancel | None = None) -> NurbsCurve:
        """Replace every corner by an arc that touches both sides.

        Parameters
        ----------
        radius : float
            Radius of the arcs, above 0.
        shrink : bool, default False
            Whether an arc that does not fit gets the largest radius that does, instead of an error: it
            takes at most half of the curve up to the next corner, or all of it up to an end. Where the
            curve turns back the corner stays.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        NurbsCurve
            The curve with arcs, at the seam of a closed curve too.

        Raises
        ------
        InvalidShape
            If no such arc fits between the neighbors of a corner, or the curve turns back or is not plane
            there.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> corner = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (4, 0), (4, 4)])
        >>> round(corner.rounded(1.0).length() - np.pi / 2, 9)
        6.0
        >>> round(corner.rounded(9.0, shrink=True).length() / np.pi, 9)
        2.0
        """
    def chamfered(self, length: float, *, shrink: bool = False, cancel: _Cancel | None = None) -> NurbsCurve:
        """Replace every corner by a line.

        Parameters
        ----------
        length : float
            How far the line begins before the corner and ends behind it, measured along the curve.
        shrink : bool, default False
            Whether it begins and ends nearer to a corner that has no room, as of `rounded`, instead of an
            error.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        NurbsCurve
            The curve with lines.

        Raises
        ------
        InvalidShape
            If a corner has no room for it.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> corner = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (4, 0), (4, 4)])
        >>> round(corner.chamfered(1.0).length() - 2**0.5, 9)
        6.0
        """
    def offset(
        self,
        distance: float,
        normal: ArrayLike = (0, 0, 1),
        *,
        tolerance: float | None = None,
        corner: Literal["round", "sharp"] = "round",
        trimmed: bool = False,
        cancel: _Cancel | None = None,
    ) -> list[NurbsCurve]:
        """Offset a plane curve to its left.

        Lines and arcs of circles are moved exactly; other spans become cubics within the tolerance.

        Parameters
        ----------
        distance : float
            How far, to the left seen against the normal, to the right where it is negative.
        normal : array_like, default (0, 0, 1)
            Normal (3,) of the plane of the curve.
        tolerance : float, optional
            The largest error, a length; by default 2^-20 of the size.
        corner : {'round', 'sharp'}, default 'round'
            At corners an arc, or the corner of both tangents up to four times the distance away.
        trimmed : bool, default False
            Whether parts that are nearer to the curve than the distance are removed.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        list of NurbsCurve
            The offset; several curves where the curve has gaps or the offset is trimmed.

        Raises
        ------
        InvalidShape
            If the curve is not in a plane with that normal, the distance is zero or not finite, or
            nothing is left.
        ToleranceNotReached
            If the tolerance is not reached.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Tiller and Hanson 1984; lecture row S18.

        Examples
        --------
        >>> circle = sc.conics.circle((0, 0, 0), 2.0)
        >>> round(circle.offset(0.5)[0].length() / (2 * np.pi), 9)      # inwards
        1.5
        """
    def least_distance(
        self, other: _Curve | _Patch | PatchSet, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> LeastDistance:
        """Find where this shape and another one are nearest to each other.

        The global minimum, ends and borders included. Of several places at one distance it is any of them.

        Parameters
        ----------
        other : curve or patch or PatchSet
            A curve or patch of any kind, or a set of patches.
        tolerance : float, optional
            How much nearer they may be elsewhere, a length; by default 2^-33 of the size of both.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        LeastDistance
            The distance, with parameters and points on both shapes, and which patches of sets they are
            on.

        Raises
        ------
        InvalidShape
            If the tolerance is negative, or bent shapes are at one distance all along: give a larger
            tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998; lecture row S18.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (4, 0)])
        >>> b = sc.BezierCurve([(1, 3), (3, 1)])
        >>> a.least_distance(b).distance
        1.0
        """
    def stationary_points(self, point: ArrayLike, *, cancel: _Cancel | None = None) -> StationaryPoints:
        """Find all places where the distance from a point is stationary.

        These are the feet of all normals through the point, the ends of the curve and of its pieces, and
        corners where the distance is a minimum or a maximum.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        StationaryPoints
            The places in the order of their parameters, each once.

        Raises
        ------
        InvalidShape
            If the point is not finite or too far away, or where the distance is constant, as from the
            center of a circle.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lane and Riesenfeld 1981; lecture row S15.

        Examples
        --------
        >>> found = sc.BezierCurve([(0, 0), (4, 0)]).stationary_points((1, 2))
        >>> found.parameters.round(9).tolist(), found.kinds
        ([0.0, 0.25, 1.0], ('maximum', 'minimum', 'maximum'))
        """
    def nearest_all(
        self, point: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find all places where the distance from a point is a minimum that is nearly the least one.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        tolerance : float, optional
            By how much the distance may exceed the least one, a length; by default a few roundings.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            The places in the order of their parameters (n,).

        Raises
        ------
        InvalidShape
            If the point is not finite, or where the distance is constant.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> bow = sc.BezierCurve([(-1, 1), (0, -1), (1, 1)])
        >>> bow.nearest_all((0, 2)).points[:, 0].round(6).tolist()
        [-1.0, 1.0]
        """
    def rebuild(
        self,
        count: SupportsIndex | None = None,
        degree: SupportsIndex | None = None,
        *,
        tolerance: float | None = None,
        ends: Literal["points", "tangents"] = "points",
        cancel: _Cancel | None = None,
    ) -> Approximation[NurbsCurve]:
        """Approximate by a polynomial curve with even knots over the same domain.

        It is nearest in the integral of the squared distance at equal parameters, and periodic if the curve
        is.

        Parameters
        ----------
        count : int, optional
            Number of control points; with a tolerance the most.
        degree : int, optional
            Degree; by default that of the curve.
        tolerance : float, optional
            As few control points as come within it, a length.
        ends : {'points', 'tangents'}, default 'points'
            Of an open curve the end points stay, or the tangents there too.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsCurve
            The new curve, and the largest distance at equal parameters, at most 1 % above the truth.

        Raises
        ------
        InvalidShape
            If the count is below the number that the degree needs.
        ToleranceNotReached
            If the tolerance is not reached.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S17.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> curve, error = arc.rebuild(degree=3, tolerance=1e-4)
        >>> curve.is_rational, error <= 1e-4
        (False, True)
        """
    def fair(
        self, tolerance: float, *, ends: Literal["points", "tangents"] = "points", cancel: _Cancel | None = None
    ) -> Approximation[NurbsCurve]:
        """Smooth the curve within a tolerance.

        Knots and weights stay; the integral of the squared second derivative becomes as small as the
        tolerance allows.

        Parameters
        ----------
        tolerance : float
            The largest distance at equal parameters, a length above 0.
        ends : {'points', 'tangents'}, default 'points'
            Of an open curve the end points stay, or the tangents there too.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsCurve
            The new curve and the largest distance at equal parameters, at most 1 % above the truth.

        Raises
        ------
        InvalidShape
            Unless the tolerance is positive and the degree is 2 at least.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Reinsch 1967; lecture row S17.

        Examples
        --------
        >>> noisy = sc.BezierCurve([(0, 0), (1, 0.1), (2, -0.1), (3, 0)])
        >>> smooth, error = noisy.fair(0.01)
        >>> bool(np.ptp(smooth.points[:, 1]) < np.ptp(noisy.points[:, 1])), error <= 0.01
        (True, True)
        """
    def torsion(self, u: ArrayLike, *, side: _Side = "right") -> _Floats:
        """Measure the torsion det(C', C'', C''') / |C' x C''|², positive for a right-handed screw.

        At an inflection or a cusp it is the limit; NaN on a straight line.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Torsions (...,), in 1 / length.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.PowerCurve([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]).torsion(0.0).item()
        3.0
        """
    def inflections(self, direction: ArrayLike | None = None) -> _Floats:
        """Find the parameters where the curve begins to bend to the other side.

        All sign changes of the signed curvature; the middle of a straight part between two bends. Corners do
        not count.

        Parameters
        ----------
        direction : array_like, optional
            Vector (3,) that the curve is seen against; by default the normal of its plane.

        Returns
        -------
        numpy.ndarray
            Parameters (n,) in order.

        Raises
        ------
        InvalidShape
            If no direction is given and the curve lies in no plane.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 1), (2, -1), (3, 0)]).inflections().round(9)
        array([0.5])
        """
    def extrema(self, direction: ArrayLike) -> _Floats:
        """Find the parameters where the curve has an extremum along a direction.

        All zeros of the derivative along it, both ends of a part at right angles to it, corners where it
        changes sign, and the ends of the curve and of its pieces.

        Parameters
        ----------
        direction : array_like
            Vector (3,).

        Returns
        -------
        numpy.ndarray
            Parameters (n,) in order.

        Raises
        ------
        InvalidShape
            If the direction is zero.
        PointAtInfinity
            If the curve runs to infinity.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).extrema((0, 1, 0))
        array([0. , 0.5, 1. ])
        """
    def bounding_box(self) -> _Floats:
        """Find the smallest box along the axes that contains the curve.

        Not that of the control points: right to a few roundings of the largest coordinate.

        Returns
        -------
        numpy.ndarray
            Array (2, 3) of the lowest and the highest corner.

        Raises
        ------
        PointAtInfinity
            If the curve runs to infinity.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).bounding_box().tolist()
        [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0]]
        """
    def signed_area(self, normal: ArrayLike = (0.0, 0.0, 1.0), *, tolerance: float = 1e-12) -> float:
        """Measure the area inside a closed curve, positive where it lies to the left.

        Parts enclosed twice count twice. For a curve that is not plane it is the area of its projection along
        the normal. Exact, but for rounding, for polynomial curves.

        Parameters
        ----------
        normal : array_like, default (0.0, 0.0, 1.0)
            Vector (3,) that the curve is seen against.
        tolerance : float, default 1e-12
            The largest relative error for rational curves.

        Returns
        -------
        float
            The area, in square units of the points.

        Raises
        ------
        InvalidShape
            If the ends are apart by more than 1e-9 of the size or the curve is in several pieces.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> round(sc.conics.circle((0, 0, 0), 2.0).signed_area(), 9)
        12.566370614
        """
    def winding_number(self, point: ArrayLike, normal: ArrayLike = (0.0, 0.0, 1.0)) -> int | NDArray[np.int64]:
        """Count how often a closed curve winds around a point, or each of several points, to the left.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,), or points (..., 2 or 3).
        normal : array_like, default (0.0, 0.0, 1.0)
            Vector (3,) that the curve is seen against.

        Returns
        -------
        int or numpy.ndarray
            The winding number, 0 outside; of points an int64 array (...,).

        Raises
        ------
        InvalidShape
            If a point lies on the curve up to 1e-12 of its size, or the curve is not closed.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> circle = sc.conics.circle((0, 0, 0), 2.0)
        >>> circle.winding_number((1, 0, 0)), circle.winding_number((3, 0, 0))
        (1, 0)
        >>> circle.winding_number([(1, 0), (3, 0)])
        array([1, 0])
        """
    def frenet_frame(self, u: ArrayLike, *, side: _Side = "right") -> _Floats:
        """Evaluate tangent, normal and binormal of Frenet's frame.

        Limits are taken where a derivative falls to zero. Normal and binormal are NaN where the curve is
        straight.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Unit vectors (..., 3, 3), one in each row.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S15.

        Examples
        --------
        >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
        >>> tangent, normal, binormal = arc.frenet_frame(0.0)
        >>> normal.round(12).tolist()[0]
        -1.0
        """
    def frames(
        self, u: ArrayLike, kind: Literal["frenet", "rotation_minimizing"] = "rotation_minimizing", *,
        start: ArrayLike | None = None, closed: bool = False, side: _Side = "right", cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate frames of tangent, normal and binormal along the curve.

        Rotation-minimizing frames turn around the tangent as little as possible, from the start of the
        domain, to about 1e-9. Straight parts keep the frame; at a corner it turns as little as it can.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain; a periodic curve or direction takes any, modulo its period.
        kind : {'frenet', 'rotation_minimizing'}, default 'rotation_minimizing'
            Rotation-minimizing frames, or those of `frenet_frame`.
        start : array_like, optional
            Vector (3,) along which the normal points at the start, as far as it is at right angles to the
            curve; by default the normal there.
        closed : bool, default False
            Whether the turn of the frame at the end of a closed curve is taken back, evenly by length.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Unit vectors (..., 3, 3), one in each row.

        Raises
        ------
        InvalidShape
            If the curve is a point; with 'frenet', where it is straight or has a zero derivative; with
            `closed`, unless it closes smoothly.
        PointAtInfinity
            If the curve runs to infinity.
        ToleranceNotReached
            If a span turns so wildly that 2^17 steps are not enough.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Wang, Jüttler, Zheng and Liu 2008; lecture row S15.

        Examples
        --------
        >>> line = sc.BezierCurve([(0, 0, 0), (2, 0, 0)])
        >>> line.frames(0.5, start=(0, 0, 1)).tolist()
        [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]
        """
    def dumps(self) -> str:
        """Write the shape as JSON text.

        Returns
        -------
        str
            Text that `loads` reads back equal in every bit.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> sc.loads(curve.dumps()) == curve
        True
        """
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> PowerCurve: ...
    def __deepcopy__(self, memo: object, /) -> PowerCurve: ...

@final
class NurbsPatch:
    """A NURBS patch: a net of control points with weights on two knot vectors.

    Immutable; arrays that it gives are read-only views.

    Parameters
    ----------
    degree : sequence of ints
        Degrees (2,) in u and v, each 1 to 255.
    knots : sequence of array_like
        Two knot vectors, for u and v; of a periodic direction one period.
    points : array_like
        Net (nu, nv, 2 or 3) of control points, in any unit of length.
    weights : array_like, optional
        Weights (nu, nv), 1 where none are given; 0 makes a point a direction.
    periodic : sequence of bools, default (False, False)
        Whether the patch is closed in u and in v.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    The NURBS Book, 4.4; lecture row S20.

    Examples
    --------
    >>> patch = sc.NurbsPatch((1, 1), ([0, 0, 1, 1], [0, 0, 1, 1]), [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]])
    >>> patch.evaluate(0.5, 0.5)
    array([0.5 , 0.5 , 0.25])
    """

    def __init__(
        self,
        degree: _Pair,
        knots: _Knots,
        points: ArrayLike,
        weights: ArrayLike | None = None,
        periodic: Sequence[bool] = (False, False),
    ) -> None: ...
    @staticmethod
    def from_homogeneous(
        degree: _Pair, knots: _Knots, points: ArrayLike, periodic: Sequence[bool] = (False, False)
    ) -> NurbsPatch:
        """Make a patch from homogeneous control points.

        Parameters
        ----------
        degree : sequence of ints
            Degrees (2,) in u and v.
        knots : sequence of array_like
            Two knot vectors, for u and v.
        points : array_like
            Array (nu, nv, 4) of wx, wy, wz, w; w = 0 makes a direction.
        periodic : sequence of bools, default (False, False)
            Whether the patch is closed in u and in v.

        Returns
        -------
        NurbsPatch
            The patch.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> rows = [[(0, 0, 0, 1), (0, 1, 0, 1)], [(4, 0, 0, 2), (4, 2, 0, 2)]]
        >>> sc.NurbsPatch.from_homogeneous((1, 1), ([0, 0, 1, 1], [0, 0, 1, 1]), rows).points[1].tolist()
        [[2.0, 0.0, 0.0], [2.0, 1.0, 0.0]]
        """
    @property
    def degree(self) -> tuple[int, int]:
        """Degrees in u and in v.

        Examples
        --------
        >>> sc.build.cylinder((0, 0, 0), (0, 0, 1), 1.0, 2.0).degree
        (2, 1)
        """
    @property
    def domain(self) -> tuple[_Interval, _Interval]:
        """Domains ((start, end) of u, (start, end) of v).

        Examples
        --------
        >>> sc.build.sphere((0, 0, 0), 1.0).domain
        ((0.0, 4.0), (0.0, 2.0))
        """
    @property
    def is_rational(self) -> bool:
        """True unless every weight is 1.

        Examples
        --------
        >>> sc.build.sphere((0, 0, 0), 1.0).is_rational
        True
        """
    @property
    def periodic(self) -> tuple[bool, bool]:
        """Whether the patch is periodic in u and in v.

        Examples
        --------
        >>> sc.build.sphere((0, 0, 0), 1.0).periodic
        (True, False)
        """
    @property
    def knots(self) -> tuple[_Floats, _Floats]:
        """Knots of u and of v: read-only float64 arrays.

        Examples
        --------
        >>> sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)).knots
        (array([0., 0., 1., 1.]), array([0., 0., 1., 1.]))
        """
    @property
    def knot_vectors(self) -> tuple[basis.KnotVector, basis.KnotVector]:
        """The `basis.KnotVector` of u and that of v.

        Examples
        --------
        >>> [vector.count for vector in sc.build.sphere((0, 0, 0), 1.0).knot_vectors]
        [8, 5]
        """
    @property
    def points(self) -> _Floats:
        """Control points (nu, nv, 3) float64, as given, read-only.

        Examples
        --------
        >>> sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)).points.tolist()
        [[[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[2.0, 0.0, 0.0], [2.0, 1.0, 0.0]]]
        """
    @property
    def weights(self) -> _Floats:
        """Weights (nu, nv) float64, read-only.

        Examples
        --------
        >>> sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)).weights.tolist()
        [[1.0, 1.0], [1.0, 1.0]]
        """
    @property
    def homogeneous_points(self) -> _Floats:
        """Array (nu, nv, 4) of wx, wy, wz, w; a direction keeps its coordinates. InvalidShape where one is too
        large for a number.

        Examples
        --------
        >>> sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)).homogeneous_points.shape
        (2, 2, 4)
        """
    def with_points(self, points: ArrayLike) -> NurbsPatch:
        """Replace the control points, keep everything else.

        Parameters
        ----------
        points : array_like
            A net of the same shape.

        Returns
        -------
        NurbsPatch
            The new patch.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.with_points(plane.points + (0, 0, 3)).evaluate(0.5, 0.5).tolist()
        [1.0, 0.5, 3.0]
        """
    def with_weights(self, weights: ArrayLike) -> NurbsPatch:
        """Replace the weights, keep everything else.

        Parameters
        ----------
        weights : array_like
            Weights of the same net.

        Returns
        -------
        NurbsPatch
            The new patch.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.with_weights([[1, 1], [3, 3]]).evaluate(0.5, 0.5).tolist()
        [1.5, 0.5, 0.0]
        """
    def evaluate(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: _Points | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Points:
        """Evaluate points of the patch at pairs of parameters.

        Parameters broadcast. A pair has the same result in every bit in a batch of any shape.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u; a periodic direction takes any, modulo its period.
        v : array_like
            Parameters in v, as `u`.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Points (..., 3) of the same units as the control points; float32 where `dtype` or `out` ask
            for it.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> sphere.evaluate(0.0, [0.0, 1.0, 2.0]).round(12).tolist()
        [[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
        """
    def evaluate_grid(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: _Points | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Points:
        """Evaluate points at every pair of parameters.

        Parameters
        ----------
        u : array_like
            Parameters (a,) in u.
        v : array_like
            Parameters (b,) in v.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Points (a, b, 3).

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.evaluate_grid([0.0, 0.5, 1.0], [0.0, 1.0]).shape
        (3, 2, 3)
        """
    def evaluate_grid_with_normals(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: tuple[_Points, _Points] | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> tuple[_Points, _Points]:
        """Evaluate points and unit normals at every pair of parameters.

        Normals point along S_u x S_v; at a pole or a collapsed edge they are the limit from inside the
        domain, NaN where there is none.

        Parameters
        ----------
        u : array_like
            Parameters (a,) in u.
        v : array_like
            Parameters (b,) in v.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : tuple (numpy.ndarray, numpy.ndarray), optional
            Two C-contiguous arrays (a, b, 3) to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        tuple (numpy.ndarray, numpy.ndarray)
            Points and normals, both (a, b, 3).

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> points, normals = plane.evaluate_grid_with_normals([0.5], [0.5])
        >>> normals.tolist()
        [[[0.0, 0.0, 1.0]]]
        """
    def derivatives(
        self,
        u: ArrayLike,
        v: ArrayLike,
        order: SupportsIndex,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        out: _Floats | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate mixed derivatives at pairs of parameters, which broadcast.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u.
        v : array_like
            Parameters in v, as `u`.
        order : int
            Highest order of derivatives along u and along v.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (..., order + 1, order + 1, 3): `[..., k, l, :]` is derived k times along u, l times
            along v.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain, or a derivative is too large for a number.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        The NURBS Book, A4.4.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.derivatives(0.5, 0.5, 1)[1, 0].tolist()
        [2.0, 0.0, 0.0]
        """
    def first_derivatives(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        out: _Floats | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate points and first derivatives at pairs of parameters, which broadcast.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u.
        v : array_like
            Parameters in v, as `u`.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (..., 3, 3) of S, S_u and S_v, with the bits of `derivatives`.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain, or a derivative is too large for a number.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> point, along_u, along_v = plane.first_derivatives(0.5, 0.5)
        >>> point.tolist(), along_u.tolist(), along_v.tolist()
        ([1.0, 0.5, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0])
        """
    def split(self, axis: _Axis, u: float) -> tuple[NurbsPatch, ...]:
        """Cut the patch at a parameter of one direction.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        u : float
            A parameter inside the domain of the direction.

        Returns
        -------
        tuple of NurbsPatch
            (before, after); of a periodic direction (opened,), cut at u.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0))
        >>> [round(part.area(), 9) for part in plane.split("u", 0.25)]
        [1.0, 3.0]
        """
    def transformed(self, matrix: ArrayLike) -> NurbsPatch:
        """Apply a linear, affine or projective map.

        Under a projective map the weights change; a point that goes to infinity gets the weight 0.

        Parameters
        ----------
        matrix : array_like
            Matrix (3, 3), (3, 4) or (4, 4) that is applied to columns.

        Returns
        -------
        NurbsPatch
            The image of the patch.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S9, S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> round(plane.transformed([[1, 0, 0, 5], [0, 3, 0, 0], [0, 0, 1, 0]]).area(), 9)
        6.0
        """
    def translated(self, by: ArrayLike) -> NurbsPatch:
        """Move the shape by a vector.

        Parameters
        ----------
        by : array_like
            Vector (2 or 3,).

        Returns
        -------
        NurbsPatch
            The moved shape.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).translated((5, 0, 1)).points.tolist()
        [[5.0, 0.0, 1.0], [6.0, 2.0, 1.0]]
        """
    def rotated(self, angle: float, axis: ArrayLike = (0, 0, 1), about: ArrayLike = (0, 0, 0)) -> NurbsPatch:
        """Rotate the shape about an axis, counterclockwise as seen from its tip.

        Parameters
        ----------
        angle : float
            Angle in radians.
        axis : array_like, default (0, 0, 1)
            Vector (3,) along the axis; only its direction counts.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) on the axis.

        Returns
        -------
        NurbsPatch
            The rotated shape.

        Raises
        ------
        InvalidShape
            If the axis is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).rotated(np.pi, about=(1, 0)).points.round(9)[1].tolist()
        [1.0, -2.0, 0.0]
        """
    def scaled(self, factor: ArrayLike, about: ArrayLike = (0, 0, 0)) -> NurbsPatch:
        """Scale the shape about a point.

        Parameters
        ----------
        factor : array_like
            A number, or one for each coordinate (3,); a negative one mirrors.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) that stays.

        Returns
        -------
        NurbsPatch
            The scaled shape.

        Raises
        ------
        InvalidShape
            If a factor is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).scaled((2, -1, 1)).points[1].tolist()
        [2.0, -2.0, 0.0]
        """
    def reversed(self, axis: _Axis) -> NurbsPatch:
        """Reverse one direction; normals are turned over.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.

        Returns
        -------
        NurbsPatch
            The same surface.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.reversed("u").evaluate(0.0, 0.0).tolist()
        [2.0, 0.0, 0.0]
        """
    def swapped(self) -> NurbsPatch:
        """Exchange u and v; normals are turned over.

        Returns
        -------
        NurbsPatch
            The same surface.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.swapped().evaluate(0.0, 1.0).tolist()
        [2.0, 0.0, 0.0]
        """
    def to_bezier(self) -> list[list[BezierPatch]]:
        """Convert to Bezier patches, one for each pair of spans.

        Returns
        -------
        list of list of BezierPatch
            Rows along u of lists along v.

        Examples
        --------
        >>> rows = sc.build.sphere((0, 0, 0), 1.0).to_bezier()
        >>> len(rows), len(rows[0])
        (4, 2)
        """
    def to_hermite(self) -> HermitePatch:
        """Convert to a grid of bicubic Hermite patches.

        Returns
        -------
        HermitePatch
            The same patch.

        Raises
        ------
        InvalidShape
            If it is rational, of degree above 3 or not C1 inside.

        Examples
        --------
        >>> sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)).to_hermite().tangents_u[0].tolist()
        [[2.0, 0.0, 0.0], [2.0, 0.0, 0.0]]
        """
    def to_nurbs(self) -> NurbsPatch:
        """Give the patch itself.

        Returns
        -------
        NurbsPatch
            The patch.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.to_nurbs() == plane
        True
        """
    def insert_knot(self, axis: _Axis, u: float, times: SupportsIndex = 1) -> NurbsPatch:
        """Add a knot in one direction without changing the surface.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        u : float
            A parameter inside the domain of the direction.
        times : int, default 1
            How often.

        Returns
        -------
        NurbsPatch
            The same surface with more knots.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0))
        >>> plane.insert_knot("u", 0.5).points.shape
        (3, 2, 3)
        """
    def refine(self, axis: _Axis, knots: ArrayLike) -> NurbsPatch:
        """Add several knots in one direction without changing the surface.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        knots : array_like
            Parameters (n,) inside the domain of the direction.

        Returns
        -------
        NurbsPatch
            The same surface with more knots.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0))
        >>> plane.refine("u", [0.25, 0.5]).points[:, 0, 0].tolist()
        [0.0, 1.0, 2.0, 4.0]
        """
    def unrolled(self) -> NurbsPatch:
        """Convert periodic directions to plain ones whose knots and points are repeated.

        Returns
        -------
        NurbsPatch
            The same surface.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> sphere.unrolled().periodic, round(sphere.unrolled().area() / np.pi, 9)
        ((False, False), 4.0)
        """
    def nearest(
        self, points: ArrayLike, *, threads: int = 0, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find the nearest point of the patch to each of several points.

        The global minimum: borders, corners and poles are included. Of several places at one distance the one
        with the smallest u, then v, is taken; where a whole curve of places is as near, any of them. Where
        the patch passes through infinity its finite part counts. A point has the same result in any batch.

        Parameters
        ----------
        points : array_like
            Points (..., 2 or 3).
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            Parameters (..., 2), points and distances, right to a few roundings of the size of the patch.

        Raises
        ------
        InvalidShape
            If a point is not finite, or more than 2^18 parts may hold the nearest point.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> round(sphere.nearest((3, 0, 0)).distances.item(), 9)
        2.0
        """
    def least_distance(
        self, other: _Curve | _Patch | PatchSet, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> LeastDistance:
        """Find where this shape and another one are nearest to each other.

        The global minimum, ends and borders included. Of several places at one distance it is any of them.

        Parameters
        ----------
        other : curve or patch or PatchSet
            A curve or patch of any kind, or a set of patches.
        tolerance : float, optional
            How much nearer they may be elsewhere, a length; by default 2^-33 of the size of both.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        LeastDistance
            The distance, with parameters and points on both shapes, and which patches of sets they are
            on.

        Raises
        ------
        InvalidShape
            If the tolerance is negative, or bent shapes are at one distance all along: give a larger
            tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998; lecture row S18.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (4, 0)])
        >>> b = sc.BezierCurve([(1, 3), (3, 1)])
        >>> a.least_distance(b).distance
        1.0
        """
    def stationary_points(self, point: ArrayLike, *, cancel: _Cancel | None = None) -> StationaryPoints:
        """Find all places where the distance from a point is stationary.

        These are the feet of all normals through the point; and on borders and edges between pieces, in
        corners and poles, the minima and maxima of the distance from the patch.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        StationaryPoints
            The places in the order of u, then v, each once.

        Raises
        ------
        InvalidShape
            If the point is not finite or too far away, or where such places are a curve, as from the
            center of a sphere.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Sherbrooke and Patrikalakis 1993.

        Examples
        --------
        >>> found = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 4, 0)).stationary_points((1, 1, 2))
        >>> found.kinds.count("minimum"), found.distances.min().round(9).item()
        (1, 2.0)
        """
    def rays(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        hits: Literal["first", "all"] = "first",
        limits: ArrayLike | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> RayHits:
        """Find where rays meet the patch.

        Borders, seams and poles count once each; a patch that crosses itself is met on each of its sheets. No
        place is lost: a ray that touches the patch, lies on it or goes through a pole is decided by
        `patch_intersections`. A ray has the same result in any batch.

        Parameters
        ----------
        origins : array_like
            Points (..., 3) where rays start.
        directions : array_like
            Vectors (..., 3); they broadcast with the origins.
        hits : {'first', 'all'}, default 'first'
            The first place of each ray, or all places.
        limits : array_like, optional
            First and last multiple (2,) of the direction, by default 0 and infinity; (-inf, inf) takes
            whole lines.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        RayHits
            The places: arrays of the shape of the rays with 'first', NaN where a ray misses; of shape
            (n,) with 'all'.

        Raises
        ------
        InvalidShape
            If a ray is not finite, has no direction, starts too far away, or cannot be decided; the
            message names it.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Kajiya 1982; Nishita, Sederberg and Kakimoto 1990.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> found = sphere.rays([(-3, 0, 0.5)], [(1, 0, 0)])
        >>> round(found.along[0].item(), 9), found.patches.tolist()
        (2.133974596, [0])
        """
    def sections(
        self, other: _Patch, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Sections:
        """Find the curves along which the patch meets another one.

        A curve ends at borders, at poles, where patches that cross touch and where one is folded. Of parts
        that both have in common the borders are given.

        Parameters
        ----------
        other : patch
            A patch of any kind.
        tolerance : float, optional
            The largest distance of a curve from both patches, a length; by default 2^-20 of the size of
            both.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Sections
            The curves, their images in the parameters of both patches, and points where the patches
            touch.

        Raises
        ------
        InvalidShape
            If too many pairs of parts are not apart, as where patches are nearly one, or both run through
            infinity.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Sinha, Klassen and Wang 1985; Sederberg and Meyers 1988; lecture row S18.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> wall = sc.build.plane((-2, -2, 0.5), (4, 0, 0), (0, 4, 0))
        >>> found = sphere.sections(wall, 1e-6)
        >>> abs(found.curves[0].length() - np.pi * 3**0.5) < 1e-5
        True
        """
    def plane_sections(
        self, origin: ArrayLike, normal: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Sections:
        """Find the curves along which the patch meets a plane.

        Images on the plane are in its coordinates, with axes by the rule of DXF files: x and y where the
        normal is z.

        Parameters
        ----------
        origin : array_like
            Point (3,) of the plane.
        normal : array_like
            Vector (3,) at right angles to the plane.
        tolerance : float, optional
            The largest distance of a curve from the patch, a length; by default 2^-20 of its size.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Sections
            The curves, as of `sections`.

        Raises
        ------
        InvalidShape
            If the normal is zero, and as of `sections`.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> found = sphere.plane_sections((0, 0, 0.5), (0, 0, 1))
        >>> bool(found.closed[0])
        True
        """
    def nearest_all(
        self, point: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find all places where the distance from a point is a minimum that is nearly the least one.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        tolerance : float, optional
            By how much the distance may exceed the least one, a length; by default a few roundings.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            The places in the order of their parameters (n, 2).

        Raises
        ------
        InvalidShape
            If the point is not finite, or where such places are a curve.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 4, 0))
        >>> plane.nearest_all((1, 2, 3)).parameters.round(9).tolist()
        [[0.25, 0.5]]
        """
    def rebuild(
        self,
        counts: SupportsIndex | tuple[SupportsIndex, SupportsIndex],
        degrees: SupportsIndex | tuple[SupportsIndex, SupportsIndex] | None = None,
        *,
        cancel: _Cancel | None = None,
    ) -> Approximation[NurbsPatch]:
        """Approximate by a polynomial patch with even knots over the same domain.

        It is nearest first along u, then along v. Corners stay; periodic directions stay periodic.

        Parameters
        ----------
        counts : int or a pair of these
            Numbers of control points in u and v, or one for both.
        degrees : int or a pair of these, optional
            Degrees in u and v, or one for both; by default those of the patch.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsPatch
            The new patch, and the largest distance at equal parameters, at most 2 % above the truth.

        Raises
        ------
        InvalidShape
            If a count is below the number that the degree needs.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S17, S20.

        Examples
        --------
        >>> patch, error = sc.build.sphere((0, 0, 0), 1.0).rebuild((12, 9), 3)
        >>> patch.points.shape, patch.is_rational, error < 0.05
        ((12, 9, 3), False, True)
        """
    def fair(
        self, tolerance: float, *,
        ends: Literal["points", "tangents"] | tuple[Literal["points", "tangents"], Literal["points", "tangents"]] = "points",
        cancel: _Cancel | None = None,
    ) -> Approximation[NurbsPatch]:
        """Smooth the patch within a tolerance.

        Knots, weights and borders stay; the energy of a thin plate becomes as small as the tolerance allows.

        Parameters
        ----------
        tolerance : float
            The largest distance at equal parameters, a length above 0.
        ends : {'points', 'tangents'} or a pair of these, default 'points'
            Whether borders stay, or the derivatives across them too; a pair for u and v.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsPatch
            The new patch, and the largest distance at equal parameters, at most 2 % above the truth.

        Raises
        ------
        InvalidShape
            Unless the tolerance is positive and a degree is 2 at least.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Greiner 1994; lecture row S17.

        Examples
        --------
        >>> x, y = np.meshgrid(np.arange(5.0), np.arange(5.0), indexing="ij")
        >>> noisy, _ = sc.fit.interpolate_patch(np.stack([x, y, 0.1 * (-1) ** (x + y)], axis=-1))
        >>> smooth, error = noisy.fair(0.05)
        >>> error <= 0.05, bool(np.ptp(smooth.points[1:-1, 1:-1, 2]) < np.ptp(noisy.points[1:-1, 1:-1, 2]))
        (True, True)
        """
    def fundamental_forms(self, u: ArrayLike, v: ArrayLike, *, side: _Sides = "right") -> tuple[_Floats, _Floats]:
        """Evaluate the first and the second fundamental form at pairs of parameters, which broadcast.

        The unit normal points along S_u x S_v; at a pole it is its limit, and the second form is NaN where it
        has none.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u.
        v : array_like
            Parameters in v, as `u`.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.

        Returns
        -------
        tuple (numpy.ndarray, numpy.ndarray)
            Arrays (..., 2, 2) of [[E, F], [F, G]] and [[L, M], [M, N]].

        Raises
        ------
        InvalidShape
            If a form is too large for a number.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> first, second = plane.fundamental_forms(0.5, 0.5)
        >>> first.tolist(), second.tolist()
        ([[4.0, 0.0], [0.0, 1.0]], [[0.0, 0.0], [0.0, 0.0]])
        """
    def curvatures(self, u: ArrayLike, v: ArrayLike, *, side: _Sides = "right") -> Curvatures:
        """Measure the curvatures at pairs of parameters, which broadcast.

        Positive where the patch bends towards its normal. At a pole they are those on which all lines through
        it agree; NaN where they do not, as at the tip of a cone.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u.
        v : array_like
            Parameters in v, as `u`.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.

        Returns
        -------
        Curvatures
            Gaussian, mean and principal curvatures, and principal directions.

        Raises
        ------
        InvalidShape
            If a curvature is too large for a number.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 2.0)
        >>> round(sphere.curvatures(0.5, 1.0).gauss.item(), 9)
        0.25
        """
    def area(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> float:
        """Measure the area.

        Adaptive quadrature of Gauss and Kronrod on every pair of spans.

        Parameters
        ----------
        tolerance : float, default 1e-12
            The largest relative error; rounding of the coordinates may be more.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        float
            The area, in square units of the points.

        Raises
        ------
        InvalidShape
            If weights differ too much in size.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work; the message names an error that can be had.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> round(sphere.area() / np.pi, 9)
        4.0
        """
    def flux(
        self, field: Callable[[_Floats], ArrayLike], *, tolerance: float = 1e-12, cancel: _Cancel | None = None
    ) -> float:
        """Measure the flux of a vector field through the surface.

        Positive where the field flows to the side of the normals, S_u x S_v of each patch. The surface may be
        open.

        Parameters
        ----------
        field : callable
            A smooth function that takes points (n, 3) and gives vectors (n, 3); it is called with
            thousands of points at once.
        tolerance : float, default 1e-12
            The largest error, relative to the integral of |field · normal|.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        float
            The integral of field · normal.

        Raises
        ------
        InvalidShape
            If values of the field have another shape or are not finite.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work, as where the field jumps.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> round(sphere.flux(lambda points: points) / np.pi, 9)      # three times the volume
        4.0
        """
    def surface_centroid(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> _Floats:
        """Find the centroid of the surface, as of a thin shell.

        Parameters
        ----------
        tolerance : float, default 1e-12
            The largest error, relative to half the diagonal of the box of the points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Point (3,).

        Raises
        ------
        InvalidShape
            If the surface has no area.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> dome = sc.build.sphere((0, 0, 0), 1.0).split("v", 1.0)[1]
        >>> dome.surface_centroid().round(9)[2].item()
        0.5
        """
    def bounding_box(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> _Floats:
        """Find the smallest box along the axes that contains the surface.

        Not that of the control points. Branch and bound on Bezier pieces.

        Parameters
        ----------
        tolerance : float, default 1e-12
            How much too small the box may be, relative to the largest coordinate.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (2, 3) of the lowest and the highest corner.

        Raises
        ------
        InvalidShape
            If the tolerance is not positive.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too many pieces.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S20.

        Examples
        --------
        >>> sc.build.sphere((0, 0, 0), 1.0).bounding_box().round(9).tolist()
        [[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]]
        """
    def isocurve(self, axis: _Axis, at: float) -> NurbsCurve:
        """Extract the curve along which one parameter is constant.

        At a knot it is the value of the patch from there on. A periodic direction takes any parameter.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction whose parameter is constant.
        at : float
            The parameter.

        Returns
        -------
        NurbsCurve
            The exact curve on the knots of the other direction; a Bezier curve of a Bezier patch.

        Raises
        ------
        InvalidShape
            If `at` is outside the domain, or the whole curve lies at infinity.

        References
        ----------
        The NURBS Book, 3.4; lecture rows S18, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> equator = sphere.isocurve("v", 1.0)
        >>> round(equator.length() / (2 * np.pi), 9)
        1.0
        """
    def boundary(self, side: _Border) -> NurbsCurve:
        """Extract the curve along a side; of a periodic direction its seam.

        Parameters
        ----------
        side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side.

        Returns
        -------
        NurbsCurve
            The exact curve, as of `isocurve`.

        Raises
        ------
        InvalidShape
            If the whole side lies at infinity.

        References
        ----------
        Lecture rows S20, S21.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0))
        >>> plane.boundary("v_end").points.tolist()
        [[0.0, 1.0, 0.0], [4.0, 1.0, 0.0]]
        """
    @property
    def is_closed(self) -> bool:
        """Whether the patch bounds a volume: every side is a pole or lies on another side, as on a sphere or a
        torus.

        Examples
        --------
        >>> ball, tube = sc.build.sphere((0, 0, 0), 1.0), sc.build.extrude(sc.conics.circle((0, 0, 0), 1.0), (0, 0, 1))
        >>> ball.is_closed, tube.is_closed
        (True, False)
        """
    def join(
        self,
        side: _Border,
        other: _Patch,
        other_side: _Border,
        continuity: _PatchSmoothness = "G1",
        moves: Literal["second", "first", "both"] = "second",
        reversed: bool | None = None,
    ) -> JoinedPatches:
        """Bring another patch to a side of this one: `build.join_patches`.

        Parameters
        ----------
        side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side of this patch.
        other : patch
            A patch of any kind.
        other_side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side of the other patch.
        continuity : {'C0', 'G1', 'C1', 'G2', 'C2'}, default 'G1'
            As of `build.join_patches`.
        moves : {'second', 'first', 'both'}, default 'second'
            Which patch moves: the other one is the second.
        reversed : bool, optional
            Whether the other side runs against this one; by default as their ends lie nearer.

        Returns
        -------
        JoinedPatches
            Both patches, and how far each moved.

        Raises
        ------
        InvalidShape
            If a side is one point, lies at infinity or is the seam of a periodic direction, or the join
            is not possible.

        Examples
        --------
        >>> a = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> b = sc.build.plane((1.1, 0, 0), (1, 0, 1), (0, 1, 0))
        >>> joined = a.join("u_end", b, "u_start", "C0")
        >>> joined.first.continuity_to("u_end", joined.second, "u_start").gap
        0.0
        """
    def continuity_to(
        self,
        side: _Border,
        other: _Patch,
        other_side: _Border,
        tolerance: float = 1e-8,
        reversed: bool | None = None,
    ) -> SeamContinuity:
        """Measure the continuity between a side of this patch and one of another, as `seam_continuity` does.

        Parameters
        ----------
        side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side of this patch.
        other : patch
            A patch of any kind.
        other_side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side of the other patch.
        tolerance : float, default 1e-08
            Angles and relative differences below it count as none.
        reversed : bool, optional
            Whether the second side runs against the first one; by default as their ends lie nearer.

        Returns
        -------
        SeamContinuity
            The continuity.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S16, S21.

        Examples
        --------
        >>> a = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> b = sc.build.plane((1, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> turned = b.rotated(0.5, (0, 1, 0), (1, 0, 0))
        >>> a.continuity_to("u_end", b, "u_start").c, a.continuity_to("u_end", turned, "u_start").g
        (2, 0)
        """
    def elevate(self, axis: _Axis, times: SupportsIndex = 1) -> NurbsPatch:
        """Raise the degree in one direction without changing the patch; every distinct knot gains as many
        copies.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        times : int, default 1
            By how much.

        Returns
        -------
        NurbsPatch
            The same patch.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        The NURBS Book, 5.5; lecture row S20.

        Examples
        --------
        >>> sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)).elevate("v").points[0].tolist()
        [[0.0, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 1.0, 0.0]]
        """
    def reduce(
        self, axis: _Axis, times: SupportsIndex = 1, tolerance: float | None = None
    ) -> Approximation[NurbsPatch]:
        """Lower the degree in one direction, with the nearest control points.

        Exact where the degree was raised before. A plain direction keeps its ends, clamped.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        times : int, default 1
            By how much.
        tolerance : float, optional
            The largest error allowed, a length; by default any.

        Returns
        -------
        Approximation of NurbsPatch
            The new patch, and the largest distance at equal parameters, at most 2 % above the truth.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        ToleranceNotReached
            If the error exceeds the tolerance.

        References
        ----------
        Lecture row S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> simpler, error = plane.elevate("u").reduce("u")
        >>> simpler.degree, error < 1e-9
        ((1, 1), True)
        """
    def remove_knot(
        self, axis: _Axis, u: float, times: SupportsIndex = 1, tolerance: float | None = None
    ) -> Approximation[NurbsPatch]:
        """Remove an inner knot of one direction, with the nearest control points.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        u : float
            An inner knot.
        times : int, default 1
            How many copies of it.
        tolerance : float, optional
            The largest error allowed, a length; by default any.

        Returns
        -------
        Approximation of NurbsPatch
            The new patch, and the largest distance at equal parameters, at most 2 % above the truth.

        Raises
        ------
        InvalidShape
            If u is not an inner knot.
        ToleranceNotReached
            If the error exceeds the tolerance.

        References
        ----------
        The NURBS Book, 5.4; lecture row S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0))
        >>> simpler, error = plane.insert_knot("u", 0.5).remove_knot("u", 0.5)
        >>> simpler.points.shape, error < 1e-9
        ((2, 2, 3), True)
        """
    def remove_knots(
        self, axis: _Axis, tolerance: float, *, cancel: _Cancel | None = None
    ) -> Approximation[NurbsPatch]:
        """Remove all inner knots of one direction that are not needed within a tolerance.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        tolerance : float
            The largest error allowed, a length in units of the points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsPatch
            The new patch, and the largest distance at equal parameters.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0))
        >>> simpler, error = plane.refine("v", [0.25, 0.5]).remove_knots("v", 1e-9)
        >>> simpler.points.shape, error < 1e-9
        ((2, 2, 3), True)
        """
    def with_domain(self, axis: _Axis, domain: ArrayLike) -> NurbsPatch:
        """Map the knots of one direction to another domain; the points stay.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        domain : array_like
            First and last parameter (2,), start < end.

        Returns
        -------
        NurbsPatch
            The same patch over another domain.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S20.

        Examples
        --------
        >>> sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0)).with_domain("u", (0, 4)).domain
        ((0.0, 4.0), (0.0, 1.0))
        """
    def clamped(self, axis: _Axis) -> NurbsPatch:
        """Clamp both ends of one direction; a periodic direction is cut at its seam.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.

        Returns
        -------
        NurbsPatch
            The same patch.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> sphere.clamped("u").periodic, len(sphere.points), len(sphere.clamped("u").points)
        ((False, False), 8, 9)
        """
    def unclamped(self, axis: _Axis) -> NurbsPatch:
        """Continue the knots of one direction outside the domain; a periodic direction becomes a plain one.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.

        Returns
        -------
        NurbsPatch
            The same patch.

        Raises
        ------
        InvalidShape
            Where weights at an end differ so much that rounding would move the patch.

        References
        ----------
        The NURBS Book, A12.1; lecture row S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0))
        >>> plane.unclamped("u").knots[0]
        array([-1.,  0.,  1.,  2.])
        """
    def to_periodic(self, axis: _Axis, tolerance: float | None = None) -> Approximation[NurbsPatch]:
        """Make a closed direction periodic, as smooth at its seam as it is within the tolerance.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        tolerance : float, optional
            The largest distance of the ends, a length; by default a few roundings.

        Returns
        -------
        Approximation of NurbsPatch
            The periodic patch and its error.

        Raises
        ------
        InvalidShape
            If the weights of the ends differ.
        ToleranceNotReached
            If the ends are farther apart.

        References
        ----------
        Lecture row S20.

        Examples
        --------
        >>> tube = sc.build.cylinder((0, 0, 0), (0, 0, 1), 1.0, 2.0)
        >>> ring, error = tube.clamped("u").to_periodic("u")
        >>> ring.periodic, error < 1e-9
        ((True, False), True)
        """
    def moebius(self, axis: _Axis, rho: float) -> NurbsPatch:
        """Change the parameter of one direction to t = rho u / ((1 - u) + rho u); the domain stays, knots and
        weights change.

        A periodic direction becomes a plain one.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        rho : float
            A positive number; 1 changes nothing.

        Returns
        -------
        NurbsPatch
            The same surface under other parameters.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lee and Lucian 1991; The NURBS Book, 6.4; lecture row S12.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0))
        >>> plane.moebius("u", 3.0).evaluate(0.5, 0.0).tolist()
        [3.0, 0.0, 0.0]
        """
    def largest_distance(self, other: NurbsPatch) -> float:
        """Bound the distance from another patch at equal parameters.

        Parameters
        ----------
        other : NurbsPatch
            A patch over the same domain.

        Returns
        -------
        float
            An upper bound, a length, at most 2 % above the truth; inf where one patch alone runs to
            infinity.

        Raises
        ------
        InvalidShape
            If the domains differ.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0))
        >>> abs(plane.largest_distance(plane.translated((0, 0, 2))) - 2) < 0.04
        True
        """
    def dragged(
        self,
        u: float,
        v: float,
        by: ArrayLike,
        tangent_u_by: ArrayLike | None = None,
        tangent_v_by: ArrayLike | None = None,
        *,
        factors: ArrayLike | None = None,
        locality: float = 0.0,
    ) -> NurbsPatch:
        """Move the point at a pair of parameters by moving the control points as little as possible.

        As `NurbsCurve.dragged`. Points that lie in one place move together, so that seams and poles stay
        closed.

        Parameters
        ----------
        u : float
            The parameter of the point in u.
        v : float
            The parameter of the point in v.
        by : array_like
            Vector (3,) by which the point moves.
        tangent_u_by : array_like, optional
            Vector (3,) added to the derivative along u; zero keeps it, None leaves it free.
        tangent_v_by : array_like, optional
            The same along v.
        factors : array_like, optional
            Factors (nu, nv) of how easily each control point moves; 0 holds it.
        locality : float, default 0.0
            The larger it is, the fewer control points follow: factors are multiplied by the influence of
            a point to this power.

        Returns
        -------
        NurbsPatch
            The new patch.

        Raises
        ------
        InvalidShape
            If nothing that the point depends on may move, or too little to choose the derivatives.

        References
        ----------
        The NURBS Book, 11.5.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> plane.dragged(0.5, 0.5, (0, 0, 1)).evaluate(0.5, 0.5).round(9)
        array([0.5, 0.5, 1. ])
        """
    def dumps(self) -> str:
        """Write the shape as JSON text.

        Returns
        -------
        str
            Text that `loads` reads back equal in every bit.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> sc.loads(curve.dumps()) == curve
        True
        """
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> NurbsPatch: ...
    def __deepcopy__(self, memo: object, /) -> NurbsPatch: ...

@final
class BezierPatch:
    """A Bezier patch over [0, 1] x [0, 1].

    Immutable; arrays that it gives are read-only views.

    Parameters
    ----------
    points : array_like
        Net (degree in u + 1, degree in v + 1, 2 or 3) of control points, in any unit of length.
    weights : array_like, optional
        Weights of the same net, 1 where none are given.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S19.

    Examples
    --------
    >>> patch = sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]])
    >>> patch.degree
    (1, 1)
    """

    def __init__(self, points: ArrayLike, weights: ArrayLike | None = None) -> None: ...
    @property
    def degree(self) -> tuple[int, int]:
        """Degrees in u and in v.

        Examples
        --------
        >>> sc.build.cylinder((0, 0, 0), (0, 0, 1), 1.0, 2.0).degree
        (2, 1)
        """
    @property
    def domain(self) -> tuple[_Interval, _Interval]:
        """Domains ((start, end) of u, (start, end) of v).

        Examples
        --------
        >>> sc.build.sphere((0, 0, 0), 1.0).domain
        ((0.0, 4.0), (0.0, 2.0))
        """
    @property
    def is_rational(self) -> bool:
        """True unless every weight is 1.

        Examples
        --------
        >>> sc.build.sphere((0, 0, 0), 1.0).is_rational
        True
        """
    @property
    def points(self) -> _Floats:
        """Control points (nu, nv, 3) float64, as given, read-only.

        Examples
        --------
        >>> sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)).points.tolist()
        [[[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[2.0, 0.0, 0.0], [2.0, 1.0, 0.0]]]
        """
    @property
    def weights(self) -> _Floats:
        """Weights (nu, nv) float64, read-only.

        Examples
        --------
        >>> sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)).weights.tolist()
        [[1.0, 1.0], [1.0, 1.0]]
        """
    @property
    def homogeneous_points(self) -> _Floats:
        """Array (nu, nv, 4) of wx, wy, wz, w; a direction keeps its coordinates. InvalidShape where one is too
        large for a number.

        Examples
        --------
        >>> sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)).homogeneous_points.shape
        (2, 2, 4)
        """
    def with_points(self, points: ArrayLike) -> BezierPatch:
        """Replace the control points, keep everything else.

        Parameters
        ----------
        points : array_like
            A net of the same shape.

        Returns
        -------
        BezierPatch
            The new patch.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.with_points(plane.points + (0, 0, 3)).evaluate(0.5, 0.5).tolist()
        [1.0, 0.5, 3.0]
        """
    def with_weights(self, weights: ArrayLike) -> BezierPatch:
        """Replace the weights, keep everything else.

        Parameters
        ----------
        weights : array_like
            Weights of the same net.

        Returns
        -------
        BezierPatch
            The new patch.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.with_weights([[1, 1], [3, 3]]).evaluate(0.5, 0.5).tolist()
        [1.5, 0.5, 0.0]
        """
    def evaluate(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: _Points | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Points:
        """Evaluate points of the patch at pairs of parameters.

        Parameters broadcast. A pair has the same result in every bit in a batch of any shape.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u; a periodic direction takes any, modulo its period.
        v : array_like
            Parameters in v, as `u`.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Points (..., 3) of the same units as the control points; float32 where `dtype` or `out` ask
            for it.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> sphere.evaluate(0.0, [0.0, 1.0, 2.0]).round(12).tolist()
        [[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
        """
    def evaluate_grid(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: _Points | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Points:
        """Evaluate points at every pair of parameters.

        Parameters
        ----------
        u : array_like
            Parameters (a,) in u.
        v : array_like
            Parameters (b,) in v.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Points (a, b, 3).

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.evaluate_grid([0.0, 0.5, 1.0], [0.0, 1.0]).shape
        (3, 2, 3)
        """
    def evaluate_grid_with_normals(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: tuple[_Points, _Points] | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> tuple[_Points, _Points]:
        """Evaluate points and unit normals at every pair of parameters.

        Normals point along S_u x S_v; at a pole or a collapsed edge they are the limit from inside the
        domain, NaN where there is none.

        Parameters
        ----------
        u : array_like
            Parameters (a,) in u.
        v : array_like
            Parameters (b,) in v.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : tuple (numpy.ndarray, numpy.ndarray), optional
            Two C-contiguous arrays (a, b, 3) to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        tuple (numpy.ndarray, numpy.ndarray)
            Points and normals, both (a, b, 3).

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> points, normals = plane.evaluate_grid_with_normals([0.5], [0.5])
        >>> normals.tolist()
        [[[0.0, 0.0, 1.0]]]
        """
    def derivatives(
        self,
        u: ArrayLike,
        v: ArrayLike,
        order: SupportsIndex,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        out: _Floats | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate mixed derivatives at pairs of parameters, which broadcast.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u.
        v : array_like
            Parameters in v, as `u`.
        order : int
            Highest order of derivatives along u and along v.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (..., order + 1, order + 1, 3): `[..., k, l, :]` is derived k times along u, l times
            along v.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain, or a derivative is too large for a number.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        The NURBS Book, A4.4.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.derivatives(0.5, 0.5, 1)[1, 0].tolist()
        [2.0, 0.0, 0.0]
        """
    def first_derivatives(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        out: _Floats | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate points and first derivatives at pairs of parameters, which broadcast.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u.
        v : array_like
            Parameters in v, as `u`.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (..., 3, 3) of S, S_u and S_v, with the bits of `derivatives`.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain, or a derivative is too large for a number.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> point, along_u, along_v = plane.first_derivatives(0.5, 0.5)
        >>> point.tolist(), along_u.tolist(), along_v.tolist()
        ([1.0, 0.5, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0])
        """
    def split(self, axis: _Axis, u: float) -> tuple[BezierPatch, BezierPatch]:
        """Cut the patch at a parameter of one direction.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        u : float
            A parameter inside the domain of the direction.

        Returns
        -------
        tuple (BezierPatch, BezierPatch)
            (before, after); of a periodic direction (opened,), cut at u.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0))
        >>> [round(part.area(), 9) for part in plane.split("u", 0.25)]
        [1.0, 3.0]
        """
    def transformed(self, matrix: ArrayLike) -> BezierPatch:
        """Apply a linear, affine or projective map.

        Under a projective map the weights change; a point that goes to infinity gets the weight 0.

        Parameters
        ----------
        matrix : array_like
            Matrix (3, 3), (3, 4) or (4, 4) that is applied to columns.

        Returns
        -------
        BezierPatch
            The image of the patch.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S9, S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> round(plane.transformed([[1, 0, 0, 5], [0, 3, 0, 0], [0, 0, 1, 0]]).area(), 9)
        6.0
        """
    def translated(self, by: ArrayLike) -> BezierPatch:
        """Move the shape by a vector.

        Parameters
        ----------
        by : array_like
            Vector (2 or 3,).

        Returns
        -------
        BezierPatch
            The moved shape.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).translated((5, 0, 1)).points.tolist()
        [[5.0, 0.0, 1.0], [6.0, 2.0, 1.0]]
        """
    def rotated(self, angle: float, axis: ArrayLike = (0, 0, 1), about: ArrayLike = (0, 0, 0)) -> BezierPatch:
        """Rotate the shape about an axis, counterclockwise as seen from its tip.

        Parameters
        ----------
        angle : float
            Angle in radians.
        axis : array_like, default (0, 0, 1)
            Vector (3,) along the axis; only its direction counts.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) on the axis.

        Returns
        -------
        BezierPatch
            The rotated shape.

        Raises
        ------
        InvalidShape
            If the axis is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).rotated(np.pi, about=(1, 0)).points.round(9)[1].tolist()
        [1.0, -2.0, 0.0]
        """
    def scaled(self, factor: ArrayLike, about: ArrayLike = (0, 0, 0)) -> BezierPatch:
        """Scale the shape about a point.

        Parameters
        ----------
        factor : array_like
            A number, or one for each coordinate (3,); a negative one mirrors.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) that stays.

        Returns
        -------
        BezierPatch
            The scaled shape.

        Raises
        ------
        InvalidShape
            If a factor is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).scaled((2, -1, 1)).points[1].tolist()
        [2.0, -2.0, 0.0]
        """
    def reversed(self, axis: _Axis) -> BezierPatch:
        """Reverse one direction; normals are turned over.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.

        Returns
        -------
        BezierPatch
            The same surface.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.reversed("u").evaluate(0.0, 0.0).tolist()
        [2.0, 0.0, 0.0]
        """
    def swapped(self) -> BezierPatch:
        """Exchange u and v; normals are turned over.

        Returns
        -------
        BezierPatch
            The same surface.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.swapped().evaluate(0.0, 1.0).tolist()
        [2.0, 0.0, 0.0]
        """
    def to_bezier(self) -> list[list[BezierPatch]]:
        """Convert to Bezier patches, one for each pair of spans.

        Returns
        -------
        list of list of BezierPatch
            Rows along u of lists along v.

        Examples
        --------
        >>> rows = sc.build.sphere((0, 0, 0), 1.0).to_bezier()
        >>> len(rows), len(rows[0])
        (4, 2)
        """
    def to_hermite(self) -> HermitePatch:
        """Convert to a grid of bicubic Hermite patches.

        Returns
        -------
        HermitePatch
            The same patch.

        Raises
        ------
        InvalidShape
            If it is rational, of degree above 3 or not C1 inside.

        Examples
        --------
        >>> sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)).to_hermite().tangents_u[0].tolist()
        [[2.0, 0.0, 0.0], [2.0, 0.0, 0.0]]
        """
    def to_nurbs(self) -> NurbsPatch:
        """Convert to a NURBS patch.

        Returns
        -------
        NurbsPatch
            The same patch.

        Examples
        --------
        >>> sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]]).to_nurbs().knots
        (array([0., 0., 1., 1.]), array([0., 0., 1., 1.]))
        """
    def nearest(
        self, points: ArrayLike, *, threads: int = 0, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find the nearest point of the patch to each of several points.

        The global minimum: borders, corners and poles are included. Of several places at one distance the one
        with the smallest u, then v, is taken; where a whole curve of places is as near, any of them. Where
        the patch passes through infinity its finite part counts. A point has the same result in any batch.

        Parameters
        ----------
        points : array_like
            Points (..., 2 or 3).
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            Parameters (..., 2), points and distances, right to a few roundings of the size of the patch.

        Raises
        ------
        InvalidShape
            If a point is not finite, or more than 2^18 parts may hold the nearest point.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> round(sphere.nearest((3, 0, 0)).distances.item(), 9)
        2.0
        """
    def least_distance(
        self, other: _Curve | _Patch | PatchSet, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> LeastDistance:
        """Find where this shape and another one are nearest to each other.

        The global minimum, ends and borders included. Of several places at one distance it is any of them.

        Parameters
        ----------
        other : curve or patch or PatchSet
            A curve or patch of any kind, or a set of patches.
        tolerance : float, optional
            How much nearer they may be elsewhere, a length; by default 2^-33 of the size of both.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        LeastDistance
            The distance, with parameters and points on both shapes, and which patches of sets they are
            on.

        Raises
        ------
        InvalidShape
            If the tolerance is negative, or bent shapes are at one distance all along: give a larger
            tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998; lecture row S18.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (4, 0)])
        >>> b = sc.BezierCurve([(1, 3), (3, 1)])
        >>> a.least_distance(b).distance
        1.0
        """
    def stationary_points(self, point: ArrayLike, *, cancel: _Cancel | None = None) -> StationaryPoints:
        """Find all places where the distance from a point is stationary.

        These are the feet of all normals through the point; and on borders and edges between pieces, in
        corners and poles, the minima and maxima of the distance from the patch.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        StationaryPoints
            The places in the order of u, then v, each once.

        Raises
        ------
        InvalidShape
            If the point is not finite or too far away, or where such places are a curve, as from the
            center of a sphere.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Sherbrooke and Patrikalakis 1993.

        Examples
        --------
        >>> found = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 4, 0)).stationary_points((1, 1, 2))
        >>> found.kinds.count("minimum"), found.distances.min().round(9).item()
        (1, 2.0)
        """
    def rays(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        hits: Literal["first", "all"] = "first",
        limits: ArrayLike | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> RayHits:
        """Find where rays meet the patch.

        Borders, seams and poles count once each; a patch that crosses itself is met on each of its sheets. No
        place is lost: a ray that touches the patch, lies on it or goes through a pole is decided by
        `patch_intersections`. A ray has the same result in any batch.

        Parameters
        ----------
        origins : array_like
            Points (..., 3) where rays start.
        directions : array_like
            Vectors (..., 3); they broadcast with the origins.
        hits : {'first', 'all'}, default 'first'
            The first place of each ray, or all places.
        limits : array_like, optional
            First and last multiple (2,) of the direction, by default 0 and infinity; (-inf, inf) takes
            whole lines.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        RayHits
            The places: arrays of the shape of the rays with 'first', NaN where a ray misses; of shape
            (n,) with 'all'.

        Raises
        ------
        InvalidShape
            If a ray is not finite, has no direction, starts too far away, or cannot be decided; the
            message names it.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Kajiya 1982; Nishita, Sederberg and Kakimoto 1990.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> found = sphere.rays([(-3, 0, 0.5)], [(1, 0, 0)])
        >>> round(found.along[0].item(), 9), found.patches.tolist()
        (2.133974596, [0])
        """
    def sections(
        self, other: _Patch, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Sections:
        """Find the curves along which the patch meets another one.

        A curve ends at borders, at poles, where patches that cross touch and where one is folded. Of parts
        that both have in common the borders are given.

        Parameters
        ----------
        other : patch
            A patch of any kind.
        tolerance : float, optional
            The largest distance of a curve from both patches, a length; by default 2^-20 of the size of
            both.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Sections
            The curves, their images in the parameters of both patches, and points where the patches
            touch.

        Raises
        ------
        InvalidShape
            If too many pairs of parts are not apart, as where patches are nearly one, or both run through
            infinity.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Sinha, Klassen and Wang 1985; Sederberg and Meyers 1988; lecture row S18.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> wall = sc.build.plane((-2, -2, 0.5), (4, 0, 0), (0, 4, 0))
        >>> found = sphere.sections(wall, 1e-6)
        >>> abs(found.curves[0].length() - np.pi * 3**0.5) < 1e-5
        True
        """
    def plane_sections(
        self, origin: ArrayLike, normal: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Sections:
        """Find the curves along which the patch meets a plane.

        Images on the plane are in its coordinates, with axes by the rule of DXF files: x and y where the
        normal is z.

        Parameters
        ----------
        origin : array_like
            Point (3,) of the plane.
        normal : array_like
            Vector (3,) at right angles to the plane.
        tolerance : float, optional
            The largest distance of a curve from the patch, a length; by default 2^-20 of its size.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Sections
            The curves, as of `sections`.

        Raises
        ------
        InvalidShape
            If the normal is zero, and as of `sections`.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> found = sphere.plane_sections((0, 0, 0.5), (0, 0, 1))
        >>> bool(found.closed[0])
        True
        """
    def nearest_all(
        self, point: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find all places where the distance from a point is a minimum that is nearly the least one.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        tolerance : float, optional
            By how much the distance may exceed the least one, a length; by default a few roundings.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            The places in the order of their parameters (n, 2).

        Raises
        ------
        InvalidShape
            If the point is not finite, or where such places are a curve.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 4, 0))
        >>> plane.nearest_all((1, 2, 3)).parameters.round(9).tolist()
        [[0.25, 0.5]]
        """
    def rebuild(
        self,
        counts: SupportsIndex | tuple[SupportsIndex, SupportsIndex],
        degrees: SupportsIndex | tuple[SupportsIndex, SupportsIndex] | None = None,
        *,
        cancel: _Cancel | None = None,
    ) -> Approximation[NurbsPatch]:
        """Approximate by a polynomial patch with even knots over the same domain.

        It is nearest first along u, then along v. Corners stay; periodic directions stay periodic.

        Parameters
        ----------
        counts : int or a pair of these
            Numbers of control points in u and v, or one for both.
        degrees : int or a pair of these, optional
            Degrees in u and v, or one for both; by default those of the patch.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsPatch
            The new patch, and the largest distance at equal parameters, at most 2 % above the truth.

        Raises
        ------
        InvalidShape
            If a count is below the number that the degree needs.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S17, S20.

        Examples
        --------
        >>> patch, error = sc.build.sphere((0, 0, 0), 1.0).rebuild((12, 9), 3)
        >>> patch.points.shape, patch.is_rational, error < 0.05
        ((12, 9, 3), False, True)
        """
    def fair(
        self, tolerance: float, *,
        ends: Literal["points", "tangents"] | tuple[Literal["points", "tangents"], Literal["points", "tangents"]] = "points",
        cancel: _Cancel | None = None,
    ) -> Approximation[NurbsPatch]:
        """Smooth the patch within a tolerance.

        Knots, weights and borders stay; the energy of a thin plate becomes as small as the tolerance allows.

        Parameters
        ----------
        tolerance : float
            The largest distance at equal parameters, a length above 0.
        ends : {'points', 'tangents'} or a pair of these, default 'points'
            Whether borders stay, or the derivatives across them too; a pair for u and v.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsPatch
            The new patch, and the largest distance at equal parameters, at most 2 % above the truth.

        Raises
        ------
        InvalidShape
            Unless the tolerance is positive and a degree is 2 at least.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Greiner 1994; lecture row S17.

        Examples
        --------
        >>> x, y = np.meshgrid(np.arange(5.0), np.arange(5.0), indexing="ij")
        >>> noisy, _ = sc.fit.interpolate_patch(np.stack([x, y, 0.1 * (-1) ** (x + y)], axis=-1))
        >>> smooth, error = noisy.fair(0.05)
        >>> error <= 0.05, bool(np.ptp(smooth.points[1:-1, 1:-1, 2]) < np.ptp(noisy.points[1:-1, 1:-1, 2]))
        (True, True)
        """
    def fundamental_forms(self, u: ArrayLike, v: ArrayLike, *, side: _Sides = "right") -> tuple[_Floats, _Floats]:
        """Evaluate the first and the second fundamental form at pairs of parameters, which broadcast.

        The unit normal points along S_u x S_v; at a pole it is its limit, and the second form is NaN where it
        has none.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u.
        v : array_like
            Parameters in v, as `u`.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.

        Returns
        -------
        tuple (numpy.ndarray, numpy.ndarray)
            Arrays (..., 2, 2) of [[E, F], [F, G]] and [[L, M], [M, N]].

        Raises
        ------
        InvalidShape
            If a form is too large for a number.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> first, second = plane.fundamental_forms(0.5, 0.5)
        >>> first.tolist(), second.tolist()
        ([[4.0, 0.0], [0.0, 1.0]], [[0.0, 0.0], [0.0, 0.0]])
        """
    def curvatures(self, u: ArrayLike, v: ArrayLike, *, side: _Sides = "right") -> Curvatures:
        """Measure the curvatures at pairs of parameters, which broadcast.

        Positive where the patch bends towards its normal. At a pole they are those on which all lines through
        it agree; NaN where they do not, as at the tip of a cone.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u.
        v : array_like
            Parameters in v, as `u`.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.

        Returns
        -------
        Curvatures
            Gaussian, mean and principal curvatures, and principal directions.

        Raises
        ------
        InvalidShape
            If a curvature is too large for a number.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 2.0)
        >>> round(sphere.curvatures(0.5, 1.0).gauss.item(), 9)
        0.25
        """
    def area(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> float:
        """Measure the area.

        Adaptive quadrature of Gauss and Kronrod on every pair of spans.

        Parameters
        ----------
        tolerance : float, default 1e-12
            The largest relative error; rounding of the coordinates may be more.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        float
            The area, in square units of the points.

        Raises
        ------
        InvalidShape
            If weights differ too much in size.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work; the message names an error that can be had.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> round(sphere.area() / np.pi, 9)
        4.0
        """
    def flux(
        self, field: Callable[[_Floats], ArrayLike], *, tolerance: float = 1e-12, cancel: _Cancel | None = None
    ) -> float:
        """Measure the flux of a vector field through the surface.

        Positive where the field flows to the side of the normals, S_u x S_v of each patch. The surface may be
        open.

        Parameters
        ----------
        field : callable
            A smooth function that takes points (n, 3) and gives vectors (n, 3); it is called with
            thousands of points at once.
        tolerance : float, default 1e-12
            The largest error, relative to the integral of |field · normal|.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        float
            The integral of field · normal.

        Raises
        ------
        InvalidShape
            If values of the field have another shape or are not finite.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work, as where the field jumps.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> round(sphere.flux(lambda points: points) / np.pi, 9)      # three times the volume
        4.0
        """
    def surface_centroid(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> _Floats:
        """Find the centroid of the surface, as of a thin shell.

        Parameters
        ----------
        tolerance : float, default 1e-12
            The largest error, relative to half the diagonal of the box of the points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Point (3,).

        Raises
        ------
        InvalidShape
            If the surface has no area.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> dome = sc.build.sphere((0, 0, 0), 1.0).split("v", 1.0)[1]
        >>> dome.surface_centroid().round(9)[2].item()
        0.5
        """
    def bounding_box(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> _Floats:
        """Find the smallest box along the axes that contains the surface.

        Not that of the control points. Branch and bound on Bezier pieces.

        Parameters
        ----------
        tolerance : float, default 1e-12
            How much too small the box may be, relative to the largest coordinate.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (2, 3) of the lowest and the highest corner.

        Raises
        ------
        InvalidShape
            If the tolerance is not positive.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too many pieces.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S20.

        Examples
        --------
        >>> sc.build.sphere((0, 0, 0), 1.0).bounding_box().round(9).tolist()
        [[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]]
        """
    def isocurve(self, axis: _Axis, at: float) -> BezierCurve:
        """Extract the curve along which one parameter is constant.

        At a knot it is the value of the patch from there on. A periodic direction takes any parameter.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction whose parameter is constant.
        at : float
            The parameter.

        Returns
        -------
        BezierCurve
            The exact curve on the knots of the other direction; a Bezier curve of a Bezier patch.

        Raises
        ------
        InvalidShape
            If `at` is outside the domain, or the whole curve lies at infinity.

        References
        ----------
        The NURBS Book, 3.4; lecture rows S18, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> equator = sphere.isocurve("v", 1.0)
        >>> round(equator.length() / (2 * np.pi), 9)
        1.0
        """
    def boundary(self, side: _Border) -> BezierCurve:
        """Extract the curve along a side; of a periodic direction its seam.

        Parameters
        ----------
        side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side.

        Returns
        -------
        BezierCurve
            The exact curve, as of `isocurve`.

        Raises
        ------
        InvalidShape
            If the whole side lies at infinity.

        References
        ----------
        Lecture rows S20, S21.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0))
        >>> plane.boundary("v_end").points.tolist()
        [[0.0, 1.0, 0.0], [4.0, 1.0, 0.0]]
        """
    @property
    def is_closed(self) -> bool:
        """Whether the patch bounds a volume: every side is a pole or lies on another side, as on a sphere or a
        torus.

        Examples
        --------
        >>> ball, tube = sc.build.sphere((0, 0, 0), 1.0), sc.build.extrude(sc.conics.circle((0, 0, 0), 1.0), (0, 0, 1))
        >>> ball.is_closed, tube.is_closed
        (True, False)
        """
    def join(
        self,
        side: _Border,
        other: _Patch,
        other_side: _Border,
        continuity: _PatchSmoothness = "G1",
        moves: Literal["second", "first", "both"] = "second",
        reversed: bool | None = None,
    ) -> JoinedPatches:
        """Bring another patch to a side of this one: `build.join_patches`.

        Parameters
        ----------
        side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side of this patch.
        other : patch
            A patch of any kind.
        other_side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side of the other patch.
        continuity : {'C0', 'G1', 'C1', 'G2', 'C2'}, default 'G1'
            As of `build.join_patches`.
        moves : {'second', 'first', 'both'}, default 'second'
            Which patch moves: the other one is the second.
        reversed : bool, optional
            Whether the other side runs against this one; by default as their ends lie nearer.

        Returns
        -------
        JoinedPatches
            Both patches, and how far each moved.

        Raises
        ------
        InvalidShape
            If a side is one point, lies at infinity or is the seam of a periodic direction, or the join
            is not possible.

        Examples
        --------
        >>> a = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> b = sc.build.plane((1.1, 0, 0), (1, 0, 1), (0, 1, 0))
        >>> joined = a.join("u_end", b, "u_start", "C0")
        >>> joined.first.continuity_to("u_end", joined.second, "u_start").gap
        0.0
        """
    def continuity_to(
        self,
        side: _Border,
        other: _Patch,
        other_side: _Border,
        tolerance: float = 1e-8,
        reversed: bool | None = None,
    ) -> SeamContinuity:
        """Measure the continuity between a side of this patch and one of another, as `seam_continuity` does.

        Parameters
        ----------
        side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side of this patch.
        other : patch
            A patch of any kind.
        other_side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side of the other patch.
        tolerance : float, default 1e-08
            Angles and relative differences below it count as none.
        reversed : bool, optional
            Whether the second side runs against the first one; by default as their ends lie nearer.

        Returns
        -------
        SeamContinuity
            The continuity.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S16, S21.

        Examples
        --------
        >>> a = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> b = sc.build.plane((1, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> turned = b.rotated(0.5, (0, 1, 0), (1, 0, 0))
        >>> a.continuity_to("u_end", b, "u_start").c, a.continuity_to("u_end", turned, "u_start").g
        (2, 0)
        """
    def elevate(self, axis: _Axis, times: SupportsIndex = 1) -> BezierPatch:
        """Raise the degree in one direction without changing the patch.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        times : int, default 1
            By how much.

        Returns
        -------
        BezierPatch
            The same patch.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        The NURBS Book, eq. 5.36; lecture row S19.

        Examples
        --------
        >>> patch = sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]])
        >>> patch.elevate("u", 2).degree
        (3, 1)
        """
    def reduce(
        self, axis: _Axis, times: SupportsIndex = 1, tolerance: float | None = None
    ) -> Approximation[BezierPatch]:
        """Lower the degree in one direction, with the same ends.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        times : int, default 1
            By how much.
        tolerance : float, optional
            The largest error allowed, a length; by default any.

        Returns
        -------
        Approximation of BezierPatch
            The new patch, and an upper bound of the distance, at most 2 % above it.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        ToleranceNotReached
            If the error exceeds the tolerance.

        References
        ----------
        Lachance 1988; lecture row S19.

        Examples
        --------
        >>> patch = sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]])
        >>> simpler, error = patch.elevate("u", 2).reduce("u", 2, tolerance=1e-9)
        >>> simpler.degree, error < 1e-9
        ((1, 1), True)
        """
    def dragged(
        self,
        u: float,
        v: float,
        by: ArrayLike,
        tangent_u_by: ArrayLike | None = None,
        tangent_v_by: ArrayLike | None = None,
        *,
        factors: ArrayLike | None = None,
        locality: float = 0.0,
    ) -> BezierPatch:
        """Move the point at a pair of parameters by moving the control points as little as possible.

        As `NurbsCurve.dragged`. Points that lie in one place move together, so that seams and poles stay
        closed.

        Parameters
        ----------
        u : float
            The parameter of the point in u.
        v : float
            The parameter of the point in v.
        by : array_like
            Vector (3,) by which the point moves.
        tangent_u_by : array_like, optional
            Vector (3,) added to the derivative along u; zero keeps it, None leaves it free.
        tangent_v_by : array_like, optional
            The same along v.
        factors : array_like, optional
            Factors (nu, nv) of how easily each control point moves; 0 holds it.
        locality : float, default 0.0
            The larger it is, the fewer control points follow: factors are multiplied by the influence of
            a point to this power.

        Returns
        -------
        BezierPatch
            The new patch.

        Raises
        ------
        InvalidShape
            If nothing that the point depends on may move, or too little to choose the derivatives.

        References
        ----------
        The NURBS Book, 11.5.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> plane.dragged(0.5, 0.5, (0, 0, 1)).evaluate(0.5, 0.5).round(9)
        array([0.5, 0.5, 1. ])
        """
    def dumps(self) -> str:
        """Write the shape as JSON text.

        Returns
        -------
        str
            Text that `loads` reads back equal in every bit.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> sc.loads(curve.dumps()) == curve
        True
        """
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> BezierPatch: ...
    def __deepcopy__(self, memo: object, /) -> BezierPatch: ...

@final
class HermitePatch:
    """A grid of bicubic patches through points with given derivatives.

    Immutable; arrays that it gives are read-only views.

    Parameters
    ----------
    points : array_like
        Points (nu, nv, 2 or 3), in any unit of length.
    tangents_u : array_like
        Derivatives (nu, nv, 2 or 3) along u.
    tangents_v : array_like
        Derivatives (nu, nv, 2 or 3) along v.
    twists : array_like, optional
        Mixed derivatives (nu, nv, 2 or 3), 0 where none are given (Ferguson's patch).
    parameters : sequence of array_like or None, optional
        Increasing parameters (nu,) and (nv,); 0, 1, 2, … where none are given.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S20.

    Examples
    --------
    >>> x, y = np.meshgrid([0.0, 1.0], [0.0, 1.0], indexing="ij")
    >>> points = np.stack([x, y, x * y], axis=-1)
    >>> along_u, along_v = np.stack([x**0, 0 * x, y], axis=-1), np.stack([0 * x, x**0, x], axis=-1)
    >>> patch = sc.HermitePatch(points, along_u, along_v, twists=np.full((2, 2, 3), (0, 0, 1)))
    >>> patch.evaluate(0.5, 0.5)
    array([0.5 , 0.5 , 0.25])
    >>> patch.points.shape == patch.tangents_u.shape == patch.tangents_v.shape == patch.twists.shape
    True
    >>> patch.parameters
    (array([0., 1.]), array([0., 1.]))
    """

    def __init__(
        self,
        points: ArrayLike,
        tangents_u: ArrayLike,
        tangents_v: ArrayLike,
        twists: ArrayLike | None = None,
        parameters: Sequence[ArrayLike | None] | None = None,
    ) -> None: ...
    @property
    def degree(self) -> tuple[int, int]:
        """Degrees in u and in v.

        Examples
        --------
        >>> sc.build.cylinder((0, 0, 0), (0, 0, 1), 1.0, 2.0).degree
        (2, 1)
        """
    @property
    def domain(self) -> tuple[_Interval, _Interval]:
        """Domains ((start, end) of u, (start, end) of v).

        Examples
        --------
        >>> sc.build.sphere((0, 0, 0), 1.0).domain
        ((0.0, 4.0), (0.0, 2.0))
        """
    @property
    def is_rational(self) -> bool:
        """True unless every weight is 1.

        Examples
        --------
        >>> sc.build.sphere((0, 0, 0), 1.0).is_rational
        True
        """
    @property
    def points(self) -> _Floats:
        """Points (nu, nv, 3) float64, read-only."""
    @property
    def tangents_u(self) -> _Floats:
        """Derivatives (nu, nv, 3) float64 along u, read-only."""
    @property
    def tangents_v(self) -> _Floats:
        """Derivatives (nu, nv, 3) float64 along v, read-only."""
    @property
    def twists(self) -> _Floats:
        """Mixed derivatives (nu, nv, 3) float64, read-only."""
    @property
    def parameters(self) -> tuple[_Floats, _Floats]:
        """Parameters (nu,) of u and (nv,) of v: read-only float64 arrays."""
    def evaluate(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: _Points | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Points:
        """Evaluate points of the patch at pairs of parameters.

        Parameters broadcast. A pair has the same result in every bit in a batch of any shape.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u; a periodic direction takes any, modulo its period.
        v : array_like
            Parameters in v, as `u`.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Points (..., 3) of the same units as the control points; float32 where `dtype` or `out` ask
            for it.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> sphere.evaluate(0.0, [0.0, 1.0, 2.0]).round(12).tolist()
        [[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
        """
    def evaluate_grid(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: _Points | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Points:
        """Evaluate points at every pair of parameters.

        Parameters
        ----------
        u : array_like
            Parameters (a,) in u.
        v : array_like
            Parameters (b,) in v.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Points (a, b, 3).

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.evaluate_grid([0.0, 0.5, 1.0], [0.0, 1.0]).shape
        (3, 2, 3)
        """
    def evaluate_grid_with_normals(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: tuple[_Points, _Points] | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> tuple[_Points, _Points]:
        """Evaluate points and unit normals at every pair of parameters.

        Normals point along S_u x S_v; at a pole or a collapsed edge they are the limit from inside the
        domain, NaN where there is none.

        Parameters
        ----------
        u : array_like
            Parameters (a,) in u.
        v : array_like
            Parameters (b,) in v.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : tuple (numpy.ndarray, numpy.ndarray), optional
            Two C-contiguous arrays (a, b, 3) to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        tuple (numpy.ndarray, numpy.ndarray)
            Points and normals, both (a, b, 3).

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> points, normals = plane.evaluate_grid_with_normals([0.5], [0.5])
        >>> normals.tolist()
        [[[0.0, 0.0, 1.0]]]
        """
    def derivatives(
        self,
        u: ArrayLike,
        v: ArrayLike,
        order: SupportsIndex,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        out: _Floats | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate mixed derivatives at pairs of parameters, which broadcast.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u.
        v : array_like
            Parameters in v, as `u`.
        order : int
            Highest order of derivatives along u and along v.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (..., order + 1, order + 1, 3): `[..., k, l, :]` is derived k times along u, l times
            along v.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain, or a derivative is too large for a number.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        The NURBS Book, A4.4.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.derivatives(0.5, 0.5, 1)[1, 0].tolist()
        [2.0, 0.0, 0.0]
        """
    def first_derivatives(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        out: _Floats | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Floats:
        """Evaluate points and first derivatives at pairs of parameters, which broadcast.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u.
        v : array_like
            Parameters in v, as `u`.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (..., 3, 3) of S, S_u and S_v, with the bits of `derivatives`.

        Raises
        ------
        InvalidShape
            If a parameter lies outside the domain, or a derivative is too large for a number.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> point, along_u, along_v = plane.first_derivatives(0.5, 0.5)
        >>> point.tolist(), along_u.tolist(), along_v.tolist()
        ([1.0, 0.5, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0])
        """
    def split(self, axis: _Axis, u: float) -> tuple[HermitePatch, HermitePatch]:
        """Cut the patch at a parameter of one direction.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.
        u : float
            A parameter inside the domain of the direction.

        Returns
        -------
        tuple (HermitePatch, HermitePatch)
            (before, after); of a periodic direction (opened,), cut at u.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0))
        >>> [round(part.area(), 9) for part in plane.split("u", 0.25)]
        [1.0, 3.0]
        """
    def transformed(self, matrix: ArrayLike) -> HermitePatch:
        """Apply a linear, affine or projective map.

        Under a projective map the weights change; a point that goes to infinity gets the weight 0.

        Parameters
        ----------
        matrix : array_like
            Matrix (3, 3), (3, 4) or (4, 4) that is applied to columns.

        Returns
        -------
        HermitePatch
            The image of the patch.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S9, S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> round(plane.transformed([[1, 0, 0, 5], [0, 3, 0, 0], [0, 0, 1, 0]]).area(), 9)
        6.0
        """
    def translated(self, by: ArrayLike) -> HermitePatch:
        """Move the shape by a vector.

        Parameters
        ----------
        by : array_like
            Vector (2 or 3,).

        Returns
        -------
        HermitePatch
            The moved shape.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).translated((5, 0, 1)).points.tolist()
        [[5.0, 0.0, 1.0], [6.0, 2.0, 1.0]]
        """
    def rotated(self, angle: float, axis: ArrayLike = (0, 0, 1), about: ArrayLike = (0, 0, 0)) -> HermitePatch:
        """Rotate the shape about an axis, counterclockwise as seen from its tip.

        Parameters
        ----------
        angle : float
            Angle in radians.
        axis : array_like, default (0, 0, 1)
            Vector (3,) along the axis; only its direction counts.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) on the axis.

        Returns
        -------
        HermitePatch
            The rotated shape.

        Raises
        ------
        InvalidShape
            If the axis is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).rotated(np.pi, about=(1, 0)).points.round(9)[1].tolist()
        [1.0, -2.0, 0.0]
        """
    def scaled(self, factor: ArrayLike, about: ArrayLike = (0, 0, 0)) -> HermitePatch:
        """Scale the shape about a point.

        Parameters
        ----------
        factor : array_like
            A number, or one for each coordinate (3,); a negative one mirrors.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) that stays.

        Returns
        -------
        HermitePatch
            The scaled shape.

        Raises
        ------
        InvalidShape
            If a factor is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).scaled((2, -1, 1)).points[1].tolist()
        [2.0, -2.0, 0.0]
        """
    def reversed(self, axis: _Axis) -> HermitePatch:
        """Reverse one direction; normals are turned over.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction of the patch.

        Returns
        -------
        HermitePatch
            The same surface.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.reversed("u").evaluate(0.0, 0.0).tolist()
        [2.0, 0.0, 0.0]
        """
    def swapped(self) -> HermitePatch:
        """Exchange u and v; normals are turned over.

        Returns
        -------
        HermitePatch
            The same surface.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> plane.swapped().evaluate(0.0, 1.0).tolist()
        [2.0, 0.0, 0.0]
        """
    def to_bezier(self) -> list[list[BezierPatch]]:
        """Convert to Bezier patches, one for each pair of spans.

        Returns
        -------
        list of list of BezierPatch
            Rows along u of lists along v.

        Examples
        --------
        >>> rows = sc.build.sphere((0, 0, 0), 1.0).to_bezier()
        >>> len(rows), len(rows[0])
        (4, 2)
        """
    def to_hermite(self) -> HermitePatch:
        """Convert to a grid of bicubic Hermite patches.

        Returns
        -------
        HermitePatch
            The same patch.

        Raises
        ------
        InvalidShape
            If it is rational, of degree above 3 or not C1 inside.

        Examples
        --------
        >>> sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)).to_hermite().tangents_u[0].tolist()
        [[2.0, 0.0, 0.0], [2.0, 0.0, 0.0]]
        """
    def to_nurbs(self) -> NurbsPatch:
        """Convert to a bicubic NURBS patch with triple knots.

        Returns
        -------
        NurbsPatch
            The same patch.

        Examples
        --------
        >>> flat = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)).to_hermite()
        >>> flat.to_nurbs().degree, flat.to_nurbs().points.shape
        ((3, 3), (4, 4, 3))
        """
    def nearest(
        self, points: ArrayLike, *, threads: int = 0, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find the nearest point of the patch to each of several points.

        The global minimum: borders, corners and poles are included. Of several places at one distance the one
        with the smallest u, then v, is taken; where a whole curve of places is as near, any of them. Where
        the patch passes through infinity its finite part counts. A point has the same result in any batch.

        Parameters
        ----------
        points : array_like
            Points (..., 2 or 3).
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            Parameters (..., 2), points and distances, right to a few roundings of the size of the patch.

        Raises
        ------
        InvalidShape
            If a point is not finite, or more than 2^18 parts may hold the nearest point.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> round(sphere.nearest((3, 0, 0)).distances.item(), 9)
        2.0
        """
    def least_distance(
        self, other: _Curve | _Patch | PatchSet, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> LeastDistance:
        """Find where this shape and another one are nearest to each other.

        The global minimum, ends and borders included. Of several places at one distance it is any of them.

        Parameters
        ----------
        other : curve or patch or PatchSet
            A curve or patch of any kind, or a set of patches.
        tolerance : float, optional
            How much nearer they may be elsewhere, a length; by default 2^-33 of the size of both.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        LeastDistance
            The distance, with parameters and points on both shapes, and which patches of sets they are
            on.

        Raises
        ------
        InvalidShape
            If the tolerance is negative, or bent shapes are at one distance all along: give a larger
            tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998; lecture row S18.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (4, 0)])
        >>> b = sc.BezierCurve([(1, 3), (3, 1)])
        >>> a.least_distance(b).distance
        1.0
        """
    def stationary_points(self, point: ArrayLike, *, cancel: _Cancel | None = None) -> StationaryPoints:
        """Find all places where the distance from a point is stationary.

        These are the feet of all normals through the point; and on borders and edges between pieces, in
        corners and poles, the minima and maxima of the distance from the patch.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        StationaryPoints
            The places in the order of u, then v, each once.

        Raises
        ------
        InvalidShape
            If the point is not finite or too far away, or where such places are a curve, as from the
            center of a sphere.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Sherbrooke and Patrikalakis 1993.

        Examples
        --------
        >>> found = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 4, 0)).stationary_points((1, 1, 2))
        >>> found.kinds.count("minimum"), found.distances.min().round(9).item()
        (1, 2.0)
        """
    def rays(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        hits: Literal["first", "all"] = "first",
        limits: ArrayLike | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> RayHits:
        """Find where rays meet the patch.

        Borders, seams and poles count once each; a patch that crosses itself is met on each of its sheets. No
        place is lost: a ray that touches the patch, lies on it or goes through a pole is decided by
        `patch_intersections`. A ray has the same result in any batch.

        Parameters
        ----------
        origins : array_like
            Points (..., 3) where rays start.
        directions : array_like
            Vectors (..., 3); they broadcast with the origins.
        hits : {'first', 'all'}, default 'first'
            The first place of each ray, or all places.
        limits : array_like, optional
            First and last multiple (2,) of the direction, by default 0 and infinity; (-inf, inf) takes
            whole lines.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        RayHits
            The places: arrays of the shape of the rays with 'first', NaN where a ray misses; of shape
            (n,) with 'all'.

        Raises
        ------
        InvalidShape
            If a ray is not finite, has no direction, starts too far away, or cannot be decided; the
            message names it.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Kajiya 1982; Nishita, Sederberg and Kakimoto 1990.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> found = sphere.rays([(-3, 0, 0.5)], [(1, 0, 0)])
        >>> round(found.along[0].item(), 9), found.patches.tolist()
        (2.133974596, [0])
        """
    def sections(
        self, other: _Patch, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Sections:
        """Find the curves along which the patch meets another one.

        A curve ends at borders, at poles, where patches that cross touch and where one is folded. Of parts
        that both have in common the borders are given.

        Parameters
        ----------
        other : patch
            A patch of any kind.
        tolerance : float, optional
            The largest distance of a curve from both patches, a length; by default 2^-20 of the size of
            both.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Sections
            The curves, their images in the parameters of both patches, and points where the patches
            touch.

        Raises
        ------
        InvalidShape
            If too many pairs of parts are not apart, as where patches are nearly one, or both run through
            infinity.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Sinha, Klassen and Wang 1985; Sederberg and Meyers 1988; lecture row S18.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> wall = sc.build.plane((-2, -2, 0.5), (4, 0, 0), (0, 4, 0))
        >>> found = sphere.sections(wall, 1e-6)
        >>> abs(found.curves[0].length() - np.pi * 3**0.5) < 1e-5
        True
        """
    def plane_sections(
        self, origin: ArrayLike, normal: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Sections:
        """Find the curves along which the patch meets a plane.

        Images on the plane are in its coordinates, with axes by the rule of DXF files: x and y where the
        normal is z.

        Parameters
        ----------
        origin : array_like
            Point (3,) of the plane.
        normal : array_like
            Vector (3,) at right angles to the plane.
        tolerance : float, optional
            The largest distance of a curve from the patch, a length; by default 2^-20 of its size.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Sections
            The curves, as of `sections`.

        Raises
        ------
        InvalidShape
            If the normal is zero, and as of `sections`.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S18.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> found = sphere.plane_sections((0, 0, 0.5), (0, 0, 1))
        >>> bool(found.closed[0])
        True
        """
    def nearest_all(
        self, point: ArrayLike, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> Nearest:
        """Find all places where the distance from a point is a minimum that is nearly the least one.

        Parameters
        ----------
        point : array_like
            Point (2 or 3,).
        tolerance : float, optional
            By how much the distance may exceed the least one, a length; by default a few roundings.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Nearest
            The places in the order of their parameters (n, 2).

        Raises
        ------
        InvalidShape
            If the point is not finite, or where such places are a curve.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 4, 0))
        >>> plane.nearest_all((1, 2, 3)).parameters.round(9).tolist()
        [[0.25, 0.5]]
        """
    def rebuild(
        self,
        counts: SupportsIndex | tuple[SupportsIndex, SupportsIndex],
        degrees: SupportsIndex | tuple[SupportsIndex, SupportsIndex] | None = None,
        *,
        cancel: _Cancel | None = None,
    ) -> Approximation[NurbsPatch]:
        """Approximate by a polynomial patch with even knots over the same domain.

        It is nearest first along u, then along v. Corners stay; periodic directions stay periodic.

        Parameters
        ----------
        counts : int or a pair of these
            Numbers of control points in u and v, or one for both.
        degrees : int or a pair of these, optional
            Degrees in u and v, or one for both; by default those of the patch.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsPatch
            The new patch, and the largest distance at equal parameters, at most 2 % above the truth.

        Raises
        ------
        InvalidShape
            If a count is below the number that the degree needs.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S17, S20.

        Examples
        --------
        >>> patch, error = sc.build.sphere((0, 0, 0), 1.0).rebuild((12, 9), 3)
        >>> patch.points.shape, patch.is_rational, error < 0.05
        ((12, 9, 3), False, True)
        """
    def fair(
        self, tolerance: float, *,
        ends: Literal["points", "tangents"] | tuple[Literal["points", "tangents"], Literal["points", "tangents"]] = "points",
        cancel: _Cancel | None = None,
    ) -> Approximation[NurbsPatch]:
        """Smooth the patch within a tolerance.

        Knots, weights and borders stay; the energy of a thin plate becomes as small as the tolerance allows.

        Parameters
        ----------
        tolerance : float
            The largest distance at equal parameters, a length above 0.
        ends : {'points', 'tangents'} or a pair of these, default 'points'
            Whether borders stay, or the derivatives across them too; a pair for u and v.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Approximation of NurbsPatch
            The new patch, and the largest distance at equal parameters, at most 2 % above the truth.

        Raises
        ------
        InvalidShape
            Unless the tolerance is positive and a degree is 2 at least.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Greiner 1994; lecture row S17.

        Examples
        --------
        >>> x, y = np.meshgrid(np.arange(5.0), np.arange(5.0), indexing="ij")
        >>> noisy, _ = sc.fit.interpolate_patch(np.stack([x, y, 0.1 * (-1) ** (x + y)], axis=-1))
        >>> smooth, error = noisy.fair(0.05)
        >>> error <= 0.05, bool(np.ptp(smooth.points[1:-1, 1:-1, 2]) < np.ptp(noisy.points[1:-1, 1:-1, 2]))
        (True, True)
        """
    def fundamental_forms(self, u: ArrayLike, v: ArrayLike, *, side: _Sides = "right") -> tuple[_Floats, _Floats]:
        """Evaluate the first and the second fundamental form at pairs of parameters, which broadcast.

        The unit normal points along S_u x S_v; at a pole it is its limit, and the second form is NaN where it
        has none.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u.
        v : array_like
            Parameters in v, as `u`.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.

        Returns
        -------
        tuple (numpy.ndarray, numpy.ndarray)
            Arrays (..., 2, 2) of [[E, F], [F, G]] and [[L, M], [M, N]].

        Raises
        ------
        InvalidShape
            If a form is too large for a number.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0))
        >>> first, second = plane.fundamental_forms(0.5, 0.5)
        >>> first.tolist(), second.tolist()
        ([[4.0, 0.0], [0.0, 1.0]], [[0.0, 0.0], [0.0, 0.0]])
        """
    def curvatures(self, u: ArrayLike, v: ArrayLike, *, side: _Sides = "right") -> Curvatures:
        """Measure the curvatures at pairs of parameters, which broadcast.

        Positive where the patch bends towards its normal. At a pole they are those on which all lines through
        it agree; NaN where they do not, as at the tip of a cone.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in u.
        v : array_like
            Parameters in v, as `u`.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.

        Returns
        -------
        Curvatures
            Gaussian, mean and principal curvatures, and principal directions.

        Raises
        ------
        InvalidShape
            If a curvature is too large for a number.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 2.0)
        >>> round(sphere.curvatures(0.5, 1.0).gauss.item(), 9)
        0.25
        """
    def area(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> float:
        """Measure the area.

        Adaptive quadrature of Gauss and Kronrod on every pair of spans.

        Parameters
        ----------
        tolerance : float, default 1e-12
            The largest relative error; rounding of the coordinates may be more.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        float
            The area, in square units of the points.

        Raises
        ------
        InvalidShape
            If weights differ too much in size.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work; the message names an error that can be had.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> round(sphere.area() / np.pi, 9)
        4.0
        """
    def flux(
        self, field: Callable[[_Floats], ArrayLike], *, tolerance: float = 1e-12, cancel: _Cancel | None = None
    ) -> float:
        """Measure the flux of a vector field through the surface.

        Positive where the field flows to the side of the normals, S_u x S_v of each patch. The surface may be
        open.

        Parameters
        ----------
        field : callable
            A smooth function that takes points (n, 3) and gives vectors (n, 3); it is called with
            thousands of points at once.
        tolerance : float, default 1e-12
            The largest error, relative to the integral of |field · normal|.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        float
            The integral of field · normal.

        Raises
        ------
        InvalidShape
            If values of the field have another shape or are not finite.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work, as where the field jumps.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> round(sphere.flux(lambda points: points) / np.pi, 9)      # three times the volume
        4.0
        """
    def surface_centroid(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> _Floats:
        """Find the centroid of the surface, as of a thin shell.

        Parameters
        ----------
        tolerance : float, default 1e-12
            The largest error, relative to half the diagonal of the box of the points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Point (3,).

        Raises
        ------
        InvalidShape
            If the surface has no area.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> dome = sc.build.sphere((0, 0, 0), 1.0).split("v", 1.0)[1]
        >>> dome.surface_centroid().round(9)[2].item()
        0.5
        """
    def bounding_box(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> _Floats:
        """Find the smallest box along the axes that contains the surface.

        Not that of the control points. Branch and bound on Bezier pieces.

        Parameters
        ----------
        tolerance : float, default 1e-12
            How much too small the box may be, relative to the largest coordinate.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (2, 3) of the lowest and the highest corner.

        Raises
        ------
        InvalidShape
            If the tolerance is not positive.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too many pieces.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S20.

        Examples
        --------
        >>> sc.build.sphere((0, 0, 0), 1.0).bounding_box().round(9).tolist()
        [[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]]
        """
    def isocurve(self, axis: _Axis, at: float) -> NurbsCurve:
        """Extract the curve along which one parameter is constant.

        At a knot it is the value of the patch from there on. A periodic direction takes any parameter.

        Parameters
        ----------
        axis : {'u', 'v'}
            The direction whose parameter is constant.
        at : float
            The parameter.

        Returns
        -------
        NurbsCurve
            The exact curve on the knots of the other direction; a Bezier curve of a Bezier patch.

        Raises
        ------
        InvalidShape
            If `at` is outside the domain, or the whole curve lies at infinity.

        References
        ----------
        The NURBS Book, 3.4; lecture rows S18, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> equator = sphere.isocurve("v", 1.0)
        >>> round(equator.length() / (2 * np.pi), 9)
        1.0
        """
    def boundary(self, side: _Border) -> NurbsCurve:
        """Extract the curve along a side; of a periodic direction its seam.

        Parameters
        ----------
        side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side.

        Returns
        -------
        NurbsCurve
            The exact curve, as of `isocurve`.

        Raises
        ------
        InvalidShape
            If the whole side lies at infinity.

        References
        ----------
        Lecture rows S20, S21.

        Examples
        --------
        >>> plane = sc.build.plane((0, 0, 0), (4, 0, 0), (0, 1, 0))
        >>> plane.boundary("v_end").points.tolist()
        [[0.0, 1.0, 0.0], [4.0, 1.0, 0.0]]
        """
    @property
    def is_closed(self) -> bool:
        """Whether the patch bounds a volume: every side is a pole or lies on another side, as on a sphere or a
        torus.

        Examples
        --------
        >>> ball, tube = sc.build.sphere((0, 0, 0), 1.0), sc.build.extrude(sc.conics.circle((0, 0, 0), 1.0), (0, 0, 1))
        >>> ball.is_closed, tube.is_closed
        (True, False)
        """
    def join(
        self,
        side: _Border,
        other: _Patch,
        other_side: _Border,
        continuity: _PatchSmoothness = "G1",
        moves: Literal["second", "first", "both"] = "second",
        reversed: bool | None = None,
    ) -> JoinedPatches:
        """Bring another patch to a side of this one: `build.join_patches`.

        Parameters
        ----------
        side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side of this patch.
        other : patch
            A patch of any kind.
        other_side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side of the other patch.
        continuity : {'C0', 'G1', 'C1', 'G2', 'C2'}, default 'G1'
            As of `build.join_patches`.
        moves : {'second', 'first', 'both'}, default 'second'
            Which patch moves: the other one is the second.
        reversed : bool, optional
            Whether the other side runs against this one; by default as their ends lie nearer.

        Returns
        -------
        JoinedPatches
            Both patches, and how far each moved.

        Raises
        ------
        InvalidShape
            If a side is one point, lies at infinity or is the seam of a periodic direction, or the join
            is not possible.

        Examples
        --------
        >>> a = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> b = sc.build.plane((1.1, 0, 0), (1, 0, 1), (0, 1, 0))
        >>> joined = a.join("u_end", b, "u_start", "C0")
        >>> joined.first.continuity_to("u_end", joined.second, "u_start").gap
        0.0
        """
    def continuity_to(
        self,
        side: _Border,
        other: _Patch,
        other_side: _Border,
        tolerance: float = 1e-8,
        reversed: bool | None = None,
    ) -> SeamContinuity:
        """Measure the continuity between a side of this patch and one of another, as `seam_continuity` does.

        Parameters
        ----------
        side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side of this patch.
        other : patch
            A patch of any kind.
        other_side : {'u_start', 'u_end', 'v_start', 'v_end'}
            The side of the other patch.
        tolerance : float, default 1e-08
            Angles and relative differences below it count as none.
        reversed : bool, optional
            Whether the second side runs against the first one; by default as their ends lie nearer.

        Returns
        -------
        SeamContinuity
            The continuity.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture rows S16, S21.

        Examples
        --------
        >>> a = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> b = sc.build.plane((1, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> turned = b.rotated(0.5, (0, 1, 0), (1, 0, 0))
        >>> a.continuity_to("u_end", b, "u_start").c, a.continuity_to("u_end", turned, "u_start").g
        (2, 0)
        """
    def dragged(
        self,
        u: float,
        v: float,
        by: ArrayLike,
        tangent_u_by: ArrayLike | None = None,
        tangent_v_by: ArrayLike | None = None,
        *,
        factors: ArrayLike | None = None,
        locality: float = 0.0,
    ) -> HermitePatch:
        """Move the point at a pair of parameters by moving points, tangents and twists as little as possible.

        As `NurbsPatch.dragged`. Tangents are measured at a third of the span, twists at a ninth.

        Parameters
        ----------
        u : float
            The parameter of the point in u.
        v : float
            The parameter of the point in v.
        by : array_like
            Vector (3,) by which the point moves.
        tangent_u_by : array_like, optional
            Vector (3,) added to the derivative along u; zero keeps it, None leaves it free.
        tangent_v_by : array_like, optional
            The same along v.
        factors : array_like, optional
            Factors (4, nu, nv) of points, tangents along u, along v, and twists; 0 holds one.
        locality : float, default 0.0
            The larger it is, the fewer control points follow: factors are multiplied by the influence of
            a point to this power.

        Returns
        -------
        HermitePatch
            The new patch.

        Raises
        ------
        InvalidShape
            If nothing that the point depends on may move, or too little to choose the derivatives.

        Examples
        --------
        >>> flat = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)).to_hermite()
        >>> flat.dragged(0.5, 0.5, (0, 0, 1)).evaluate(0.5, 0.5).round(9).tolist()
        [1.0, 0.5, 1.0]
        """
    def dumps(self) -> str:
        """Write the shape as JSON text.

        Returns
        -------
        str
            Text that `loads` reads back equal in every bit.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> sc.loads(curve.dumps()) == curve
        True
        """
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> HermitePatch: ...
    def __deepcopy__(self, memo: object, /) -> HermitePatch: ...

class _PatchFields(TypedDict, total=False):
    kind: Literal["bezier", "hermite", "nurbs"]
    indices: ArrayLike
    degree: _Pair
    knots: _Knots
    periodic: Sequence[bool]
    parameters: _Knots

@final
class PatchSet:
    """Patches on one pool of control points, which neighbors share.

    Immutable; `len`, indices and loops give the patches.

    Parameters
    ----------
    points : array_like
        Pool of points (n, 2 or 3), in any unit of length.
    patches : sequence of _PatchFields or array_like
        For each patch an array (nu, nv) of rows of the pool (a Bezier patch), or a dict: kind
        ('bezier', 'hermite' or 'nurbs'), indices, and for NURBS the pairs degree, knots and periodic,
        for Hermite the pair parameters and indices (4, nu, nv) of points (w = 1), tangents along u,
        along v and twists (w = 0).
    weights : array_like, optional
        Weights (n,) of the pool, 1 where none are given.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S20.

    Examples
    --------
    >>> pool = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (1, 1, 0), (2, 1, 0)]
    >>> patches = sc.PatchSet(pool, [[[0, 3], [1, 4]], [[1, 4], [2, 5]]])
    >>> len(patches), round(patches.area(), 9)
    (2, 2.0)
    """

    def __init__(
        self,
        points: ArrayLike,
        patches: Sequence[_PatchFields | ArrayLike],
        weights: ArrayLike | None = None,
    ) -> None: ...
    @staticmethod
    def from_patches(patches: Sequence[_Patch], merge: bool = True) -> PatchSet:
        """Make a set of patches.

        Parameters
        ----------
        patches : sequence of patches
            Patches of any kinds.
        merge : bool, default True
            Whether points that are equal in every bit become one.

        Returns
        -------
        PatchSet
            The set.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> a = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> b = sc.build.plane((1, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> sc.PatchSet.from_patches([a, b]).points.shape
        (6, 3)
        """
    @property
    def points(self) -> _Floats:
        """The pool (n, 3) float64, read-only.

        Examples
        --------
        >>> sc.PatchSet.from_patches([sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))]).points.tolist()
        [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]
        """
    @property
    def weights(self) -> _Floats:
        """Weights (n,) float64 of the pool, read-only.

        Examples
        --------
        >>> sc.PatchSet.from_patches([sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))]).weights
        array([1., 1., 1., 1.])
        """
    @property
    def patches(self) -> list[dict[str, Any]]:
        """A dict for each patch, as the constructor takes them.

        Examples
        --------
        >>> ball = sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0)])
        >>> ball.patches[0]["kind"], ball.patches[0]["degree"]
        ('nurbs', (2, 2))
        """
    def with_points(self, points: ArrayLike, weights: ArrayLike | None = None) -> PatchSet:
        """Replace the pool, keep the patches.

        Parameters
        ----------
        points : array_like
            Points (n, 2 or 3).
        weights : array_like, optional
            Weights (n,); kept unless given. A pool of another size needs them.

        Returns
        -------
        PatchSet
            The new set.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.PatchSet.from_patches([sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))])
        >>> round(plane.with_points(2 * plane.points).area(), 9)
        4.0
        """
    def evaluate_grid(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: _Points | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> _Points:
        """Evaluate points of every patch at every pair of parameters.

        Parameters
        ----------
        u : array_like
            Parameters (a,) in the domain of every patch.
        v : array_like
            Parameters (b,) in the domain of every patch.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : numpy.ndarray, optional
            A C-contiguous array of the result's shape to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Points (patches, a, b, 3).

        Raises
        ------
        InvalidShape
            If a parameter lies outside a domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> plane = sc.PatchSet.from_patches([sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))])
        >>> plane.evaluate_grid([0.0, 0.5, 1.0], [0.0, 1.0]).shape
        (1, 3, 2, 3)
        """
    def evaluate_grid_with_normals(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        side: _Sides = "right",
        at_infinity: _AtInfinity = "raise",
        dtype: DTypeLike | None = None,
        out: tuple[_Points, _Points] | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> tuple[_Points, _Points]:
        """Evaluate points and unit normals of every patch at every pair of parameters.

        Parameters
        ----------
        u : array_like
            Parameters (a,) in the domain of every patch.
        v : array_like
            Parameters (b,) in the domain of every patch.
        side : {'left', 'right'} or a pair of these, default 'right'
            At knots, the value from the right or from the left; a pair for u and v.
        at_infinity : {'raise', 'nan'}, default 'raise'
            Where the weight is zero: raise PointAtInfinity, or mark the point with NaN.
        dtype : dtype_like, optional
            float64 or float32.
        out : tuple (numpy.ndarray, numpy.ndarray), optional
            Two C-contiguous arrays (patches, a, b, 3) to write into.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        tuple (numpy.ndarray, numpy.ndarray)
            Points and normals, both (patches, a, b, 3).

        Raises
        ------
        InvalidShape
            If a parameter lies outside a domain by more than 4 ulp.
        PointAtInfinity
            Where the weight is zero, unless `at_infinity` is 'nan'.
        Cancelled
            If `cancel` returned true.

        Examples
        --------
        >>> plane = sc.PatchSet.from_patches([sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))])
        >>> points, normals = plane.evaluate_grid_with_normals([0.5], [0.5])
        >>> points.tolist(), normals.tolist()
        ([[[[0.5, 0.5, 0.0]]]], [[[[0.0, 0.0, 1.0]]]])
        """
    def transformed(self, matrix: ArrayLike) -> PatchSet:
        """Apply a linear, affine or projective map to all points.

        Under a projective map the weights change; a point that goes to infinity gets the weight 0.

        Parameters
        ----------
        matrix : array_like
            Matrix (3, 3), (3, 4) or (4, 4) that is applied to columns.

        Returns
        -------
        PatchSet
            The image of the set.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> plane = sc.PatchSet.from_patches([sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))])
        >>> round(plane.transformed([[2, 0, 0], [0, 3, 0], [0, 0, 1]]).area(), 9)
        6.0
        """
    def translated(self, by: ArrayLike) -> PatchSet:
        """Move the shape by a vector.

        Parameters
        ----------
        by : array_like
            Vector (2 or 3,).

        Returns
        -------
        PatchSet
            The moved shape.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).translated((5, 0, 1)).points.tolist()
        [[5.0, 0.0, 1.0], [6.0, 2.0, 1.0]]
        """
    def rotated(self, angle: float, axis: ArrayLike = (0, 0, 1), about: ArrayLike = (0, 0, 0)) -> PatchSet:
        """Rotate the shape about an axis, counterclockwise as seen from its tip.

        Parameters
        ----------
        angle : float
            Angle in radians.
        axis : array_like, default (0, 0, 1)
            Vector (3,) along the axis; only its direction counts.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) on the axis.

        Returns
        -------
        PatchSet
            The rotated shape.

        Raises
        ------
        InvalidShape
            If the axis is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).rotated(np.pi, about=(1, 0)).points.round(9)[1].tolist()
        [1.0, -2.0, 0.0]
        """
    def scaled(self, factor: ArrayLike, about: ArrayLike = (0, 0, 0)) -> PatchSet:
        """Scale the shape about a point.

        Parameters
        ----------
        factor : array_like
            A number, or one for each coordinate (3,); a negative one mirrors.
        about : array_like, default (0, 0, 0)
            Point (2 or 3,) that stays.

        Returns
        -------
        PatchSet
            The scaled shape.

        Raises
        ------
        InvalidShape
            If a factor is zero.

        Examples
        --------
        >>> sc.BezierCurve([(0, 0), (1, 2)]).scaled((2, -1, 1)).points[1].tolist()
        [2.0, -2.0, 0.0]
        """
    @property
    def is_closed(self) -> bool:
        """Whether no side is free: each is a pole, lies across a closed direction, or lies on another side.

        Examples
        --------
        >>> ball, tube = sc.build.sphere((0, 0, 0), 1.0), sc.build.cylinder((0, 0, 0), (0, 0, 1), 1.0, 2.0)
        >>> [sc.PatchSet.from_patches([patch]).is_closed for patch in (ball, tube)]
        [True, False]
        """
    def join(self, other: _Patch | PatchSet, merge: bool = True) -> PatchSet:
        """Put the patches of another set, or another patch, behind those of the set.

        Parameters
        ----------
        other : patch or PatchSet
            A patch of any kind, or a set.
        merge : bool, default True
            Whether equal control points become one, so that the patches hang together.

        Returns
        -------
        PatchSet
            One set.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> ends = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0)), sc.build.plane((1, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> sc.PatchSet.from_patches(ends[:1]).join(ends[1]).edge_counts()["shared"]
        1
        """
    def oriented(self, *, cancel: _Cancel | None = None) -> PatchSet:
        """Turn patches so that normals agree across common edges, and point outwards where the set is closed.

        A patch that is turned has u and v exchanged, on the same pool of points. Of open patches that hang
        together the first one stays.

        Parameters
        ----------
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        PatchSet
            The same surfaces.

        Raises
        ------
        InvalidShape
            If more than two sides meet at an edge, or the surface has one side only, as a Moebius band;
            the message names the edge.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S20.

        Examples
        --------
        >>> ball = sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0)])
        >>> round(ball.flipped().oriented().volume() / np.pi * 3, 9)
        4.0
        """
    def flipped(self) -> PatchSet:
        """Turn all normals over by exchanging u and v of every patch.

        Returns
        -------
        PatchSet
            The same surfaces.

        Examples
        --------
        >>> ball = sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0)])
        >>> round(ball.flipped().volume() / np.pi * 3, 9)
        -4.0
        """
    def least_distance(
        self, other: _Curve | _Patch | PatchSet, tolerance: float | None = None, *, cancel: _Cancel | None = None
    ) -> LeastDistance:
        """Find where this shape and another one are nearest to each other.

        The global minimum, ends and borders included. Of several places at one distance it is any of them.

        Parameters
        ----------
        other : curve or patch or PatchSet
            A curve or patch of any kind, or a set of patches.
        tolerance : float, optional
            How much nearer they may be elsewhere, a length; by default 2^-33 of the size of both.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        LeastDistance
            The distance, with parameters and points on both shapes, and which patches of sets they are
            on.

        Raises
        ------
        InvalidShape
            If the tolerance is negative, or bent shapes are at one distance all along: give a larger
            tolerance.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Johnson and Cohen 1998; lecture row S18.

        Examples
        --------
        >>> a = sc.BezierCurve([(0, 0), (4, 0)])
        >>> b = sc.BezierCurve([(1, 3), (3, 1)])
        >>> a.least_distance(b).distance
        1.0
        """
    def rays(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        hits: Literal["first", "all"] = "first",
        limits: ArrayLike | None = None,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> RayHits:
        """Find where rays meet the patches.

        As `rays` of a patch, with the number of the patch at each place. Of patches that are met at one place
        the first one counts with 'first'; all do with 'all'.

        Parameters
        ----------
        origins : array_like
            Points (..., 3) where rays start.
        directions : array_like
            Vectors (..., 3); they broadcast with the origins.
        hits : {'first', 'all'}, default 'first'
            The first place of each ray, or all places.
        limits : array_like, optional
            First and last multiple (2,) of the direction, by default 0 and infinity.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        RayHits
            The places.

        Raises
        ------
        InvalidShape
            If a ray is not finite, has no direction, starts too far away, or cannot be decided; the
            message names it.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Kajiya 1982; Nishita, Sederberg and Kakimoto 1990.

        Examples
        --------
        >>> ball = sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0)])
        >>> met = ball.rays((0, 0, -4), (0, 0, 1))
        >>> met.along.round(9).tolist(), met.patches.tolist()
        (3.0, 0)
        """
    def edge_counts(self) -> dict[str, int]:
        """Count how the sides of the patches meet.

        An edge counts once, however many sides lie on it. Two sides are one edge where they are one curve at
        equal scaled parameters, to 1e-10 of the extent of the larger patch, whatever their degrees and knots.
        A pole is a side that is one point.

        Returns
        -------
        dict of str
            Numbers of edges by kind: 'shared', 'free' and 'pole'.

        Examples
        --------
        >>> sphere = sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0)])
        >>> sphere.edge_counts() == {"shared": 1, "free": 0, "pole": 2}
        True
        """
    def seams(self) -> list[tuple[tuple[int, _Border], tuple[int, _Border]]]:
        """List the whole sides that are one edge.

        Returns
        -------
        list of tuple (tuple (int, {'u_start', 'u_end', 'v_start', 'v_end'}), tuple (int, {'u_start', 'u_end', 'v_start', 'v_end'}))
            Pairs of (number of a patch, side).

        Examples
        --------
        >>> a = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> b = sc.build.plane((1, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> sc.PatchSet.from_patches([a, b]).seams()
        [((0, 'u_end'), (1, 'u_start'))]
        """
    def __len__(self) -> int: ...
    def __getitem__(self, i: SupportsIndex) -> _Patch: ...
    def area(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> float:
        """Measure the area.

        Adaptive quadrature of Gauss and Kronrod on every pair of spans.

        Parameters
        ----------
        tolerance : float, default 1e-12
            The largest relative error; rounding of the coordinates may be more.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        float
            The area, in square units of the points.

        Raises
        ------
        InvalidShape
            If weights differ too much in size.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work; the message names an error that can be had.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> round(sphere.area() / np.pi, 9)
        4.0
        """
    def flux(
        self, field: Callable[[_Floats], ArrayLike], *, tolerance: float = 1e-12, cancel: _Cancel | None = None
    ) -> float:
        """Measure the flux of a vector field through the surface.

        Positive where the field flows to the side of the normals, S_u x S_v of each patch. The surface may be
        open.

        Parameters
        ----------
        field : callable
            A smooth function that takes points (n, 3) and gives vectors (n, 3); it is called with
            thousands of points at once.
        tolerance : float, default 1e-12
            The largest error, relative to the integral of |field · normal|.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        float
            The integral of field · normal.

        Raises
        ------
        InvalidShape
            If values of the field have another shape or are not finite.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work, as where the field jumps.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
        >>> round(sphere.flux(lambda points: points) / np.pi, 9)      # three times the volume
        4.0
        """
    def surface_centroid(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> _Floats:
        """Find the centroid of the surface, as of a thin shell.

        Parameters
        ----------
        tolerance : float, default 1e-12
            The largest error, relative to half the diagonal of the box of the points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Point (3,).

        Raises
        ------
        InvalidShape
            If the surface has no area.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> dome = sc.build.sphere((0, 0, 0), 1.0).split("v", 1.0)[1]
        >>> dome.surface_centroid().round(9)[2].item()
        0.5
        """
    def bounding_box(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> _Floats:
        """Find the smallest box along the axes that contains the surface.

        Not that of the control points. Branch and bound on Bezier pieces.

        Parameters
        ----------
        tolerance : float, default 1e-12
            How much too small the box may be, relative to the largest coordinate.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Array (2, 3) of the lowest and the highest corner.

        Raises
        ------
        InvalidShape
            If the tolerance is not positive.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too many pieces.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture row S20.

        Examples
        --------
        >>> sc.build.sphere((0, 0, 0), 1.0).bounding_box().round(9).tolist()
        [[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]]
        """
    def volume(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> float:
        """Measure the volume that the patches enclose.

        By Gauss's theorem and adaptive quadrature. Sides meet on equal points; a side that is a pole or
        crosses a periodic direction is closed.

        Parameters
        ----------
        tolerance : float, default 1e-12
            The largest relative error; rounding of the coordinates may be more.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        float
            The volume, in cubic units of the points; negative if the normals point inwards.

        Raises
        ------
        InvalidShape
            If a side meets no other, or normals point to the other side beyond it; the message names it.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> ball = sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0)])
        >>> round(ball.volume() / np.pi * 3, 9)
        4.0
        """
    def centroid(self, *, tolerance: float = 1e-12, cancel: _Cancel | None = None) -> _Floats:
        """Find the centroid of the solid that the patches enclose.

        Parameters
        ----------
        tolerance : float, default 1e-12
            The largest error, relative to half the diagonal of the box of the points.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            Point (3,).

        Raises
        ------
        InvalidShape
            If the volume is zero, and as of `volume`.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> ball = sc.PatchSet.from_patches([sc.build.sphere((1, 2, 3), 1.0)])
        >>> ball.centroid().round(9)
        array([1., 2., 3.])
        """
    def second_moments(self, about: ArrayLike | None = None, *, tolerance: float = 1e-12,
                       cancel: _Cancel | None = None) -> _Floats:
        """Integrate d d^T over the solid that the patches enclose, where d is the vector from a point.

        The inertia tensor at density 1 is trace(m) * eye(3) - m. All are negative if the normals point
        inwards.

        Parameters
        ----------
        about : array_like, optional
            Point (3,); by default the centroid.
        tolerance : float, default 1e-12
            The largest error, relative to the trace about the centroid.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        numpy.ndarray
            A symmetric matrix (3, 3), in units of length to the fifth power.

        Raises
        ------
        InvalidShape
            If a moment is too large for a number, and as of `centroid`.
        PointAtInfinity
            If a patch runs to infinity.
        ToleranceNotReached
            If the tolerance takes too much work.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Lecture rows S19, S20.

        Examples
        --------
        >>> ball = sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0)])
        >>> inertia = np.trace(ball.second_moments()) * np.eye(3) - ball.second_moments()
        >>> round(float(inertia[2, 2]) / ball.volume(), 9)      # 2/5 m r²
        0.4
        """
    def dragged(
        self,
        patch: SupportsIndex,
        u: float,
        v: float,
        by: ArrayLike,
        tangent_u_by: ArrayLike | None = None,
        tangent_v_by: ArrayLike | None = None,
        *,
        factors: ArrayLike | None = None,
        locality: float = 0.0,
    ) -> PatchSet:
        """Move the point of a patch by moving the pool as little as possible.

        As `NurbsPatch.dragged`. Shared points move once and neighbors follow, as do points that lie in one
        place. A tangent or twist that serves several corners stays.

        Parameters
        ----------
        patch : int
            Number of the patch.
        u : float
            The parameter of the point in u.
        v : float
            The parameter of the point in v.
        by : array_like
            Vector (3,) by which the point moves.
        tangent_u_by : array_like, optional
            Vector (3,) added to the derivative along u; zero keeps it, None leaves it free.
        tangent_v_by : array_like, optional
            The same along v.
        factors : array_like, optional
            Factors (n,) of how easily each point of the pool moves; 0 holds it.
        locality : float, default 0.0
            The larger it is, the fewer control points follow: factors are multiplied by the influence of
            a point to this power.

        Returns
        -------
        PatchSet
            The new set.

        Raises
        ------
        InvalidShape
            If nothing that the point depends on may move, or too little to choose the derivatives.

        Examples
        --------
        >>> plane = sc.PatchSet.from_patches([sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))])
        >>> plane.dragged(0, 0.5, 0.5, (0, 0, 2)).evaluate_grid([0.5], [0.5]).round(9).tolist()
        [[[[0.5, 0.5, 2.0]]]]
        """
    def dumps(self) -> str:
        """Write the shape as JSON text.

        Returns
        -------
        str
            Text that `loads` reads back equal in every bit.

        Examples
        --------
        >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
        >>> sc.loads(curve.dumps()) == curve
        True
        """
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> PatchSet: ...
    def __deepcopy__(self, memo: object, /) -> PatchSet: ...

@final
class Tessellation:
    """The mesh of a patch set: everything but positions, made once and evaluated for any position of the
    points.

    Vertices are shared along common edges, a pole is one vertex, faces are wound along S_u x S_v.

    Parameters
    ----------
    patch_set : PatchSet
        A set of patches.
    resolution : int or a pair of these
        Faces in every span, for u and v or one for both.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S22.

    Examples
    --------
    >>> ball = sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0)])
    >>> mesh = sc.Tessellation(ball, 4)
    >>> positions, normals = mesh.evaluate(ball)
    >>> positions.shape == (mesh.vertex_count, 3)
    True
    """

    def __init__(self, patch_set: PatchSet, resolution: SupportsIndex | tuple[SupportsIndex, SupportsIndex]) -> None: ...
    @staticmethod
    def adaptive(
        patch_set: PatchSet,
        *,
        tolerance: float | None = None,
        angle: float | None = None,
        smallest: float = 0.0,
        threads: SupportsIndex = 0,
        cancel: _Cancel | None = None,
    ) -> Tessellation:
        """Make a mesh with as many faces as the shape needs, without cracks along common edges.

        Parameters
        ----------
        patch_set : PatchSet
            A set of patches.
        tolerance : float, optional
            A length: no point of the surface lies farther from the mesh. None for any.
        angle : float, optional
            Radians: normals on one face are no farther apart. None for any.
        smallest : float, default 0.0
            A length: faces that are shorter in a direction are not cut for the angle, as beside poles and
            around sharp bends.
        threads : int, default 0
            How many threads; 0 takes all cores where that is worth it. The result is the same in every
            bit.
        cancel : callable, optional
            A function without arguments that is called now and then; a true result ends the call.

        Returns
        -------
        Tessellation
            The mesh.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        PointAtInfinity
            If a patch runs to infinity.
        Cancelled
            If `cancel` returned true.

        References
        ----------
        Filip, Magedson and Markot 1986; lecture row S22.

        Examples
        --------
        >>> ball = sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0)])
        >>> fine = sc.Tessellation.adaptive(ball, tolerance=1e-3)
        >>> coarse = sc.Tessellation.adaptive(ball, tolerance=1e-1)
        >>> coarse.vertex_count < fine.vertex_count
        True
        """
    @property
    def vertex_count(self) -> int:
        """Number of vertices.

        Examples
        --------
        >>> ball = sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0)])
        >>> sc.Tessellation(ball, 4).vertex_count
        114
        """
    @property
    def face_starts(self) -> NDArray[np.int32]:
        """Where the corners of each face start: (f,) int32, read-only.

        Examples
        --------
        >>> plane = sc.PatchSet.from_patches([sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))])
        >>> sc.Tessellation(plane, (2, 1)).face_starts.tolist()
        [0, 4]
        """
    @property
    def face_patches(self) -> NDArray[np.int32]:
        """The patch of each face: (f,) int32, read-only.

        Examples
        --------
        >>> plane = sc.PatchSet.from_patches([sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))])
        >>> sc.Tessellation(plane, (2, 1)).face_patches.tolist()
        [0, 0]
        """
    @property
    def corner_vertices(self) -> NDArray[np.int32]:
        """The vertex of each corner: (c,) int32, read-only.

        Examples
        --------
        >>> plane = sc.PatchSet.from_patches([sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))])
        >>> mesh = sc.Tessellation(plane, 1)
        >>> mesh.evaluate_positions(plane)[mesh.corner_vertices].tolist()
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]
        """
    @property
    def corner_uvs(self) -> NDArray[np.float32]:
        """Parameters of each corner, scaled to [0, 1]: (c, 2) float32, read-only.

        Examples
        --------
        >>> plane = sc.PatchSet.from_patches([sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))])
        >>> sc.Tessellation(plane, 1).corner_uvs.tolist()
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
        """
    def fits(self, patch_set: PatchSet, before: PatchSet | None = None) -> bool:
        """Tell whether a set has the same patches, and the same sides lie on one another or are points.

        Parameters
        ----------
        patch_set : PatchSet
            A set of patches.
        before : PatchSet, optional
            A set that fits, with the same patches: only changes from it are looked at.

        Returns
        -------
        bool
            Whether it fits.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> ball = sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0)])
        >>> mesh = sc.Tessellation(ball, 4)
        >>> plane = sc.PatchSet.from_patches([sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))])
        >>> mesh.fits(ball.scaled(2.0)), mesh.fits(plane)
        (True, False)
        """
    def evaluate(self, patch_set: PatchSet) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Compute positions and normals for a set with the same patches.

        Whether its sides still lie on one another, `fits` tells.

        Parameters
        ----------
        patch_set : PatchSet
            A set of patches.

        Returns
        -------
        tuple (numpy.ndarray, numpy.ndarray)
            Positions (vertex_count, 3) and corner normals (c, 3), both float32.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        PointAtInfinity
            If a vertex lies at infinity.

        Examples
        --------
        >>> ball = sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0)])
        >>> mesh = sc.Tessellation(ball, 4)
        >>> positions, normals = mesh.evaluate(ball)
        >>> bool(np.allclose(np.linalg.norm(positions, axis=1), 1)), len(normals) == len(mesh.corner_vertices)
        (True, True)
        """
    def evaluate_positions(self, patch_set: PatchSet, *, before: PatchSet | None = None,
                           out: NDArray[np.float32] | None = None) -> NDArray[np.float32]:
        """Compute positions alone for a set with the same patches.

        Parameters
        ----------
        patch_set : PatchSet
            A set of patches.
        before : PatchSet, optional
            The set whose positions `out` has: only what differs is computed, with the same result in
            every bit.
        out : numpy.ndarray, optional
            A float32 array (vertex_count, 3) to write into; after an error its values are undefined.

        Returns
        -------
        numpy.ndarray
            Positions (vertex_count, 3) float32.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.
        PointAtInfinity
            If a vertex lies at infinity.

        Examples
        --------
        >>> ball = sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0)])
        >>> mesh = sc.Tessellation(ball, 4)
        >>> larger = mesh.evaluate_positions(ball.scaled(2.0))
        >>> bool(np.allclose(np.linalg.norm(larger, axis=1), 2))
        True
        """
    def sharp_edges(self, normals: ArrayLike, angle: float) -> NDArray[np.int32]:
        """List the edges across which corner normals differ.

        Parameters
        ----------
        normals : array_like
            Corner normals (c, 3), as of `evaluate`.
        angle : float
            Radians: edges with a larger difference are sharp.

        Returns
        -------
        numpy.ndarray
            Pairs of vertices (k, 2) int32.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> floor = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
        >>> wall = sc.build.plane((0, 0, 0), (0, 1, 0), (0, 0, 1))
        >>> corner = sc.PatchSet.from_patches([floor, wall])
        >>> mesh = sc.Tessellation(corner, 1)
        >>> mesh.sharp_edges(mesh.evaluate(corner)[1], angle=0.5).shape
        (1, 2)
        """
    def __copy__(self) -> Tessellation: ...
    def __deepcopy__(self, memo: object, /) -> Tessellation: ...

_AtUndefined = Literal["raise", "nan"]

@final
class Formula:
    """An expression of real variables, read from text; nothing in it is ever run.

    Numbers, + - * / ^, parentheses, pi, e and constants; sin cos tan asin acos atan sinh cosh tanh asinh
    acosh atanh exp log ln log2 log10 sqrt cbrt abs sign floor, and atan2(y, x), min, max of two. -t^2 is
    -(t^2), 2^3^2 is 2^9, log is the natural logarithm, and a * is never left out.

    Parameters
    ----------
    text : str
        The expression, at most 10,000 characters.
    variables : sequence of strings, optional
        Names of the variables.
    constants : Mapping of str, optional
        Names and values of constants.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.
    FormulaError
        If the text is not a formula; it has the position.

    References
    ----------
    Lecture row S1.

    Examples
    --------
    >>> sc.Formula("a * sin(t)", constants={"a": 2}).evaluate([0.0, np.pi / 2])
    array([0., 2.])
    """

    def __init__(
        self, text: str, variables: Sequence[str] = ("t",), constants: Mapping[str, float] | None = None
    ) -> None: ...
    @property
    def text(self) -> str:
        """The text.

        Examples
        --------
        >>> sc.Formula("a * sin(t)", constants={"a": 2}).text
        'a * sin(t)'
        """
    @property
    def variables(self) -> tuple[str, ...]:
        """Names of the variables, in the order of their values.

        Examples
        --------
        >>> sc.Formula("x^2 + y", ("x", "y")).variables
        ('x', 'y')
        """
    @property
    def constants(self) -> dict[str, float]:
        """A new dict of the names and values that were given.

        Examples
        --------
        >>> sc.Formula("a * sin(t)", constants={"a": 2}).constants
        {'a': 2.0}
        """
    def evaluate(self, *values: ArrayLike, at_undefined: _AtUndefined = "raise") -> _Floats:
        """Evaluate the expression.

        Parameters
        ----------
        *values : array_like
            An array for each variable; they broadcast.
        at_undefined : {'raise', 'nan'}, default 'raise'
            Where there is no finite value: raise InvalidShape with the place, or give NaN.

        Returns
        -------
        numpy.ndarray
            Values (...,).

        Raises
        ------
        InvalidShape
            Where an operation has no finite result, unless `at_undefined` is 'nan'.

        Examples
        --------
        >>> sc.Formula("x^2 + y", ("x", "y")).evaluate([1.0, 2.0], 3.0)
        array([4., 7.])
        """
    def derivatives(self, t: ArrayLike, order: SupportsIndex, *, at_undefined: _AtUndefined = "raise") -> _Floats:
        """Evaluate the expression and its derivatives by its one variable.

        Parameters
        ----------
        t : array_like
            Values (...,) of the variable.
        order : int
            Highest order of derivatives, 0 or more.
        at_undefined : {'raise', 'nan'}, default 'raise'
            Where there is no finite value: raise InvalidShape with the place, or give NaN.

        Returns
        -------
        numpy.ndarray
            Array (..., order + 1).

        Raises
        ------
        InvalidShape
            Where a derivative does not exist, as of abs(t) at 0, unless `at_undefined` is 'nan'.

        References
        ----------
        Griewank and Walther, Evaluating Derivatives, chapter 13.

        Examples
        --------
        >>> sc.Formula("t^3").derivatives(2.0, 2)
        array([ 8., 12., 12.])
        """
    def gradient(self, *values: ArrayLike, at_undefined: _AtUndefined = "raise") -> _Floats:
        """Evaluate the first derivative by each variable.

        Parameters
        ----------
        *values : array_like
            An array for each variable; they broadcast.
        at_undefined : {'raise', 'nan'}, default 'raise'
            Where there is no finite value: raise InvalidShape with the place, or give NaN.

        Returns
        -------
        numpy.ndarray
            Array (..., variables).

        Raises
        ------
        InvalidShape
            Where a derivative does not exist, unless `at_undefined` is 'nan'.

        Examples
        --------
        >>> sc.Formula("x^2 + y", ("x", "y")).gradient(3.0, 1.0)
        array([6., 1.])
        """
    def polynomial(self) -> _Floats | None:
        """Coefficients of the expression as a polynomial of its one variable.

        Returns
        -------
        numpy.ndarray or None
            Coefficients (degree + 1,), lowest power first; None where the expression has anything but
            sums, products, quotients by constants and whole powers, or the degree is above 255.

        Examples
        --------
        >>> sc.Formula("(t + 1)^2").polynomial()
        array([1., 2., 1.])
        """
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Formula: ...
    def __deepcopy__(self, memo: object, /) -> Formula: ...

_Value = (
    NurbsCurve | BezierCurve | HermiteCurve | PowerCurve | NurbsPatch | BezierPatch | HermitePatch | PatchSet | Region
)

def dumps(value: _Value | Sequence[_Value]) -> str:
    """Write shapes as JSON text.

    Parameters
    ----------
    value : NurbsCurve or BezierCurve or HermiteCurve or PowerCurve or NurbsPatch or BezierPatch or HermitePatch or PatchSet or Region or sequence of NurbsCurve or BezierCurve or HermiteCurve or PowerCurve or NurbsPatch or BezierPatch or HermitePatch or PatchSet or Region
        A curve, a patch, a set, a region, or a list of them.

    Returns
    -------
    str
        Text that `loads` reads back equal in every bit.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    Examples
    --------
    >>> curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
    >>> sc.loads(sc.dumps(curve)) == curve
    True
    """
def loads(text: str | bytes) -> _Value | list[_Value]:
    """Read the JSON text that `dumps` wrote.

    Parameters
    ----------
    text : str or bytes
        The text.

    Returns
    -------
    NurbsCurve or BezierCurve or HermiteCurve or PowerCurve or NurbsPatch or BezierPatch or HermitePatch or PatchSet or Region or list of NurbsCurve or BezierCurve or HermiteCurve or PowerCurve or NurbsPatch or BezierPatch or HermitePatch or PatchSet or Region
        A shape, or a list of shapes.

    Raises
    ------
    InvalidShape
        If the text is damaged, of another format or of a newer version, or holds an invalid shape;
        the message has the place.

    Examples
    --------
    >>> a, b = sc.loads(sc.dumps([sc.BezierCurve([(0, 0), (1, 2)]), sc.conics.circle((0, 0, 0), 1.0)]))
    >>> a, b.periodic
    (BezierCurve(degree=1), False)
    """
def nearest(
    shapes: Sequence[_Curve] | Sequence[_Patch],
    points: ArrayLike,
    *,
    threads: SupportsIndex = 0,
    cancel: _Cancel | None = None,
) -> NearestAmong:
    """Find the nearest point of several curves, or of several patches, to each of several points.

    The global minimum over all of them. Of several shapes at one distance, up to rounding of the size of
    them all, the first is taken. It is much faster than `nearest` of each: few of them are searched.
    Shapes that lie wholly at infinity do not count.

    Parameters
    ----------
    shapes : sequence of curves or sequence of patches
        A list of curves of any kinds, or of patches of any kinds.
    points : array_like
        Points (..., 2 or 3).
    threads : int, default 0
        How many threads; 0 takes all cores where that is worth it. The result is the same in every
        bit.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    NearestAmong
        Numbers of the shapes, parameters, points and distances.

    Raises
    ------
    InvalidShape
        If there is no shape, curves and patches are mixed, a point is not finite, or more than 2^18
        parts may hold the nearest point.
    PointAtInfinity
        If all shapes lie at infinity.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Johnson and Cohen 1998; lecture rows S15, S20.

    Examples
    --------
    >>> left = sc.BezierCurve([(0, 0), (0, 4)])
    >>> right = sc.BezierCurve([(3, 0), (3, 4)])
    >>> found = sc.nearest([left, right], [(1, 2), (5, 1)])
    >>> found.shapes, found.parameters, found.distances
    (array([0, 1]), array([0.5 , 0.25]), array([1., 2.]))
    """
def seam_continuity(
    first: _Patch,
    first_side: _Border,
    second: _Patch,
    second_side: _Border,
    *,
    tolerance: float = 1e-8,
    parameters: ArrayLike | None = None,
    reversed: bool | None = None,
) -> SeamContinuity:
    """Measure the continuity of two patches across a side of each.

    Places of both are those equally far along the parameters of their sides. They are close in every
    span, on both sides of each knot, and closer where gap, angle or the difference of curvatures are
    largest: the results are the largest found, not bounds.

    Parameters
    ----------
    first : patch
        A patch of any kind.
    first_side : {'u_start', 'u_end', 'v_start', 'v_end'}
        The side of the first patch.
    second : patch
        A patch of any kind.
    second_side : {'u_start', 'u_end', 'v_start', 'v_end'}
        The side of the second patch.
    tolerance : float, default 1e-08
        Angles and relative differences below it count as none.
    parameters : array_like, optional
        Parameters (n,) in [0, 1] along the first side; by default they are chosen.
    reversed : bool, optional
        Whether the second side runs against the first one; by default as their ends lie nearer.

    Returns
    -------
    SeamContinuity
        Gap, angle, difference of curvatures and what follows from them.

    Raises
    ------
    InvalidShape
        If a side lies at infinity or is the seam of a periodic direction.

    References
    ----------
    Pegna and Wolter 1992; lecture rows S16, S21.

    Examples
    --------
    >>> a = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
    >>> b = sc.build.plane((1, 0, 0), (1, 0, 0), (0, 1, 0))
    >>> seam = sc.seam_continuity(a, "u_end", b, "u_start")
    >>> seam.gap, seam.g
    (0.0, 2)
    """
