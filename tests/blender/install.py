"""Installs the zip as a legacy add-on: blender --background --python install.py -- ZIP"""

import sys

import addon_utils
import bpy

bpy.ops.preferences.addon_install(filepath=sys.argv[sys.argv.index('--') + 1], overwrite=True)
if addon_utils.enable('splinewright', default_set=True, persistent=True) is None:
    sys.exit("the add-on could not be enabled")
bpy.ops.wm.save_userpref()
