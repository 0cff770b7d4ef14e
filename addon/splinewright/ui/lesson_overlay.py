"""Over the 3D view, at its upper left: what the step of a lesson says."""

import blf
import bpy
import gpu

from ..bridge.lessons import stage
from ..core.base.failures import FAILURES
from ..core.base.words import phrase, say
from . import messages, texts
from .operators import lessons
from .ui_state import ui_state

#: In pixels of an interface that is not scaled: letters, lines, margins, the widest line, and what Blender writes there itself.
_SIZE, _LINE, _MARGIN, _WIDEST, _BLENDERS = 14, 20, 12, 460, 70
_TITLE, _TEXT, _RIGHT = (1.0, 0.8, 0.35, 1.0), (1.0, 1.0, 1.0, 1.0), (0.5, 1.0, 0.6, 1.0)


def draw():
    """Called by Blender for each 3D view, in pixels."""
    context = bpy.context
    scene = context.scene
    if not (stage.lesson_of(scene) and scene.splinewright_lesson_in_view and context.space_data.overlay.show_overlays):
        return
    try:
        lesson = lessons.current(scene)
    except FAILURES:
        return                          # the panel says it
    number = stage.step_of(scene)
    scale = context.preferences.system.ui_scale
    left, right = messages.free_space()
    blf.size(0, _SIZE * scale)
    room = min(right - left - 4 * _MARGIN * scale, _WIDEST * scale)
    lines = [(say(phrase("{title}: {number} of {count}", title=phrase(lesson.title), number=number + 1, count=len(lesson.steps))), _TITLE)]
    lines += [(line, _TEXT) for line in texts.wrapped(say(lesson.steps[number].text), room, lambda text: blf.dimensions(0, text)[0])]
    if ui_state.lesson_word and str(number) in stage.answers(scene):
        lines.append((say(ui_state.lesson_word), _RIGHT if stage.answers(scene)[str(number)].get('right') else _TITLE))
    lines += [(line, _RIGHT) for line in texts.wrapped(say(lessons.shown_answer(scene)), room, lambda text: blf.dimensions(0, text)[0])]
    _draw_lines(lines, left + _MARGIN * scale, _top(context, scale), scale)


def _top(context, scale):
    """Where the text begins, below headers that lie over the view, and what Blender writes there."""
    over = sum(region.height for region in context.area.regions if region.type in ('HEADER', 'TOOL_HEADER') and region.height > 1)
    is_over = context.preferences.system.use_region_overlap
    return context.region.height - (over if is_over else 0) - (_BLENDERS if context.space_data.overlay.show_text else _MARGIN) * scale


def _draw_lines(lines, left, top, scale):
    margin, height = _MARGIN * scale / 2, _LINE * scale
    widest = max(blf.dimensions(0, line)[0] for line, _ in lines)
    gpu.state.blend_set('ALPHA')
    messages.draw_box(left - margin, top - len(lines) * height - margin, left + widest + margin, top + margin)
    for i, (line, color) in enumerate(lines, 1):
        blf.color(0, *color)
        blf.position(0, left, top - (i - 0.28) * height, 0)
        blf.draw(0, line)
    gpu.state.blend_set('NONE')


CLASSES = ()
