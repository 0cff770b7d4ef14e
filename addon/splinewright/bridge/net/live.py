"""A shape follows its net: read the net, write what moved, at every step of a drag.

What the net says is worked out anew each time from the net and its baseline alone, so that undo,
redo and reopening need no care.
"""

import time

import bpy
import numpy as np

from ...core import definition as definitions
from ...core.failures import FAILURES, sentence
from ...core.library import sc
from ...core.net import net as nets
from .. import fineness, made, recipes, shape, stamp, store, write_mesh
from . import marks
from . import net as bridge
from . import points_net


#: Seconds without a move after which the shape is looked at for changes by other hands.
_PAUSE = 0.25


class Session:
    """What is worked out once for a net. Rebuilt at will: it holds no truth of its own."""

    def __init__(self, net):
        self.made_with = net
        self.problem = ""
        self.show(net)
        self.faces = None               # the Tessellation whose faces the shape has, where that is known
        self.pool = None                # of the definition that was written last
        self._fineness = self._stamp = None     # of the faces, and of the shape when it got them
        self._checked = 0.0
        self._patch_sets = {}
        self._settings = {}             # of the shape, by the number that the net is marked with

    def show(self, net):
        """Take this for the net, and its points for those that are there."""
        self.net = net                  # other than it was made with where that has gained or lost points
        self.points = net.single        # for the overlay
        self.state = nets.exact(net, net.single, net.single_weights)

    def require_alone(self, data, pool):
        """Raises ValueError where others changed the shape since its net last wrote it."""
        if self.pool is not None and not np.array_equal(pool, self.pool):
            raise ValueError("the shape was given another definition while its net was out: leave the net")
        now = time.monotonic()
        if now - self._checked > _PAUSE:        # not at every step of a drag
            shape.require_untouched(data)
        self._checked = now

    def trust(self):
        """Undo may have put back any earlier state of the shape."""
        self.faces = self.pool = None

    def wrote(self, data, faces):
        """The shape has these faces now."""
        self.faces, self._fineness, self._stamp = faces, fineness.of(data), store.read_stamp(data)

    def settings(self, mark, present):
        """The settings that a mark stands for: from now on the present ones, where it is new or none of ours."""
        return present if mark < marks.FIRST else self._settings.setdefault(mark, present)

    def mark(self, settings):
        """The mark that stands for settings of the shape."""
        known = next((mark for mark, values in self._settings.items() if values == settings), None)
        if known is None:
            known = marks.FIRST + len(self._settings)
            if known == marks.FIRST + marks.COUNT:
                known = next(iter(self._settings))
                del self._settings[known]
            self._settings[known] = settings
        return known

    def patch_set(self, definition):
        """The PatchSet of a definition with the net's patches, or those of its source."""
        is_source = definition is self.net.source
        if is_source not in self._patch_sets:
            self._patch_sets[is_source] = definitions.to_patch_set(definition)
        return self._patch_sets[is_source].with_points(definition.pool[:, :3], definition.pool[:, 3])

    def moved(self, data, patch_set):
        """(positions, exact normals or None) on the faces that the shape has, or None where it needs others."""
        if self.faces is None or self._fineness != fineness.of(data):
            return None
        if not stamp.same_topology(self._stamp, store.read_stamp(data)):
            return None
        try:
            if write_mesh.keeps_normals():
                return self.faces.evaluate(patch_set)
            return self.faces.evaluate_positions(patch_set), None
        except sc.InvalidShape:
            return None                 # sides that were one are not any more, or the other way round


_sessions = {}


def session(data):
    """The session of a net's data-block."""
    token = bridge.token(data)
    if token not in _sessions:
        begin(data, bridge.numbers(bridge.source(data)))
    return _sessions[token]


def begin(data, net, settings=None):
    """Start the session of a net's data-block that was made from these numbers, and settings() of its shape."""
    if len(_sessions) > 32:
        _drop_idle()
    _sessions[bridge.token(data)] = started = Session(net)
    if settings is not None:
        started.settings(marks.FIRST, settings)


def _drop_idle():
    """Forget the sessions of nets that are no more; undo may bring them back, at the cost of a new one."""
    living = {bridge.token(ob.data) for ob in bpy.data.objects if bridge.is_net(ob)}
    for token in set(_sessions) - living:
        del _sessions[token]


def forget():
    """Drop all sessions: another file was opened."""
    _sessions.clear()


def trust():
    """After undo and redo: take shapes as they are."""
    for current in _sessions.values():
        current.trust()


def pull(ob):
    """Bring the shape of a net up to date. Returns its data-block if it changed, else None.

    Where the net cannot be read or shown, shape and definition stay as they were last; problem() says why.
    """
    if not bridge.is_current(ob):
        return None
    owner, current = bridge.shape_of(ob), session(ob.data)
    follow = _follow_points if points_net.is_free(ob.data) else _follow
    changed = _show_as_marked(owner.data, ob, current)
    try:
        changed = follow(owner.data, ob, current) or changed
    except FAILURES as error:
        current.problem = sentence(error)
    return owner.data if changed else None


def _show_as_marked(data, ob, current):
    """Give a shape the settings that its net is marked with: undo may have brought others back. Whether it changed."""
    present = fineness.settings(data)
    wanted = current.settings(marks.read(ob), present)
    if wanted == present:
        return False
    fineness.take(data, wanted)
    try:
        current.wrote(data, shape.rewrite(data))
    except FAILURES as error:
        data.splinewright.problem = sentence(error)
        return False
    return True


def mark(data):
    """The settings of a shape were changed: let its net know, if it is out."""
    token = bridge.editor(data)
    nets_of = (ob for ob in bpy.data.objects if bridge.is_net(ob) and bridge.token(ob.data) == token)
    held = next((ob for ob in nets_of if ob.mode == 'EDIT'), None) if token is not None else None
    if held is not None:
        marks.write(held, session(held.data).mark(fineness.settings(data)))


def _follow(data, ob, current):
    """Bring a shape up to date; whether it changed."""
    current.points, weights = bridge.read(ob, current.net)
    current.state = nets.exact(current.net, current.points, weights, bridge.typed(ob.data))
    definition = nets.read(current.net, current.state)
    current.problem = ""
    return made.follow_net(data, definition) if recipes.has_points(data) else _show(data, definition, current)


def _follow_points(data, ob, current):
    """_follow() where the net may gain and lose points. They are shown in the panel even if the shape refuses them."""
    current.show(points_net.read(ob.data, current.made_with))
    current.problem = ""
    return made.follow_points(data, current.net, points_net.is_turned(ob.data))


def problem(ob):
    """Why the shape does not follow its net, or ""."""
    return session(ob.data).problem


def settle(data):
    """Write what a drag leaves out: exact normals, sharp edges, and faces that are as many as the shape asks for."""
    if store.is_draft(data):
        faces = shape.rewrite(data)
        current = _sessions.get(bridge.editor(data))
        if current is not None:
            current.wrote(data, faces)


def _show(data, definition, current):
    """Whether anything was to be written."""
    pool = np.array(data[store.KEY]['pool']).reshape(-1, 4)
    if np.array_equal(pool, definition.pool):
        current.pool = pool
        return False
    current.require_alone(data, pool)
    shape.require_writable(data)
    if definition.has_curves:
        shape.set_definition(data, definition)
        current.pool = definition.pool
        return True
    moved = current.moved(data, current.patch_set(definition))
    if moved is None:
        current.wrote(data, shape.set_definition(data, definition))
        current.pool = definition.pool
        return True
    positions, normals = moved
    if not np.isfinite(positions).all():
        raise sc.InvalidShape("a point is farther away than Blender can show (3.4e38)")
    write_mesh.move(data, positions, normals)
    current.pool = definition.pool
    store.write_draft(data, definition, stamp.moved(store.read_stamp(data), positions))
    return True
