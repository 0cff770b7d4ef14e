"""Times scipy where it is the rival: scipy_splines.py DATA KEPT WORKLOAD, as the others do."""

import sys

from scipy.interpolate import make_lsq_spline

from timing import Run


def least_squares(run):
    knots, parameters, points = run.input("lsq.knots"), run.input("lsq.parameters"), run.input("coil100000", -1, 3)
    run.time("make_lsq_spline", len(points), lambda: make_lsq_spline(parameters, points, knots, 3))
    run.keep("make_lsq_spline", make_lsq_spline(parameters, points, knots, 3).c, 1)


RUNS = {"W7 least squares": least_squares}

if __name__ == "__main__" and sys.argv[3] in RUNS:
    RUNS[sys.argv[3]](Run("scipy", *sys.argv[1:]))
