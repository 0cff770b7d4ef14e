"""The manual is made of the README and of its own pages, in all languages, and reads without a network; the zip has the addresses that are known."""

import html.parser
import io
import posixpath
import re
import sys
import tomllib
from pathlib import Path

import pytest
from PIL import Image

PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "addon"))
import make_manual
import make_zip
import manual_pages

#: (name, language) of every page.
ALL = [(name, language) for name in manual_pages.PAGES for language in manual_pages.languages_of(name)]


@pytest.fixture(scope='module')
def files():
    return dict(make_manual.content())


class Page(html.parser.HTMLParser):
    """Anchors, addresses and text of a page; every tag is closed."""

    VOID = {'meta', 'link', 'img', 'br', 'hr'}

    def __init__(self, text):
        super().__init__()
        self.anchors, self.addresses, self.texts, self.open = [], [], [], []
        self.feed(text)
        assert not self.open, self.open

    def handle_starttag(self, tag, attributes):
        known = dict(attributes)
        self.anchors += [known['id']] if 'id' in known else []
        self.addresses += [known[name] for name in ('href', 'src') if name in known]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.texts.append(data)


def page_of(files, name, language):
    return Page(files[f"{manual_pages.address(name, language)}.html"].decode())


def led_to(name, language, address):
    """A page or picture from the manual's folder that a page has the address of."""
    here = f"{manual_pages.address(name, language)}.html"
    return posixpath.normpath(posixpath.join(posixpath.dirname(here), address.partition("#")[0] or posixpath.basename(here)))


@pytest.mark.parametrize('name, language', ALL)
def test_every_page_is_whole_and_leads_to_all_others(name, language, files):
    page = page_of(files, name, language)
    others = {f"{manual_pages.address(other, language if language in manual_pages.languages_of(other) else 'en')}.html" for other in manual_pages.PAGES}
    assert others <= {led_to(name, language, address) for address in page.addresses}
    assert len(set(page.anchors)) == len(page.anchors), f"{name} has an anchor twice"
    assert len("".join(page.texts)) > 600, f"{name} is empty"


def test_all_pages_are_made(files):
    assert {path for path in files if path.endswith(".html")} == {f"{manual_pages.address(*page)}.html" for page in ALL}


def test_nothing_of_the_manual_lies_elsewhere(files):
    brought = {"../LICENSE", "../CHANGELOG.md"}
    for name, language in ALL:
        for address in page_of(files, name, language).addresses:
            path = led_to(name, language, address)
            assert path in files or path in brought, f"{language}/{name} asks for {address}"
    assert "url(" not in files["style.css"].decode() and "@import" not in files["style.css"].decode()
    assert not any(path.endswith(".js") for path in files)


@pytest.mark.parametrize('name, language', ALL)
def test_a_page_says_its_language_and_leads_to_the_others_at_its_top(name, language, files):
    text = files[f"{manual_pages.address(name, language)}.html"].decode()
    assert re.search(r'<html lang="(.*?)">', text)[1] == language
    top = re.search(r'<main>\n(.*?)<h1 ', text, re.S)[1]
    others = [other for other in manual_pages.languages_of(name) if other != language]
    links = re.findall(r'<a href="(.*?)" hreflang="(.*?)" lang="(.*?)">(.*?)</a>', top)
    assert [(led_to(name, language, address), *said) for address, *said in links] == [
        (f"{manual_pages.address(name, other)}.html", other, other, manual_pages.LANGUAGES[other]) for other in others]
    assert (manual_pages.LANGUAGES[language] in top) is bool(others)


@pytest.mark.parametrize('name, language', [page for page in ALL if page[1] != 'en'])
def test_a_translation_has_the_anchors_of_the_english_page(name, language, files):
    assert page_of(files, name, language).anchors == page_of(files, name, 'en').anchors


@pytest.mark.parametrize('language', manual_pages.IN_ENGLISH)
def test_a_translation_says_which_pages_are_in_english(language, files):
    texts = [files[f"{manual_pages.address(*page)}.html"].decode().partition("<h1 ")[2] for page in ALL if page[1] == language]
    after = [found for text in texts for found in re.findall(r'<a href="\.\./[\w-]+\.html[^"]*">[^<]*</a>(.{20})', text, re.S)]
    assert len(after) > 10 and all(text.startswith(f" ({manual_pages.IN_ENGLISH[language]})"[:20]) for text in after), after


def test_pictures_are_those_of_the_readme_and_small(files):
    pictures = {path: data for path, data in files.items() if path.startswith("pictures/")}
    assert len(pictures) >= 12 and sum(map(len, pictures.values())) < 1_000_000
    for path, data in pictures.items():
        with Image.open(io.BytesIO(data)) as picture:
            assert picture.format == 'WEBP' and 300 < picture.width <= 960, path


def test_sections_of_the_readme_are_there_word_for_word(files):
    def words(text):
        return " ".join(re.findall(r"\w+", text))
    readme = (PROJECT / "README.md").read_text()
    section = re.search(r"^## Five minutes\n(.*?)^## ", readme, re.S | re.M)[1]
    plain = re.sub(r"!\[(.*?)\]\(.*?\)|```python|```|^\d+\. ", "", section, flags=re.M)
    assert words(plain) in words("".join(Page(files["five-minutes.html"].decode()).texts))


def test_the_same_sources_give_the_same_bytes(files):
    assert dict(make_manual.content()) == files


@pytest.mark.parametrize('text, what', (
    ("# A\n[b](nets.md#nowhere)\n", "nowhere"),
    ("# A\n![b](nowhere.png)\n", "nowhere.png"),
    ("# A\n<!-- README: Nowhere -->\n", "Nowhere"),
    ("# A\n<b>x</b>\n\n<div>\n</div>\n", "div"),
))
def test_what_leads_nowhere_is_refused(text, what, monkeypatch):
    source = manual_pages.source
    monkeypatch.setattr(manual_pages, 'source', lambda name, language='en': text if name == "files" else source(name, language))
    with pytest.raises(manual_pages.Broken, match=what):
        make_manual.content()


@pytest.mark.parametrize('old, new, what', (
    ("(../workflows.md)", "(workflows.md)", "pl/index links workflows.html, which is not there"),
    ("(teaching.md)", "(../teaching.md)", "pl/index links ../teaching.md, which is there in Polski"),
    ("\n## S", "\nS", "pl/index has 3 headings, and 4 in English"),
    ("\n## S", "\n<!-- F1: nets -->\n## S", "pl/index: what does <!-- F1: nets --> mean"),
))
def test_a_translation_that_is_not_like_the_english_page_is_refused(old, new, what, monkeypatch):
    source = manual_pages.source
    text = source("index", "pl").replace(old, new)
    assert text != source("index", "pl")
    monkeypatch.setattr(manual_pages, 'source', lambda name, language='en': text if (name, language) == ("index", "pl") else source(name, language))
    with pytest.raises(manual_pages.Broken, match=what):
        make_manual.content()


def test_addresses_on_the_web_stand_in_one_file_only():
    for path in (PROJECT / "addon").rglob("*"):
        if path.suffix in ('.py', '.toml', '.md', '.css') and path.name != "addresses.py":
            assert not re.search(r"https?://(?!www\.w3\.org/2000/svg)", path.read_text()), path    # that is the name of a format


def test_every_part_has_the_addresses_that_are_known():
    """None is made up: where there is none yet, none is shown."""
    known = make_zip.addresses((PROJECT / "addon/splinewright/ui/addresses.py").read_text())
    urls = tomllib.loads((PROJECT / "native/pyproject.toml").read_text())["project"].get("urls", {})
    assert urls == {label: known[name] for label, name in (("Homepage", "WEBSITE"), ("Issues", "ISSUES")) if name in known}
    cited = re.findall(r"^url: (.*)$", (PROJECT / "CITATION.cff").read_text(), re.M)
    assert [one.strip('"') for one in cited] == ([known["WEBSITE"]] if "WEBSITE" in known else [])


def test_the_zip_has_the_addresses_that_are_known():
    init, manifest = ((PROJECT / "addon/splinewright" / name).read_text() for name in ("__init__.py", "blender_manifest.toml"))
    for name, text in (("__init__.py", init), ("blender_manifest.toml", manifest)):
        made = make_zip.completed(name, text, "1.2.3", {})
        assert "url" not in made and "website" not in made and "1.2.3" in made
    known = make_zip.addresses('"""Text."""\nWEBSITE = "https://a.example"\nISSUES = "https://b.example"\nNONE = ""\n')
    made = make_zip.completed("__init__.py", init, "1.2.3", known)
    info = {}
    exec(made.partition("def register")[0], info)
    assert info["bl_info"]["doc_url"] == "https://a.example" and info["bl_info"]["tracker_url"] == "https://b.example"
    assert info["bl_info"]["version"] == (1, 2, 3) and info["__version__"] == "1.2.3"
    made = make_zip.completed("blender_manifest.toml", manifest, "1.2.3", known)
    assert 'version = "1.2.3"\nwebsite = "https://a.example"\n' in made
