"""Shapes that move, as plain meshes and curves that move the same where Splinewright is missing.

Each frame is a shape key, of which one F-curve picks those to show. The baked data-block points to the one that it stands
for, which so stays in the file: that is the way back.
"""

from dataclasses import dataclass, field

import bpy
import numpy as np

from ...core.base.failures import Refusal
from ...core.base.words import phrase
from ...core.shape import definition as definitions
from ...core.verbs import verbs
from ..data import animation, blocks, settings, store, tessellate
from ..follow import follow
from ..mesh import stamp, write_mesh
from ..native import native_links
from ..recipes import recipes
from ..shape import shape

KEY = "splinewright_baked"
_VERSION = 1
#: The largest number of bytes that a data-block may take.
_MOST = 4 * 10 ** 9


@dataclass
class Take:
    """The points of a data-block in some frames."""

    frames: list
    points: list = field(default_factory=list)      # of (n, 3) float32, one for each frame
    faces: object = None                            # the Tessellation with these points, None for what the data-block has
    steps: int = 0                                  # into how many pieces spans of curves are cut then, 0 for as they are

    @property
    def moves(self):
        return any(not np.array_equal(points, self.points[0]) for points in self.points)


class _AsShown:
    """Makes the Take of a data-block that has the same faces, or lines, in every frame."""

    def __init__(self, data, frames):
        self._data, self._take, self._stamp = data, Take(list(frames)), None

    def look(self, frame):
        now = stamp.of(self._data)
        self._stamp = self._stamp or now
        if not stamp.same_topology(self._stamp, now):
            raise Refusal(_OTHER_TOPOLOGY.format(self._data.name, frame, self._take.frames[0]))
        self._take.points.append(shape.points_of(self._data).astype(np.float32))

    def take(self):
        return self._take


class _ByNeed:
    """Makes the Take of a surface that has as many faces as each frame needs: those of the frame that needs the most."""

    def __init__(self, data, frames):
        self._data, self._take, self._most, self._sets = data, Take(list(frames)), 0, []

    def look(self, frame):
        self._sets.append(_patch_set(self._data))
        if len(self._data.polygons) > self._most:
            self._most = len(self._data.polygons)
            self._take.faces = tessellate.tessellated(self._data, self._sets[-1])

    def take(self):
        faces = self._take.faces
        for frame, patch_set in zip((*self._take.frames, None), (*self._sets, _patch_set(self._data))):
            if not faces.fits(patch_set):
                when = "now" if frame is None else phrase("at frame {frame}", frame=frame)
                raise Refusal(_OTHER_PATCHES.format(self._data.name, when))
        self._take.points = [faces.evaluate_positions(patch_set) for patch_set in self._sets]
        return self._take


class _LinesByNeed:
    """Makes the Take of curves whose spans have as many pieces as each frame needs: as many as the frame that needs the most."""

    def __init__(self, data, frames):
        self._data, self._take, self._curves = data, Take(list(frames)), []

    def look(self, frame):
        curves = verbs.curves_of(store.read(self._data))
        self._curves.append((curves, recipes.around(self._data)))
        self._take.steps = max(self._take.steps, *(tessellate.steps_of(self._data, curve) for curve in curves))

    def take(self):
        reach, steps = settings.of(self._data).reach, self._take.steps
        for frame, (curves, around) in zip(self._take.frames, self._curves):
            lines = [points for curve in curves for points, _ in curve.polylines(steps, reach, around)]
            self._take.points.append(np.concatenate(lines).astype(np.float32))
            if len(self._take.points[-1]) != len(self._take.points[0]):
                raise Refusal(_OTHER_TOPOLOGY.format(self._data.name, frame, self._take.frames[0]))
        return self._take


def _patch_set(data):
    return definitions.to_patch_set(store.read(data))


def record(scene, shapes, frames):
    """Steps, one for each frame, that end with {data-block: Take} for those Meshes and Curves. The scene is at the frame
    where it was afterwards, also where they are not gone to the end.

    Raises Refusal where a shape cannot be baked: now, or at the step of the frame that shows it.
    """
    if not frames:
        raise Refusal("the last frame lies before the first")
    _require_no_other_followers(shapes)
    for data in shapes:
        _require_bakeable(data, len(frames))
    return _recorded(scene, shapes, frames)


def _recorded(scene, shapes, frames):
    makers = {data: _maker_for(data)(data, frames) for data in shapes}
    was, within = scene.frame_current, scene.frame_subframe
    try:
        for frame in frames:
            scene.frame_set(frame)
            for maker in makers.values():
                maker.look(frame)
            yield
    finally:
        scene.frame_set(was, subframe=within)
    return {data: maker.take() for data, maker in makers.items()}


def _maker_for(data):
    if tessellate.by_count(data):
        return _AsShown
    return _ByNeed if isinstance(data, bpy.types.Mesh) else _LinesByNeed


_OTHER_TOPOLOGY = ("{0} has other faces, or points, at frame {1} than at frame {2}, and shape keys only move them: "
                   "choose a resolution that is not keyed")
_OTHER_PATCHES = ("{0} has other patches, or other ones that meet, {1} than where it has the most faces, and shape keys "
                  "only move them")


def _require_bakeable(data, count):
    shape.require_writable(data)
    shape.require_untouched(data)
    for user in native_links.users_of(data):
        if user.library or user.override_library:
            raise Refusal("{name} is linked from another file and cannot be changed here", name=user.name)
    size = 12 * count * len(shape.points_of(data))
    if size > _MOST:
        raise Refusal("{name} would take {size:.1f} GB for {count} frames: bake fewer, or show it by fewer faces",
                      name=data.name, size=size / 1000000000.0, count=count)


def _require_no_other_followers(shapes):
    for follower, source in follow.links():
        if source.data in shapes and follower not in shapes:
            raise Refusal("{name} follows {source_name}: bake both together", name=follower.name, source_name=source.name)


def bake(data, take):
    """Put a Mesh or Curve that moves by itself in the place of a shape's; that new data-block."""
    baked = data.copy()
    baked.name = f"{data.name} Baked"
    if take.faces is not None:
        shape.rewrite(baked, faces=take.faces)
    if take.steps:
        with settings.quiet(baked):
            settings.set_count(baked, take.steps, take.steps)
        shape.rewrite(baked)
    shape.detach(baked)
    if isinstance(baked, bpy.types.Mesh):
        write_mesh.let_normals_turn(baked)
    _add_keys(baked, take)
    baked[KEY] = {'version': _VERSION, 'original': data, 'first': take.frames[0], 'last': take.frames[-1]}
    for user in native_links.users_of(data):
        user.data = baked
    return baked


def _add_keys(data, take):
    """A shape key for each frame, and the F-curve that goes through them, straight from one to the next."""
    holder = bpy.data.objects.new(data.name, data)
    for frame, points in zip(take.frames, take.points):
        block = holder.shape_key_add(name=f"Frame {frame}", from_mix=False)
        block.data.foreach_set('co', points.ravel())
    bpy.data.objects.remove(holder)
    keys = data.shape_keys
    keys.use_relative = False
    for frame, block in zip(take.frames, keys.key_blocks):
        keys.eval_time = block.frame
        keys.keyframe_insert('eval_time', frame=frame)
    for curves in animation.curve_lists(keys.animation_data):
        for curve in curves:
            for point in curve.keyframe_points:
                point.interpolation = 'LINEAR'


def is_baked(data):
    return data is not None and KEY in data.keys() and store.is_group(data[KEY])


def frames(data):
    """The first and last frame of the bake, as words."""
    return phrase("{first} to {last}", first=data[KEY].get('first'), last=data[KEY].get('last'))


def unbake(data):
    """Put the shape that a baked data-block stands for back in its place. Raises Refusal where that is no more."""
    original = data[KEY].get('original') if is_baked(data) else None
    if type(original) is not type(data) or not store.has_definition(original):
        raise Refusal("the shape that {name} was baked from is not there any more", name=data.name)
    if native_links.users_of(original):
        original = original.copy()      # this one is a copy of a baked shape that is live again
    for user in native_links.users_of(data):
        user.data = original
    keys = data.shape_keys
    action = keys.animation_data.action if keys and keys.animation_data else None
    blocks.remove(data)
    if action is not None and not action.users:
        bpy.data.actions.remove(action)
    return original
