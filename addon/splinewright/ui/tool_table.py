"""All our tools in the toolbar of 3D views, by groups that have one button each. toolbar.py shows them."""

from typing import NamedTuple

from . import object_kinds

_CURVE, _PATCH = frozenset({'curve'}), frozenset({'patch'})
NETS = ('EDIT_MESH', 'EDIT_CURVE')
_OBJECT, _CURVES = ('OBJECT',), ('EDIT_CURVE',)
_EVERYWHERE = (*NETS, *_OBJECT)
_AT_ONCE = (("at_once", True),)
_DRAGGED = (("at_mouse", True), ("is_drag", True))
_CLICK, _DRAG = ('MOUSE_LMB',), ('MOUSE_LMB_DRAG',)
_WITH_CTRL = ('EVENT_CTRL', 'MOUSE_LMB')


class Tool(NamedTuple):
    """A tool: what it is called, the operator that its button calls, and with which settings and modifiers. shown: the
    operator's settings in the header; of_patches: those there for patches only; preview: the preview at the mouse, of
    ui.gizmos; keys: pairs of icons and words for the status bar; is_always: whether it is there with nothing selected;
    concerns: the kinds of objects it is used on, of ui.object_kinds."""

    name: str
    label: str
    description: str
    operator: str
    keys: tuple
    settings: tuple = _AT_ONCE
    modifiers: tuple = ()
    shown: tuple = ()
    of_patches: tuple = ()
    modes: tuple = _OBJECT
    cursor: str = 'CROSSHAIR'
    preview: str = ""
    is_always: bool = False
    concerns: frozenset = object_kinds.SHAPES

    @property
    def idname(self):
        return f"splinewright.{self.name}"


_DRAW = (
    Tool("draw_curve", "Draw Curve", "Draw a stroke that becomes a smooth curve within a tolerance",
         "splinewright.draw_curve", ((_DRAG, "Draw Curve"),), shown=("pixels", "degree"), cursor='PAINT_BRUSH', is_always=True),
    Tool("draw_on_surface", "Draw on Surface", "Draw a stroke on the surface under the mouse; it becomes a smooth curve",
         "splinewright.draw_on_surface", ((_DRAG, "Draw on Surface"),), shown=("pixels", "degree"), cursor='PAINT_BRUSH',
         is_always=True),
    Tool("draw_contour", "Draw Contour", "Click the points of a contour of segments and arcs; Enter finishes it",
         "splinewright.draw_contour", ((_CLICK, "First Point"),), shown=("radius",), is_always=True))

_KNOTS = (
    Tool("insert_knot", "Insert Knot", "Click a curve or patch to insert a knot there; the shape stays the same",
         "splinewright.insert_here", ((_CLICK, "Insert Knot"), (_WITH_CTRL, "Middle of Span")),
         modifiers=('ctrl',), of_patches=("direction",), modes=_EVERYWHERE, preview='knot'),
    Tool("split", "Split", "Click a curve or patch to split it there; the shape stays the same",
         "splinewright.split_here", ((_CLICK, "Split"), (_WITH_CTRL, "Middle of Span")),
         modifiers=('ctrl',), of_patches=("direction",), modes=_EVERYWHERE, cursor='KNIFE', preview='knot'),
    Tool("isocurve", "Extract Isocurve", "Click a patch to extract the curve along u or v there",
         "splinewright.extract_here", ((_CLICK, "Extract Isocurve"), (_WITH_CTRL, "Middle of Span")),
         modifiers=('ctrl',), of_patches=("direction",), preview='isocurve', concerns=_PATCH),
    Tool("edge", "Extract Edge", "Click an edge of a patch to extract it as a curve", "splinewright.extract_side_here",
         ((_CLICK, "Extract Edge"),), preview='side', concerns=_PATCH))

_CORNERS = (
    Tool("trim", "Trim", "Click the part of a curve to remove, up to where it meets other curves", "splinewright.trim_here",
         ((_CLICK, "Remove Part"),), shown=("meet",), cursor='KNIFE', preview='trim', concerns=_CURVE),
    Tool("extend", "Extend", "Click a curve near an end to extend it until it meets another curve",
         "splinewright.extend_here", ((_CLICK, "Extend Nearest End"),), shown=("meet", "how"), preview='extend', concerns=_CURVE),
    Tool("fillet", "Fillet", "Click two curves on the parts to keep; a circular arc connects them",
         "splinewright.fillet_here", ((_CLICK, "First Curve to Fillet"),), shown=("radius", "joined"), preview='curve', concerns=_CURVE),
    Tool("chamfer", "Chamfer", "Click two curves on the parts to keep; a straight segment connects them",
         "splinewright.chamfer_here", ((_CLICK, "First Curve to Chamfer"),), shown=("first_length", "second_length", "joined"),
         preview='curve', concerns=_CURVE),
    Tool("round_edges", "Round Edges", "Click the edges of selected surfaces to round; Enter finishes",
         "splinewright.round_here", ((_CLICK, "First Edge to Round"),), concerns=_PATCH))

_SHAPE = (
    Tool("pull", "Pull Shape", "Drag any point of a curve or patch; the control points follow with the least change",
         "splinewright.pull_here", ((_DRAG, "Pull Shape"),), shown=("locality",), modes=_EVERYWHERE),
    Tool("join", "Join Patches", "Click an edge of a patch, and then the edge to join it to", "splinewright.join_here",
         ((_CLICK, "First Edge to Join"),), shown=("continuity", "moves"), preview='side', concerns=_PATCH))

_POINTS = (
    Tool("weight", "Weight", "Drag a control point sideways to change its weight, or the weights of all selected points",
         "splinewright.weight_here", ((_DRAG, "Weight"),), settings=_DRAGGED, modes=NETS, cursor='MOVE_X'),
    Tool("radius", "Radius", "Drag a control point sideways to change the radius there, or at all selected points",
         "splinewright.radius_here", ((_DRAG, "Radius"),), settings=_DRAGGED, modes=_CURVES, cursor='MOVE_X', concerns=_CURVE),
    Tool("tilt", "Tilt", "Drag a control point sideways to change the tilt there, or at all selected points",
         "splinewright.tilt_here", ((_DRAG, "Tilt"),), settings=_DRAGGED, modes=_CURVES, cursor='MOVE_X', concerns=_CURVE))

_LOOK = (
    Tool("measure", "Measure", "Point at a shape to measure it there; a click shows all numbers in the Measure panel", "splinewright.measure_here",
         ((_CLICK, "Show in the Panel"),), modes=_EVERYWHERE, preview='measure'),
    Tool("pick", "Pick Piece", "Click a piece of a shape; commands that ask for a piece start with it",
         "splinewright.pick_piece", ((_CLICK, "Pick Piece"),), shown=("other",), cursor='EYEDROPPER'))

GROUPS = (_DRAW, _KNOTS, _CORNERS, _SHAPE, _POINTS, _LOOK)
TOOLS = {tool.name: tool for group in GROUPS for tool in group}
