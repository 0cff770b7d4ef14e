"""Outlines of letters in Blender's own font, and of text objects: Bezier curves, as Blender has them."""

from pathlib import Path as FilePath

import bpy
import numpy as np

from ...core.base.failures import Refusal
from ...core.figures import paths
from ...core.figures.letters import Letter
from ...core.native import native_values
from ..data import blocks
from ..native import native_splines

#: Of the fonts that come with Blender those of its interface, which have Latin and Cyrillic letters; the first that is there.
_FONTS = "Inter.woff2", "DejaVuSans.woff2"
#: Stands on either side of a letter, so that its advance is known.
_POST = "|"


def letters(characters):
    """A function that gives the core.figures.letters.Letter of each of these characters. Raises Refusal where the font lacks one."""
    known = set(bpy.data.fonts)
    data = bpy.data.curves.new('Splinewright Letters', 'FONT')
    ob = bpy.data.objects.new('Splinewright Letters', data)
    font = _font()
    try:
        if font is not None:
            data.font = font
        posts = _splines(ob, _POST * 2)
        found = {character: _letter(character, _splines(ob, f"{_POST}{character}{_POST}"), posts) for character in set(characters)}
    finally:
        bpy.data.objects.remove(ob)
        blocks.remove(data)
        for made in set(bpy.data.fonts) - known:
            bpy.data.fonts.remove(made)
    return found.__getitem__


def _font():
    folder = bpy.utils.system_resource('DATAFILES', path="fonts")
    files = [FilePath(folder) / name for name in _FONTS] if folder else []
    file = next((file for file in files if file.is_file()), None)
    return bpy.data.fonts.load(str(file)) if file is not None else None


def _letter(character, splines, posts):
    """Of the outlines of a character between two posts, and those of two posts alone."""
    of_post = len(posts) // 2
    own = splines[of_post:len(splines) - of_post]
    if not own and not character.isspace():
        raise Refusal("Blender's font has no letter {letter!r}", letter=character)
    first, second, last = splines[0], posts[of_post], splines[-of_post]
    start = second[0, 0, 0] - posts[0][0, 0, 0]         # the advance of a post
    advance = last[0, 0, 0] - first[0, 0, 0] - start
    return Letter(float(advance), tuple(_outline(spline - (start, 0.0)) for spline in own))


def _splines(ob, text):
    """[(n, 4, 2)]: of each outline of a text its cubic pieces."""
    ob.data.body = text
    return [np.array([piece[:, :2] for piece in paths.pieces_of([curve])]) for curve in curves_of(ob, bpy.context.evaluated_depsgraph_get())]


def _outline(cubics):
    return paths.Path(cubics[0, 0], tuple(cubic[1:] for cubic in cubics), closed=True)


def curves_of(ob, depsgraph):
    """The outlines of a text object, as curves in its space."""
    try:
        shown = ob.to_curve(depsgraph)
        read = [native_values.curve_value(native_splines.read(spline, False), "")[0] for spline in shown.splines]
    finally:
        ob.to_curve_clear()
    return [curve for curve in read if curve is not None]
