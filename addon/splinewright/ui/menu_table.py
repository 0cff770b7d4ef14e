"""All our menus: their entries, which kinds of selected objects an entry concerns, and where they belong in Blender's own menus.
menus.py shows them. For each kind of object an operator stands in one menu."""

from typing import NamedTuple

from . import object_kinds
from .operators.show_overlays import SIGHTS
from .tool_table import GROUPS, NETS

CURVE, PATCH, NATIVE, BAKED, MESH = (frozenset({kind}) for kind in ('curve', 'patch', 'native', 'baked', 'mesh'))
SHAPES, FOLLOWED = object_kinds.SHAPES, object_kinds.FOLLOWED
CURVES, SURFACES = CURVE | NATIVE, PATCH | NATIVE
#: Whatever is selected.
ANY = None


class Entry(NamedTuple):
    """An operator. concerns: the kinds of objects, of ui.object_kinds; changes: whether it changes what shapes are, so that it is gray
    where that is not to be changed; text: what it says, if that is not the operator's own; settings: pairs of names and values."""

    operator: str
    concerns: frozenset = SHAPES
    icon: str = 'NONE'
    changes: bool = False
    text: str = ""
    settings: tuple = ()


class Native(NamedTuple):
    """An operator of Blender's that works in nets, in these modes."""

    operator: str
    modes: frozenset


class Place(NamedTuple):
    """Entries and menus in one of Blender's menus: at its end, or first. has_line: whether a line parts them from Blender's own;
    mode: 'NETS' where nets are edited, 'OTHERS' where none is, 'OBJECT' for Object Mode with something selected that concerns us;
    is_header: whether it is a bar, where menus have no icons."""

    menu: str
    entries: tuple
    mode: str = ""
    is_first: bool = False
    has_line: bool = True
    is_header: bool = False


class Menu(NamedTuple):
    """entries: Entry, Native, Menu, or None for a line between groups."""

    name: str
    label: str
    entries: tuple
    icon: str = 'NONE'

    @property
    def idname(self):
        return f"SPLINEWRIGHT_MT_{self.name}"


def _verbs(concerns, *names):
    return tuple(Entry(name, concerns, changes=True) for name in names)


def _others(concerns, *names):
    return tuple(Entry(name, concerns) for name in names)


def _sight(name):
    return Entry('show_sight', text=SIGHTS[name].label, settings=(('sight', name),))


def _native(modes, *operators):
    return tuple(Native(operator, frozenset(modes)) for operator in operators)


def _made(concerns, *kinds_and_icons):
    """Constructions from objects, which follow them."""
    return tuple(Entry(f"add_{kind}", concerns, icon) for kind, icon in kinds_and_icons)


def _tools(*modes):
    """Entries that choose the toolbar's tools of these modes, by its groups, so that F3 finds them. What draws is under Add."""
    groups = [[Entry('use_tool', tool.concerns, text=tool.label, settings=(('tool', tool.name),))
               for tool in group if not tool.is_always and set(modes) & set(tool.modes)] for group in GROUPS]
    return tuple(entry for group in groups if group for entry in (None, *group))[1:]


def _from_numbers(icon, *names):
    return tuple(Entry(f"add_{name}", ANY, icon) for name in names)


# Objects and nets ---------------------------------------------------------------------------------

KNOTS = Menu('knots', "Knots", (
    *_verbs(SHAPES, 'insert_knot', 'remove_knot', 'remove_knots'), *_others(SHAPES, 'set_knots'), None, *_verbs(SHAPES, 'clamp', 'unclamp')))
DEGREE = Menu('degree', "Degree", _verbs(SHAPES, 'raise_degree', 'lower_degree'))
PARAMETER = Menu('parameter', "Parameter", (
    *_verbs(SHAPES, 'reparameterize'), *_verbs(CURVE, 'standard_form', 'project_curve')))
MODIFY = Menu('modify', "Modify", (
    KNOTS, DEGREE, PARAMETER, None,
    *_verbs(SHAPES, 'rebuild', 'fair', 'make_periodic'), *_others(SHAPES, 'make_deformable'), None,
    *_verbs(SHAPES, 'reverse'), *_verbs(PATCH, 'swap_uv'), None,
    *_verbs(SHAPES, 'split'), *_verbs(CURVE, 'split_where_met')), 'MODIFIER')
CORNERS = Menu('corners', "Trim and Corners", (
    *_verbs(CURVE, 'trim_curve', 'extend_curve'), None,
    *_verbs(CURVE, 'fillet_corners', 'chamfer_corners', 'fillet_curves', 'chamfer_curves')), 'SNAP_MIDPOINT')
PIECES = Menu('pieces', "Join", (
    *_others(SHAPES, 'join'), *_verbs(CURVE, 'join_ends', 'join_pieces', 'join_curves'), *_verbs(PATCH, 'join_patches'), None,
    *_others(SHAPES, 'separate_pieces', 'delete_pieces', 'explode')), 'AUTOMERGE_ON')
CONVERT = Menu('convert', "Convert", (
    *_others(object_kinds.INEXACT, 'make_exact'), *_others(SHAPES, 'to_native'), None, *_verbs(SHAPES, 'to_nurbs', 'to_bezier', 'to_hermite')),
    'FILE_REFRESH')

FROM_OBJECTS = Menu('curve_from_objects', "Curve from Objects", (
    Entry('add_offset', CURVES, 'MOD_OFFSET', text="Offset Curve"),
    *_made(CURVES, ('blend', 'MOD_SMOOTH'), ('about', 'FORCE_VORTEX')),
    *_others(CURVE, 'add_touching_circle', 'intersections'), None,
    *_made(FOLLOWED, ('projected', 'MOD_SHRINKWRAP'), ('on_patch', 'UV')), None,
    *_made(SURFACES, ('section', 'MOD_BOOLEAN'), ('planes', 'MOD_ARRAY')), *_others(PATCH, 'extract_isocurve', 'extract_boundary')),
    'CURVE_DATA')
FROM_CURVES = Menu('surface_from_curves', "Surface from Curves", _made(
    CURVES, ('extrude', 'MOD_SOLIDIFY'), ('revolve', 'MOD_SCREW'), ('ruled', 'MOD_LATTICE'), ('loft', 'MOD_ARRAY'),
    ('sweep', 'CURVE_PATH'), ('two_rails', 'CURVE_PATH'), ('pipe', 'META_CAPSULE'), ('network', 'MOD_LATTICE'),
    ('filling', 'MESH_GRID')), 'MOD_LATTICE')
FROM_SURFACES = Menu('surface_from_surfaces', "Surface from Surfaces", (
    *_made(SURFACES, ('surface_blend', 'MOD_SMOOTH'), ('matched', 'SNAP_EDGE'), ('rounded_edge', 'MOD_BEVEL'), ('offset_surface', 'MOD_OFFSET'),
           ('thickened', 'MOD_SOLIDIFY'), ('extended_surface', 'MOD_EDGESPLIT')),
    *_made(PATCH, ('filling', 'MESH_GRID')), *_others(PATCH, 'cap'), *_made(SURFACES, ('of_mesh', 'MOD_SUBSURF'))), 'MOD_SOLIDIFY')

POINTS = Menu('points', "Points", (
    *_others(FOLLOWED, 'curve_through_points', 'fit_curve'), *_others(CURVE, 'divide_equally'), *_others(SHAPES, 'project_points')),
    'SNAP_VERTEX')
CONSTRUCTION = Menu('construction', "Construction", (
    Entry('follow_object', FOLLOWED, 'LINKED'), *_made(FOLLOWED, ('mirror', 'MOD_MIRROR')), *_others(SHAPES, 'edit_source', 'make_editable'), None,
    *_others(SHAPES, 'restore', 'detach', 'apply_transform', 'adopt_transform')), 'LINKED')
ANIMATION = Menu('animation', "Animation", (
    Entry('key_points', icon='KEY_HLT'), *_others(SHAPES, 'clear_point_keys', 'bake_animation'), *_others(BAKED, 'unbake')), 'ANIM')
PICTURES = Menu('pictures', "Pictures", (
    *_made(CURVES, ('halving', 'NONE'), ('chain_points', 'NONE'), ('marks', 'NONE'), ('orders', 'NONE'), ('lift', 'NONE'),
           ('perspective', 'NONE')), *_made(FOLLOWED, ('discs', 'NONE'), ('hulls', 'NONE'), ('influence', 'NONE'))), 'IMAGE_DATA')
TEACHING = Menu('teaching', "Teaching", (
    *_made(CURVES, ('basis', 'GRAPH'), ('basis_triangle', 'NONE'), ('construction', 'NONE')), *_made(SURFACES, ('basis_products', 'GRAPH')), PICTURES,
    *_others(CURVE, 'choose_function'), *_others(SHAPES, 'write_formulas'), *_made(FOLLOWED, ('labels', 'FONT_DATA')), _sight('LABELS'), _sight('AXES')), 'HELP')
SHOW = Menu('show', "Show", tuple(_sight(name) for name in SIGHTS if name not in ('LABELS', 'AXES')), 'OVERLAY')

OBJECT_TOOLS = Menu('object_tools', "Tools", _tools('OBJECT'), 'TOOL_SETTINGS')
NET_TOOLS = Menu('net_tools', "Tools", _tools(*NETS), 'TOOL_SETTINGS')

#: In the header and in the context menu, in Object Mode.
OBJECT = Menu('object', "NURBS", (
    Entry('edit_net', icon='EDITMODE_HLT'), OBJECT_TOOLS, None, MODIFY, CORNERS, PIECES, CONVERT, None,
    FROM_OBJECTS, FROM_CURVES, FROM_SURFACES, POINTS, None, CONSTRUCTION, ANIMATION, TEACHING, SHOW), 'SURFACE_DATA')
#: What of Blender's own changes nets, with its keys.
GESTURES = Menu('gestures', "Blender's Gestures", (
    *_native(('EDIT_CURVE', 'EDIT_MESH'), 'transform.translate', 'transform.resize'), None,
    *_native(('EDIT_CURVE',), 'curve.extrude_move', 'curve.subdivide', 'curve.dissolve_verts', 'curve.delete', 'curve.cyclic_toggle',
             'curve.make_segment', 'curve.split', 'curve.handle_type_set'),
    *_native(('EDIT_MESH',), 'mesh.extrude_region_move', 'mesh.loopcut_slide', 'mesh.dissolve_edges', 'mesh.delete_edgeloop')),
    'HAND')
#: The same while nets are edited. Blender has a menu "Control Points" of its own there.
NET = Menu('net', "NURBS", (
    Entry('leave_net', icon='CHECKMARK'), Entry('renew_net', icon='FILE_REFRESH'), NET_TOOLS, None, MODIFY, CORNERS, PIECES, CONVERT, None,
    *_others(SHAPES, 'weight_here'), *_others(CURVE, 'radius_here', 'tilt_here'),
    Menu('infinity', "Infinity", _others(SHAPES, 'point_to_infinity', 'point_from_infinity')), ANIMATION, SHOW, GESTURES), 'SURFACE_DATA')

# Add ----------------------------------------------------------------------------------------------

DRAW = Menu('draw', "Draw", tuple(Entry(name, ANY, 'GREASEPENCIL') for name in ('draw_curve', 'draw_contour', 'draw_on_surface')),
            'GREASEPENCIL')
THROUGH = Menu('through_points', "Through Points", (
    *_from_numbers('SNAP_VERTEX', 'interpolating', 'approximating', 'catmull_rom', 'kochanek_bartels', 'polynomial', 'osculating', 'ducks'), None,
    *_others(ANY, 'contour_through_points')), 'SNAP_VERTEX')
CONICS = Menu('conics', "Conic", (
    *_from_numbers('MESH_CIRCLE', 'ellipse', 'parabola', 'hyperbola'), *_from_numbers('SPHERECURVE', 'arc_by_points'), None,
    *_from_numbers('CURVE_DATA', 'conic', 'foci', 'five_points', 'equation')), 'MESH_CIRCLE')
FORMULAS = Menu('mathematical', "Mathematical", (
    *_from_numbers('FORCE_VORTEX', 'helix'), *_from_numbers('FILE_TEXT', 'formula'), *_from_numbers('FILE_TEXT', 'projection'), *_from_numbers('GRAPH', 'functions', 'triangle'),
    *_from_numbers('EMPTY_AXIS', 'axes')), 'FILE_TEXT')
ADD_CURVE = Menu('curve_add', "NURBS", (
    Entry('add_line', ANY, 'IPO_LINEAR'), Entry('add_bezier_curve', ANY, 'CURVE_BEZCURVE'),
    Entry('add_bezier_chain', ANY, 'CURVE_PATH'), Entry('add_hermite_curve', ANY, 'CURVE_DATA'),
    Entry('add_nurbs_curve', ANY, 'CURVE_NCURVE'), Entry('add_circle', ANY, 'MESH_CIRCLE'), Entry('add_arc', ANY, 'SPHERECURVE'),
    Entry('add_contour', ANY, 'MESH_PLANE'), None, DRAW, THROUGH, CONICS, FORMULAS), 'CURVE_DATA')
ADD_SURFACE = Menu('surface_add', "NURBS", (
    Entry('add_bezier_patch', ANY, 'MESH_GRID'), Entry('add_hermite_patch', ANY, 'SURFACE_NSURFACE'),
    Entry('add_nurbs_patch', ANY, 'SURFACE_DATA'), None,
    Entry('add_plane', ANY, 'MESH_PLANE'), Entry('add_cylinder', ANY, 'MESH_CYLINDER'), Entry('add_cone', ANY, 'MESH_CONE'),
    Entry('add_sphere', ANY, 'MESH_UVSPHERE'), Entry('add_torus', ANY, 'MESH_TORUS'),
    *_from_numbers('FILE_TEXT', 'surface_formula'), *_from_numbers('GRAPH', 'products'), Entry('add_teapot', ANY, 'MESH_UVSPHERE'), None,
    FROM_CURVES, FROM_SURFACES), 'SURFACE_DATA')

#: What menus of Blender's begin with.
TOPS = (OBJECT, NET, ADD_CURVE, ADD_SURFACE)

# In Blender's own menus ---------------------------------------------------------------------------

_DELETED = (Entry('delete_pieces', icon='SURFACE_DATA'),)       # Blender's X takes points away, which a net has to keep
PLACES = (
    Place("VIEW3D_MT_curve_add", (ADD_CURVE,)),
    Place("VIEW3D_MT_surface_add", (ADD_SURFACE,)),
    Place("VIEW3D_MT_object_context_menu", (OBJECT,), 'OBJECT'),
    Place("VIEW3D_MT_object_apply", (Entry('apply_transform', text="Transform of NURBS"),)),
    Place("VIEW3D_MT_object_convert", (
        Entry('make_exact', object_kinds.INEXACT, text="NURBS Shape (Exact)"), Entry('add_of_mesh', MESH, text="NURBS from Mesh"),
        Entry('to_native', text="Blender Curve/Surface from NURBS"))),
    Place("VIEW3D_MT_edit_mesh_vertices", (
        Entry('curve_through_points', ANY, text="NURBS Curve Through Points"),
        Entry('contour_through_points', ANY, text="NURBS Contour Through Points"),
        Entry('fit_curve', ANY, text="Fit NURBS Curve"), Entry('fit_patch', ANY, text="Fit NURBS Patch")), 'OTHERS'),
    Place("VIEW3D_MT_edit_mesh_faces", (Entry('patch_through_grid', ANY, text="NURBS Patch Through Grid"),), 'OTHERS'),
    Place("VIEW3D_MT_editor_menus", (OBJECT,), 'OBJECT', has_line=False, is_header=True),
    Place("VIEW3D_MT_editor_menus", (NET,), 'NETS', has_line=False, is_header=True),
    Place("TOPBAR_MT_file_import", (
        Entry('import_bpt', ANY, text="Bezier Patches (.bpt)"),
        Entry('import_json', ANY, text="Splinewright Exact Curves and Patches (.spw.json)")), has_line=False),
    Place("TOPBAR_MT_file_export", (
        Entry('export_bpt', ANY, text="Bezier Patches (.bpt)"),
        Entry('export_json', ANY, text="Splinewright Exact Curves and Patches (.spw.json)"),
        Entry('export_figure', ANY, text="Figure (.svg, .pdf)")), has_line=False),
    *(Place(f"VIEW3D_MT_edit_{kind}_context_menu", (NET,), 'NETS', is_first=True) for kind in ('mesh', 'curve')),
    *(Place(f"VIEW3D_MT_edit_{kind}_delete", _DELETED, 'NETS', is_first=True) for kind in ('mesh', 'curve')))


def menus_in(menu):
    """A menu and all below it."""
    return [menu, *(below for entry in menu.entries if isinstance(entry, Menu) for below in menus_in(entry))]


def entries_in(menu):
    """The operators in a menu and in all below it."""
    return [entry for below in menus_in(menu) for entry in below.entries if isinstance(entry, (Entry, Native))]


def operators_in(menu):
    """The entries of a menu and of all below it that are operators of Splinewright."""
    return [entry for entry in entries_in(menu) if isinstance(entry, Entry)]


def entry_of(operator):
    """The entry of an operator, of the menus of objects and of nets; one for shapes where it is a tool's and in no menu."""
    return next((entry for top in (NET, OBJECT) for entry in operators_in(top) if entry.operator == operator), Entry(operator))


def _pie(*names):
    return tuple(map(entry_of, names))


#: What is used most in nets, around the mouse: left, right, below, above, and the corners from the upper left one on.
PIE_OF_CURVES = _pie('insert_here', 'weight_here', 'leave_net', 'pull_here', 'raise_degree', 'radius_here', 'split', 'rebuild')
PIE_OF_PATCHES = _pie('insert_here', 'weight_here', 'leave_net', 'pull_here', 'raise_degree', 'make_periodic', 'split', 'rebuild')

#: Each menu once.
MENUS = tuple(dict.fromkeys(below for top in TOPS for below in menus_in(top)))
