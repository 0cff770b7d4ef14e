"""What differs between the Blenders that this runs on: a fact, a name, and from which version on it holds.

Measured on 3.4.1, 4.2.0, 4.2.23, 4.3.0, 4.3.2, 4.4.0, 4.5.0, 4.5.15, 5.0.0, 5.0.1, 5.1.2, 5.2.0, 5.2.2 and 5.2.3; none
between 3.4.1 and 4.2.0 was to be had. tests/blender/test_versions.py measures every one on the Blender it runs in.
"""

from functools import cache

import bpy
import gpu

from ...core.native import native

_VERSION = bpy.app.version

#: Where curves are sampled: 5.0.0 goes by spans, 4.5.15 did not. 4.2.0 to 4.5.15 take a cyclic curve of resolution 1 for
#: its control polygon, 3.4.1 and 5.0.0 do not.
sampling = native.Sampling(by_span=_VERSION >= (5, 0, 0), polygon_at_1=(4, 2, 0) <= _VERSION < (5, 0, 0))

#: From 4.5.0 on, not in 4.4.0: normals may be stored as they are, which costs little, not as 16-bit angles.
keeps_exact_normals = _VERSION >= (4, 5, 0)

#: 3.4.1, not 4.2.0: custom normals show only with a switch of the mesh.
has_auto_smooth = 'use_auto_smooth' in bpy.types.Mesh.bl_rna.properties

#: 3.4.1, not 4.2.0: how many corners each face has must be written, too.
wants_face_totals = not bpy.types.MeshPolygon.bl_rna.properties['loop_total'].is_readonly

#: 4.2.0, not 3.4.1: UV maps are attributes.
uvs_are_attributes = 'uv' in bpy.types.MeshUVLoopLayer.bl_rna.properties

#: 4.2.0, not 3.4.1: what edges and faces have, creases say, are attributes, which are read and written much faster.
marks_are_attributes = 'crease' not in bpy.types.MeshEdge.bl_rna.properties

#: From 4.4.0 on, not in 4.3.2: actions have slots and layers of strips.
actions_have_layers = 'layers' in bpy.types.Action.bl_rna.properties

#: 4.2.0, not 3.4.1: a property may be kept from one call to the next and be in no preset.
has_skip_preset = 'is_skip_preset' in bpy.types.Property.bl_rna.properties

#: 4.2.0, not 3.4.1: files are dropped on windows.
drops_files = hasattr(bpy.types, 'FileHandler')

#: 4.2.0, not 3.4.1: it tells of a save that failed.
tells_of_failed_saves = hasattr(bpy.app.handlers, 'save_post_fail')

#: 4.2.0, not 3.4.1: add-ons that are extensions have folders of their own for what users put there.
has_extension_folders = hasattr(bpy.utils, 'extension_path_user')

#: 4.2.0, not 3.4.1: a window tells which operators are under way in it.
knows_modal_operators = 'modal_operators' in bpy.types.Window.bl_rna.properties


def name():
    """Of this Blender, for people."""
    return bpy.app.version_string


@cache
def point_shader():
    """The name of the shader for points: 5.2.2 has a separate one, 4.3.2 has not. Needs a window."""
    try:
        gpu.shader.from_builtin('POINT_UNIFORM_COLOR')
    except ValueError:
        return 'UNIFORM_COLOR'
    return 'POINT_UNIFORM_COLOR'
