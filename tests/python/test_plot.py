"""splinecore.plot: what is drawn lies on the shape; axes are made or taken; without matplotlib it says what to install."""

import subprocess
import sys
import warnings

import numpy as np
import pytest

import splinecore as sc
from splinecore import build, plot
from wild_shapes import CURVES, SURFACES

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("agg")
pyplot = pytest.importorskip("matplotlib.pyplot")

CALLS = [*((call, CURVES) for call in (plot.curve, plot.comb)), *((call, SURFACES) for call in (plot.control_net, plot.isocurves))]
#: A picture has pixels, and matplotlib no room for the squares of these.
BEYOND = {"huge", "tiny", "wild weights", "degree 60", "150 of a set", "1000 of a set"}


@pytest.fixture(autouse=True)
def closed_figures():
    yield
    pyplot.close("all")


def points_of(axes, line=0):
    found = np.array(axes.lines[line].get_data_3d() if axes.name == "3d" else axes.lines[line].get_data(), float).T
    return found[np.isfinite(found).all(axis=1)]


def draw(axes):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        axes.figure.canvas.draw()


@pytest.mark.parametrize("call, shape", [pytest.param(call, shapes[name], id=f"{call.__name__}-{name}")
                                         for call, shapes in CALLS for name in sorted(set(shapes) - BEYOND)])
def test_every_shape_is_drawn(call, shape):
    axes = call(shape)
    draw(axes)
    assert axes.lines


@pytest.mark.parametrize("name", ["Bezier", "sphere", "Hermite", "many knots", "32 of a set"])
def test_surfaces_are_faces_on_the_surface(name):
    axes = plot.surface(SURFACES[name], resolution=3)
    draw(axes)
    assert len(axes.collections) == 1
    with pytest.raises(sc.InvalidShape, match="projection='3d'"):
        plot.surface(SURFACES[name], pyplot.figure().add_subplot())


def test_a_curve_is_where_it_is():
    curve = sc.BezierCurve(np.random.default_rng(1).uniform(-1, 1, (7, 3)), weights=[1, 2, 3, 1, 0.1, 5, 1])
    points = points_of(plot.curve(curve))
    assert len(points) > 50 and curve.nearest(points).distances.max() < 1e-3
    flat = points_of(plot.curve(curve, pyplot.figure().add_subplot()))
    assert np.array_equal(flat, points[:, :2])


def test_axes_are_flat_for_what_lies_in_the_plane_and_are_taken_where_they_are_given():
    flat, solid = sc.BezierCurve([(0, 0), (1, 1)]), sc.BezierCurve([(0, 0, 0), (1, 1, 1)])
    assert plot.curve(flat).name == plot.control_polygon(flat).name == plot.comb(flat).name == "rectilinear"
    axes = plot.curve(solid)
    assert axes.name == "3d" and plot.curve(flat, axes) is axes and plot.control_polygon(solid, axes=axes) is axes
    assert len(axes.lines) == 3


def test_styles_are_those_of_matplotlib():
    axes = plot.curve(CURVES["cubic"], color="red", linewidth=3)
    assert axes.lines[0].get_color() == "red" and axes.lines[0].get_linewidth() == 3
    assert plot.control_polygon(CURVES["cubic"], axes, marker="s").lines[1].get_marker() == "s"


def test_a_polygon_is_broken_at_infinity_and_a_ring_is_closed():
    assert points_of(plot.control_polygon(CURVES["half circle"])).tolist() == [[1, 0], [-1, 0]]
    ring = points_of(plot.control_polygon(CURVES["ring"]))
    assert len(ring) == 13 and np.array_equal(ring[0], ring[-1])
    with pytest.raises(sc.InvalidShape, match="to_bezier"):
        plot.control_polygon(CURVES["power"])
    handles = points_of(plot.control_polygon(sc.HermiteCurve([(0, 0), (3, 0)], [(3, 3), (3, 3)])))
    assert handles.tolist() == [[0, 0], [1, 1], [2, -1], [3, 0]]


def test_teeth_of_a_comb_are_as_long_as_the_curvature():
    helix = sc.BezierCurve([(0, 0, 0), (1, 2, 1), (3, 1, 0), (4, 3, 2)])
    axes = plot.comb(helix, scale=0.5, count=10)
    rows = np.array(axes.lines[0].get_data_3d()).T
    feet, tips = rows[:33:3], rows[1:33:3]
    u = np.linspace(0, 1, 11)
    assert np.allclose(feet, helix.evaluate(u)) and np.allclose(np.linalg.norm(tips - feet, axis=1), 0.5 * helix.curvature(u))
    normal = helix.frenet_frame(u)[:, 1]
    assert (np.einsum("ij,ij->i", tips - feet, normal) < 0).all()
    straight = plot.comb(CURVES["line"], count=4)
    assert np.ptp(points_of(straight)[:, 0] - points_of(straight)[:, 1]) == 0
    with pytest.raises(sc.InvalidShape, match="count is 0"):
        plot.comb(helix, count=0)


def test_basis_functions_sum_to_one_and_jump_where_they_do():
    axes = plot.basis_functions(sc.basis.KnotVector(2, [0, 0, 0, 1, 1, 1, 2, 2, 2]))
    draw(axes)
    functions = [np.array(line.get_data()) for line in axes.lines[:-1]]
    assert len(functions) == 6 and np.allclose(sum(values for _, values in functions), 1)
    assert np.array_equal(axes.lines[-1].get_xdata(), [0, 1, 2])
    draw(plot.basis_functions(CURVES["ring"].knot_vector, color="black"))
    with pytest.raises(sc.InvalidShape, match="flat"):
        plot.basis_functions(CURVES["ring"].knot_vector, plot.curve(CURVES["ring"]))


def test_isocurves_lie_on_the_surface():
    ball = build.sphere((0, 0, 0), 1.0)
    points = points_of(plot.isocurves(ball, count=3))
    assert np.allclose(np.linalg.norm(points, axis=1), 1, atol=1e-3) and len(points) > 200
    with pytest.raises(sc.InvalidShape, match="count is 0"):
        plot.isocurves(ball, count=0)


def test_nets_have_all_rows_and_columns():
    axes = plot.control_net(sc.BezierPatch(np.random.default_rng(1).uniform(0, 1, (3, 4, 3))))
    assert len(points_of(axes)) == 2 * 12


def test_the_library_does_without_matplotlib_and_says_what_to_install():
    code = """if True:
        import sys
        import splinecore as sc
        assert "matplotlib" not in sys.modules
        sys.modules["matplotlib"] = None
        try:
            sc.plot.curve(sc.BezierCurve([(0, 0), (1, 1)]))
        except ImportError as error:
            print(error)
    """
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env={"PYTHONPATH": ":".join(sys.path)})
    assert done.stdout == "splinecore.plot needs matplotlib: pip install splinecore[plot]\n", done.stderr
