"""How far surfaces are from what they should be, by dense samples of the control points that the programs kept."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

import workloads
from exact import functions

ALONG = 129
DENSE = 201
STEPS = 20_000


@dataclass
class Deviation:
    largest: float
    angle: float | None = None
    words: str = ""


def slopes(knots, u, degree=3):
    """First derivatives of the functions."""
    spans = knots[degree:] - knots[:-degree]
    quotients = functions(knots, u, degree - 1) / np.where(spans > 0, spans, np.inf)
    return degree * (quotients[:, :-1] - quotients[:, 1:])


def projected(rows, *derivatives):
    """Points of homogeneous rows, and of their derivatives those of the points."""
    weights = rows[..., 3:]
    points = rows[..., :3] / weights
    return points, *((row[..., :3] - row[..., 3:] * points) / weights for row in derivatives)


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


@dataclass
class Surface:
    degrees: tuple
    knots: tuple
    points: np.ndarray  # homogeneous

    @staticmethod
    def of_rows(degrees, knots, rows):
        return Surface(degrees, knots, np.concatenate([rows[..., :3] * rows[..., 3:], rows[..., 3:]], -1))

    def line(self, axis, count):
        knots, degree = self.knots[axis], self.degrees[axis]
        return np.linspace(knots[degree], knots[-degree - 1], count)

    def functions(self, axis, u, of=functions):
        return of(self.knots[axis], u, self.degrees[axis])

    def grid(self, u, v):
        return projected(np.einsum("ai,bj,ijk->abk", self.functions(0, u), self.functions(1, v), self.points, optimize=True))[0]

    def jets(self, u, v):
        """Points and derivatives along u and v at pairs."""
        def total(of_u, of_v):
            return np.einsum("aj,ajk->ak", self.functions(1, v, of_v), np.tensordot(self.functions(0, u, of_u), self.points, 1))

        return projected(total(functions, functions), total(slopes, functions), total(functions, slopes))


def read(numbers):
    """Surfaces as programs keep them: degrees, counts, knots along u and along v, rows x, y, z, w."""
    found = []
    while len(numbers):
        degree_u, degree_v, count_u, count_v = (int(n) for n in numbers[:4])
        sizes = [4, count_u + degree_u + 1, count_v + degree_v + 1, 4 * count_u * count_v]
        _, knots_u, knots_v, rows, numbers = np.split(numbers, np.cumsum(sizes))
        found.append(Surface.of_rows((degree_u, degree_v), (knots_u, knots_v), rows.reshape(count_u, count_v, 4)))
    return found


def step_within(surface, at, along, rest):
    """A step of Gauss and Newton from parameters, (2, count), that stays in the domain."""
    gram = np.einsum("iak,jak->ija", along, along)
    right = np.einsum("iak,ak->ia", along, rest)
    own, mixed = np.stack([gram[0, 0], gram[1, 1]]), gram[0, 1]
    free = (own[::-1] * right - mixed * right[::-1]) / (own[0] * own[1] - mixed**2)
    low, high = np.stack([surface.line(axis, 2) for axis in (0, 1)], 1)[..., None]
    steps = np.clip(at + free, low, high) - at
    beside_held = (right - mixed * steps[::-1]) / own
    steps = np.where((at + free != np.clip(at + free, low, high))[::-1], beside_held, steps)
    return np.clip(at + steps, low, high)


def nearest_on(surface, places):
    """Distances and unit normals at the nearest points."""
    lines = [surface.line(axis, ALONG) for axis in (0, 1)]
    _, index = cKDTree(surface.grid(*lines).reshape(-1, 3)).query(places)
    at = np.stack([lines[0][index // ALONG], lines[1][index % ALONG]])
    for _ in range(15):
        points, *along = surface.jets(*at)
        at = step_within(surface, at, np.stack(along), places - points)
    points, along_u, along_v = surface.jets(*at)
    return np.linalg.norm(places - points, axis=1), unit(np.cross(along_u, along_v))


def nearest(surfaces, places):
    found = [nearest_on(surface, places) for surface in surfaces]
    best = np.argmin([distances for distances, _ in found], axis=0)
    every = np.arange(len(places))
    return tuple(np.stack([pair[k] for pair in found])[best, every] for k in (0, 1))


def curve(data, name, u):
    return functions(data[f"{name}.knots"], u) @ data[f"{name}.points"]


def largest(differences):
    return float(np.linalg.norm(differences, axis=-1).max())


def of_loft(surfaces, data):
    """From the sections; and from the spline through them with averages of parameters as knots."""
    surface, = surfaces
    parameters, u = data["loft.parameters"], np.linspace(0, 1, ALONG)
    rows = np.einsum("ai,kij->kaj", functions(data["loft.knots"], u), data["loft.sections"])
    distances, _ = nearest(surfaces, rows.reshape(-1, 3))
    v = np.linspace(0, 1, DENSE)
    controls = np.linalg.solve(functions(data["loft.knots_v"], parameters), rows.reshape(len(parameters), -1))
    wanted = (functions(data["loft.knots_v"], v) @ controls).reshape(DENSE, ALONG, 3)
    apart = largest(surface.grid(surface.line(0, ALONG), surface.line(1, DENSE)).swapaxes(0, 1) - wanted)
    return Deviation(float(distances.max()), words=f"{apart:.1e} from the cubic spline through the sections at equal parameters")


def rail_frames(data):
    """Points, x, y and tangents at every hundredth of so many steps: frames by double reflection (Wang et al. 2008)."""
    v = np.linspace(0, 1, STEPS + 1)
    points = curve(data, "rail", v)
    tangents = unit(slopes(data["rail.knots"], v) @ data["rail.points"])
    x = np.empty_like(points)
    x[0] = data["rail.start"]
    for i in range(STEPS):
        way = points[i + 1] - points[i]
        square = way @ way
        turned = x[i] - 2 / square * (way @ x[i]) * way
        tangent = tangents[i] - 2 / square * (way @ tangents[i]) * way
        rest = tangents[i + 1] - tangent
        x[i + 1] = turned - 2 / (rest @ rest) * (rest @ turned) * rest if rest @ rest > 0 else turned
    every = slice(None, None, STEPS // (DENSE - 1))
    return points[every], x[every], np.cross(tangents, x)[every], tangents[every]


def of_sweep(surfaces, data):
    """From the section in frames that turn no more than they must, at equal parameters."""
    surface, = surfaces
    points, *axes = rail_frames(data)
    section = curve(data, "gutter", np.linspace(0, 1, ALONG))
    wanted = points + np.einsum("ac,cbk->abk", section, np.stack(axes))
    return Deviation(largest(surface.grid(surface.line(0, ALONG), surface.line(1, DENSE)) - wanted))


def of_pipe(surfaces, data):
    """Of the distance from the rail from the radius."""
    places = np.concatenate([s.grid(s.line(0, ALONG), s.line(1, DENSE)).reshape(-1, 3) for s in surfaces])
    knots, rows = data["rail.knots"], data["rail.points"]
    dense = np.linspace(0, 1, STEPS + 1)
    _, index = cKDTree(curve(data, "rail", dense)).query(places)
    v = dense[index]
    for _ in range(5):
        along = slopes(knots, v) @ rows
        v = np.clip(v + ((places - functions(knots, v) @ rows) * along).sum(1) / (along * along).sum(1), 0, 1)
    distances = np.linalg.norm(places - functions(knots, v) @ rows, axis=1)
    return Deviation(float(np.abs(distances - workloads.PIPE_RADIUS).max()))


def of_coons(surfaces, data):
    """From the borders; and from the bilinearly blended patch."""
    t = np.linspace(0, 1, ALONG)
    low, right, high, left = (curve(data, f"coons{k}", t) for k in range(4))
    distances, _ = nearest(surfaces, np.concatenate([low, right, high, left]))
    high, left = high[::-1], left[::-1]
    u, v = t[:, None, None], t[None, :, None]
    ruled = (1 - v) * low[:, None] + v * high[:, None] + (1 - u) * left + u * right
    wanted = ruled - ((1 - u) * ((1 - v) * low[0] + v * high[0]) + u * ((1 - v) * low[-1] + v * high[-1]))
    grid = surfaces[0].grid(surfaces[0].line(0, ALONG), surfaces[0].line(1, ALONG))
    turned = [g[::a, ::b] for g in (grid, grid.swapaxes(0, 1)) for a in (1, -1) for b in (1, -1)]
    apart = min(largest(g - wanted) for g in turned)
    return Deviation(float(distances.max()), words=f"{apart:.1e} from the bilinearly blended patch")


def inside(corners, points):
    """Whether places near the sphere are seen from its south pole in a convex polygon."""
    x, y, z = unit(points).T
    images = np.stack([x, y], 1) / (1 + z)[:, None]
    sides = np.roll(corners, -1, 0) - corners
    ways = images[:, None] - corners
    return (sides[:, 0] * ways[..., 1] - sides[:, 1] * ways[..., 0] > 0).all(1)


def at_equal_parameters(surface, sides):
    """The largest distance of a border from the side of the hole that it is, both run through at their own pace."""
    u, v = (surface.line(axis, ALONG) for axis in (0, 1))
    borders = [surface.jets(u, 0 * u + v[end])[0] for end in (0, -1)] + [surface.jets(0 * v + u[end], v)[0] for end in (0, -1)]
    runs = [run for side in sides for run in (side, side[::-1])]
    return max(min(largest(border - run) for run in runs) for border in borders)


def of_filling(surfaces, data, name):
    """From the sides of neighbors and their tangent planes; and from the sphere in which the hole is."""
    nets = data[f"{name}.neighbors"]
    bezier = np.repeat([0.0, 1.0], 3)
    t = np.linspace(0, 1, ALONG)
    sides = [Surface.of_rows((2, 2), (bezier, bezier), net).jets(t, 0 * t)[0] for net in nets]
    places = np.concatenate(sides)
    distances, normals = nearest(surfaces, places)
    sines = np.linalg.norm(np.cross(normals, unit(places)), axis=1)
    corners = nets[:, 0, 0, :2] / (1 + nets[:, 0, 0, 2:3])
    grids = np.concatenate([s.grid(s.line(0, DENSE), s.line(1, DENSE)).reshape(-1, 3) for s in surfaces])
    radii = np.linalg.norm(grids[inside(corners, grids)], axis=1)
    note = f"{np.abs(radii - 1).max():.1e} from the sphere"
    if len(surfaces) == 1 and len(sides) == 4:
        note += f", {at_equal_parameters(surfaces[0], sides):.1e} from the sides at equal parameters"
    return Deviation(float(distances.max()), float(np.arcsin(np.minimum(sines, 1)).max()), note)


def of_offset(surfaces, data):
    """From the points at the distance along normals, at equal parameters."""
    surface, = surfaces
    knots, net = data["waves.knots"], data["waves_a"]
    waves = Surface((3, 3), (knots, knots), np.concatenate([net, np.ones((*net.shape[:2], 1))], -1))
    u, v = (t.ravel() for t in np.meshgrid(*[np.linspace(0, 1, DENSE)] * 2, indexing="ij"))
    points, along_u, along_v = waves.jets(u, v)
    wanted = points + workloads.OFFSET * unit(np.cross(along_u, along_v))
    return Deviation(largest(surface.grid(surface.line(0, DENSE), surface.line(1, DENSE)).reshape(-1, 3) - wanted))


MEASURES = {
    "W12 loft": of_loft,
    "W12 sweep": of_sweep,
    "W12 pipe": of_pipe,
    "W12 coons": of_coons,
    "W12 fill 4": lambda surfaces, data: of_filling(surfaces, data, "fill 4"),
    "W12 fill 5": lambda surfaces, data: of_filling(surfaces, data, "fill 5"),
    "W12 offset": of_offset,
}


def measured(kept, wanted):
    """{workload: {"who, call": Deviation}} of the surfaces in a folder."""
    data, found = workloads.inputs(), {}
    for workload in wanted:
        for path in sorted(kept.glob(f"{workload}.*.f64")) if workload in MEASURES else []:
            who, call = path.stem[len(workload) + 1:].split(".", 1)
            found.setdefault(workload, {})[f"{who}, {call}"] = MEASURES[workload](read(np.fromfile(path)), data)
    return found
