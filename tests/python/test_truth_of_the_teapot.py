"""Newell's teapot: its area, box and borders, computed from its numbers alone, against what the library says."""

import json
from pathlib import Path

import numpy as np
import pytest

import bicubic
import splinecore as sc
from bicubic import Real

TEAPOT = json.loads((Path(__file__).resolve().parents[2] / "addon/splinewright/core/shape/teapot.json").read_text())
POINTS, ROWS = np.array(TEAPOT['points']), [np.array(rows, np.int32).reshape(4, 4) for rows in TEAPOT['patches']]
NETS = [POINTS.astype(Real)[rows] for rows in ROWS]


def teapot():
    return sc.PatchSet(POINTS, ROWS)


@pytest.fixture(scope='module')
def box():
    return bicubic.box(NETS)


def test_the_independent_rule_is_right_for_polynomials_and_for_a_flat_patch():
    nodes, weights = bicubic.gauss_legendre(12)
    for power in range(24):
        assert abs(weights @ nodes**power - Real(1) / (power + 1)) <= 4e-19
    flat = np.stack(np.meshgrid(np.arange(4), np.arange(4), [0], indexing='ij'), -1)[:, :, 0].astype(Real)
    assert abs(bicubic.area(flat, 1, 4) - 9) <= 1e-17


@pytest.mark.skipif(np.finfo(Real).nmant < 63, reason="no extended precision on this machine")
def test_the_area_agrees_in_twelve_digits_and_more():
    coarse, fine = (np.array([bicubic.area(net, *rule) for net in NETS]) for rule in ((5, 24), (8, 30)))
    assert np.abs(fine - coarse).max() <= 1e-14, "the rule itself has as many digits"
    assert abs(teapot().area() - fine.sum()) <= 1e-14 * fine.sum()
    assert np.abs([teapot()[i].area() / area - 1 for i, area in enumerate(fine)]).max() <= 1e-14


def test_the_extremes_are_where_the_library_evaluates_them(box):
    patches = teapot()
    for values in box:
        for axis, (value, (number, u, v)) in enumerate(values):
            assert abs(patches[number].evaluate(float(u), float(v))[axis] - value) <= 4e-15


def test_no_point_that_the_library_evaluates_is_outside_and_the_box_is_not_that_of_the_points(box):
    patches, t = teapot(), np.linspace(0, 1, 129)
    least, most = (np.array([float(value) for value, _ in values]) for values in box)
    dense = np.concatenate([patches[i].evaluate_grid(t, t).reshape(-1, 3) for i in range(len(patches))])
    assert (dense >= least - 4e-15).all() and (dense <= most + 4e-15).all()
    assert np.abs(dense.min(axis=0) - least).max() <= 1e-3 and np.abs(dense.max(axis=0) - most).max() <= 1e-3
    assert (POINTS.max(axis=0) > most + 0.01).any()


def test_meshes_reach_the_box_and_never_leave_it(box):
    patches = teapot()
    least, most = (np.array([float(value) for value, _ in values]) for values in box)
    for mesh in (sc.Tessellation(patches, 64), sc.Tessellation.adaptive(patches, tolerance=1e-3)):
        positions = mesh.evaluate_positions(patches)
        assert (positions >= least - 4e-7).all() and (positions <= most + 4e-7).all()
        assert max(np.abs(positions.min(axis=0) - least).max(), np.abs(positions.max(axis=0) - most).max()) <= 2e-3


def test_the_borders_are_those_that_the_points_say():
    counts, poles = bicubic.sides(NETS)
    free = [row for row, times in counts.items() if times == 1]
    shared = [row for row, times in counts.items() if times == 2]
    assert len(free) + len(shared) == len(counts)
    assert teapot().edge_counts() == {'shared': len(shared), 'free': len(free), 'pole': poles}
    assert bicubic.loops(free) == 6, "rims of body and lid, two ends of the handle, two of the spout"


@pytest.mark.parametrize('mesh', (lambda patches: sc.Tessellation(patches, 7),
                                  lambda patches: sc.Tessellation.adaptive(patches, tolerance=0.02)))
def test_a_mesh_has_as_many_loops_of_borders(mesh):
    mesh = mesh(teapot())
    starts = np.r_[mesh.face_starts, len(mesh.corner_vertices)]
    following = np.arange(1, len(mesh.corner_vertices) + 1)
    following[starts[1:] - 1] = starts[:-1]
    edges = np.stack([mesh.corner_vertices, mesh.corner_vertices[following]], axis=1)
    _, index, uses = np.unique(np.sort(edges, axis=1), axis=0, return_index=True, return_counts=True)
    assert bicubic.loops([tuple(edge) for edge in edges[index[uses == 1]].tolist()]) == 6
