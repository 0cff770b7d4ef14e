"""Figures as files: what stands in them, read again."""

import re
import zlib
from xml.etree import ElementTree

import numpy as np
import pytest

from addon_core import core

figures, letters, paths, pdf, svg = (core(f"figures.{name}") for name in ('figure', 'letters', 'paths', 'pdf', 'svg'))
labels, failures = core("formulas.labels"), core("base.failures")
NAMESPACE = "{http://www.w3.org/2000/svg}"
RED = (1.0, 0.0, 0.0)


def path(*points, closed=False):
    """A Path whose steps have these numbers of points."""
    start, *steps = (np.array(step, float).reshape(-1, 2) for step in points)
    return paths.Path(start[0], tuple(steps), closed)


LINE, PARABOLA, CUBIC = path((0, 0), (10, 5)), path((1, 2), (3, 4, 5, 6)), path((1, 1), (2, 0.1, 3, 1 / 3, 4, 1))


def figure(*items, white=True):
    return figures.Figure(160.0, 90.0, white, (figures.Group("things & <more>", items),))


def read(made):
    return ElementTree.fromstring(svg.text_of(made).encode())


def test_the_page_has_its_size_in_millimeters():
    root = read(figure())
    assert (root.get('width'), root.get('height'), root.get('viewBox')) == ("160mm", "90mm", "0 0 160 90")
    assert root.find(f".//{NAMESPACE}title").text == "things & <more>"


def test_lines_parabolas_and_cubics_have_their_commands():
    root = read(figure(figures.Stroke((LINE, PARABOLA, CUBIC), RED, 0.5)))
    (element,) = root.iter(f"{NAMESPACE}path")
    assert element.get('d') == "M0,0 L10,5 M1,2 Q3,4 5,6 M1,1 C2,0.1 3,0.333333333 4,1"
    assert (element.get('stroke'), element.get('stroke-width'), element.get('fill')) == ("#ff0000", "0.5", "none")


def test_closed_paths_and_tiny_numbers():
    closed = path((0, 0), (1, -1e-12), (1, 1), (0, 0), closed=True)
    assert svg.data([closed]) == "M0,0 L1,0 L1,1 L0,0 Z"


def test_a_page_is_white_or_transparent():
    def rectangles(white):
        return [element for element in read(figure(white=white)) if element.tag == f"{NAMESPACE}rect"]
    assert [element.get('fill') for element in rectangles(True)] == ["#ffffff"] and rectangles(False) == []


def test_dashes_and_dots():
    root = read(figure(figures.Stroke((LINE,), RED, 0.5, dashed=True), figures.Dot((3.0, 4.0), 1.5, RED)))
    assert root.find(f".//{NAMESPACE}path").get('stroke-dasharray') == "2 1.5"
    circle = root.find(f".//{NAMESPACE}circle")
    assert (circle.get('cx'), circle.get('cy'), circle.get('r')) == ("3", "4", "0.75")


def box_letter(character):
    """As wide as its number among letters, with a box in it; a space has none."""
    if character == " ":
        return letters.Letter(0.25, ())
    return letters.Letter(0.5, (path((0, 0), (0.4, 0), (0.4, 1), (0, 1), (0, 0), closed=True),))


def test_a_label_has_its_parts_beside_each_other():
    area = letters.label(labels.Label("P", "0,1", "  w", (0, 0, 0)), (10.0, 20.0), 4.0, RED, box_letter)
    assert area.text == "P0,1  w" and len(area.paths) == 5
    lefts = [each.start[0] for each in area.paths]
    assert lefts[0] == pytest.approx(10 + 0.43 * 4) and lefts[1] == pytest.approx(lefts[0] + 2.0)
    assert lefts[4] == pytest.approx(lefts[1] + 3 * 0.72 * 2.0 + 2 * 1.0)
    assert area.paths[1].start[1] > area.paths[0].start[1], "below the line, where y goes down"
    tops = [each.steps[1][0][1] for each in area.paths]
    assert tops[0] == pytest.approx(20 - 0.36 * 4 - 4) and tops[1] == pytest.approx(20 - 0.36 * 4 + 1 - 0.72 * 4)


def test_the_width_of_a_text_is_where_the_next_begins():
    _, end = letters.written("ab c", 3.0, 0.0, 2.0, box_letter)
    assert end == pytest.approx(3.0 + letters.width("ab c", 2.0, box_letter)) == pytest.approx(3.0 + 2.0 * 1.75)


def test_letters_say_what_they_are():
    area = letters.label(labels.Label("Ж", "", "", (0, 0, 0)), (1.0, 1.0), 4.0, RED, box_letter)
    (element,) = read(figure(area)).iter(f"{NAMESPACE}path")
    assert element.get('aria-label') == "Ж" and element.get('fill') == "#ff0000" and element.get('stroke') is None


@pytest.mark.parametrize('color', ((1, 1, 1, 1), (0.9, 0.9, 0.9), (0, 0, 0), (0.34, 0.71, 0.91), (0.9, 0.62, 0), (1, 1, 0), (0.1, 0.15, 0.45)))
def test_ink_is_dark_and_keeps_its_hue(color):
    found = np.array(figures.ink(color))
    assert found @ (0.2126, 0.7152, 0.0722) <= 0.56 and (found >= 0).all()
    given = np.array(color[:3], float)
    if np.ptp(given) > 0.2:
        assert np.allclose(found / found.max(), given / given.max())
    if (given @ (0.2126, 0.7152, 0.0722)) < 0.2:
        assert np.allclose(found, given)
    assert figures.ink((1, 1, 1)) == figures.ink((0, 0, 0)) == (0, 0, 0)


def test_the_head_of_an_arrow_points_from_its_foot():
    (head,) = figures.arrow_head(np.array([0.0, 0]), np.array([10.0, 0]))
    corners = np.vstack([head.start, *head.steps])
    assert corners[:, 0].tolist() == pytest.approx([10, 7.6, 7.6, 10]) and abs(corners[1, 1]) == pytest.approx(0.6)
    assert figures.arrow_head(np.zeros(2), np.zeros(2)) == ()


def test_a_pdf_has_the_same_cubics():
    pytest.importorskip("reportlab")
    found = pdf.bytes_of(figure(figures.Stroke((LINE, PARABOLA, CUBIC), RED, 0.5), figures.Area((CUBIC,), RED), figures.Dot((1.0, 2.0), 1.0, RED)))
    assert found.startswith(b"%PDF")
    width, height = map(float, re.search(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+) \]", found).groups())
    assert (width, height) == pytest.approx((160 / 25.4 * 72, 90 / 25.4 * 72), abs=0.01)
    drawn = stream_of(found)
    assert "2 .1 3 .333333 4 1 c" in drawn and "10 5 l" in drawn
    assert "2.333333 3.333333 3.666667 4.666667 5 6 c" in drawn, "a parabola is raised"


def stream_of(found):
    """What is drawn on the one page, as text."""
    import base64
    raw = re.search(rb"stream\r?\n(.*?)endstream", found, re.S)[1].strip()
    return zlib.decompress(base64.a85decode(raw, adobe=False) if raw.endswith(b"~>") is False else base64.a85decode(raw[:-2])).decode()


def test_without_reportlab_a_sentence_says_how_to_get_it(monkeypatch):
    monkeypatch.setitem(__import__('sys').modules, 'reportlab.pdfgen', None)
    with pytest.raises(failures.Refusal, match="python3-reportlab"):
        pdf.bytes_of(figure())
