"""Every call of an operator says one thing at most: the status bar shows only the last."""

import bpy
import pytest

from curves import run, value_of
from natives import native_curve
from shapes import activate, add, enter, leave, op
from support import part

reports = part('ui.operators.reports')


class _Operator:
    def __init__(self):
        self.said = []

    def report(self, kinds, text):
        self.said.append((*kinds, text))


def said(capfd):
    """The lines that Blender printed of reports."""
    lines = capfd.readouterr().out.splitlines()
    return [line for line in lines if line.split(":")[0] in ("Info", "Warning", "Error")]


def test_the_worst_is_last_and_gives_the_kind():
    operator = _Operator()
    assert reports.finished(operator, reports.Report("Done", ("a note",), ("a loss",))) == {'FINISHED'}
    assert reports.finished(operator, reports.Report("Done", ("a note",))) == {'FINISHED'}
    assert reports.finished(operator, reports.Report()) == {'FINISHED'}
    assert reports.cancelled(operator, "first", "second") == {'CANCELLED'}
    assert operator.said == [('WARNING', "Done; a note; a loss"), ('INFO', "Done; a note"), ('ERROR', "first; second")]


def test_many_reasons_are_summed_up():
    failed = {name: "it is flat" for name in "ABCDE"} | {"F": "F is linked", "G": "why not"}
    assert reports.by_name(failed) == ("A, B, C and 2 more: it is flat", "F is linked", "G: why not")
    operator = _Operator()
    reports.cancelled(operator, *map(str, range(9)))
    assert operator.said == [('ERROR', "0; 1; 2; and 6 more")]


def test_some_done_and_some_not_is_one_warning(capfd):
    for name, kind in (("one", 'three knots'), ("two", 'cubic'), ("three", 'cubic')):
        add(value_of(kind), name)
    activate(*bpy.data.objects)
    assert run('remove_knot') == {'FINISHED'}
    line, = said(capfd)
    assert line.startswith("Warning: Removed a knot of one: 7 points became 6, largest distance")
    assert line.endswith("; two, three: there is no inner knot")


def test_none_done_is_one_error(capfd):
    for name in ("one", "two"):
        add(value_of('cubic'), name)
    activate(*bpy.data.objects)
    with pytest.raises(RuntimeError, match="there is no inner knot"):
        run('remove_knot')
    assert bpy.data.objects["one"].data.splinewright.value.degree == 3


def test_what_conversions_drop_is_in_their_one_report(capfd):
    obs = [native_curve(), native_curve()]
    for ob in obs:
        ob.modifiers.new("Hook", 'HOOK')
    activate(*obs)
    assert op(bpy.ops.splinewright.make_exact) == {'FINISHED'}
    line, = said(capfd)
    assert line.startswith("Warning: Made 2 objects exact") and "without the points of the modifier Hook" in line


def test_every_verb_without_settings_says_one_thing(capfd):
    for name, kind in (('reverse', 'nurbs'), ('to_bezier', 'nurbs'), ('insert_knot', 'cubic'),
                       ('raise_degree', 'many curves'), ('split', 'cubic'), ('apply_transform', 'cubic'),
                       ('restore', 'cubic'), ('detach', 'cubic')):
        add(value_of(kind))
        capfd.readouterr()
        assert run(name) == {'FINISHED'}
        line, = said(capfd)
        assert line.startswith("Info: "), line


def test_entering_and_leaving_a_net_say_nothing_where_all_is_well(capfd):
    add(value_of('cubic'))
    capfd.readouterr()
    enter()
    leave()
    assert said(capfd) == []
