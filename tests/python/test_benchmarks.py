"""What `./run bench` measures, and how it judges, without measuring."""

import json
import re
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import splinecore as sc

BENCHMARKS = Path(__file__).resolve().parents[2] / "native/benchmarks"
sys.path.insert(0, str(BENCHMARKS))

import bounds  # noqa: E402
import deviations  # noqa: E402
import exact  # noqa: E402
import ours  # noqa: E402
import ours_surfaces  # noqa: E402
import table  # noqa: E402
import workloads  # noqa: E402

MACHINE = {"name": "a machine", "versions": "-", "rounds": 3, "operation_ns": 0.1, "division_ns": 2, "byte_ns": 0.02}


def line(workload, who, call, ns, items=1000, note=""):
    return {"workload": workload, "who": who, "call": call, "seconds": ns * items * 1e-9, "items": items, "note": note}


def row_of(lines, errors=None, earlier=None):
    rows = table.rows_of(lines, errors or {}, MACHINE, earlier)
    return next(row for row in rows if row.workload == lines[0]["workload"])


def test_splitmix64_gives_its_published_numbers():
    first = np.array([0xE220A8397B1DCDAF, 0x6E789E6AA1B965F4, 0x06C45D188009454F], dtype=np.uint64)
    assert np.array_equal(workloads.random(0, 3), (first >> np.uint64(11)) * 2.0**-53)


@pytest.mark.parametrize("workload", workloads.WORKLOADS)
def test_every_workload_has_what_it_needs(workload):
    assert workload in ours.RUNS
    assert workload in table.WHAT
    if workload in workloads.TOLERANCES:
        assert workload in table.MARKS and workload in deviations.MEASURES
    elif workload not in ("adaptive", "picture"):
        assert workload in table.MARKS and workload in bounds.BOUNDS and workload in exact.references()
    rivals = "".join((BENCHMARKS / name).read_text() for name in ("sisl.cpp", "occt.cpp", "scipy_splines.py"))
    assert f'{{"{workload}", ' in rivals or f'"{workload}": ' in rivals


def test_the_step_between_samples_is_the_same_in_both_languages():
    assert f"kSampleStep = {workloads.SAMPLE_STEP};" in (BENCHMARKS / "driver.hpp").read_text()


def test_exact_rows_of_a_circle():
    half = np.sqrt(0.5)
    knots, points = np.repeat([0.0, 1.0], 3), np.array([[1, 0, 0, 1], [1, 1, 0, half], [0, 1, 0, 1]])
    u = np.array([0.0, 0.25, 0.5, 1.0])
    rows = exact.curve_rows(knots, points, u, 2, degree=2)
    curve = sc.NurbsCurve(2, knots, points[:, :3], points[:, 3])
    assert exact.error(curve.derivatives(u, 2).reshape(-1, 9), rows) < 4e-16
    assert exact.error(curve.derivatives(u, 2).reshape(-1, 9) + 1e-9, rows) > 9e-10


def test_exact_rows_of_the_sheet():
    data = workloads.inputs()
    knots, net = (data["surface.knots_u"], data["surface.knots_v"]), data["surface.points"]
    pairs = data["pairs"][:7]
    patch = sc.NurbsPatch((3, 3), knots, net[..., :3], net[..., 3])
    rows = exact.surface_rows(*knots, net, pairs)
    made = patch.derivatives(*pairs.T.copy(), 1)
    assert exact.error(np.stack([made[:, 0, 0], made[:, 1, 0], made[:, 0, 1]], 1).reshape(7, 9), rows) < 1e-14
    normals = exact.with_normals(rows)[:, 3:]
    assert np.allclose([float(sum(normal * normal)) for normal in normals], 1, rtol=1e-15)


def test_exact_control_points_are_those_of_the_verbs():
    knots, points = workloads.uneven_knots(12, 20), workloads.helix(20, 13)[:, :3]
    curve, inserted = sc.NurbsCurve(3, knots, points), workloads.random(15, 9)
    finer = exact.new_points(knots, points, exact.refined_knots(knots, inserted), 3, 1)
    assert exact.error(curve.refine(inserted).points, finer) < 1e-15
    higher = exact.new_points(knots, points, exact.repeated(knots, lambda n: n + 2), 5, 1)
    assert exact.error(curve.elevate(2).points, higher) < 2e-15
    pieces = exact.new_points(knots, points, exact.repeated(knots, lambda n: 0 * n + 4), 3, 1)
    assert exact.error(np.concatenate([piece.points for piece in curve.to_bezier()]), pieces) < 1e-15


def test_the_length_is_that_of_a_circle():
    half = np.sqrt(0.5)
    points = np.array([[1, 0, 0, 1], [1, 1, 0, half], [0, 1, 0, 1]])
    cubic = sc.NurbsCurve(2, np.repeat([0.0, 1.0], 3), points[:, :3], points[:, 3]).elevate()
    length = exact.arc_length(cubic.knots, np.column_stack([cubic.points, cubic.weights]))
    assert abs(float(length) - np.pi / 2) < 4e-16


def test_a_root_has_more_digits_than_a_double():
    assert abs(exact.root(Fraction(2)) ** 2 - 2) < Fraction(1, 1 << 70)
    assert abs(exact.root(Fraction(1, 10**40)) * 10**20 - 1) < Fraction(1, 1 << 70)


def test_the_ratio_is_of_medians_and_of_the_rival_named():
    lines = [line("W1 sorted", "splinecore", "out=", ns) for ns in (1, 2, 9)]
    lines += [line("W1 sorted", "splinecore", "fresh", 1), line("W1 sorted", "SISL", "s1542", 80),
              line("W1 sorted", "OCCT", "D0, cache", 3)]
    row = row_of(lines, earlier={"W1 sorted": 12.0})
    assert (row.ours, row.rival) == ("splinecore, out=", "SISL, s1542")
    assert row.ratio == pytest.approx(40) and row.mark == 35 and row.earlier_ratio == pytest.approx(6)
    assert "**40.0×** | 35×" in table.markdown([row], MACHINE)
    assert "| 2 | 80 (SISL s1542) | 40.0× |" in table.brief([row], MACHINE)


def test_without_reused_arrays_the_fresh_ones_count_and_float32_never():
    row = row_of([line("W3 points", "splinecore", "float32, fresh", 1), line("W3 points", "splinecore", "fresh", 4),
                  line("W3 points", "SISL", "s1506", 8)])
    assert row.ours == "splinecore, fresh" and row.ratio == pytest.approx(2)
    assert "| 2.0× | 13×" in table.markdown([row], MACHINE)


def test_verbs_are_measured_by_the_faster_rival():
    lines = [line("W6 refine", "splinecore", "refine", 10), line("W6 refine", "SISL", "s1018", 40),
             line("W6 refine", "OCCT", "InsertKnots", 30)]
    assert row_of(lines).rival == "OCCT, InsertKnots"


def test_a_length_that_is_wrong_is_no_rival():
    lines = [line("W11", "splinecore", "length", 10), line("W11", "OCCT", "Length", 30),
             line("W11", "OCCT", "Length to 1e-9", 90)]
    errors = {"W11": {"OCCT, Length": 1e-6, "OCCT, Length to 1e-9": 1e-10}}
    assert row_of(lines, errors).rival == "OCCT, Length to 1e-9"


def test_a_surface_that_is_off_is_no_rival():
    lines = [line("W12 sweep", "splinecore", "sweep", 10, note="96 control points, degrees 3 and 3"),
             line("W12 sweep", "OCCT", "near", 90, note="1200 control points"), line("W12 sweep", "OCCT", "off", 30)]
    found = {"splinecore, sweep": deviations.Deviation(5e-5), "OCCT, near": deviations.Deviation(9e-5, 0.004),
             "OCCT, off": deviations.Deviation(2e-4, words="a word")}
    row = next(row for row in table.rows_of(lines, {}, MACHINE, deviations={"W12 sweep": found}) if row.calls)
    assert row.rival == "OCCT, near" and row.ratio == pytest.approx(9)
    assert "| 10 | 96 | 5e-05 | 90 (OCCT near) | 1,200 | 9e-05, 0.004 rad | 9.0× |" in table.brief([row], MACHINE)
    assert "off by 2.0e-04; a word" in table.markdown([row], MACHINE)


def test_rows_without_a_bound_have_no_bars(tmp_path):
    import plot
    rows = [row_of([line("adaptive", "splinecore", "adaptive", 5), line("adaptive", "OCCT", "BRepMesh", 9)])]
    plot.draw(rows, MACHINE, tmp_path / "table.png")
    assert not list(tmp_path.iterdir())


class Kept:
    """Stands for a run: has the inputs, times nothing, keeps in memory."""

    def __init__(self):
        self.data = workloads.inputs()

    def input(self, name, *shape):
        return self.data[name].reshape(shape or (-1,))

    def time(self, call, items, work, note=""):
        assert "control points" in note

    def keep(self, call, rows, step):
        self.rows = np.asarray(rows, float)


@pytest.mark.parametrize("workload", workloads.TOLERANCES)
def test_our_surfaces_are_as_near_as_they_are_asked_to_be(workload):
    kept = Kept()
    ours_surfaces.RUNS[workload](kept)
    deviation = deviations.MEASURES[workload](deviations.read(kept.rows), kept.data)
    assert 0 <= deviation.largest <= workloads.TOLERANCES[workload]
    assert deviation.angle is None or deviation.angle <= workloads.ANGLE


def test_a_surface_that_was_moved_is_off_by_so_much():
    kept = Kept()
    ours_surfaces.RUNS["W12 coons"](kept)
    surface, = deviations.read(kept.rows)
    surface.points[..., 2] += 1e-3
    found = deviations.MEASURES["W12 coons"]([surface], kept.data)
    assert 1e-4 < found.largest <= 1e-3 + 1e-12 and found.words.startswith("1.0e-03 from the bilinear")


def test_jets_of_a_kept_surface_are_those_of_the_patch():
    kept = Kept()
    ours_surfaces.RUNS["W12 pipe"](kept)
    surface, = deviations.read(kept.rows)
    patch, = ours_surfaces.build.pipe(ours_surfaces.cubic(kept, "rail"), workloads.PIPE_RADIUS,
                                      tolerance=workloads.TOLERANCES["W12 pipe"]).value
    low, high = patch.domain[0]
    u, v = low + (high - low) * workloads.random(1, 20), workloads.random(2, 20)
    made = patch.first_derivatives(u, v)
    for k, rows in enumerate(surface.jets(u, v)):
        assert np.allclose(rows, made[:, k], rtol=1e-11, atol=1e-11)


def test_the_bound_is_the_slowest_of_three():
    assert bounds.Bound(10, 1, 10, "").nanoseconds(MACHINE) == 2
    assert bounds.Bound(30, 1, 10, "").nanoseconds(MACHINE) == pytest.approx(3)
    assert bounds.Bound(1, 0, 500, "").nanoseconds(MACHINE) == 10


def test_the_table_says_every_formula_and_is_json():
    row = row_of([line("W2", "splinecore", "fresh", 5), line("W2", "SISL", "s1221", 50, note="a note")])
    text = table.markdown([row], MACHINE)
    assert bounds.BOUNDS["W2"].formula in text and "a note" in text and "a machine" in text
    columns = {len(re.findall(r"(?<!\\)\|", line)) for line in text.splitlines() if line.startswith("|")}
    assert len(columns) == 1
    assert json.loads(table.as_json([row], MACHINE))["rows"][0]["ratio"] == pytest.approx(10)


def test_a_normal_that_is_none_is_not_asked_for():
    reference = exact.exactly(np.array([[1.0, 2, 3, 0, 0, 0], [1, 2, 3, 0, 0, 1]]))
    assert exact.error(np.array([[1.0, 2, 3, 1, 0, 0], [1, 2, 3, 0, 0, 1]]), reference) == 0
    assert exact.error(np.array([[1.0, 2, 3, 0, 0, 0], [1, 2, 3, 0, 0.5, 1]]), reference) == 0.5


def test_options_stand_before_and_after_workloads():
    program = [sys.executable, BENCHMARKS / "run.py", "no-build"]
    for words in (["--rounds", "0", "W2"], ["W2", "--rounds", "0"]):
        done = subprocess.run([*program, *words], capture_output=True, text=True)
        assert done.returncode == 2 and "one round at least" in done.stderr
    done = subprocess.run([*program, "W2", "W99"], capture_output=True, text=True)
    assert done.returncode == 2 and "no workload W99; there are W1 sorted, W1 random, W2," in done.stderr
