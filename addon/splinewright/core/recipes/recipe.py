"""What a recipe is. Each is one entry of a table: operators, panels and storage are made from it."""

from dataclasses import dataclass
from numbers import Real
from typing import Callable, NamedTuple

import numpy as np

from ..base.failures import Refusal, WrongKind
from ..base.library import sc
from ..base.words import phrase
from ..shape import definition as definitions


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
    before: object = None               # its value in files from before there was such a parameter, if not the default
    follows: str = ""                   # the parameter whose value it has where that is given and its own is not
    of_scene: bool = False              # it is the scene's tolerance where none is given
    where: tuple = ()                   # (the name of another parameter, its values) with which alone it counts
    numbers: int = 0                    # of a text of numbers between spaces: how many have fields of their own, which take keys

    def checked(self, value):
        """The value as a recipe takes it. Raises WrongKind for one of another kind, Refusal for one outside its limits."""
        wanted = type(self.default)
        if wanted is str:
            return self._checked_text(value)
        if not isinstance(value, (Real, np.bool_)):
            raise WrongKind("{label} is {value!r}: it must be a number", label=phrase(self.label), value=value)
        if not abs(value) < 1e300:
            raise Refusal("{label} is not a finite number", label=phrase(self.label))
        if wanted is not float and value != int(value):
            raise Refusal("{label} is {value:g}: it must be a whole number", label=phrase(self.label), value=value)
        if wanted is not bool and not self._is_within(value):
            raise Refusal("{label} is {value:g}: it must be from {least:g} to {most:g}",
                          label=phrase(self.label), value=value, least=self.least, most=self.most)
        return wanted(value)

    def _checked_text(self, value):
        if type(value) is not str:
            raise WrongKind("{label} is {value!r}: it must be a text", label=phrase(self.label), value=value)
        names = [choice[0] for choice in self.choices]
        if names and value not in names:
            raise Refusal("{label} is {value!r}: it must be one of {names}",
                          label=phrase(self.label), value=value, names=', '.join(names))
        return value

    def _is_within(self, value):
        """Blender's properties clip in single precision."""
        return self.least - 1e-6 * abs(self.least) <= value <= self.most + 1e-6 * abs(self.most)


class Result(NamedTuple):
    """What a recipe made, and how far that may lie from what was asked for: 0 where it is exact."""

    value: object                       # a splinecore value or a Definition
    error: float = 0.0
    said: str = ""                      # what was achieved beside that, in words
    warning: str = ""                   # what is wrong with it, in words

    @property
    def definition(self):
        is_one = isinstance(self.value, definitions.Definition)
        return self.value if is_one else definitions.from_value(self.value)


@dataclass(frozen=True)
class Recipe:
    kind: str                           # names it in files
    label: str
    description: str
    parameters: tuple                   # of Parameter
    make: Callable                      # (points, places or inputs, **parameters) -> Result; raises Refusal or an error of
                                        # the library
    points: tuple = ()                  # rows (x, y, z) to start from; none where the parameters or objects say all
    has_any_count: bool = False         # of points
    resolution: int = 32
    thickness: float = 0.0              # of new curves, so that they render: the radius of Blender's bevel
    is_surface: bool = False            # it makes patches
    covers_inputs: bool = False         # what it makes lies where they do: they are hidden unless that is not wanted
    covered: Callable | None = None     # (values) -> over how many of its first inputs it lies, where not over all
    count_for: Callable | None = None   # (values) -> how many of the points to start from
    is_endless: bool = False            # curves may run far: they are shown as far as the reach around the points
    inputs: tuple = ()                  # what is to be selected, for each object that it is made from in place of
                                        # points, of wanted.Input; make() takes a list of their Definitions
    has_more: bool = False              # it takes any number of what the last of `inputs` says, in an order that can be changed
    is_from_mesh: bool = False          # its input is a mesh that shows no shape: make() takes core.shape.polygons.Polygons
    takes_points: bool = False          # an empty is an input, too: make() takes a core.surfaces.sections.Point for it
    has_turns: bool = False             # each can be turned: make() takes a list of truths as `turned`
    takes_spaces: bool = False          # make() takes the matrices (4, 4) of the inputs, where those lie, as `spaces`
    arranged: Callable | None = None    # (inputs) -> their order, as numbers from 0, in which they are taken at first
    fixed: int = 0                      # how many of its first inputs have a part of their own, before what has an order
    own_spaces: tuple = ()              # which of them enter in their own space, counted from 0: others where they lie
    is_beside: bool = False             # what it makes is put beside its first input, not over it
    frame: str = ""                     # what an object is called that may be chosen for its place and axes alone:
                                        # make() takes their matrix (4, 4) in the space of the shape, or None, as `frame`
    first_values: Callable | None = None # (inputs) -> values of parameters that fit them, by name: what it begins with
    is_measured: bool = False           # distances count: make() takes inputs as long as in the world, and what it makes comes back
    has_places: bool = False            # in place of points it has objects, any number: make() takes where they are
    takes_cancel: bool = False          # it may take long: make() takes a `cancel` as the library does
    applied: Callable | None = None     # (definition) -> what is left of it without the recipe, where that is not all
    has_groups: bool = False            # of points, any number of them; make() refuses parts of one
    radius_asked: str = ""              # the parameter that asks for the radius along its first input: make() takes it as
                                        # `factor`, a curve over the parameters of that of which x is the radius, or None
    lengths: tuple = ()                 # that are shown and typed in place of points: (label, description, the number of a
                                        # point, that of the one that is so far from it)

    @property
    def wanted(self):
        """What must be selected."""
        return ' and '.join(one.text for one in self.inputs)

    def takes(self, count):
        """Whether it can be made from this number of objects."""
        return count >= len(self.inputs) if self.has_more else count == len(self.inputs)

    def wanted_at(self, index):
        """What the input of an index is to be."""
        return self.inputs[min(index, len(self.inputs) - 1)]

    @property
    def defaults(self):
        return {parameter.name: parameter.default for parameter in self.parameters}

    def checked(self, given):
        """Values of parameters by name as the recipe takes them. Raises WrongKind or Refusal."""
        known = {parameter.name: parameter for parameter in self.parameters}
        for name in given:
            if name not in known:
                has = phrase("it has {known}", known=', '.join(known)) if known else "it has none"
                raise WrongKind("{label} has no setting {name!r}: {has}", label=phrase(self.label), name=name, has=has)
        return {name: known[name].checked(value) for name, value in given.items()}

    def completed(self, given, tolerance=None, suggested=()):
        """Values of all parameters: those given by name, or of what they follow, or the tolerance, or suggested ones, or their
        defaults. tolerance: that of the scene. Raises as checked()."""
        given = self.checked(given)
        of_scene = {parameter.name: tolerance for parameter in self.parameters if parameter.of_scene and tolerance is not None}
        followed = {parameter.name: given[parameter.follows] for parameter in self.parameters if parameter.follows in given}
        return {**self.defaults, **dict(suggested), **of_scene, **followed, **given}

    def counting(self, properties, name_of=lambda parameter: parameter.name):
        """The parameters that count with the values that properties have. name_of: (parameter) -> what they call it."""
        named = {parameter.name: parameter for parameter in self.parameters}

        def counts(parameter):
            return not parameter.where or getattr(properties, name_of(named[parameter.where[0]])) in parameter.where[1]
        return [parameter for parameter in self.parameters if counts(parameter)]

    def work(self, given, values):
        """A function that gives what make() does of points, places or inputs, for a `cancel` as the library takes it."""
        return lambda cancel: self.make(given, **values, **({'cancel': cancel} if self.takes_cancel else {}))

    @property
    def can_gain_points(self):
        return self.has_any_count or self.has_groups

    @property
    def can_close(self):
        """Whether a parameter says that it is closed."""
        return 'closed' in self.defaults

    @property
    def start(self):
        """(n, 3) float64: the points to start from."""
        return np.array(self.points, dtype=np.float64).reshape(-1, 3)

    def start_for(self, values):
        """start, or as many of them as these values of the parameters ask for."""
        return self.start[:self.count_for(values)] if self.count_for else self.start


def of_patches(patches, error=0.0, said="", warning=""):
    """The Result that is a patch, or several as one."""
    return Result(patches[0] if len(patches) == 1 else sc.PatchSet.from_patches(patches), error, said, warning)


def share_of_size(definition, share):
    """A length, in one digit."""
    places = definition.pool[definition.pool[:, 3] != 0.0, :3]
    return float(f"{share * np.ptp(places, axis=0).max():.1g}")
