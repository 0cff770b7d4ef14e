"""How wide the texts of a panel are, and how much width Blender's layout gives to each, in pixels.

A panel draws into a Recorder in place of its layout. As Blender does it, what has no words is as wide as an icon, all else in a row has
equal parts of the rest, and a column has the whole width. How much of that is left for words is measured in pictures.
"""

from types import SimpleNamespace
from typing import NamedTuple

import blf
import bpy

#: Of an interface that is not scaled: an icon or a row's height, what words ask for in a row, between what is not aligned, around a box.
_UNIT, _WORDS, _SPACE, _BOX = 20, 200, 8, 5
#: Of a region its tabs and the margins of a panel; of a title besides them the triangle and the grip.
_TABS, _TITLE = 46, 14 + 16
#: What lies beside the words of a field, as pictures show it, of a number its first digits, too; an icon, and what is between it and the words of a label.
_SIDES = {'label': 6, 'button': 6, 'option': 23, 'number': 68, 'choice': 26, 'text': 14, 'menu': 26}
_ICON, _AFTER_ICON = 18, 8
#: A letter of an axis, or a number of a list, goes where there is no room for it and digits.
_LETTERS = 3


class Field(NamedTuple):
    """What may have words."""

    kind: str                           # of _SIDES, or 'gap'
    words: str
    has_icon: bool = False
    width: float = 0.0                  # that it asks for, where that is another than of others


class Recorder:
    """Stands for Blender's UILayout."""

    def __init__(self, direction='column', align=False, factor=0.0, columns=1):
        self.direction, self.align, self.factor, self.columns, self.items = direction, align, factor, columns, []

    def _part(self, direction, align=False, **more):
        self.items.append(Recorder(direction, align, **more))
        return self.items[-1]

    def row(self, align=False, **_):
        return self._part('row', align)

    def column(self, align=False, **_):
        return self._part('column', align)

    def box(self):
        return self._part('box')

    def split(self, factor=0.0, align=False):
        return self._part('split', align, factor=factor)

    def grid_flow(self, columns=1, align=False, **_):
        return self._part('grid', align, columns=columns)

    def _add(self, kind, words, icon='NONE'):
        self.items.append(Field(kind, words, icon != 'NONE'))

    def label(self, text="", icon='NONE', **_):
        self._add('label', _translated(text), icon)

    def operator(self, name, text=None, icon='NONE', **_):
        self._add('button', _name_of(name) if text is None else _translated(text, "Operator"), icon)
        return SimpleNamespace()

    def operator_menu_enum(self, name, _property, text=None, icon='NONE', **_):
        self._add('menu', _name_of(name) if text is None else _translated(text, "Operator"), icon)

    def menu(self, name, text=None, icon='NONE', **_):
        self._add('menu', _translated(getattr(bpy.types, name).bl_label if text is None else text), icon)

    def separator(self, factor=1.0, **_):
        self.items.append(Field('gap', "", width=0.3 * _UNIT * factor))

    def popover(self, *_, text="", icon='NONE', **__):
        self._add('menu', _translated(text), icon)

    def context_pointer_set(self, *_):
        """Nothing to show."""

    def template_list(self, kind, _name, data, items, active, number, **_):
        """Each row, as the list draws it."""
        rows = self.column()
        rows.items.append(Field('gap', "", width=_WORDS))
        for index, item in enumerate(getattr(data, items)):
            getattr(bpy.types, kind).draw_item(SimpleNamespace(), bpy.context, rows.row(), data, item, 0, active, number, index)

    def prop(self, data, name, text=None, icon='NONE', index=-1, expand=False, **_):
        known = data.bl_rna.properties[name]
        words = _translated(known.name, known.translation_context) if text is None else _translated(text)
        if expand:
            part = self.row(align=True) if self.direction == 'row' else self.column(align=True)
            for item in known.enum_items:
                part._add('button', _translated(item.name, known.translation_context))
        elif known.type == 'BOOLEAN':
            self._add('option', words, icon)
        elif known.type in ('INT', 'FLOAT') and known.is_array and index < 0 and known.subtype in ('COLOR', 'COLOR_GAMMA'):
            part = self.column(align=True)
            part._add('label', words)
            part._add('text', "")
        elif known.type in ('INT', 'FLOAT'):
            values = [getattr(data, name)] if not known.is_array else [getattr(data, name)[index]] if index >= 0 else list(getattr(data, name))
            for _ in values:
                self._add('number', words if len(words) > _LETTERS else " ", icon)
        else:
            self._chosen(data, name, known, words, icon)

    def _chosen(self, data, name, known, words, icon):
        """A choice, or a text or object, which a user has named: after its label, which asks for a third of what that does."""
        part = self.row(align=self.align) if words else self
        if words:
            part.items.append(Field('label', f"{words}:", width=_WORDS / 3))
        value = getattr(data, name)
        chosen = known.enum_items[value].name if known.type == 'ENUM' and value in known.enum_items else ""
        part._add('choice' if known.type == 'ENUM' else 'text', _translated(chosen, known.translation_context) or " ", icon)


def _translated(text, context="*"):
    return bpy.app.translations.pgettext_iface(text, context) if text else ""


def _name_of(operator):
    room, _, name = operator.partition(".")
    return _translated(getattr(getattr(bpy.ops, room), name).get_rna_type().name, "Operator")


def _scale():
    return bpy.context.preferences.system.ui_scale


def _is_fixed(item):
    """Whether it stays as narrow as it is."""
    return not item.words if isinstance(item, Field) else item.direction != 'box' and bool(item.items) and all(map(_is_fixed, item.items))


def _wanted(item):
    """The width that it asks for in a row."""
    if isinstance(item, Field):
        return item.width or (_WORDS if item.words else _UNIT)
    widths = list(map(_wanted, item.items)) or [0]
    if item.direction in ('row', 'split'):
        return sum(widths) + (len(widths) - 1) * _space(item)
    return max(widths) * item.columns + (2 * _BOX if item.direction == 'box' else 0)


def _space(item):
    return 0 if item.align else _SPACE


def placed(item, width):
    """(Field, its width) of all within a layout of a width."""
    if isinstance(item, Field):
        yield item, width
        return
    for part, share in zip(item.items, _shares(item, width)):
        yield from placed(part, share)


def _shares(item, width):
    count = len(item.items)
    if item.direction in ('column', 'box'):
        return [width - (2 * _BOX if item.direction == 'box' else 0)] * count
    if item.direction == 'grid':
        return [(width - (item.columns - 1) * _space(item)) / item.columns] * count
    room = width - (count - 1) * _space(item)
    if item.direction == 'split':
        first = room * (item.factor or 1 / count)
        return [first, *[(room - first) / max(count - 1, 1)] * (count - 1)]
    fixed = sum(_wanted(part) for part in item.items if _is_fixed(part))
    free = sum(_wanted(part) for part in item.items if not _is_fixed(part)) or 1
    return [_wanted(part) if _is_fixed(part) else max(room - fixed, 0) * _wanted(part) / free for part in item.items]


def width_of(words, style='widget'):
    """In pixels of an interface that is not scaled."""
    blf.size(0, getattr(bpy.context.preferences.ui_styles[0], style).points * _scale())
    return blf.dimensions(0, words)[0] / _scale()


def room_of(field, width):
    """How much of the width of a field its words may take."""
    icon = _ICON + (_AFTER_ICON if field.kind == 'label' else 0)
    return width - _SIDES[field.kind] - (icon if field.has_icon else 0)


def drawn(panel, context):
    """The Recorder into which a panel has drawn."""
    layout = Recorder()
    own = {name: getattr(panel, name) for name in dir(panel) if not name.startswith('__')}
    panel.draw(SimpleNamespace(**{**own, 'layout': layout}), context)
    return layout


def too_long(panel, context, region):
    """[(words, the width that they take, that they have)] of a panel in a sidebar: what is cut off."""
    width = region.width / _scale() - _TABS
    title, has_button = _translated(panel.bl_label), hasattr(panel, 'draw_header_preset')
    found = [(title, width_of(title, 'panel_title'), width - _TITLE - (_UNIT if has_button else 0))]
    return [(words, needed, has) for words, needed, has in found if needed > has] + cut_off(drawn(panel, context), region)


def cut_off(layout, region):
    """too_long() of what was drawn into a Recorder."""
    found = [(field.words, width_of(field.words), room_of(field, share))
             for field, share in placed(layout, region.width / _scale() - _TABS) if field.words.strip()]
    return [(words, needed, has) for words, needed, has in found if needed > has]
