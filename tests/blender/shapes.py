"""Shapes of every kind, and a user's hands on them."""

import bpy
import numpy as np

from support import curve_points, part, splinecore as sc, vertices

live, selection, recipes, shape, starters, form_verbs, knot_verbs, on_shapes = (part(name) for name in (
    'bridge.net.live', 'bridge.net.selection', 'bridge.recipes.recipes', 'bridge.shape.shape', 'core.shape.starters', 'ui.operators.form_verbs',
    'ui.operators.knot_verbs', 'ui.operators.on_shapes'))

RANDOM = np.random.default_rng(12)


def verbs_of(base):
    """Classes of the verbs that take curves (OnCurves), or patches (OnPatches)."""
    return [cls for cls in (*knot_verbs.CLASSES, *form_verbs.CLASSES) if issubclass(cls, (on_shapes.OnShapes, base))]


def names_of(classes):
    return [cls.bl_idname.split('.')[1] for cls in classes]


OF_CURVES, OF_PATCHES = verbs_of(on_shapes.OnCurves), verbs_of(on_shapes.OnPatches)
KINDS = ('nurbs patch', 'teapot', 'mixed set', 'nurbs', 'hermite', 'many curves')


def points(*size):
    """Numbers that float32 does not hold."""
    return RANDOM.uniform(-1, 1, (*size, 3))


def hermite_set():
    u = sc.HermitePatch(*[points(2, 3) for _ in range(4)], parameters=([0, 0.3], [0, 1, 4]))
    return sc.PatchSet.from_patches([u, sc.BezierPatch(points(3, 2))])


CLAMPED = [0, 0, 0, 0, 0.1, 1 / 3, 1, 1, 1, 1]
VALUES = {
    'cubic': lambda: sc.BezierCurve(points(4)),
    'rational cubic': lambda: sc.BezierCurve(points(4), [1, 1 / 3, 0.1, 2]),
    'quintic': lambda: sc.BezierCurve(points(6)),
    'semicircle': lambda: sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0, 1]),
    'hermite': lambda: sc.HermiteCurve(points(4), points(4), [0, 0.1, 1 / 3, 2]),
    'hermite with corners': lambda: sc.HermiteCurve(points(3), points(3, 2)),
    'closed hermite': lambda: starters.hermite_chain(5, True),
    'nurbs': lambda: sc.NurbsCurve(3, CLAMPED, points(6), RANDOM.uniform(0.5, 2, 6)),
    'periodic': lambda: sc.NurbsCurve(3, np.cumsum(np.full(8, 1 / 3)), points(7), periodic=True),
    'many curves': lambda: [sc.BezierCurve(points(4)), sc.NurbsCurve(2, range(8), points(5)),
                            sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0, 1]), sc.HermiteCurve(points(2), points(2))],
    'bezier patch': lambda: sc.BezierPatch(points(3, 4), RANDOM.uniform(0.5, 2, (3, 4))),
    'hermite patch': lambda: sc.HermitePatch(*[points(3, 2) for _ in range(4)], parameters=([0, 0.3, 1], [0, 3])),
    'ferguson': lambda: starters.hermite_patch(3, 3),
    'nurbs patch': lambda: sc.NurbsPatch((3, 2), (CLAMPED, [0, 1, 2, 3, 4]), points(6, 4), periodic=(False, True)),
    'patch with a point at infinity': lambda: sc.BezierPatch(points(3, 2), [[1, 1], [0, 0], [1, 1]]),
    'teapot': lambda: starters.teapot(),
    'mixed set': hermite_set,
}


def add(value, name="shape"):
    """A selected, active shape, after an undo step."""
    ob = bpy.data.objects.new(name, shape.new_data(name, value, (4, 4)))
    bpy.context.scene.collection.objects.link(ob)
    bpy.context.view_layer.update()     # objects that were removed are None until then
    activate(ob)
    bpy.ops.ed.undo_push(message="add")
    return ob


def activate(*obs):
    """Select these and no others; the first is active."""
    for other in bpy.context.selected_objects:
        other.select_set(False)
    for ob in obs:
        ob.select_set(True)
    bpy.context.view_layer.objects.active = obs[0]


def made(kind, *sources, **settings):
    """The object that the operator of a recipe adds, from these objects or from none."""
    if sources:
        activate(*sources)
    assert op(getattr(bpy.ops.splinewright, f"add_{kind}"), **settings) == {'FINISHED'}
    return bpy.context.object


def pieces_named(ob):
    return [piece.name for piece in part('bridge.data.store').read(ob.data).pieces]


def shown(ob):
    if ob.type == 'CURVE':
        return np.concatenate([curve_points(spline) for spline in ob.data.splines])
    return vertices(ob.data)


def require_exact(ob):
    """The mesh or curve is what its definition evaluates to."""
    assert np.array_equal(shown(ob), shape.evaluated(ob.data, shape.store.read(ob.data), recipes.around(ob.data)).points)


def enter():
    assert bpy.ops.splinewright.edit_net('EXEC_DEFAULT', True) == {'FINISHED'}
    return bpy.context.object


def leave():
    assert bpy.ops.splinewright.leave_net('EXEC_DEFAULT', True) == {'FINISHED'}
    return bpy.context.object


def numbers_of(ob):
    return live.session(ob.data).net


def select(ob, *chosen):
    selection.select(ob, numbers_of(ob), chosen)
    bpy.ops.ed.undo_push(message="select")


def move(x, y, z):
    assert bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(x, y, z)) == {'FINISHED'}


def first_point(ob):
    return int(np.flatnonzero(numbers_of(ob).are_points)[0])


def by_hand(ob):
    """Edit the result in its own Edit Mode."""
    bpy.ops.object.mode_set(mode='EDIT')
    if ob.type == 'MESH':
        bpy.ops.mesh.select_all(action='SELECT')
        bpy.ops.transform.resize(value=(1, 1, 3), orient_type='GLOBAL')
        bpy.ops.mesh.subdivide()
    else:
        bpy.ops.curve.select_all(action='SELECT')
        bpy.ops.curve.subdivide()
    bpy.ops.object.mode_set(mode='OBJECT')


def op(operator, **settings):
    return operator('EXEC_DEFAULT', True, **settings)


def world_points(ob):
    bpy.context.view_layer.update()
    matrix = np.array(ob.matrix_world)
    return shown(ob) @ matrix[:3, :3].T + matrix[:3, 3]
