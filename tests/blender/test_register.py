"""Installing, enabling and disabling; a native module that is missing or wrong."""

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import addon_utils
import bpy
import pytest

from support import ADDON, part

MENUS = ("VIEW3D_MT_curve_add", "VIEW3D_MT_surface_add", "TOPBAR_MT_file_import", "TOPBAR_MT_file_export")


def census():
    """Counts of everything that an add-on could leave behind."""
    handlers = {name: len(getattr(bpy.app.handlers, name)) for name in dir(bpy.app.handlers)
                if isinstance(getattr(bpy.app.handlers, name), list)}
    menus = {name: len(getattr(bpy.types, name).draw._draw_funcs) if hasattr(getattr(bpy.types, name).draw, '_draw_funcs') else 0
             for name in MENUS}
    ours = sorted(name for name in dir(bpy.types) if 'splinewright' in name.lower())
    operators = sorted(dir(bpy.ops.splinewright))
    properties = [owner.__name__ for owner in (bpy.types.Mesh, bpy.types.Curve, bpy.types.Object, bpy.types.Scene,
                                               bpy.types.WindowManager) if hasattr(owner, 'splinewright')]
    config = bpy.context.window_manager.keyconfigs.addon
    keys = sum(len(keymap.keymap_items) for keymap in config.keymaps) if config else 0
    return {'handlers': handlers, 'menus': menus, 'types': ours, 'operators': operators,
            'properties': properties, 'keys': keys}


def test_register_unregister_and_register_again_leave_nothing_behind():
    part('ui').unregister()
    part('ui').register()               # there are no keymaps yet when Blender starts in background
    enabled = census()
    assert enabled['types'] and enabled['operators'] and enabled['properties'] == ['Mesh', 'Curve']
    part('ui').unregister()
    disabled = census()
    try:
        assert disabled['types'] == [] and disabled['operators'] == [] and disabled['properties'] == []
        part('ui').register()
        assert census() == enabled
        part('ui').unregister()
        assert census() == disabled
    finally:
        part('ui').register()
    assert census() == enabled


def test_disabling_and_enabling_as_the_preferences_do_keeps_shapes_alive():
    bpy.ops.splinewright.add_teapot()
    value = bpy.context.object.data.splinewright.value
    addon_utils.disable(ADDON, default_set=True)
    assert not hasattr(bpy.types.Mesh, 'splinewright')
    assert addon_utils.enable(ADDON, default_set=True, persistent=True) is not None
    # A fresh import may have made new classes; the text is what must be equal.
    assert bpy.data.objects["Teapot"].data.splinewright.value.dumps() == value.dumps()


def test_the_version_is_the_same_everywhere():
    version = sys.modules[ADDON].__version__
    assert version == part('splinecore').__version__
    with zipfile.ZipFile(os.environ['SPLINEWRIGHT_ZIP']) as archive:
        assert f'version = "{version}"' in archive.read('splinewright/blender_manifest.toml').decode()
        # Blender takes bl_info out of an extension once it is loaded.
        source = archive.read('splinewright/__init__.py').decode()
    assert f'"version": ({version.replace(".", ", ")})' in source


def test_the_zip_holds_only_what_runs_and_the_manual():
    with zipfile.ZipFile(os.environ['SPLINEWRIGHT_ZIP']) as archive:
        names = archive.namelist()
    assert {name.split('/')[0] for name in names} == {'splinewright'}
    others = [name for name in names if not name.startswith('splinewright/licenses/')]
    assert {Path(name).suffix for name in others} <= {'.py', '.so', '.json', '.toml', '.md', '.html', '.css', '.webp', '.svg', '.dat', '.blend', '.po', ''}
    assert {Path(name).suffix for name in set(names) - set(others)} <= {'.txt', ''}
    assert not any('test' in name.replace('self_test', '') for name in names)


BROKEN = {
    'missing': lambda module: module.unlink(),
    'truncated': lambda module: module.write_bytes(module.read_bytes()[:1000]),
    'empty': lambda module: module.write_bytes(b''),
}

PROBE = """
import addon_utils, bpy, sys
module = addon_utils.enable('splinewright', default_set=True, persistent=True)
assert module is not None, "not enabled"
from splinewright.core.base import library
from splinewright.ui import preferences
assert library.problem, "no problem seen"
assert not hasattr(bpy.types.Mesh, 'splinewright')
assert preferences.SplinewrightPreferences.is_registered
drawn, buttons = [], []
class Row:
    alert = False
    def label(self, text, icon): drawn.append(text)
    def column(self, align): return self
    row = lambda self: self
    def operator(self, name, icon): buttons.append(name); return self
class Self: layout = Row()
preferences.SplinewrightPreferences.draw(Self(), None)
print("SAID", ' '.join(drawn))
assert buttons == ["splinewright.manual"] and bpy.types.SPLINEWRIGHT_OT_manual.is_registered
assert "splinewright" in str([prefix for prefix, _ in bpy.utils.manual_map()])
addon_utils.disable('splinewright', default_set=True)
addon_utils.enable('splinewright', default_set=True, persistent=True)
"""


@pytest.mark.parametrize('harm', BROKEN.values(), ids=BROKEN)
def test_a_missing_or_wrong_native_module_is_one_sentence_in_the_preferences(harm, tmp_path):
    addons = tmp_path / "scripts" / "addons"
    addons.mkdir(parents=True)
    shutil.copytree(Path(sys.modules[ADDON].__file__).parent, addons / "splinewright")
    for module in (addons / "splinewright" / "splinecore").glob("*.so"):
        harm(module)
    environment = {**os.environ, 'BLENDER_USER_SCRIPTS': str(tmp_path / "scripts"), 'HOME': str(tmp_path)}
    run = subprocess.run([bpy.app.binary_path, '--background', '--factory-startup', '--python-exit-code', '1',
                          '--python-expr', PROBE], env=environment, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
    said = next(line for line in run.stdout.splitlines() if line.startswith("SAID"))
    assert "native module" in said and "Install the Splinewright zip" in said
    assert "splinewright" not in run.stderr.lower() or "Traceback" not in run.stderr
