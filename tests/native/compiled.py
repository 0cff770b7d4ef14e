"""Says which sources of the library are compiled so that bits may differ: compiled.py COMPILE_COMMANDS SOURCES.

A compiler that fuses products and sums does it where it likes; kernels say where. Instructions beyond the least are for
the sets of kernels that are chosen at run time.
"""

import json
import sys
from pathlib import Path

OWN_SETS = {"kernels/x86_64_v3.cpp", "kernels/x86_64_v4.cpp"}
CARELESS = ("-ffast-math", "-Ofast", "-funsafe-math-optimizations", "-fassociative-math", "-freciprocal-math",
            "-ffinite-math-only", "-fno-signed-zeros", "-ffp-contract=on", "-ffp-contract=fast")


def troubles(name, options):
    if "-ffp-contract=off" not in options:
        yield f"{name} is compiled without -ffp-contract=off"
    yield from (f"{name} is compiled with {option}" for option in options if option in CARELESS)
    chosen = [option for option in options if option.startswith(("-march=", "-mfma", "-mavx"))]
    if chosen and name not in OWN_SETS:
        yield f"{name} is compiled with {' '.join(chosen)}, which not every machine can run"


def main(commands, sources):
    root = Path(sources).resolve()
    known = {}
    for entry in json.loads(Path(commands).read_text()):
        path = Path(entry["file"]).resolve()
        if path.is_relative_to(root):
            known[str(path.relative_to(root))] = entry["command"].split()
    if not known:
        sys.exit(f"no source below {root} is compiled")
    found = [trouble for name, options in known.items() for trouble in troubles(name, options)]
    print(*found, f"{len(known)} sources", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
