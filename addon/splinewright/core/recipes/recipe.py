"""What a recipe is. Each is one entry of a table: operators, panels and storage are made from it."""

from dataclasses import dataclass
from typing import Callable, NamedTuple

import numpy as np


@dataclass(frozen=True)
class Parameter:
    """A number, choice or text that a recipe takes."""

    name: str
    label: str
    description: str
    default: object                     # its type is the parameter's
    least: float = -1e9
    most: float = 1e9
    unit: str = 'NONE'                  # as Blender's properties: 'LENGTH', 'ROTATION'
    choices: tuple = ()                 # of texts: (value, label, description)


class Made(NamedTuple):
    """What a recipe made, and how far that may lie from what was asked for: 0 where it is exact."""

    value: object
    error: float = 0.0


@dataclass(frozen=True)
class Recipe:
    kind: str                           # names it in files
    label: str
    description: str
    parameters: tuple                   # of Parameter
    make: Callable                      # (points (n, 3), **parameters) -> Made; raises ValueError or ArithmeticError
    points: tuple = ()                  # rows to start from; none where the parameters say all
    has_any_count: bool = False         # of points
    resolution: int = 32

    @property
    def defaults(self):
        return {parameter.name: parameter.default for parameter in self.parameters}

    @property
    def start(self):
        """(n, 3) float64: the points to start from."""
        return np.array(self.points, dtype=np.float64).reshape(-1, 3)
