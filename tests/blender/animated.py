"""What moves from frame to frame, and pictures of it."""

import bpy
import numpy as np

from shapes import activate


def in_scene(name, data, scene=None):
    """An object of a scene, active where that is the one at hand."""
    ob = bpy.data.objects.new(name, data)
    (scene or bpy.context.scene).collection.objects.link(ob)
    bpy.context.view_layer.update()
    if scene in (None, bpy.context.scene):
        activate(ob)
    return ob


def curves_of(action):
    if hasattr(action, 'fcurves'):
        return action.fcurves
    return [curve for bag in action.layers[0].strips[0].channelbags for curve in bag.fcurves]


def animate(owner, path, values, index=-1):
    """Keys {frame: value} of a property, straight between them."""
    holder, _, name = path.rpartition('.')
    target = owner.path_resolve(holder) if holder else owner
    for frame, value in values.items():
        if index < 0:
            setattr(target, name, value)
        else:
            getattr(target, name)[index] = value
        assert target.keyframe_insert(name, frame=frame, index=index)
    for curve in curves_of(owner.animation_data.action):
        for point in curve.keyframe_points:
            point.interpolation = 'LINEAR'


def rise(ob):
    """Let an object be at z = frame - 1."""
    animate(ob, 'location', {1: 0.0, 101: 100.0}, index=2)


def native_path():
    """Blender's own curve from (-2, 0) to (2, 0)."""
    bpy.ops.curve.primitive_nurbs_path_add()
    return bpy.context.object


def follow_object(ob):
    activate(ob)
    assert bpy.ops.splinewright.follow_object('EXEC_DEFAULT', True) == {'FINISHED'}
    return bpy.context.object


def evaluated(ob, depsgraph=None):
    """(n, 3): the points that a depsgraph shows of a Curve or Mesh object, in its own space, with its shape keys."""
    depsgraph = depsgraph or bpy.context.evaluated_depsgraph_get()
    shown = ob.evaluated_get(depsgraph)
    if ob.type == 'MESH':
        return np.array([vertex.co for vertex in shown.data.vertices])
    splines = shown.to_curve(depsgraph, apply_modifiers=True).splines
    points = np.array([point.co[:3] for spline in splines for point in spline.points])
    shown.to_curve_clear()
    return points


def height(ob, depsgraph=None):
    return float(evaluated(ob, depsgraph)[:, 2].mean())


class Frames:
    """Keeps what every frame of a render shows, as `look(depsgraph)` gives it, while it is in a with statement.

    It looks when everything is evaluated: a render engine of its own is what sees it.
    """

    def __init__(self, look):
        self.look, self.seen = look, {}

    def __enter__(self):
        frames = self

        class Engine(bpy.types.RenderEngine):
            bl_idname, bl_label = 'SPLINEWRIGHT_TEST', "Test"

            def render(self, depsgraph):
                frames.seen.setdefault(depsgraph.scene.frame_current, []).append(frames.look(depsgraph))

        self.engine = Engine
        bpy.utils.register_class(Engine)
        return self

    def __exit__(self, *_):
        bpy.utils.unregister_class(self.engine)


def rendered(look, frames, scene=None):
    """{frame: [look(depsgraph) for each view layer]} of an animation that is rendered."""
    scene = scene or bpy.context.scene
    if scene.camera is None:
        camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
        scene.collection.objects.link(camera)
        scene.camera = camera
    scene.frame_start, scene.frame_end, scene.frame_step = frames[0], frames[-1], max(1, frames[1] - frames[0])
    scene.render.resolution_x = scene.render.resolution_y = 8
    with Frames(look) as seen:
        scene.render.engine = 'SPLINEWRIGHT_TEST'
        scene.render.filepath = bpy.app.tempdir + "frame"
        bpy.ops.render.render(animation=True, scene=scene.name)
        scene.render.engine = 'BLENDER_WORKBENCH'
    return seen.seen


def in_cycles(scene):
    scene.render.engine = 'CYCLES'
    scene.cycles.device, scene.cycles.samples, scene.cycles.use_denoising = 'CPU', 1, False


def coverage(folder, frames):
    """The share of each frame's picture, of the square from -1 to 1 as it is seen from above, that is not transparent."""
    scene = bpy.context.scene
    scene.camera = in_scene("camera", bpy.data.cameras.new("camera"))
    scene.camera.data.type, scene.camera.data.ortho_scale, scene.camera.location.z = 'ORTHO', 2, 50
    scene.render.film_transparent = True
    scene.render.resolution_x = scene.render.resolution_y = 16
    scene.render.image_settings.color_mode = 'RGBA'
    scene.frame_start, scene.frame_end, scene.frame_step = frames[0], frames[-1], frames[1] - frames[0]
    scene.render.filepath = str(folder / "frame")
    bpy.ops.render.render(animation=True)
    shares = []
    for frame in frames:
        image = bpy.data.images.load(str(folder / f"frame{frame:04}.png"))
        shares.append(np.array(image.pixels).reshape(-1, 4)[:, 3].mean())
    return shares
