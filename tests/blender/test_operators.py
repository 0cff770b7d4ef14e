"""What all operators have in common: names that say the verb, presets where there is something to keep."""

import ctypes
import re

import bpy
import pytest

import patches
from curves import run, value_of
from shapes import activate, add, op
from support import part

OPERATORS = sorted(name for name in dir(bpy.ops.splinewright))
VERBS = {'Accept', 'Add', 'Apply', 'Ask', 'Bake', 'Blend', 'Bring', 'Cap', 'Chamfer', 'Change', 'Check', 'Choose', 'Clamp', 'Clear', 'Collect', 'Convert',
         'Delete', 'Discard', 'Divide', 'Draw', 'Edit', 'Elevate', 'Explode', 'Export', 'Extend', 'Extract', 'Extrude', 'Fair',
         'Fill', 'Fillet', 'Finish', 'Fit', 'Flip', 'Import', 'Insert', 'Join', 'Key', 'Leave', 'Lock', 'Loft', 'Make', 'Mark',
         'Match', 'Measure', 'Mirror', 'Move', 'Normalize', 'Offset', 'Pick', 'Project', 'Pull', 'Rebuild', 'Reduce', 'Reload',
         'Remove', 'Reparameterize', 'Reverse', 'Revolve', 'Round', 'Separate', 'Set', 'Show', 'Smooth', 'Sort',
         'Split', 'Start', 'Swap', 'Sweep', 'Switch', 'Thicken', 'Trim', 'Unclamp', 'Unlock', 'Update', 'Write'}


def kind_of(name):
    return getattr(bpy.types, f"SPLINEWRIGHT_OT_{name}")


def kept(name):
    """The settings that Blender would keep in a preset."""
    properties = getattr(bpy.ops.splinewright, name).get_rna_type().properties
    return {p.identifier for p in properties
            if not (p.is_hidden or p.is_skip_save or getattr(p, 'is_skip_preset', False) or p.identifier == 'rna_type')}


@pytest.mark.parametrize('name', [name for name in OPERATORS if 'UNDO' in kind_of(name).bl_options])
def test_undo_history_shows_a_verb(name):
    assert kind_of(name).bl_label.split()[0] in VERBS, kind_of(name).bl_label


@pytest.mark.parametrize('name', OPERATORS)
def test_an_operator_offers_presets_where_it_has_settings(name):
    assert ('PRESET' in kind_of(name).bl_options) == bool(kept(name))


@pytest.mark.parametrize('name', OPERATORS)
def test_no_preset_holds_a_place_a_name_or_a_number_of_a_piece(name):
    properties = getattr(bpy.ops.splinewright, name).get_rna_type().properties
    numbers = {key for key in kept(name) if properties[key].type in ('INT', 'FLOAT', 'STRING', 'COLLECTION')}
    assert not numbers & {'filepath', 'directory', 'files', 'location', 'rotation', 'source', 'piece', 'first', 'second',
                          'parameter', 'parameter_u', 'parameter_v', 'knots', 'eye', 'slot'}


@pytest.mark.parametrize('name', ('import_bpt', 'export_bpt', 'import_json'))
def test_presets_of_files_hold_no_path_though_the_file_browser_shows_it_again(name):
    known = getattr(bpy.ops.splinewright, name).get_rna_type().properties['filepath']
    assert known.is_skip_preset if part('bridge.data.versions').has_skip_preset else known.is_skip_save


def test_what_is_done_is_an_undo_step_of_its_name(capfd):
    add(value_of('nurbs'))
    for name in ('insert_knot', 'split', 'to_bezier', 'edit_net', 'leave_net', 'add_basis'):
        op(getattr(bpy.ops.splinewright, name)) if name in ('edit_net', 'leave_net') else run(name)
    capfd.readouterr()
    bpy.context.window_manager.print_undo_steps()
    ctypes.CDLL(None).fflush(None)      # Blender's own buffer
    said = capfd.readouterr().out
    for label in ("Insert Knot", "Split", "Convert to Bezier", "Edit Control Points", "Finish Editing", "Add Basis Functions"):
        assert f"name='{label}'" in said


def test_buttons_leave_out_what_menus_say_already():
    text_of = part('ui.offered').text_of
    assert [text_of(name) for name in ('to_nurbs', 'to_bezier', 'standard_form', 'add_line', 'make_periodic')] == [
        "Convert to NURBS", "Convert to Bezier", "Normalize Weights", "Line", "Make Periodic"]


@pytest.mark.parametrize('name, settings', (('write_formulas', {'piece': 4}), ('add_basis', {'piece': 4})))
def test_the_piece_of_the_last_call_is_forgotten(name, settings):
    add(value_of('many curves'), "many")
    op(getattr(bpy.ops.splinewright, name), **settings)
    activate(add(value_of('nurbs'), "one"))
    assert op(getattr(bpy.ops.splinewright, name)) == {'FINISHED'}


def test_the_object_that_was_followed_last_is_forgotten():
    first, second = add(value_of('cubic'), "first"), add(value_of('nurbs'), "second")
    op(bpy.ops.splinewright.follow_object, source="first")
    activate(second)
    op(bpy.ops.splinewright.follow_object)
    assert part('bridge.recipes.recipes').read_inputs(bpy.context.object.data) == [second] != [first]


@pytest.mark.parametrize('name, make', (
    ('add_revolve', lambda: (add(value_of('cubic')),)), ('add_extrude', lambda: (add(value_of('cubic')),)),
    ('add_ruled', lambda: (add(value_of('cubic')), add(value_of('nurbs'), "other"))),
    ('extract_boundary', lambda: (add(patches.value_of('bicubic')),))))
def test_what_it_made_lets_its_settings_be_changed_and_is_no_ground_to_do_it_again(name, make):
    run_it = getattr(bpy.ops.splinewright, name)
    activate(*make())
    assert op(run_it) == {'FINISHED'} and run_it.poll()
    with pytest.raises(RuntimeError, match="Select"):
        op(run_it)
    bpy.ops.object.select_all(action='DESELECT')
    bpy.context.view_layer.objects.active = None
    assert not run_it.poll()


def test_no_parameter_hides_a_method_of_its_operator():
    """A property stands before a method of the same name: what calls it breaks in a window, where nothing else looks."""
    table, bases = part('core.recipes.table'), [part(f'ui.operators.{name}') for name in ('from_objects', 'add_recipe')]
    for cls in (cls for room in bases for cls in room.CLASSES):
        names = {parameter.name for parameter in cls.recipe.parameters}
        hidden = {name for name in names for base in cls.__mro__[1:] if callable(vars(base).get(name))}
        assert not hidden and cls.recipe.kind in table.RECIPES, (cls.recipe.kind, hidden)


#: Words that no other program has for what is meant.
ODD = ("comes of", "come of", "at one pace", "each for itself", "say how far", "go on as one another", "the other way over", "is one number")


def test_tooltips_have_plain_words():
    described = {cls.__name__: cls.bl_description for room in part('ui')._rooms() for cls in room.CLASSES if getattr(cls, 'bl_description', "")}
    described |= {recipe.kind: recipe.description for recipe in part('core.recipes.table').RECIPES.values()}
    assert len(described) > 200
    assert not [name for name, text in described.items() if any(words in text for words in ODD)]


#: Short words that Blender writes small inside of labels.
SMALL = {'a', 'an', 'the', 'and', 'or', 'nor', 'but', 'of', 'in', 'on', 'at', 'to', 'by', 'from', 'for', 'with', 'as', 'per', 'de'}
#: Labels that are mathematics or names of places in files, as they are written there.
SYMBOLS = re.compile(r"[a-z]|[xyz]\(.*\)|(First|Last) [uv]|[uv] (Start|End)|inputs|stage|de .*")


def is_capitalized(label):
    words = re.findall(r"[^\s(/]+", label)
    return all(word[0].isupper() or not word[0].isalpha() or word in SMALL and 0 < i < len(words) for i, word in enumerate(words))


def texts_shown():
    """(where, label, tooltip) of classes, properties and choices."""
    for cls in (cls for room in part('ui')._rooms() for cls in room.CLASSES):
        yield cls.__name__, getattr(cls, 'bl_label', ""), getattr(cls, 'bl_description', "")
        names = {name for base in cls.__mro__ for name in vars(base).get('__annotations__', {})}
        for prop in (cls.bl_rna.properties.get(name) for name in names):
            if prop is not None and not prop.is_hidden:
                yield f"{cls.__name__}.{prop.identifier}", prop.name, prop.description
                for item in prop.enum_items if prop.type == 'ENUM' else ():
                    yield f"{cls.__name__}.{prop.identifier}={item.identifier}", item.name, item.description


def test_labels_are_capitalized():
    assert not [(where, label) for where, label, _ in texts_shown() if label and not SYMBOLS.fullmatch(label) and not is_capitalized(label)]


@pytest.mark.parametrize('name', OPERATORS)
def test_every_setting_has_a_tooltip(name):
    """A choice, and the objects that Blender's dialog lists, have those of their items."""
    properties = [prop for prop in getattr(bpy.ops.splinewright, name).get_rna_type().properties if prop.identifier != 'rna_type']
    shown = [prop for prop in properties if not prop.is_hidden]
    assert not [prop.identifier for prop in shown if prop.type != 'ENUM' and not prop.description]
    assert not [(prop.identifier, item.identifier) for prop in shown if prop.type == 'ENUM' and not prop.description
                for item in prop.enum_items if not item.description]


def test_a_tooltip_is_a_sentence_of_twenty_words_at_most():
    tips = [(where, tip) for where, _, tip in texts_shown() if tip]
    assert len(tips) > 400
    assert not [(where, tip) for where, tip in tips if len(tip.split()) > 20 or ". " in tip or tip.endswith(".")]
