"""A layout that keeps what panels put into it."""

import types


class Layout:
    """Stands for Blender's UILayout and all that lies in it."""

    def __init__(self):
        self.texts, self.props, self.operators = [], [], []
        self.enabled = True

    def _inner(self, *_, **__):
        return self

    row = column = box = split = grid_flow = _inner

    def separator(self, **_):
        pass

    def context_pointer_set(self, *_):
        pass

    def label(self, text="", **_):
        self.texts.append(text)

    def prop(self, owner, name, **_):
        assert name in owner.bl_rna.properties, f"{owner} has no {name}"
        self.props.append(name)

    def menu(self, name, **_):
        self.texts.append(name)

    def operator(self, name, **_):
        self.operators.append(name)
        return types.SimpleNamespace()


def drawn(panel, context):
    """What a panel's class draws."""
    layout = Layout()
    helpers = {name: getattr(panel, name) for name in dir(panel) if not name.startswith('__')}
    panel.draw(types.SimpleNamespace(**{**helpers, 'layout': layout}), context)
    return layout
