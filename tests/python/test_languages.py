"""The languages: one catalog of all that users read, translations that fit it, and messages that are patterns."""

import ast
import re
import sys
from collections import Counter
from types import SimpleNamespace

import pytest
from addon_core import ADDON, core
from filled_words import filled

pofile = pytest.importorskip("babel.messages.pofile")       # ./run installs it
sys.path.insert(0, str(ADDON.parent))
import make_languages                                       # noqa: E402

FOLDER = ADDON / "languages"
#: Of two curves that lie beside each other.
SIDE_BY_SIDE = SimpleNamespace(c=-1, g=-1)
LANGUAGES = ("it", "pl", "ru")
#: What is told to users, and the calls that tell it.
TELLING = re.compile(r"(Refusal|WrongKind|Contradiction|ChangedNet|DamagedNet|UnreadableDefinition|Cycle|\.fail|phrase|say|reports\.\w+|poll_message_set"
                     r"|status_text_set|draw_note|draw_problem|pop_up)$")


def entries(name):
    with (FOLDER / name).open("rb") as file:
        return {(message.context, message.id): message for message in pofile.read_po(file) if message.id}


TEMPLATE = entries("splinewright.pot")


def forms(message):
    return [text for text in (message.string if isinstance(message.string, (tuple, list)) else (message.string,)) if text]


def holes(text):
    return set(re.findall(r"(?<!\{)\{(\w*)[}:!]", text))


def originals(message):
    return message.id if isinstance(message.id, tuple) else (message.id,)


def test_the_catalog_has_all_texts_and_no_others():
    wanted = {(text.context, (text.text, text.plural) if text.plural else text.text) for text in make_languages.collected()}
    assert wanted - set(TEMPLATE) == set(), "./run languages writes the catalog"
    assert set(TEMPLATE) - wanted == set(), "./run languages writes the catalog"


@pytest.mark.parametrize('language', LANGUAGES)
def test_a_language_has_all_texts_of_the_catalog(language):
    assert set(entries(f"{language}.po")) == set(TEMPLATE), "./run languages brings new texts"


@pytest.mark.parametrize('language', LANGUAGES)
def test_translations_have_the_places_to_fill_of_the_english_texts(language):
    for message in entries(f"{language}.po").values():
        wanted = set().union(*map(holes, originals(message)))
        for text in forms(message):
            lacking = wanted - holes(text)
            assert holes(text) <= wanted and lacking <= {"count"}, (message.id, text)
            assert "count" not in lacking or isinstance(message.id, tuple), (message.id, text)


@pytest.mark.parametrize('language', LANGUAGES)
def test_translations_begin_and_end_as_the_english_texts(language):
    for message in entries(f"{language}.po").values():
        for text in forms(message):
            assert (text[0] == " ", text[-1] == " ") == (originals(message)[0][0] == " ", originals(message)[0][-1] == " "), (message.id, text)


@pytest.mark.parametrize('language', LANGUAGES)
def test_every_text_is_translated(language):
    missing = [message.id for message in entries(f"{language}.po").values() if not forms(message) or message.fuzzy]
    assert missing == [], len(missing)


#: Texts with a number that is never 1 where they are said, or is an upper bound.
NEVER_ONE = {
    "the net has {count} splines: join them (Make Segment) or delete all but one, the shape waits",
    "{name} would take {size:.1f} GB for {count} frames: bake fewer, or show it by fewer faces",
    "{count} users show the same data: make it single-user first", "{count} pieces have", "{count} edges rounded", "{count} Edges", "{count} objects",
    "the hull of {count} points was given up: rounding hides which of them are its corners", "the file has more than {count:,} characters",
    "a text of at most {count:,} characters is expected", "a list of 1 to {count} steps is expected", "it is one curve with {count} pieces",
    "{gone} of {count} points of the net were replaced, or given another tilt or radius: the shape has them where they were",
    "the surfaces meet in {count} curves: one is expected", "it is one patch with {count} pieces", "{count} shapes", "{count} shapes, ",
    "it has {count} corners: a hole has eight at most", "there are {count} knots, and none of number {number}", "{text} of {count} points",
    "The definitions of {count} shapes ended", "Exported {count} objects to", " of {count} files", "{count} points", "Weight of {count} points: {text}",
    "{count} objects are shown as the render needs", "{shapes}{count} control points, largest distance {error}",
    "Keys of {count} points that are gone go when the net is left"}


def test_a_noun_behind_a_number_has_its_form_for_one():
    """Unless more than one are told of, or more than are allowed."""
    alike = {text.text for text in make_languages.collected() if text.plural == text.text}
    plain = {text for text in alike if re.search(r"\{count[^}]*\} (more )?[A-Za-z]+s\b|\{count[^}]*\} (vertices|control points)", text)
             and not re.search("are the most|too many", text)}
    assert not plain - NEVER_ONE, plain - NEVER_ONE
    assert not NEVER_ONE - alike, "a text is gone"


def calls():
    for path in sorted(ADDON.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Call):
                yield path, node


def test_what_is_told_is_a_pattern_and_no_filled_string():
    """An f-string would be filled before it could be translated."""
    for path, call in calls():
        if TELLING.search(ast.unparse(call.func)):
            for argument in call.args:
                filled = [node for node in ast.walk(argument) if isinstance(node, ast.JoinedStr)]
                words = [part for node in filled for part in node.values if isinstance(part, ast.Constant) and re.search(r"[a-z]{3,}", part.value)]
                assert not words, (path, call.lineno, ast.unparse(argument))


def test_nothing_is_decided_by_the_words_of_an_error():
    """They may be said in another way, and in another language; what is in them a Phrase knows, and an error its class."""
    asked = ("str", "sentence", "say", "repr")
    for path in sorted(ADDON.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Compare) and any(isinstance(how, (ast.In, ast.NotIn, ast.Eq, ast.NotEq)) for how in node.ops):
                for said in (node.left, *node.comparators):
                    is_asked = isinstance(said, ast.Call) and ast.unparse(said.func) in asked and isinstance(said.args[0], ast.Name)
                    assert not (is_asked and said.args[0].id in ("error", "refused", "refusal", "why", "problem")), (path, node.lineno)


def test_patterns_have_what_fills_them():
    for path, call in calls():
        name = ast.unparse(call.func)
        if name.rpartition(".")[2] in ("phrase", "Refusal", "fail") and call.args and call.keywords and not any(
                keyword.arg is None for keyword in call.keywords):
            patterns = [node.value for node in ast.walk(call.args[0]) if isinstance(node, ast.Constant) and isinstance(node.value, str)]
            given = {keyword.arg for keyword in call.keywords} - {'one'}
            if isinstance(call.args[0], (ast.Constant, ast.IfExp)) and any(map(holes, patterns)):
                assert set().union(*map(holes, patterns)) <= given, (path, call.lineno)


#: (file, argument) where single words fill a pattern that are names of files and scripts, the same in every language.
NAMES = {("api.py", "name"), ("core/lessons/reading.py", "names")}


def test_no_word_of_english_fills_a_pattern():
    """It would stay English in other languages: there is a pattern for each, or the word is a phrase."""
    found = {(path.relative_to(ADDON).as_posix(), name): (line, words) for path in sorted(ADDON.rglob("*.py")) for line, name, words in filled(path)}
    assert {place: told for place, told in found.items() if place not in NAMES} == {}
    assert NAMES <= set(found)


def test_words_that_fill_a_pattern_are_found(tmp_path):
    source = tmp_path / "source.py"
    source.write_text("""
class A:
    thing = "Knot"
    def told(self):
        return phrase("{thing} is there", thing=self.thing)

def refuse(name, other):
    raise Refusal("the {name} is closed, {other}", name=name, other=other)

def all_of(given):
    kind = "tangent" if given else "the next one"
    for end in ('start', 'end'):
        refuse(end, other=given)
    return phrase("{kind} {count}", kind=kind, count=len(given))
""")
    assert [found[1:] for found in sorted(filled(source))] == [("thing", {"Knot"}), ("name", {"start", "end"}), ("kind", {"tangent"})]


RUSSIAN = r'''
msgid ""
msgstr "Plural-Forms: nplurals=3; plural=(n%10==1 && n%100!=11 ? 0 : n%10>=2 && n%10<=4 && (n%100<10 || n%100>=20) ? 1 : 2);\n"

msgctxt "*"
msgid "the shape has {count} piece, there is none of number {number}"
msgid_plural "the shape has {count} pieces, there is none of number {number}"
msgstr[0] "в форме {count} часть, номера {number} нет"
msgstr[1] "в форме {count} части, номера {number} нет"
msgstr[2] "в форме {count} частей, номера {number} нет"

msgctxt "*"
msgid "Inserted knots into {what}"
msgstr "Узлы вставлены: {what}"

msgctxt "*"
msgid "{a} values, at least {b} are needed"
msgstr "нужно не меньше {b}, а есть {a}"

msgctxt "*"
msgid "largest distance {error}"
msgstr "наибольшее отклонение {error}"

#, fuzzy
msgctxt "*"
msgid "unsure"
msgstr "наверное"

msgctxt "*"
msgid "within {error:.1e} of \"it\"\n"
msgstr "в пределах {error:.1e} от «it»\n"
'''


@pytest.fixture
def russian():
    words = core('base.words')
    spoken = core('base.catalog').read(RUSSIAN)
    words.use(lambda: spoken)
    yield spoken
    words.use(None)


@pytest.mark.parametrize('count, said', ((1, "1 часть"), (3, "3 части"), (5, "5 частей"), (21, "21 часть"), (112, "112 частей")))
def test_a_number_chooses_the_form_of_its_noun(russian, count, said):
    words = core('base.words')
    sentence = words.phrase("the shape has {count} pieces, there is none of number {number}",
                            one="the shape has {count} piece, there is none of number {number}", count=count, number=200)
    assert sentence == f"the shape has {count} piece{'s' if count > 1 else ''}, there is none of number 200"
    assert words.say(sentence) == words.say(str(sentence)) == f"в форме {said}, номера 200 нет"


def test_a_refusal_keeps_its_english_words(russian):
    failures, words = core('base.failures'), core('base.words')
    refusal = failures.Refusal("Inserted knots into {what}", what="Loft")
    assert str(refusal) == "Inserted knots into Loft"
    assert words.say(failures.sentence(refusal)) == "Узлы вставлены: Loft"
    named = failures.AboutInputs("{} values, at least {} are needed", 0, 1).named(["A", "B"])
    assert str(named) == "A values, at least B are needed"
    assert words.say(failures.sentence(named)) == "нужно не меньше B, а есть A"


def test_sentences_of_the_library_and_joined_ones_are_recognized(russian):
    say = core('base.words').say
    assert say("3 values, at least 4 are needed") == "нужно не меньше 4, а есть 3"
    assert say("Cube: 3 values, at least 4 are needed; largest distance 0.5") == "Cube: нужно не меньше 4, а есть 3; наибольшее отклонение 0.5"
    assert say("Inserted knots into Curve: largest distance 0.5") == "Узлы вставлены: Curve: наибольшее отклонение 0.5"


def test_what_is_not_translated_stays_as_it_is(russian):
    words = core('base.words')
    for text in ("unsure", "", "nothing like it", words.phrase("a {word} of {count}", word="b", count=2)):
        assert words.say(text) == text
    assert words.say(words.phrase('within {error:.1e} of "it"\n', error=0.001)) == "в пределах 1.0e-03 от «it»\n"


def test_nothing_is_translated_where_english_is_spoken():
    words = core('base.words')
    assert words.say("Inserted knots into Loft") == "Inserted knots into Loft"


def test_the_addon_reads_what_ordinary_tools_write():
    catalog = core('base.catalog')
    for language in LANGUAGES:
        read = catalog.read((FOLDER / f"{language}.po").read_text(encoding='utf-8'))
        wanted = {(message.context, originals(message)[0]): forms(message) for message in entries(f"{language}.po").values()
                  if forms(message) and not message.fuzzy}
        assert read.texts == wanted


def test_glossaries_of_terms_are_complete():
    """docs/languages.md has a table of terms in four languages."""
    page = (ADDON.parents[1] / "docs" / "languages.md").read_text()
    rows = [[cell.strip() for cell in line.strip("|\n ").split("|")] for line in page.splitlines() if line.startswith("| ")][2:]
    assert len(rows) >= 120 and all(len(row) == 4 and all(row) for row in rows)
    assert max(Counter(row[0] for row in rows).values()) == 1


def test_a_phrase_keeps_no_exception_alive():
    words = core('base.words')
    error = OSError("no such file")
    said = words.phrase("{name} cannot be read: {error}", name="a", error=error)
    assert said == "a cannot be read: no such file" and error not in said.arguments.values()


def test_a_count_is_recognized_by_its_digits_alone():
    words, catalog = core('base.words'), core('base.catalog')
    polish = catalog.read((FOLDER / "pl.po").read_text(encoding="utf-8"))
    words.use(lambda: polish)
    try:
        assert words.say("7 curves").startswith("7 ") and words.say("7 curves") != "7 curves"
        assert words.say("Odd curves") == "Odd curves" and words.say("NURBS curve") == "krzywa NURBS"
    finally:
        words.use(None)


@pytest.mark.parametrize('language', LANGUAGES)
def test_words_inside_messages_are_translated_with_them(language):
    words, spoken = core('base.words'), core('base.catalog').read((FOLDER / f"{language}.po").read_text(encoding='utf-8'))
    side, bounds, lofts = core('verbs.patch_curves').named_side, core('joints.held_bounds'), core('surfaces.lofts')
    lost = bounds.sentence([(core('joints.held').Held((0, 'u_end'), (1, 'v_start'), 'G2', 'both'), 'G1')])
    corners = words.listed([lofts._corners([1, 3], 4), lofts._corners([2], 0)])
    words.use(lambda: spoken)
    try:
        for text in (side('u_start'), side('end', 2), lost, corners, core('joints.continuity').in_words(SIDE_BY_SIDE, 3)):
            said = words.say(text)
            assert said != text and not re.search(r"\b(start|end|of|the|sections?|corners|gap)\b", said), (text, said)
        assert words.say(str(corners)) == words.say(corners)
    finally:
        words.use(None)
