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
    __instruction_set__,
    __version__,
    bpt,
    dumps,
    loads,
    meshes,
)

PATCHES = (NurbsPatch, BezierPatch, HermitePatch)
SURFACES = (PatchSet, *PATCHES)
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
    """What files hold."""
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
        facts.append(f"area {value.area(tolerance=1e-6):.6g}" if isinstance(value, SURFACES) else f"length {value.length():.9g}")
    except Error as error:
        facts.append(str(error))
    return f"{kind}: {'; '.join(facts)}"


def convert(args):
    """JSON and BPT, and kinds of shapes."""
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
    if isinstance(value, PatchSet):
        return [part for patch in patches_of(value) for part in converted(patch, kind)]
    if kind == "nurbs":
        return [value.to_nurbs()]
    if isinstance(value, (BezierCurve, BezierPatch)):
        return [value]
    made = value.to_bezier()
    if isinstance(value, PATCHES):
        return [part for row in made for part in row]
    return made if isinstance(made, list) else [made]


def patches_of(value):
    """The patches of a set, or the one that a patch is."""
    return [value[i] for i in range(len(value))] if isinstance(value, PatchSet) else [value]


def one_set(values):
    """The patches of all values as one set."""
    patches = []
    for value in values:
        if isinstance(value, SURFACES):
            patches += patches_of(value)
        else:
            raise Refused(f"a {type(value).__name__} is no surface: BPT holds Bezier patches alone")
    return PatchSet.from_patches(patches)


def tessellate(args):
    """Meshes of surfaces, polylines of curves."""
    values = read(args.input)
    progress = Progress(len(values), args.progress)
    require_fineness(args)
    found, lines = [], []
    for value in values:
        if isinstance(value, SURFACES):
            found.append(mesh_of(value, args))
        else:
            lines += value.polylines(args.resolution or 32)
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
    """Whether two files hold the same shapes."""
    a, b = read(args.a), read(args.b)
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


def difference(a, b, tolerance):
    """What to say of two shapes, and whether they are the same up to the tolerance."""
    if type(a) is type(b) and a == b:
        return "", True
    if isinstance(a, SURFACES) != isinstance(b, SURFACES):
        return f"a {type(a).__name__} and a {type(b).__name__}", False
    if isinstance(a, PatchSet) or isinstance(b, PatchSet):
        parts = [patches_of(value) for value in (a, b)]
        if len(parts[0]) != len(parts[1]):
            return f"{len(parts[0])} and {len(parts[1])} patches", False
        distance = max(distance_of(*pair) for pair in zip(*parts))
    else:
        distance = distance_of(a, b)
    return f"up to {distance:.6g} apart at the same parts of their parameters", distance <= tolerance


def distance_of(a, b, count=64):
    """The largest distance of points at the same parts of the parameters, of curves or of patches."""
    if isinstance(a, PATCHES):
        points = [value.evaluate_grid(*[np.linspace(*domain, count + 1) for domain in value.domain], at_infinity="nan")
                  for value in (a, b)]
    else:
        points = [value.evaluate(np.linspace(*value.domain, count**2 + 1), at_infinity="nan") for value in (a, b)]
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
            added.add_argument(name, nargs="+" if name == "files" else None)
        added.add_argument("--progress", action=argparse.BooleanOptionalAction,
                           help="say how far it is on the error output; else where that is a terminal")
        added.set_defaults(call=call)
        return added

    verb(info, "files")
    verb(convert, "input", "output").add_argument("--to", choices=("nurbs", "bezier"), help="the kind of shapes; else as read")
    meshing = verb(tessellate, "input", "output")
    meshing.add_argument("--resolution", type=int, help="parts of each span: 8 of surfaces, 32 of curves where not given")
    meshing.add_argument("--tolerance", type=float, help="how far the mesh may be from the surface")
    meshing.add_argument("--angle", type=float, help="how far normals of neighbors may turn, in degrees")
    verb(compare, "a", "b").add_argument("--tolerance", type=float, default=0.0, help="distance that counts as none")
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
