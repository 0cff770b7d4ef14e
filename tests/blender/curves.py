"""Curves of every kind, the same ones at every call, and the operators on them."""

import re

import bpy
import numpy as np

import shapes
from shapes import VALUES, op
from support import splinecore as sc

MORE = {
    'parabola': lambda: sc.BezierCurve(shapes.points(3)),
    'uniform': lambda: sc.NurbsCurve(3, np.arange(12.0), shapes.points(8), shapes.RANDOM.uniform(0.5, 2, 8)),
    'hyperbola': lambda: sc.BezierCurve([(1, 0), (1, 1), (0, 1)], [1, -2, 1]),
    'circle': lambda: sc.conics.circle((0.5, 0, 0), 2.0),
    'three knots': lambda: sc.NurbsCurve(3, [0, 0, 0, 0, 0.1, 1 / 3, 1 / 3, 1, 1, 1, 1], shapes.points(7)),
    'nearly closed': lambda: sc.BezierCurve([(0, 0), (1, 0), (1, 1), (0, 1e-4)]),
    'large circle': lambda: sc.conics.circle((0, 0, 0), 1e6),
}


def value_of(kind):
    """The same one at every call."""
    shapes.RANDOM.bit_generator.state = np.random.default_rng(7).bit_generator.state
    return (VALUES.get(kind) or MORE[kind])()


def run(name, **settings):
    """With the defaults of what is not given: Blender remembers the last ones."""
    operator = getattr(bpy.ops.splinewright, name)
    defaults = {p.identifier: tuple(p.default_array) if getattr(p, 'is_array', False) else p.default
                for p in operator.get_rna_type().properties if p.identifier != 'rna_type'}
    return op(operator, **{**defaults, **settings})


def curves_of(ob):
    value = ob.data.splinewright.value
    return value if isinstance(value, list) else [value]


def value_of_patch():
    return sc.BezierPatch(np.random.default_rng(1).uniform(size=(3, 3, 3)))


def said_distance(text):
    """The distance at the end of a sentence, 0 where none is said."""
    found = re.search(r"largest distance (\S+)$", text)
    return float(found.group(1)) if found else 0.0


def said_near(text):
    """(how many control points, the largest distance) of the report of what was made near something."""
    count, distance = re.search(r"(\d+) control points, largest distance (\S+)$", text, re.MULTILINE).groups()
    return int(count), float(distance)
