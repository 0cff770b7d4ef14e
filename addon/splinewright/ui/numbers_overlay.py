"""Over the 3D view: the numbers of the pieces of a shape, where they are asked for; and the piece that is picked."""

from typing import NamedTuple

import blf
import bpy
import gpu
import numpy as np

from ..bridge.analysis import surveys
from ..bridge.shape import shape
from ..core.base.words import phrase
from . import active_shape, line_batches, picking
from .ui_state import ui_state

#: Of other pieces, of active ones, of the one at the mouse.
COLORS = ((1.0, 1.0, 1.0, 1.0), (1.0, 0.75, 0.2, 1.0), (0.35, 1.0, 0.5, 1.0))
#: Of numbers that the surface hides this part is seen.
HIDDEN = 0.3
#: Shapes of more pieces show no numbers; those of meshes of more faces are never hidden.
_MOST_PIECES, _MOST_FACES = 500, 200_000
_SIZE = 15.0
#: A number is hidden by what lies nearer to the eye by this part of the size of the shape.
_LIFT = 0.01


class Numbered(NamedTuple):
    """An object whose pieces show numbers."""

    ob: bpy.types.Object
    numbers: tuple                      # of its pieces; 0 for none
    marked: tuple                       # those that are active

    def text(self, i):
        """What stands at the piece of an index: its number, and that by which the last operator means it, if that is another
        one, as it was before."""
        return str(i + 1) if self.numbers[i] == i + 1 else phrase("{i} (was {numbers})", i=i + 1, numbers=self.numbers[i])


def shown(context):
    """The Numbered objects."""
    if ui_state.picking:
        found = ui_state.picking
    else:
        owner = active_shape.shape_of(context.object)
        is_shown = owner is not None and (ui_state.asking or owner.data.splinewright.show_numbers)
        found = {**({owner.name: active_shape.counted(owner.data)} if is_shown else {}), **_asked(context)}
    obs = {name: context.view_layer.objects.get(name) for name in found}
    marked = _settings(context) if found is ui_state.picking or _asked(context) else None
    return [Numbered(ob, found[name], active_shape.of(ob.data) if marked is None else marked) for name, ob in obs.items()
            if shape.has_shape(ob) and ob.visible_get() and len(found[name]) == active_shape.count_of(ob.data)]


def _asked(context):
    """The numbers by names of objects that the last operator asks for, if its panel is open."""
    operator, found = context.active_operator, {}
    if operator is None or not _is_open(context.area):
        return {}
    for numbers in active_shape.asked(operator).values():
        for name, those in numbers.items():
            found[name] = tuple(one or other for one, other in zip(found.get(name, those), those))
    return found


def _settings(context):
    """The numbers that the last operator was given."""
    operator = context.active_operator
    return tuple(getattr(operator.properties, setting) for setting in active_shape.asked(operator)) if operator else ()


def _is_open(area):
    """Whether the panel of the last operator shows its settings: it is higher than its header."""
    least = 2.0 * 25.0 * bpy.context.preferences.system.ui_scale
    return any(region.type == 'HUD' and region.height > least and region.x > 0 for region in area.regions)


def draw_outline():
    """Called by Blender for each 3D view: the lines around the piece at the mouse, and sides that are picked."""
    if ui_state.hovered:
        name, number = ui_state.hovered
        _draw_lines(name, lambda data: surveys.outlines_of(data)[number - 1])
    show_sides(ui_state.sides)


def show_sides(sides):
    """Draw sides of patches, (object's name, number, side) each, into the current 3D view."""
    for name, number, side in sides:
        _draw_lines(name, lambda data: surveys.sides_of(data)[number - 1].get(side, []))


def _draw_lines(name, lines_of):
    """Polylines of a shape with this name, if it is there."""
    ob = bpy.context.view_layer.objects.get(name)
    if not shape.has_shape(ob):
        return
    with gpu.matrix.push_pop():
        gpu.matrix.multiply_matrix(ob.matrix_world)
        line_batches.draw(line_batches.lines(np.stack([line[:-1], line[1:]], 1), lambda: COLORS[2], 3.0) for line in lines_of(ob.data))


def draw():
    """Called by Blender for each 3D view, in pixels."""
    context = bpy.context
    if not context.space_data.overlay.show_overlays:
        return
    for numbered in shown(context):
        if 1 < len(numbered.numbers) <= _MOST_PIECES:
            _draw_numbers(context, numbered, surveys.middles_of(numbered.ob.data))


def _draw_numbers(context, numbered, points):
    region, ob = context.region, numbered.ob
    scale = context.preferences.system.ui_scale
    pixels = picking.on_screen(region, context.region_data, ob.matrix_world, points)
    hidden = hidden_ones(context, ob, points)
    blf.enable(0, blf.SHADOW)
    blf.shadow(0, 5, 0.0, 0.0, 0.0, 1.0)
    for i in np.argsort(~hidden):       # those that are seen last
        number, (x, y) = numbered.numbers[i], pixels[i]
        if not (number and 0 <= x < region.width and 0 <= y < region.height):
            continue
        is_hovered = ui_state.hovered == (ob.name, i + 1)
        color = COLORS[2 if is_hovered else number in numbered.marked]
        blf.size(0, (1.5 if is_hovered else 1.0) * _SIZE * scale)
        blf.color(0, *color[:3], HIDDEN if hidden[i] and not is_hovered else 1.0)
        text = numbered.text(i)
        width, height = blf.dimensions(0, text)
        blf.position(0, x - width / 2, y - height / 2, 0)
        blf.draw(0, text)
    blf.disable(0, blf.SHADOW)


def hidden_ones(context, ob, points):
    """(n,) bool: which points lie behind the surface itself, as the current view shows them."""
    space, none = context.space_data, np.zeros(len(points), bool)
    if ob.type != 'MESH' or len(ob.data.polygons) > _MOST_FACES or ob.mode != 'OBJECT':
        return none
    if space.shading.show_xray or space.shading.type == 'WIREFRAME' or ob.display_type in ('WIRE', 'BOUNDS'):
        return none
    drawn = ob.evaluated_get(context.evaluated_depsgraph_get())
    if not abs(drawn.matrix_world.determinant()) > 0.0:
        return none
    into = drawn.matrix_world.inverted()
    view = context.region_data
    eye = into @ view.view_matrix.inverted().translation
    back = (into.to_3x3() @ view.view_matrix.inverted().col[2].xyz).normalized()
    size = max(drawn.dimensions) / max(map(abs, drawn.matrix_world.to_scale()))
    return np.array([_is_hidden(drawn, point, eye, back, _LIFT * size, view.is_perspective) for point in points])


def _is_hidden(drawn, point, eye, back, lift, is_perspective):
    if not np.isfinite(point).all():
        return False
    to = np.array(eye) - point if is_perspective else np.array(back)
    to /= np.linalg.norm(to) or 1.0
    return drawn.ray_cast(point + lift * to, to)[0]
