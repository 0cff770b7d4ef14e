"""What the user interface remembers of the open file: gestures under way, and what it looked at last.

As bridge.data.file_state: all of it is worked out again where it is missing, and forgotten when another file is opened.
"""

from dataclasses import dataclass, field, fields


@dataclass
class UiState:
    """Data-blocks and objects stand here by their keys or names: references die with undo."""

    is_scanned: bool = False                            # whether the file was looked through since it was opened
    stopped: tuple = ()                                 # what stopped says in the status bar
    nets: set = field(default_factory=set)              # objects that are nets; a hint
    kept: set = field(default_factory=set)              # nets that were left by other ways and hold what no shape took
    is_still: bool = False                              # whether distances have not changed for a while
    handed: tuple = ()                                  # the ended_operators() when editing looked at copies last
    awaited: tuple = None                               # those when rows were seen that are being cut in
    was_undone: bool = False                            # whether something was since Blender drew
    status: str = ""                                    # what messages says in the status bar
    suspended: list = field(default_factory=list)       # of saving
    was_in_result: bool = False                         # whether a mesh or curve of a shape was in Edit Mode
    selected_shapes: set = field(default_factory=set)   # names, at the last change; of join_notice
    last_join: tuple = ()                               # the ended_operators() when one was looked at; of join_notice
    errands: list = field(default_factory=list)         # of main_thread, and whether there were some lately
    frame_before: tuple = ()                            # the name of the scene and its frame when undo began with a net out
    finishing: object = None                            # the finishing.Finishing that goes on, listening to Esc
    is_unawaited: bool = False                          # whether no script waits for what Blender is asked to look for
    lesson_word: str = ""                               # whether the last answer of a lesson was right, in words
    lesson_shown: tuple = ()                            # what Show Me said last: the name of a lesson, the number of a step, the text
    lesson_faults: tuple = ()                           # what is wrong with the lesson that is made, as it was checked last
    lesson_items: tuple = ()                            # of lesson_questions: texts of a menu, which Blender needs to live on
    to_say: list = field(default_factory=list)          # sentences for a window, where no operator can report them
    looks_left: int = 0
    is_deaf: bool = False                               # whether the main thread left another one waiting
    served: tuple = None                                # the frame, and the part of it, that it was not
    missed: int = 0                                     # frames that were rendered without shapes brought up to date

    # Gestures.
    asking: set = field(default_factory=set)            # names of open dialogs that ask for a piece
    asked: dict = field(default_factory=dict)           # of active_shape: what the last operator asked for pieces of
    picking: dict = field(default_factory=dict)         # while a piece is picked: numbers of pieces by names of objects
    hovered: tuple = ()                                 # the name of an object and the number of its piece at the mouse
    aimed: tuple = None                                 # while a knot is inserted by a click: an aim_overlay.Aim
    is_pointing: bool = False                           # whether an operator waits for what is clicked
    sides: tuple = ()                                   # while sides of patches are picked: (object's name, number, side) each
    rounding: tuple = None                              # while edges are picked that are rounded: an edges_overlay.Edges
    edge: tuple = None                                  # of edge_picking, while an edge is picked: the one at the mouse
    drawn_stroke: tuple = ()                            # while one is drawn: its points
    contour: tuple = None                               # while one is drawn: the core.drawing.contours.Contour, and that with the next point
    pulled: tuple = None                                # while a shape is pulled by a point: a pull_overlay.Pull
    measured: tuple = None                              # while one measures by a click: a measure_overlay.Measured
    fed: tuple = None                                   # while a function is chosen by a click: a fed_overlay.Fed
    weighing: tuple = None                              # while weights change by the mouse: a weight_overlay.Weighing
    moved_knot: tuple = None                            # while a knot is moved: a knot_strip.Moved
    pointed_knot: tuple = None                          # of the knot strip, at the mouse: a knot_strip.Pointed


ui_state = UiState()


def forget():
    """Another file is open."""
    fresh = UiState()
    for each in fields(UiState):
        setattr(ui_state, each.name, getattr(fresh, each.name))
