"""A real Blender window under Xvfb: events in, pictures out."""

import importlib
import os
import struct
import sys
import time
import traceback
import zlib

import bpy
import numpy as np

# Blender's own screenshot is black under software rendering in 4.3 and 5.2; Xvfb keeps its picture in a file.
FRAME = os.path.join(os.environ['XVFB_FRAMES'], 'Xvfb_screen0')


def save_picture(path):
    """What the screen shows, drawn anew, as a PNG."""
    bpy.ops.wm.redraw_timer(type='DRAW_WIN_SWAP', iterations=1)
    with open(FRAME, 'rb') as file:
        raw = file.read()
    header = struct.unpack('>25I', raw[:100])
    size, width, height, order, stride, colors = (header[i] for i in (0, 4, 5, 7, 12, 19))
    pixels = np.frombuffer(raw, np.uint8, stride * height, size + 12 * colors)
    pixels = pixels.reshape(height, stride)[:, :4 * width].reshape(height, width, 4)
    rgb = pixels[..., 2::-1] if order == 0 else pixels[..., 1:4]
    rows = np.concatenate([np.zeros((height, 1), np.uint8), rgb.reshape(height, -1)], 1).tobytes()
    header = struct.pack('>2I5B', width, height, 8, 2, 0, 0, 0)
    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + _chunk(b'IHDR', header) + _chunk(b'IDAT', zlib.compress(rows, 6)) + _chunk(b'IEND', b''))
    return rgb


def _chunk(kind, body):
    return struct.pack('>I', len(body)) + kind + body + struct.pack('>I', zlib.crc32(kind + body))


class View:
    """The 3D viewport of the first window."""

    def __init__(self):
        self.window = bpy.context.window_manager.windows[0]
        self.area = next(area for area in self.window.screen.areas if area.type == 'VIEW_3D')
        self.region = self._region('WINDOW')
        self.x, self.y = self.region.x + self.region.width // 2, self.region.y + self.region.height // 2

    def _region(self, kind):
        return next(region for region in self.area.regions if region.type == kind)

    def override(self):
        return bpy.context.temp_override(window=self.window, area=self.area, region=self.region)

    def move(self, x=None, y=None):
        self.x, self.y = self.x if x is None else x, self.y if y is None else y
        self.window.event_simulate('MOUSEMOVE', 'NOTHING', x=self.x, y=self.y)

    def press(self, key, text="", **modifiers):
        """A key or button; `text` is the character it types."""
        self.window.event_simulate(key, 'PRESS', x=self.x, y=self.y, **({'unicode': text} if text else {}), **modifiers)
        self.window.event_simulate(key, 'RELEASE', x=self.x, y=self.y, **modifiers)

    def wheel_up(self, **modifiers):
        """One notch; wheels are not released."""
        self.window.event_simulate('WHEELUPMOUSE', 'PRESS', x=self.x, y=self.y, **modifiers)

    def open_sidebar(self):
        self.area.spaces.active.show_region_ui = True

    def show_tab(self, name, click):
        """Steps that bring a tab of the sidebar up. Before 4.0 only a click can: `click` is its place."""
        sidebar = self._region('UI')
        if not hasattr(sidebar, 'active_panel_category'):
            self.move(*click)
            self.press('LEFTMOUSE')
            yield 0.5
            return
        for _ in range(20):             # a tab exists only once it was drawn
            sidebar.active_panel_category = name
            self.area.tag_redraw()
            yield 0.5
            if sidebar.active_panel_category == name:
                return
        raise AssertionError(f"the sidebar has no tab {name}")


    def go_to_field(self, name, region=None):
        """Steps that bring the mouse over the field of a property in the sidebar, or in a region; fails if there is none."""
        region, manager = region or self._region('UI'), bpy.context.window_manager
        manager.clipboard = ""
        for y in range(region.y + region.height - 30, region.y, -9):
            self.move(region.x + region.width // 2, y)
            yield 0.05
            self.press('C', ctrl=True, shift=True)      # copies the name of what is below the mouse
            yield 0.05
            if manager.clipboard.endswith(name):
                return
        raise AssertionError(f"there is no field {name}")


ADDON = next(key for key in bpy.context.preferences.addons.keys() if key.split('.')[-1] == 'splinewright')


def part(name):
    """A module of the add-on, by its dotted name below the add-on."""
    return importlib.import_module(f"{ADDON}.{name}")


def empty_file():
    """Remove the objects of the factory scene, as an undo step."""
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    bpy.ops.ed.undo_push(message="empty")


def until(is_so, seconds=10.0):
    """Steps until it is so; they end after a while even if it is not, for the caller to say what is wrong."""
    end = time.monotonic() + seconds
    yield 0.3
    while not is_so() and time.monotonic() < end:
        yield 0.3


def pick_by_keys(view, keys):
    """Steps through an open menu."""
    for key in keys:
        view.press(key)
        yield 0.3


def select_points(*numbers):
    """Select points of the net in Edit Mode, as an undo step."""
    ob = bpy.context.object
    part('bridge.net.selection').select(ob, part('bridge.net.live').session(ob.data).net, numbers)
    bpy.ops.ed.undo_push(message="select")


def mean_difference(a, b):
    """Of two pictures, 0 to 255."""
    return float(np.abs(a.astype(int) - b).mean())


def run(steps):
    """Run a generator of steps; each yields the seconds until the next. Ends Blender, with 1 on an error."""
    def tick():
        try:
            return next(steps)
        except StopIteration:
            bpy.ops.wm.quit_blender()
        except Exception:
            traceback.print_exc()
            sys.stdout.flush()
            os._exit(1)
    bpy.context.preferences.view.show_splash = False
    # What a script sets would be there for the next.
    bpy.context.preferences.use_preferences_save = False
    bpy.app.timers.register(tick, first_interval=1.5)
