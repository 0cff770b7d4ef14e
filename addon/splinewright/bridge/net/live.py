"""A shape follows its net: read the net, write what moved, at every step of a drag.

What the net says is worked out anew each time from the net and its baseline alone, so that undo,
redo and reopening need no care.
"""

import time

import bpy
import numpy as np

from ...core import definition as definitions
from ...core.failures import Refusal, told
from ...core.library import sc
from ...core.net import exact_net
from .. import fineness, problems, recipes, remaking, settings, shape, stamp, store, versions, write_mesh
from ..file_state import state
from . import free_net, marks, net_object


#: Seconds without a move after which the shape is looked at for changes by other hands.
_PAUSE = 0.25


class Session:
    """What is worked out once for a net. Rebuilt at will: it holds no truth of its own."""

    def __init__(self, net):
        self.made_with = net
        self.show(net)
        self.faces = None               # the Tessellation whose faces the shape has, where that is known
        self.pool = None                # of the definition that was written last
        self._fineness = self._stamp = None     # of the faces, and of the shape when it got them
        self._checked = 0.0
        self._patch_sets = {}
        self._settings = {}             # of the shape, their values by the mark that the net carries

    def show(self, net):
        """Take this for the net, and its points for those that are there."""
        self.net = net                  # other than it was made with where that has gained or lost points
        self.points = net.single        # for the overlay
        self.state = exact_net.exact(net, net.single, net.single_weights)

    def require_alone(self, data, pool):
        """Raises Refusal where others changed the shape since its net last wrote it."""
        if self.pool is not None and not np.array_equal(pool, self.pool):
            raise Refusal("the shape was given another definition while its net was out: leave the net")
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
        """What a mark stands for: from now on the present values, where it is new or none of ours."""
        return present if mark < marks.FIRST else self._settings.setdefault(mark, present)

    def mark(self, values):
        """The mark that stands for values of the shape's settings."""
        known = next((mark for mark, others in self._settings.items() if others == values), None)
        if known is None:
            known = marks.FIRST + len(self._settings)
            if known == marks.FIRST + marks.COUNT:
                known = next(iter(self._settings))
                del self._settings[known]
            self._settings[known] = values
        return known

    def patch_set(self, definition):
        """The PatchSet of a definition with the net's patches, or those of its source."""
        is_source = definition is self.net.source
        if is_source not in self._patch_sets:
            self._patch_sets[is_source] = definitions.to_patch_set(definition)
        return self._patch_sets[is_source].with_points(definition.pool[:, :3], definition.pool[:, 3])

    def _has_faces(self, data):
        """Whether the shape has the faces that are known here."""
        return (self.faces is not None and self._fineness == fineness.of(data)
                and stamp.same_topology(self._stamp, store.read_stamp(data)))

    def final_faces(self, data):
        """The Tessellation that the shape has when the gesture is over, where that is known already, or None."""
        return self.faces if self._has_faces(data) and fineness.by_count(data) else None

    def moved(self, data, patch_set):
        """(positions, exact normals or None) on the faces that the shape has, or None where it needs others."""
        if not self._has_faces(data):
            return None
        try:
            if versions.keeps_exact_normals:
                return self.faces.evaluate(patch_set)
            return self.faces.evaluate_positions(patch_set), None
        except sc.InvalidShape:
            return None                 # sides that were one are not any more, or the other way round


def session(data):
    """The session of a net's data-block."""
    token = net_object.token(data)
    if token not in state.sessions:
        begin(data, net_object.net_of(net_object.source(data)))
    return state.sessions[token]


def begin(data, net, shown_by=None):
    """Start the session of a net's data-block that was made from these numbers.

    shown_by: the values of the settings of the shape when its net was made, where they are known.
    """
    if len(state.sessions) > 32:
        _drop_idle()
    state.sessions[net_object.token(data)] = started = Session(net)
    if shown_by is not None:
        started.settings(marks.FIRST, shown_by)


def _drop_idle():
    """Forget the sessions of nets that are no more; undo may bring them back, at the cost of a new one."""
    living = {net_object.token(ob.data) for ob in bpy.data.objects if net_object.is_net(ob)}
    for token in set(state.sessions) - living:
        del state.sessions[token]


def trust():
    """After undo and redo: take shapes as they are."""
    for current in state.sessions.values():
        current.trust()


def pull(ob):
    """Bring the shape of a net up to date. Returns its data-block if it changed, else None.

    Where the net cannot be read or shown, shape and definition stay as they were last; problem() says why.
    """
    if not net_object.is_current(ob):
        return None
    data, current = net_object.shape_of(ob).data, session(ob.data)
    follow = _follow_points if free_net.is_free(ob.data) else _follow
    is_changed = _show_as_marked(data, ob, current)
    try:
        is_changed = follow(data, ob, current) or is_changed
        problems.tell(data, problems.NET, "")
    except Exception as error:
        problems.tell(data, problems.NET, told(error))
    return data if is_changed else None


def _show_as_marked(data, ob, current):
    """Give a shape the settings that its net is marked with: undo may have brought others back. Whether it changed."""
    present = settings.values(data)
    wanted = current.settings(marks.read(ob), present)
    if wanted == present:
        return False
    settings.take(data, wanted)
    try:
        current.wrote(data, shape.rewrite(data))
    except Exception as error:
        problems.tell(data, problems.SETTING, told(error))
        return False
    return True


def mark(data):
    """The settings of a shape were changed: let its net know, if it is out."""
    token = net_object.editor(data)
    if token is None:
        return
    nets = (ob for ob in bpy.data.objects if net_object.is_net(ob) and net_object.token(ob.data) == token)
    held = next((ob for ob in nets if ob.mode == 'EDIT'), None)
    if held is not None:
        marks.write(held, session(held.data).mark(settings.values(data)))


def _follow(data, ob, current):
    """Bring a shape up to date; whether it changed."""
    current.points, weights = net_object.read(ob, current.net)
    current.state = exact_net.exact(current.net, current.points, weights, net_object.typed(ob.data))
    definition = exact_net.read(current.net, current.state)
    return remaking.follow_net(data, definition) if recipes.has_points(data) else _show(data, definition, current)


def _follow_points(data, ob, current):
    """_follow() where the net may gain and lose points. They are shown in the panel even if the shape refuses them."""
    current.show(free_net.read(ob.data, current.made_with))
    return remaking.follow_points(data, current.net, free_net.is_turned(ob.data))


def problem(ob):
    """Why the shape does not follow its net, or ""."""
    owner = net_object.shape_of(ob)
    return problems.of(owner.data, problems.NET) if owner else ""


def settle(data):
    """Write what a drag leaves out: exact normals, sharp edges, and faces that are as many as the shape asks for."""
    if store.is_draft(data):
        current = state.sessions.get(net_object.editor(data))
        faces = shape.rewrite(data, faces=current.final_faces(data) if current else None)
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
