"""A user edits a shape by keys and mouse; state and picture are looked at after every step."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import (View, empty_file, into_net, mean_difference, nets, out_of_net, part, pick_by_keys, redrawn, run,
                    save_picture, select_points, until)

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
NAME = "NURBS Patch"


class Look:
    """What is to be seen and what is so, at one moment."""

    def __init__(self, name):
        self.picture = save_picture(OUTPUT / f"{name}.png")[:, :830]     # left of the sidebar
        ob = bpy.data.objects.get(NAME)
        self.value = ob.data.splinewright.value if ob else None
        self.nets = nets()
        self.mode = bpy.context.mode
        assert len(np.unique(self.picture.reshape(-1, 3), axis=0)) > 50, f"{name}.png is empty"
        if ob:
            self._require_exact(ob, name)
        print(f"{name:24} {self.mode:10} nets {len(self.nets)}", flush=True)

    @staticmethod
    def _require_exact(ob, name):
        shape, store = part('bridge.shape.shape'), part('bridge.data.store')
        expected = shape.evaluated(ob.data, store.read(ob.data)).points
        assert np.array_equal(shape.points_of(ob.data), expected), f"{name}: the mesh is not its definition"
        assert not shape.is_touched(ob.data), name

    def height(self, row):
        return self.value.points.reshape(-1, 3)[row, 2]

    def is_in_net(self):
        return len(self.nets) == 1 and self.mode == 'EDIT_MESH' and self.nets[0].mode == 'EDIT'

    def is_out(self):
        return not self.nets and self.mode == 'OBJECT'

    def differs_from(self, other):
        return mean_difference(self.picture, other.picture) > 0.5


def value():
    return bpy.data.objects[NAME].data.splinewright.value


def at_rest():
    """Steps until what was pressed is done, and the shape shown exactly."""
    yield from redrawn()
    store = part('bridge.data.store')
    yield from until(lambda: NAME not in bpy.data.objects or not store.is_draft(bpy.data.objects[NAME].data),
                     "exact normals")
    yield from redrawn()


def climb(view, name, redo, is_there):
    """Press Ctrl+Z, or Shift+Ctrl+Z, until it is there; what was seen at each rung."""
    seen = []
    for i in range(20):
        view.press('Z', ctrl=True, shift=redo)
        yield from at_rest()
        seen.append(Look(f"{name}-{i}"))
        if is_there(seen[-1]):
            return seen
    raise AssertionError(f"{name}: not there after {len(seen)} times")


def distinct(looks):
    """Without those that show the same as the one before."""
    return [look for before, look in zip([None, *looks], looks)
            if before is None or (look.value, look.is_out()) != (before.value, before.is_out())]


def steps():
    view = View()
    empty_file()
    part('ui.preferences').get().surface_mode = 'COUNT'     # automatic faces stay while points are dragged
    view.open_sidebar()
    view.move(420, 690)                 # the menu must fit below
    yield from redrawn()
    empty = Look("edit-0-empty")

    # Shift+A > Surface > NURBS > NURBS Patch
    view.press('A', shift=True)
    yield from redrawn()
    from_first_entry = 2 if bpy.app.version < (4, 0, 0) else 3          # later ones begin with Search
    into_ours = ['RIGHT_ARROW', 'UP_ARROW', 'RIGHT_ARROW']
    yield from pick_by_keys(view, ['DOWN_ARROW'] * from_first_entry + into_ours + ['DOWN_ARROW'] * 2)
    save_picture(OUTPUT / "edit-1-menu.png")
    view.press('RET')
    yield from until(lambda: NAME in bpy.data.objects, "Shift+A adds a patch")
    assert bpy.context.object.name == NAME
    with view.override():
        bpy.ops.view3d.view_selected()
    yield from redrawn()
    added = Look("edit-1-added")
    assert added.is_out() and added.differs_from(empty)

    view.move(420, 420)
    view.press('TAB')
    yield from into_net()
    entered = Look("edit-2-tab")
    assert entered.is_in_net() and entered.value == added.value and entered.differs_from(added)
    yield from view.show_tab("NURBS", (1045, 538))
    view.move(420, 420)
    yield from redrawn()

    # G, a drag that the shape follows at every move, a click
    with view.override():
        select_points(14, 15, 20, 21)
    yield from redrawn()
    view.press('G')
    yield from redrawn()
    for _ in range(5):
        before = value()
        view.move(y=view.y + 14)
        yield from until(lambda: value() != before, "the shape follows every move")
        Look("edit-3-dragging")
    view.press('LEFTMOUSE')
    yield from at_rest()
    dragged = Look("edit-3-dragged")
    assert dragged.is_in_net() and dragged.value != entered.value and dragged.differs_from(entered)

    # G, Z, a number, Enter
    view.press('G')
    yield from redrawn()
    for key in ('Z', 'ONE', 'RET'):
        view.press(key, **({'text': '1'} if key == 'ONE' else {}))
        yield from redrawn()
    yield from at_rest()
    typed = Look("edit-4-typed")
    assert abs(typed.height(14) - dragged.height(14) - 1) < 1e-6, (typed.height(14), dragged.height(14))
    assert typed.height(0) == added.height(0), "a point that was not moved lost digits"

    # G, a drag, Esc
    view.press('G')
    yield from redrawn()
    view.move(y=view.y + 60)
    yield from until(lambda: value() != typed.value, "the shape follows until Esc")
    Look("edit-5-before-escape")
    view.press('ESC')
    yield from until(lambda: value() == typed.value, "Esc takes the drag back")
    yield from at_rest()
    escaped = Look("edit-5-escaped")
    assert escaped.value == typed.value and escaped.is_in_net()

    # Proportional editing, by its key, with a circle that reaches other points
    bpy.context.scene.tool_settings.proportional_size = 4
    view.press('O')
    yield from redrawn()
    view.press('G')
    yield from redrawn()
    view.move(y=view.y + 40)
    yield from until(lambda: value() != escaped.value, "the shape follows proportional editing")
    view.press('LEFTMOUSE')
    yield from at_rest()
    proportional = Look("edit-6-proportional")
    moved = (proportional.value.points != escaped.value.points).any(-1)
    assert moved.sum() > 4, "proportional editing moved the selected points only"
    view.press('O')
    yield from redrawn()

    view.press('TAB')
    yield from out_of_net()
    left = Look("edit-7-left")
    assert left.is_out() and left.value == proportional.value and bpy.context.object.name == NAME

    # Some steps change nothing of the shape: the selection, the key O.
    down = yield from climb(view, "edit-8-undo", False, lambda look: look.is_out() and look.value == added.value)
    expected = [left, proportional, typed, dragged, entered, added]
    assert [(look.value, look.is_out()) for look in distinct([left, *down])] == [
        (look.value, look.is_out()) for look in expected], "undo goes another way back"
    up = yield from climb(view, "edit-9-redo", True, lambda look: look.is_out() and look.value == left.value)
    assert [(look.value, look.is_out()) for look in distinct([down[-1], *up])] == [
        (look.value, look.is_out()) for look in expected[::-1]], "redo goes another way"
    assert not up[-1].differs_from(left), "the picture after undo and redo is another"

    # Tab lets other objects alone
    with view.override():
        bpy.ops.mesh.primitive_cube_add()
    yield from redrawn()
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'EDIT_MESH', "Tab enters the cube")
    assert bpy.context.object.name.startswith("Cube") and not Look("edit-10-cube").nets
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'OBJECT', "Tab leaves the cube")
    print("editing did what it should:", bpy.app.version_string, flush=True)


run(steps())
