"""What is done to one patch of several leaves no seam open, or says which."""

import bpy
import numpy as np
import pytest

from curves import run
from patches import value_of
from shapes import add, require_exact
from support import part, splinecore as sc

seams, store = part('core.joints.seams'), part('bridge.data.store')


def surface(seed, rows, columns, kind):
    """Patches side by side that share their borders, some turned, some with u and v exchanged."""
    random = np.random.default_rng(seed)
    points = random.normal(size=(3 * rows + 1, 3 * columns + 1, 3))
    points[..., 0] += 3.0 * np.arange(3 * rows + 1)[:, None]
    points[..., 1] += 3.0 * np.arange(3 * columns + 1)[None]
    weights = np.exp(random.normal(size=points.shape[:2])) if kind == 'rational' else None
    patches = []
    for i in range(rows):
        for j in range(columns):
            of = np.s_[3 * i:3 * i + 4, 3 * j:3 * j + 4]
            patch = sc.BezierPatch(points[of], None if weights is None else weights[of])
            if kind == 'nurbs':
                patch = sc.NurbsPatch((2, 2), ([0, 0, 0, 0.3, 1, 1, 1], [2, 2, 2, 2.5, 4, 4, 4]), points[of])
            for axis in 'uv':
                patch = patch.reversed(axis) if kind != 'nurbs' and random.random() < 0.5 else patch
            patches.append(patch.swapped() if kind != 'nurbs' and random.random() < 0.5 else patch)
    return sc.PatchSet.from_patches(patches)


def open_border(value):
    """The length of all sides that no other patch has."""
    shared = {side for pair in value.seams() for side in pair}
    total = 0.0
    for i in range(len(value)):
        patch = value[i]
        for side in ('u_start', 'u_end', 'v_start', 'v_end'):
            if (i, side) not in shared:
                axis, at = side[0], patch.domain['uv'.index(side[0])][side.endswith('end')]
                total += patch.isocurve(axis, at).length()
    return total


STEPS = (('split', {'parameter_u': 0.3, 'parameter_v': 0.6}), ('insert_knot', {'parameter_u': 0.3, 'parameter_v': 0.6}),
         ('raise_degree', {'times': 2}), ('insert_knot', {'where': 'SPANS'}))


@pytest.mark.parametrize('kind', ('bezier', 'rational', 'nurbs'))
@pytest.mark.parametrize('direction', ('U', 'V', 'BOTH'))
@pytest.mark.parametrize('name, settings', STEPS)
def test_what_was_closed_stays_closed(name, settings, direction, kind, capfd):
    for seed in range(3):
        ob = add(surface(seed, 3, 4, kind))
        before = ob.data.splinewright.value
        given = {key: (2.0 + 2.0 * at if kind == 'nurbs' and key.endswith('v') else at) for key, at in settings.items()}
        assert run(name, piece=6, direction=direction, **given) == {'FINISHED'}
        after = ob.data.splinewright.value
        assert len(after) > len(before) or name != 'split'
        assert abs(open_border(after) - open_border(before)) < 1e-9 * open_border(before)
        assert len(after) < 2 * len(before), "no more than a row of patches, and a column, are cut"
        require_exact(ob)
        assert "open now" not in capfd.readouterr().out


@pytest.mark.parametrize('direction', ('U', 'V'))
def test_without_neighbors_it_comes_open_and_says_where(direction, capfd):
    ob = add(surface(5, 1, 3, 'bezier'))
    before = open_border(ob.data.splinewright.value)
    run('split', piece=2, direction=direction, neighbors=False)
    opened = open_border(ob.data.splinewright.value) > before * (1 + 1e-9)
    assert opened == ("open now between the patches" in capfd.readouterr().out)


def test_lower_degree_of_one_patch_says_what_it_opens(capfd):
    ob = add(surface(5, 2, 2, 'bezier'))
    run('lower_degree', piece=1, direction='BOTH')
    assert "shape is open now between the patches 1 and" in capfd.readouterr().out


def test_the_teapot_stays_as_closed_as_it_was():
    ob = add(value_of('teapot'))
    before = open_border(ob.data.splinewright.value)
    for piece in (1, 9, 20, 32):
        for direction in 'UV':
            run('split', piece=piece, direction=direction, parameter_u=0.4, parameter_v=0.7)
            assert abs(open_border(ob.data.splinewright.value) - before) < 1e-9 * before
    require_exact(ob)


def test_a_ring_of_patches_is_cut_all_round():
    wall = sc.BezierCurve([(1, 0, 0), (2, 0, 1), (1, 0, 2)])
    quarters = [sc.build.revolve(wall, (0, 0, 0), (0, 0, 1), i * np.pi / 2, np.pi / 2) for i in range(4)]
    ob = add(sc.PatchSet.from_patches(quarters))
    before = open_border(ob.data.splinewright.value)
    for direction in 'UV':
        run('split', piece=1, direction=direction, parameter_u=0.5, parameter_v=0.5)
        assert abs(open_border(ob.data.splinewright.value) - before) < 1e-9 * before
    require_exact(ob)
