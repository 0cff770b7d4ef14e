"""A shape follows its net: read the net, write what moved, at every step of a drag.

What the net says is worked out again each time from the net and its baseline alone, so that undo,
redo and reopening need no care.
"""

import time

import bpy
import numpy as np

from ...core.base.arrays import are_equal
from ...core.base.failures import FAILURES, Refusal, sentence, text_of
from ...core.base.library import sc
from ...core.net import exact_net, last_reading, reading
from ...core.shape import definition as definitions
from ...core.shape.moved_positions import MovedPositions
from ..cage import cage, free_net, net_object, settings_number
from ..curve import curve_layers
from ..data import problems, settings, store, tessellate
from ..data.file_state import ended_operators, look_again, state
from ..keys import point_keys
from ..mesh import stamp, write_mesh
from ..recipes import recipes
from ..shape import recipe_edit, shape
from . import along, curve_extras, growing, holding, keyed_stages, stages
from .growing import Phase


#: Seconds without a move after which the shape is looked at for changes by other hands, and so many times as long as it
#: takes to look, or a step of a drag that is slow would always be a pause; nor is one that comes in the rhythm of the last.
_PAUSE = 0.25
_SHARE = 20
_LONGEST_PAUSE = 0.5
_RHYTHM = 3
#: A length that float32 holds, whatever is rounded.
_FAR = 3e38
#: Among the values of settings: the number of what lies along a shape.
_ALONG = 'along'
_WAITS = "the shape takes up the new rows when the slide has ended"


class Session:
    """Values worked out once for a net. Rebuilt at will: it holds no truth."""

    def __init__(self, net):
        self.made_with = net
        self.stages = {0: stages.Stage(net)}    # by their first numbers
        self.stage = self.stages[0]
        self.extra = 0                          # how many points are passed over
        self.is_waiting = False                 # whether there are rows that growing.grow() is to take up later
        self.show(net)
        self.faces = None               # the Tessellation whose faces the shape has, where that is known
        self.pool = None                # of the definition that was written last
        self.last = None                # the core.net.last_reading.LastReading of the net
        self.placed = holding.Placed()
        self.released = ""              # what holds no more since the net came
        self.lost = ""                  # what does not hold as smoothly as it is to
        self.keyed_rows = {}            # of bridge.net.keyed_stages
        self._fineness = self.stamp = None      # of the faces, and of the shape when it got them
        self._look = self._last_step = self._next_check = 0.0
        self._patch_sets = {}           # the last ones, by how many points they have
        self._moved = None              # the MovedPositions on the faces
        self._settings = {}             # of the shape, their values by the number that the net carries for them
        self.along = {}                 # what lay along the shape, by its number there: see along

    def show(self, net):
        """Take this for the net, and its points for those that are there."""
        self.net = net                  # other than it was made with where that has gained or lost points
        self.take(exact_net.exact(net, net.single, net.single_weights), np.arange(len(net.rows)))

    def take_stage(self, stage):
        """Take this for the current stage of the net."""
        self.stage = stage
        self.faces = self._moved = None
        self.placed = holding.Placed()
        self._patch_sets.clear()
        self.show(stage.net)

    def take(self, exact, slots):
        """Take these for the numbers of the vertices, and for their slots among what Blender holds, -1 for none."""
        self.state, self.slots, self._points = exact, slots, None

    @property
    def points(self):
        """(n, 3) float32: where the vertices are shown."""
        if self._points is None:
            with np.errstate(over='ignore'):
                self._points = self.state.positions.astype(np.float32)
        return self._points

    def require_alone(self, data, pool):
        """Raises Refusal where others changed the shape since its net last wrote it."""
        if self.pool is not None and not are_equal(pool, self.pool):
            raise Refusal("the shape was given another definition while its net was out: leave the net")
        self.look_at(data)

    def look_at(self, data):
        """Raises Refusal where others changed what the shape shows, which is looked for when a drag pauses."""
        start = now = time.monotonic()
        if start > self._next_check:            # not at every step of a drag
            shape.require_untouched(data)
            now = time.monotonic()
            self._look = now - start
        rhythm = _RHYTHM * (start - self._last_step) if self._last_step else 0.0
        self._last_step = now
        self._next_check = now + min(max(_PAUSE, _SHARE * self._look), max(_LONGEST_PAUSE, rhythm))

    def accept_undo(self):
        """Undo may have put back any earlier state of the shape."""
        self.faces = self._moved = self.pool = self.last = None
        self.placed = holding.Placed()

    def wrote(self, data, faces):
        """The shape has these faces now."""
        if faces is not self.faces:
            self._moved = None
        self.faces, self._fineness, self.stamp = faces, tessellate.of(data), store.read_stamp(data)

    def settings(self, number, present):
        """What a number in the net stands for: from now on the present values, where it is new or not one of the add-on's."""
        return present if number < settings_number.FIRST else self._settings.setdefault(number, present)

    def number_of(self, values):
        """The number in the net that stands for values of the shape's settings."""
        known = next((number for number, others in self._settings.items() if others == values), None)
        if known is None:
            numbers = range(settings_number.FIRST, settings_number.FIRST + settings_number.COUNT)
            free = (number for number in numbers if number not in self._settings)
            known = next(free, None) or next(iter(self._settings))
            self._settings.pop(known, None)
            self._settings[known] = values
        return known

    def patch_set(self, definition):
        """The PatchSet of a definition with the net's patches, or those of its source: it shares what did not move."""
        count = len(definition.pool)    # handles of the net may have rows of their own
        last, weights = self._patch_sets.get(count), definition.pool[:, 3]
        if last is None:
            found = definitions.to_patch_set(definition)
        else:
            points = np.ascontiguousarray(definition.pool[:, :3])       # which the library would make of it, slower
            found = last.with_points(points, None if are_equal(last.weights, weights) else weights)
        self._patch_sets[count] = found
        return found

    @property
    def is_dragged(self):
        """Whether the shape shows moved() positions."""
        return self._moved is not None

    def _has_faces(self, data, known):
        """Whether the shape has the faces that are known here. known: its stamp."""
        return (self.faces is not None and known is not None and self._fineness == tessellate.of(data)
                and stamp.same_topology(self.stamp, known))

    def final_faces(self, data):
        """The Tessellation that the shape has when the gesture is over, where that is known already, or None."""
        return self.faces if self._has_faces(data, store.read_stamp(data)) and tessellate.by_count(data) else None

    def moved(self, data, known, patch_set):
        """The MovedPositions on the faces that the shape has, or None where it needs others. known: its stamp."""
        if not self._has_faces(data, known):
            faces = shape.faces_of(data)
            if faces is None:
                return None
            self.wrote(data, faces)
        return self.moved_on(patch_set)

    def moved_on(self, patch_set, rows=None):
        """moved() where the shape is known to have these faces. rows: as of MovedPositions.move()."""
        moved, self._moved = self._moved, None
        if not (moved or self.faces).fits(patch_set):
            return None                 # sides that were one are not any more, or the other way round
        if moved is None:
            moved = MovedPositions(self.faces, patch_set)
        else:
            moved.move(patch_set, rows)
        self._moved = moved
        return moved


def session(data):
    """The session of a net's data-block. Raises DamagedNet."""
    token = net_object.required_token(data)
    if token not in state.sessions:
        try:
            begin(data, net_object.net_of(net_object.source(data)))
            state.sessions[token].stages = stages.stored(data, state.sessions[token].made_with)
        except net_object.DamagedNet as error:
            state.sessions[token] = error.args[0]   # the exception itself would keep what was alive where it was raised
    found = state.sessions[token]
    if isinstance(found, str):
        raise net_object.DamagedNet(found)
    return found


def known_session(data):
    """session(), or None where the net is damaged, of which problem() tells."""
    try:
        return session(data)
    except net_object.DamagedNet:
        return None


def begin(data, net, shown_by=None):
    """Start the session of a net's data-block that was made from these numbers.

    shown_by: shown_now() of the shape when its net was made, where it is known.
    """
    if len(state.sessions) > 32:
        _drop_idle()
    state.sessions[net_object.token(data)] = started = Session(net)
    if shown_by is not None:
        started.settings(settings_number.FIRST, shown_by)


def shown_now(data):
    """The values of the settings of a shape, and the number of what lies along it."""
    return {**settings.values(data), _ALONG: curve_layers.number(data)}


def _drop_idle():
    """Forget the sessions of nets that are no more; undo may bring them back, at the cost of a new one."""
    living = {net_object.token(ob.data) for ob in bpy.data.objects if net_object.is_net(ob)}
    for token in set(state.sessions) - living:
        del state.sessions[token]


def accept_undo():
    """After undo and redo: take shapes as they are, and look at damaged nets again."""
    for token, current in list(state.sessions.items()):
        if isinstance(current, Session):
            current.accept_undo()
        else:
            del state.sessions[token]


def sync_from_cage(ob, moment=Phase.FREE):
    """Bring the shape of a net up to date. Returns its data-block if it changed, else None.

    Of what cannot be read or shown the shape keeps what it has; problem() says why. Whatever goes wrong is kept in words:
    others are to be brought up to date, too.
    """
    state.drag = None
    net = ob.data
    look_again(net)
    problems.set_problem(net, problems.STRAYS, "")
    try:
        data, is_changed, problem = _pulled(ob, moment)
    except Exception as error:
        problems.set_problem(net, problems.NET, text_of(error))
        return None
    problems.set_problem(net, problems.NET, problem)
    return data if is_changed else None


def _pulled(ob, moment):
    """(the data-block of a net's shape, whether it changed, what it does not take of the net)."""
    owner = net_object.required_shape(ob)
    if owner is None:
        return None, False, "the shape of this net was deleted, or is in no scene"
    if not net_object.edits(ob, owner):
        return None, False, "this net is of an earlier time: its shape has changed since, and follows it no more"
    data, current = owner.data, session(ob.data)
    wanted = current.settings(settings_number.read(ob), shown_now(data))
    is_shown_otherwise = _show_as_noted(data, current, wanted)
    try:
        if free_net.is_free(ob.data):
            is_changed, problem = _follow_points(data, ob, current)
        else:
            is_changed, problem = _follow(data, ob, current, moment)
    except Exception as error:
        is_changed, problem = False, text_of(error)
    if wanted[_ALONG] != curve_layers.number(data) and wanted[_ALONG] in current.along:
        along.put(data, current.along[wanted[_ALONG]], wanted[_ALONG])
        is_changed = True
    return data, is_changed or is_shown_otherwise, problem


def _show_as_noted(data, current, wanted):
    """Give a shape the settings of which its net has the number: undo may have brought others back. Whether it changed."""
    values = {name: value for name, value in wanted.items() if name != _ALONG}
    if values == settings.values(data):
        return False
    settings.take(data, values)
    try:
        current.wrote(data, shape.rewrite(data))
    except Exception as error:
        problems.set_problem(data, problems.SETTING, text_of(error))
        return False
    return True


def note_settings(data):
    """The settings of a shape were changed: let its net know, if it is out."""
    token = net_object.editor(data)
    if token is None:
        return
    nets = (ob for ob in bpy.data.objects if net_object.is_net(ob) and net_object.token(ob.data) == token)
    held = next((ob for ob in nets if ob.mode == 'EDIT'), None)
    if held is not None:
        settings_number.write(held, session(held.data).number_of(shown_now(data)))


def begin_along(ob):
    """The along.Gesture of a net in Edit Mode. Raises Refusal."""
    sync_from_cage(ob)
    if problem(ob):
        raise Refusal(problem(ob))
    return along.Gesture(ob, session(ob.data).net)


def end_along(gesture):
    """Keep what a gesture left along the shape of a net."""
    known, data = session(gesture.net_data).along, gesture.data
    known[curve_layers.number(data)] = gesture.pieces_before
    new = max(known) + 1
    known[new] = gesture.pieces
    curve_layers.set_number(data, new)
    note_settings(data)


def _follow(data, ob, current, moment):
    """Bring a shape up to date; whether it changed, and what it does not take. Raises where the net cannot be read: nothing
    waits then, and the shape is left alone."""
    current.is_waiting, can_grow = False, _can_grow(data)
    if can_grow:
        growing.choose(ob.data, current)
    found, definition = _read(data, ob, current)
    has_grown, refused = False, ""
    try:
        has_grown = can_grow and growing.grow(ob.data, current, definition, found, moment)
    except FAILURES as error:
        refused = sentence(error)
    if has_grown:                       # what was read before is of another stage
        found, definition = _read(data, ob, current)
    if found.extra > current.extra and can_grow and ended_operators() == state.seen:
        state.began = state.seen        # they ended before points were copied: another is at work
    current.extra = found.extra
    current.take(found.state, found.slots)
    if current.is_waiting:
        found = found._replace(problem="", note=_WAITS if moment == Phase.BUSY else "")
    if not recipes.has_points(data):
        definition = keyed_stages.with_digits(data, current.net, definition)
        try:
            definition = holding.followed(data, ob, current, definition)
        except FAILURES as error:
            refused = refused or sentence(error)
    notes = current.stage.note, found.note, current.released, current.lost
    problems.set_problem(ob.data, problems.STRAYS, "; ".join(filter(None, notes)))
    if recipes.has_points(data):
        return recipe_edit.follow_net(data, definition), found.problem
    were_said = definition.has_curves and curve_extras.has_types(data)
    is_changed = _show(data, definition, current)
    if definition.has_curves:
        curve_extras.keep_types(data, ob, current, definition, were_said)
    return is_changed, refused or found.problem


def _read(data, ob, current):
    """(the core.net.reading.Reading of a net, the definition that it says)."""
    net, typed = current.net, net_object.typed(ob.data, current.net)
    said = None if isinstance(ob.data, bpy.types.Curve) else cage.snapshot(ob, current.last and current.last.said)
    again = current.last and current.last.again(net, said, typed)
    if again:
        return again
    found = reading.read(net, net_object.present(ob, net), typed, lambda: _last(data, net))
    definition = exact_net.read(net, found.state)
    current.last = last_reading.of(net, said, typed, found, definition)
    return found, definition


def _last(data, net):
    """The Net of a shape as it is; that which its net was made with where they do not compare."""
    last = net_object.net_of(recipe_edit.edited(data))
    return last if np.array_equal(last.origins, net.origins) else net


def _follow_points(data, ob, current):
    """_follow() where the net may gain and lose points. They are shown in the panel even if the shape refuses them."""
    is_turned = free_net.is_turned(ob.data)
    current.show(free_net.read(ob.data, current.made_with))
    try:
        return recipe_edit.follow_points(data, current.net, is_turned), ""
    except FAILURES:
        others = free_net.without_copies(ob.data, current.net)
        if others is None:
            raise
    is_changed = recipe_edit.follow_points(data, others, is_turned)
    problems.set_problem(ob.data, problems.STRAYS, reading.note(len(current.net.rows) - len(others.rows)))
    return is_changed, ""


def ignore_called_off(ob):
    """What was extruded from a net's ends and called off is passed over once for all."""
    owner = net_object.shape_of(ob)
    if owner is not None and _can_grow(owner.data):
        growing.ignore_called_off(ob.data, session(ob.data))


def _can_grow(data):
    """Whether the net of a shape, of its definition, may gain and lose points."""
    return not recipes.has(data)


def problem(ob):
    """What the shape does not take of its net, or ""."""
    return problems.of(ob.data, problems.NET)


def note(ob):
    """What the shape passes over, or ""."""
    return problems.of(ob.data, problems.STRAYS)


def is_waiting(ob):
    """Whether there are rows in a net that were cut in, or are gone, and are taken up a moment later."""
    current = known_session(ob.data)
    return current is not None and current.is_waiting


def unread(ob):
    """problem(), where leaving the net would lose something: not where there is no shape to lose it."""
    return "" if net_object.is_orphan(ob) else problem(ob)


def is_draft(ob):
    """Whether the shape of a net lacks what a drag leaves out; undo may bring such a one back."""
    owner = net_object.shape_of(ob)
    return owner is not None and store.is_draft(owner.data)


def look_at_all(ob):
    """Read all of a net of which a drag reads what moved: others may have given points other weights meanwhile."""
    current = known_session(ob.data) if ob.mode == 'EDIT' else None
    last = current and current.last
    said = last and cage.snapshot(ob)
    if said and not last.agrees(said):
        sync_from_cage(ob, Phase.BUSY)


def finalize(data, progress=shape.no_progress):
    """Write what a drag leaves out: exact normals, sharp edges, and faces that are as many as the shape asks for. progress:
    as of shape.rewrite()."""
    if store.is_draft(data):
        current = state.sessions.get(net_object.editor(data))
        current = current if isinstance(current, Session) else None
        faces = shape.rewrite(data, progress, current.final_faces(data) if current else None)
        if current is not None:
            current.wrote(data, faces)


def _shows_another_stage(data, current):
    """Whether a shape is made of pieces that its net had before, or had afterwards and undo took back."""
    if len(current.stages) == 1:
        return False
    shown = store.read(data)
    return not definitions.have_same_pieces(shown, current.net.source) and any(
        definitions.have_same_pieces(shown, stage.net.source) for stage in current.stages.values())


def _show(data, definition, current):
    """Whether anything was to be written."""
    pool = store.pool(data)
    if are_equal(pool, definition.pool) and not _shows_another_stage(data, current):
        current.pool = pool
        return False
    current.require_alone(data, pool)
    shape.require_writable(data)
    known = store.read_stamp(data)
    moved = None if definition.has_curves else current.moved(data, known, current.patch_set(definition))
    if moved is None:
        with keyed_stages.staged(data, current):
            faces = (curve_extras.show if definition.has_curves else shape.set_definition)(data, definition)
        if faces is not None:
            current.wrote(data, faces)
        current.pool = definition.pool
        return True
    show_moved(data, definition, moved, current, known)
    return True


def show_moved(data, definition, moved, current, known):
    """Let a shape be of a definition by moving its vertices. moved: its MovedPositions; known: the stamp of the shape."""
    if not _are_finite(moved.positions, definition.pool):
        raise sc.InvalidShape("a point is farther away than Blender can show (3.4e38)")
    write_mesh.move(data, moved.positions)
    current.pool = definition.pool
    store.write_draft(data, definition, stamp.moved(known, moved.checksum()))
    point_keys.show(data, definition.pool)


def _are_finite(positions, pool):
    """Whether all positions are finite in float32: where weights are positive they lie among the points of the pool."""
    is_among = pool[:, 3].min() > 0 and -_FAR < pool.min() and pool.max() < _FAR
    return is_among or bool(np.isfinite(positions).all())
