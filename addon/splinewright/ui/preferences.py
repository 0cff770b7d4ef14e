"""The add-on's preferences. They work without the native library, to say what is wrong with it."""

import textwrap

import bpy

from ..core import library


class SplinewrightPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__.rpartition('.')[0]

    def draw(self, context):
        layout = self.layout
        if not library.problem:
            layout.label(text=f"Native library splinecore {library.sc.__version__} is loaded", icon='CHECKMARK')
            return
        column = layout.column(align=True)
        column.alert = True
        for i, line in enumerate(textwrap.wrap(library.problem, 90)):
            column.label(text=line, icon='ERROR' if i == 0 else 'BLANK1')
