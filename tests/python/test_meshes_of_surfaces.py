"""Meshes of primitives, of what curves make by moving, and of the teapot, by count and adaptive (lecture row S22)."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import mesh_checks
import splinecore as sc
from splinecore import build

TEAPOT = json.loads((Path(__file__).resolve().parents[2] / "addon/splinewright/core/shape/teapot.json").read_text())
ORIGIN, UP = (0, 0, 0), (0, 0, 1)
PROFILE = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 2, 2, 2],
                        [(1, 0, 0), (1.5, 0, 0.5), (0.5, 0, 1), (1, 0, 1.5), (1.2, 0, 2)], [1, 2, 1, 0.5, 1])
BOWL = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 2, 2, 2], [(0, 0, 0.1), (0.5, 0, 0.1), (1, 0, 0.5), (0.9, 0, 1), (1.2, 0, 1.4)])
PARABOLA = sc.BezierCurve([(0, 0, 2), (1, 0, 2), (2, 0, 0)])


def set_of(*patches):
    return sc.PatchSet.from_patches(list(patches))


def can(turned_down=lambda disc: disc.reversed('v')):
    """A cylinder with caps; the lower one is a disc with its normal turned down."""
    low = turned_down(build.disc(ORIGIN, UP, 1))
    return set_of(build.cylinder(ORIGIN, UP, 1, 2), low, build.disc((0, 0, 2), UP, 1))


def teapot():
    rows = [np.array(numbers, np.int32).reshape(4, 4) for numbers in TEAPOT['patches']]
    return sc.PatchSet(np.array(TEAPOT['points']), rows)


SHAPES = {
    'plane': lambda: set_of(build.plane(ORIGIN, (2, 0, 0), (0, 1, 0))),
    'disc': lambda: set_of(build.disc(ORIGIN, UP, 1)),
    'sector': lambda: set_of(build.disc(ORIGIN, UP, 1, 0.3, 2.0)),
    'cylinder': lambda: set_of(build.cylinder(ORIGIN, UP, 1, 2)),
    'cylinder with caps': can,
    'half a cylinder': lambda: set_of(build.cylinder(ORIGIN, UP, 1, 2, 0.5, math.pi)),
    'cone with its cap': lambda: set_of(build.cone(ORIGIN, UP, 1, 2), build.disc(ORIGIN, UP, 1).reversed('v')),
    'cone of another height': lambda: set_of(build.cone(ORIGIN, UP, 1, 1.9)),
    'truncated cone': lambda: set_of(build.cone(ORIGIN, UP, 1, 2, 0.5)),
    'sphere': lambda: set_of(build.sphere(ORIGIN, 1)),
    'slice of a sphere': lambda: set_of(build.sphere(ORIGIN, 1, UP, 0.5, 2.0)),
    'torus': lambda: set_of(build.torus(ORIGIN, UP, 1, 0.25)),
    'third of a torus': lambda: set_of(build.torus(ORIGIN, UP, 1, 0.25, 0, -2.0)),
    'revolved': lambda: set_of(build.revolve(PROFILE, ORIGIN, UP)),
    'bowl': lambda: set_of(build.revolve(BOWL, ORIGIN, UP)),
    'revolved from the axis': lambda: set_of(build.revolve(PARABOLA, ORIGIN, UP)),
    'partly revolved': lambda: set_of(build.revolve(PROFILE, ORIGIN, UP, 0, 4.0)),
    'extruded': lambda: set_of(build.extrude(PROFILE, (0, 1, 0))),
    'extruded circle': lambda: set_of(build.extrude(sc.conics.circle(ORIGIN, 1, UP), (0, 0, 1))),
    'ruled': lambda: set_of(build.ruled(PROFILE, PROFILE.with_points(PROFILE.points + (0, 2, 0)).elevate())),
    'teapot': teapot,
}
CLOSED = ('cylinder with caps', 'cone with its cap', 'sphere', 'torus')
CAPS = {'running back': lambda disc: disc.reversed('u'), 'swapped': lambda disc: disc.swapped(),
        'of higher degree': lambda disc: disc.reversed('v').elevate('u'),
        'with one knot more': lambda disc: disc.reversed('v').insert_knot('u', 0.4)}
COUNTS = (2, 5, (3, 8), (7, 2), 16)
ADAPTIVE = ({'tolerance': 0.05}, {'tolerance': 0.01}, {'angle': 0.3}, {'angle': 0.15})


@pytest.mark.parametrize('resolution', COUNTS, ids=str)
@pytest.mark.parametrize('name', SHAPES)
def test_a_mesh_by_count_holds_together_and_has_sound_faces(name, resolution):
    patch_set = SHAPES[name]()
    mesh_checks.check(patch_set, sc.Tessellation(patch_set, resolution))


@pytest.mark.parametrize('settings', ADAPTIVE, ids=str)
@pytest.mark.parametrize('name', SHAPES)
def test_an_adaptive_mesh_holds_together_and_has_sound_faces(name, settings):
    patch_set = SHAPES[name]()
    mesh_checks.check(patch_set, sc.Tessellation.adaptive(patch_set, **settings))


@pytest.mark.parametrize('make', (lambda s: sc.Tessellation(s, 6),
                                  lambda s: sc.Tessellation.adaptive(s, tolerance=0.05)), ids=('by count', 'adaptive'))
@pytest.mark.parametrize('name', SHAPES)
def test_a_shape_is_closed_or_open_as_its_name_says(name, make):
    patch_set = SHAPES[name]()
    uses, _ = mesh_checks.edge_uses(mesh_checks.mesh_of(patch_set, make(patch_set)))
    assert (uses == 2).all() == (name in CLOSED)


@pytest.mark.parametrize('resolution', COUNTS, ids=str)
@pytest.mark.parametrize('change', CAPS)
def test_by_count_a_cap_meets_its_cylinder_whatever_its_parameters(change, resolution):
    patch_set = can(CAPS[change])
    mesh_checks.check(patch_set, sc.Tessellation(patch_set, resolution))


@pytest.mark.parametrize('change', CAPS)
def test_adaptively_a_cap_meets_its_cylinder_whatever_its_parameters(change):
    patch_set = can(CAPS[change])
    mesh_checks.check(patch_set, sc.Tessellation.adaptive(patch_set, tolerance=0.05))


def steps_of_circle(tolerance):
    """The fewest steps on a quarter that leave no part of a circle of radius 1 farther than that."""
    return next(n for n in range(1, 100) if 1 - math.cos(math.pi / (4 * n)) <= tolerance)


@pytest.mark.parametrize('tolerance', (0.05, 0.01, 0.004))
@pytest.mark.parametrize('name, patches', (('disc', 1), ('cylinder', 1), ('extruded circle', 1),
                                           ('cylinder with caps', 3), ('cone with its cap', 2)))
def test_what_is_straight_one_way_costs_little_more_than_the_square_grid_of_the_same_promise(name, patches, tolerance):
    """Cells are halved: they may be half as long and wide as needed, not less."""
    resolution, patch_set = steps_of_circle(tolerance), SHAPES[name]()
    grid = sc.Tessellation(patch_set, resolution)
    assert len(grid.face_starts) == 4 * patches * resolution**2
    adaptive = sc.Tessellation.adaptive(patch_set, tolerance=tolerance)
    assert len(adaptive.face_starts) <= 4 * len(grid.face_starts)


def broken(change):
    """A mesh of a torus that is no longer sound."""
    patch_set = SHAPES['torus']()
    mesh = mesh_checks.mesh_of(patch_set, sc.Tessellation(patch_set, 5))
    return patch_set, change(mesh)


def flipped_face(mesh):
    vertex = mesh.vertex.copy()
    vertex[:4] = vertex[3::-1]
    return mesh._replace(vertex=vertex)


def torn(mesh):
    vertex = mesh.vertex.copy()
    vertex[0] = len(mesh.positions)
    return mesh._replace(vertex=vertex, positions=np.vstack([mesh.positions, mesh.positions[mesh.vertex[0]]]))


def flattened(mesh):
    positions = mesh.positions.copy()
    positions[mesh.vertex[0]] = positions[mesh.vertex[1]]
    return mesh._replace(positions=positions)


@pytest.mark.parametrize('change', (flipped_face, torn, flattened))
def test_the_checks_see_what_is_broken(change):
    patch_set, mesh = broken(change)
    with pytest.raises(AssertionError):
        mesh_checks.check_borders(mesh, mesh_checks.sides_of(patch_set, 1.25))
        mesh_checks.check_faces(mesh, patch_set)


def test_the_checks_see_a_vertex_inside_an_edge():
    """A square with two half as wide beside it."""
    positions = np.array([(0, 0), (1, 0), (1, 1), (0, 1), (2, 0), (2, 0.5), (1, 0.5), (2, 1)], float)
    vertex = np.array([0, 1, 2, 3, 1, 4, 5, 6, 6, 5, 7, 2])
    following = np.array([1, 2, 3, 0, 5, 6, 7, 4, 9, 10, 11, 8])
    mesh = mesh_checks.Mesh(vertex, following, None, None, None, None, np.c_[positions, np.zeros(8)], None)
    with pytest.raises(AssertionError, match="inside the edge"):
        mesh_checks.check_no_vertex_on_an_edge(mesh, 2)


def test_the_checks_see_a_sliver():
    patch_set = SHAPES['plane']()
    mesh = mesh_checks.mesh_of(patch_set, sc.Tessellation(patch_set, (2, 1)))
    positions = mesh.positions.copy()
    positions[mesh.vertex[(mesh.uv == (0.5, 0)).all(axis=1)][0], 0] += 0.97
    own, given = mesh_checks.qualities(mesh._replace(positions=positions), patch_set)
    assert own.min() < 0.1 and given.min() > 0.5
