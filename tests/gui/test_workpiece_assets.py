"""A loft as asset: marked, saved, appended to another file with its sections, placed by G, given modifiers, rendered; the sections go on
shaping it where it was put. Linked it is shown, says so in its panel, and Tab leaves it alone. By keys."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from window import View, nets, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
LIBRARY = OUTPUT / "assets-library.blend"
SECTIONS = ("S 0.6 Enter", "G Z 1 Enter", "S 0.4 Enter G Z 2 Enter")
NAMES = []


def picture(name):
    return save_picture(OUTPUT / f"assets-{name}.png")


def loft():
    return next(ob for ob in bpy.data.objects if ob.type == 'MESH' and part('bridge.shape.shape').has_shape(ob))


def seen():
    """The points of the loft in the world."""
    points = np.array([vertex.co for vertex in loft().data.vertices])
    matrix = np.array(loft().matrix_world)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def made(view):
    for transforms in SECTIONS:
        before = len(bpy.data.objects)
        yield from by_keys.add(view, "Curve > NURBS > Circle")
        yield from until(lambda: len(bpy.data.objects) == before + 1, "a circle")
        NAMES.append(bpy.context.object.name)
        yield from by_keys.keys(view, transforms)
    yield from by_keys.select_all(view, 3)
    yield from by_keys.add(view, "Surface > NURBS > Surface from Curves > Loft")
    yield from until(lambda: len(bpy.data.objects) == 4, "a loft")
    NAMES.append(bpy.context.object.name)
    loft().asset_mark()
    with view.override():
        bpy.ops.wm.save_as_mainfile(filepath=str(LIBRARY))
    yield from redrawn()


def bring(how):
    """Steps into another file, to which the loft is appended or linked; then the View of it."""
    bpy.ops.wm.read_homefile(use_factory_startup=False, use_empty=False)
    yield from redrawn()
    view = View()
    with view.override():
        for ob in list(bpy.data.objects):
            bpy.data.objects.remove(ob)
        getattr(bpy.ops.wm, how)('EXEC_DEFAULT', True, filepath=str(LIBRARY / "Object" / NAMES[-1]), filename=NAMES[-1],
                                 directory=str(LIBRARY / "Object"))
    view.move(420, 690)
    yield from until(lambda: NAMES[-1] in bpy.data.objects, f"{how} brings it")
    yield from redrawn()
    return view


def placed(view):
    """G, S and R as of any object."""
    view = yield from bring('append')
    assert loft().library is None and part('bridge.follow.follow').problem(loft().data) == ""
    yield from by_keys.choose(view, NAMES[-1])
    before = seen()
    yield from by_keys.keys(view, "G X 3 Enter")
    yield from until(lambda: np.allclose(seen(), before + (3, 0, 0), atol=1e-5), "G puts it elsewhere")
    yield from by_keys.keys(view, "S 0.5 Enter")
    yield from until(lambda: abs(np.ptp(seen()[:, 2]) - np.ptp(before[:, 2]) / 2) < 1e-5, "S makes it smaller")
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: np.allclose(seen(), before + (3, 0, 0), atol=1e-5), "Ctrl+Z")
    value = loft().data.splinewright.value
    yield from by_keys.choose(view, NAMES[0])
    yield from by_keys.keys(view, "S 1.5 Enter")
    yield from until(lambda: loft().data.splinewright.value != value, "it follows its section where it was put")
    assert abs(seen()[:, 0].mean() - 3) < 0.05
    yield from by_keys.see_all(view)
    picture("placed")


def rendered(view):
    """With modifiers, as any mesh."""
    view = View()
    yield from by_keys.choose(view, NAMES[-1])
    many = len(loft().data.vertices)
    with view.override():
        bpy.ops.object.modifier_add(type='SOLIDIFY')
        loft().modifiers[0].thickness = 0.1
        bpy.ops.object.modifier_add(type='BEVEL')
        bpy.ops.ed.undo_push(message="modifiers")
    yield from redrawn()
    evaluated = loft().evaluated_get(bpy.context.evaluated_depsgraph_get())
    assert len(evaluated.data.vertices) > 2 * many
    picture("modifiers")
    scene = bpy.context.scene
    scene.render.engine = 'BLENDER_WORKBENCH'
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 320, 240, 100
    scene.render.filepath = str(OUTPUT / "assets-rendered.png")
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    scene.camera = camera
    camera.location, camera.rotation_euler = (3, -7, 1), (np.pi / 2, 0, 0)
    with view.override():
        bpy.ops.render.render(write_still=True)
    yield from redrawn()
    image = bpy.data.images.load(scene.render.filepath)
    pixels = np.array(image.pixels).reshape(240, 320, -1)[..., :3]
    assert np.abs(pixels[100:140, 140:180].mean(axis=(0, 1)) - pixels[:20, :20].mean(axis=(0, 1))).max() > 0.03, "it is in the picture"


def linked(view):
    view = yield from bring('link')
    assert loft().library is not None
    yield from by_keys.choose(view, NAMES[-1])
    yield from by_keys.see_all(view)
    yield from by_keys.sidebar(view)
    yield from redrawn()
    picture("linked")
    view.area.spaces.active.show_region_ui = False
    view.move(420, 420)
    yield from redrawn()
    value = loft().data.splinewright.value
    view.press('TAB')
    yield from redrawn()
    yield from redrawn()
    assert not nets() and bpy.context.mode == 'OBJECT' and loft().data.splinewright.value == value
    picture("linked-tab")


run(by_keys.one_by_one(made, placed, rendered, linked))
