"""What a user does by keys alone: menus by their words, F3, transforms with numbers; saving and opening again."""

from types import SimpleNamespace

import bpy

from window import View, empty_file, part, redrawn, until

KEYS = {**{str(i): name for i, name in enumerate(('ZERO', 'ONE', 'TWO', 'THREE', 'FOUR', 'FIVE', 'SIX', 'SEVEN', 'EIGHT', 'NINE'))},
        '.': 'PERIOD', '-': 'MINUS', ' ': 'SPACE'}


class _Entries:
    """A layout that notes what can be chosen in it, in order."""

    def __init__(self, context):
        self.found, self.operator_context = [], context

    def operator(self, name, text=None, **_):
        room, _, own = name.partition(".")
        self.found.append(text or getattr(getattr(bpy.ops, room), own).get_rna_type().name if own else text)
        return SimpleNamespace()

    def menu(self, name, text=None, **_):
        self.found.append(text or getattr(bpy.types, name).bl_label)

    def prop(self, data, name, text=None, **_):
        self.found.append(text or name)

    def operator_menu_enum(self, name, _, text=None, **__):
        self.operator(name, text)

    def row(self, **_):
        return self

    column = row

    def separator(self, **_):
        pass

    def label(self, **_):
        pass


def entries(menu, context='INVOKE_REGION_WIN'):
    """The words of the entries of a menu that is drawn by Python."""
    layout = _Entries(context)
    draw = getattr(bpy.types, menu).draw
    for function in getattr(draw, '_draw_funcs', [draw]):
        function(SimpleNamespace(layout=layout), bpy.context)
    return layout.found


#: Blender's own, by the words of their entries.
_BLENDERS = {"Curve": 'VIEW3D_MT_curve_add', "Surface": 'VIEW3D_MT_surface_add'}


def _opened(menu, name):
    """The name of the menu that an entry of another one opens, in words."""
    table = part('ui.menu_table')
    if menu == 'VIEW3D_MT_add':
        return _BLENDERS[name]
    if menu in _BLENDERS.values():
        return (table.ADD_CURVE if menu == 'VIEW3D_MT_curve_add' else table.ADD_SURFACE).idname
    own = next(own for own in table.MENUS if own.idname == menu)
    return next(entry.idname for entry in own.entries if isinstance(entry, table.Menu) and entry.label == name)


def add(view, path):
    """Steps that choose what a path of words below Shift+A says: Curve > NURBS > Circle."""
    yield from _chosen(view, 'VIEW3D_MT_add', path, lambda: view.press('A', shift=True))


def command(view, path):
    """Steps that choose what a path of words below NURBS says, the menu of the header: Modify > Rebuild."""
    def opened():
        with view.override():
            bpy.ops.wm.call_menu(name=part('ui.menu_table').OBJECT.idname)
    yield from _chosen(view, part('ui.menu_table').OBJECT.idname, path, opened)


def _chosen(view, menu, path, opens):
    names, menus = path.split(" > "), []
    with view.override():
        for i, name in enumerate(names):
            menus.append(entries(menu, 'INVOKE_REGION_WIN' if i else 'EXEC_REGION_WIN'))
            menu = _opened(menu, name) if i + 1 < len(names) else None
    opens()
    yield from redrawn()
    for i, (name, found) in enumerate(zip(names, menus)):
        for key in ['HOME', *['DOWN_ARROW'] * found.index(name), 'RET' if i == len(names) - 1 else 'RIGHT_ARROW']:
            view.press(key)
            yield from redrawn()
    yield from redrawn()


def search(view, words):
    """Steps that press F3, type words and take what is found first."""
    view.press('F3')
    yield from redrawn()
    yield from redrawn()
    for letter in words.lower():
        view.press(KEYS.get(letter, letter.upper()), letter)
    yield from redrawn()
    yield from redrawn()
    view.press('RET')
    yield from redrawn()
    yield from redrawn()


def keys(view, text):
    """Steps that press keys as they are written: "G Z 0.5 Enter", "Ctrl+Z"."""
    for word in text.split():
        if word.lstrip('-').replace('.', '', 1).isdigit():
            for digit in word:
                view.press(KEYS[digit], digit)
            continue
        *modifiers, key = word.split("+")
        key = {'Enter': 'RET', 'Tab': 'TAB', 'Esc': 'ESC', 'Click': 'LEFTMOUSE'}.get(key, key)
        view.press(key, **{modifier.lower(): True for modifier in modifiers})
        if modifiers or key in ('TAB', 'E'):
            yield from redrawn()
    yield from redrawn()


def typed(view, field, text):
    """Steps that give a field of the sidebar a number."""
    yield from view.go_to_field(field)
    view.press('RET')
    yield from redrawn()
    for letter in text:
        view.press(KEYS[letter], letter)
    view.press('RET')
    yield from redrawn()
    view.move(420, 420)


def sidebar(view):
    """Steps that open the tab of the add-on."""
    view.open_sidebar()
    yield from redrawn()
    yield from view.show_tab("NURBS", (1045, 538))


def select_all(view, count):
    """Steps that press A over so many objects."""
    view.press('A')
    yield from until(lambda: len(bpy.context.selected_objects) == count, "A selects all")


def see_all(view):
    """Steps after which all is in the view."""
    with view.override():
        bpy.ops.view3d.view_all(center=False)
    yield from redrawn()


def choose(view, *names):
    """Steps that select objects; the first one is the active one."""
    with view.override():
        bpy.ops.object.select_all(action='DESELECT')
        for name in names:
            bpy.data.objects[name].select_set(True)
        bpy.context.view_layer.objects.active = bpy.data.objects[names[0]]
        bpy.ops.ed.undo_push(message="select")
    yield from redrawn()


def saved_and_opened(view, path):
    """Steps that save by Ctrl+S, and open the file; then the View of what is there."""
    with view.override():
        bpy.ops.wm.save_as_mainfile(filepath=str(path))
    stamp = path.stat().st_mtime_ns
    view.press('S', ctrl=True)
    yield from until(lambda: path.stat().st_mtime_ns > stamp, "Ctrl+S saves")
    bpy.ops.wm.open_mainfile(filepath=str(path))
    yield from redrawn()
    return View()


def followed_when_opened(view, path, value, require, name, text):
    """Steps that save and open the file, and move an object by keys, which value() follows. require: called of both."""
    before = value()
    view = yield from saved_and_opened(view, path)
    assert value() == before
    require()
    view.move(420, 420)
    yield from choose(view, name)
    yield from keys(view, text)
    yield from until(lambda: value() != before, "it follows in the opened file")
    require()


def one_by_one(*stops):
    """Steps through an empty file: what a user does, each stop of which is told when it is over."""
    view = View()
    empty_file()
    view.move(420, 690)
    yield from redrawn()
    for stop in stops:
        yield from stop(view)
        print(stop.__name__, flush=True)
