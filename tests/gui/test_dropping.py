"""Files come into a real window: dragged from Blender's file browser, dropped several at once, chosen several at once."""

import os
import sys
import tempfile
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, opened_browser, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
FOLDER = Path(tempfile.mkdtemp())
GOOD = "1\n1 1\n0 0 0\n0 1 1\n1 0 1\n1 1 0\n"


def names():
    return sorted(ob.name for ob in bpy.data.objects)


def browse(view):
    """A file browser at the lower right that shows the folder; the region with the names."""
    area = next(area for area in view.window.screen.areas if area.type in ('PROPERTIES', 'FILE_BROWSER'))
    area.ui_type = 'FILES'
    yield from redrawn()
    space = area.spaces.active
    space.show_region_toolbar = False
    space.params.directory = str(FOLDER).encode()
    space.params.display_type = 'LIST_VERTICAL'
    region = next(region for region in area.regions if region.type == 'WINDOW')
    with bpy.context.temp_override(window=view.window, area=area, region=region):
        bpy.ops.file.refresh()
    yield from until(lambda: region.width > 100, "room for names")
    return area, region


def drag(view, area, region):
    """Move the first file of the list into the view; the folder is read by a thread that tells nobody when it is done."""
    for _ in range(50):
        view.move(region.x + 45, region.y + region.height - 34)
        yield from redrawn()
        view.press('LEFTMOUSE')
        yield from redrawn()
        with bpy.context.temp_override(window=view.window, area=area, region=region):
            if [file.name for file in bpy.context.selected_files] == ["a.bpt"]:
                break
    else:
        raise AssertionError("the list shows no file a.bpt")
    view.window.event_simulate('LEFTMOUSE', 'PRESS', x=view.x, y=view.y)
    yield from redrawn()
    for x in range(view.x - 20, 400, -60):
        view.move(x, 420)
        yield from redrawn()
    save_picture(OUTPUT / "dropping.png")
    view.window.event_simulate('LEFTMOUSE', 'RELEASE', x=view.x, y=view.y)


def a_file_is_dragged_into_the_view(view):
    area, region = yield from browse(view)
    yield from drag(view, area, region)
    yield from until(lambda: bpy.data.objects, "the object of the file")
    assert names() == ["a"], names()
    assert bpy.context.window_manager.operators[-1].bl_idname == 'SPLINEWRIGHT_OT_import_bpt'
    print("dragged", flush=True)


def several_are_dropped(view):
    """What Blender does with files of the desktop: their handler is found, and asked."""
    with view.override():
        files = [{'name': name} for name in ("bad.bpt", "a.bpt", "b.bpt")]
        bpy.ops.wm.drop_import_file('INVOKE_DEFAULT', True, directory=str(FOLDER), files=files)
    yield from until(lambda: names() == ["a", "b"], "the objects of two files")
    assert bpy.context.window_manager.operators[-1].bl_idname == 'SPLINEWRIGHT_OT_import_bpt', "a browser was opened"
    with view.override():
        bpy.ops.wm.drop_import_file('INVOKE_DEFAULT', True, directory=str(FOLDER), files=[{'name': "c.json"}])
    yield from until(lambda: names() == ["a", "b", "c"], "the object of a third")
    view.press('Z', ctrl=True)
    yield from until(lambda: names() == ["a", "b"], "the objects before the last drop")
    print("dropped", flush=True)


def several_are_chosen(view):
    """In the file browser of File > Import."""
    with view.override():
        bpy.ops.splinewright.import_bpt('INVOKE_DEFAULT', True)
    there = yield from opened_browser()
    there['area'].spaces.active.params.directory = str(FOLDER).encode()
    with bpy.context.temp_override(**there):
        bpy.ops.file.refresh()
    chosen = []
    while len(chosen) < 3:              # of a list that is being read
        yield from redrawn()
        with bpy.context.temp_override(**there):
            bpy.ops.file.select_all(action='SELECT')
            chosen = bpy.context.selected_files
    yield from redrawn()
    save_picture(OUTPUT / "choosing.png")
    with bpy.context.temp_override(**there):
        bpy.ops.file.execute('INVOKE_DEFAULT')
    yield from until(lambda: names() == ["a", "b"], "the objects of the files that are good")
    print("chosen", flush=True)


def steps():
    view = View()
    empty_file()
    (FOLDER / "a.bpt").write_text(GOOD)
    (FOLDER / "b.bpt").write_text(GOOD)
    (FOLDER / "bad.bpt").write_text("teapot")
    (FOLDER / "c.json").write_text('{"format":"splinecore","version":1,"kind":"bezier_curve","points":[[0,0,0,1],[1,1,0,1]]}')
    parts = [several_are_chosen]
    if hasattr(bpy.types, 'FileHandler'):       # from Blender 4.1 on
        parts = [a_file_is_dragged_into_the_view, several_are_dropped, several_are_chosen]
    for part_of_it in parts:
        empty_file()
        yield from part_of_it(view)
    print("files did what they should:", bpy.app.version_string, flush=True)


run(steps())
