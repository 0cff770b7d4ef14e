"""The languages in Blender: what users read follows that of the preferences at once, and back; what code reads stays English."""

import json
from types import SimpleNamespace

import bpy
import numpy as np
import pytest

from shapes import add
from support import ADDON, part, splinecore as sc

words, failures, languages, reports, shelf, checking = (part(name) for name in (
    'core.base.words', 'core.base.failures', 'ui.languages', 'ui.operators.reports', 'bridge.lessons.shelf', 'core.lessons.checking'))
#: For each language what stands in its file for some texts.
SAID = {
    'it_IT': ("Inserisci nodo", "Aggiunge un nodo, e con esso", "Esercitazioni", "Taglio degli angoli", "la forma ha 1 pezzo, non ce n'è uno di numero 7",
              "Nodi inseriti: Curve", "knots ha 2 valori, ne servono almeno 5 per il grado 3"),
    'pl_PL': ("Wstaw węzeł", "Dodaj węzeł, a z nim", "Lekcje", "Obcinanie narożników", "kształt ma 1 część, nie ma części nr 7",
              "Wstawiono węzły: Curve", "knots ma wartości: 2, dla stopnia 3 potrzeba co najmniej 5"),
    'ru_RU': ("Вставить узел", "Добавить узел, а с ним", "Уроки", "Срезание углов", "в фигуре 1 кусок, куска с номером 7 нет",
              "Узлы вставлены: Curve", "knots содержит 2 значений, для степени 3 нужно не менее 5"),
    'en_US': ("Insert Knot", "Add a knot, and with it", "Lessons", "Corner Cutting", "the shape has 1 piece, there is none of number 7",
              "Inserted knots into Curve", "knots has 2 values, at least 5 are needed for degree 3"),
}


def has_languages():
    """False in builds of Blender that come without translations, such as the module bpy."""
    try:
        bpy.context.preferences.view.language = 'en_US'
    except TypeError:
        return False
    return True


in_languages = pytest.mark.skipif(not has_languages(), reason="this Blender comes without languages")


@pytest.fixture(autouse=True)
def as_it_was():
    view = bpy.context.preferences.view
    yield
    if not has_languages():
        return
    view.language = 'en_US'
    view.use_translate_interface = view.use_translate_tooltips = False


def switch(language):
    view = bpy.context.preferences.view
    view.language = language
    view.use_translate_interface = view.use_translate_tooltips = True
    languages.give()                    # a window is told that the language is another


def refused():
    """What Delete Pieces says of a piece that is not there."""
    ob = add(sc.BezierCurve([(0, 0, 0), (1, 0, 0), (1, 1, 0)]))
    bpy.context.view_layer.objects.active = ob
    with pytest.raises(RuntimeError) as error:
        bpy.ops.splinewright.delete_pieces('EXEC_DEFAULT', True, piece=7)
    return str(error.value)


def reported(said):
    heard = []
    reports.finished(SimpleNamespace(report=lambda kinds, text: heard.append(text)), said)
    return heard[0]


def error_of_the_library():
    with pytest.raises(sc.Error) as error:
        sc.NurbsCurve(3, [0, 1], [(0, 0, 0)] * 4)
    return failures.sentence(error.value)


def shown():
    translate = bpy.app.translations
    return (translate.pgettext_iface("Insert Knot", "Operator"),
            translate.pgettext_tip("Add a knot, and with it control points; the shape stays the same"),
            translate.pgettext_iface("Lessons"),
            words.say(next(lesson.title for lesson in shelf.all_lessons().values() if lesson.title == "Corner Cutting")),
            refused(),
            reported(reports.Report(words.phrase("Inserted knots into {what}", what="Curve"))),
            words.say(error_of_the_library()))


@in_languages
def test_all_texts_change_with_the_language_and_back():
    for language in ('pl_PL', 'en_US', 'ru_RU', 'it_IT', 'pl_PL', 'en_US'):
        switch(language)
        for text, wanted in zip(shown(), SAID[language]):
            assert wanted in text, language


@in_languages
def test_texts_stay_english_where_the_interface_is_not_translated():
    switch('pl_PL')
    bpy.context.preferences.view.use_translate_interface = False
    assert words.say("Corner Cutting") == "Corner Cutting"


@in_languages
def test_code_reads_english_in_any_language():
    switch('ru_RU')
    assert bpy.types.SPLINEWRIGHT_PT_lessons.bl_label == "Lessons"
    assert error_of_the_library() == "knots has 2 values, at least 5 are needed for degree 3"
    assert any(lesson.title == "Corner Cutting" for lesson in shelf.all_lessons().values())


@in_languages
def test_nothing_stays_behind():
    languages.unregister()
    try:
        bpy.context.preferences.view.language = 'pl_PL'
        bpy.context.preferences.view.use_translate_interface = True
        assert bpy.app.translations.pgettext_iface("Insert Knot", "Operator") == "Insert Knot"
        assert words.say("Corner Cutting") == "Corner Cutting"
    finally:
        languages.register()
    assert words.say("Corner Cutting") == "Obcinanie narożników"


def test_every_text_of_blenders_classes_is_in_the_catalog():
    """Labels, tooltips, properties and their choices, as Blender has them; formulas and names in other ways are none."""
    catalog = languages._FOLDER / "pl.po"
    known = part('core.base.catalog').read(catalog.read_text(encoding='utf-8').replace('msgstr ""\n\n', 'msgstr "x"\n\n')
                                           .replace('] ""\n', '] "x"\n'))
    texts = {text for _, text in known.texts}
    lacking = {text for text in class_texts() if text not in texts}
    assert lacking == set(), json.dumps(sorted(lacking), ensure_ascii=False, indent=0)


def class_texts():
    """Of operators and panels: what has words and is not one of Blender's own."""
    for cls in subclasses(bpy.types.Operator):
        module, _, name = cls.bl_idname.replace('_OT_', '.').lower().partition('.')
        rna = getattr(getattr(bpy.ops, module), name).get_rna_type()
        yield from filter(is_wordy, (cls.bl_label, getattr(cls, 'bl_description', "")))
        for each in rna.properties:
            if each.identifier not in BLENDERS:
                yield from filter(is_wordy, (each.name, each.description))
    for cls in subclasses(bpy.types.Panel):
        yield from filter(is_wordy, (cls.bl_label,))


#: Properties that Blender's helpers bring.
BLENDERS = ('rna_type', 'align', 'location', 'rotation', 'check_existing', 'filepath', 'directory', 'files', 'filter_glob', 'view_align')


def subclasses(cls):
    for each in cls.__subclasses__():
        if each.__module__.startswith(ADDON) and hasattr(each, 'bl_rna') and getattr(each, 'is_registered', False):
            yield each
        yield from subclasses(each)


def is_wordy(text):
    return " " in (text or "") and sum(map(str.isalpha, text)) > 4 and not text.startswith("W =")


def given():
    """Languages whose files were read, and those whose texts Blender has."""
    return languages.of.cache_info().currsize, set(languages._given)


@pytest.fixture
def started_anew():
    languages.unregister()
    bpy.context.preferences.view.language = 'en_US'
    languages.register()


@in_languages
def test_a_file_is_read_when_its_language_is_spoken(started_anew):
    assert given() == (0, set())
    assert words.say("Corner Cutting") == "Corner Cutting" and given() == (0, set())
    switch('ru_RU')
    assert given() == (1, {'ru_RU'})
    switch('pl_PL')
    assert given() == (2, {'ru_RU', 'pl_PL'})
    assert bpy.app.translations.pgettext_iface("Insert Knot", "Operator") == "Wstaw węzeł"


@in_languages
def test_a_language_that_was_chosen_before_is_there_at_the_start(started_anew):
    switch('it_IT')
    languages.unregister()
    languages.register()
    assert given() == (1, {'it_IT'})
    assert bpy.app.translations.pgettext_iface("Insert Knot", "Operator") == "Inserisci nodo"


@in_languages
def test_what_is_written_beside_points_follows_the_language(monkeypatch):
    overlay, labels, drawn = part('ui.labels_overlay'), part('core.formulas.labels'), []
    monkeypatch.setattr(overlay, 'blf', SimpleNamespace(size=lambda *_: None, position=lambda *_: None, dimensions=lambda *_: (10.0, 10.0),
                                                        draw=lambda _font, text: drawn.append(text)))
    many = part('core.shape.definition').from_value(sc.NurbsPatch((1, 1), (np.r_[0, np.arange(30.0), 29],) * 2, np.zeros((30, 30, 3))))
    label, = labels.of(many)
    switch('pl_PL')
    overlay._draw_label(label, 0.0, 0.0, 1.0)
    overlay._draw_label(labels.Label("P", "0,1", "  w = 2", (0, 0, 0)), 0.0, 0.0, 1.0)
    assert drawn[0] != str(label.after) and "956" in drawn[0] and drawn[1:] == ["P", "0,1", "  w = 2"]
