"""Import and export: BPT patch files and exact JSON."""

import re
from pathlib import Path

import bpy
import numpy as np
from bpy.props import BoolProperty, CollectionProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

from ...bridge.data import blocks, store, versions
from ...bridge.shape import shape
from ...core.base import whole_files
from ...core.base.failures import FAILURES, Refusal, sentence
from ...core.base.library import sc
from ...core.base.words import phrase, say
from ...core.shape import definition as definitions
from ...core.shape import transform
from ...core.shape.definition import ANY_CURVES
from .. import progress
from . import new_shapes, reports
from .adding import can_add, resolution_property


def path_of(operator):
    return Path(bpy.path.abspath(operator.filepath))


def path_property():
    """In place of those of Blender's helpers, which presets would hold: its file browser shows hidden ones again."""
    return StringProperty(name="File Path", maxlen=1024, subtype='FILE_PATH',
                          options={'HIDDEN', 'SKIP_PRESET' if versions.has_skip_preset else 'SKIP_SAVE'})


def printable(text):
    """Names of files may hold bytes that are no text."""
    return str(text).encode('utf-8', 'replace').decode('utf-8')


def _text_of(path):
    """The text of a file. Raises Refusal where it holds something else, OSError where it cannot be read."""
    try:
        return path.read_text(encoding='utf-8-sig')
    except UnicodeDecodeError as error:
        raise Refusal("it is not a text file") from error


def _start_of(path):
    """The first part of a file, as far as it is text. Raises OSError where it cannot be read."""
    with path.open('rb') as file:
        return file.read(_LOOKED_AT).decode('utf-8-sig', 'replace')


class _Import(ImportHelper):
    """Adds the shapes of files at their coordinates, from the origin of the world."""

    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    filepath: path_property()
    directory: StringProperty(subtype='DIR_PATH', options={'HIDDEN', 'SKIP_SAVE'})
    files: CollectionProperty(type=bpy.types.OperatorFileListElement, options={'HIDDEN', 'SKIP_SAVE'})
    resolution_u: resolution_property("U", default=10)
    resolution_v: resolution_property("V", default=10)

    @classmethod
    def poll(cls, context):
        return can_add(cls, context)

    def values(self, text):
        """The value of each object that the text of a file makes."""
        raise NotImplementedError

    def look_inside(self, path):
        """Raises Refusal for a file of others whose name ends as ours do."""

    def name_of(self, path):
        """What objects of a file are called."""
        return path.stem

    def invoke(self, context, event):
        """Files that were dropped need no file browser."""
        if self.properties.is_property_set("files"):
            return self.execute(context)
        return super().invoke(context, event)

    def execute(self, context):
        paths, made, failed = self._paths(), [], {}
        with progress.shown(context, len(paths)) as step:
            for i, path in enumerate(paths):
                try:
                    made += self._read(path, lambda part, i=i: step(i + part))
                except FAILURES as error:
                    failed[printable(path.name)] = printable(sentence(error))
        reasons = reports.by_name(failed)
        if not made:
            return reports.cancelled(self, *reasons)
        _link(context, made)
        done = len(paths) - len(failed)
        what = made[0][0] if len(made) == 1 else phrase("{count} objects",
                                                        count=len(made)) + (phrase(" of {count} files", count=done) if done > 1 else "")
        return reports.finished(self, reports.Report(phrase("Imported {what}", what=what), warnings=reasons))

    def _paths(self):
        """The files that were chosen or dropped, or the one that a script names."""
        folder = Path(bpy.path.abspath(self.directory))
        return [folder / element.name for element in self.files if element.name] or [path_of(self)]

    def _read(self, path, progress):
        """Pairs of a name and a new data-block for what a file holds. progress is called with the part that is done."""
        name, made = printable(self.name_of(path)), []
        self.look_inside(path)
        try:
            values = self.values(_text_of(path))
            for value in values:
                start = new_shapes.start_of_any(self, is_surface=not _is_curve(value))
                made.append((name, shape.new_data(name, value, start)))
                progress(len(made) / len(values))
        except Exception:
            for _, data in made:
                blocks.remove(data)
            raise
        return made


def _link(context, made):
    """New objects of pairs of a name and a data-block, selected in place of what was; the last one is active."""
    for ob in context.selected_objects:
        ob.select_set(False)
    for name, data in made:
        ob = bpy.data.objects.new(name, data)
        context.collection.objects.link(ob)
        ob.select_set(True)
        context.view_layer.objects.active = ob


class _Export(ExportHelper):
    bl_options = {'REGISTER'}

    filepath: path_property()
    transform: BoolProperty(
        name="Apply Transforms", description="Write the shapes where they stand in the world; otherwise in the space of "
        "their objects, with every digit")

    @classmethod
    def poll(cls, context):
        if not _exported(context):
            cls.poll_message_set(say("Select a Splinewright shape"))
            return False
        return True

    def text(self, values):
        """(the text for values by names of objects, those left out, by name). Raises as sc.dumps()."""
        raise NotImplementedError

    def execute(self, context):
        path, chosen = path_of(self), _exported(context)
        if not self.filepath or path.is_dir():
            return reports.cancelled(self, "Name a file to write to")
        name = chosen[0].name if len(chosen) == 1 else ""
        try:
            text, left_out = self.text({ob.name: self._value(ob) for ob in chosen})
            whole_files.write(path, text)
        except FAILURES as error:
            text = printable(sentence(error))
            return reports.cancelled(self, reports.named(name, text) if name else text)
        count = len(chosen) - len(left_out)
        what = phrase("Exported {count} objects to", count=count) if count > 1 else "Exported"
        changed = {ob.name: _CHANGED for ob in chosen if ob.name not in left_out and shape.is_touched(ob.data)}
        warnings = reports.by_name({**left_out, **changed})
        return reports.finished(self, reports.Report(f"{what} {printable(path.name)}", warnings=warnings))

    def _value(self, ob):
        if not self.transform:
            return shape.value_of(ob.data)
        return definitions.to_value(transform.transformed(store.read(ob.data), np.array(ob.matrix_world, dtype=np.float64)))


def _exported(context):
    """The selected shapes by name; the active one where none is."""
    chosen = [ob for ob in context.selected_objects if shape.has_shape(ob)]
    if not chosen and shape.has_shape(context.object):
        chosen = [context.object]
    return sorted(chosen, key=lambda ob: ob.name)


#: Of a shape whose mesh or curve is not what its definition shows.
_CHANGED = "changes made by hand are not in the file: it holds the definition, which Discard Manual Changes shows"
_NO_PATCH = "BPT holds patches, this is a curve"


def _is_curve(value):
    return isinstance(value, (*ANY_CURVES, list))


class _Bpt:
    filename_ext = ".bpt"
    filter_glob: StringProperty(default="*.bpt", options={'HIDDEN'})
    flip: BoolProperty(name="Flip", description="Exchange u and v of every patch, which turns the normals over")


#: What is looked at of a file to see whose it is, in bytes, and what files of ours have there.
_LOOKED_AT = 1 << 20
_OURS = re.compile(r'"format"\s*:\s*"splinecore"')


class _Json:
    filename_ext = ".spw.json"
    filter_glob: StringProperty(default="*.json", options={'HIDDEN'})


class SPLINEWRIGHT_OT_import_bpt(_Bpt, _Import, bpy.types.Operator):
    bl_idname = "splinewright.import_bpt"
    bl_label = "Import BPT"
    bl_description = "Import a file of Bezier patches as one object; equal points become one"

    def values(self, text):
        return [sc.bpt.loads(text, self.flip)]


class SPLINEWRIGHT_OT_export_bpt(_Bpt, _Export, bpy.types.Operator):
    bl_idname = "splinewright.export_bpt"
    bl_label = "Export BPT"
    bl_description = "Export the patches of all selected shapes as Bezier patches, exactly"
    bl_options = {'REGISTER', 'PRESET'}

    def text(self, values):
        curves = {name: _NO_PATCH for name, value in values.items() if _is_curve(value)}
        if len(curves) == len(values):
            raise Refusal(_NO_PATCH)
        patches = [patch for name, value in values.items() if name not in curves for patch in self._patches(name, value)]
        return sc.bpt.dumps(sc.PatchSet.from_patches(patches) if len(patches) > 1 else patches[0]), curves

    def _patches(self, name, value):
        """Those of one object. Raises Refusal that names it where the format cannot hold them."""
        if self.flip:
            value = value.flipped() if isinstance(value, sc.PatchSet) else value.swapped()
        patches = [value[i] for i in range(len(value))] if isinstance(value, sc.PatchSet) else [value]
        if any(patch.is_rational for patch in patches):
            raise Refusal("{name}: it is rational, and BPT holds no weights: export it as JSON", name=name)
        return patches


def _shapes(value):
    """The outlines of a region, or the shape alone."""
    return value.outlines if isinstance(value, sc.Region) else [value]


class SPLINEWRIGHT_OT_import_json(_Json, _Import, bpy.types.Operator):
    bl_idname = "splinewright.import_json"
    bl_label = "Import Exact JSON"
    bl_description = "Import curves and patches with every digit; all curves of a list become one object"

    def look_inside(self, path):
        """Of a dropped file Blender compares the last ending alone, which any JSON has."""
        if not path.name.lower().endswith(self.filename_ext) and not _OURS.search(_start_of(path)):
            raise Refusal("it holds no curves or patches of Splinewright")

    def name_of(self, path):
        return path.stem[:-4] if path.stem.lower().endswith(".spw") else path.stem

    def values(self, text):
        value = sc.loads(text)
        if not isinstance(value, (list, sc.Region)):
            return [value]
        value = [item for one in (value if isinstance(value, list) else [value]) for item in _shapes(one)]
        curves = [item for item in value if isinstance(item, ANY_CURVES)]
        patches = [item for item in value if not isinstance(item, ANY_CURVES)]
        if not value:
            raise Refusal("the file holds an empty list")
        return ([curves] if curves else []) + patches


class SPLINEWRIGHT_OT_export_json(_Json, _Export, bpy.types.Operator):
    bl_idname = "splinewright.export_json"
    bl_label = "Export Exact JSON"
    bl_description = "Export the definitions of all selected shapes with every digit"
    bl_options = {'REGISTER', 'PRESET'}

    def check(self, context):
        """Whether the name in the file browser got an ending. Blender's helper would add one of two parts again and again."""
        path = Path(self.filepath)
        if not path.name or self.filepath.endswith(("/", "\\")) or path.suffix.lower() == ".json":
            return False
        self.filepath += ".json" if path.suffix.lower() == ".spw" else self.filename_ext
        return True

    def text(self, values):
        """One shape as it is, several as a list of their curves, patches and sets of patches."""
        found = list(values.values())
        if len(found) == 1:
            return sc.dumps(found[0]), {}
        return sc.dumps([item for value in found for item in (value if isinstance(value, list) else [value])]), {}


CLASSES = (SPLINEWRIGHT_OT_import_bpt, SPLINEWRIGHT_OT_export_bpt,
           SPLINEWRIGHT_OT_import_json, SPLINEWRIGHT_OT_export_json)

if versions.drops_files:
    class _Dropped:
        """Files that are dropped into a 3D view."""

        @classmethod
        def poll_drop(cls, context):
            return context.area and context.area.type == 'VIEW_3D'

    class SPLINEWRIGHT_FH_bpt(_Dropped, bpy.types.FileHandler):
        bl_idname = "SPLINEWRIGHT_FH_bpt"
        bl_label = "Bezier Patches"
        bl_import_operator = "splinewright.import_bpt"
        bl_file_extensions = ".bpt"

    class SPLINEWRIGHT_FH_json(_Dropped, bpy.types.FileHandler):
        bl_idname = "SPLINEWRIGHT_FH_json"
        bl_label = "Splinewright Exact Curves and Patches (.spw.json)"
        bl_import_operator = "splinewright.import_json"
        bl_file_extensions = ".json"

    CLASSES += (SPLINEWRIGHT_FH_bpt, SPLINEWRIGHT_FH_json)
