"""Times scipy and matplotlib where they are the rivals: scipy_splines.py DATA KEPT WORKLOAD, as the others do."""

import io
import sys

from scipy.interpolate import make_lsq_spline

from timing import Run


def least_squares(run):
    knots, parameters, points = run.input("lsq.knots"), run.input("lsq.parameters"), run.input("coil100000", -1, 3)
    run.time("make_lsq_spline", len(points), lambda: make_lsq_spline(parameters, points, knots, 3))
    run.keep("make_lsq_spline", make_lsq_spline(parameters, points, knots, 3).c, 1)


def picture(run):
    """The control net of the surface as SVG, rows and columns as lines in space."""
    from matplotlib.figure import Figure
    net = run.input("surface.points", 32, 32, 4)[..., :3]

    def drawn():
        axes = Figure(figsize=(3, 3)).add_subplot(projection="3d")
        for line in [*net, *net.swapaxes(0, 1)]:
            axes.plot(*line.T, linewidth=0.5)
        axes.set_axis_off()
        text = io.StringIO()
        axes.figure.savefig(text, format="svg")
        return text.getvalue()

    run.time("savefig of the net", 1, drawn, f"{len(drawn()):,} bytes")


RUNS = {"W7 least squares": ("scipy", least_squares), "picture": ("matplotlib", picture)}

if __name__ == "__main__" and sys.argv[3] in RUNS:
    who, work = RUNS[sys.argv[3]]
    work(Run(who, *sys.argv[1:]))
