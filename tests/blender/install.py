"""Installs the zip, as an extension where Blender knows them: blender --background --python install.py -- ZIP"""

import sys

import addon_utils
import bpy

path = sys.argv[sys.argv.index('--') + 1]
if 'package_install_files' in dir(bpy.ops.extensions):
    bpy.ops.extensions.package_install_files(filepath=path, repo='user_default', enable_on_install=True)
else:
    bpy.ops.preferences.addon_install(filepath=path, overwrite=True)
    if addon_utils.enable('splinewright', default_set=True, persistent=True) is None:
        sys.exit("the add-on could not be enabled")
library = next(module for name, module in sys.modules.items() if name.endswith('splinewright.core.base.library'))
if library.problem:
    sys.exit(library.problem)
bpy.ops.wm.save_userpref()
