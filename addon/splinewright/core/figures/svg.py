"""A figure as SVG: lines L, parabolas Q and cubics C."""

from xml.etree import ElementTree

from .figure import Area, Dot

_NAMESPACE = "http://www.w3.org/2000/svg"
_LETTERS = {1: 'L', 2: 'Q', 3: 'C'}
#: What is drawn and what is left out of a dashed line, in widths of the line.
DASHES = 4.0, 3.0


def text_of(figure):
    """The whole file."""
    size = {'width': f"{_number(figure.width)}mm", 'height': f"{_number(figure.height)}mm",
            'viewBox': f"0 0 {_number(figure.width)} {_number(figure.height)}"}
    root = ElementTree.Element('svg', xmlns=_NAMESPACE, version="1.1", **size)
    box = {'width': _number(figure.width), 'height': _number(figure.height)}
    defined = ElementTree.SubElement(ElementTree.SubElement(root, 'defs'), 'clipPath', id="page")
    ElementTree.SubElement(defined, 'rect', box)
    if figure.white:
        ElementTree.SubElement(root, 'rect', box, fill="#ffffff")
    drawing = ElementTree.SubElement(root, 'g', {'clip-path': "url(#page)"})
    for group in figure.groups:
        element = ElementTree.SubElement(drawing, 'g')
        ElementTree.SubElement(element, 'title').text = _printable(group.name)
        for item in group.items:
            _add(element, item)
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="utf-8"?>\n' + ElementTree.tostring(root, encoding='unicode') + "\n"


def _add(element, item):
    if isinstance(item, Dot):
        x, y = item.center
        ElementTree.SubElement(element, 'circle', cx=_number(x), cy=_number(y), r=_number(item.diameter / 2), fill=_color(item.color))
    elif isinstance(item, Area):
        more = {'aria-label': _printable(item.text)} if item.text else {}
        ElementTree.SubElement(element, 'path', d=data(item.paths), fill=_color(item.color), **more)
    else:
        dashes = " ".join(_number(part * item.width) for part in DASHES)
        more = {'stroke-dasharray': dashes, 'stroke-linecap': 'butt'} if item.dashed else {'stroke-linecap': 'round'}
        ElementTree.SubElement(element, 'path', {
            'd': data(item.paths), 'fill': 'none', 'stroke': _color(item.color), 'stroke-width': _number(item.width),
            'stroke-linejoin': 'round', **more})


def data(paths):
    """The commands of Paths."""
    return " ".join(command for path in paths for command in _commands(path))


def _commands(path):
    yield f"M{_pair(path.start)}"
    for step in path.steps:
        yield _LETTERS[len(step)] + " ".join(map(_pair, step))
    if path.closed:
        yield 'Z'


def _pair(point):
    return f"{_number(point[0])},{_number(point[1])}"


def _number(value):
    """With a billionth of a millimeter."""
    return f"{round(float(value), 9) + 0.0:.9f}".rstrip('0').rstrip('.')


def _color(color):
    return "#" + "".join(f"{round(255 * channel):02x}" for channel in color)


def _printable(text):
    """Without what XML cannot hold."""
    return "".join(letter for letter in text if letter.isprintable()).encode('utf-8', 'replace').decode('utf-8')
