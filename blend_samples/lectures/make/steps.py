"""The steps by which a picture is made: each is one thing that a user does, an entry of a menu with its fields, a click, a key."""

from typing import NamedTuple


class Step(NamedTuple):
    """A call of an operator of Blender or of ours; or one of two words for what only a mouse does."""

    operator: str
    settings: dict


class Picture(NamedTuple):
    """A picture of the lectures."""

    number: str                         # of the lecture, and of the item there
    title: str
    most: int                           # steps in which it can be made
    steps: tuple
    view: str = 'TOP'                   # 'TOP', 'FRONT', or 'SPACE': from the side and above
    rendered: bool = False              # where light on faces is what it shows


#: Clicks that no operator stands for: on objects, on control points.
CLICK, CHOOSE = "click", "choose"


def add(kind, **settings):
    """An entry of the Add menu or of NURBS > Teaching."""
    return Step(f"splinewright.add_{kind}", settings)


def call(operator, **settings):
    return Step(operator if "." in operator else f"splinewright.{operator}", settings)


def show(sight):
    """A switch of the Overlays popover."""
    return call('show_sight', sight=sight)


def click(*numbers):
    """Select objects in the order in which they were made, from 0; the first one is active."""
    return Step(CLICK, {'numbers': numbers})


def choose(*numbers):
    """Select control points of the net."""
    return Step(CHOOSE, {'numbers': numbers})


def move(x, y, z=0.0):
    return call('transform.translate', value=(x, y, z))


def together():
    """S 0: the selected points become one, in their middle."""
    return call('transform.resize', value=(0.0, 0.0, 0.0))


EDIT, DONE = call('edit_net'), call('leave_net')
NET, LABELS, KNOTS = show('NET'), show('LABELS'), show('KNOTS')


def bent(number, x, y, z=0.0):
    """Edit one control point: four steps."""
    return EDIT, choose(number), move(x, y, z), DONE


#: A bent Hermite segment with its derivatives in their true length.
HERMITE = (add('bezier_curve', degree=3), call('to_hermite'), add('marks', steps=0, marker=0.02, derivatives=True))


def joined(number, continuity):
    """Two curves, the second turned, joined at their near ends, beside as many such pairs as were made before."""
    place = 5.0 * number
    return (add('bezier_curve', degree=3, location=(place, 0.0, 0.0)),
            add('bezier_curve', degree=3, location=(place + 2.0, 0.7, 0.0), rotation=(0.0, 0.0, 0.9)),
            click(2 * number, 2 * number + 1), call('join_ends', continuity=continuity))
