"""The decimal that a user typed into one of Blender's properties, which keep numbers in single precision."""

import math

import numpy as np


def typed(number):
    """The shortest decimal of a float32 number, as float64: 0.1 typed into a property is 0.1."""
    return float(str(np.float32(number)))


def typed_angle(radians):
    """typed() for an angle that is shown in degrees: the shorter of its decimals in both units, in radians."""
    in_radians, in_degrees = (str(np.float32(number)) for number in (radians, math.degrees(radians)))
    return math.radians(float(in_degrees)) if len(in_degrees) < len(in_radians) else float(in_radians)


def typed_all(numbers):
    """(n,): typed() of float32 numbers."""
    return np.asarray(numbers, np.float32).astype(str).astype(np.float64)
