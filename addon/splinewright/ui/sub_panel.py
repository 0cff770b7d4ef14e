"""What the panels below the shape's own in the sidebar have in common."""


class SubPanel:
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'UI'
    bl_category = "NURBS"
    bl_parent_id = "SPLINEWRIGHT_PT_shape"
    bl_options = {'DEFAULT_CLOSED'}
