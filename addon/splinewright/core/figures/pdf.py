"""A figure as PDF, by reportlab, which a Python of Blender may not have."""

import io

from ..base.failures import Refusal
from .figure import Area, Dot
from .svg import DASHES

#: Of PDF, in a millimeter.
_POINTS = 72.0 / 25.4


def bytes_of(figure):
    """The whole file. Raises Refusal without reportlab."""
    kept = io.BytesIO()
    canvas = _canvas_module().Canvas(kept, pagesize=(figure.width * _POINTS, figure.height * _POINTS), invariant=1)
    canvas.setCreator('Splinewright')
    draw(canvas, figure)
    canvas.showPage()
    canvas.save()
    return kept.getvalue()


def _canvas_module():
    try:
        from reportlab.pdfgen import canvas
    except ImportError as error:
        raise Refusal("PDF needs the Python package reportlab, which this Blender lacks: install it, for example by sudo apt install "
                      "python3-reportlab on Debian and Ubuntu, or export SVG") from error
    return canvas


def draw(canvas, figure, left=0.0, bottom=0.0):
    """Draw a figure on a canvas of reportlab, with its lower left corner at a place in mm."""
    canvas.saveState()
    canvas.translate(left * _POINTS, (bottom + figure.height) * _POINTS)
    canvas.scale(_POINTS, -_POINTS)
    box = canvas.beginPath()
    box.rect(0, 0, figure.width, figure.height)
    if figure.white:
        canvas.setFillColorRGB(1, 1, 1)
        canvas.drawPath(box, stroke=0, fill=1)
    canvas.clipPath(box, stroke=0, fill=0)
    canvas.setLineJoin(1)
    for group in figure.groups:
        for item in group.items:
            _draw(canvas, item)
    canvas.restoreState()


def _draw(canvas, item):
    if isinstance(item, Dot):
        canvas.setFillColorRGB(*item.color)
        canvas.circle(*item.center, item.diameter / 2, stroke=0, fill=1)
    elif isinstance(item, Area):
        canvas.setFillColorRGB(*item.color)
        canvas.drawPath(_path(canvas, item.paths), stroke=0, fill=1, fillMode=1)
    else:
        canvas.setStrokeColorRGB(*item.color)
        canvas.setLineWidth(item.width)
        canvas.setLineCap(0 if item.dashed else 1)
        canvas.setDash([part * item.width for part in DASHES] if item.dashed else [])
        canvas.drawPath(_path(canvas, item.paths), stroke=1, fill=0)


def _path(canvas, paths):
    found = canvas.beginPath()
    for path in paths:
        found.moveTo(*path.start)
        before = path.start
        for step in path.steps:
            _go(found, before, step)
            before = step[-1]
        if path.closed:
            found.close()
    return found


def _go(found, before, step):
    """PDF has lines and cubics; a parabola is raised to a cubic."""
    if len(step) == 1:
        found.lineTo(*step[0])
    elif len(step) == 2:
        found.curveTo(*((before + 2.0 * step[0]) / 3.0), *((2.0 * step[0] + step[1]) / 3.0), *step[1])
    else:
        found.curveTo(*step[0], *step[1], *step[2])
