"""Menus of objects hold entries on what is selected, and no others."""

from types import SimpleNamespace

import bpy
import pytest

import patches
from curves import value_of
from natives import native_curve
from layouts import Layout, drawn_by
from shapes import VALUES, activate, add, enter, op
from support import part

menus = part('ui.menus')


class Drawn(list):
    """Stands for a UILayout: the names of what is put into it."""

    enabled = True

    def operator(self, name, **_):
        self.append(name.split(".")[1])
        assert getattr(bpy.ops.splinewright, self[-1]).get_rna_type()
        return SimpleNamespace()

    def menu(self, name, **_):
        self.append(name)
        menu = getattr(bpy.types, name)
        menu.draw(SimpleNamespace(layout=self), bpy.context)

    def row(self, **_):
        return self

    def separator(self, **_):
        """Nothing is named."""


def drawn(menu):
    """What we add to one of Blender's menus, with what lies below."""
    layout = Drawn()
    for name, draw in (*menus._PLACES, *menus._TOPS):
        if name == menu:
            draw(SimpleNamespace(layout=layout), bpy.context)
    return layout


CONTEXT, APPLY, CONVERT = "VIEW3D_MT_object_context_menu", "VIEW3D_MT_object_apply", "VIEW3D_MT_object_convert"


def cube():
    bpy.ops.mesh.primitive_cube_add()
    return bpy.context.object


def test_a_text_can_be_made_exact():
    bpy.ops.object.text_add()
    assert [drawn(menu) for menu in (CONTEXT, APPLY, CONVERT)] == [["SPLINEWRIGHT_MT_object_context", 'make_exact'], [], ['make_exact']]


@pytest.mark.parametrize('make', (lambda: bpy.ops.object.empty_add(),
                                  lambda: bpy.ops.object.camera_add()))
def test_what_is_not_ours_to_change_has_no_entries(make):
    make()
    assert bpy.context.selected_objects
    assert [drawn(menu) for menu in (CONTEXT, APPLY, CONVERT)] == [[], [], []]


def test_a_mesh_can_become_patches():
    cube()
    assert [drawn(menu) for menu in (CONTEXT, APPLY, CONVERT)] == [[], [], ["add_of_mesh"]]


def test_nothing_selected_has_no_entries():
    activate(add(value_of('cubic')))
    bpy.context.object.select_set(False)
    assert [drawn(menu) for menu in (CONTEXT, APPLY, CONVERT)] == [[], [], []]


def test_a_curve_of_blender_is_made_exact_or_followed():
    native_curve()
    assert drawn(CONTEXT)[:3] == ["SPLINEWRIGHT_MT_object_context", "make_exact", "follow_object"]
    assert {"add_revolve", "add_extrude", "add_ruled"} <= set(drawn(CONTEXT))
    assert not {"edit_net", "to_native", "restore", "join", "raise_degree"} & set(drawn(CONTEXT))
    assert drawn(APPLY) == [] and drawn(CONVERT) == ["make_exact"]


@pytest.mark.parametrize('value, own, others', (
    (lambda: value_of('cubic'), {"SPLINEWRIGHT_MT_curve", "raise_degree", "add_revolve"},
     {"SPLINEWRIGHT_MT_patch", "patch_split"}),
    (lambda: patches.value_of('bicubic'), {"SPLINEWRIGHT_MT_patch", "patch_split"},
     {"SPLINEWRIGHT_MT_curve", "raise_degree", "add_revolve"})))
def test_a_shape_has_its_verbs(value, own, others):
    add(value())
    found = set(drawn(CONTEXT))
    assert own | {"edit_net", "set_knots", "pick_piece", "to_native", "follow_object", "restore"} <= found
    assert not (others | {"make_exact"}) & found
    assert drawn(APPLY) == ["apply_transform"] and drawn(CONVERT) == ["to_native"]


def test_a_shape_and_a_cube_have_what_concerns_the_shape():
    shape, box = add(value_of('cubic')), cube()
    activate(box, shape)
    assert "raise_degree" in drawn(CONTEXT)


def test_the_object_menu_holds_everything():
    cube()
    found = set(drawn("VIEW3D_MT_object"))
    assert {"edit_net", "make_exact", "raise_degree", "patch_split", "add_ruled", "detach"} <= found


def test_no_operator_stands_twice_in_a_menu():
    add(value_of('cubic'))
    for name, _ in menus._PLACES:
        found = [entry for entry in drawn(name) if entry != 'show_sight']       # one for each overlay
        assert len(found) == len(set(found)), name


def test_what_most_begin_with_stands_first_under_add():
    assert drawn("VIEW3D_MT_curve_add")[1:7] == ["add_line", "add_bezier_curve", "add_bezier_chain", "add_nurbs_curve",
                                                 "add_circle", "add_arc"]
    assert {"add_revolve", "add_extrude", "add_ruled"} <= set(drawn("VIEW3D_MT_surface_add"))


def test_offset_is_among_the_tools_of_curves():
    """Also of a circle, which its numbers make: it leaves that as it is."""
    op(bpy.ops.splinewright.add_circle)
    layout = drawn_by(part('ui.curve_tools').SPLINEWRIGHT_PT_curve_tools, bpy.context)
    assert "splinewright.add_offset" in layout.operators and "splinewright.add_offset" not in layout.disabled
    assert op(bpy.ops.splinewright.add_offset) == {'FINISHED'}


WORDS = ("zebra", "stripes", "continuity", "comb", "curvature")


@pytest.mark.parametrize('menu', ('SPLINEWRIGHT_MT_object', 'SPLINEWRIGHT_MT_net'))
def test_what_other_programs_call_it_is_found_by_f3(menu):
    """That looks through the entries of menus and of the menus in them."""
    ob = add(VALUES['nurbs patch']())
    if menu == 'SPLINEWRIGHT_MT_net':
        enter()
    shown = []
    layout = type("Entries", (Layout,), {'menu': lambda self, name, **_: shown.append(name)})()
    getattr(menus, menu).draw(SimpleNamespace(layout=layout), bpy.context)
    assert 'SPLINEWRIGHT_MT_sights' in shown
    entries = Layout()
    menus.SPLINEWRIGHT_MT_sights.draw(SimpleNamespace(layout=entries), bpy.context)
    for word in WORDS:
        assert any(word in text.lower() for text in entries.texts), word
    chosen = bpy.context.scene.splinewright_sights
    for sight, name in (('ZEBRA', "stripes"), ('COMB', "comb"), ('CURVATURE', "curvature")):
        assert op(bpy.ops.splinewright.show_sight, sight=sight) == {'FINISHED'} and getattr(chosen, name)
        assert op(bpy.ops.splinewright.show_sight, sight=sight) == {'FINISHED'} and not getattr(chosen, name)
    op(bpy.ops.splinewright.show_sight, sight='ZEBRA')
    op(bpy.ops.splinewright.show_sight, sight='REFLECTION')
    assert chosen.stripes and chosen.stripe_kind == 'REFLECTION', "another kind, not off"
    assert op(bpy.ops.splinewright.show_sight, sight='CONTINUITY') == {'FINISHED'} and ob.data.splinewright.show_seams
