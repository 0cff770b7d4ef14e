"""Blender's module bpy as if it were Blender's program, for as much as these tests ask of it:

PYTHON as_program.py [FILE.blend] [--background] [--factory-startup] [--addons A,B] [--python-exit-code N]
                     [--python FILE | --python-expr TEXT] [-- ARGUMENTS]
PYTHON as_program.py --version
PYTHON as_program.py --command extension validate ZIP
"""

import os
import subprocess
import sys
import traceback
from pathlib import Path

import bpy
import addon_utils                  # found only once bpy is there


def read(words):
    """The flags, what follows each, and the file to open."""
    found, file, words = {}, None, iter(words)
    for word in words:
        if word == '--':
            break
        if word in ('--python', '--python-expr', '--python-exit-code', '--addons'):
            found[word] = next(words)
        elif word in ('--background', '--factory-startup', '--version'):
            found[word] = True
        elif word.startswith('-'):
            sys.exit(f"as_program.py does not know {word}")
        else:
            file = word
    return found, file


def enable_extensions():
    """The module begins with factory settings, and 4.2's crashes when it reads others."""
    folder = Path(bpy.utils.user_resource('EXTENSIONS', path='user_default'))
    for manifest in folder.glob('*/blender_manifest.toml'):
        addon_utils.enable(f'bl_ext.user_default.{manifest.parent.name}', default_set=True)


def run(found):
    space = {'__name__': '__main__'}
    if '--python' in found:
        space['__file__'] = found['--python']
        with open(found['--python'], encoding='utf-8') as file:
            exec(compile(file.read(), found['--python'], 'exec'), space)
    if '--python-expr' in found:
        exec(found['--python-expr'], space)


def validate(path):
    """As the program does: by the script of its own add-on for extensions."""
    cli = Path(bpy.utils.system_resource('SCRIPTS')) / "addons_core" / "bl_pkg" / "cli" / "blender_ext.py"
    return subprocess.run([sys.executable, str(cli), 'validate', path]).returncode


def main():
    if sys.argv[1:4] == ['--command', 'extension', 'validate']:
        return validate(sys.argv[4])
    found, file = read(sys.argv[1:])
    if '--version' in found:
        print("Blender", bpy.app.version_string, "(the module bpy)")
        return 0
    # Empty in the module; whoever starts a second Blender asks for it.
    bpy.app.binary_path = os.environ['BLENDER']
    if '--factory-startup' not in found:
        enable_extensions()
    for addon in filter(None, found.get('--addons', '').split(',')):
        bpy.ops.preferences.addon_enable(module=addon)
    if file:
        bpy.ops.wm.open_mainfile(filepath=file)
    try:
        run(found)
    except SystemExit as end:
        if isinstance(end.code, str):
            print(end.code, file=sys.stderr)
        return 1 if isinstance(end.code, str) else end.code or 0
    except Exception:
        traceback.print_exc()
        return int(found.get('--python-exit-code', 0))
    return 0


if __name__ == '__main__':
    code = main()
    sys.stdout.flush()
    sys.stderr.flush()
    # 4.2's module frees its panels after Python has ended, and crashes.
    os._exit(code)
