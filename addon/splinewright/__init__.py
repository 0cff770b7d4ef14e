"""Splinewright: exact NURBS, Bezier and Hermite curves and patches in Blender."""

bl_info = {
    "name": "Splinewright",
    "author": "The Splinewright developers",
    "version": (0, 0, 0),
    "blender": (3, 4, 0),
    "location": "View3D > Add > Curve, Surface; Sidebar > NURBS",
    "description": "Exact NURBS, Bezier and Hermite curves and patches",
    "category": "Add Curve",
}

# make_zip.py writes the version here and above.
__version__ = "0.0.0"


def register():
    from . import ui
    ui.register()


def unregister():
    from . import ui
    ui.unregister()
