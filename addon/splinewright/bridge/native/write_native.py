"""Values as Blender's own curves and surfaces."""

from typing import NamedTuple

from ...core.base.failures import Refusal
from ...core.base.library import sc
from ...core.base.words import phrase
from ...core.native import native_density, native_forms
from ...core.shape.definition import CURVES
from ..data import versions
from . import measure_native, native_splines, surface_nets


class Plan(NamedTuple):
    """The splines that a value becomes, before anything is written."""

    forms: list                     # of Form
    numbers: list                   # for each the number of its curve or patch in the value

    @property
    def notes(self):
        """What Blender cannot hold as it is: sentences."""
        count = len({number for form, number in zip(self.forms, self.numbers) if not form.is_as_given})
        if not count:
            return []
        who = "1 piece has" if count == 1 else phrase("{count} pieces have", count=count)
        return [phrase("{who} knots or weights that Blender cannot hold: the same shape in Bezier pieces", who=who)]


def plan(value):
    """What write_curves() or new_surface() will write.

    Raises Refusal, naming the piece, where Blender has no such shape.
    """
    if isinstance(value, CURVES):
        pieces, make = [value], native_forms.curve_forms
    elif isinstance(value, list):
        pieces, make = value, native_forms.curve_forms
    else:
        pieces = [value[i] for i in range(len(value))] if isinstance(value, sc.PatchSet) else [value]
        make = native_forms.patch_forms
    found = Plan([], [])
    for number, piece in enumerate(pieces):
        try:
            forms = make(piece)
        except (Refusal, sc.Error) as error:
            raise Refusal(phrase("piece {number}: {error}",
                                 number=number + 1, error=error) if len(pieces) > 1 else str(error)) from error
        found.forms.extend(forms)
        found.numbers.extend([number] * len(forms))
    return found


def write_curves(data, planned, steps, types=()):
    """Give a curve data-block the planned splines in place of the present ones. steps: ours in a span; types: of the handles of each
    piece, where they are known.

    Returns the measured deviation, in units of the object: float32 rounding, about 1e-6 of the size.
    """
    data.dimensions = '3D'
    data.splines.clear()
    for form, number in zip(planned.forms, planned.numbers):
        resolution = native_density.resolution_of_curve(form.spline, steps, versions.sampling)
        native_splines.append(data, form.spline, resolution, types[number] if types else "")
    data.update_tag()               # Blender 3.4 does not notice foreach_set on points
    return measure_native.of_forms(data, planned.forms)


def new_surface(context, name, planned, steps):
    """A new surface data-block of the planned splines, and the measured deviation. steps: ours along u and v.

    Raises Refusal outside Object Mode.
    """
    data = surface_nets.new_surface(context, name, [form.spline.points.shape[:2] for form in planned.forms])
    for spline, form in zip(data.splines, planned.forms):
        resolution = [native_density.resolution_of_surface(direction, count)
                      for direction, count in zip(form.spline.directions, steps[::-1])]
        native_splines.fill(spline, form.spline, resolution)
        spline.use_smooth = True
    data.update_tag()
    return data, measure_native.of_forms(data, planned.forms)
