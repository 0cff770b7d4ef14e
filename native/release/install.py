"""Installs the extension inside Blender and lets it test itself: install.py -- file ZIP, or install.py -- repository URL"""

import sys
import time

import bpy


def from_file(path):
    bpy.ops.extensions.package_install_files(filepath=path, repo='user_default', enable_on_install=True)


def from_repository(url):
    """As a user adds a remote repository, looks what it has, and installs it."""
    bpy.context.preferences.system.use_online_access = True
    bpy.ops.preferences.extension_repo_add(name="Splinewright", remote_url=url, type='REMOTE', use_sync_on_startup=False)
    number = len(bpy.context.preferences.extensions.repos) - 1
    bpy.ops.extensions.repo_sync(repo_index=number)
    deadline = time.monotonic() + 60
    while 'FINISHED' not in bpy.ops.extensions.package_install(repo_index=number, pkg_id="splinewright"):
        if time.monotonic() > deadline:
            sys.exit("the repository's package does not come")


how, what = sys.argv[sys.argv.index('--') + 1:]
{'file': from_file, 'repository': from_repository}[how](what)
names = [name for name in bpy.context.preferences.addons.keys() if name.endswith('.splinewright')]
if not names:
    sys.exit("the extension is not enabled")
print(f"Installed from the {how}: {names[0]}")
bpy.ops.splinewright.self_test()
