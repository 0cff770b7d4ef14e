import zlib

import bpy
import numpy as np
import pytest

from shapes import RANDOM


@pytest.fixture(autouse=True)
def empty_scene(request):
    """Every test begins in an empty file, with the add-on enabled, and with random numbers of its own."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    RANDOM.bit_generator.state = np.random.default_rng(zlib.crc32(request.node.name.encode())).bit_generator.state
    yield
