"""The toolbar without those of Blender's tools that mean nothing for a net, while all that is edited are nets."""

from bl_ui.space_toolsystem_toolbar import VIEW3D_PT_tools_active

from . import editing

#: They take faces and edges apart, or add others than rows.
_MEANINGLESS = {f"builtin.{name}" for name in (
    'primitive_cube_add', 'primitive_cone_add', 'primitive_cylinder_add', 'primitive_uv_sphere_add', 'primitive_ico_sphere_add',
    'extrude_manifold', 'extrude_along_normals', 'extrude_individual', 'inset_faces', 'bevel', 'offset_edge_loop_cut', 'knife', 'bisect',
    'poly_build', 'spin', 'spin_duplicates', 'rip_region', 'rip_edge')}
_NAME = 'tools_from_context'
#: What Blender's class has in place of ours, while ours is there.
_blenders = ()


def meaningful(context, items):
    """Of tools, groups of tools in tuples and None for gaps those that mean something for nets, and the one in use."""
    active = context.workspace.tools.from_space_view3d_mode('EDIT_MESH', create=False) if context.workspace else None
    hidden = _MEANINGLESS - {active.idname if active else ""}
    is_gap = True
    for item in items:
        group = item if type(item) is tuple else (item,)
        kept = tuple(tool for tool in group if getattr(tool, 'idname', None) not in hidden)
        if kept and not (kept == (None,) and is_gap):
            is_gap = kept == (None,)
            yield kept if type(item) is tuple and len(kept) > 1 else kept[0]


def _is_of_nets(context, mode):
    edited = editing.nets_in_edit_mode(context) if mode == 'EDIT_MESH' else []
    return bool(edited) and len(edited) == len(context.objects_in_mode)


def _tools_from_context(cls, context, mode=None):
    items = _blenders[0].__func__(cls, context, mode)
    return meaningful(context, items) if _is_of_nets(context, mode or context.mode) else items


_ours = classmethod(_tools_from_context)
CLASSES = ()


def register():
    global _blenders
    if not _blenders:
        _blenders = vars(VIEW3D_PT_tools_active)[_NAME],
        setattr(VIEW3D_PT_tools_active, _NAME, _ours)


def unregister():
    """Where another add-on has put its own over ours, and calls that, it stays."""
    global _blenders
    if vars(VIEW3D_PT_tools_active)[_NAME] is _ours:
        setattr(VIEW3D_PT_tools_active, _NAME, *_blenders)
        _blenders = ()
