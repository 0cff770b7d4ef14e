"""A figure as SVG: lines L, parabolas Q and cubics C."""

from xml.etree import ElementTree

from .figure import Area, Dot

_NAMESPACE = "http://www.w3.org/2000/svg"
_LETTERS = {1: 'L', 2: 'Q', 3: 'C'}
#: What is drawn and what is left out of a dashed line, in widths of the line.
DASHES = 4.0, 3.0
#: Digits of a millimeter of what is drawn, and of letters.
_DIGITS, _OF_LETTERS = 9, 4


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
        ElementTree.SubElement(element, 'path', d=data(item.paths, _OF_LETTERS if item.text else _DIGITS), fill=_color(item.color), **more)
    else:
        dashes = " ".join(_number(part * item.width) for part in DASHES)
        more = {'stroke-dasharray': dashes, 'stroke-linecap': 'butt'} if item.dashed else {'stroke-linecap': 'round'}
        ElementTree.SubElement(element, 'path', {
            'd': data(item.paths), 'fill': 'none', 'stroke': _color(item.color), 'stroke-width': _number(item.width),
            'stroke-linejoin': 'round', **more})


def data(paths, digits=_DIGITS):
    """The commands of Paths, with a number of digits of a millimeter."""
    return " ".join(command for path in paths for command in _commands(path, digits))


def _commands(path, digits):
    yield f"M{_pair(path.start, digits)}"
    for step in path.steps:
        yield _LETTERS[len(step)] + " ".join(_pair(point, digits) for point in step)
    if path.closed:
        yield 'Z'


def _pair(point, digits):
    return f"{_number(point[0], digits)},{_number(point[1], digits)}"


def _number(value, digits=_DIGITS):
    return f"{round(float(value), digits) + 0.0:.{digits}f}".rstrip('0').rstrip('.')


def _color(color):
    return "#" + "".join(f"{round(255 * channel):02x}" for channel in color)


def _printable(text):
    """Without what XML cannot hold."""
    return "".join(letter for letter in text if letter.isprintable()).encode('utf-8', 'replace').decode('utf-8')
