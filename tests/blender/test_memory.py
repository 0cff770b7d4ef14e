"""Memory stays flat however long one edits."""

import os
from pathlib import Path

import bpy
import pytest

from shapes import VALUES, add, enter, first_point, leave, move, require_exact, select

PAGE = os.sysconf('SC_PAGE_SIZE')
#: Allocators keep some; one copy more of each of 700 definitions and meshes would be 100 MB.
ALLOWED = 12 * 2 ** 20


def used():
    return int(Path('/proc/self/statm').read_text().split()[1]) * PAGE


@pytest.mark.skipif(not Path('/proc/self/statm').exists(), reason="needs Linux's /proc")
@pytest.mark.parametrize('name', ('teapot', 'hermite'))
def test_memory_is_flat_over_a_thousand_edits_and_a_thousand_undos(name):
    ob = add(VALUES[name]())
    ob.data.splinewright.set_resolution(8, 8)
    held = enter()
    select(held, first_point(held))
    for i in range(1000):
        move(0, 0, 0.01)
        if i == 300:
            after_edits = used()
    assert used() - after_edits < ALLOWED
    for i in range(1000):
        bpy.ops.ed.undo()
        bpy.ops.ed.redo()
        if i == 300:
            after_undos = used()
    assert used() - after_undos < ALLOWED
    leave()
    require_exact(bpy.data.objects["shape"])


@pytest.mark.skipif(not Path('/proc/self/statm').exists(), reason="needs Linux's /proc")
def test_memory_is_flat_over_entering_and_leaving():
    add(VALUES['teapot']())
    for i in range(400):
        enter()
        leave()
        if i == 150:
            early = used()
    assert used() - early < ALLOWED
