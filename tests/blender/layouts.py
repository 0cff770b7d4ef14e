"""Panels drawn without a window: what they say, and every property that they show is read."""

from types import SimpleNamespace

import bpy

from support import part


class Layout:
    """Stands for Blender's UILayout."""

    def __init__(self, whole=None):
        for name in ('texts', 'props', 'operators', 'disabled', 'menus'):        # those of the whole, in its parts too
            object.__setattr__(self, name, getattr(whole, name) if whole else [])
        object.__setattr__(self, 'enabled', whole.enabled if whole else True)

    def __setattr__(self, name, value):
        """Such as alert, which says nothing. A part of what is gray is gray."""
        if name == 'enabled':
            object.__setattr__(self, name, self.enabled and value)

    def label(self, text="", **_):
        self.texts.append(text)

    def prop(self, data, name, text="", **_):
        getattr(data, name)
        self.texts.append(text)
        self.props.append(name)

    def operator(self, name, text="", **_):
        self.operators.append(name)
        if not self.enabled:
            self.disabled.append(name)
        module, function = name.split(".")
        self.texts.append(text or getattr(getattr(bpy.ops, module), function).get_rna_type().name)
        return SimpleNamespace()

    def operator_menu_enum(self, name, enum, text="", **_):
        self.operator(name, text)

    def separator(self, **_):
        """Nothing to say."""

    def popover(self, *_, **__):
        """Nothing to say."""

    def menu(self, name, **_):
        self.menus.append(name)

    def template_list(self, kind, _name, data, items, active, number, **_):
        """Each row, as the list draws it."""
        for index, item in enumerate(getattr(data, items)):
            getattr(bpy.types, kind).draw_item(SimpleNamespace(), bpy.context, Layout(self), data, item, 0, active, number, index)

    def context_pointer_set(self, *_):
        """Nothing to say."""

    def _part(self, *_, **__):
        return Layout(self)

    row = column = box = split = grid_flow = _part


def panels():
    """Every panel of ours."""
    rooms = part('ui')._rooms()
    return [cls for room in rooms for cls in room.CLASSES if issubclass(cls, bpy.types.Panel)]


def drawn_by(panel, context):
    """The layout of one panel."""
    layout = Layout()
    own = {name: getattr(panel, name) for name in dir(panel) if not name.startswith('__')}
    panel.draw(SimpleNamespace(**{**own, 'layout': layout}), context)
    return layout


def drawn():
    """All that the panels say of the active object, in one line."""
    layout = Layout()
    for panel in panels():
        if not hasattr(panel, 'poll') or panel.poll(bpy.context):
            layout.texts.extend(drawn_by(panel, bpy.context).texts)
    return " ".join(layout.texts)


def sidebar(context):
    """The layout of what the sidebar shows of a shape, its construction, how it is shown, and of its control points."""
    whole = Layout()
    for name in ('shape', 'construction', 'display', 'points'):
        panel = getattr(bpy.types, f"SPLINEWRIGHT_PT_{name}")
        if panel.poll(context):
            own = drawn_by(panel, context)
            for what in ('texts', 'props', 'operators', 'disabled', 'menus'):
                getattr(whole, what).extend(getattr(own, what))
    return whole
