"""The decimal that a user typed into one of Blender's properties, which keep numbers in single precision."""

import math

import numpy as np


def typed(number):
    """The shortest decimal of a float32 number, as float64: 0.1 typed into a property is 0.1."""
    return float(str(np.float32(number)))


def text_of(number, digits=4):
    """A length in a message, of a number of digits, as Blender's fields show it: from a millionth on without an exponent."""
    rounded = float(f"{number:.{digits}g}")
    return np.format_float_positional(rounded, trim='-') if 1e-6 <= abs(rounded) < 1.0 else f"{rounded:.{digits}g}"


def typed_angle(radians):
    """typed() for an angle that is shown in degrees: the shorter of its decimals in both units, in radians."""
    in_radians, in_degrees = (str(np.float32(number)) for number in (radians, math.degrees(radians)))
    return math.radians(float(in_degrees)) if len(in_degrees) < len(in_radians) else float(in_radians)


def typed_all(numbers):
    """(n,): typed() of float32 numbers."""
    return np.asarray(numbers, np.float32).astype(str).astype(np.float64)


def meant(number, text):
    """The float64 of a text where a property that is shown beside it has that number still; typed() otherwise."""
    try:
        exact = float(text)
    except ValueError:
        return typed(number)
    return exact if single(exact) == number else typed(number)


def single(number):
    """What a property of Blender's keeps of a number."""
    most = float(np.finfo(np.float32).max)
    return float(np.float32(min(max(number, -most), most)))
