"""A drawn stroke becomes a clean curve; one that is too short is refused."""

import bpy
import numpy as np
import pytest

from curves import said_near
from shapes import op, require_exact
from support import splinecore as sc
from test_curve_through import value
from test_menus import drawn

T = np.linspace(0, 1, 60)
DRAWN = np.stack([4 * T, np.sin(6 * T), 0.2 * T], -1)
LOOP = np.stack([np.cos(6 * T), np.sin(6 * T), 0 * T], -1)


def text_of(points):
    return " ".join(map(repr, np.ravel(points).tolist()))


@pytest.mark.parametrize('points, closed', ((DRAWN, False), (LOOP, True)))
def test_a_stroke_becomes_a_clean_curve_within_the_tolerance(points, closed, capfd):
    assert op(bpy.ops.splinewright.draw_curve, stroke=text_of(points), tolerance=0.0625, closed=closed) == {'FINISHED'}
    made, error = sc.fit.approximate(points, tolerance=0.0625, parameters='centripetal', corrections=3, closed=closed)
    assert value(bpy.context.object) == made
    require_exact(bpy.context.object)
    assert error <= 0.0625 and len(made.points) < len(points) / 2
    assert said_near(capfd.readouterr().out) == (len(made.points), pytest.approx(error, rel=1e-3))


@pytest.mark.parametrize('stroke', ("", "0 0 0", "0 0 0 0 0 0", "1 2", "1 2 x"))
def test_what_is_no_stroke_is_refused(stroke):
    before = len(bpy.data.objects), len(bpy.data.curves)
    with pytest.raises(RuntimeError, match="stroke"):
        op(bpy.ops.splinewright.draw_curve, stroke=stroke)
    assert (len(bpy.data.objects), len(bpy.data.curves)) == before


def test_there_are_two_pens_in_the_menus():
    def begins(name):
        return getattr(bpy.types, f"SPLINEWRIGHT_OT_{name}").begins_on_surface
    assert [begins('draw_curve'), begins('draw_on_surface')] == [False, True]
    for menu in ("VIEW3D_MT_object", "VIEW3D_MT_curve_add"):
        assert {'draw_curve', 'draw_on_surface'} <= set(drawn(menu))
    op(bpy.ops.splinewright.draw_on_surface, stroke=text_of(DRAWN), tolerance=0.0625)
    first = value(bpy.context.object)
    op(bpy.ops.splinewright.draw_curve, stroke=text_of(DRAWN), tolerance=0.0625)
    assert value(bpy.context.object) == first


def test_one_undo_takes_it_back():
    bpy.ops.ed.undo_push(message="before")
    count = len(bpy.data.objects)
    op(bpy.ops.splinewright.draw_curve, stroke=text_of(DRAWN))
    bpy.ops.ed.undo()
    assert len(bpy.data.objects) == count
