"""Knots are moved by numbers, and where the strip is that shows them; by the mouse that is tried in a window."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest

import patches
from curves import curves_of, run, value_of
from natives import native_curve
from shapes import activate, add, enter, numbers_of, op, require_exact, select
from support import part, splinecore as sc

definitions, live, seen, store, strip, strip_keys = (part(name) for name in (
    'core.shape.definition', 'bridge.net.live', 'bridge.analysis.overlays', 'bridge.data.store', 'ui.knot_strip',
    'ui.operators.strip_keys'))
state, blenders_refusals = part('ui.ui_state').ui_state, part('core.base.failures').blenders_refusals
#: Kind of a shape, axis, which of its knots, where to.
MOVED = (('nurbs', 'U', 5, 0.15), ('periodic', 'U', 3, 0.9), ('uniform', 'U', 5, 4.25), ('uniform', 'U', 1, -2.0),
         ('three knots', 'U', 7, 0.5), ('hermite', 'U', 2, 0.25), ('circle', 'U', 4, 0.2))
MOVED_PATCHES = (('nurbs patch', 'U', 5, 0.15), ('nurbs patch', 'V', 3, 1.5), ('rational nurbs', 'V', 4, 1.0),
                 ('uniform', 'V', 4, 0.75), ('hermite patch', 'U', 2, 0.5), ('both periodic', 'U', 2, 0.25))


def shape():
    return bpy.data.objects["shape"]


def value():
    return shape().data.splinewright.value


def knots_of(found, axis):
    name = next((name for name in ('parameters', 'knots') if hasattr(found, name)), None)
    knots = getattr(found, name) if name else [0.0, 1.0]
    return np.array(knots['UV'.index(axis)] if isinstance(knots, tuple) else knots)


def added(kind, axis, is_patch):
    ob = add(patches.value_of(kind) if is_patch else value_of(kind))
    return ob, value(), knots_of(value(), axis)


def expected(knots, number, to):
    return np.where(knots == knots[number - 1], to, knots)


def between(knots, number, part=0.4):
    """A parameter between the neighbors of a knot."""
    distinct = np.unique(knots)
    i = int(np.searchsorted(distinct, knots[number - 1]))
    return float(distinct[i - 1] + part * (distinct[i + 1] - distinct[i - 1])) if 0 < i < len(distinct) - 1 else None


@pytest.mark.parametrize('is_net', (False, True))
@pytest.mark.parametrize('kind, axis, number, to, is_patch', (
    *((*row, False) for row in MOVED), *((*row, True) for row in MOVED_PATCHES)))
def test_a_knot_moves_the_points_stay_and_undo_is_one_step(kind, axis, number, to, is_patch, is_net):
    _, before, knots = added(kind, axis, is_patch)
    to = between(knots, number) or to
    if is_net:
        enter()
    assert run('move_knot', axis=axis, knot=number, parameter=to, exact=repr(to)) == {'FINISHED'}
    after = value()
    assert np.array_equal(knots_of(after, axis), expected(knots, number, to))
    assert np.array_equal(after.points, before.points)
    require_exact(shape())
    if is_net:
        ob = bpy.context.object
        assert bpy.context.mode.startswith('EDIT') and live.problem(ob) == ""
        assert definitions.are_same(numbers_of(ob).source, store.read(shape().data))
    bpy.ops.ed.undo()
    assert value() == before and bpy.context.mode.startswith('EDIT') == is_net
    bpy.ops.ed.redo()
    assert value() == after
    require_exact(shape())


def test_the_number_of_the_panel_counts_where_it_was_changed():
    _, _, knots = added('nurbs', 'U', False)
    third = float(knots[4] + (knots[5] - knots[4]) / 3)
    run('move_knot', knot=5, parameter=third, exact=repr(third))
    assert knots_of(value(), 'U')[4] == third
    half = float(np.float32((knots[4] + knots[5]) / 2))
    run('move_knot', knot=5, parameter=half, exact=repr(third))
    assert knots_of(value(), 'U')[4] == float(str(np.float32(half)))


@pytest.mark.parametrize('scale', (1e-150, 1e150))
def test_knots_that_single_precision_does_not_hold_are_moved_and_never_mistaken(scale):
    points = np.random.default_rng(2).normal(size=(6, 3))
    curve = sc.NurbsCurve(3, scale * np.array([0, 0, 0, 0, 1, 2, 3, 3, 3, 3.0]), points)
    add(curve)
    to = 1.5 * scale
    single = part('core.base.decimals').single
    assert run('move_knot', knot=5, parameter=single(to), exact=repr(to)) == {'FINISHED'}
    assert value().knots[4] == to
    require_exact(shape())
    def hit(at):
        return strip.Hit(SimpleNamespace(ob=shape(), number=1, bars=seen.bars_of(shape().data, 1)[0]), 0, 1, at)
    assert strip_keys.SPLINEWRIGHT_OT_insert_on_strip.call(None, bpy.context, hit(1.75 * scale)) == {'FINISHED'}
    assert [to, 1.75 * scale] == value().knots[4:6].tolist()
    assert strip_keys.SPLINEWRIGHT_OT_remove_on_strip.call(None, bpy.context, hit(1.75 * scale)) == {'FINISHED'}
    assert np.array_equal(value().knots, scale * np.array([0, 0, 0, 0, 1.5, 2, 3, 3, 3, 3.0]))


@pytest.mark.parametrize('kind, number, to, words', (
    ('nurbs', 5, 99.0, "between"), ('nurbs', 1, 0.1, "ends of the domain stay"),
    ('nurbs', 99, 0.1, "none of number 99"),
    ('periodic', 1, 0.1, "begins at this knot"), ('cubic', 1, 0.5, "no knots"), ('nurbs', 5, -1e30, "between")))
def test_what_may_not_be_is_refused_and_nothing_changed(kind, number, to, words):
    _, before, _ = added(kind, 'U', False)
    with pytest.raises(RuntimeError, match=words):
        run('move_knot', knot=number, parameter=to)
    assert value() == before
    enter()
    with pytest.raises(RuntimeError, match=words):
        run('move_knot', knot=number, parameter=to)
    assert value() == before and bpy.context.mode.startswith('EDIT')


def test_a_piece_that_is_not_there_and_an_axis_that_a_curve_has_not_are_refused():
    _, before, _ = added('nurbs', 'U', False)
    for settings, words in (({'piece': 7}, "none of number 7"), ({'axis': 'V'}, "no knots along v")):
        with pytest.raises(RuntimeError, match=words):
            run('move_knot', knot=5, parameter=0.15, **settings)
    assert value() == before


def test_what_is_made_by_its_numbers_or_follows_is_refused_in_the_words_of_others():
    for make in ('add_circle', 'follow_object'):
        native_curve()
        op(getattr(bpy.ops.splinewright, make))
        ob = bpy.context.object
        before = ob.data.splinewright.value
        assert seen.bars_of(ob.data, 1)[0], "its knots are shown"
        with pytest.raises(RuntimeError, match="Apply Construction"):
            run('move_knot', knot=4, parameter=0.2)
        assert ob.data.splinewright.value == before


def test_what_was_changed_by_hand_is_refused():
    ob, before, _ = added('nurbs patch', 'U', True)
    ob.data.vertices[0].co.x += 1
    ob.data.update()
    with pytest.raises(RuntimeError, match="changed by hand"):
        run('move_knot', knot=5, parameter=0.15)
    assert value() == before


def in_a_row():
    """Two patches side by side, smooth, with the same knots along v."""
    knots, net = [0, 0, 0, 0, 1, 2, 2, 2, 2], np.zeros((7, 5, 3))
    net[..., 0], net[..., 1] = np.arange(7.0)[:, None], np.arange(5.0)
    net[1:-1, 1:-1, 2] = np.random.default_rng(4).uniform(size=(5, 3))
    u = [0, 0, 0, 0, 1, 1, 1, 1]
    return sc.PatchSet.from_patches([sc.NurbsPatch((3, 3), (u, knots), part) for part in (net[:4], net[3:])])


@pytest.mark.parametrize('is_net', (False, True))
def test_patches_that_share_a_border_stay_together_and_the_seam_holds(is_net):
    ob = add(in_a_row())
    op(bpy.ops.splinewright.hold_seam, first=1, first_side='u_end', second=2, second_side='u_start', continuity='G1')
    before = value()
    if is_net:
        enter()
    run('move_knot', piece=2, axis='V', knot=5, parameter=0.5, exact="0.5")
    after = value()
    assert after != before and all(after[i].knots[1][4] == 0.5 for i in range(2))
    found = sc.seam_continuity(after[0], 'u_end', after[1], 'u_start')
    assert max(found.gaps) < 1e-12 and max(found.angles) < 1e-6
    require_exact(shape())


def clicked(aimed, name='insert_here'):
    """(what the tool Insert Knot or another one returns for a click, what it reports)."""
    cls, said = getattr(bpy.types, f"SPLINEWRIGHT_OT_{name}"), []
    own = {key: vars(base)[key] for base in cls.__mro__[::-1] for key in ('clicked', 'done_at') if key in vars(base)}
    stand_in = type("Clicked", (), {**own, 'report': lambda self, kind, text: said.append((kind, text))})()
    return stand_in.clicked(aimed), said


def test_what_is_refused_at_a_click_is_a_report_and_no_traceback():
    curve = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 1, 1], np.random.default_rng(1).normal(size=(4, 3)))
    ob = add(curve, "one")
    before = ob.data.splinewright.value
    for name, word in (('insert_here', "multiplicity"), ('split_here', "u = 0")):
        result, said = clicked(part('ui.aim_overlay').Aim("one", 1, (0.0,), 'U'), name)
        assert result == {'CANCELLED'} and said[0][0] == {'ERROR'} and word in said[0][1] and "Traceback" not in said[0][1]
        assert ob.data.splinewright.value == before


def test_of_two_selected_shapes_one_gets_a_knot_where_it_is_meant_alone():
    """insert_here and the strip mean the shape at the mouse."""
    one, other = add(value_of('nurbs'), "one"), add(value_of('uniform'), "other")
    activate(one, other)
    before = {ob.name: ob.data.splinewright.value for ob in (one, other)}
    aim = part('ui.aim_overlay').Aim
    assert clicked(aim("one", 1, (0.15,), 'U'))[0] == {'FINISHED'}
    after = {name: bpy.data.objects[name].data.splinewright.value for name in before}
    assert len(after["one"].points) == len(before["one"].points) + 1 and after["other"] == before["other"]
    with pytest.raises(RuntimeError, match="none of these is not selected"):
        run('insert_knot', only="none of these", piece=1, parameter_u=0.15)
    assert bpy.data.objects["other"].data.splinewright.value == before["other"]


# Where the strip is --------------------------------------------------------------------------------


def region(kind, x, y, width, height):
    return SimpleNamespace(type=kind, x=x, y=y, width=width, height=height, as_pointer=lambda: 1)


#: A window as it opens: bars above, toolbar, a sidebar that is closed, the panel of the last operator.
WINDOW, TOOLS = region('WINDOW', 0, 79, 1057, 667), region('TOOLS', 0, 79, 60, 640)
AROUND = (region('HEADER', 0, 746, 1057, 27), region('TOOL_HEADER', 0, 719, 1057, 27), TOOLS,
          region('UI', 1056, 79, 1, 1))


@pytest.fixture
def context():
    """Of a 3D view, as Blender has one in background, and regions of ours."""
    screen = bpy.context.window_manager.windows[0].screen
    space = next(area for area in screen.areas if area.type == 'VIEW_3D').spaces.active
    bpy.context.scene.splinewright_sights.strip = True

    class Context(SimpleNamespace):
        object = property(lambda self: bpy.context.object)
        mode = property(lambda self: bpy.context.mode)
        scene = property(lambda self: bpy.context.scene)
        objects_in_mode = property(lambda self: bpy.context.objects_in_mode)

    yield Context(space_data=space, region=WINDOW, area=SimpleNamespace(regions=(*AROUND, WINDOW)),
                  preferences=SimpleNamespace(system=SimpleNamespace(ui_scale=1.0)))
    bpy.context.scene.splinewright_sights.property_unset('strip')
    state.moved_knot = None


def with_regions(context, *more, window=WINDOW):
    context.region, context.area = window, SimpleNamespace(regions=(*AROUND, *more, window))
    return context


def test_the_strip_lies_clear_of_what_else_is_there(context):
    add(patches.value_of('nurbs patch'))
    plain = strip.shown(context).box
    assert plain.left > 60 and plain.right < 1057 and 0 < plain.bottom < 20
    small, large = region('HUD', 65, 84, 168, 25), region('HUD', 65, 84, 300, 180)
    assert strip.shown(with_regions(context, small)).box == plain, "it stays where it is when that panel comes"
    assert strip.shown(with_regions(context, large)).box.left > 365
    beside = strip.shown(with_regions(context, region('UI', 800, 79, 257, 640))).box
    assert beside.right < 800
    shelf = strip.shown(with_regions(context, region('ASSET_SHELF', 0, 79, 1057, 100))).box
    assert shelf.bottom > 100
    narrow = region('WINDOW', 0, 79, 500, 667)
    above = strip.shown(with_regions(context, region('HUD', 65, 84, 168, 125), window=narrow)).box
    assert above.bottom >= 130 and above.left < 100
    for tiny in (region('WINDOW', 0, 79, 200, 667), region('WINDOW', 0, 79, 1057, 100)):
        assert strip.shown(with_regions(context, window=tiny)) is None


def test_both_directions_of_a_patch_have_their_own_bar(context):
    add(patches.value_of('nurbs patch'))
    found = strip.shown(context)
    upper, lower = found.boxes
    assert [bar.name for bar in found.bars] == ["u", "v"] and upper.bottom == lower.top
    for axis, box in enumerate(found.boxes):
        places = found.places(axis)
        assert box.left < places[0] and places[-1] < box.right
        hit = strip.hit(context, places[1] + 3, box.bottom + 5)
        assert (hit.axis, hit.mark, hit.value) == (axis, 1, found.bars[axis].values[1])
    assert strip.hit(context, 500, upper.top + 2) is None
    assert strip.hit(context, upper.left - 2, upper.bottom + 5) is None


def test_between_knots_is_a_short_parameter(context):
    add(value_of('uniform'))
    found = strip.shown(context)
    left, right = found.ends(0)
    hit = strip.hit(context, left + (right - left) * 0.5, found.box.bottom + 9)
    assert hit.mark is None or hit.value in found.bars[0].values
    hit = strip.hit(context, left + (right - left) * 0.5132, found.box.bottom + 9)
    assert hit.mark is None and len(repr(hit.value)) <= 5 and abs(hit.value - 0.5132 * 11) < 0.03


@pytest.mark.parametrize('kind, mark, is_patch', (('uniform', 5, False), ('nurbs patch', 2, True)))
def test_a_copy_is_inserted_on_a_knot_and_both_are_removed(context, kind, mark, is_patch):
    _, before, _ = added(kind, 'U', is_patch)
    for count in (2, 3, 2, 1):
        found = strip.shown(context)
        hit = strip.hit(context, found.places(0)[mark], found.boxes[0].bottom + 5)
        assert hit.bar.counts[mark] != count
        name, settings = ('insert_knot', {}) if count > hit.bar.counts[mark] else (
            'remove_knot', {'nearest': False, 'limited': True, 'tolerance': 1e-9})
        assert strip_keys._called(name, hit, times=1, **settings) == {'FINISHED'}
        assert strip.shown(context).bars[0].counts[mark] == count
    assert np.allclose(value().points, before.points, atol=1e-12)


@pytest.mark.parametrize('tolerance', (0.0, 1e-6))
def test_what_would_move_the_shape_too_far_stays(context, tolerance):
    _, before, _ = added('uniform', 'U', False)
    found = strip.shown(context)
    hit = strip.hit(context, found.places(0)[5], found.boxes[0].bottom + 5)
    words = "^shape: the knot cannot be removed within"
    with pytest.raises(part('core.base.failures').Refusal, match=words), blenders_refusals():
        strip_keys._called('remove_knot', hit, nearest=False, times=1, limited=True, tolerance=tolerance)
    assert value() == before


def test_nothing_is_shown_where_there_is_nothing_to_show(context):
    ob, _, _ = added('nurbs', 'U', False)
    assert strip.shown(context) is not None
    ob.select_set(False)
    assert strip.shown(context) is None, "verbs are done with what is selected"
    ob.select_set(True)
    for owner, switch in ((context.space_data.overlay, 'show_overlays'), (context.space_data, 'show_gizmo')):
        setattr(owner, switch, False)
        assert strip.shown(context) is None
        setattr(owner, switch, True)
    ob.hide_set(True)
    assert strip.shown(context) is None
    native_curve()
    assert strip.shown(context) is None
    bpy.ops.object.mode_set(mode='EDIT')
    assert strip.shown(context) is None
    bpy.ops.object.mode_set(mode='OBJECT')
    bpy.context.view_layer.objects.active = None
    assert strip.shown(context) is None


def test_a_damaged_shape_shows_none(context):
    ob, _, _ = added('nurbs', 'U', False)
    ob.data[store.KEY]['form'] = "nonsense"
    bpy.context.view_layer.update()
    part('bridge.data.file_state').look_again(ob.data)
    assert strip.shown(context) is None


def test_in_a_net_the_piece_of_the_selected_points_is_shown_and_elsewhere_that_in_hand(context):
    ob = add(value_of('many curves'))
    assert strip.shown(context).number == 1 and strip.shown(context).count == 4
    part('ui.active_shape').take(ob.data, 2)
    assert strip.shown(context).number == 2
    held = enter()
    rows = numbers_of(held).rows
    for number, piece in enumerate(store.read(shape().data).pieces, 1):
        select(held, *np.flatnonzero(np.isin(rows, piece.indices))[:2].tolist())
        assert strip.shown(context).number == number


def test_nothing_is_worked_out_where_nothing_changed(context):
    added('nurbs', 'U', False)
    assert strip.shown(context).bars is strip.shown(context).bars
    first = strip.shown(context).bars
    run('move_knot', knot=5, parameter=0.15)
    assert strip.shown(context).bars is not first


def test_while_a_knot_is_moved_the_bar_reaches_as_far_as_when_it_began(context):
    ob, _, _ = added('uniform', 'U', False)
    span = strip.shown(context).spans
    state.moved_knot = strip.Moved(ob.data.name, 0, 11, span)
    run('move_knot', knot=12, parameter=50.0, exact="50.0")
    assert strip.shown(context).spans == span and strip.shown(context).bars[0].span == (0.0, 50.0)
    state.moved_knot = None
    assert strip.shown(context).spans == ((0.0, 50.0),)
