"""What the library refuses of the items that it counts is said of the inputs that they are, by their numbers, which become names."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core
from splinecore import build
from test_addon_caps import CIRCLE, make, moved, polygon

failures, sections = core('base.failures'), core('surfaces.sections')
NAMES = ("ann", "bob", "cid", "dan", "eve", "fay")


def refused(kind, *inputs, **values):
    """What a modeler is told, with names."""
    with pytest.raises(failures.AboutInputs) as caught:
        make(kind, *inputs, **values)
    return str(caught.value.named(NAMES))


def line(*points):
    return build.polynomial_through(points).to_nurbs()


def test_items_become_inputs_and_texts_keep_their_braces():
    with pytest.raises(failures.AboutInputs) as caught, failures.about_items(sections=[2, 0], along_u=[4]):
        raise sc.InvalidShape("sections[1] is {x}, along_u[0] not; sections[7] is unknown")
    assert str(caught.value.named(NAMES)) == "ann is {x}, eve not; sections[7] is unknown"
    with pytest.raises(sc.InvalidShape, match="^nothing is counted$"), failures.about_items(sections=[0]):
        raise sc.InvalidShape("nothing is counted")
    with pytest.raises(failures.AboutInputs) as caught, failures.about_items(side=[3, 5]):
        raise sc.InvalidShape("side 1 ends where no other one does")
    assert str(caught.value.named(NAMES)) == "fay ends where no other one does"


def test_fillings_name_curves_that_cross_or_do_not_close():
    rim = polygon((-4, -4), (4, -4), (4, 4), (-4, 4))
    assert refused('filling', rim, CIRCLE, moved(CIRCLE, x=1.0)).startswith("bob and cid cross or touch")
    loop = sc.NurbsCurve(3, np.arange(5.0), [(0, 0, 0), (1, 1, 0), (1, 0, 0), (0, 1, 0)], periodic=True)
    assert refused('filling', rim, loop).startswith("bob crosses itself")
    bent = line((0, 0, 0), (1, 0, 0))
    assert "ends of" in refused('filling', bent, line((1, 0, 0), (1, 1, 0)), line((1, 1, 0), (0, 1, 0)))


def test_networks_name_curves_and_surfaces():
    u = [line((0, y, 0), (1, y, 0)) for y in (0.0, 1.0)]
    v = [line((x, 0, 0), (x, 1, 0)) for x in (0.0, 1.0)]
    across = line((0, 0.2, 0), (1, 0.8, 0))
    assert "meet each other" in refused('network', *u, *v, line((0.5, -1, 0), (0.5, 2, 0)), line((0.2, -1, 0), (0.8, 2, 0)), across)
    far = build.plane((9, 9, 9), (1, 0, 0), (0, 1, 0))
    assert refused('network', far, *u, *v).startswith("ann has no side on which a curve lies")
    assert refused('network', *u, far, *v).startswith("cid has no side")


def test_sweeps_name_sections():
    rail = line((0, 0, 0), (0, 0, 4))
    twice = line((-1, 0, 1), (1, 0, 2), (-1, 0, 3))
    assert refused('sweep', rail, CIRCLE, twice, placed='there').startswith("cid crosses the rail at 2 places")
    with pytest.raises(failures.AboutInputs, match="input 1 has 2 pieces, input 2 has 1"):
        make('ruled', [rail, CIRCLE], twice)
