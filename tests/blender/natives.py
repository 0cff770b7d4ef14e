"""Blender's own curves and surfaces, both operators on them, and what is drawn."""

import bpy

CURVES = ('primitive_bezier_curve_add', 'primitive_bezier_circle_add', 'primitive_nurbs_curve_add',
          'primitive_nurbs_circle_add', 'primitive_nurbs_path_add')
SURFACES = ('primitive_nurbs_surface_surface_add', 'primitive_nurbs_surface_cylinder_add',
            'primitive_nurbs_surface_sphere_add', 'primitive_nurbs_surface_torus_add')


def native_curve(name='primitive_nurbs_path_add'):
    getattr(bpy.ops.curve, name)()
    return bpy.context.object


def native_surface(name='primitive_nurbs_surface_torus_add'):
    getattr(bpy.ops.surface, name)()
    return bpy.context.object


def all_natives():
    return [native_curve(name) for name in CURVES] + [native_surface(name) for name in SURFACES]


def select(*objects):
    bpy.context.view_layer.update()
    for ob in bpy.context.view_layer.objects:
        if ob:
            ob.select_set(ob in objects)
    bpy.context.view_layer.objects.active = objects[-1] if objects else None


def exact(*objects):
    select(*objects)
    assert bpy.ops.splinewright.make_exact() == {'FINISHED'}


def native(*objects):
    select(*objects)
    assert bpy.ops.splinewright.to_native() == {'FINISHED'}


def drawn(ob):
    """A copy of the mesh that Blender evaluates, in the space of the object."""
    bpy.context.view_layer.update()
    return bpy.data.meshes.new_from_object(ob.evaluated_get(bpy.context.evaluated_depsgraph_get()))


def material(name):
    return bpy.data.materials.get(name) or bpy.data.materials.new(name)
