"""Between Blender's resolutions and our steps in a span: about as many edges."""

from . import native


def steps_of_curve(spline, resolution, version):
    """Our steps in a span where Blender has this resolution."""
    direction, = spline.directions
    if spline.kind == 'BEZIER':
        return resolution
    if spline.kind != 'NURBS' or not native.is_valid_curve(direction):
        return 1
    samples = len(native.curve_parameters(direction, resolution, version))
    return _steps(direction, samples)


def steps_of_surface(direction, resolution):
    return _steps(direction, resolution * direction.count)


def _steps(direction, samples):
    edges = samples if direction.flags.cyclic else samples - 1
    return max(round(edges / native.span_count(direction)), 1)


def resolution_of_curve(spline, steps, version):
    """Blender's resolution for so many of our steps in a span."""
    direction, = spline.directions
    if spline.kind == 'BEZIER' or version >= (5, 0, 0):
        return steps
    return _resolution(direction, steps, direction.count if direction.flags.cyclic else direction.count - 1)


def resolution_of_surface(direction, steps):
    return _resolution(direction, steps, direction.count)


def _resolution(direction, steps, samples_for_one):
    """`samples_for_one`: how many samples Blender takes for each step of its resolution."""
    samples = steps * native.span_count(direction) + (0 if direction.flags.cyclic else 1)
    return max(round(samples / samples_for_one), 1)
