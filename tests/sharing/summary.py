"""What came of the tests in all processes: summary.py FOLDER SECONDS. 1 where a file was begun and not ended, or nothing ran."""

import collections
import json
import sys
from pathlib import Path

folder, seconds = Path(sys.argv[1]), sys.argv[2]
counts = collections.Counter()
for path in folder.glob('*.counts'):
    counts.update(json.loads(path.read_text()))
crashed = sorted({path.stem for path in folder.glob('*.taken')} - {path.stem for path in folder.glob('*.done')})
for name in crashed:
    print(f"{name} was begun and not ended: its process is gone")
said = f"{counts['passed']} passed, {counts['failed'] + len(crashed)} failed"
print(said + (f", {counts['skipped']} skipped" if counts['skipped'] else ""), f"in {seconds} s")
sys.exit(bool(crashed) or not counts)
