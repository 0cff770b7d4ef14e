"""What the panels of the sidebar have in common."""


class SidePanel:
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'UI'
    bl_category = "NURBS"


class ClosedPanel(SidePanel):
    bl_options = {'DEFAULT_CLOSED'}


class SubPanel(ClosedPanel):
    """Below the shape's own."""

    bl_parent_id = "SPLINEWRIGHT_PT_shape"
