"""What Splinewright remembers of the open file beside what the file says itself.

All of it is worked out again where it is missing, and forgotten when another file is opened: it holds no truth.
"""

from dataclasses import dataclass, field, fields
from functools import cache

import bpy


@dataclass
class FileState:
    """Data-blocks and objects stand here by their keys: references die with undo."""

    followers: set = field(default_factory=set)         # data-blocks that are made from objects; a hint
    causes: object = None                               # the bridge.recipes.causes.Index of the followers, until they have others
    made: dict = field(default_factory=dict)            # of a follower what it was made of last; of bridge.follow.follow
    costs: dict = field(default_factory=dict)           # of a follower the seconds that it took the last two times
    late: dict = field(default_factory=dict)            # the bridge.recipes.late.Delay of followers that are brought up to date later
    put_off_at: float = 0.0                             # when the last one was put off, by bridge.recipes.late.clock()
    put_off_by: tuple = ()                              # the ended_operators() then
    owners: dict = field(default_factory=dict)          # of a follower the key of the object in whose space it lies, or None
    doubtful: set = field(default_factory=set)          # followers that did not follow before all objects became others
    sessions: dict = field(default_factory=dict)        # of a net's token its bridge.net.live.Session, or why there is none
    problems: dict = field(default_factory=dict)        # of a data-block its problems, by what they are about
    magnets: dict = field(default_factory=dict)         # of a scene with a net out what bridge.net.magnet puts back
    drag: tuple = None                                  # the bridge.net.dragging.Drag that goes on, maybe
    selected: dict = field(default_factory=dict)        # of a net's data-block its selected vertices, until it changes
    drawn: dict = field(default_factory=dict)           # of a net's data-block what ui.overlay draws, until it changes
    sights: dict = field(default_factory=dict)          # of a shape's data-block what bridge.analysis.overlays keeps, until it changes
    overlaid: dict = field(default_factory=dict)        # of an object and what it shows that is drawn over it, until anything changes
    targets: dict = field(default_factory=dict)         # of an object its bridge.analysis.deviation_targets.Target, until it changes
    seen: tuple = ()                                    # those when Blender told of a change, or drew
    began: tuple = ()                                   # those when points of a net were copied
    quiet: set = field(default_factory=set)             # data-blocks whose settings change without a new evaluation
    shown: dict = field(default_factory=dict)           # of a data-block the settings by which it was written last
    readings: dict = field(default_factory=dict)        # of a data-block the bridge.data.readings.Reading of its definition
    definitions: dict = field(default_factory=dict)     # of a digest the definition that was read
    touched: dict = field(default_factory=dict)         # of a data-block whether others changed it, until it changes
    by_hand: set = field(default_factory=set)           # data-blocks that were changed in Edit Mode
    surveys: dict = field(default_factory=dict)         # of bridge.analysis.surveys
    wholes: dict = field(default_factory=dict)          # of bridge.analysis.surveys: what shapes measure, None for what takes long
    place: tuple = (None, ())                           # of bridge.analysis.surveys: a place of a shape, and what that measures there
    shows_keys: bool = True                             # whether points go where keys put them
    lost_keys: list = field(default_factory=list)       # of bridge.keys.point_keys: sentences for the next report


state = FileState()


def forget():
    """Another file is open."""
    fresh = FileState()
    for each in fields(FileState):
        setattr(state, each.name, getattr(fresh, each.name))


def ended_operators():
    """What tells those operators that have ended, which Blender remembers, from those at another moment.

    The address of the last one alone does not: one that Blender forgets leaves its own to another.
    """
    return tuple(operator.as_pointer() for operator in bpy.context.window_manager.operators)


def look_again(block):
    """A data-block changed in whatever way: what was worked out for showing it may not be so any more."""
    name = key(block)
    state.selected.pop(name, None)
    state.drawn.pop(name, None)
    state.sights.pop(name, None)
    state.overlaid.clear()
    for ob in [ob for ob, target in state.targets.items() if target.data == name]:
        del state.targets[ob]


def key(block):
    """(the name of its kind, its name, the file it is linked from or ""): what tells it from all others of the file."""
    library = block.library
    return _kind(type(block)), block.name, library.filepath if library else ""


@cache
def _kind(kind):
    return 'curves' if issubclass(kind, bpy.types.Curve) else kind.bl_rna.identifier


_COLLECTIONS = {'curves': 'curves', 'Mesh': 'meshes', 'Object': 'objects'}


def block_of(key):
    """The data-block that has a key, or None."""
    kind, name, library = key
    return getattr(bpy.data, _COLLECTIONS[kind]).get((name, library or None))


def remember(known, key, value, most):
    """Keep a value in a dictionary of limited size; the oldest go."""
    known.pop(key, None)
    while len(known) >= most:
        del known[next(iter(known))]
    known[key] = value
    return value
