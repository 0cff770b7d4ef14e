"""Render and play animations from a real window, with and without Lock Interface: what follows and what is keyed is right
in every frame, and nothing is written in another thread while the window draws."""

import os
import sys
import threading
import time
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, part, redrawn, run, until

errands, handlers, shape, texts = (part(name) for name in (
    'ui.main_thread', 'ui.handlers', 'bridge.shape.shape', 'ui.texts'))
FOLDER = Path(os.environ['SPLINEWRIGHT_OUTPUT']) / "frames"
FRAMES = (2, 5, 8, 11)
#: Rows of the picture, 16 units high, in which what follows a place, what is keyed and what follows that lie.
ROWS = {"mover": slice(11, 15), "plane": slice(6, 10), "again": slice(1, 5)}
in_main = []


def expected(frame):
    """The shares of their rows that they cover: one goes out of the picture to the right, the others grow."""
    return 1 - (frame - 1) / 16, frame / 16, frame / 16


def keys(owner, name, values, index=-1):
    for frame, value in values.items():
        if index < 0:
            setattr(owner, name, value)
        else:
            getattr(owner, name)[index] = value
        owner.keyframe_insert(name, frame=frame, index=index)
    action = owner.id_data.animation_data.action
    curves = action.fcurves if hasattr(action, 'fcurves') else action.layers[0].strips[0].channelbags[0].fcurves
    for curve in curves:
        for point in curve.keyframe_points:
            point.interpolation = 'LINEAR'


def plane(name, width, y, x=0.0):
    bpy.ops.splinewright.add_plane(width=width, depth=4, location=(x, y, 0))
    bpy.context.object.name = name
    return bpy.context.object


def follow(source, name):
    bpy.ops.splinewright.follow_object()
    bpy.context.object.name, source.hide_render = name, True
    return bpy.context.object


def make_scene():
    source = plane("source", 32, 5, 8)
    keys(source, 'location', {1: 8.0, 201: 208.0}, 0)
    bpy.context.scene.frame_set(1)
    follow(source, "mover")
    for name, y in (("plane", 0), ("grower", -5)):
        keys(plane(name, 1, y).data.splinewright_parameters, 'plane_width', {1: 1.0, 201: 201.0})
    again = follow(bpy.data.objects["grower"], "again")
    again.data.splinewright.mode = 'COUNT'
    keys(again.data.splinewright, 'resolution_u', {1: 1, 201: 201})
    scene = bpy.context.scene
    scene.camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(scene.camera)
    scene.camera.data.type, scene.camera.data.ortho_scale, scene.camera.location.z = 'ORTHO', 16, 50
    render = scene.render
    render.engine, render.resolution_x, render.resolution_y = 'BLENDER_WORKBENCH', 16, 16
    scene.display.render_aa = 'OFF'
    render.film_transparent, render.image_settings.color_mode = True, 'RGBA'
    scene.frame_start, scene.frame_end, scene.frame_step = FRAMES[0], FRAMES[-1], FRAMES[1] - FRAMES[0]
    bpy.context.preferences.view.render_display_type = 'NONE'


def covered(path):
    """The share of its rows that each shape covers in a picture."""
    image = bpy.data.images.load(str(path))
    alpha = np.array(image.pixels).reshape(16, 16, 4)[..., 3]
    bpy.data.images.remove(image)
    return tuple(float(alpha[rows].mean()) for rows in ROWS.values())


def note_threads():
    """Have every write of a shape say whether it is done in the main thread."""
    finish = shape._finish

    def noted(*arguments):
        in_main.append(threading.current_thread() is threading.main_thread())
        finish(*arguments)
    shape._finish = noted


def is_over():
    return not bpy.app.is_job_running('RENDER') and not errands.is_away()


def rendered(view, name, is_locked):
    """Steps through the render of an animation, all frames of which must be right."""
    scene = bpy.context.scene
    scene.render.use_lock_interface, scene.render.filepath = is_locked, str(FOLDER / name)
    scene.frame_set(4)
    in_main.clear()
    with view.override():
        assert bpy.ops.render.render('INVOKE_DEFAULT', animation=True) == {'RUNNING_MODAL'}
    yield from until(is_over, "the end of a render")
    for frame in FRAMES:
        found = covered(f"{scene.render.filepath}{frame:04}.png")
        assert np.allclose(found, expected(frame), atol=0.01), (name, frame, found, expected(frame))
    assert in_main and (is_locked or all(in_main)), "a shape was written in the thread of the render"
    assert part('ui.ui_state').ui_state.missed == 0
    require_views_at(4)


def require_views_at(frame):
    """The shapes are as the frame at hand wants them."""
    assert bpy.context.scene.frame_current == frame
    graph = bpy.context.evaluated_depsgraph_get()
    found = []
    for name in ROWS:
        ob = bpy.data.objects[name].evaluated_get(graph)
        across = [(ob.matrix_world @ vertex.co).x for vertex in ob.data.vertices]
        found.append((min(across), max(across)))
    assert np.allclose(found, [(frame - 9, frame + 23), (-frame / 2, frame / 2), (-frame / 2, frame / 2)], atol=1e-4), found
    assert bpy.data.objects["again"].data.splinewright.resolution_u == frame
    again = bpy.data.objects["again"].data
    assert len(again.vertices) == (frame + 1) * (1 + again.splinewright.resolution_v)


def a_still(view):
    """Steps through a still, and what follows after it."""
    scene = bpy.context.scene
    scene.frame_set(7)
    scene.render.filepath = str(FOLDER / "still.png")
    with view.override():
        bpy.ops.render.render('INVOKE_DEFAULT', write_still=True)
    yield from until(is_over, "the end of a still")
    assert np.allclose(covered(scene.render.filepath), expected(7), atol=0.01)
    require_views_at(7)
    bpy.data.objects["mover"].scale.y = 2
    bpy.data.objects["grower"].data.splinewright_parameters.plane_depth = 2
    again = bpy.data.objects["again"].data
    yield from until(lambda: np.isclose(max(vertex.co.y for vertex in again.vertices), 1), "what follows after a render")


def a_main_thread_that_does_not_answer(view):
    """Steps through a render that waits for it in vain: once, and the window says so."""
    told = []
    pop_up, texts.pop_up = texts.pop_up, lambda text: (told.append(text), pop_up(text))
    patience, errands._PATIENCE = errands._PATIENCE, 1.0
    serve, errands.serve = errands.serve, lambda come_back: 0.01
    in_main.clear()
    begin = time.monotonic()
    with view.override():
        bpy.ops.render.render('INVOKE_DEFAULT', animation=True)
    yield from until(lambda: bpy.app.is_job_running('RENDER'), "a render")
    yield from until(lambda: not bpy.app.is_job_running('RENDER'), "the end of a render")
    assert part('ui.ui_state').ui_state.missed == len(FRAMES) and time.monotonic() - begin < 30
    assert all(in_main)
    errands.serve, errands._PATIENCE = serve, patience
    yield from until(lambda: told, "a popup that says which frames are wrong")
    texts.pop_up = pop_up
    assert "Lock Interface" in told[0]
    assert part('ui.ui_state').ui_state.missed == 0
    view.press('ESC')
    yield from redrawn()


def played(view):
    """Steps through an animation that is played."""
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end, scene.frame_step = 1, 200, 1
    scene.frame_set(1)
    with view.override():
        bpy.ops.screen.animation_play()
    yield from until(lambda: scene.frame_current > 40, "frames that are played")
    with view.override():
        bpy.ops.screen.animation_cancel(restore_frame=False)
    yield from redrawn()
    require_views_at(scene.frame_current)


def steps():
    view = View()
    with view.override():
        empty_file()
        make_scene()
    yield from redrawn()
    note_threads()
    yield from rendered(view, "open", is_locked=False)
    yield from rendered(view, "locked", is_locked=True)
    yield from rendered(view, "open again", is_locked=False)
    yield from a_still(view)
    yield from a_main_thread_that_does_not_answer(view)
    yield from played(view)
    print("renders from the window are right:", bpy.app.version_string, flush=True)


run(steps())
