"""A real Blender window under Xvfb: events in, pictures out.

Steps are generators that wait until something is so: `yield from until(...)`, or `yield from redrawn()` where all that
can be known is that Blender has taken the events and drawn what came of them.
"""

import importlib
import itertools
import os
import struct
import sys
import time
import traceback
import zlib

import bpy
import numpy as np
from bpy_extras import view3d_utils
from mathutils import Vector

# Blender's own screenshot is black under software rendering in 4.3 and 5.2; Xvfb keeps its picture in a file.
FRAME = os.path.join(os.environ['XVFB_FRAMES'], 'Xvfb_screen0')
#: Nothing that is waited for takes so many seconds, however loaded the machine is.
LIMIT = 60.0
#: How often is looked whether it is so.
_POLL = 0.02
_draws = 0


def until(is_so, what):
    """Steps until it is so. Raises AssertionError with what was waited for where it does not come."""
    end = time.monotonic() + LIMIT
    while not is_so():
        assert time.monotonic() < end, f"not within {LIMIT:.0f} s: {what}"
        yield


def distances_measured():
    """Whether the distances of a shape from another object are known in the end."""
    return any(what[0] == 'deviation' for known in part('bridge.data.file_state').state.sights.values() for what in known)


def redrawn():
    """Steps until Blender has handled the events so far, and drawn what came of them."""
    before = _draws
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            area.tag_redraw()
    yield
    yield from until(lambda: _draws > before, "a redraw")


def nets():
    return [ob for ob in bpy.data.objects if part('bridge.cage.net_object').is_net(ob)]


def in_net():
    return bpy.context.mode.startswith('EDIT') and len(nets()) == 1 and nets()[0].mode == 'EDIT'


def is_out():
    return bpy.context.mode == 'OBJECT' and not nets()


def into_net():
    """Steps until a net is in Edit Mode, and drawn."""
    yield from until(in_net, "a net in Edit Mode")
    yield from redrawn()


def out_of_net():
    """Steps until there is none any more, and that is drawn."""
    yield from until(is_out, "Object Mode without a net")
    yield from redrawn()


def _count_draw():
    global _draws
    _draws += 1


def save_picture(path):
    """What the screen shows, drawn anew, as a PNG."""
    bpy.ops.wm.redraw_timer(type='DRAW_WIN_SWAP', iterations=1)
    rgb = _screen()
    write_png(path, rgb)
    return rgb


def _screen():
    """The rows of pixels that Xvfb shows."""
    with open(FRAME, 'rb') as file:
        raw = file.read()
    header = struct.unpack('>25I', raw[:100])
    size, width, height, order, stride, colors = (header[i] for i in (0, 4, 5, 7, 12, 19))
    pixels = np.frombuffer(raw, np.uint8, stride * height, size + 12 * colors)
    pixels = pixels.reshape(height, stride)[:, :4 * width].reshape(height, width, 4)
    return pixels[..., 2::-1] if order == 0 else pixels[..., 1:4]


def write_png(path, rgb):
    height, width = rgb.shape[:2]
    rows = np.concatenate([np.zeros((height, 1), np.uint8), rgb.reshape(height, -1)], 1).tobytes()
    header = struct.pack('>2I5B', width, height, 8, 2, 0, 0, 0)
    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + _chunk(b'IHDR', header) + _chunk(b'IDAT', zlib.compress(rows, 6)) + _chunk(b'IEND', b''))


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

    def pixel_of(self, point):
        """Where a point of the world is drawn, in pixels of the window."""
        place = view3d_utils.location_3d_to_region_2d(self.region, self.region.data, Vector(point))
        return round(self.region.x + place.x), round(self.region.y + place.y)

    def press(self, key, text="", **modifiers):
        """A key or button; `text` is the character it types."""
        self.window.event_simulate(key, 'PRESS', x=self.x, y=self.y, **({'unicode': text} if text else {}), **modifiers)
        self.window.event_simulate(key, 'RELEASE', x=self.x, y=self.y, **modifiers)

    def drag(self, places):
        """Steps of a drag with the left button, which stays down, through places."""
        self.move(*places[0])
        self.window.event_simulate('LEFTMOUSE', 'PRESS', x=self.x, y=self.y)
        for place in places[1:]:
            self.move(*place)
            yield

    def release(self):
        self.window.event_simulate('LEFTMOUSE', 'RELEASE', x=self.x, y=self.y)

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
            yield from redrawn()
            return

        def is_shown():                 # a tab exists only once it was drawn
            sidebar.active_panel_category = name
            return sidebar.active_panel_category == name
        yield from redrawn()
        yield from until(is_shown, f"a tab {name} in the sidebar")
        yield from redrawn()

    def in_sidebar(self, *parts):
        """Steps that bring the tab NURBS of the sidebar up, and then those of each part, by this view."""
        self.open_sidebar()
        yield from redrawn()
        yield from self.show_tab("NURBS", (1045, 538))
        self.move(420, 420)
        for part_of_it in parts:
            yield from part_of_it(self)

    def beside(self, kind):
        """An area of a kind beside the view, which gives it half of its room."""
        known = set(self.window.screen.areas)
        with self.override():
            bpy.ops.screen.area_split(direction='VERTICAL', factor=0.5)
        (area,) = set(self.window.screen.areas) - known
        area.type = kind
        return area

    def scroll_down(self, notches):
        """Steps that turn the wheel at the mouse."""
        for _ in range(notches):
            self.window.event_simulate('WHEELDOWNMOUSE', 'PRESS', x=self.x, y=self.y)
            yield
        yield from redrawn()

    def search(self, places, is_found, what, key, scrolls=False, **modifiers):
        """Steps that press a key at one place after the other until it is found. scrolls: from the second time on what lies further
        down is brought up."""
        end, passes = time.monotonic() + LIMIT * (3 if scrolls else 1), itertools.count()
        while time.monotonic() < end:
            if next(passes) > 1 and scrolls:
                yield from self.scroll_down(5)
            for place in places:
                self.move(*place)
                yield
                self.press(key, **modifiers)
                yield
                if is_found():
                    return
        raise AssertionError(f"not within {LIMIT:.0f} s: {what}")

    def go_to_field(self, name, region=None):
        """Steps that bring the mouse over the field of a property in the sidebar, or in a region."""
        region, manager = region or self._region('UI'), bpy.context.window_manager
        manager.clipboard = ""
        places = [(region.x + region.width // 2, y) for y in range(region.y + region.height - 30, region.y, -9)]
        # The key copies the name of what is below the mouse; 5.2 tells which of several numbers it is.
        yield from self.search(places, lambda: manager.clipboard.partition("[")[0].endswith(name), f"a field {name}",
                               'C', scrolls=True, ctrl=True, shift=True)


def opened_browser():
    """Steps until an operator has opened a file browser in a window of its own; what stands there for overrides."""
    def areas():
        return [(window, area) for window in bpy.context.window_manager.windows for area in window.screen.areas
                if area.type == 'FILE_BROWSER' and area.spaces.active.active_operator and area.spaces.active.params]
    yield from until(areas, "a file browser")
    yield from redrawn()
    (window, area), = areas()
    return {'window': window, 'area': area, 'region': next(region for region in area.regions if region.type == 'WINDOW')}


ADDON = next(key for key in bpy.context.preferences.addons.keys() if key.split('.')[-1] == 'splinewright')


def part(name):
    """A module of the add-on, by its dotted name below the add-on."""
    return importlib.import_module(f"{ADDON}.{name}")


def user_item(operator):
    """The user's key for an operator of ours."""
    return next(item for _, item, name in part('ui.keymaps').of_user() if name == operator)


def empty_file():
    """Remove the objects of the factory scene, as an undo step."""
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    bpy.ops.ed.undo_push(message="empty")


def pick_by_keys(view, keys):
    """Steps through an open menu."""
    for key in keys:
        view.press(key)
        yield from redrawn()


def select_points(*numbers):
    """Select points of the net in Edit Mode, as an undo step."""
    ob = bpy.context.object
    part('bridge.net.selection').select(ob, part('bridge.net.live').session(ob.data).net, numbers)
    bpy.ops.ed.undo_push(message="select")


def mean_difference(a, b):
    """Of two pictures, 0 to 255."""
    return float(np.abs(a.astype(int) - b).mean())


def draw_fast(system):
    """Without smooth edges, which take a quarter of a script's time where the processor draws."""
    system.viewport_aa = 'OFF'
    system.use_overlay_smooth_wire = system.use_edit_mode_smooth_wire = False


def _show_failure():
    """A picture of what was on the screen."""
    try:
        save_picture(os.path.join(os.environ['SPLINEWRIGHT_OUTPUT'], "failed.png"))
    except Exception:
        traceback.print_exc()
        sys.stdout.flush()


def run(steps):
    """Run a generator of steps. Ends Blender, with 1 on an error."""
    def whole():
        yield from redrawn()
        yield from steps

    waiting = whole()

    def tick():
        try:
            next(waiting)
            return _POLL
        except StopIteration:
            bpy.ops.wm.quit_blender()
        except Exception:
            traceback.print_exc()
            sys.stdout.flush()
            _show_failure()
            os._exit(1)
    bpy.context.preferences.view.show_splash = False
    bpy.context.preferences.view.smooth_view = 0            # the view would glide for a time of its own
    if not os.environ.get('SPLINEWRIGHT_SMOOTH'):
        draw_fast(bpy.context.preferences.system)
    # What a script sets would be there for the next.
    bpy.context.preferences.use_preferences_save = False
    bpy.types.SpaceView3D.draw_handler_add(_count_draw, (), 'WINDOW', 'POST_PIXEL')
    bpy.app.timers.register(tick, first_interval=_POLL, persistent=True)
