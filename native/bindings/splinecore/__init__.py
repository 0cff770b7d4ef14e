"""Exact NURBS, Bezier and Hermite curves and patches on a native library.

    import splinecore as sc
    curve = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
    curve.evaluate([0.0, 0.5, 1.0])      # three points of the unit circle

Values are immutable; arrays go in as any real numbers and come out as float64.
"""

from . import _splinecore, _svg
from ._splinecore import (
    Approximation,
    BezierCurve,
    BezierPatch,
    Cancelled,
    Continuity,
    Curvatures,
    Error,
    Filling,
    Formula,
    FormulaError,
    HermiteCurve,
    HermitePatch,
    Intersections,
    InvalidShape,
    JoinedPatches,
    LeastDistance,
    LoftSurface,
    Nearest,
    NearestAmong,
    NetworkSurface,
    NurbsCurve,
    NurbsPatch,
    PatchIntersections,
    PatchSet,
    PointAtInfinity,
    PowerCurve,
    RayHits,
    Region,
    RoundedEdge,
    SeamContinuity,
    Sections,
    StationaryPoints,
    SubdivisionPatches,
    Tessellation,
    ToleranceNotReached,
    __instruction_set__,
    __version__,
    dumps,
    loads,
    nearest,
    seam_continuity,
)
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

# So that pickles, errors and help name the package and not the file below it.
for _name in __all__:
    if _name not in ("basis", "bpt", "build", "conics", "fit", "meshes", "plot"):
        globals()[_name].__module__ = __name__
del _name

# What notebooks show.
NurbsCurve._repr_svg_ = BezierCurve._repr_svg_ = HermiteCurve._repr_svg_ = PowerCurve._repr_svg_ = _svg.curve
NurbsPatch._repr_svg_ = BezierPatch._repr_svg_ = HermitePatch._repr_svg_ = PatchSet._repr_svg_ = _svg.surface
Region._repr_svg_ = _svg.region
