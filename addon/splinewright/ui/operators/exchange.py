"""Import and export: BPT patch files and exact JSON."""

from pathlib import Path

import bpy
from bpy.props import BoolProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

from ...bridge import blocks, shape
from ...core import bpt
from ...core.definition import ANY_CURVES
from ...core.failures import FAILURES, Refusal, sentence
from ...core.library import sc
from .. import progress
from . import new_shapes
from .adding import can_add

#: Steps in every span of what is imported, where the preferences say nothing.
_RESOLUTION = 10


def _path(operator):
    return Path(bpy.path.abspath(operator.filepath))


def _printable(text):
    """Names of files may hold bytes that are no text."""
    return str(text).encode('utf-8', 'replace').decode('utf-8')


def _text_of(path):
    """What a file says. Raises Refusal where it is no text, OSError where it cannot be read."""
    try:
        return path.read_text(encoding='utf-8-sig')
    except UnicodeDecodeError as error:
        raise Refusal("it is no text file") from error


def _start(value):
    return new_shapes.start_unasked(not isinstance(value, (*ANY_CURVES, list)), _RESOLUTION)


class _Import(ImportHelper):
    """Adds the shapes of a file where their coordinates say, at the origin of the world."""

    bl_options = {'REGISTER', 'UNDO'}

    @classmethod
    def poll(cls, context):
        return can_add(cls, context)

    def values(self, text):
        """The value of each object that the text of a file makes."""
        raise NotImplementedError

    def execute(self, context):
        path = _path(self)
        name = _printable(path.stem)
        made = []
        try:
            values = self.values(_text_of(path))
            with progress.shown(context, len(values)) as step:
                for value in values:
                    made.append(shape.new_data(name, value, _start(value)))
                    step(len(made))
        except FAILURES as error:
            for data in made:
                blocks.remove(data)
            self.report({'ERROR'}, f"{_printable(path.name)}: {_printable(sentence(error))}")
            return {'CANCELLED'}
        self._link(context, name, made)
        self.report({'INFO'}, f"Imported {name}")
        return {'FINISHED'}

    @staticmethod
    def _link(context, name, made):
        for ob in context.selected_objects:
            ob.select_set(False)
        for data in made:
            ob = bpy.data.objects.new(name, data)
            context.collection.objects.link(ob)
            ob.select_set(True)
            context.view_layer.objects.active = ob


class _Export(ExportHelper):
    bl_options = {'REGISTER'}

    @classmethod
    def poll(cls, context):
        if not shape.has_shape(context.object):
            cls.poll_message_set("Select a Splinewright shape")
            return False
        return True

    def text(self, value):
        """What is written of the active shape."""
        raise NotImplementedError

    def execute(self, context):
        path = _path(self)
        if not self.filepath or path.is_dir():
            self.report({'ERROR'}, "Name a file to write to")
            return {'CANCELLED'}
        # A file that is there stays whole until the new one is.
        partial = path.with_name(path.name + ".part")
        try:
            partial.write_text(self.text(shape.value_of(context.object.data)), encoding='utf-8')
            partial.replace(path)
        except FAILURES as error:
            if partial.is_file():
                partial.unlink()
            self.report({'ERROR'}, f"{context.object.name}: {_printable(sentence(error))}")
            return {'CANCELLED'}
        self.report({'INFO'}, f"Exported {_printable(path.name)}")
        return {'FINISHED'}


class _Bpt:
    filename_ext = ".bpt"
    filter_glob: StringProperty(default="*.bpt", options={'HIDDEN'})
    flip: BoolProperty(name="Flip", description="Exchange u and v of every patch, which turns the normals over")


class _Json:
    filename_ext = ".json"
    filter_glob: StringProperty(default="*.json", options={'HIDDEN'})


class SPLINEWRIGHT_OT_import_bpt(_Bpt, _Import, bpy.types.Operator):
    bl_idname = "splinewright.import_bpt"
    bl_label = "Import BPT"
    bl_description = "Import a file of Bezier patches as one object; equal points become one"

    def values(self, text):
        return [bpt.loads(text, self.flip)]


class SPLINEWRIGHT_OT_export_bpt(_Bpt, _Export, bpy.types.Operator):
    bl_idname = "splinewright.export_bpt"
    bl_label = "Export BPT"
    bl_description = "Export the patches of the active shape as Bezier patches, exactly"

    def text(self, value):
        if isinstance(value, (*ANY_CURVES, list)):
            raise Refusal("BPT holds patches, this is a curve")
        if self.flip:
            value = value.flipped() if isinstance(value, sc.PatchSet) else value.swapped()
        return bpt.dumps(value)


class SPLINEWRIGHT_OT_import_json(_Json, _Import, bpy.types.Operator):
    bl_idname = "splinewright.import_json"
    bl_label = "Import Exact JSON"
    bl_description = "Import curves and patches with every digit; all curves of a list become one object"

    def values(self, text):
        value = sc.loads(text)
        if not isinstance(value, list):
            return [value]
        curves = [item for item in value if isinstance(item, ANY_CURVES)]
        patches = [item for item in value if not isinstance(item, ANY_CURVES)]
        if not value:
            raise Refusal("the file holds an empty list")
        return ([curves] if curves else []) + patches


class SPLINEWRIGHT_OT_export_json(_Json, _Export, bpy.types.Operator):
    bl_idname = "splinewright.export_json"
    bl_label = "Export Exact JSON"
    bl_description = "Export the definition of the active shape with every digit"

    def text(self, value):
        return sc.dumps(value)


CLASSES = (SPLINEWRIGHT_OT_import_bpt, SPLINEWRIGHT_OT_export_bpt,
           SPLINEWRIGHT_OT_import_json, SPLINEWRIGHT_OT_export_json)

if hasattr(bpy.types, 'FileHandler'):
    class SPLINEWRIGHT_FH_bpt(bpy.types.FileHandler):
        bl_idname = "SPLINEWRIGHT_FH_bpt"
        bl_label = "Bezier Patches"
        bl_import_operator = "splinewright.import_bpt"
        bl_export_operator = "splinewright.export_bpt"
        bl_file_extensions = ".bpt"

        @classmethod
        def poll_drop(cls, context):
            return context.area and context.area.type == 'VIEW_3D'

    CLASSES += (SPLINEWRIGHT_FH_bpt,)
