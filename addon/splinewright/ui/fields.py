"""Fields in a layout whose labels are never cut off: one that has no room beside its value stands above it."""

from ..core.base.words import say
from . import texts

#: In pixels of an interface that is not scaled: what a number takes with the sides of its field, and a choice with its arrow.
_NUMBER, _CHOICE = 84, 84


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
    if texts.fits(words, _CHOICE + beside):
        split = layout.split(factor=texts.share([words], beside), align=True)
        split.label(text=words)
        row = split.row(align=True)
    else:
        layout.label(text=words)
        row = layout.row(align=True)
    row.prop(data, name, text="")
    return row
