"""The manual that lies in the zip: F1 over the add-on, and buttons that open it. It works without the native library."""

import functools
import json
import webbrowser
from pathlib import Path

import bpy
from bpy.props import StringProperty

from ..core.base.words import phrase
from . import languages
from .operators import reports

FOLDER = Path(__file__).resolve().parent.parent / "manual"
#: Pairs of a pattern of Blender's names and the page and anchor that F1 leads to.
_MAP = "f1.json"


class SPLINEWRIGHT_OT_manual(bpy.types.Operator):
    bl_idname = "splinewright.manual"
    bl_label = "Manual"
    bl_description = "Read the manual of Splinewright in the browser; it came with the add-on and needs no network"
    bl_options = {'INTERNAL'}

    page: StringProperty(name="Page", description="A page of the manual, and an anchor in it", default="index.html",
                         options={'SKIP_SAVE'})

    def execute(self, context):
        page = translated(self.page)
        path = FOLDER / page.partition("#")[0]
        if not path.is_file():
            return reports.cancelled(self, phrase("there is no page {path}: install the Splinewright zip again", path=path))
        if not webbrowser.open(address_of(page)):
            return reports.cancelled(self, phrase("no browser was found: the manual is {path}", path=path))
        return reports.finished(self, reports.Report(phrase("The manual is {path}", path=path)))


def address_of(page):
    """For a browser."""
    return f"{FOLDER.as_uri()}/{page}"


def translated(page):
    """The page in the language of the interface if it is there, with the same anchor, or else the English one."""
    language = languages.spoken()
    is_there = language and (FOLDER / language / page.partition("#")[0]).is_file()
    return f"{language}/{page}" if is_there else page


def draw_button(layout, page):
    """A question mark that leads to a page."""
    layout.operator(SPLINEWRIGHT_OT_manual.bl_idname, text="", icon='HELP', emboss=False).page = page


@functools.lru_cache(1)
def _map():
    path = FOLDER / _MAP
    return [tuple(pair) for pair in json.loads(path.read_text(encoding='utf-8'))] if path.is_file() else []


def pages():
    """For Blender: where the manual lies, and what leads to which page."""
    return address_of(""), [(pattern, translated(page)) for pattern, page in _map()]


CLASSES = (SPLINEWRIGHT_OT_manual,)


def register():
    bpy.utils.register_manual_map(pages)


def unregister():
    bpy.utils.unregister_manual_map(pages)
