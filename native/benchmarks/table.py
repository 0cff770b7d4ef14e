"""The table: medians of all rounds, one row a workload, as Markdown and JSON."""

import json
import re
import statistics
from dataclasses import asdict, dataclass, field

from bounds import BOUNDS
from workloads import ANGLE, TOLERANCES, WORKLOADS

MARKS = {"W1 sorted": 35, "W1 random": 18, "W2": 20, "W3 points": 13, "W3 normals": 22, "W4": 12, "W5 degree 11": 39,
         "W5 degree 25": 84, "W6 refine": 2, "W6 elevate": 4, "W6 Beziers": 2,
         "W7 curve 1e3": 10, "W7 curve 1e4": 10, "W7 curve 1e5": 10, "W7 surface": 2,
         "W7 least squares": 12, "W8 curve": 60, "W8 patch": 60,
         "W9 curves": 1, "W9 surfaces": 1, "W10": 12, "W11": 2, **dict.fromkeys(TOLERANCES, 1),
         "W13 first": 20, "W13 all": 20, "picture": 10}
MARKS_BY_EARLIER = {"adaptive": 10}
FASTER_OF_BOTH = ("W6 refine", "W6 elevate", "W6 Beziers")
AGAINST_SCIPY = ("W7 least squares",)
AGAINST_MATPLOTLIB = ("picture",)
AGAINST_OCCT = ("W8 curve", "W8 patch", "W11", *TOLERANCES, "W13 first", "W13 all", "adaptive")
ACCURATE_LENGTH = 1e-9
ALL_CORES = "splinecore, all cores"


@dataclass
class Row:
    workload: str
    calls: dict = field(default_factory=dict)  # "who, call" -> ns an item
    notes: dict = field(default_factory=dict)
    errors: dict = field(default_factory=dict)
    angles: dict = field(default_factory=dict)  # from tangent planes
    bound_ns: float | None = None
    formula: str = ""
    ours: str | None = None
    rival: str | None = None
    ratio: float | None = None
    mark: float | None = None
    earlier_ratio: float | None = None


def rows_of(lines, errors, machine, earlier=None, deviations=None):
    """`lines` are what the programs said, in all rounds; errors is {workload: {"who, call": error}}, deviations those of surfaces."""
    rows = []
    for workload in WORKLOADS:
        times, row = {}, Row(workload, errors=errors.get(workload, {}), mark=MARKS.get(workload))
        for line in lines:
            if line["workload"] == workload:
                name = f"{line['who']}, {line['call']}"
                times.setdefault(name, []).append(line["seconds"] / line["items"] * 1e9)
                if line["note"]:
                    row.notes[name] = line["note"]
        row.calls = {name: statistics.median(values) for name, values in times.items()}
        for name, deviation in (deviations or {}).get(workload, {}).items():
            take_deviation(row, name, deviation)
        if workload in BOUNDS:
            row.bound_ns, row.formula = BOUNDS[workload].nanoseconds(machine), BOUNDS[workload].formula
        compare(row, earlier)
        rows.append(row)
    return rows


def take_deviation(row, name, deviation):
    row.errors[name] = deviation.largest
    words = [row.notes.get(name, ""), f"off by {deviation.largest:.1e}", deviation.words]
    if deviation.angle is not None:
        row.angles[name] = deviation.angle
        words.insert(2, f"{deviation.angle:.1e} rad from tangent planes")
    row.notes[name] = "; ".join(filter(None, words))


def fastest(row, names):
    return min(names, key=row.calls.get, default=None)


def is_ours(name):
    """Whether it is one thread, in float64."""
    return name.startswith("splinecore") and "float32" not in name and name != ALL_CORES


def best_of_ours(row):
    """The call with reused arrays, where there is one."""
    reused = [name for name in row.calls if name == "splinecore, out="]
    return fastest(row, reused or [name for name in row.calls
                                   if is_ours(name)])


def rival_of(row):
    rivals = [name for name in row.calls if not name.startswith("splinecore")]
    if row.workload in AGAINST_OCCT:
        rivals = [name for name in rivals if name.startswith("OCCT")]
    elif row.workload in AGAINST_SCIPY:
        rivals = [name for name in rivals if name.startswith("scipy")]
    elif row.workload in AGAINST_MATPLOTLIB:
        rivals = [name for name in rivals if name.startswith("matplotlib")]
    elif row.workload not in FASTER_OF_BOTH:
        rivals = [name for name in rivals if name.startswith("SISL")]
    if row.workload == "W11":
        rivals = [name for name in rivals if row.errors.get(name, 0) <= ACCURATE_LENGTH]
    if row.workload in TOLERANCES:
        rivals = [name for name in rivals if is_within(row, name)] or rivals
    return fastest(row, rivals)


def is_within(row, name):
    return row.errors.get(name, 0) <= TOLERANCES[row.workload] and row.angles.get(name, 0) <= ANGLE


def compare(row, earlier):
    row.ours, row.rival = best_of_ours(row), rival_of(row)
    if row.ours and row.rival:
        row.ratio = row.calls[row.rival] / row.calls[row.ours]
    if row.ours and earlier and row.workload in earlier:
        row.earlier_ratio = earlier[row.workload] / row.calls[row.ours]


def number(value, digits=3):
    if value is None:
        return "–"
    return f"{value:.{digits}g}" if value < 1000 else f"{value:,.0f}"


def cell(row, name):
    return number(row.calls.get(name)) if name else "–"


def rival_cell(row, who):
    name = fastest(row, [name for name in row.calls if name.startswith(who)])
    name = row.rival if row.rival and row.rival.startswith(who) else name
    return f"{cell(row, name)} ({name.split(', ', 1)[1]})" if name else "–"


def ratio_cell(row):
    if row.ratio is None:
        return "–"
    return f"{row.ratio:.1f}×" if row.ratio >= 1 else f"{row.ratio:.2f}×"


def mark_cell(row):
    by_earlier = MARKS_BY_EARLIER.get(row.workload)
    return f"{row.mark}×" if row.mark else f"{by_earlier}× earlier" if by_earlier else "–"


def share_cell(row):
    if not row.bound_ns or not row.ours:
        return "–"
    return f"{100 * row.bound_ns / row.calls[row.ours]:.0f} %"


def markdown(rows, machine):
    lines = [f"{machine['name']}; {machine['versions']}; one thread, medians of {machine['rounds']} rounds; "
             "nanoseconds of the processor an item, on all cores of the clock", "",
             "| workload | splinecore `out=` | fresh | float32 `out=` | all cores | SISL | OCCT | scipy | ratio | mark | error "
             "| rival's | bound | of the bound | × earlier |", "| --- |" + " ---: |" * 14]
    for row in rows:
        reached = row.ratio is not None and row.mark is not None and row.ratio >= row.mark
        ratio = ratio_cell(row)
        fresh = next((name for name in row.calls if is_ours(name) and "out=" not in name), None)
        lines.append("| " + " | ".join([
            row.workload, cell(row, "splinecore, out="), cell(row, fresh), cell(row, "splinecore, float32, out="),
            cell(row, ALL_CORES), rival_cell(row, "SISL"), rival_cell(row, "OCCT"), rival_cell(row, "scipy"),
            f"**{ratio}**" if reached else ratio,
            mark_cell(row), number(row.errors.get(row.ours), 2),
            number(row.errors.get(row.rival), 2), number(row.bound_ns), share_cell(row),
            f"{row.earlier_ratio:.1f}" if row.earlier_ratio else "–"]) + " |")
    lines += ["", f"Measured in the same run: {1 / machine['operation_ns']:.1f}e9 operations on four doubles, "
              f"{1 / machine['division_ns']:.2f}e9 divisions of four doubles, {1 / machine['byte_ns']:.0f} GB/s "
              "written. The bound is the largest of:", ""]
    lines += [f"- {row.workload}: {row.formula}" for row in rows if row.formula]
    lines += [f"- {row.workload}: {name}: {note}" for row in rows for name, note in row.notes.items()]
    return "\n".join(lines) + "\n"


WHAT = {
    "W1 sorted": "points of a rational cubic curve, parameters in order", "W1 random": "the same, in any order",
    "W2": "two derivatives", "W3 points": "a grid of a rational bicubic surface, 1000 × 1000",
    "W3 normals": "the same with unit normals", "W4": "point and first derivatives at scattered pairs",
    "W5 degree 11": "a Bezier curve of degree 11", "W5 degree 25": "of degree 25",
    "W6 refine": "1000 knots into a cubic of 1000 points, a knot", "W6 elevate": "its degree from 3 to 5, a point",
    "W6 Beziers": "its Bezier pieces, a piece", "W7 curve 1e3": "a cubic through 1000 points, chord length, a point",
    "W7 curve 1e4": "through 10,000", "W7 curve 1e5": "through 100,000",
    "W7 surface": "a bicubic through 300 × 300 points",
    "W7 least squares": "a cubic of 200 control points near 100,000, a point",
    "W8 curve": "the nearest point of a rational cubic curve, a query", "W8 patch": "of a rational bicubic surface",
    "W9 curves": "63 crossings of two cubics of 64 points", "W9 surfaces": "the curves of two bicubic waves within 1e-5",
    "W10": "32 patches of 64 × 64 points with normals",
    "W11": "length of a curve to 1e-9", "adaptive": "the teapot meshed to 1e-3", "picture": "a bicubic surface as the SVG of a notebook",
    "W12 loft": "a loft through 12 sections of 32 points", "W12 sweep": "a section of 8 points along a rail of 16 within 1e-4",
    "W12 pipe": "a pipe about it within 1e-4", "W12 coons": "a Coons patch of four borders",
    "W12 fill 4": "a hole of four sides in a sphere filled, G1 within 1e-4 and 1e-2 rad", "W12 fill 5": "of five sides",
    "W12 offset": "the offset of a bicubic wave within 1e-5",
    "W13 first": "the first hit on a lens of two bicubic patches of 12 × 12 points, a ray", "W13 all": "all hits, a ray",
}


def brief(rows, machine):
    """The tables of docs/benchmarks.md."""
    where = f"{machine['name']}, {machine['versions']}, one thread; nanoseconds an item"
    of_surfaces = [row for row in rows if row.workload in TOLERANCES]
    others = [row for row in rows if row.workload not in TOLERANCES]
    tables = [brief_others(others, where)] * bool(others) + [brief_surfaces(of_surfaces, where)] * bool(of_surfaces)
    return "\n\n".join("\n".join(lines) for lines in tables) + "\n"


def brief_others(rows, where):
    lines = [f"{where}:", "", "| | splinecore | rival | ratio | error | of the bound | all cores |",
             "| --- | ---: | ---: | ---: | ---: | ---: | ---: |"]
    for row in rows:
        lines.append(f"| {WHAT[row.workload]} | {cell(row, row.ours)} | {brief_rival(row)} | {ratio_cell(row)} "
                     f"| {number(row.errors.get(row.ours), 2)} | {share_cell(row)} | {cell(row, ALL_CORES)} |")
    return lines


def brief_surfaces(rows, where):
    """Each with its control points and how far it is off, and the same of the rival's."""
    lines = [f"Surfaces; {where}:", "",
             "| | splinecore | control points | off by | rival | control points | off by | ratio |",
             "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"]
    for row in rows:
        lines.append(f"| {WHAT[row.workload]} | {cell(row, row.ours)} | {surface_cells(row, row.ours)} | {brief_rival(row)} "
                     f"| {surface_cells(row, row.rival)} | {ratio_cell(row)} |")
    return lines


def brief_rival(row):
    return f"{cell(row, row.rival)} ({row.rival.replace(',', '')})" if row.rival else "–"


def surface_cells(row, name):
    """How many control points a surface has, and how far it is off."""
    count = re.match(r"(\d+) control points", row.notes.get(name, ""))
    angle = f", {number(row.angles[name], 2)} rad" if name in row.angles else ""
    return f"{number(int(count[1]), 4) if count else '–'} | {number(row.errors.get(name), 2)}{angle}"


def as_json(rows, machine):
    return json.dumps({"machine": machine, "rows": [asdict(row) for row in rows]}, indent=1, ensure_ascii=False) + "\n"
