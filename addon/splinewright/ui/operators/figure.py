"""Export of a figure: what a 3D view shows, as exact paths on a page."""

from pathlib import Path

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

from ...bridge.cage import net_object
from ...bridge.data.settings import overlays_of
from ...bridge.figures import drawn
from ...bridge.shape import shape
from ...core.base import whole_files
from ...core.base.failures import FAILURES
from ...core.base.words import phrase, say
from ...core.figures import page, pdf, svg
from ...core.figures.figure import ink
from .. import analysis_overlay, colors, editing, labels_overlay
from . import reports
from .exchange import path_of, path_property, printable

_ENDINGS = {'SVG': ".svg", 'PDF': ".pdf"}


def _millimeters(name, description, default, most):
    return FloatProperty(name=name, description=description, default=default, min=0.01, soft_min=0.1, max=most, precision=2, step=10)


def _view(context):
    """(window, area, region, its RegionView3D) of the 3D view that is meant: where the mouse is, or the largest of the window; or None."""
    window = context.window or next(iter(context.window_manager.windows), None)
    found = [(window, area, region, region.data or area.spaces.active.region_3d)        # a region has no data without a window
             for area in (window.screen.areas if window is not None else ()) if area.type == 'VIEW_3D'
             for region in area.regions if region.type == 'WINDOW']
    return next((view for view in found if view[2] == context.region), max(found, key=lambda view: view[2].width * view[2].height, default=None))


class SPLINEWRIGHT_OT_export_figure(ExportHelper, bpy.types.Operator):
    bl_idname = "splinewright.export_figure"
    bl_label = "Export Figure"
    bl_description = "Export curves, patches, nets and names of the 3D view as exact paths; other meshes only hide what lies behind"
    bl_options = {'REGISTER', 'PRESET'}

    filename_ext = ".svg"
    filepath: path_property()
    filter_glob: StringProperty(default="*.svg;*.pdf", options={'HIDDEN'})
    format: EnumProperty(name="Format", description="What the file holds", items=(
        ('SVG', "SVG", "For browsers, Inkscape and word processors"),
        ('PDF', "PDF", "For print and LaTeX; needs the Python package reportlab")))
    width: _millimeters("Width", "Of the page in millimeters; its height follows from the shape of the view", 160.0, 5000.0)
    curve_width: _millimeters("Curves", "Width of curves and borders of patches, in millimeters", 0.5, 20.0)
    isocurve_width: _millimeters("Isocurves", "Width of isocurves, in millimeters", 0.15, 20.0)
    point_size: _millimeters("Points", "Diameter of control points, in millimeters", 1.4, 50.0)
    text_size: _millimeters("Text", "Size of letters, in millimeters", 3.5, 100.0)
    isocurves: IntProperty(
        name="Isocurves per Span", description="How many isocurves show every span of a patch each way, beside those at knots",
        default=3, min=0, soft_max=20, max=100)
    behind: EnumProperty(name="Hidden Lines", description="How lines behind surfaces are drawn; rays to meshes find them", default='OMIT', items=(
        (drawn.OMIT, "Leave Out", "Leave out what lies more than a millimeter of the page behind a mesh"),
        (drawn.DASH, "Dash", "Draw dashes where a line lies more than a millimeter of the page behind a mesh"),
        (drawn.SHOW, "Show", "Draw all lines, as if surfaces were transparent")))
    white: BoolProperty(name="White Background", description="Make the page white; otherwise it is transparent", default=True)

    @classmethod
    def poll(cls, context):
        if _view(context) is None:
            cls.poll_message_set(say("Open a 3D view: the figure shows what it shows"))
            return False
        return True

    def check(self, context):
        """Whether the name in the file browser got another ending."""
        path, ending = Path(self.filepath), _ENDINGS[self.format]
        if not path.name or self.filepath.endswith(("/", "\\")) or path.suffix.lower() == ending:
            return False
        kept = path.with_suffix("") if path.suffix.lower() in _ENDINGS.values() else path
        self.filepath = f"{kept}{ending}"
        return True

    def execute(self, context):
        path = path_of(self)
        if not self.filepath or path.is_dir():
            return reports.cancelled(self, "Name a file to write to")
        if path.suffix.lower() not in _ENDINGS.values():
            path = path.with_name(path.name + _ENDINGS[self.format])
        try:
            drawing = self._drawing(context)
            made = drawing.figure
            if not made.groups:
                return reports.cancelled(self, "Nothing to draw: the view shows no curves or patches", *reports.by_name(drawing.left_out))
            whole_files.write(path, pdf.bytes_of(made) if path.suffix.lower() == ".pdf" else svg.text_of(made))
        except FAILURES as error:
            return reports.failed(self, error)
        said = phrase("Exported {name}, {width:.4g} × {height:.4g} mm", name=printable(path.name), width=made.width, height=made.height)
        return reports.finished(self, reports.Report(said, warnings=reports.by_name(
            {name: phrase("left out: {reason}", reason=reason) for name, reason in drawing.left_out.items()})))

    def _drawing(self, context):
        window, area, region, view = _view(context)
        space = area.spaces.active
        clip = np.array(view.perspective_matrix, dtype=np.float64)
        seen = page.page(clip, self.width, region.height / max(region.width, 1), _near(space, view))
        with context.temp_override(window=window, area=area, region=region):
            shown = _shown(bpy.context, space)
        return drawn.figure(shown, seen, drawn.Wanted(
            curves=self.curve_width, isocurves=self.isocurve_width, letters=self.text_size, points=self.point_size, count=self.isocurves,
            behind=self.behind, white=self.white, net_colors=tuple(map(ink, colors.of_net()))))


def _near(space, view):
    """How far before the eye a view begins."""
    camera = space.camera if view.view_perspective == 'CAMERA' else None
    return camera.data.clip_start if camera is not None and camera.type == 'CAMERA' else space.clip_start


def _shown(context, space):
    """The View of a 3D view: nets that are out, and overlays, as far as they are switched on."""
    out = [ob for ob in map(net_object.shape_of, editing.nets()) if shape.has_shape(ob)]
    scene, layer, depsgraph = context.scene, context.view_layer, context.evaluated_depsgraph_get()
    if not space.overlay.show_overlays:
        return drawn.View(scene, layer, depsgraph, space, tuple(out))
    chosen, overlaid = overlays_of(scene), tuple(analysis_overlay.shapes_seen(context))
    nets = tuple(dict.fromkeys([*(overlaid if chosen.polygon else ()), *out]))
    return drawn.View(scene, layer, depsgraph, space, nets, tuple(labels_overlay.labeled(context)) if chosen.labels else (), overlaid)


CLASSES = (SPLINEWRIGHT_OT_export_figure,)
