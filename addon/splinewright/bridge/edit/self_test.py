"""Whether this Blender and the library agree, in numbers that one can send to others."""

import platform
import sys

import bpy
import numpy as np

from ... import __version__
from ...core.base import self_test
from ...core.base.library import sc
from ...core.base.self_test import Check
from ..data import versions
from ..native import write_native

#: Blender keeps single precision, and adds up parameters of surfaces step by step.
_CURVE_TOLERANCE = 2e-5
_SURFACE_TOLERANCE = 1e-4


def machine():
    """Lines on what this runs on."""
    return [f"Splinewright {__version__}, splinecore {sc.__version__} ({sc.__instruction_set__})",
            f"Blender {versions.name()}, Python {platform.python_version()}, NumPy {np.__version__}",
            f"{platform.system()} {platform.release()}, {platform.machine()}, {sys.byteorder} endian"]


def checks(context):
    """Each Check, as it is done. Nothing of the open file is changed."""
    yield from self_test.checks()
    yield _curves()
    if context.mode == 'OBJECT':
        yield _surfaces(context)


#: How many checks there are.
COUNT = 5


def _curves():
    worst = 0.0
    for curve in self_test.curves():
        data = bpy.data.curves.new("self-test", 'CURVE')
        try:
            deviation = write_native.write_curves(data, write_native.plan(curve), 12)
        finally:
            bpy.data.curves.remove(data)
        worst = _worse(worst, deviation)
    return _against_blender("Blender's own NURBS curves", worst, _CURVE_TOLERANCE)


def _surfaces(context):
    worst = 0.0
    for patch in self_test.patches():
        data, deviation = write_native.new_surface(context, "self-test", write_native.plan(patch), (4, 4))
        bpy.data.curves.remove(data)
        worst = _worse(worst, deviation / np.abs(patch.points).max())
    return _against_blender("Blender's own NURBS surfaces", worst, _SURFACE_TOLERANCE)


def _worse(worst, deviation):
    return float('inf') if deviation is None else max(worst, deviation)


def _against_blender(name, worst, tolerance):
    return Check(name, f"up to {worst:.1e} of the size away (Blender's own rounding: {tolerance:.0e})", worst <= tolerance)
