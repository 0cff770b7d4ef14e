"""What a lesson is: steps that make shapes, name numbers to move and to watch, and ask."""

import re
from dataclasses import dataclass, field
from typing import NamedTuple

#: Of the text of a Watch: the number of a value.
VALUE = re.compile(r"\{(\d+)\}")


@dataclass(frozen=True)
class Make:
    """A shape of a step: of a value, or made by a recipe from shapes that are there."""

    shape: str
    value: object = None                # a splinecore value; None where a recipe makes it
    recipe: str = ""
    inputs: tuple = ()                  # names of shapes
    settings: dict = field(default_factory=dict)
    points: tuple = ()                  # rows (x, y, z) that the recipe is made from; () for those that it starts from
    faces: tuple = ()                   # of a surface: how many in each span, for u and v; () where the add-on chooses
    place: tuple = (0.0, 0.0, 0.0)      # of the object that a recipe makes; measures take shapes in their own space


@dataclass(frozen=True)
class Change:
    """Another value, other settings, points or faces of a shape."""

    shape: str
    value: object = None
    settings: dict = field(default_factory=dict)
    points: tuple = ()
    faces: tuple = ()


class Measure(NamedTuple):
    """A number of the shapes that are there; measures.py says which kinds there are."""

    kind: str
    shape: str
    arguments: dict                     # by name: numbers, texts, or Measures


class Condition(NamedTuple):
    """Whether a measure is near, above or below a number or another measure."""

    measure: Measure
    relation: str                       # 'near', 'above' or 'below'
    value: object                       # a number or a Measure
    within: float = 0.0                 # how near


@dataclass(frozen=True)
class Ask:
    """A question. kind: 'do' is right when all conditions hold, 'number' when the typed number is near a measure or number, 'choose'
    when the right answer is chosen, 'point' when exactly these control points of a shape are picked."""

    kind: str
    conditions: tuple = ()
    value: object = None
    within: float = 0.0
    choices: tuple = ()
    right: int = 0
    shape: str = ""
    points: frozenset = frozenset()     # numbers from 0 among all points of the shape


class Watch(NamedTuple):
    """A line of text with numbers in it, which follows the shapes: {0}, {1}, …"""

    text: str
    values: tuple                       # of Measure


class Move(NamedTuple):
    """What a learner moves: control points of a shape, counted from 0, or a setting of its recipe."""

    shape: str
    points: tuple = ()
    setting: str = ""


@dataclass(frozen=True)
class Step:
    text: str
    make: tuple = ()                    # of Make
    change: tuple = ()                  # of Change
    view: str = ""                      # 'TOP', 'FRONT', 'RIGHT', 'FREE', or "" to leave it
    overlays: tuple = ()                # switches of overlays that are on
    move: tuple = ()                    # of Move
    watch: tuple = ()                   # of Watch
    ask: Ask | None = None
    hint: str = ""
    solution: tuple = ()                # of Change
    wrong: tuple = ()                   # of tuples of Change, each of which answers wrongly


@dataclass(frozen=True)
class Lesson:
    name: str
    title: str
    lectures: tuple                     # the items of the lectures that it is about
    steps: tuple
