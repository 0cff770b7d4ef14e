"""Menus of objects hold entries on what is selected, and no others."""

import ast
import inspect
import re
from types import SimpleNamespace

import bpy
import pytest

import patches
from curves import value_of
from layouts import Layout
from natives import native_curve
from shapes import VALUES, activate, add, enter, leave, op
from support import part

menus, menu_table, offered, tool_table = (part(f'ui.{name}') for name in ('menus', 'menu_table', 'offered', 'tool_table'))
#: Blender's own height of an entry and of a line between groups, in pixels at 100 %.
ENTRY, LINE = 20, 8
#: Operators that are not found in menus: of panels, keys, files, redo panels, lists and other modes.
ELSEWHERE = {
    'add_asset_library', 'add_inputs', 'add_lesson_step', 'add_sample', 'ask_question', 'axis_from_edge', 'check_answer',
    'check_lesson', 'collect_answers', 'edit_linked', 'export_bpt', 'export_figure', 'export_json', 'export_lesson', 'fit_patch', 'hold_joint',
    'hold_seam', 'import_bpt', 'import_json', 'insert_on_strip', 'leave_lesson', 'leave_result', 'lesson_step', 'manual',
    'measure_whole', 'move_input', 'move_knot', 'new_lesson', 'patch_through_grid', 'pick_answer', 'pick_for_operator', 'pie',
    'release_joint', 'release_seam', 'remove_input', 'remove_on_strip', 'reverse_inputs', 'select_seen', 'self_test',
    'set_moving', 'set_patch_material', 'show_inputs', 'show_lesson_folder', 'show_solution', 'sort_inputs', 'start_lesson',
    'start_lesson_file', 'tolerance_from_render', 'turn_input', 'update_late', 'update_now'}


class Drawn(list):
    """Stands for a UILayout: the names of what is put into it, with what lies below. `sizes`: of each menu, its entries and lines."""

    enabled = True

    def __init__(self):
        self.sizes, self._menus = {}, [""]

    def operator(self, name, **_):
        module, _, operator = name.partition(".")
        assert getattr(getattr(bpy.ops, module), operator).get_rna_type()
        self.append(operator if module == 'splinewright' else name)
        self.count('entries')
        return SimpleNamespace()

    def menu(self, name, **_):
        self.append(name)
        self.count('entries')
        self._menus.append(name)
        self.sizes[name] = {'entries': 0, 'lines': 0}
        getattr(bpy.types, name).draw(SimpleNamespace(layout=self), bpy.context)
        self._menus.pop()

    def count(self, what):
        if self._menus[-1]:
            self.sizes[self._menus[-1]][what] += 1

    def row(self, **_):
        return self

    def separator(self, **_):
        self.count('lines')


def drawn(menu):
    """What we add to one of Blender's menus, with what lies below."""
    layout = Drawn()
    for name, draw in (*menus._AT_ENDS, *menus._FIRST):
        if name == menu:
            draw(SimpleNamespace(layout=layout), bpy.context)
    return layout


CONTEXT, APPLY, CONVERT = "VIEW3D_MT_object_context_menu", "VIEW3D_MT_object_apply", "VIEW3D_MT_object_convert"
HEADER = "VIEW3D_MT_editor_menus"


def cube():
    bpy.ops.mesh.primitive_cube_add()
    return bpy.context.object


def test_a_text_can_be_made_exact():
    bpy.ops.object.text_add()
    assert "make_exact" in drawn(CONTEXT) and drawn(APPLY) == [] and drawn(CONVERT) == ["make_exact"]


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
    assert {"make_exact", "follow_object"} <= set(drawn(CONTEXT)) and drawn(HEADER)[0] == "SPLINEWRIGHT_MT_object"
    assert {"add_revolve", "add_extrude", "add_ruled"} <= set(drawn(CONTEXT))
    assert not {"edit_net", "to_native", "restore", "join", "raise_degree"} & set(drawn(CONTEXT))
    assert drawn(APPLY) == [] and drawn(CONVERT) == ["make_exact"]


@pytest.mark.parametrize('value, own, others', (
    (lambda: value_of('cubic'), {"SPLINEWRIGHT_MT_corners", "trim_curve", "add_revolve"},
     {"swap_uv", "join_patches", "SPLINEWRIGHT_MT_surface_from_surfaces"}),
    (lambda: patches.value_of('bicubic'), {"swap_uv", "extract_isocurve", "add_thickened"},
     {"SPLINEWRIGHT_MT_corners", "trim_curve", "add_revolve"})))
def test_a_shape_has_its_verbs(value, own, others):
    add(value())
    found = set(drawn(CONTEXT))
    assert own | {"edit_net", "set_knots", "use_tool", "to_native", "follow_object", "restore", "raise_degree", "split"} <= found
    assert not (others | {"make_exact"}) & found
    assert drawn(APPLY) == ["apply_transform"] and drawn(CONVERT) == ["to_native"]


def test_a_shape_and_a_cube_have_what_concerns_the_shape():
    shape, box = add(value_of('cubic')), cube()
    activate(box, shape)
    assert "raise_degree" in drawn(CONTEXT)


def follower():
    native_curve()
    op(bpy.ops.splinewright.follow_object)


def net(value):
    def begin():
        add(value())
        enter()
    return begin


STATES = {'nothing': lambda: None, 'curve': lambda: add(value_of('nurbs')), 'patch': lambda: add(patches.value_of('plain nurbs')),
          'follower': follower, 'curve of Blender': native_curve, 'curve net': net(lambda: value_of('nurbs')),
          'patch net': net(lambda: patches.value_of('plain nurbs'))}


@pytest.mark.parametrize('state', STATES)
def test_no_menu_has_more_than_14_entries_or_is_higher_than_500_pixels(state):
    STATES[state]()
    for name, _ in (*menus._AT_ENDS, *menus._FIRST):
        for menu, size in drawn(name).sizes.items():
            assert 0 < size['entries'] <= 14, (menu, size)
            assert ENTRY * (1 + size['entries']) + LINE * size['lines'] <= 500, (menu, size)


def test_whatever_is_selected_no_menu_can_grow_longer():
    for menu in menu_table.MENUS:
        assert sum(entry is not None for entry in menu.entries) <= 14, menu.name


def test_a_command_is_in_one_menu():
    nets = {entry.operator for entry in menu_table.operators_in(menu_table.NET)}
    objects = [entry.operator for entry in menu_table.operators_in(menu_table.OBJECT)]
    adding = [entry.operator for top in (menu_table.ADD_CURVE, menu_table.ADD_SURFACE) for entry in menu_table.operators_in(top)]
    from_objects = {entry.operator for menu in (menu_table.FROM_CURVES, menu_table.FROM_SURFACES) for entry in menu.entries}
    for kind in sorted(part('ui.object_kinds').ALL):
        of_kind = [entry.operator for entry in menu_table.operators_in(menu_table.OBJECT)
                   if entry.operator not in ('show_sight', 'use_tool') and entry.concerns is not None and kind in entry.concerns]
        assert len(of_kind) == len(set(of_kind)), kind
    assert set(adding) and {name for name in adding if adding.count(name) > 1} == {'add_filling'}, "for curves, and for surfaces"
    assert set(objects) & set(adding) == from_objects, "what is made of objects is under Add, too, in the same menus"
    of_tools = {tool.operator.partition(".")[2] for tool in tool_table.TOOLS.values()}
    assert {*objects, *adding, *nets} | of_tools | ELSEWHERE == set(dir(bpy.ops.splinewright))
    assert not of_tools & set(objects), "what takes clicks is a tool, and no entry beside it"


def test_no_entry_is_written_beside_the_table():
    """menus.py draws what the table has, and names no operator; toolbar and menu have the same tools, in the same groups."""
    names = [node.value for node in ast.walk(ast.parse(inspect.getsource(menus))) if isinstance(node, ast.Constant) and isinstance(node.value, str)]
    assert not [name for name in names if re.search(r"splinewright\.\w", name)]
    assert {place.menu for place in menu_table.PLACES} == {menu for menu, _ in (*menus._AT_ENDS, *menus._FIRST)}
    for modes, menu in ((('OBJECT',), menu_table.OBJECT_TOOLS), (('EDIT_MESH', 'EDIT_CURVE'), menu_table.NET_TOOLS)):
        groups = [[tool.name for tool in group if set(tool.modes) & set(modes) and not tool.is_always] for group in tool_table.GROUPS]
        names = [entry and entry.settings[0][1] for entry in menu.entries]
        assert names == [name for group in groups if group for name in (None, *group)][1:]


def test_files_are_imported_and_exported_by_entries_of_the_table():
    assert drawn("TOPBAR_MT_file_import") == ["import_bpt", "import_json"]
    assert drawn("TOPBAR_MT_file_export") == ["export_bpt", "export_json", "export_figure"]


def test_what_a_tool_does_is_called_as_the_tool():
    """In Undo History, and in menus: but for verbs where a tool has none."""
    labels = {tool.name: (tool.label, getattr(bpy.types, tool.operator.replace(".", "_OT_").replace("splinewright", "SPLINEWRIGHT")).bl_label)
              for tool in tool_table.TOOLS.values()}
    assert {name: label for name, (own, label) in labels.items() if label != own} == {
        'weight': "Change Weight", 'radius': "Change Radius", 'tilt': "Change Tilt", 'draw_on_surface': "Draw Curve on Surface"}
    assert not [name for name in dir(bpy.ops.splinewright)
                if "click" in getattr(bpy.ops.splinewright, name).get_rna_type().name.lower()], "a tool and a command are not told apart so"


def test_every_tool_is_found_by_f3():
    """By the entry of a menu that chooses it, or the operator's own entry, in each mode where the tool is."""
    for mode, top in (('OBJECT', menu_table.OBJECT), ('EDIT_MESH', menu_table.NET), ('EDIT_CURVE', menu_table.NET)):
        entries = [*menu_table.operators_in(top), *menu_table.operators_in(menu_table.ADD_CURVE)]
        chosen = {value for entry in entries if entry.operator == 'use_tool' for _, value in entry.settings}
        found = chosen | {tool.name for tool in tool_table.TOOLS.values() for entry in entries
                          if tool.operator == f"splinewright.{entry.operator}"}
        wanted = {tool.name for tool in tool_table.TOOLS.values() if mode in tool.modes}
        assert wanted <= found, (mode, wanted - found)
        assert {name for name in chosen if mode == 'OBJECT'} <= wanted, "none that is not there in this mode"


@pytest.mark.parametrize('value, own, others', (
    (lambda: value_of('cubic'), {'trim', 'fillet', 'split', 'pick'}, {'isocurve', 'edge', 'join', 'round_edges'}),
    (lambda: patches.value_of('bicubic'), {'isocurve', 'edge', 'join', 'round_edges', 'split', 'pick'}, {'trim', 'fillet', 'extend'})))
def test_the_menu_of_tools_has_those_for_what_is_selected(value, own, others):
    add(value())
    shown = {entry.settings[0][1] for entry in menu_table.OBJECT_TOOLS.entries if entry and menus._is_shown(entry, bpy.context)}
    assert own <= shown and not others & shown


@pytest.mark.parametrize('makes', (
    (lambda: add(value_of('nurbs')),), (lambda: add(patches.value_of('plain nurbs')),), (native_curve,),
    (lambda: add(value_of('nurbs'), "one"), lambda: add(value_of('nurbs'), "other")),
    (lambda: add(patches.value_of('plain nurbs'), "one"), lambda: add(patches.value_of('plain nurbs'), "other")),
    (lambda: add(value_of('nurbs'), "curve"), lambda: add(patches.value_of('plain nurbs'), "patch"))))
def test_what_can_be_made_of_what_is_selected_is_in_the_menu(makes):
    activate(*[make() or bpy.context.object for make in makes])
    found = drawn(CONTEXT)
    offered_now = {f"add_{recipe.kind}" for recipe in part('core.recipes.table').DERIVED if hasattr(bpy.types, f"SPLINEWRIGHT_OT_add_{recipe.kind}")
                   and getattr(bpy.ops.splinewright, f"add_{recipe.kind}").poll()}
    assert offered_now and not offered_now - set(found), offered_now - set(found)


def test_the_header_has_the_menu_while_there_is_something_to_do():
    assert drawn(HEADER) == []
    cube()
    assert drawn(HEADER) == []
    add(value_of('cubic'))
    assert drawn(HEADER)[0] == "SPLINEWRIGHT_MT_object"
    enter()
    assert drawn(HEADER)[0] == "SPLINEWRIGHT_MT_net"


def test_what_most_begin_with_stands_first_under_add():
    assert drawn("VIEW3D_MT_curve_add")[1:7] == ["add_line", "add_bezier_curve", "add_bezier_chain", "add_hermite_curve", "add_nurbs_curve",
                                                 "add_circle"]
    assert {"add_revolve", "add_extrude", "add_ruled"} <= set(drawn("VIEW3D_MT_surface_add"))


def test_under_add_all_that_is_made_of_objects_stands_whatever_is_selected():
    for begin in (lambda: None, cube):
        begin()
        assert {"add_loft", "add_thickened", "add_of_mesh"} <= set(drawn("VIEW3D_MT_surface_add"))


WORDS = ("zebra", "stripes", "continuity", "comb", "curvature")


@pytest.mark.parametrize('menu', ('SPLINEWRIGHT_MT_object', 'SPLINEWRIGHT_MT_net'))
def test_what_other_programs_call_it_is_found_by_f3(menu):
    """That looks through the entries of menus and of the menus in them."""
    ob = add(VALUES['nurbs patch']())
    if menu == 'SPLINEWRIGHT_MT_net':
        enter()
    shown = []
    layout = type("Entries", (Layout,), {'menu': lambda self, name, **_: shown.append(name)})()
    getattr(bpy.types, menu).draw(SimpleNamespace(layout=layout), bpy.context)
    assert 'SPLINEWRIGHT_MT_show' in shown
    entries = Layout()
    bpy.types.SPLINEWRIGHT_MT_show.draw(SimpleNamespace(layout=entries), bpy.context)
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


#: Of these F3 finds a tool first whose name begins so, which does nothing until a click.
_TOOLS_FIRST = {'add_rounded_edge', 'add_filling'}


def _with_paths(menu, path=()):
    """(path, label, operator) of the entries of a menu and of all below it."""
    for entry in menu.entries:
        if isinstance(entry, menu_table.Menu):
            yield from _with_paths(entry, (*path, menu.label))
        elif entry is not None:
            label = entry.text or getattr(bpy.ops.splinewright, entry.operator).get_rna_type().name
            yield (*path, menu.label), label, entry.operator


def test_f3_finds_no_other_command_first():
    """Of entries that have all words that are typed, in their menus' names or their own, Blender lists the shortest first. A command
    and the tool of the same name do the same."""
    entries = list(_with_paths(menu_table.OBJECT))
    wrong = []
    for path, label, operator in entries:
        words = [word.strip("()") for word in label.lower().split()]
        for other_path, other, _ in entries:
            found = " ".join((*other_path, other)).lower().split()
            is_shorter = len(" > ".join((*other_path, other))) <= len(" > ".join((*path, label)))
            if other != label and is_shorter and all(any(one.startswith(word) for one in found) for word in words):
                wrong.append((operator, label, other_path[-1], other))
    assert {operator for operator, *_ in wrong} <= _TOOLS_FIRST, wrong
    assert {menu for _, _, menu, _ in wrong} == {"Tools"}, wrong


@pytest.mark.parametrize('state, own, other', (('curve net', 'curve.subdivide', 'mesh.loopcut_slide'),
                                               ('patch net', 'mesh.loopcut_slide', 'curve.subdivide')))
def test_the_menu_of_nets_lists_blenders_own_gestures(state, own, other):
    """Each is there, and Blender has it."""
    STATES[state]()
    found = {entry.operator for entry in menu_table.GESTURES.entries if entry and menus._is_shown(entry, bpy.context)}
    assert own in found and other not in found and 'transform.translate' in found
    for name in found:
        module, _, operator = name.partition(".")
        assert getattr(getattr(bpy.ops, module), operator).get_rna_type().name
    leave()
    assert not [entry for entry in menu_table.GESTURES.entries if entry and menus._is_shown(entry, bpy.context)]


@pytest.mark.parametrize('mode', ('edit_curve', 'edit_mesh'))
def test_the_menu_of_nets_has_a_label_that_no_menu_of_blenders_has_beside_it(mode):
    beside = {cls.bl_label for name in dir(bpy.types) if name.startswith(f"VIEW3D_MT_{mode}") for cls in [getattr(bpy.types, name)]}
    assert "Control Points" in beside or mode != 'edit_curve'
    assert menu_table.NET.label not in beside
