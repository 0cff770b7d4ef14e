"""Boolean operations on plane regions: closed forms, laws of sets, membership of random points, and grids of whole numbers."""

import math
import pickle

import numpy as np
import pytest

import shapes
import splinecore as sc

OPERATIONS = {
    "union": (lambda a, b: a | b, np.logical_or), "intersection": (lambda a, b: a & b, np.logical_and),
    "difference": (lambda a, b: a - b, lambda a, b: a & ~b), "symmetric_difference": (lambda a, b: a ^ b, np.logical_xor),
}


def polygon(*points):
    points = np.array([*points, points[0]], dtype=float)
    return sc.NurbsCurve(1, np.r_[0, np.arange(len(points)), len(points) - 1], points)


def rectangle(x, y, width, height):
    return polygon((x, y), (x + width, y), (x + width, y + height), (x, y + height))


def circle(x, y, radius):
    return sc.conics.circle((x, y, 0), radius)


def region(*curves, **options):
    return sc.Region.of(curves, **options)


def blob(rng, degree=None, rational=None, center=(0, 0), size=1.0):
    """A closed curve about a center, smooth or with corners, that does not cross itself."""
    degree = degree or int(rng.integers(1, 10))
    count = int(rng.integers(max(degree + 1, 3), degree + 8))
    angles = 2 * math.pi * (np.arange(count) + rng.uniform(-0.2, 0.2, count)) / count
    radii = size * rng.uniform(0.6, 1.4, count)
    points = np.c_[radii * np.cos(angles), radii * np.sin(angles)] + center
    weights = rng.uniform(0.5, 2, count) if (rng.random() < 0.5 if rational is None else rational) else None
    return sc.NurbsCurve(degree, np.arange(count + 1.0), points, weights, periodic=True)


def is_closed_to_the_bit(curve):
    start, end = curve.evaluate(curve.domain)
    return curve.periodic or (start == end).all()


def check(a, b, rng, size=1.0, count=100):
    """All four operations on a pair, by areas and by places."""
    found = {name: make(a, b) for name, (make, _) in OPERATIONS.items()}
    areas = {name: one.area() for name, one in found.items()}
    whole = a.area() + b.area()
    near = 1e-8 * (whole + size**2)
    assert abs(areas["union"] + areas["intersection"] - whole) <= near
    assert abs(areas["difference"] + areas["intersection"] - a.area()) <= near
    assert abs(areas["symmetric_difference"] - (areas["union"] - areas["intersection"])) <= near
    curves = [*a.outlines, *b.outlines]
    if not curves:
        return found
    boxes = np.array([curve.bounding_box() for curve in curves])
    points = rng.uniform(boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0), (count, 3))
    apart = np.min([curve.nearest(points).distances for curve in curves], axis=0) > 1e-7 * size
    points = points[apart]
    for name, (_, rule) in OPERATIONS.items():
        assert all(is_closed_to_the_bit(curve) for curve in found[name].outlines)
        assert (found[name].contains(points) == rule(a.contains(points), b.contains(points))).all(), name
    assert not (found["difference"] & b).area() > near
    return found


def lens(distance):
    """What two unit circles have in common."""
    return 2 * math.acos(distance / 2) - distance / 2 * math.sqrt(4 - distance**2)


@pytest.mark.parametrize("distance", [1e-3, 0.5, 1.0, 1.7, 1.999])
def test_two_circles_have_a_lens_in_common(distance):
    a, b = region(circle(0, 0, 1)), region(circle(distance, 0, 1))
    found = check(a, b, np.random.default_rng(1))
    assert found["intersection"].area() == pytest.approx(lens(distance), rel=1e-11, abs=1e-11)
    assert found["union"].area() == pytest.approx(2 * math.pi - lens(distance), rel=1e-12)
    assert [len(found[name].outlines) for name in OPERATIONS] == [1, 1, 1, 2]
    assert found["intersection"].centroid() == pytest.approx([distance / 2, 0, 0], abs=1e-11)


def test_outlines_that_meet_nothing_stay_as_they_are():
    outer, inner, far = circle(0, 0, 3), circle(0, 0, 1), circle(9, 0, 1)
    ring = region(outer, inner)
    assert ring.outlines[0] == outer and ring.outlines[1] == inner.reversed()
    assert set((ring | region(far)).outlines) == {outer, inner.reversed(), far}
    assert (ring & region(far)).outlines == () and not ring & region(far)
    assert (region(outer) - region(inner)) == ring
    assert (ring | region(inner)).area() == pytest.approx(9 * math.pi, rel=1e-14)
    assert len((ring | region(inner)).outlines) == 1


SQUARE = rectangle(0, 0, 2, 2)
HALF_DISK = sc.build.join_curves([circle(0, 0, 1).part(0, circle(0, 0, 1).parameter_at_length(math.pi)), sc.BezierCurve([(-1, 0), (1, 0)])], 1e-9)[0]
CONTACTS = {
    "the same": ([SQUARE], [SQUARE], 4, 4),
    "the same, the other way": ([SQUARE], [SQUARE.reversed()], 4, 4),
    "the same from another corner": ([SQUARE], [polygon((2, 2), (0, 2), (0, 0), (2, 0))], 4, 4),
    "a side in common": ([SQUARE], [rectangle(2, 0, 1, 2)], 6, 0),
    "a part of a side": ([SQUARE], [rectangle(2, 0.5, 1, 1)], 5, 0),
    "sides that overlap": ([SQUARE], [rectangle(2, 1, 1, 2)], 6, 0),
    "a corner": ([SQUARE], [rectangle(2, 2, 1, 1)], 5, 0),
    "a corner at a side": ([SQUARE], [polygon((2, 1), (3, 0), (3, 2))], 5, 0),
    "inside along a side": ([SQUARE], [rectangle(0.5, 0, 1, 1)], 4, 1),
    "inside along two sides": ([SQUARE], [rectangle(0, 0, 1, 1)], 4, 1),
    "inside at a corner of a side": ([SQUARE], [polygon((0, 1), (1, 0.5), (1, 1.5))], 4, 0.5),
    "across": ([SQUARE], [rectangle(-1, 0.5, 4, 1)], 6, 2),
    "across along a side": ([SQUARE], [rectangle(-1, 0, 4, 1)], 6, 2),
    "across corners": ([SQUARE], [polygon((-1, -1), (3, 3), (-1, 3))], 10, 2),
    "a hole filled": ([SQUARE, rectangle(0.5, 0.5, 1, 1)], [rectangle(0.5, 0.5, 1, 1)], 4, 0),
    "a hole and what is wider": ([SQUARE, rectangle(0.5, 0.5, 1, 1)], [rectangle(0.25, 0.25, 1.5, 1.5)], 4, 1.25),
    "a hole and half of it": ([SQUARE, rectangle(0.5, 0.5, 1, 1)], [rectangle(0.5, 0.5, 0.5, 1)], 3.5, 0),
    "circles that touch": ([circle(0, 0, 1)], [circle(2, 0, 1)], 2 * math.pi, 0),
    "circles that touch within": ([circle(0, 0, 1)], [circle(0.5, 0, 0.5)], math.pi, math.pi / 4),
    "one circle": ([circle(0, 0, 1)], [sc.conics.circle((0, 0, 0), 1.0, normal=(0, 0, -1))], math.pi, math.pi),
    "a circle in a square": ([SQUARE], [circle(1, 1, 1)], 4, math.pi),
    "a square in a circle": ([rectangle(-1, -1, 2, 2)], [circle(0, 0, math.sqrt(2))], 2 * math.pi, 4),
    "a half and the whole": ([circle(0, 0, 1)], [HALF_DISK], math.pi, math.pi / 2),
    "nothing": ([SQUARE], [], 4, 0),
    "nothing at all": ([], [], 0, 0),
}


@pytest.mark.parametrize("name", CONTACTS)
def test_what_touches_is_decided(name):
    a, b, both, common = CONTACTS[name]
    for first, second in ((a, b), (b, a)):
        found = check(region(*first), region(*second), np.random.default_rng(2))
        assert found["union"].area() == pytest.approx(both, abs=1e-9)
        assert found["intersection"].area() == pytest.approx(common, abs=1e-9)


def test_shared_borders_go_and_touching_ones_stay_apart():
    square = region(SQUARE)
    assert len((square | region(rectangle(2, 0, 1, 2))).outlines) == 1
    assert len((square | region(rectangle(2, 2, 1, 1))).outlines) == 2
    assert square | square == square & square == square
    assert square - square == square ^ square == sc.Region.of([])
    pinched = square - region(polygon((0, 1), (1, 0.5), (1, 1.5)))
    assert sorted(np.sign(one.signed_area()) for one in pinched.outlines) == [-1, 1]


def on_grid(rng, count=5, size=6):
    """Rectangles at whole numbers, and the cells inside an odd number of them."""
    cells = np.zeros((size, size), dtype=bool)
    curves = []
    for _ in range(count):
        (x, width), (y, height) = ((int(start), int(rng.integers(1, size - start + 1))) for start in rng.integers(0, size, 2))
        curves.append(rectangle(x, y, width, height))
        cells[x:x + width, y:y + height] ^= True
    return curves, cells


def test_rectangles_at_whole_numbers_against_cells(inputs):
    rng = np.random.default_rng(3)
    centers = np.stack(np.meshgrid(*2 * [np.arange(6) + 0.5], indexing="ij"), axis=-1)
    for _ in range(inputs(300)):
        (a, in_a), (b, in_b) = (on_grid(rng, int(rng.integers(1, 6))) for _ in range(2))
        a, b = region(*a), region(*b)
        assert (a.contains(centers) == in_a).all()
        for make, rule in OPERATIONS.values():
            found, cells = make(a, b), rule(in_a, in_b)
            assert found.area() == pytest.approx(cells.sum(), abs=1e-9)
            assert (found.contains(centers) == cells).all()


def test_random_pairs_of_any_degree(inputs):
    rng = np.random.default_rng(4)
    for _ in range(inputs(1000)):
        size = 10.0 ** rng.choice([-6, 0, 6])
        a, b = (region(blob(rng, center=size * rng.uniform(-1, 1, 2), size=size)) for _ in range(2))
        check(a, b, rng, size, 20)


def test_random_regions_with_holes_and_many_outlines(inputs):
    rng = np.random.default_rng(5)
    for _ in range(inputs(60)):
        a, b = (region(*(blob(rng, center=rng.uniform(-2, 2, 2), size=rng.uniform(0.3, 2)) for _ in range(rng.integers(2, 5)))) for _ in range(2))
        check(a, b, rng, 2.0, 40)


def test_what_is_turned_and_far_away_is_the_same(inputs):
    rng = np.random.default_rng(6)
    for _ in range(inputs(60)):
        turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        turn *= np.linalg.det(turn)
        matrix = np.eye(4)
        matrix[:3, :3] = turn
        matrix[:3, 3] = rng.uniform(-1, 1, 3) * rng.choice([1, 1e6])
        plain = [blob(rng, center=rng.uniform(-0.4, 0.4, 2)) for _ in range(2)]
        a, b = (region(curve.transformed(matrix), normal=turn[:, 2]) for curve in plain)
        found = a & b
        wanted = region(plain[0]) & region(plain[1])
        near = 1e-12 if abs(matrix[:3, 3]).max() < 2 else 1e-8
        assert found.area() == pytest.approx(wanted.area(), abs=near)
        assert found.centroid() == pytest.approx(matrix[:3, :3] @ wanted.centroid() + matrix[:3, 3], abs=10 * near)
        moments = turn @ wanted.second_moments() @ turn.T
        assert found.second_moments() == pytest.approx(moments, abs=10 * near)


def test_a_region_seen_from_behind_is_in_the_same_plane():
    a, b = region(circle(0, 0, 1)), region(circle(1, 0, 1), normal=(0, 0, -1))
    assert b.normal.tolist() == [0, 0, -1]
    assert (a & b).area() == pytest.approx(lens(1.0), rel=1e-12)
    assert (b - a).normal.tolist() == [0, 0, -1] and (b - a).area() == pytest.approx(math.pi - lens(1.0), rel=1e-12)


def test_rules_of_filling():
    eight = polygon((0, 0), (2, 2), (2, 0), (0, 2))
    assert region(eight).area() == pytest.approx(2)
    assert len(region(eight).outlines) == 2
    star = polygon(*((math.sin(k * 4 * math.pi / 5), math.cos(k * 4 * math.pi / 5)) for k in range(5)))
    inner = 5 / 2 * math.sin(2 * math.pi / 5) * (math.cos(2 * math.pi / 5) / math.cos(math.pi / 5)) ** 2
    assert region(star, rule="nonzero").area() - region(star).area() == pytest.approx(inner)
    twice = [circle(0, 0, 1), circle(0, 0, 1)]
    assert not region(*twice) and region(*twice, rule="nonzero").area() == pytest.approx(math.pi)
    assert not region(circle(0, 0, 1), circle(0, 0, 1).reversed(), rule="nonzero")
    slit = polygon((0, 0), (2, 0), (2, 1), (1, 1), (2, 1), (2, 2), (0, 2))
    assert region(slit).area() == pytest.approx(4)


def test_what_is_no_outline_is_refused():
    with pytest.raises(sc.InvalidShape, match=r"curves\[1\] is not closed: its ends are 1 apart"):
        region(SQUARE, sc.BezierCurve([(0, 0), (1, 1), (1, 0)]))
    with pytest.raises(sc.InvalidShape, match=r"curves\[0\] is not in the plane"):
        region(polygon((0, 0, 0), (1, 0, 0), (1, 1, 1)), normal=(0, 0, 1))
    with pytest.raises(sc.InvalidShape, match="plane"):
        region(polygon((0, 0, 0), (1, 0, 0), (1, 1, 1), (0, 1, 0)))
    with pytest.raises(sc.InvalidShape, match="line|nothing"):
        region(polygon((0, 0), (1, 0)))
    with pytest.raises(sc.InvalidShape, match="plane"):
        region(SQUARE) | region(polygon((0, 0, 1), (1, 0, 1), (1, 1, 1)))
    with pytest.raises(sc.InvalidShape, match="rule"):
        region(SQUARE, rule="odd")
    with pytest.raises(sc.InvalidShape, match="no area"):
        region().centroid()
    with pytest.raises(sc.InvalidShape, match="pieces"):
        region(sc.NurbsCurve(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 0), (1, 1), (0, 0)]))
    with pytest.raises(TypeError):
        region(SQUARE) | SQUARE


@pytest.mark.parametrize("far", [0.0, 1e6])
@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
def test_moments_in_closed_form(size, far):
    if far:
        far *= size
    width, height = 3 * size, 2 * size
    box = region(rectangle(far, -far, width, height))
    near = 1e-12 if not far else 1e-9
    assert box.area() == pytest.approx(width * height, rel=near)
    assert (box.centroid() - (far, -far, 0)) / size == pytest.approx(np.array([1.5, 1, 0]), abs=1e-9 if far else 1e-13)
    wanted = np.diag([width**3 * height, width * height**3, 0]) / 12
    assert box.second_moments() / size**4 == pytest.approx(wanted / size**4, rel=near, abs=near)
    corner = box.second_moments((far, -far, 0)) / size**4
    assert corner[0, 0] == pytest.approx(18, rel=max(near, 1e-9)) and corner[0, 1] == pytest.approx(9, rel=max(near, 1e-9))
    ellipse = sc.NurbsCurve(2, shapes.CIRCLE_KNOTS, size * (np.array(shapes.SQUARE) * (3, 2)) + (far, far), shapes.SQUARE_WEIGHTS)
    found = region(ellipse)
    assert found.second_moments() / size**4 == pytest.approx(math.pi / 4 * np.diag([27 * 2, 3 * 8, 0]), rel=near, abs=near)
    assert found.second_moments((far, far, size))[2, 2] / size**4 == pytest.approx(6 * math.pi, rel=near)


def test_moments_of_what_is_put_together_add_up(inputs):
    rng = np.random.default_rng(7)
    for _ in range(inputs(40)):
        a, b = (region(blob(rng, center=rng.uniform(-1, 1, 2))) for _ in range(2))
        origin = (0, 0, 0)
        both = (a | b).second_moments(origin)
        parts = a.second_moments(origin) + (b - a).second_moments(origin) if b - a else a.second_moments(origin)
        assert both == pytest.approx(parts, abs=1e-9)
        grid = np.stack(np.meshgrid(*2 * [(np.arange(60) + 0.5) / 12 - 2.5]), axis=-1).reshape(-1, 2)
        inside = grid[a.contains(grid)]
        assert a.centroid()[:2] == pytest.approx(inside.mean(axis=0), abs=0.05)
        assert a.second_moments(origin)[:2, :2] == pytest.approx(inside.T @ inside / 144, abs=0.2)


def check_offset(one, distance, rng, size=1.0, count=60, **options):
    """By places: how far they are from outlines, and on which side."""
    found = one.offset(distance, **options)
    assert all(is_closed_to_the_bit(curve) for curve in found.outlines)
    boxes = np.array([curve.bounding_box() for curve in one.outlines])
    points = rng.uniform(boxes[:, 0].min(axis=0) - abs(distance), boxes[:, 1].max(axis=0) + abs(distance), (count, 3)) * (1, 1, 0)
    far = np.min([curve.nearest(points).distances for curve in one.outlines], axis=0)
    sure = abs(far - abs(distance)) > 1e-5 * size
    wanted = one.contains(points) | (far <= distance) if distance > 0 else one.contains(points) & (far >= -distance)
    assert (found.contains(points) == wanted)[sure].all()
    return found


def test_offsets_in_closed_form():
    rng = np.random.default_rng(9)
    box = region(rectangle(0, 0, 3, 2))
    assert check_offset(box, 0.5, rng).area() == pytest.approx(6 + 5 + math.pi / 4, rel=1e-9)
    assert box.offset(0.5, corner="sharp").area() == pytest.approx(12, rel=1e-9)
    assert check_offset(box, -0.5, rng).area() == pytest.approx(2, rel=1e-9)
    assert not box.offset(-1.01) and box.offset(0.0) == box
    ring = region(circle(0, 0, 2), circle(0, 0, 1))
    assert check_offset(ring, 0.25, rng).area() == pytest.approx(math.pi * (2.25**2 - 0.75**2), rel=1e-9)
    assert check_offset(ring, -0.25, rng).area() == pytest.approx(math.pi * (1.75**2 - 1.25**2), rel=1e-9)
    closed = check_offset(ring, 1.5, rng)
    assert len(closed.outlines) == 1 and closed.area() == pytest.approx(math.pi * 3.5**2, rel=1e-9)
    assert not ring.offset(-0.51)


def test_offsets_merge_and_part():
    rng = np.random.default_rng(10)
    two = region(rectangle(0, 0, 2, 2), rectangle(3, 0, 2, 2))
    assert [len(check_offset(two, distance, rng).outlines) for distance in (0.4, 0.6)] == [2, 1]
    dumbbell = region(rectangle(0, 0, 2, 2)) | region(rectangle(2, 0.75, 2, 0.5)) | region(rectangle(4, 0, 2, 2))
    assert [len(check_offset(dumbbell, distance, rng).outlines) for distance in (-0.2, -0.3)] == [1, 2]
    horseshoe = region(circle(0, 0, 3), circle(0, 0, 2)) - region(rectangle(0, -0.25, 4, 0.5))
    assert [len(check_offset(horseshoe, distance, rng).outlines) for distance in (0.2, 0.3)] == [1, 2]
    island = region(circle(0, 0, 3), circle(0, 0, 2), circle(0, 0, 1))
    assert [len(check_offset(island, distance, rng).outlines) for distance in (0.4, -0.4, 0.6)] == [3, 3, 1]


def test_offsets_of_random_regions(inputs):
    rng = np.random.default_rng(11)
    for _ in range(inputs(40)):
        one = region(*(blob(rng, degree=int(rng.integers(1, 6)), center=rng.uniform(-1, 1, 2)) for _ in range(rng.integers(1, 3))))
        check_offset(one, rng.uniform(-0.3, 0.3), rng)


def test_regions_are_values():
    ring = region(circle(0, 0, 2), circle(0, 0, 1))
    again = pickle.loads(pickle.dumps(ring))
    assert again == ring and hash(again) == hash(ring) and again.area() == ring.area()
    assert ring != region(circle(0, 0, 2)) and repr(ring) == "Region(outlines=2)"


def glyph_curves(text):
    """Closed curves of the letters of a font, quadratic Bezier pieces and lines, as far as it is installed."""
    ttx = pytest.importorskip("fontTools.ttLib")
    pens = pytest.importorskip("fontTools.pens.recordingPen")
    try:
        font = ttx.TTFont("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")
    except OSError:
        pytest.skip("no font")
    glyphs, names = font.getGlyphSet(), font.getBestCmap()
    for letter in text:
        pen = pens.DecomposingRecordingPen(glyphs)
        glyphs[names[ord(letter)]].draw(pen)
        yield letter, list(outlines(pen.value))


def outlines(steps):
    """Curves of degree 2 from the steps of a pen."""
    pieces, start, here = [], None, None
    for step, points in steps:
        points = [np.array(point, dtype=float) for point in points]
        if step == "moveTo":
            start = here = points[0]
        elif step == "lineTo":
            pieces.append((here, (here + points[0]) / 2, points[0]))
            here = points[0]
        elif step == "qCurveTo":
            for k, off in enumerate(points[:-1]):
                to = points[-1] if k + 2 == len(points) else (off + points[k + 1]) / 2
                pieces.append((here, off, to))
                here = to
        else:
            if (here != start).any():
                pieces.append((here, (here + start) / 2, start))
            net = [pieces[0][0], *(point for piece in pieces for point in piece[1:])]
            yield sc.NurbsCurve(2, np.r_[0, np.repeat(np.arange(len(pieces) + 1), 2), len(pieces)], net)
            pieces = []


def test_letters_of_a_font():
    rng = np.random.default_rng(8)
    letters = {letter: region(*curves, rule="nonzero") for letter, curves in glyph_curves("B8@&Oige")}
    for letter, one in letters.items():
        assert one.area() == pytest.approx(abs(sum(curve.signed_area() for curve in dict(glyph_curves(letter))[letter])), rel=1e-9)
    for a, b in ("B8", "8@", "@&", "Oi", "ge", "BB"):
        check(letters[a], letters[b], rng, 1000.0, 50)
    check_offset(letters["B"], 40.0, rng, 1000.0)
    assert len(check_offset(letters["B"], 400.0, rng, 1000.0).outlines) == 1
    check_offset(letters["8"], -60.0, rng, 1000.0)
    holes = {letter: sum(curve.signed_area() < 0 for curve in one.outlines) for letter, one in letters.items()}
    assert {letter: holes[letter] for letter in "B8Oi"} == {"B": 2, "8": 2, "O": 1, "i": 0}
