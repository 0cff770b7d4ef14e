"""Objects of a view as a figure: curves, the lines of patches, control nets and names."""

from typing import NamedTuple

import numpy as np

from ...core.base.failures import FAILURES, sentence
from ...core.base.words import phrase, say
from ...core.figures import hiding, lines, page, paths
from ...core.figures.figure import BLACK, Area, Dot, Figure, Group, Stroke, arrow_head, ink
from ...core.figures.letters import label
from ...core.shape import sewing
from ...core.verbs import verbs
from ..analysis import overlays
from ..cage import net_object
from ..data import store
from ..data.settings import overlays_of
from ..native import read_native
from ..shape import images, piece_materials, shape
from . import hidden, outlines, sights

#: What is done with lines behind surfaces.
SHOW, DASH, OMIT = 'SHOW', 'DASH', 'OMIT'
#: Of lines of nets and overlays: their parts of the width of curves.
_OF_NET, _BOLD = 0.5, 0.8


class Wanted(NamedTuple):
    """How a figure is drawn; lengths in mm."""

    curves: float = 0.5                 # the widths of curves and sides, and of isocurves
    isocurves: float = 0.15
    letters: float = 3.5
    points: float = 1.4
    count: int = 3                      # of isocurves in every span
    behind: str = OMIT
    white: bool = True
    net_colors: tuple = (BLACK, BLACK)  # of rows along u and along v


class View(NamedTuple):
    """A view layer as a 3D view shows it, and which of its shapes have overlays."""

    scene: object
    layer: object
    depsgraph: object
    space: object                       # of the 3D view, or None
    nets: tuple = ()
    named: tuple = ()
    overlaid: tuple = ()                # shapes with what the switches of the scene draw over them


class Drawing(NamedTuple):
    figure: Figure
    left_out: dict                      # why, by names of objects


def figure(view, seen, wanted):
    """The Drawing of a View on a core.figures.page.Page. Raises Refusal."""
    groups, left_out = [], {}
    for ob in _objects(view):
        try:
            items, lost = _of_object(ob, view, seen, wanted)
            groups.append(Group(ob.name, tuple(items)))
            left_out.update({ob.name: lost} if lost else {})
        except FAILURES as error:
            left_out[ob.name] = sentence(error)
    groups += [Group(ob.name, tuple(_sights(ob, view, seen, wanted))) for ob in view.overlaid]
    groups += [Group(ob.name, tuple(_net(ob, view, seen, wanted))) for ob in view.nets]
    groups += _names(view, seen, wanted)
    return Drawing(Figure(seen.width, seen.height, wanted.white, tuple(group for group in groups if group.items)), left_out)


def _objects(view):
    """The objects that are seen in a view and in instances of collections."""
    where = {'view_layer': view.layer} if view.space is None else {'view_layer': view.layer, 'viewport': view.space}
    found = {ob: None for ob in view.layer.objects if ob and ob.visible_get(**where)}       # a removed one is None for a while
    for holder in list(found):
        found.update(dict.fromkeys(images.shapes_in(holder)))
    return [ob for ob in found if not net_object.is_net(ob) and (ob.type in ('CURVE', 'SURFACE', 'FONT', 'MESH'))]


def _of_object(ob, view, seen, wanted):
    """(Strokes of an object, what of it is left out or "")."""
    if shape.has_shape(ob):
        drawn, lost = _of_shape(ob.data, wanted), _modifiers(ob)
        matrices = images.of(ob, view.layer, view.space)
    elif ob.type == 'MESH':
        return [], "a mesh without curves or patches" if ob.data.polygons or ob.data.edges else ""
    else:
        drawn, lost = _of_native(ob, view.depsgraph, wanted)
        matrices = [ob.matrix_world]
    found = []
    for matrix in matrices:
        world = np.array(matrix, dtype=np.float64)
        for pieces, color, width in drawn:
            found += _strokes(paths.moved(pieces, world), color, width, view, seen, wanted)
    return found, lost


def _of_shape(data, wanted):
    """[(pieces in the space of a shape, color, width)]."""
    definition, color = store.read(data), _color(data)
    if not definition.has_curves:
        return _of_patches(sewing.patches_of(definition), color, wanted)
    colors = piece_materials.colors_of(data)
    return [(paths.pieces_of([curve]), ink(colors[piece.name]) if piece.name in colors else color, wanted.curves)
            for piece, curve in zip(definition.pieces, verbs.curves_of(definition))]


def _of_patches(patches, color, wanted):
    return [(lines.isocurves(patches, wanted.count), color, wanted.isocurves), (lines.sides(patches), color, wanted.curves)]


def _of_native(ob, depsgraph, wanted):
    """The same of one of Blender's own objects, and what of it is left out."""
    color = _color(ob.data)
    if ob.type == 'FONT':
        return [(paths.pieces_of(outlines.curves_of(ob, depsgraph)), color, wanted.isocurves)], ""
    reading = read_native.read(ob, depsgraph)
    lost = ", ".join([*reading.dropped, *read_native.not_followed(ob)])
    if ob.type == 'SURFACE':
        return _of_patches(reading.pieces, color, wanted), lost
    return [(paths.pieces_of([curve]), color, wanted.curves) for curve in reading.pieces], lost


def _modifiers(ob):
    """The modifiers that change its look, in words, or ""."""
    return ", ".join(phrase("the modifier {name}", name=modifier.name) for modifier in ob.modifiers
                     if modifier.show_viewport and modifier.type != 'MIRROR')


def _color(data):
    """Of the first material."""
    material = next(filter(None, data.materials), None)
    return ink(material.diffuse_color) if material is not None else BLACK


def _strokes(pieces, color, width, view, seen, wanted):
    """Of pieces of the world: those that are seen, and those behind surfaces as is wanted."""
    if wanted.behind == SHOW:
        stretches = [(piece, True) for piece in pieces]
    else:
        is_seen = hidden.sight(seen, view.scene, view.depsgraph)
        stretches = [part for piece in pieces if paths.of_piece(piece, seen) for part in hiding.stretches(piece, is_seen)]
    shown = paths.of_pieces([piece for piece, is_front in stretches if is_front], seen)
    behind = [piece for piece, is_front in stretches if not is_front] if wanted.behind == DASH else []
    dashed = paths.of_pieces(behind, seen)
    return [Stroke(tuple(each), color, width, is_dashed) for each, is_dashed in ((dashed, True), (shown, False)) if each]


def _net(ob, view, seen, wanted):
    """The control polygon or net of a shape."""
    found = overlays.kept(ob.data, 'polygon of figure', (), overlays.polygon_of)
    if found is None:
        return []
    rows = [sights.Lines(color, np.asarray(pairs).reshape(-1, 2, 3)) for pairs, color in zip(found.rows, wanted.net_colors)]
    return _lines([*rows, sights.Lines(BLACK, arrows=found.arrows, points=found.points)], ob, view, seen, wanted)


def _sights(ob, view, seen, wanted):
    return _lines(sights.of(ob, overlays_of(view.scene)), ob, view, seen, wanted)


def _lines(drawn, ob, view, seen, wanted):
    """What stands for sights.Lines of a shape in each place where it is seen; nothing hides it."""
    found = []
    for matrix in images.of(ob, view.layer, view.space):
        world = np.array(matrix, dtype=np.float64)
        for each in drawn:
            arrows = np.array(each.arrows).reshape(-1, 2, 3)
            pieces = paths.moved(paths.of_lines(np.concatenate([each.pairs, arrows])), world)
            shown = paths.of_pieces(pieces, seen)
            width = (_BOLD if each.is_bold else _OF_NET) * wanted.curves
            found += [Stroke(tuple(shown), each.color, width)] if shown else []
            for foot, tip in page.places(_placed(arrows.reshape(-1, 3), world), seen).reshape(-1, 2, 2):
                found += [Area(arrow_head(foot, tip), each.color)] if np.isfinite([foot, tip]).all() else []
            found += [Dot(tuple(place.tolist()), wanted.points, each.color)
                      for place in page.places(_placed(each.points, world), seen) if _is_on(place, seen)]
    return found


def _placed(points, world):
    return points @ world[:3, :3].T + world[:3, 3]


def _names(view, seen, wanted):
    """Groups of the names of points, knots and functions, and of the numbers of axes."""
    known = [(ob, overlays.kept(ob.data, 'labels', (), overlays.labels_of) or ()) for ob in view.named]
    known += [(ob, _numbers(ob)) for ob in view.overlaid if overlays_of(view.scene).axes]
    characters = {letter for _, named in known for each in named for text, _ in each.runs for letter in say(text)}
    letters, found = outlines.letters(characters) if characters else None, []
    for ob, named in known:
        world = np.array(ob.matrix_world, dtype=np.float64)
        at = page.places(_placed(np.array([each.point for each in named]).reshape(-1, 3), world), seen)
        colors = piece_materials.colors_of(ob.data)
        areas = [label(each, place, wanted.letters, ink(colors[each.part]) if each.part in colors else BLACK, letters)
                 for each, place in zip(named, at) if _is_on(place, seen)]
        found.append(Group(say(phrase("Names of {name}", name=ob.name)), tuple(areas)))
    return found


def _numbers(ob):
    found = overlays.kept(ob.data, 'numbers', (), overlays.axes_of)
    return found.labels if found else ()


def _is_on(place, seen):
    return bool((place >= 0.0).all() and (place <= (seen.width, seen.height)).all())
