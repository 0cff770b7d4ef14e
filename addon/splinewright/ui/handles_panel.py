"""The types of the handles of selected joints, and buttons that set them, while the net of a chain is edited."""

from ..bridge.cage import net_splines
from ..bridge.curve import handles as kept_types
from ..core.base.words import phrase, say
from ..core.net import handles
from . import texts

#: What Blender's operator calls a type, what its button says, and its icon.
_TYPES = {handles.AUTO: ('AUTOMATIC', "Automatic", 'HANDLE_AUTO'), handles.VECTOR: ('VECTOR', "Vector", 'HANDLE_VECTOR'),
          handles.ALIGNED: ('ALIGNED', "Aligned", 'HANDLE_ALIGNED'), handles.FREE: ('FREE_ALIGN', "Free", 'HANDLE_FREE')}


def draw(layout, net_data, shape_data, session, vertices):
    """For the selected vertices of the net of a shape, in Edit Mode."""
    if not session.net.chains:
        return
    problem = kept_types.problem(shape_data)
    if problem:
        texts.draw_problem(layout, problem)
    found = types_of(net_data, session, vertices)
    if found:
        column = layout.column(align=True)
        column.label(text=say(phrase("Handles: {types}", types=in_words(found) if len(found) < 3 else phrase("Several"))))
        row = column.row(align=True)
        for letter, (name, _, icon) in _TYPES.items():
            row.operator("curve.handle_type_set", text="", icon=icon, depress=found == {letter}).type = name


def types_of(net_data, session, vertices):
    """The letters of the types of handles that belong to these vertices of a net."""
    chosen = set()
    for first, spline in session.net.chains:
        joints = {(vertex - first) // 3 for vertex in vertices if first <= vertex < first + 3 * spline.count}
        chosen |= {first + 3 * joint + side for joint in joints for side in (0, 2)}
    slots = session.slots[sorted(chosen)]
    return net_splines.letters_of(net_data, slots[slots >= 0].tolist())


def in_words(letters):
    return ", ".join(say(words) for letter, (_, words, _) in _TYPES.items() if letter in letters)
