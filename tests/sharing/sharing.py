"""A plugin of pytest: several processes share the test files, each takes the next one that no other has taken.

SHARED_FOLDER is where they see what is taken, and where each leaves its counts; a line about each file goes to SHARED_OUTPUT,
the number of an open file. Without them nothing is shared. SHARED_WITHOUT names files that are left out.
"""

import collections
import itertools
import json
import os
import time
from pathlib import Path

#: The files that take longest, so that none of them comes last.
SLOW = ("test_random_walk.py", "test_memory.py", "test_random_patches.py", "test_against_blender.py", "test_fineness.py",
        "test_write_native.py", "test_sample_meshes.py", "test_damaged.py", "test_patch_verbs.py",
        "test_wild_fillings.py", "test_packaging.py", "test_complete_sections.py", "test_every_call.py", "test_nearly_touching.py",
        "test_adaptive_tessellation.py", "test_trimmed_offsets.py", "test_all_fillets.py", "test_promised_tolerances.py")
FOLDER = os.environ.get('SHARED_FOLDER')
WITHOUT = os.environ.get('SHARED_WITHOUT', '').split()


def pytest_configure(config):
    if FOLDER:
        config.pluginmanager.register(Sharing(Path(FOLDER), int(os.environ['SHARED_OUTPUT'])))


def order(path):
    return SLOW.index(path.name) if path.name in SLOW else len(SLOW), path.name


class Sharing:
    def __init__(self, folder, output):
        self.folder, self.output = folder, output
        self.counts = collections.Counter()

    def take(self, name):
        """Whether the file is ours."""
        try:
            (self.folder / f"{name}.taken").touch(exist_ok=False)
        except FileExistsError:
            return False
        return True

    def pytest_runtestloop(self, session):
        if session.testsfailed:
            raise session.Interrupted(f"{session.testsfailed} errors while the tests were collected")
        files = itertools.groupby(sorted(session.items, key=lambda item: order(item.path)), key=lambda item: item.path)
        for path, items in files:
            if path.name not in WITHOUT and self.take(path.name):
                self.run(path.name, list(items))
        return True

    def run(self, name, items):
        before, start = self.counts.copy(), time.monotonic()
        for item, following in zip(items, [*items[1:], None]):
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
        (self.folder / f"{name}.done").touch()
        (self.folder / f"{os.getpid()}.counts").write_text(json.dumps(self.counts))
        said = ', '.join(f"{count} {what}" for what, count in (self.counts - before).items())
        os.write(self.output, f"  {name:38} {said:28} {time.monotonic() - start:6.1f} s\n".encode())

    def pytest_runtest_logreport(self, report):
        if report.failed:
            self.counts['failed'] += 1
        elif report.skipped:
            self.counts['skipped'] += 1
        elif report.when == 'call':
            self.counts['passed'] += 1
