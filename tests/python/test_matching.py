"""Match with both surfaces moving: they go on from each other, each moves about half of what one alone would."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core
from splinecore import build

matching, definitions = core("surfaces.matching"), core("shape.definition")
RECIPES = core("recipes.table").RECIPES
SIDES = ("u_start", "u_end", "v_start", "v_end")


def sheet(rng, degree, spans, x, is_rational):
    """A wavy patch over a unit square from x on, with random knots."""
    knots, at = [], []
    for p, count in zip(degree, spans):
        inner = np.sort(rng.uniform(0.1, 0.9, count - 1))
        knots.append(np.r_[[0.0] * (p + 1), inner, [1.0] * (p + 1)])
        at.append(np.array([knots[-1][i + 1:i + p + 1].mean() for i in range(p + count)]))
    grid = np.stack(np.meshgrid(*at, indexing="ij") + [rng.normal(0, 0.03, (len(at[0]), len(at[1])))], -1)
    grid[..., 0] += x
    weights = rng.uniform(0.8, 1.25, grid.shape[:2]) if is_rational else None
    return sc.NurbsPatch(degree, knots, grid, weights)


def turned(patch, rng):
    """The same patch, run another way, and the name of the side that was u_start."""
    names = {"u_start": "u_start"}
    side = "u_start"
    if rng.random() < 0.5:
        patch, side = patch.reversed("v"), side
    if rng.random() < 0.5:
        patch, side = patch.swapped(), "v_start"
    if rng.random() < 0.5:
        patch, side = patch.reversed(side[0]), f"{side[0]}_end"
    return patch, names.get(side, side)


@pytest.mark.parametrize("continuity, angle", (("G0", None), ("G1", 1e-4), ("G2", 1e-4)))
def test_random_pairs_meet_and_share_the_way(continuity, angle, inputs):
    shares = []
    for seed in range(inputs(60)):
        rng = np.random.default_rng(seed)
        of = [tuple(int(n) for n in rng.integers(*range_, 2)) for range_ in ((2, 5), (1, 5), (2, 5), (1, 5))]
        first = sheet(rng, of[0], of[1], 0.0, rng.random() < 0.3).reversed("u")
        gap = float(rng.uniform(0.01, 0.1))
        second, side = turned(sheet(rng, of[2], of[3], 1.0 + gap, rng.random() < 0.3), rng)
        found = matching.half_way(first, "u_start", second, side, continuity, None, 1.0)
        seam = sc.seam_continuity(found.first, "u_start", found.second, side)
        assert seam.gap <= 1e-9, seed
        if angle:
            assert seam.angle <= angle, seed
        alone = build.match_patch(first, "u_start", second, side, continuity).error
        is_rational = found.first.is_rational       # weights shift what lies half way
        assert found.moved[0] == pytest.approx(0.5 * alone, rel=0.6 if is_rational else 0.05)
        other_alone = build.match_patch(second, side, first, "u_start", continuity).error
        shares.append(max(found.moved) / max(alone, other_alone))
        edges = [patch.boundary(name) for patch, name in ((first, "u_start"), (second, side), (found.first, "u_start"))]
        t = np.linspace(0, 1, 9)
        own, theirs, made = (edge.evaluate(edge.domain[0] + (edge.domain[1] - edge.domain[0]) * t) for edge in edges)
        far = np.linalg.norm(own - theirs, axis=1).max()
        assert np.linalg.norm(made - own, axis=1).max() <= max(far, np.linalg.norm(own - theirs[::-1], axis=1).max()), seed
    assert np.median(shares) <= 0.75


def test_the_recipe_makes_both_and_says_how_far_each_moved():
    rng = np.random.default_rng(1)
    first, second = sheet(rng, (3, 3), (2, 2), 0.0, False), sheet(rng, (2, 3), (3, 1), 1.05, False)
    recipe = RECIPES["matched"]
    given = [definitions.from_value(one) for one in (first, second)]
    made = recipe.make(given, **{**recipe.defaults, "both": True})
    whole = definitions.to_patch_set(made.definition)
    assert len(whole) == 2 and " and " in made.said and "gap 0" in made.said
    assert len(made.definition.pool) < sum(whole[i].points[..., 0].size for i in range(2))      # the seam is shared
    assert len(recipe.make(given, **recipe.defaults).definition.pieces) == 1
