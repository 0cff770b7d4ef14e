import bpy
import pytest


@pytest.fixture(autouse=True)
def empty_scene():
    """Every test begins in an empty file, with the add-on enabled."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    yield
