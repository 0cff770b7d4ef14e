"""Shapes become Blender's own curves and surfaces, in their place."""

from ...core.base.failures import Refusal
from ...core.base.words import phrase
from ...core.shape.definition import CURVES
from ..curve import curve_layers, handles
from ..data import animation, held, settings, store, tessellate
from ..data.shading import Look
from ..keys import point_keys
from ..mesh import mesh_attributes, mesh_looks
from ..recipes import recipes
from ..shape import curve_pieces, shape
from . import native_layers, native_links, retype, write_native
from .make_exact import Outcome


def to_native(context, ob):
    """Make the data-block of a shape Blender's own, and so of all objects that share it.

    A curve keeps its data-block. A mesh of patches becomes a surface, and the objects stay the same
    objects. Raises one of the FAILURES, and has changed nothing, if it cannot be.
    """
    if not shape.has_shape(ob):
        raise Refusal("it is not a Splinewright shape")
    data, users = ob.data, native_links.users_of(ob.data)
    shape.require_writable(data)
    shape.require_untouched(data)
    for user in users:
        if ob.type == 'MESH' and (user.library or user.override_library):
            raise Refusal("{name} is linked from another file and cannot be changed here", name=user.name)
    value = shape.value_of(data)
    planned = write_native.plan(value)
    parented = native_links.parented_points(users)
    deviation, lost = (_surface if ob.type == 'MESH' else _curve)(context, ob, value, planned, users)
    return Outcome(deviation, parented + lost), planned.notes


def _curve(context, ob, value, planned, users):
    data, lost = ob.data, native_links.hooked_points(users)
    curves = [value] if isinstance(value, CURVES) else value
    steps = max(tessellate.steps_of(data, curve) for curve in curves)
    pieces, types = curve_pieces.of(data, store.read(data)), handles.known(data)
    if handles.problem(data):
        lost.append("the handle types, which are damaged")
    lost += _beside(data)
    is_flat, unfilled = native_layers.fill_of(data, range(len(data.splines)))
    if native_links.drop_point_animation(data):
        lost.append("the animation of single points")
    shape.detach(data)
    curve_layers.forget(data)
    deviation = write_native.write_curves(data, planned, steps, types)
    unlike = native_layers.give(data, planned, [curve.domain for curve in curves], pieces)
    if is_flat:
        data.dimensions = '2D'
    return deviation, lost + unfilled + [phrase("{noun} of single points", noun=noun) for noun in unlike]


def _beside(data):
    """What Blender's own curves and surfaces have not, as nouns."""
    return ["the keys of control points"] * bool(point_keys.count(data)) + ["the joints and seams that hold"] * bool(held.known(data))


def _surface(context, ob, value, planned, users):
    mesh = ob.data
    lost = mesh_attributes.in_words(mesh_attributes.keep(mesh, None)) + _beside(mesh)
    chosen = settings.of(mesh)
    surface, deviation = write_native.new_surface(
        context, mesh.name, planned, (chosen.resolution_u, chosen.resolution_v))
    for material in mesh.materials:
        surface.materials.append(material)
    looks = mesh_looks.looks_by_patch(mesh)
    for spline, number in zip(surface.splines, planned.numbers):
        spline.material_index, spline.use_smooth = looks.get(number, Look())
    if animation.paths(mesh) - {recipes.WATCHED}:
        lost.append("the animation of the mesh data")
    return deviation, lost + retype.all_become(context, users, surface, retype.become_surface, retype.become_mesh)
