"""Fields in a layout whose labels are never cut off: one that has no room beside its value stands above it."""

import bpy

from ..core.base.words import say
from . import texts

#: In pixels of an interface that is not scaled: what a number takes with the sides of its field, what a choice takes at least, and besides
#: its words.
_NUMBER, _CHOICE, _ARROW = 84, 84, 36


def number(layout, data, name, label="", beside=0):
    """A number. beside: in pixels of an interface that is not scaled, what stands beside it or is set in."""
    words = say(label or data.bl_rna.properties[name].name)
    if texts.fits(words, _NUMBER + beside):
        layout.prop(data, name, text=words)
    else:
        layout.label(text=words)
        layout.prop(data, name, text="")


def choice(layout, data, name, label="", beside=0):
    """A choice, a text or an object. Returns the row that it stands in."""
    words = say(label or data.bl_rna.properties[name].name)
    if texts.fits(words, beside + max(_CHOICE, _ARROW + _widest(data.bl_rna.properties[name]))):
        split = layout.split(factor=texts.share([words], beside), align=True)
        split.label(text=words)
        row = split.row(align=True)
    else:
        layout.label(text=words)
        row = layout.row(align=True)
    row.prop(data, name, text="")
    return row


def _widest(known):
    """The width of the longest of the choices that a property has, in pixels of an interface that is not scaled."""
    if known.type != 'ENUM' or not texts.is_drawn():
        return 0.0
    said = [bpy.app.translations.pgettext_iface(item.name, known.translation_context) for item in known.enum_items]
    return max(map(texts.width_of, said), default=0.0) / bpy.context.preferences.system.ui_scale
