"""Sheets as PDF: A4, by reportlab, with an embedded font that has Latin and Cyrillic letters."""

from functools import cache
from pathlib import Path

from reportlab.lib.pagesizes import A4
from reportlab.lib.styles import ParagraphStyle
from reportlab.lib.units import mm
from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.ttfonts import TTFont
from reportlab.platypus import Flowable, KeepTogether, PageBreak, Paragraph, SimpleDocTemplate, Spacer, Table, TableStyle

#: Debian's fonts-dejavu-core.
_FOLDER = Path("/usr/share/fonts/truetype/dejavu")
_BODY, _BOLD = "DejaVuSans", "DejaVuSans-Bold"
_EDGE, _TEXT, _BETWEEN = 18 * mm, 92 * mm, 4 * mm
#: Lines to write on, by kinds of questions, and how far they lie from each other.
_LINES, _DISTANCE = {'do': 3, 'number': 2, 'point': 2, 'choose': 0}, 8 * mm


class Drawing(Flowable):
    """A figure, by a function that draws it on a canvas."""

    def __init__(self, figure, draw):
        super().__init__()
        self.figure, self._draw = figure, draw
        self.width, self.height = figure.width * mm, figure.height * mm

    def wrap(self, *_):
        return self.width, self.height

    def draw(self):
        self._draw(self.canv, self.figure)


class Lines(Flowable):
    """Space to write."""

    def __init__(self, count):
        super().__init__()
        self.count = count

    def wrap(self, width, _height):
        self.width, self.height = width, self.count * _DISTANCE
        return self.width, self.height

    def draw(self):
        self.canv.setLineWidth(0.4)
        for i in range(self.count):
            self.canv.line(0, i * _DISTANCE + 1, self.width, i * _DISTANCE + 1)


@cache
def _styles():
    for name in (_BODY, _BOLD):
        pdfmetrics.registerFont(TTFont(name, str(_FOLDER / f"{name}.ttf")))
    pdfmetrics.registerFontFamily(_BODY, normal=_BODY, bold=_BOLD, italic=_BODY, boldItalic=_BOLD)
    body = ParagraphStyle("body", fontName=_BODY, fontSize=10, leading=14, spaceAfter=4)
    return {'body': body, 'choice': ParagraphStyle("choice", body, leftIndent=14, bulletFontName=_BODY, bulletFontSize=11),
            'title': ParagraphStyle("title", body, fontName=_BOLD, fontSize=18, leading=24, spaceAfter=10),
            'lesson': ParagraphStyle("lesson", body, fontName=_BOLD, fontSize=13, leading=18, spaceBefore=10, spaceAfter=6)}


def write(path, title, lessons, say, draw):
    """Write the sheets of a lecture. lessons: [(title, [content.Step])]; say: translates a text; draw: a figure on a canvas."""
    document = SimpleDocTemplate(str(path), pagesize=A4, title=title, author="Splinewright", invariant=1, leftMargin=_EDGE, rightMargin=_EDGE,
                                 topMargin=_EDGE, bottomMargin=_EDGE)
    parts = [_paragraph(title, 'title')]
    for number, (name, steps) in enumerate(lessons, 1):
        for place, step in enumerate(steps, 1):
            shown = _step(place, step, say, draw)
            parts.append(KeepTogether([_paragraph(f"{number}. {say(name)}", 'lesson'), shown] if place == 1 else [shown]))
    document.build([*parts, PageBreak(), *_answers(lessons, say)], onFirstPage=_number, onLaterPages=_number)


def _step(place, step, say, draw):
    words = [_paragraph(f"{place}) {say(step.text)}", 'body')]
    words += [Paragraph(_escaped(say(choice)), _styles()['choice'], bulletText="□") for choice in step.choices]
    if _LINES.get(step.kind):
        words.append(Lines(_LINES[step.kind]))
    if step.figure is None:
        return _table([[words]], [A4[0] - 2 * _EDGE])
    return _table([[words, Drawing(step.figure, draw)]], [_TEXT, A4[0] - 2 * _EDGE - _TEXT])


def _table(rows, widths):
    return Table(rows, colWidths=widths, style=TableStyle([
        ('VALIGN', (0, 0), (-1, -1), 'TOP'), ('LEFTPADDING', (0, 0), (0, -1), 0), ('RIGHTPADDING', (0, 0), (-1, -1), _BETWEEN),
        ('BOTTOMPADDING', (0, 0), (-1, -1), _BETWEEN)]))


def _answers(lessons, say):
    found = [_paragraph(say("Answers"), 'title')]
    for number, (name, steps) in enumerate(lessons, 1):
        asked = [(place, step) for place, step in enumerate(steps, 1) if step.kind]
        said = [_paragraph(f"{place}) {say(step.answer)}", 'body') for place, step in asked]
        if said:
            found += [KeepTogether([_paragraph(f"{number}. {say(name)}", 'lesson'), said[0]]), *said[1:], Spacer(1, 2 * mm)]
    return found


def _paragraph(text, style):
    return Paragraph(_escaped(text), _styles()[style])


def _escaped(text):
    """reportlab reads marks in texts."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\n", "<br/>")


def _number(canvas, document):
    canvas.setFont(_BODY, 8)
    canvas.drawCentredString(A4[0] / 2, 9 * mm, str(document.page))
