"""What Splinewright remembers of the open file beside what the file says itself.

All of it is worked out anew where it is missing, and forgotten when another file is opened: it holds no truth.
"""

from dataclasses import dataclass, field, fields
from functools import cache

import bpy


@dataclass
class FileState:
    """Data-blocks and objects stand here by their keys: references die with undo."""

    is_scanned: bool = False                            # whether the file was looked through since it was opened
    followers: set = field(default_factory=set)         # data-blocks that are made from objects; a hint
    causes: object = None                               # the bridge.recipes.causes.Index of the followers, until they have others
    made: dict = field(default_factory=dict)            # of a follower what it was made of last; of bridge.follow.follow
    costs: dict = field(default_factory=dict)           # of a follower the seconds that it took the last two times
    late: dict = field(default_factory=dict)            # followers that are brought up to date later; of bridge.recipes.late
    put_off_at: float = 0.0                             # when the last one was put off, by bridge.recipes.late.clock()
    put_off_by: tuple = ()                              # the ended_operators() then
    owners: dict = field(default_factory=dict)          # of a follower the key of the object in whose space it lies, or None
    doubtful: set = field(default_factory=set)          # followers that did not follow before all objects became others
    stopped: tuple = ()                                 # what ui.stopped says in the status bar
    nets: set = field(default_factory=set)              # objects that are nets; a hint
    kept: set = field(default_factory=set)              # nets that were left by other ways and hold what no shape took
    sessions: dict = field(default_factory=dict)        # of a net's token its bridge.net.live.Session, or why there is none
    problems: dict = field(default_factory=dict)        # of a data-block its problems, by what they are about
    magnets: dict = field(default_factory=dict)         # of a scene with a net out what bridge.net.magnet puts back
    drag: tuple = None                                  # the bridge.net.dragging.Drag that goes on, maybe
    selected: dict = field(default_factory=dict)        # of a net's data-block its selected vertices, until it changes
    drawn: dict = field(default_factory=dict)           # of a net's data-block what ui.overlay draws, until it changes
    sights: dict = field(default_factory=dict)          # of a shape's data-block what bridge.analysis.overlays keeps, until it changes
    overlaid: dict = field(default_factory=dict)        # of an object and what it shows that is drawn over it, until anything changes
    targets: dict = field(default_factory=dict)         # of an object its bridge.analysis.deviation_targets.Target, until it changes
    is_still: bool = False                              # whether distances have not changed for a while
    handed: tuple = ()                                  # the ended_operators() when ui.editing looked at copies last
    seen: tuple = ()                                    # those when Blender told of a change, or drew
    began: tuple = ()                                   # those when points of a net were copied
    awaited: tuple = None                               # those when rows were seen that are being cut in
    was_undone: bool = False                            # whether something was since Blender drew
    status: str = ""                                    # what ui.messages says in the status bar
    quiet: set = field(default_factory=set)             # data-blocks whose settings change without a new evaluation
    shown: dict = field(default_factory=dict)           # of a data-block the settings by which it was written last
    readings: dict = field(default_factory=dict)        # of a data-block the bridge.data.readings.Reading of its definition
    definitions: dict = field(default_factory=dict)     # of a digest the definition that was read
    touched: dict = field(default_factory=dict)         # of a data-block whether others changed it, until it changes
    by_hand: set = field(default_factory=set)           # data-blocks that were changed in Edit Mode
    surveys: dict = field(default_factory=dict)         # of bridge.analysis.surveys
    wholes: dict = field(default_factory=dict)          # of bridge.analysis.surveys: what shapes measure, None for what takes long
    place: tuple = (None, ())                           # of bridge.analysis.surveys: a place of a shape, and what that measures there
    suspended: list = field(default_factory=list)       # of ui.saving
    asking: set = field(default_factory=set)            # names of open dialogs that ask for a piece
    asked: dict = field(default_factory=dict)           # of ui.hand: what the last operator asked for pieces of
    picking: dict = field(default_factory=dict)         # while a piece is picked: numbers of pieces by names of objects
    hovered: tuple = ()                                 # the name of an object and the number of its piece at the mouse
    aimed: tuple = None                                 # while a knot is inserted by a click: a ui.aim_overlay.Aim
    is_pointing: bool = False                           # whether an operator waits for what is clicked
    sides: tuple = ()                                   # while sides of patches are picked: (object's name, number, side) each
    rounding: tuple = None                              # while edges are picked that are rounded: ui.edges_overlay.Edges
    edge: tuple = None                                  # of ui.edge_picking, while an edge is picked: the one at the mouse
    drawn_stroke: tuple = ()                            # while one is drawn: its points
    contour: tuple = None                               # while one is drawn: the core.drawing.contours.Contour, and that with the next point
    pulled: tuple = None                                # while a shape is pulled by a point: a ui.pull_overlay.Pull
    measured: tuple = None                              # while one measures by a click: a ui.measure_overlay.Measured
    weighing: tuple = None                              # while weights change by the mouse: a ui.weight_overlay.Weighing
    moved_knot: tuple = None                            # while a knot is moved: a ui.knot_strip.Moved
    pointed_knot: tuple = None                          # of the knot strip, at the mouse: a ui.knot_strip.Pointed
    was_in_result: bool = False                         # whether a mesh or curve of a shape was in Edit Mode; of ui.detour
    selected_shapes: set = field(default_factory=set)   # names, at the last change; of ui.join_notice
    last_join: tuple = ()                               # the ended_operators() when one was looked at; of ui.join_notice
    errands: list = field(default_factory=list)         # of ui.errands, and whether there were some lately
    frame_before: tuple = ()                            # the name of the scene and its frame when undo began with a net out
    shows_keys: bool = True                             # whether points go where keys put them
    lost_keys: list = field(default_factory=list)       # of bridge.keys.point_keys: sentences for the next report
    to_say: list = field(default_factory=list)          # sentences for a window, where no operator can report them
    looks_left: int = 0
    is_deaf: bool = False                               # whether the main thread left another one waiting
    served: tuple = None                                # the frame, and the part of it, that it was not
    missed: int = 0                                     # frames that were rendered without shapes brought up to date


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
    """Keep a value in a dictionary of at most so many; the oldest go."""
    known.pop(key, None)
    while len(known) >= most:
        del known[next(iter(known))]
    known[key] = value
    return value
