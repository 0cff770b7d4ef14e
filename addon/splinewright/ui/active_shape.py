"""The active shape, and its active pieces: the numbers with which operators begin that ask for pieces of a shape."""

import numpy as np

from ..bridge.cage import net_object
from ..bridge.data import settings, store
from ..bridge.net import live, selection
from ..bridge.recipes import recipes
from ..bridge.shape import shape
from . import editing
from .ui_state import ui_state

_NAMES = ('piece', 'other_piece')


def shape_of(ob):
    """The shape that an object is, or whose net it is; None where it is neither."""
    owner = net_object.shape_of(ob) if net_object.is_net(ob) else ob
    return owner if shape.has_shape(owner) else None


def shapes(context):
    """The shapes whose nets are edited, or those that are selected in Object Mode."""
    obs = editing.nets_in_edit_mode(context) or (context.selected_objects if context.mode == 'OBJECT' else [])
    return [owner for owner in map(shape_of, obs) if owner is not None]


def is_free(ob):
    """Whether the definition of a shape may be changed by hand: it is not linked, nor is it made by a recipe."""
    try:
        return not ob.data.library and not recipes.has(ob.data)
    except store.UnreadableDefinition:
        return False


def pieces_of_points(ob):
    """Numbers from 0 of the pieces that have a selected point or handle of a net in Edit Mode; of all where none is
    selected."""
    session = live.known_session(ob.data)
    if session is None:
        return []
    rows = session.net.rows[selection.selected(ob, session.net)]
    pieces = session.net.definition.pieces
    return [i for i, piece in enumerate(pieces) if not len(rows) or np.isin(rows, piece.indices).any()]


def whole_pieces(ob):
    """Numbers from 0 of the pieces of which all points of a net in Edit Mode are selected."""
    session = live.known_session(ob.data)
    if session is None:
        return []
    rows = session.net.rows[selection.selected(ob, session.net)]
    return [i for i, piece in enumerate(session.net.definition.pieces) if np.isin(piece.indices, rows).all()]


def of(data):
    """(piece, other piece) of a data-block, counted from 1; 0 for none."""
    count = count_of(data)
    return tuple(number if number <= count else 0 for number in (getattr(settings.of(data), name) for name in _NAMES))


def count_of(data):
    """How many pieces a shape has; 0 where it cannot be read."""
    try:
        definition = store.read(data)
    except store.UnreadableDefinition:
        return 0
    return len(definition.pieces) if definition else 0


def counted(data):
    """The numbers of the pieces of a shape."""
    return tuple(range(1, count_of(data) + 1))


def take(data, number, is_other=False):
    """Make a piece active. One piece is not both."""
    mine, others = _NAMES[::-1] if is_other else _NAMES
    setattr(settings.of(data), mine, number)
    if getattr(settings.of(data), others) == number:
        setattr(settings.of(data), others, 0)


def keep(data, parents):
    """After a verb, the active one is the first piece of those that came from it. parents: as of core.verbs.verbs.Changed."""
    chosen = settings.of(data)
    for name in _NAMES:
        number = getattr(chosen, name)
        if number:
            setattr(chosen, name, parents.index(number - 1) + 1 if number - 1 in parents else 0)


def begin(operator, obs, nets=()):
    """Set an operator's `piece`, where it was not given, to the active piece: of one shape, as several have several; and
    where its net is edited to the one of the selected points."""
    shapes = [ob for ob in obs if shape.has_shape(ob)]
    if len(shapes) == 1 and not operator.properties.is_property_set('piece'):
        operator.piece = chosen(shapes[0].data, nets[0] if nets else None) or operator.piece


def chosen(data, net=None):
    """The number of the piece that has all selected points of a net, or the active one; 0 for none."""
    of_points = pieces_of_points(net) if net else ()
    alone = of_points[0] + 1 if len(of_points) == 1 < count_of(data) else 0
    return alone or of(data)[0]


def begin_pair(operator, context):
    """Set an operator's `first` and `second`, where neither was given: two pieces of a shape, or one of each of two."""
    given = operator.properties.is_property_set
    if given('first') or given('second'):
        return
    other = next((ob for ob in context.selected_objects if ob != context.object), None)
    operator.first, second = of(context.object.data)
    operator.second = of(other.data)[0] if other else second


def forget_asked():
    """An operator that asks for pieces begins."""
    ui_state.asked.clear()


def note(operator, setting, ob, numbers=None):
    """A setting of an operator names a piece of an object. numbers: by which it means the pieces that are there now, 0
    for one that it does not mean; as they are counted if none are given."""
    numbers = counted(ob.data) if numbers is None else tuple(numbers)
    ui_state.asked.setdefault((type(operator).__name__, setting), {})[ob.name] = numbers


def note_pair(operator, ob, parents, parted):
    """note() the `first` and `second` piece of an operator that made one shape of two, of which the former had `parted`
    pieces; of one shape where that is None."""
    forget_asked()
    note(operator, 'first', ob, [parent + 1 if parted is None or parent < parted else 0 for parent in parents])
    note(operator, 'second', ob, [max(parent + 1 - (parted or 0), 0) for parent in parents])


def asked(operator):
    """{setting: {name of an object: numbers of its pieces}} that were noted for the last operator; {} for another one."""
    return {setting: found for (name, setting), found in ui_state.asked.items() if name == operator.bl_idname}
