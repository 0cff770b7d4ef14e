"""Instructions of a program inside of counted_work()."""

import os
import re
import subprocess
import sys


def counted(command, **environment):
    made = subprocess.run(["valgrind", "--tool=callgrind", "--toggle-collect=counted_work",
                           "--callgrind-out-file=/dev/null", *command],
                          env={**os.environ, **environment}, text=True, stderr=subprocess.PIPE)
    found = re.search(r"Collected : (\d+)", made.stderr)
    if made.returncode != 0 or not found or found[1] == "0":
        sys.exit(f"{' '.join(command)} could not be counted:\n{made.stderr}")
    return int(found[1])
