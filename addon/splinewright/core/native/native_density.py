"""Between Blender's resolutions and our steps in a span: about as many edges."""

from . import native


def steps_of_curve(spline, resolution, sampling):
    """Our steps in a span where Blender has this resolution."""
    direction, = spline.directions
    if spline.kind == 'BEZIER':
        return resolution
    if spline.kind != 'NURBS' or not native.is_valid_curve(direction):
        return 1
    samples = len(native.curve_parameters(direction, resolution, sampling))
    return _steps(direction, samples)


def steps_of_surface(direction, resolution):
    return _steps(direction, resolution * direction.count)


def _steps(direction, samples):
    edges = samples if direction.flags.cyclic else samples - 1
    return max(round(edges / native.span_count(direction)), 1)


def resolution_of_curve(spline, steps, sampling):
    """Blender's resolution for a given number of the add-on's steps in a span: never one at which it shows another curve."""
    direction, = spline.directions
    if spline.kind == 'BEZIER' or sampling.by_span:
        return steps
    resolution = _resolution(direction, steps, direction.count if direction.flags.cyclic else direction.count - 1)
    shows_another = direction.degree > 1 and native.gives_polygon(direction, resolution, sampling)
    return 2 if shows_another else resolution


def resolution_of_surface(direction, steps):
    return _resolution(direction, steps, direction.count)


def _resolution(direction, steps, samples_for_one):
    """`samples_for_one`: how many samples Blender takes for each step of its resolution."""
    samples = steps * native.span_count(direction) + (0 if direction.flags.cyclic else 1)
    return max(round(samples / samples_for_one), 1)
