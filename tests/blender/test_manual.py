"""F1 over everything of ours leads to a page and an anchor of the manual in the zip, which speaks of it."""

import html.parser
import os
import re
import textwrap
import webbrowser
import zipfile
from pathlib import Path
from urllib.parse import unquote, urlparse

import bpy
import pytest

from shapes import op
from support import ADDON, part
from test_languages import in_languages, switch

manual = part('ui.manual')


class Text(html.parser.HTMLParser):
    """The anchors of a page, and its text from each anchor to the next."""

    def __init__(self, text):
        super().__init__()
        self.parts, self.anchor = {"": ""}, ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        if 'id' in dict(attributes):
            self.anchor = dict(attributes)['id']
            self.parts[self.anchor] = ""

    def handle_data(self, data):
        self.parts[self.anchor] += data


@pytest.fixture(scope='module')
def pages():
    """The pages in the zip, {name: {anchor: text}}."""
    with zipfile.ZipFile(os.environ['SPLINEWRIGHT_ZIP']) as archive:
        return {Path(name).name: Text(archive.read(name).decode()).parts for name in archive.namelist()
                if Path(name).parent.as_posix() == 'splinewright/manual' and name.endswith('.html')}


def classes(kind):
    return [cls for room in part('ui')._all_rooms() for cls in room.CLASSES if issubclass(cls, kind)]


def led_to(name):
    """Where F1 over one of Blender's names leads: its own function says."""
    from bl_operators.wm import WM_OT_doc_view_manual
    return WM_OT_doc_view_manual._lookup_rna_url(name, verbose=False)


def text_of(pages, address):
    """What stands at an address of the manual."""
    assert address and address.startswith(manual.address_of("")), address
    page, _, anchor = address[len(manual.address_of("")):].partition("#")
    assert page in pages and anchor in pages[page], f"{address} is not there"
    return pages[page][anchor]


OPERATORS = [cls.bl_idname.partition(".")[2] for cls in classes(bpy.types.Operator)]


@pytest.mark.parametrize('name', OPERATORS)
def test_every_operator_is_told_of(name, pages):
    text = text_of(pages, led_to(f"bpy.ops.splinewright.{name}"))
    label = getattr(bpy.ops.splinewright, name).get_rna_type().name
    assert label.lower() in " ".join(text.lower().split()), f"{label} is not in: {text}"


def test_every_panel_is_told_of(pages):
    for cls in classes((bpy.types.Panel, bpy.types.Menu)):
        text_of(pages, led_to(f"bpy.types.{cls.__name__}"))


PROPERTIES = [(cls.__name__, known.identifier) for cls in classes((bpy.types.PropertyGroup, bpy.types.AddonPreferences))
              for known in cls.bl_rna.properties
              if known.identifier not in ('rna_type', 'bl_idname') and not known.is_hidden]


@pytest.mark.parametrize('owner, name', PROPERTIES)
def test_every_property_is_told_of(owner, name, pages):
    text_of(pages, led_to(f"bpy.types.{owner}.{name}"))


def test_nothing_is_mapped_that_is_not_there():
    import fnmatch
    known = [f"bpy.ops.splinewright.{name}" for name in OPERATORS]
    known += [f"bpy.types.{cls.__name__}" for cls in classes((bpy.types.Panel, bpy.types.Menu))]
    known += [f"bpy.types.{owner}.{name}" for owner, name in PROPERTIES]
    known = [name.lower() for name in known]
    for pattern, page in manual.pages()[1]:
        assert fnmatch.filter(known, pattern), f"{pattern} on {page} is nothing of ours"


@pytest.fixture
def opened(monkeypatch):
    """The addresses that a browser is asked for."""
    found = []
    monkeypatch.setattr(webbrowser, 'open', lambda address, *_, **__: not found.append(address))
    return found


@pytest.fixture
def speak():
    """Switches the language of the interface until the test has ended."""
    yield switch
    view = bpy.context.preferences.view
    view.language = 'en_US'
    view.use_translate_interface = view.use_translate_tooltips = False


def path_of(address):
    assert urlparse(address).scheme == 'file' and not urlparse(address).netloc
    return Path(unquote(urlparse(address).path))


@pytest.mark.parametrize('name, page', (
    ('splinewright.edit_net', 'nets.html'), ('SPLINEWRIGHT_OT_insert_knot.times', 'modify.html'),
    ('SplinewrightShape.tolerance', 'surfaces.html'), ('SplinewrightRecipe.torus_radius', 'surfaces.html')))
def test_f1_opens_the_page_in_the_browser(name, page, opened):
    assert bpy.ops.wm.doc_view_manual(doc_id=name) == {'FINISHED'}
    (address,) = opened
    assert path_of(address).name == page and path_of(address).is_file() and urlparse(address).fragment


def test_the_button_opens_the_manual(opened):
    assert bpy.ops.splinewright.manual() == {'FINISHED'}
    assert bpy.ops.splinewright.manual(page="nets.html#knots") == {'FINISHED'}
    assert [path_of(address).name for address in opened] == ["index.html", "nets.html"]
    assert all(path_of(address).is_file() for address in opened) and opened[1].endswith("#knots")


@in_languages
@pytest.mark.parametrize('locale, folder', (('pl_PL', "pl"), ('ru_RU', "ru"), ('it_IT', "it"), ('de_DE', ""), ('en_US', "")))
def test_pages_open_in_the_language_of_the_interface(locale, folder, opened, speak):
    speak(locale)
    bpy.ops.splinewright.manual(page="five-minutes.html")
    bpy.ops.splinewright.manual(page="files.html")
    bpy.ops.wm.doc_view_manual(doc_id='splinewright.start_lesson')
    bpy.ops.wm.doc_view_manual(doc_id='splinewright.insert_knot')
    root = manual.FOLDER / folder
    assert [path_of(address) for address in opened] == [
        root / "five-minutes.html", manual.FOLDER / "files.html", root / "teaching.html", manual.FOLDER / "modify.html"]
    assert urlparse(opened[2]).fragment == "lessons" and 'id="lessons"' in path_of(opened[2]).read_text(encoding='utf-8')
    assert all(path_of(address).is_file() for address in opened)


@in_languages
def test_pages_are_english_where_the_interface_is_not_translated(opened, speak):
    speak('pl_PL')
    bpy.context.preferences.view.use_translate_interface = False
    bpy.ops.splinewright.manual(page="teaching.html")
    assert path_of(opened[0]) == manual.FOLDER / "teaching.html"


def test_a_missing_page_or_browser_is_said_in_words(monkeypatch, opened):
    with pytest.raises(RuntimeError, match="there is no page"):
        bpy.ops.splinewright.manual(page="nowhere.html")
    monkeypatch.setattr(webbrowser, 'open', lambda *_, **__: False)
    with pytest.raises(RuntimeError, match=re.escape(f"no browser was found: the manual is {manual.FOLDER}")):
        bpy.ops.splinewright.manual()


def test_folders_of_any_name_make_addresses(monkeypatch, tmp_path):
    folder = tmp_path / "My Add-ons (übel) #1 100%"
    folder.mkdir()
    monkeypatch.setattr(manual, 'FOLDER', folder)
    address = manual.address_of("nets.html#knots")
    assert path_of(address) == folder / "nets.html" and urlparse(address).fragment == "knots" and address.isascii()


def test_without_a_manual_other_add_ons_keep_their_own(monkeypatch, tmp_path):
    monkeypatch.setattr(manual, 'FOLDER', tmp_path)
    manual._map.cache_clear()
    try:
        assert manual.pages()[1] == []
        assert led_to("bpy.types.splinewrightshape.tolerance") is None or "splinewright" not in led_to(
            "bpy.types.splinewrightshape.tolerance").lower()
        assert led_to("bpy.ops.mesh.subdivide")
    finally:
        manual._map.cache_clear()


def test_the_hook_goes_with_the_add_on():
    part('ui').unregister()
    try:
        assert not [prefix for prefix, _ in bpy.utils.manual_map() if prefix.startswith("file:") and ADDON in prefix]
    finally:
        part('ui').register()
    assert [prefix for prefix, _ in bpy.utils.manual_map() if prefix == manual.address_of("")]


def samples():
    """The Python of the manual and the README that is for Blender."""
    project = Path(__file__).resolve().parents[2]
    for page in (*sorted((project / "addon/manual").glob("*.md")), project / "README.md"):
        for code in re.findall(r"^ *```python\n(.*?)^ *```", page.read_text(), re.S | re.M):
            if re.search(r"\bC\.object|\bbpy\b|\bapi\b", code):
                yield pytest.param(textwrap.dedent(code), id=page.stem)


@pytest.mark.parametrize('code', samples())
def test_samples_for_blender_run(code):
    op(bpy.ops.splinewright.add_nurbs_curve)
    exec(code, {'C': bpy.context, 'bpy': bpy, 'api': part('api')})


def test_there_are_samples_for_blender():
    assert len(list(samples())) >= 7
