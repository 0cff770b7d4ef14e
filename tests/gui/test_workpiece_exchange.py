"""What comes in and goes out: an SVG drawing is made exact and changed in its net, Suzanne becomes NURBS that are moved and made
editable, and both go out as JSON and come in again with every digit. Undone, saved, opened."""

import os
import sys
import tempfile
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from window import into_net, nets, out_of_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
FOLDER = Path(tempfile.mkdtemp())
#: Two closed outlines with arcs and one of straight lines, 200 mm wide.
DRAWING = """<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100">
<path d="M 10 10 L 90 10 C 110 10 110 90 90 90 L 10 90 Z" fill="#c04020"/>
<path d="M 30 30 L 70 30 L 70 70 L 30 70 Z" fill="#204080"/>
<circle cx="150" cy="50" r="40" fill="#208040"/>
</svg>"""
NAMES = {}


def picture(name):
    return save_picture(OUTPUT / f"exchange-{name}.png")


def value(name):
    return bpy.data.objects[NAMES[name]].data.splinewright.value


def curves_of(ob):
    found = ob.data.splinewright.value
    return found if isinstance(found, list) else [found]


def has_shape(ob):
    return part('bridge.shape.shape').has_shape(ob)


def drawing(view):
    """An SVG file, imported by Blender, and made exact by F3: as long as it was, of the same materials."""
    path = FOLDER / "drawing.svg"
    path.write_text(DRAWING)
    with view.override():
        bpy.ops.import_curve.svg('EXEC_DEFAULT', True, filepath=str(path))
        bpy.ops.ed.undo_push(message="drawing")
    yield from until(lambda: len(bpy.data.objects) == 3, "what is drawn")
    obs = list(bpy.data.objects)
    materials = {ob.name: [slot.name for slot in ob.data.materials] for ob in obs}
    wide = np.ptp([(ob.matrix_world @ point.co)[0] for ob in obs for spline in ob.data.splines for point in spline.bezier_points])
    yield from by_keys.choose(view, *(ob.name for ob in obs))
    yield from by_keys.see_all(view)
    picture("drawing")
    yield from by_keys.search(view, "convert to splinewright")
    yield from until(lambda: sum(map(has_shape, bpy.data.objects)) == 3, "F3 finds Convert to Splinewright")
    made = [ob for ob in bpy.data.objects if has_shape(ob)]
    assert {ob.name: [slot.name for slot in ob.data.materials] for ob in made} == materials
    ends = [(curve.evaluate(curve.domain[0]), curve.evaluate(curve.domain[1])) for ob in made for curve in curves_of(ob)]
    assert all(np.allclose(*pair, atol=1e-7) for pair in ends), "what was closed is closed"
    where = np.concatenate([np.asarray(curve.points) for ob in made for curve in curves_of(ob)])
    assert abs(np.ptp(where[:, 0]) - wide) < 0.2 * wide and part('bridge.data.store')
    NAMES['outline'] = max(made, key=lambda ob: sum(curve.length() for curve in curves_of(ob))).name


def redrawn_in_net(view):
    """The outline by numbers in its net."""
    before = bpy.data.objects[NAMES['outline']].data.splinewright.value
    yield from by_keys.choose(view, NAMES['outline'])
    view.press('TAB')
    yield from into_net()
    view.press('A')
    yield from redrawn()
    yield from by_keys.keys(view, "S X 1.2 Enter")
    yield from until(lambda: value('outline') != before, "the outline follows its net")
    picture("net")
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: value('outline') == before, "Ctrl+Z")
    view.press('TAB')
    yield from out_of_net()


def of_mesh(view):
    """Any mesh: its panel is whole, G moves what is made, and Apply Construction lets it go."""
    with view.override():
        bpy.ops.mesh.primitive_monkey_add('EXEC_DEFAULT', True, size=0.2, location=(0.1, 0.3, 0))
        NAMES['mesh'] = bpy.context.object.name
        bpy.ops.ed.undo_push(message="mesh")
    yield from by_keys.search(view, "nurbs from mesh")
    yield from until(lambda: bpy.context.object.name != NAMES['mesh'], "F3 finds NURBS from Mesh")
    NAMES['made'] = bpy.context.object.name
    assert part('bridge.recipes.recipes').kind(bpy.context.object.data) == 'of_mesh' and len(value('made')) > 100
    yield from by_keys.see_all(view)
    yield from by_keys.sidebar(view)
    picture("mesh")
    view.area.spaces.active.show_region_ui = False
    view.move(420, 420)
    yield from redrawn()
    yield from by_keys.keys(view, "G X 0.4 Enter")
    yield from until(lambda: abs(bpy.context.object.matrix_world.translation.x - 0.5) < 1e-5, "G moves it")
    yield from by_keys.search(view, "apply construction")
    yield from until(lambda: not part('bridge.recipes.recipes').kind(bpy.context.object.data), "F3 finds Apply Construction")


def out_and_in(view):
    """All shapes as JSON: what comes back is the same in every digit."""
    path = FOLDER / "out.json"
    yield from by_keys.choose(view, NAMES['made'], NAMES['outline'])
    before = {name: value(name) for name in ('made', 'outline')}
    known = set(bpy.data.objects.keys())
    with view.override():
        bpy.ops.splinewright.export_json('EXEC_DEFAULT', True, filepath=str(path))
        bpy.ops.splinewright.import_json('EXEC_DEFAULT', True, filepath=str(path))
    yield from until(lambda: len(bpy.data.objects) > len(known), "what comes in")
    def dumps(found):           # what comes in of curves is a list
        return part('core.base.library').sc.dumps(found[0] if isinstance(found, list) else found)
    came = {dumps(ob.data.splinewright.value) for ob in bpy.data.objects if ob.name not in known}
    assert came == {dumps(was) for was in before.values()}, [len(text) for text in came]
    yield from by_keys.see_all(view)
    picture("back")
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: set(bpy.data.objects.keys()) == known, "Ctrl+Z takes them away")


def kept(view):
    before = {name: value(name) for name in ('made', 'outline')}
    yield from by_keys.saved_and_opened(view, OUTPUT / "exchange.blend")
    assert all(value(name) == was for name, was in before.items()) and not nets()
    picture("opened")


run(by_keys.one_by_one(drawing, redrawn_in_net, of_mesh, out_and_in, kept))
