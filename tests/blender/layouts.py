"""Panels drawn without a window: what they say, and every property that they show is read."""

from types import SimpleNamespace

import bpy

from support import part


class Layout:
    """Stands for Blender's UILayout."""

    def __init__(self, whole=None):
        for name in ('texts', 'props', 'operators', 'disabled'):        # those of the whole, in its parts too
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

    def separator(self, **_):
        """Nothing to say."""

    def popover(self, *_, **__):
        """Nothing to say."""

    def menu(self, *_, **__):
        """Nothing to say."""

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
