"""The add-on's preferences. They work without the native library, to say what is wrong with it."""

import bpy

from ..core import library
from . import texts


class SplinewrightPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__.rpartition('.')[0]

    def draw(self, context):
        layout = self.layout
        if not library.problem:
            layout.label(text=f"Native library splinecore {library.sc.__version__} is loaded", icon='CHECKMARK')
            return
        texts.draw_problem(layout, library.problem, width=90)
