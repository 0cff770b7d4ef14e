"""A patch is split, one of its parts the other way: nothing comes open. In the net P takes a part out and X deletes one; a mesh
becomes NURBS, and its panel is whole. Undone, saved, opened."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from window import into_net, nets, out_of_net, part, redrawn, run, save_picture, select_points, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
NAMES = {}
SIDES = ('u_start', 'u_end', 'v_start', 'v_end')


def picture(name):
    return save_picture(OUTPUT / f"apart-{name}.png")


def value():
    return bpy.data.objects[NAMES['patch']].data.splinewright.value


def count():
    found = value()
    return len(found) if isinstance(found, part('core.base.library').sc.PatchSet) else 1


def open_border():
    """The length of all sides that no other patch has."""
    shared = {side for pair in value().seams() for side in pair}
    total = 0.0
    for i in range(len(value())):
        patch = value()[i]
        for side in SIDES:
            if (i, side) not in shared:
                total += patch.isocurve(side[0], patch.domain['uv'.index(side[0])][side.endswith('end')]).length()
    return total


def split(view, **settings):
    with view.override():
        bpy.ops.splinewright.split('INVOKE_DEFAULT', True, **settings)
    yield from redrawn()


def parts(view):
    yield from by_keys.add(view, "Surface > NURBS > NURBS Patch")
    yield from until(lambda: len(bpy.data.objects) == 1, "a patch")
    NAMES['patch'] = bpy.context.object.name
    (u0, u1), (v0, v1) = value().domain
    yield from split(view, direction='U', parameter_u=0.4 * u0 + 0.6 * u1)
    assert count() == 2
    before = open_border()
    yield from split(view, piece=1, direction='V', parameter_v=0.5 * (v0 + v1))
    assert count() >= 3 and abs(open_border() - before) < 1e-9
    with view.override():
        bpy.ops.view3d.view_all(center=False)
    yield from redrawn()
    picture("split")


def inner_points(number):
    """Of a part in the net, the points that no other part has."""
    net = part('bridge.net.live').session(nets()[0].data).net
    pieces = net.definition.pieces
    used = [set(each.indices.ravel().tolist()) for each in pieces]
    rows = used[number].difference(*used[:number], *used[number + 1:])
    return [vertex for vertex, row in enumerate(net.rows) if int(row) in rows]


def taken(view):
    """P makes a shape of a part, and Ctrl+Z puts it back; X, and the top of its menu, deletes one."""
    before, many = value(), count()
    view.press('TAB')
    yield from into_net()
    view.move(420, 420)
    select_points(*inner_points(0))
    yield from redrawn()
    view.press('P')
    yield from until(lambda: len(list(filter(part('bridge.shape.shape').has_shape, bpy.data.objects))) == 2, "P takes a part out")
    assert count() == many - 1
    yield from redrawn()
    picture("taken")
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: count() == many and value() == before, "Ctrl+Z puts it back")
    if not nets():
        view.press('TAB')
    yield from into_net()
    select_points(*inner_points(0))
    yield from redrawn()
    view.press('X')
    yield from redrawn()
    picture("menu")
    for key in ('HOME', 'RET'):
        view.press(key)
        yield from redrawn()
    yield from until(lambda: count() == many - 1, "X deletes a part")
    if nets():
        view.press('TAB')
        yield from out_of_net()
    assert len(bpy.data.objects) == 1
    picture("deleted")


def of_mesh(view):
    with view.override():
        bpy.ops.mesh.primitive_cube_add('EXEC_DEFAULT', True, location=(4, 0, 0))
        bpy.ops.splinewright.add_of_mesh('INVOKE_DEFAULT', True)
    yield from until(lambda: "Cube NURBS" in bpy.data.objects, "a shape of the mesh")
    assert part('bridge.recipes.recipes').kind(bpy.context.object.data) == 'of_mesh'
    with view.override():
        bpy.ops.view3d.view_all(center=False)
    view.open_sidebar()
    yield from redrawn()
    yield from view.show_tab("NURBS", (1045, 538))
    picture("mesh")
    view.area.spaces.active.show_region_ui = False
    yield from redrawn()


def kept(view):
    before = value()
    yield from by_keys.saved_and_opened(view, OUTPUT / "apart.blend")
    assert value() == before


run(by_keys.one_by_one(parts, taken, of_mesh, kept))
