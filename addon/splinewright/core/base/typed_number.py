"""A number that is typed while something is dragged."""

import math
from typing import NamedTuple


class Typed(NamedTuple):
    """Its digits, and whether it is negative: the sign may come at any time, as in Blender's own gestures."""

    digits: str = ""
    is_negative: bool = False

    @property
    def number(self):
        """None where it is none yet."""
        try:
            value = float(self.digits)
        except ValueError:
            return None
        if not math.isfinite(value):
            return None
        return -value if self.is_negative else value

    def __str__(self):
        return f"{'-' if self.is_negative else ''}{self.digits}"


def after(typed, character):
    """The text when a character is added, or None where it cannot be part of a number."""
    if character == '-':
        return typed._replace(is_negative=not typed.is_negative)
    character = character.replace(",", ".")
    if len(character) != 1 or character not in "0123456789." or character == "." in typed.digits:
        return None
    return typed._replace(digits=typed.digits + character)


def shortened(typed):
    """The text when the last character is taken back."""
    return Typed() if not typed.digits else typed._replace(digits=typed.digits[:-1])
