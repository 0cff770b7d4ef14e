"""The command line: splinecore info|convert|tessellate|compare; --help of each tells the rest.

Exit codes: 0 done, or the same; 1 the files differ; 2 a call or a file that is wrong; 130 interrupted.
"""

import argparse
import sys
from pathlib import Path

import numpy as np

from . import (
    BezierCurve,
    BezierPatch,
    Error,
    HermitePatch,
    NurbsPatch,
    PatchSet,
    PowerCurve,
    Region,
    __instruction_set__,
    __version__,
    bpt,
    dumps,
    loads,
    meshes,
    nearest,
)

PATCHES = (NurbsPatch, BezierPatch, HermitePatch)
SURFACES = (PatchSet, *PATCHES)
PLACES = {"files": "files to read: .json or .bpt", "input": "the file to read: .json or .bpt",
          "output": "the file to write; its ending decides the format", "a": "a .json or .bpt file", "b": "the file to compare it with"}
ENDINGS = {"convert": (".json", ".bpt"), "tessellate": (".obj", ".ply", ".stl", ".glb")}


class Refused(Exception):
    """A sentence for whoever called."""


class Progress:
    """How far, on one line of the error output; nothing where nobody watches, unless it is wanted."""

    def __init__(self, count, wanted):
        self._count, self._done = count, 0
        self._shown = wanted if wanted is not None else count > 1 and sys.stderr.isatty()

    def step(self):
        self._done += 1
        if self._shown:
            end = "\n" if self._done == self._count else ""
            print(f"\r{self._done} of {self._count}", end=end, file=sys.stderr, flush=True)


def read(path):
    """The values in a JSON or BPT file, by its ending."""
    try:
        text = Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise Refused(f"{path} cannot be read: {getattr(error, 'strerror', None) or 'it is not a text file'}") from None
    try:
        values = bpt.loads(text) if Path(path).suffix.lower() == ".bpt" else loads(text)
    except Error as error:
        raise Refused(f"{path}: {error}") from None
    return values if isinstance(values, list) else [values]


def write(path, data):
    """Written whole or not at all."""
    path = Path(path)
    part = path.with_name(path.name + ".part")
    try:
        part.write_bytes(data)
        part.replace(path)
    except OSError as error:
        part.unlink(missing_ok=True)
        raise Refused(f"{path} cannot be written: {error.strerror}") from None


def info(args):
    """Tell what files hold."""
    progress, code = Progress(len(args.files), args.progress), 0
    for path in args.files:
        try:
            values = read(path)
        except Refused as refused:
            print(f"splinecore: {refused}", file=sys.stderr)
            values, code = None, 2
        progress.step()
        if values is not None:
            print(f"{path}: {shapes(len(values))}")
            for i, value in enumerate(values):
                print(f"  {i}: {describe(value)}")
    return code


def shapes(count):
    """A number of shapes in words."""
    return f"{count} {'shape' if count == 1 else 'shapes'}"


def describe(value):
    """One line on a shape."""
    kind = type(value).__name__
    if isinstance(value, Region):
        count = len(value.outlines)
        return f"Region: {count} {'outline' if count == 1 else 'outlines'}; area {value.area():.9g}"
    if isinstance(value, PatchSet):
        facts = [f"{len(value)} patches, {len(value.points)} points"]
    elif isinstance(value, PATCHES):
        facts = [f"degree {value.degree[0]} x {value.degree[1]}, {value.points.shape[0]} x {value.points.shape[1]} points"]
    elif isinstance(value, PowerCurve):
        facts = [f"degree {value.degree}"]
    else:
        facts = [f"degree {value.degree}, {len(value.points)} points"]
    if getattr(value, "is_rational", False):
        facts.append("rational")
    if np.any(getattr(value, "periodic", False)):
        facts.append("periodic")
    try:
        low, high = value.bounding_box()
        facts.append(f"from ({', '.join(f'{x:.6g}' for x in low)}) to ({', '.join(f'{x:.6g}' for x in high)})")
        facts += extent_of_surface(value) if isinstance(value, SURFACES) else extent_of_curve(value)
    except Error as error:
        facts.append(str(error))
    return f"{kind}: {'; '.join(facts)}"


def extent_of_curve(curve):
    """The length, and whether the curve is closed."""
    return [f"length {curve.length():.9g}", "closed" if curve.is_closed else "open"]


def extent_of_surface(surface):
    """The area, whether the surface is closed, and the volume then."""
    patches = surface if isinstance(surface, PatchSet) else PatchSet.from_patches([surface])
    area = f"area {patches.area(tolerance=1e-6):.6g}"
    if not patches.is_closed:
        return [area, "open"]
    try:
        return [area, "closed", f"volume {patches.volume(tolerance=1e-6):.6g}"]
    except Error as error:
        return [area, "closed", f"no volume: {error}"]


def convert(args):
    """Convert between JSON and BPT, and between kinds of shapes."""
    values = read(args.input)
    progress = Progress(len(values), args.progress)
    made = []
    for value in values:
        made += converted(value, args.to)
        progress.step()
    if Path(args.output).suffix.lower() == ".bpt":
        text = bpt.dumps(one_set(made))
    else:
        text = dumps(made if len(made) != 1 else made[0])
    write(args.output, text.encode())
    return 0


def converted(value, kind):
    """The shapes of this kind that a shape is made of."""
    if kind is None:
        return [value]
    if isinstance(value, (PatchSet, Region)):
        return [part for patch in parts_of(value) for part in converted(patch, kind)]
    if kind == "nurbs":
        return [value.to_nurbs()]
    if isinstance(value, (BezierCurve, BezierPatch)):
        return [value]
    made = value.to_bezier()
    if isinstance(value, PATCHES):
        return [part for row in made for part in row]
    return made if isinstance(made, list) else [made]


def parts_of(value):
    """The patches of a set, the outlines of a region, or the one that a curve or a patch is."""
    if isinstance(value, Region):
        return list(value.outlines)
    return [value[i] for i in range(len(value))] if isinstance(value, PatchSet) else [value]


def one_set(values):
    """The patches of all values as one set."""
    patches = []
    for value in values:
        if isinstance(value, SURFACES):
            patches += parts_of(value)
        else:
            raise Refused(f"a {type(value).__name__} is no surface: BPT holds Bezier patches alone")
    return PatchSet.from_patches(patches)


def tessellate(args):
    """Write meshes of surfaces and polylines of curves."""
    values = read(args.input)
    progress = Progress(len(values), args.progress)
    require_fineness(args)
    found, lines = [], []
    for value in values:
        if isinstance(value, SURFACES):
            found.append(mesh_of(value, args))
        else:
            lines += [line for curve in parts_of(value) for line in curve.polylines(args.resolution or 32)]
        progress.step()
    ending = Path(args.output).suffix.lower()
    if ending == ".stl" and lines:
        raise Refused(f"{args.input} holds curves: STL holds triangles alone")
    write(args.output, meshes.stl(found) if ending == ".stl" else getattr(meshes, ending[1:])(found, lines))
    faces = sum(len(mesh[2]) - 1 for mesh in found)
    vertices = sum(len(part[0]) for part in (*found, *lines))
    print(f"{args.output}: {vertices} vertices, {faces} faces, {len(lines)} lines")
    return 0


def require_fineness(args):
    """Raises Refused for a number that is none of parts, and for two kinds of fineness."""
    if args.resolution is not None and args.resolution < 1:
        raise Refused(f"resolution = {args.resolution} is not 1 or more")
    if args.resolution is not None and (args.tolerance is not None or args.angle is not None):
        raise Refused("--resolution counts faces, --tolerance and --angle measure them: give one or the others")


def mesh_of(value, args):
    """Positions, normals, face starts and vertices of corners."""
    angle = None if args.angle is None else float(np.radians(args.angle))
    return meshes.mesh(value, resolution=args.resolution, tolerance=args.tolerance, angle=angle)


def compare(args):
    """Tell whether two files hold the same shapes."""
    a, b = read(args.a), read(args.b)
    if args.geometry:
        return compare_places(a, b, args)
    if len(a) != len(b):
        print(f"{args.a} holds {shapes(len(a))}, {args.b} {len(b)}")
        return 1
    progress = Progress(len(a), args.progress)
    differ = False
    for i, (one, other) in enumerate(zip(a, b)):
        line, same = difference(one, other, args.tolerance)
        progress.step()
        differ |= not same
        if line:
            print(f"{i}: {line}")
    print("different" if differ else "the same")
    return 1 if differ else 0


def compare_places(a, b, args):
    """Whether all shapes of two files lie in the same places, however they are cut into pieces."""
    progress = Progress(2, args.progress)
    apart = []
    for kind, is_surface in (("curves", False), ("surfaces", True)):
        parts = [[part for value in values if isinstance(value, SURFACES) == is_surface for part in parts_of(value)]
                 for values in (a, b)]
        progress.step()
        if all(parts):
            apart.append(max(farthest(*parts), farthest(*reversed(parts))))
            print(f"{kind}: up to {apart[-1]:.6g} apart at sampled points")
        elif any(parts):
            apart.append(float("inf"))
            print(f"{args.a if parts[0] else args.b} alone holds {kind}")
    same = max(apart, default=0.0) <= args.tolerance
    print("the same" if same else "different")
    return 0 if same else 1


def farthest(shapes, others):
    """The largest distance of sampled points of curves, or of patches, from others."""
    points = np.concatenate([sampled(value, 64 if isinstance(value, PATCHES) else 1024) for value in shapes])
    return float(nearest(others, points[np.isfinite(points).all(axis=-1)]).distances.max())


def sampled(value, count):
    """Points (n, 3) at even parameters, NaN at infinity."""
    if isinstance(value, PATCHES):
        return value.evaluate_grid(*[np.linspace(*domain, count + 1) for domain in value.domain], at_infinity="nan").reshape(-1, 3)
    return value.evaluate(np.linspace(*value.domain, count + 1), at_infinity="nan")


def difference(a, b, tolerance):
    """What to say of two shapes, and whether they are the same up to the tolerance."""
    if type(a) is type(b) and a == b:
        return "", True
    if isinstance(a, SURFACES) != isinstance(b, SURFACES):
        return f"a {type(a).__name__} and a {type(b).__name__}", False
    if isinstance(a, (PatchSet, Region)) or isinstance(b, (PatchSet, Region)):
        parts = [parts_of(value) for value in (a, b)]
        if len(parts[0]) != len(parts[1]):
            kind = "patches" if isinstance(a, SURFACES) else "outlines"
            return f"{len(parts[0])} and {len(parts[1])} {kind}", False
        distance = max(distance_of(*pair) for pair in zip(*parts))
    else:
        distance = distance_of(a, b)
    return f"up to {distance:.6g} apart at the same parts of their parameters", distance <= tolerance


def distance_of(a, b, count=64):
    """The largest distance of points at the same parts of the parameters, of curves or of patches."""
    points = [sampled(value, count if isinstance(value, PATCHES) else count**2) for value in (a, b)]
    return float(np.nanmax(np.linalg.norm(points[0] - points[1], axis=-1)))


def parser():
    """What can be called."""
    made = argparse.ArgumentParser(prog="splinecore", description="Exact curves and surfaces in files.",
                                   epilog="Exit codes: 0 done or the same, 1 different, 2 wrong call or file.")
    made.add_argument("--version", action="version", version=f"splinecore {__version__} ({__instruction_set__})")
    verbs = made.add_subparsers(dest="verb", required=True)

    def verb(call, *names):
        added = verbs.add_parser(call.__name__, help=call.__doc__, description=call.__doc__)
        for name in names:
            added.add_argument(name, nargs="+" if name == "files" else None, metavar=name.upper(), help=PLACES[name])
        added.add_argument("--progress", action=argparse.BooleanOptionalAction,
                           help="show progress on the error output; by default where that is a terminal")
        added.set_defaults(call=call)
        return added

    verb(info, "files")
    verb(convert, "input", "output").add_argument("--to", choices=("nurbs", "bezier"), help="the kind of shapes to write; by default as they are")
    meshing = verb(tessellate, "input", "output")
    meshing.add_argument("--resolution", type=int, help="parts of each span; by default 8 of surfaces, 32 of curves")
    meshing.add_argument("--tolerance", type=float, help="the largest distance of the mesh from the surface")
    meshing.add_argument("--angle", type=float, help="the largest angle of normals on one face, in degrees")
    comparing = verb(compare, "a", "b")
    comparing.add_argument("--tolerance", type=float, default=0.0, help="the largest distance that counts as the same; by default 0")
    comparing.add_argument("--geometry", action="store_true",
                           help="compare places alone, whatever the order, kinds, pieces and parameters of the shapes")
    return made


def require_endings(args):
    """Raises Refused for files of a kind that is not read or written."""
    ending = Path(getattr(args, "output", "")).suffix.lower()
    known = ENDINGS.get(args.verb, ())
    if known and ending not in known:
        other = [verb for verb, endings in ENDINGS.items() if ending in endings]
        raise Refused(f"{args.output}: {', '.join(known)} can be written" + "".join(f"; {verb} writes {ending}" for verb in other))


def main(arguments=None):
    """The exit code of a call."""
    args = parser().parse_args(arguments)
    try:
        require_endings(args)
        return args.call(args)
    except (Refused, Error, ValueError) as error:
        print(f"splinecore: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130
