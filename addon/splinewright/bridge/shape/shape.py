"""A shape as a whole: its definition, and the mesh or curve that is written from it."""

from contextlib import suppress
from typing import Callable, NamedTuple

import bpy
import numpy as np

from ...core.base.failures import FAILURES, Refusal
from ...core.base.library import sc
from ...core.net.handles import fitting
from ...core.shape import definition as definitions
from ..curve import curve_layers, handles, write_curve
from ..data import blocks, held, problems, settings, store, tessellate
from ..data.file_state import key, state
from ..keys import keyed_seams, point_keys
from ..mesh import mesh_layers, stamp, write_mesh
from ..recipes import recipes
from . import piece_materials


def file_of(ob):
    """The name of the file from which an object or what it shows is linked; "" where both are of this file."""
    overridden = ob.data.override_library.reference if ob.data.override_library else None
    found = [block.library for block in (ob.data, ob, overridden) if block and block.library]
    return bpy.path.basename(found[0].filepath) or "another file" if found else ""


def has_shape(ob):
    """Whether the object is a shape of Splinewright."""
    return ob is not None and ob.type in ('MESH', 'CURVE') and is_shape(ob.data)


def is_shape(data):
    """Whether a data-block, or None, is that of a shape of Splinewright."""
    return type(data) in (bpy.types.Mesh, bpy.types.Curve) and store.has_definition(data)


def is_shown(ob, depsgraph):
    """Whether a depsgraph evaluates an object: it may be hidden, of another scene, or left out of the view layer."""
    return ob.evaluated_get(depsgraph).is_evaluated


#: Steps that set_definition() and rewrite() report to `progress`.
STEPS = 2


def no_progress(step):
    """For callers that show none."""


def new_data(name, value, resolution, progress=no_progress, around=None):
    """A new Mesh or Curve that shows the value, which may be a Definition. resolution: two numbers, of which a curve uses the first, or all that
    settings.start() takes.

    around: as of set_definition().
    """
    definition = value if isinstance(value, definitions.Definition) else definitions.from_value(value)
    collection = bpy.data.curves if definition.has_curves else bpy.data.meshes
    data = collection.new(name, 'CURVE') if definition.has_curves else collection.new(name)
    if definition.has_curves:
        data.use_path = True        # Follow Path finds no path otherwise
    try:
        settings.start(data, *resolution)
        set_definition(data, definition, progress, around)
    except Exception:
        blocks.remove(data)
        raise
    return data


def value_of(data):
    """The splinecore value of a data-block, or None where it has no definition."""
    definition = store.read(data)
    return None if definition is None else definitions.to_value(definition)


def set_value(data, value):
    """Give the data-block another definition and write what it shows.

    Raises TypeError or ValueError, and changes nothing, if the value does not fit.
    """
    recipes.require_free(data)
    seams, types = held.known(data), handles.known(data)
    before, wanted = None, definitions.from_value(value)
    with suppress(store.UnreadableDefinition):          # a damaged one is replaced all the same
        before = store.read(data)
    set_definition(data, definitions.with_names_of(wanted, before) if before else wanted)
    held.carry(data, seams, before)
    handles.write(data, fitting(types, store.read(data)))


def set_definition(data, definition, progress=no_progress, around=None):
    """set_value() with a definition. around: (n, 3), the points that a recipe has now, if it has any.

    Returns the Tessellation whose faces the data-block has then; None for a Curve.
    """
    plan = planned(data, definition, around)
    progress(1)
    carry_out(plan, progress)
    return plan.picture.tessellation


class Plan(NamedTuple):
    """A definition that a data-block can have, and what it will show then."""

    data: bpy.types.ID
    definition: definitions.Definition
    picture: "Picture"


def planned(data, definition, around=None):
    """The Plan of set_definition(), for several that are to be carried out together or not at all.

    Raises as set_definition() does.
    """
    require_writable(data)
    require_untouched(data)
    store.require_fitting(data, definition)
    return Plan(data, definition, evaluated(data, definition, around))


def carry_out(plan, progress=no_progress):
    """Do what was planned."""
    point_keys.carry(plan.data, plan.definition)
    store.write(plan.data, plan.definition)
    point_keys.show(plan.data, plan.definition.pool)
    _finish(plan.data, plan.picture, progress)


def rewrite(data, progress=no_progress, faces=None):
    """Evaluate the stored definition again, after its settings changed. Raises and returns as set_definition() does.

    faces: the Tessellation that it is to have, where that is known and fits.
    """
    require_untouched(data)
    known = store.read_stamp(data) if faces is not None else None
    return restore(data, progress, faces, known is not None and stamp.is_of_faces(known, faces))


def restore(data, progress=no_progress, faces=None, has_faces=False):
    """rewrite(), also where the geometry was changed by others: their changes are lost. has_faces: whether it is known to
    have those."""
    definition = store.read(data)
    if definition is None:
        return None
    require_writable(data)
    picture = evaluated(data, definition, recipes.around(data), faces, has_faces)
    progress(1)
    _finish(data, picture, progress)
    return picture.tessellation


def _finish(data, picture, progress):
    store.write_final(data, picture.write() or stamp.of(data))
    progress(2)
    problems.set_problem(data, problems.SETTING, "")
    state.touched[key(data)] = False
    state.by_hand.discard(key(data))
    state.shown[key(data)] = settings.values(data)


def detach(data):
    """Leave a plain Mesh or Curve: what it shows stays, with exact normals where a drag left them out, the definition goes."""
    if data.library or data.override_library:
        raise Refusal("{name} is linked from another file and cannot be changed here", name=data.name)
    if store.is_draft(data) and not is_touched(data):
        with suppress(*FAILURES):
            restore(data)
    mesh_layers.have_normals_back(data)
    store.remove(data)
    recipes.remove(data)
    point_keys.remove(data)
    keyed_seams.write(data, None)
    held.write(data, ())
    handles.write(data, ())
    curve_layers.set_number(data, 0)


def is_touched(data):
    """Whether the geometry is not what was written: edited by hand, joined, remeshed, moved by Apply Transform."""
    known = store.read_stamp(data) if store.has_definition(data) else None
    return known is not None and not stamp.agree(known, stamp.of(data))


def seems_touched(data):
    """is_touched() as it was when Blender last reported a change, for what panels and overlays draw again and again."""
    name = key(data)
    if name not in state.touched:
        state.touched[name] = is_touched(data)
    return state.touched[name]


class Picture(NamedTuple):
    """What a definition shows at the settings of a data-block."""

    points: np.ndarray                  # (n, 3) float32, all of them
    write: Callable                     # puts it into the data-block; gives its stamp then, or None where it is to be read
    tessellation: object = None         # the splinecore Tessellation of patches


def evaluated(data, definition, around=None, faces=None, has_faces=False):
    """The Picture of a definition, evaluated now and written when its write() is called; around as of set_definition(),
    faces and has_faces as of restore().

    Raises Refusal or an error of the library where there is nothing finite to show.
    """
    if definition.has_curves:
        value = definitions.to_value(definition)
        curves = value if isinstance(value, list) else [value]
        owned = [(piece, line) for piece, curve in zip(definition.pieces, curves) for line in lines_of(data, curve, around)]
        if not owned:
            raise sc.InvalidShape("no piece of the curve lies within reach")
        lines = [(_single(points), closed) for _, (points, closed) in owned]
        names = [piece.name for piece, _ in owned]

        def write_lines():
            write_curve.write(data, lines)
            piece_materials.show(data, names)
        return Picture(np.concatenate([points for points, _ in lines]), write_lines)
    patch_set = definitions.to_patch_set(definition)
    is_known = faces is not None and faces.fits(patch_set)
    tessellation = faces if is_known else tessellate.tessellated(data, patch_set)
    positions, normals = tessellation.evaluate(patch_set)
    _single(positions)
    sharp = tessellation.sharp_edges(normals, settings.of(data).sharp_angle)
    is_there = is_known and has_faces
    names = [piece.name for piece in definition.pieces]

    def write():
        stays = write_mesh.write(data, tessellation, positions, normals, sharp, is_there)
        piece_materials.show_faces(data, names)
        if stays:
            return stamp.of_faces(data, tessellation, positions)
    return Picture(positions, write, tessellation)


def faces_of(data):
    """The splinecore Tessellation whose faces a Mesh was written with, made again, or None where it is not to be had or
    asks for other faces as soon as points move."""
    known = store.read_stamp(data) if tessellate.by_count(data) else None
    definition = store.read(data) if known is not None else None
    if definition is None or definition.has_curves:
        return None
    try:
        found = tessellate.tessellated(data, definitions.to_patch_set(definition))
    except sc.InvalidShape:
        return None
    return found if stamp.is_of_faces(known, found) else None


def lines_of(data, curve, around=None):
    """The polylines by which a data-block shows one of its curves; around as of set_definition()."""
    chosen = settings.of(data)
    return curve.polylines(tessellate.steps_of(data, curve), chosen.reach, around)


def points_of(data):
    """(n, 3) float64: the points that the data-block holds."""
    if isinstance(data, bpy.types.Mesh):
        flat = np.empty(3 * len(data.vertices), np.float32)
        data.vertices.foreach_get('co', flat)
        return flat.reshape(-1, 3).astype(np.float64)
    found = [np.empty((0, 3))]
    for spline in data.splines:
        flat = np.empty(4 * len(spline.points), np.float32)
        spline.points.foreach_get('co', flat)
        found.append(flat.reshape(-1, 4)[:, :3])
    return np.concatenate(found).astype(np.float64)


def _single(points):
    """The points as Blender holds them, in float32. Raises InvalidShape if one is too far away."""
    with np.errstate(over='ignore'):
        points = points.astype(np.float32)
    if not np.isfinite(points).all():
        raise sc.InvalidShape("a point is farther away than Blender can show (3.4e38)")
    return points


def require_writable(data):
    """Raises Refusal where writing would be lost, or would lose something."""
    store.require_known_version(data)
    if data.library:
        raise Refusal("{name} is linked from another file and cannot be changed here", name=data.name)
    if data.override_library or data.is_evaluated:
        raise Refusal("{name} is an evaluated copy: change the original", name=data.name)
    if data.is_editmode:
        raise Refusal("{name} is in Edit Mode: leave it first", name=data.name)
    if data.shape_keys:
        raise Refusal("{name} has shape keys, which hold other positions: remove them first", name=data.name)


def require_untouched(data):
    """Raises Refusal where writing would throw away what others made of the geometry."""
    if is_touched(data):
        raise Refusal("{name} was changed by hand since Splinewright wrote it: Discard Manual Changes makes it again, "
                      "Convert to Plain Mesh/Curve keeps them and ends the shape",
                      name=data.name)
