"""Sample scenes that lie in the zip."""

from pathlib import Path

import bpy
from bpy.props import EnumProperty

from ...bridge.data import store, tessellate
from ...core.base.failures import FAILURES
from ...core.base.words import phrase, say
from . import polls, reports

FOLDER = Path(__file__).resolve().parents[2] / "samples"
SAMPLES = (
    ('vase', "Vase", "A profile, and the surface of revolution that follows it"),
    ('shampoo', "Bottle", "A loft through ellipses, with a cap that is revolved"),
    ('mouse', "Computer Mouse", "A network of curves, mirrored with G2 across its plane"),
    ('hull', "Hull", "A loft through frames with a chine, mirrored, with pipes along its edges"))


class SPLINEWRIGHT_OT_add_sample(bpy.types.Operator):
    bl_idname = "splinewright.add_sample"
    bl_label = "Add Sample Scene"
    bl_description = "Add a scene with shapes that are alive, to be taken apart; your own scene stays as it is"
    bl_options = {'REGISTER', 'UNDO'}

    sample: EnumProperty(name="Sample", description="Which scene is added", items=SAMPLES, options={'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        return polls.in_object_mode(cls, context)

    def execute(self, context):
        label = next(label for name, label, _ in SAMPLES if name == self.sample)
        try:
            collection = _appended(FOLDER / f"{self.sample}.blend", label)
        except (OSError, *FAILURES) as error:
            return reports.failed(self, error, label)
        scene = bpy.data.scenes.new(label)
        scene.collection.children.link(collection)
        if context.window is not None:
            context.window.scene = scene
        for ob in collection.objects:
            if ob.type == 'MESH' and store.has_definition(ob.data):
                ob.data.splinewright.mode = tessellate.AUTOMATIC
        _look_at_all(context)
        return reports.finished(self, reports.Report(phrase("Added the scene {name}: Tab on a curve edits it, and the surfaces "
                                                            "follow",
                                                            name=scene.name)))


def _appended(path, label):
    """The collection of a file. Raises OSError."""
    with bpy.data.libraries.load(str(path)) as (_, wanted):
        wanted.collections = [label]
    return wanted.collections[0]


def _look_at_all(context):
    area = context.area
    if area is not None and area.type == 'VIEW_3D':
        region = next(region for region in area.regions if region.type == 'WINDOW')
        with context.temp_override(area=area, region=region):
            bpy.ops.view3d.view_all()


def draw(layout):
    """A menu of all samples."""
    layout.operator_menu_enum(SPLINEWRIGHT_OT_add_sample.bl_idname, "sample", text="Add Sample Scene", icon='SCENE_DATA')


class SPLINEWRIGHT_OT_add_asset_library(bpy.types.Operator):
    bl_idname = "splinewright.add_asset_library"
    bl_label = "Show Samples in Asset Browser"
    bl_description = "Add the folder of sample files to the asset libraries of Blender's preferences"
    bl_options = {'INTERNAL'}

    @classmethod
    def poll(cls, context):
        if _is_library(context):
            cls.poll_message_set(say("The samples are in the asset browser: library Splinewright"))
            return False
        return True

    def execute(self, context):
        bpy.ops.preferences.asset_library_add('EXEC_DEFAULT', directory=str(FOLDER))
        context.preferences.filepaths.asset_libraries[-1].name = "Splinewright"
        return reports.finished(self, reports.Report("The samples are in the asset browser: library Splinewright"))


def _is_library(context):
    return any(Path(library.path) == FOLDER for library in context.preferences.filepaths.asset_libraries)


CLASSES = (SPLINEWRIGHT_OT_add_sample, SPLINEWRIGHT_OT_add_asset_library)
