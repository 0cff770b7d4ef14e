"""Blender's own sphere, torus and cylinder, and random surfaces: vertex by vertex against the exact patches of them.

Of single nets test_against_blender.py compares all flags and degrees. Here are the objects that users add, what
Convert to Splinewright leaves in the scene, surfaces of several patches, and our own sphere, torus and cylinder beside them.
"""

import math

import bpy
import numpy as np
import pytest

import blender_objects
from geometry import mesh_points
from natives import SURFACES, exact, native_surface
from support import part, splinecore as sc

native = part('core.native.native')
read_native = part('bridge.native.read_native')
table = part('core.recipes.table')

#: Blender's rounding relative to the size, as in test_against_blender.py: it adds parameters up in single precision.
TOLERANCE = 1e-4
#: On surfaces of few pieces these sums are short.
PRIMITIVE_TOLERANCE = 1e-5
RESOLUTIONS = ((1, 1), (2, 3), (4, 4), (7, 5), (12, 12))


def set_resolution(ob, u, v):
    for spline in ob.data.splines:
        spline.resolution_u, spline.resolution_v = u, v
    ob.data.update_tag()


def ours(ob):
    """What the exact patches say at the places where Blender samples, in Blender's order of vertices."""
    reading, found = read_native.read(ob), []
    assert len(reading.pieces) == len(ob.data.splines)
    for piece, made, spline in zip(reading.pieces, reading.splines, ob.data.splines):
        u, v = map(native.surface_parameters, made.directions, (spline.resolution_u, spline.resolution_v))
        found.append(piece.evaluate_grid(v, u).swapaxes(0, 1).reshape(-1, 3))
    return np.concatenate(found)


def compare(ob, tolerance=TOLERANCE):
    expected, drawn = ours(ob), blender_objects.evaluated_vertices(ob)
    size = max(np.abs(point.co[:3]).max() for spline in ob.data.splines for point in spline.points)
    assert expected.shape == drawn.shape
    assert np.linalg.norm(expected - drawn, axis=1).max() <= tolerance * size


@pytest.mark.parametrize('resolution', RESOLUTIONS, ids=str)
@pytest.mark.parametrize('name', SURFACES)
def test_what_a_user_adds_is_exactly_what_blender_draws(name, resolution):
    ob = native_surface(name)
    set_resolution(ob, *resolution)
    compare(ob, PRIMITIVE_TOLERANCE)
    value = read_native.read(ob).value
    exact(ob)
    assert ob.data.splinewright.value == value


@pytest.mark.parametrize('seed', range(6))
@pytest.mark.parametrize('name', SURFACES)
def test_it_stays_so_when_points_weights_orders_and_flags_are_others(name, seed):
    rng = np.random.default_rng((seed, SURFACES.index(name)))
    ob = native_surface(name)
    spline = ob.data.splines[0]
    for point in spline.points:
        point.co = (*(np.array(point.co[:3]) + rng.uniform(-0.3, 0.3, 3)), rng.uniform(0.5, 2))
    set_resolution(ob, *rng.integers(1, 6, 2).tolist())
    for axis in 'uv':
        for flag in ('cyclic', 'endpoint', 'bezier'):
            setattr(spline, f"use_{flag}_{axis}", bool(rng.integers(2)))
        setattr(spline, f"order_{axis}", int(rng.integers(2, 1 + min(6, getattr(spline, f"point_count_{axis}")))))
    if len(blender_objects.evaluated_vertices(ob)) == 0:
        assert read_native.read(ob).value is None, "Blender draws nothing of it"
        return
    compare(ob)


def test_all_primitives_in_one_object_are_a_patch_set_of_what_blender_draws():
    ob = native_surface(SURFACES[0])
    bpy.ops.object.mode_set(mode='EDIT')
    for place, name in enumerate(SURFACES[1:], 1):
        getattr(bpy.ops.surface, name)(location=(3 * place, 0, 0))
    bpy.ops.object.mode_set(mode='OBJECT')
    set_resolution(ob, 3, 4)
    assert len(ob.data.splines) == 4
    compare(ob)
    value = read_native.read(ob).value
    exact(ob)
    assert isinstance(value, sc.PatchSet) and ob.data.splinewright.value == value


@pytest.mark.parametrize('flags', native.ALL_FLAGS, ids=str)
def test_random_nets_made_exact_show_what_blender_drew(flags):
    rng = np.random.default_rng((31, *flags))
    pair = [native.Direction(6, degree, other) for degree, other in ((2, flags), (3, native.Flags(endpoint=True)))]
    net = rng.uniform(-1, 1, (6, 6, 4))
    net[..., 3] = rng.uniform(0.5, 2, (6, 6))
    ob = blender_objects.surface_object(6, 6)
    blender_objects.set_surface(ob, net, pair, (5, 3))
    compare(ob)
    exact(ob)
    value, settings = ob.data.splinewright.value, ob.data.splinewright
    patches = sc.PatchSet.from_patches([value], merge=False)
    mesh = sc.Tessellation(patches, (settings.resolution_u, settings.resolution_v))
    assert np.array_equal(mesh_points(ob.data), mesh.evaluate_positions(patches))


def error_of_radius(kind, points):
    """How far points lie from Blender's sphere or cylinder of radius 1, or its torus of the radii 3/4 and 1/4."""
    across, height = np.linalg.norm(points[..., :2], axis=-1), points[..., 2]
    errors = {'sphere': np.hypot(across, height) - 1, 'cylinder': across - 1,
              'torus': np.hypot(across - 0.75, height) - 0.25}
    return np.abs(errors[kind]).max()


#: Our recipes with the numbers, and the start and way round, of Blender's own.
LIKE_BLENDERS = {'sphere': {'radius': 1.0, 'start': math.pi},
                 'torus': {'radius': 0.75, 'tube_radius': 0.25, 'start': math.pi},
                 'cylinder': {'radius': 1.0, 'height': 2.0, 'start': -math.pi / 2, 'sweep': -2 * math.pi, 'caps': False}}


def recipe_points(kind, patch, u, v):
    """Points of our recipe at parameters of Blender's patch: its cylinder has u and v the other way, and the tube of
    its torus begins at the bottom, where ours begins outside."""
    shares = [(at - start) / (end - start) for at, (start, end) in zip((u, v), patch.domain)]
    recipe = table.RECIPES[kind]
    made = recipe.make(recipe.start, **{**recipe.defaults, **LIKE_BLENDERS[kind]}).value
    if kind == 'cylinder':
        made = made.swapped()
    if kind == 'torus':
        shares[1] = np.mod(shares[1] - 0.25, 1.0)
    return made.evaluate_grid(*(start + share * (end - start) for share, (start, end) in zip(shares, made.domain)))


@pytest.mark.parametrize('kind', LIKE_BLENDERS)
def test_our_recipes_are_blenders_own_surfaces_with_all_digits(kind):
    ob = native_surface(f'primitive_nurbs_surface_{kind}_add')
    patch = read_native.read(ob).value
    at = [np.linspace(*domain, 201) for domain in patch.domain]
    blenders, recipes = patch.evaluate_grid(*at), recipe_points(kind, patch, *at)
    assert np.abs(blenders - recipes).max() <= 4e-7
    # Blender's single precision leaves 1.2e-7 on sphere and torus, and 3e-9 on the cylinder.
    assert 1e-9 < error_of_radius(kind, blenders) <= 2e-7 and error_of_radius(kind, recipes) <= 5e-16


@pytest.mark.parametrize('resolution', RESOLUTIONS, ids=str)
@pytest.mark.parametrize('kind', LIKE_BLENDERS)
def test_the_mesh_that_blender_makes_of_its_own_has_the_vertices_of_our_recipe(kind, resolution):
    ob = native_surface(f'primitive_nurbs_surface_{kind}_add')
    set_resolution(ob, *resolution)
    reading, drawn = read_native.read(ob), blender_objects.evaluated_vertices(ob)
    u, v = map(native.surface_parameters, reading.splines[0].directions, resolution)
    expected = recipe_points(kind, reading.value, v, u).swapaxes(0, 1).reshape(-1, 3)
    assert expected.shape == drawn.shape and np.abs(expected - drawn).max() <= PRIMITIVE_TOLERANCE
