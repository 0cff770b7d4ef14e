"""Writes addon/manual/lectures.md: the pictures of the lectures in their order, each with the steps that make it.

    /usr/bin/python3 blend_samples/lectures/page.py
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[1]
PAGE = PROJECT / "addon/manual/lectures.md"
sys.path.insert(0, str(HERE))

import field_names
import pictures
import steps

LECTURES = {'000': "Parametric Curves", '001': "Graphics and Surfaces", '002': "B-Spline Basis Functions", '004': "Curves and Surfaces"}
_HEAD = """# Pictures of the lectures

The {count} pictures of the lectures in their order, each with the steps that make it from an empty scene. A step is an entry of the menu
*Add*, of *NURBS > Teaching* or another command with the values of its fields, an overlay, a click or a key. Fields that are not
named keep their values. All shapes stay alive: move a point, change a number in the panel *Construction*, and the picture follows.
[Teaching](teaching.md) describes the commands.
"""
#: What a step is called where its operator does not say it.
_WORDS = {
    'splinewright.edit_net': "**Tab**", 'splinewright.leave_net': "**Tab**", 'splinewright.set_knots': "*Edit Knots*",
    'splinewright.weight_here': "*Change Weight*", 'splinewright.point_to_infinity': "*Move to Infinity*", 'splinewright.join_ends': "*Join Ends*",
    'splinewright.to_bezier': "*Convert to Bezier*", 'splinewright.to_hermite': "*Convert to Hermite*", 'splinewright.split': "*Split*",
    'splinewright.add_bezier_curve': "*Bezier Curve*", 'splinewright.add_nurbs_curve': "*NURBS Curve*", 'splinewright.add_bezier_chain': "*Bezier Chain*",
    'splinewright.add_bezier_patch': "*Bezier Patch*", 'splinewright.add_teapot': "*Newell's Teapot*", 'splinewright.add_functions': "*Basis Functions on Knots*",
    'splinewright.add_triangle': "*Triangle of Functions on Knots*", 'splinewright.add_axes': "*Axes*", 'splinewright.add_formula': "*Curve from Formula*",
    'splinewright.add_equation': "*Conic from Equation*", 'splinewright.add_conic': "*Conic by Weight*", 'splinewright.add_helix': "*Helix*",
    'splinewright.add_polynomial': "*Polynomial Through Points*", 'splinewright.add_ducks': "*Spline with Ducks*", 'splinewright.add_lift': "*Homogeneous Curve*",
    'splinewright.add_construction': "*Construction of a Point*", 'splinewright.add_chain_points': "*Chain Points*", 'splinewright.add_hulls': "*Convex Hulls*",
    'splinewright.add_halving': "*Halved Polygons*", 'splinewright.add_marks': "*Marks on a Curve*", 'splinewright.add_orders': "*Orders of Points*",
    'splinewright.add_revolve': "*Revolve*", 'object.shade_flat': "*Shade Flat*", 'object.shade_smooth': "*Shade Smooth*"}
_OVERLAYS = {'NET': "Control Net", 'LABELS': "Labels", 'KNOTS': "Knots", 'COMB': "Curvature Comb", 'HODOGRAPH': "Hodograph", 'ISOCURVES': "Isocurves"}


def page():
    """The text of the page."""
    parts = [_HEAD.format(count=len(pictures.PICTURES))]
    for lecture, title in LECTURES.items():
        parts.append(f"\n## Lecture {lecture}: {title}\n")
        parts += [_picture(picture) for picture in pictures.PICTURES if picture.number.startswith(lecture)]
    if pictures.MISSING:
        parts.append("\n## Not made yet\n")
        parts += [f"\n- {number}: {reason}" for number, reason in pictures.MISSING.items()]
    return "".join(parts)


def _picture(picture):
    count = len(picture.steps)
    made = "; ".join(map(_words, picture.steps))
    return (f"\n**{picture.number}** {picture.title}.\n\n"
            f"{count} step{'s' if count > 1 else ''}: {made}.\n")


def _words(step):
    settings = step.settings
    if step.operator == steps.CLICK:
        return f"click on {_counted('object', settings['numbers'], 1)}"
    if step.operator == steps.CHOOSE:
        return f"select {_counted('point', settings['numbers'], 0)}"
    if step.operator == 'transform.translate':
        return f"**G** by {_value(settings['value'])}"
    if step.operator == 'transform.resize':
        return "**S 0**"
    if step.operator == 'splinewright.show_sight':
        return f"overlay *{_OVERLAYS[settings['sight']]}*"
    return ": ".join(filter(None, (_WORDS[step.operator], ", ".join(_field(step.operator, name, value) for name, value in settings.items()))))


def _counted(word, numbers, first):
    texts = [str(number + first) for number in numbers]
    return f"{word}{'s' if len(texts) > 1 else ''} {', '.join(texts[:-1]) + ' and ' if len(texts) > 1 else ''}{texts[-1]}"


def _field(operator, name, value):
    """A field and its value, both as the panel of the last operator calls them."""
    choices = field_names.CHOICES.get((operator, name))
    return f"*{field_names.FIELDS[operator][name]}* {f'*{choices[value]}*' if choices else _value(value)}"


def _value(value):
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, str):
        return f"`{value}`" if value else "empty"
    if isinstance(value, tuple):
        return f"({', '.join(f'{number:.4g}' for number in value)})"
    return f"{value:.4g}"


if __name__ == '__main__':
    PAGE.write_text(page())
    print(f"{PAGE.relative_to(PROJECT)}: {len(pictures.PICTURES)} pictures")
