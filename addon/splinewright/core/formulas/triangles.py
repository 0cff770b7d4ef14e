"""At a parameter, level by level: basis functions, de Boor's and de Casteljau's points (S9, S14, S15)."""

from ..base.library import sc
from . import exact, teaching, written


#: Most lines of a scheme, and columns of degrees.
MOST_LINES, MOST_COLUMNS = 63, 9


def scheme_lines(spline):
    """All functions, each of the two to its left that are one line away. Functions that are zero everywhere are written as 0."""
    if spline.kind == 'Hermite':
        return []
    spans = len(spline.knots) - 1
    if 2 * spans - 1 > MOST_LINES or spline.degree > MOST_COLUMNS:
        return [f"The triangle of functions is written up to {(MOST_LINES + 1) // 2} spans and degree {MOST_COLUMNS}: "
                f"these are {spans} of degree {spline.degree}"]
    columns = [[written.interval(*each, spline.allowed) for each in zip(spline.knots, spline.knots[1:])]]
    for degree in range(spline.degree + 1):
        ends = zip(spline.knots, spline.knots[degree + 1:])
        columns.append([f"N{i},{degree}" if start < end else "0" for i, (start, end) in enumerate(ends)])
    lines = [""] * (2 * spans - 1)
    for number, column in enumerate(columns):
        width = max(map(len, column)) + 2
        at = {2 * i + max(number - 1, 0): text for i, text in enumerate(column)}
        lines = [line + at.get(i, "").ljust(width) for i, line in enumerate(lines)]
    return ["Triangle of functions, each made of the two to its left, above and below it:", *("  " + line.rstrip() for line in lines)]


def basis_lines(spline, u, letter):
    """Which functions feed which, and with what coefficients."""
    if spline.kind == 'Hermite':
        return _hermite_lines(spline, u, letter)
    levels = exact.basis(spline.degree, spline.knots, u)
    at = written.number(u, spline.allowed)
    lines = [f"Basis functions of the span {spline.on(spline.segment_at(u))} at {letter} = {at}, by degree:"]
    for degree, level in enumerate(levels):
        texts = written.numbers([each.value for each in level])
        lines.append("  " + "   ".join(f"N{each.number},{degree} = {text}" for each, text in zip(level, texts)))
    if spline.degree > 0:
        lines.append(f"Each is of two below, N_i,p = ({letter} - u_i) / (u_i+p - u_i) N_i,p-1 + "
                     f"(u_i+p+1 - {letter}) / (u_i+p+1 - u_i+1) N_i+1,p-1, where 0/0 counts as 0:")
    return lines + [_fed(each, degree) for degree, level in enumerate(levels) if degree > 0 for each in level]


def _fed(function, degree):
    i, below = function.number, degree - 1
    left, right = written.numbers([function.left, function.right])
    return f"  N{i},{degree} = ({left}) N{i},{below} + ({right}) N{i + 1},{below}"


def _hermite_lines(spline, u, letter):
    """Lecture row S4."""
    segment = spline.segment_at(u)
    t = (u - segment.start) / segment.length
    values = [sum(exact.HERMITE[k][j] * t ** k for k in range(4)) for j in range(4)]
    names = ("P at the start", "R at the start", "P at the end", "R at the end")
    return [f"Hermite functions at {letter} = {written.number(u, spline.allowed)}, on {spline.on(segment)} at t = {written.number(t)}:",
            *(f"  of {name}: {written.number(value)}" for name, value in zip(names, values))]


def de_boor_lines(spline, rows, u, count, allowed):
    """De Boor's numbers; count: of the points of a periodic curve, by which theirs are counted."""
    if spline.kind != 'NURBS':
        return []
    levels = exact.de_boor(spline.degree, spline.knots, rows, u)
    return [f"de Boor's algorithm at u = {written.number(u, spline.allowed)}: {STEPS}:",
            *step_lines(levels, lambda number: f"P{number % count}", allowed, "  ")]


#: What step_lines() write.
STEPS = "points and weights by level, each (1 - a) times the one before it and a times its own, of the level above"


def step_lines(levels, name_of, allowed, indent):
    """Levels of exact.Step. name_of: (number of a control point) -> what it is called."""
    def one(step, level):
        name = name_of(step.number) if level == 0 else f"a = {written.number(step.ratio)}"
        return f"{name}  {written.point(step.row, allowed)}"
    return [f"{indent}{level}:  " + "   ".join(one(step, level) for step in steps) for level, steps in enumerate(levels)]


def casteljau_lines(spline, rows, u, allowed):
    """The rational algorithm as far as it goes, then the homogeneous one."""
    segment = spline.segment_at(u)
    t = (u - segment.start) / segment.length
    levels = exact.casteljau(exact.bezier_points(segment, rows), t)
    bezier = sc.BezierCurve.from_homogeneous([[float(each.value) for each in row] for row in levels[0]])
    found, broken = bezier.rational_casteljau_triangle(float(t))
    lines = [f"de Casteljau on the Bezier curve of the span {spline.on(segment)}, at t = {written.number(t)}, points and weights by level:"]
    for level, points in enumerate(levels[:len(found)]):
        lines.append(f"  {level}:  " + "   ".join(written.point(row, allowed) for row in points))
    if broken is not None:
        lines.append("  Here " + teaching.broken_text(broken) + "; the homogeneous algorithm continues:")
        for level, points in enumerate(levels):
            lines.append(f"  {level}:  " + "   ".join(_homogeneous(row, allowed) for row in points))
    return lines


def _homogeneous(row, allowed):
    return "[" + " ".join(written.numbers(row, [allowed] * len(row))) + "]"
