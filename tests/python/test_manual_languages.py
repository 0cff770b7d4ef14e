"""The manual's pages in other languages: made from the English text as it is now, of the same parts, with the names of the interface."""

import re
import sys
from collections import Counter
from functools import cache
from pathlib import Path
from urllib.parse import unquote

import pytest

pofile = pytest.importorskip("babel.messages.pofile")       # ./run installs it
PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "addon"))
import manual_pages                                         # noqa: E402
from markdown_it import MarkdownIt                          # noqa: E402

LANGUAGES = [language for language in manual_pages.LANGUAGES if language != manual_pages.ENGLISH]
TRANSLATIONS = [(name, language) for name in manual_pages.PAGES for language in manual_pages.languages_of(name)[1:]]
#: What beginners, teachers and students read first.
FIRST = ("index", "five-minutes", "teaching")
#: Names that the catalog lacks, for they are Blender's, and titles of steps: in Italian, Polish and Russian.
OTHERS = {
    "Alt+click": ("Alt+clic", "Alt+kliknięcie", "Alt+щелчок"),
    "Ctrl+right click": ("Ctrl+clic destro", "Ctrl+kliknięcie prawym przyciskiem", "Ctrl+щелчок правой кнопкой"),
    "wheel": ("rotella", "Kółko", "Колёсико"),
    "Apply": ("Applica", "Zastosuj", "Применить"),
    "Bevel": ("Smussa", "Fazowanie", "Фаска"),
    "Delete": ("Cancella", "Usuń", "Удалить"),
    "Dissolve": ("Dissolvi", "Rozpuść", "Растворить"),
    "Dissolve Edges": ("Dissolvi Spigoli", "Rozpuść krawędzie", "Растворить рёбра"),
    "Edge": ("Spigolo", "Krawędź", "Ребро"),
    "Edge Loops": ("Anello di Spigoli (loop)", "Pętle krawędzi", "Петли рёбер"),
    "Export": ("Esporta", "Eksportuj", "Экспортировать"),
    "File": ("File", "Plik", "Файл"),
    "Import": ("Importa", "Importuj", "Импортировать"),
    "Inset Faces": ("Incassa Facce", "Wstawka lic", "Выдавить внутрь"),
    "Knife": ("Coltello", "Nóż", "Нож"),
    "Loop Cut and Slide": ("Taglia ad Anello e Scorri", "Przetnij pętlą i przesuń", "Разрезать петлёй со сдвигом"),
    "Overlays": ("Sovrapposizioni", "Nakładki", "Наложения"),
    "Spin": ("Rivoluzione", "Obracaj", "Прокрутить"),
    "Subdivide": ("Suddividi", "Pod podziel", "Подразделить"),
    "Toggle Cyclic": ("Attiva/disattiva Ciclico", "Przełącz cyklicznie", "Переключить замкнутость"),
    "Tools Split": ("Strumenti Dividi", "Narzędzia Podziel", "Инструменты Разделить"),
    "Transform": ("Trasforma", "Przekształć", "Трансформировать"),
    "Draw": ("Disegnare", "Rysuj", "Рисуем"),
    "Revolve": ("Ruotare", "Obróć", "Вращаем"),
    "Insert a knot": ("Inserire un nodo", "Wstaw węzeł", "Вставляем узел"),
    "Pull": ("Tirare", "Ciągnij", "Тянем"),
    "Lock G2": ("Bloccare G2", "Zablokuj G2", "Закрепляем G2"),
}
#: Keys, what is typed with them, and names that are the same in all languages.
KEYS = re.compile(r"(?:(?:Ctrl|Shift|Alt)\+)*(?:(?:Ctrl|Tab|Enter|Esc|F\d|numpad \d|NURBS|[A-Z]\d?|-?[\d.]+)(?: |$))+")


@cache
def tokens(name, language=manual_pages.ENGLISH):
    return MarkdownIt('commonmark').enable('table').parse(text(name, language))


def text(name, language):
    """A page as Markdown, without comments."""
    return re.sub(r"<!-- .*? -->", "", manual_pages.text(name, language), flags=re.S)


def structure(name, language=manual_pages.ENGLISH):
    """(what begins or ends, its tag) of headings, paragraphs, lists, rows and blocks of code."""
    return [(token.type, token.tag) for token in tokens(name, language) if token.type != 'inline']


def inline(name, language, kind):
    return [child for token in tokens(name, language) for child in token.children or () if child.type == kind]


def names(name, language=manual_pages.ENGLISH):
    """What a page sets in italics or bold, menus one by one, without the full stops of titles."""
    found = []
    for token in tokens(name, language):
        children = token.children or ()
        for i, child in enumerate(children):
            if child.type in ('em_open', 'strong_open'):
                end = next(j for j in range(i, len(children)) if children[j].type == child.type.replace("open", "close"))
                said = "".join(" " if one.type == 'softbreak' else one.content for one in children[i + 1:end])
                found += [part.rstrip(".:") for part in said.split(" > ")]
    return found


@cache
def catalog(language):
    """{English text: its translations}"""
    found = {}
    with (PROJECT / f"addon/splinewright/languages/{language}.po").open("rb") as file:
        for message in pofile.read_po(file):
            if message.id and isinstance(message.id, str):
                found.setdefault(message.id, set()).add(message.string)
    return found


def said_as(english, language):
    """What a name of the English page may be called in a language."""
    other = OTHERS.get(english)
    return catalog(language).get(english, set()) | ({other[LANGUAGES.index(language)]} if other else set())


def test_the_first_pages_are_there_in_every_language():
    for name in FIRST:
        assert set(manual_pages.languages_of(name)) == set(manual_pages.LANGUAGES), name


def test_folders_hold_translations_only():
    found = {path.relative_to(manual_pages.SOURCE) for path in manual_pages.SOURCE.rglob("*/*.md")}
    assert found == {Path(f"{manual_pages.address(*page)}.md") for page in TRANSLATIONS}


@pytest.mark.parametrize('name, language', TRANSLATIONS)
def test_a_translation_is_of_the_present_english_page(name, language):
    wanted = manual_pages.fingerprint(name)
    assert manual_pages.made_from(name, language) == wanted, (
        f"the English page changed: translate {manual_pages.path(name, language)} again, then write <!-- English: {wanted} --> below its title")


@pytest.mark.parametrize('name, language', TRANSLATIONS)
def test_a_translation_has_the_parts_of_the_english_page(name, language):
    own, english = structure(name, language), structure(name)
    first = next((i for i, (one, other) in enumerate(zip(own, english, strict=False)) if one != other), min(len(own), len(english)))
    assert own == english, f"another part begins where the English page has {english[first - 3:first + 3]}: {own[first - 3:first + 3]}"


@pytest.mark.parametrize('name, language', TRANSLATIONS)
def test_a_translation_shows_the_same_pictures_and_code(name, language):
    for kind, of in (('image', lambda token: Path(token.attrs['src']).name), ('code_inline', lambda token: token.content)):
        own, english = (Counter(map(of, inline(name, each, kind))) for each in (language, manual_pages.ENGLISH))
        assert own == english, (own - english, english - own)
    assert all(token.content for token in inline(name, language, 'image')), "a picture has no words for those who do not see it"


@pytest.mark.parametrize('name, language', TRANSLATIONS)
def test_a_translation_links_the_same_pages(name, language):
    def target(token):
        page, _, anchor = unquote(token.attrs['href']).partition("#")
        return Path(page).name, bool(anchor)
    own, english = (Counter(map(target, inline(name, each, 'link_open'))) for each in (language, manual_pages.ENGLISH))
    assert own == english, (own - english, english - own)


@pytest.mark.parametrize('name, language', TRANSLATIONS)
def test_a_translation_names_the_same_keys(name, language):
    own, english = (Counter(filter(KEYS.fullmatch, names(name, each))) for each in (language, manual_pages.ENGLISH))
    assert own == english, (own - english, english - own)
    own, english = (Counter(re.findall(r"\b(?:Ctrl|Shift|Alt|Tab|Enter|Esc|F\d)\b", text(name, each)))
                    for each in (language, manual_pages.ENGLISH))
    assert own == english, (own - english, english - own)


@pytest.mark.parametrize('name, language', TRANSLATIONS)
def test_names_are_those_of_the_translated_interface(name, language):
    own, english = (Counter(one for one in names(name, each) if not KEYS.fullmatch(one)) for each in (language, manual_pages.ENGLISH))
    known = set()
    for one, count in english.items():
        said = said_as(one, language)
        assert said, f"the interface has no {one}: the English page must say what it has"
        assert sum(own[other] for other in said) >= count, f"{one} is called {' or '.join(said)}"
        known |= said
    assert set(own) <= known, set(own) - known
    assert sum(own.values()) == sum(english.values()), "a name is there once more than in English"


def test_another_english_text_gives_another_fingerprint(monkeypatch):
    source, before = manual_pages.source, manual_pages.fingerprint("nets")
    for change, is_new in ((lambda text: text.replace("Undo", "undo").replace("\n\nA ", "\n\nOne "), True),
                           (lambda text: re.sub(r"<!-- F1: .*? -->", "<!-- F1: other -->", text, flags=re.S), False),
                           (lambda text: re.sub(r"(\w) (\w)", "\\1\n\\2", text), False)):
        monkeypatch.setattr(manual_pages, 'source', lambda name, language='en', change=change: change(source(name, language)))
        assert manual_pages.source("nets") != source("nets")
        assert (manual_pages.fingerprint("nets") != before) is is_new


def test_a_changed_section_of_the_readme_counts(monkeypatch):
    before, section = manual_pages.fingerprint("five-minutes"), manual_pages.section
    monkeypatch.setattr(manual_pages, 'section', lambda *of: section(*of) + "More.\n")
    assert manual_pages.fingerprint("five-minutes") != before


def test_a_name_in_other_words_is_found(monkeypatch):
    """The tests above fail where a page is not as it should be."""
    source = manual_pages.source
    with_fault = source("index", "pl").replace("*Kształt*", "*Bryła*").replace("**F1**", "F1").replace("- [Pięć", "[Pięć")
    monkeypatch.setattr(manual_pages, 'source', lambda name, language='en': with_fault if language == "pl" else source(name, language))
    tokens.cache_clear()
    try:
        for test in (test_names_are_those_of_the_translated_interface, test_a_translation_names_the_same_keys,
                     test_a_translation_has_the_parts_of_the_english_page):
            with pytest.raises(AssertionError):
                test("index", "pl")
    finally:
        tokens.cache_clear()
