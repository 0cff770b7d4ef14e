"""Numbers, vectors, sums and matrices as plain text. A number not larger than its error is 0."""

from decimal import Decimal
from fractions import Fraction
from itertools import repeat
from math import inf, isqrt, lcm

import numpy as np

from .exact import Number

#: The largest numbers of a fraction that is written as one.
_MOST_NUMERATOR, _MOST_DENOMINATOR = 10 ** 6, 9999
#: Significant digits with which a decimal is written rather than a fraction.
_SHORT = 6
#: How often a number that is no fraction may look like one.
_CHANCE = 1e-4
#: Parts of a number within which it is written.
_WITHIN = 1e-10
#: The largest common denominator that is written before a matrix.
_MOST_COMMON = 10 ** 7


def number(given, allowed=inf):
    """A Number, or a Fraction, as a text: a short decimal, a fraction, or a decimal within parts of it, or its error. allowed: what
    decimals may differ by, beside that."""
    given = given if isinstance(given, Number) else Number(given)
    if given.is_zero:
        return "0"
    short = _decimal(given.value, given.error, _SHORT)
    return short or _fraction(given) or _decimal(given.value, max(given.error, min(_WITHIN * abs(float(given.value)), allowed)), 17)


def numbers(given, allowed=()):
    """The texts of several that belong together, as number(): where one is a fraction, all are that can be. allowed: of each."""
    given = [each if isinstance(each, Number) else Number(each) for each in given]
    texts = [number(each, *within) for each, within in zip(given, ([within] for within in allowed) if allowed else repeat([]))]
    if not any("/" in text for text in texts):
        return texts
    return [text if each.is_zero else _fraction(each) or text for each, text in zip(given, texts)]


def _decimal(value, within, most):
    """The shortest decimal that is so near, or None where it has more significant digits."""
    near = float(value)
    slack = within + 1e-15 * abs(near)
    for digits in range(1, most + 1):
        text = f"{near:.{digits}g}"
        if digits == 17 or abs(float(text) - near) <= slack and abs(Fraction(text) - value) <= within:
            return _plain(text)
    return None


def _plain(text):
    """Without an exponent where it is as easily read."""
    size = abs(float(text))
    return format(Decimal(text), 'f') if 1e-5 <= size < 1e12 else text


def _fraction(given):
    denominator = _MOST_DENOMINATOR
    if given.error * denominator ** 2 > _CHANCE:
        denominator = max(isqrt(int(_CHANCE / given.error)), 1)
    found = given.value.limit_denominator(denominator)
    if abs(found - given.value) > given.error or abs(found.numerator) > _MOST_NUMERATOR or not found:
        return None
    return str(found)


def vector(given, allowed=inf):
    given = list(given)
    return "(" + ", ".join(numbers(given, [allowed] * len(given))) + ")"


def point(row, allowed=inf):
    """A homogeneous point [X, Y, Z, W]: as a point with its weight, or with all four numbers where it is at infinity."""
    *along, weight = row
    if weight.is_zero:
        return "[" + " ".join(numbers(along, [allowed] * len(along))) + " 0]  (at infinity)"
    return f"{vector([each / weight for each in along], allowed)} w = {number(weight)}"


def summed(terms):
    """c1 name1 + c2 name2 ..., of pairs of a text of a number and a name, without those that are zero."""
    written = ""
    for text, name in terms:
        if text == "0":
            continue
        is_negative, size = text.startswith("-"), text.lstrip("-")
        sign = ("-" if is_negative else "") if not written else (" - " if is_negative else " + ")
        written += sign + (name if name and size == "1" else f"{size} {name}".rstrip())
    return written or "0"


def power(variable, exponent):
    """1 is written as nothing."""
    return "" if exponent == 0 else variable if exponent == 1 else f"{variable}^{exponent}"


def powers(degree, variable="t"):
    """[t^3 t^2 t 1]"""
    return "[" + " ".join(power(variable, k) or "1" for k in range(degree, -1, -1)) + "]"


def from_start(name, local, start, allowed):
    """(what a parameter is called that counts from a start, and what that means or ""): its own name where the start is 0."""
    return (name, "") if start == 0 else (local, f"{local} = {name} - {number(start, allowed)}".replace("- -", "+ "))


def allowed_for(points):
    """What coordinates as decimals may differ by."""
    return 1e-11 * float(np.ptp(points.reshape(-1, points.shape[-1]), axis=0).max())


def share_of(numbers, scales):
    """What terms as decimals may differ by: of the largest of those that are no constant. scales: what multiplies each."""
    return 1e-12 * max((abs(float(each.value * scale)) for each, scale in zip(numbers[1:], scales[1:])), default=0.0)


def interval(start, end, allowed=inf):
    return f"[{number(start, allowed)}, {number(end, allowed)}]"


def listed(items, most, what):
    """Items by lines: functions that give lines of each; of more than the most it is said how many there are."""
    lines = [line for item in items[:most] for line in item()]
    return lines + ([f"  and {len(items) - most} {what} more"] if len(items) > most else [])


def matrix(rows, indent, errors=None):
    """Lines of a matrix of Fractions, their common denominator before it where that is small; else as numbers with errors."""
    common = lcm(*(Fraction(value).denominator for row in rows for value in row))
    is_whole = common <= _MOST_COMMON
    errors = errors or [[0.0] * len(row) for row in rows]
    texts = [[str(int(value * common)) if is_whole else number(Number(Fraction(value), error)) for value, error in zip(*each)]
             for each in zip(rows, errors)]
    width = max(len(text) for row in texts for text in row)
    lines = [indent + "  ".join(text.rjust(width) for text in row) for row in texts]
    return ([f"{indent}1/{common} times"] if is_whole and common > 1 else []) + lines
