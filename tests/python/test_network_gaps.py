"""Curves of a network that pass one another by a gap."""

import numpy as np
import pytest

import splinecore as sc

def test_curves_may_pass_one_another_by_a_gap(inputs):
    """Crossing waves that are lifted by random heights: within the gap there is a surface, as near as its error says and to 8 times
    the gap; the tolerance decides how many points it has as without a gap."""
    random = np.random.default_rng(20261128)
    made = 0
    for _ in range(inputs(200)):
        gap, phase = 10.0 ** random.uniform(-5.0, -1.5), random.uniform(0.0, 6.0)
        height = lambda x, y: 0.3 * np.sin(2.0 * x + phase) * np.cos(1.5 * y)
        rows, columns = (np.linspace(0.0, 1.0, n) for n in random.integers(2, 5, 2))
        t = np.linspace(0.0, 1.0, 9)
        along_u = [sc.fit.interpolate(np.c_[t, 0 * t + y, height(t, y) + random.uniform(0, gap)]).value for y in rows]
        along_v = [sc.fit.interpolate(np.c_[0 * t + x, t, height(x, t) + random.uniform(0, gap)]).value for x in columns]
        with pytest.raises(sc.Error, match="do not meet"):
            sc.build.network(along_u, along_v, tolerance=1e-7)
        value, error = sc.build.network(along_u, along_v, tolerance=1e-6, gap=1.01 * gap + 1e-5)
        far = max(value.nearest(curve.evaluate(np.linspace(*curve.domain, 40))).distances.max() for curve in (*along_u, *along_v))
        assert far <= 1.02 * error + 1e-9 and error <= 8.1 * gap + 1e-5
        made += 1
    assert made == inputs(200)


def test_a_gap_is_a_length():
    line = sc.BezierCurve([(0, 0, 0), (1, 0, 0)])
    for gap, message in ((-1.0, "gap = -1 is below 0"), (0.0, "gap = 0 is not a positive length")):
        with pytest.raises(sc.InvalidShape, match=message):
            sc.build.network([line, line], [line, line], gap=gap)
