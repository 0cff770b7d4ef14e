"""Says which names the shared library exports that no public header has: exported.py LIBRARY INCLUDE.

Weak names are left out: inline functions and templates, which every user of a header has of his own.
"""

import re
import subprocess
import sys
from pathlib import Path

NAME = re.compile(r"(?:typeinfo (?:name )?for |vtable for |guard variable for )?splinecore::(?:\w+::)*?(\w+)")


def exported(library):
    made = subprocess.run(["nm", "-DC", "--defined-only", library], stdout=subprocess.PIPE, text=True, check=True)
    rows = [line.split(" ", 2) for line in made.stdout.splitlines()]
    return [name for _, kind, name in rows if kind not in "Wu"]


def main(library, include):
    headers = "".join(path.read_text() for path in Path(include).rglob("*.hpp"))
    public = set(re.findall(r"\w+", headers))
    names = exported(library)
    if not any(name.startswith("splinecore::evaluate(") for name in names):
        sys.exit("the public interface is not exported")
    others = [name for name in names if not (found := NAME.match(name)) or found[1] not in public]
    for name in others:
        print(f"exported, but in no public header: {name}")
    print(f"{len(names)} names are exported")
    return 1 if others else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
