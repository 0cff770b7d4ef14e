"""What has to be known while nets are out, over the 3D views and in the status bar: with the sidebar closed, too."""

import bpy
import blf
import gpu
from gpu_extras.batch import batch_for_shader

from ..bridge.cage import net_object
from ..bridge.data import problems
from ..bridge.data.file_state import ended_operators, state
from ..bridge.net import live
from ..bridge.shape import shape
from ..core.base.words import phrase, say
from . import colors, editing, knot_strip_overlay
from .ui_state import ui_state

#: What is in the way, and what is good to know.
WARNING, NOTE = colors.WARNING, (0.9, 0.9, 0.9, 1.0)
_BEHIND = (0.0, 0.0, 0.0, 0.7)
#: In pixels of an interface that is not scaled.
_SIZE, _LINE, _MARGIN = 13, 19, 12


def sentence(layer):
    """[(sentence, color)] for a view layer."""
    found = []
    for ob in editing.nets() if ui_state.nets else ():
        if ob.visible_get(view_layer=layer) or layer.objects.get(ob.name) == ob:     # to look for a name takes long
            found += _of_edited(ob) if ob.mode == 'EDIT' else _of_kept(ob)
    return found + list(_of_result(layer.objects.active))


def _of_result(ob):
    if ob is not None and ob.mode == 'EDIT' and shape.has_shape(ob):
        yield phrase("{name}: this is the generated mesh, not the net: changes here count as made by hand", name=ob.name), WARNING
        yield "The sidebar leads back to the net, discards such changes or keeps them; Tab leaves", NOTE


def _of_edited(ob):
    owner = net_object.shape_of(ob)
    name = owner.name if owner else ob.name
    problem, note, saved = live.problem(ob), live.note(ob), problems.of(ob.data, problems.SAVED)
    if problem:
        yield phrase("{name}: {problem}", name=name, problem=problem), WARNING
        yield phrase("{key} takes it back, Reload Control Points puts the net out again from the shape as it is",
                     key=undo_key()), NOTE
    elif note:
        yield phrase("{name}: {note}", name=name, note=note), NOTE
    if problem and saved:
        yield phrase("Saved: {saved}", saved=saved), NOTE


def _of_kept(ob):
    problem = live.problem(ob)
    if problem and net_object.shape_of(ob):
        yield phrase("{name} holds changes that {shape} has not taken: {problem}",
                     name=ob.name, shape=net_object.shape_of(ob).name, problem=problem), WARNING
        yield phrase("Tab on {name} continues with it; deleting it drops them", name=ob.name), NOTE


def undo_key():
    """What to press to take something back, as the user has it."""
    keymap = bpy.context.window_manager.keyconfigs.user.keymaps.get('Screen')
    item = next((item for item in keymap.keymap_items if item.idname == 'ed.undo' and item.active), None) if keymap else None
    return item.to_string() if item else "Undo"


def refresh():
    """Show an obstacle in the status bar; draw() shows it in the views."""
    windows = bpy.context.window_manager.windows
    texts = ["   ".join(say(text) for text, color in sentence(window.view_layer) if color == WARNING) for window in windows]
    if any(texts) or ui_state.status:      # what others wrote there meanwhile is gone either way
        for window, text in zip(windows, texts):
            window.workspace.status_text_set(say(text or None))
    ui_state.status = next(filter(None, texts), "")


def take_back():
    """Nothing is said in the status bar any more."""
    if ui_state.status:
        for window in bpy.context.window_manager.windows:
            window.workspace.status_text_set(None)
    ui_state.status = ""


def draw():
    """Called by Blender for each 3D view."""
    state.seen, ui_state.was_undone = ended_operators(), False
    lines = [(line, color) for text, color in sentence(bpy.context.view_layer) for line in _wrapped(say(text))]
    if not lines:
        return
    scale, (left, right) = _scale(), free_space()
    widths = [blf.dimensions(0, line)[0] for line, _ in lines]
    middle, margin = (left + right) / 2, _MARGIN * scale
    bottom = max(3 * _LINE * scale, knot_strip_overlay.top(bpy.context) + 2 * margin)
    top = bottom + len(lines) * _LINE * scale
    gpu.state.blend_set('ALPHA')
    draw_box(middle - max(widths) / 2 - margin, bottom - margin, middle + max(widths) / 2 + margin, top + margin / 2)
    for i, ((line, color), width) in enumerate(zip(lines, widths), 1):
        blf.color(0, *color)
        blf.position(0, middle - width / 2, top - (i - 0.25) * _LINE * scale, 0)
        blf.draw(0, line)
    gpu.state.blend_set('NONE')


def _scale():
    return bpy.context.preferences.system.ui_scale


def free_space():
    """The left and right end of what toolbar and sidebar leave of the view."""
    left, right = 0, bpy.context.region.width
    if bpy.context.preferences.system.use_region_overlap:
        for region in bpy.context.area.regions:
            if region.type == 'TOOLS' and region.width > 1:
                left += region.width
            if region.type == 'UI' and region.width > 1:
                right -= region.width
    return (left, right) if right - left > 200 else (0, bpy.context.region.width)


def _wrapped(sentence):
    """The sentence in lines that fit the view."""
    blf.size(0, _SIZE * _scale())
    left, right = free_space()
    lines = [""]
    for word in sentence.split():
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and blf.dimensions(0, longer)[0] > right - left - 4 * _MARGIN * _scale():
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


def draw_box(left, bottom, right, top):
    shader = gpu.shader.from_builtin('UNIFORM_COLOR')
    shader.uniform_float('color', _BEHIND)
    corners = [(left, bottom, 0), (right, bottom, 0), (right, top, 0), (left, top, 0)]
    batch_for_shader(shader, 'TRIS', {'pos': corners}, indices=[(0, 1, 2), (0, 2, 3)]).draw(shader)
