"""The preferences in a window: all of them are drawn, and a key that a user changes stays changed in the next Blender."""

import os
import subprocess
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import ADDON, View, empty_file, into_net, out_of_net, part, redrawn, run, save_picture, until, user_item

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])

NEXT = """
import importlib, os, sys
import bpy
keymaps = importlib.import_module(sys.argv[-1] + '.ui.keymaps')
def tick():
    found = {operator: (item.type, item.active) for _, item, operator in keymaps.of_user()}
    print("NEXT", found["splinewright.edit_net"], found["splinewright.leave_net"], flush=True)
    os._exit(0)
bpy.app.timers.register(tick, first_interval=1.0)
"""


def steps():
    view = View()
    empty_file()
    trouble, preferences = [], part('ui.preferences').SplinewrightPreferences
    draw = preferences.draw

    def watched(self, context):
        try:
            draw(self, context)
        except Exception as error:
            trouble.append(repr(error))
            raise
        trouble.append("")
    preferences.draw = watched

    view.beside('PREFERENCES')
    bpy.context.preferences.active_section = 'ADDONS'
    bpy.context.window_manager.addon_search = "Splinewright"
    yield from redrawn()
    bpy.ops.preferences.addon_expand(module=ADDON)
    yield from redrawn()
    yield from until(lambda: trouble, "the preferences are drawn")
    save_picture(OUTPUT / "preferences.png")
    part('ui.preferences').get().use_theme = False
    part('ui.preferences').get().surface_mode = 'BOTH'
    trouble.clear()
    yield from redrawn()
    yield from until(lambda: trouble, "the preferences are drawn anew")
    save_picture(OUTPUT / "preferences-own.png")
    assert not any(trouble), trouble

    with view.override():
        assert bpy.ops.splinewright.self_test('INVOKE_DEFAULT') == {'FINISHED'}
    yield from redrawn()
    save_picture(OUTPUT / "self-test.png")
    view.move(view.region.x + view.region.width // 2, view.region.y + 5)
    yield from redrawn()
    view.press('ESC')                   # where moving away has not closed it
    yield from redrawn()
    assert "Results, bit for bit" in bpy.context.window_manager.clipboard
    with view.override():
        bpy.ops.splinewright.add_nurbs_patch('EXEC_DEFAULT', True)
    user_item("splinewright.edit_net").type = 'F6'
    user_item("splinewright.leave_net").active = False
    yield from redrawn()
    view.move(view.region.x + view.region.width // 3, view.region.y + view.region.height // 2)
    view.press('F6')
    yield from into_net()
    with view.override():
        bpy.ops.splinewright.leave_net('EXEC_DEFAULT', True)
    yield from out_of_net()
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'EDIT_MESH', "Tab is Blender's own again")
    assert not part('bridge.cage.net_object').is_net(bpy.context.object)
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'OBJECT', "Object Mode by Blender's own Tab")

    bpy.ops.wm.save_userpref()
    again = subprocess.run([bpy.app.binary_path, '--window-geometry', '0', '0', '800', '600', '--python-expr', NEXT, '--',
                            ADDON], capture_output=True, text=True, timeout=300)
    assert "NEXT ('F6', True) ('TAB', False)" in again.stdout, again.stdout + again.stderr
    print("the preferences did what they should:", bpy.app.version_string, flush=True)


run(steps())
