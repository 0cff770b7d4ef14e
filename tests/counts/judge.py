"""Counts the instructions of counted.cpp's workloads under callgrind and holds them against counts.json.

judge.py PROGRAM --compiler "x86_64 GNU 12.2.0" --build Release [--write]

Both kernels of the library are counted: SPLINECORE_KERNELS names them. --write commits what is found.
"""

import argparse
import json
import shlex
import shutil
import sys
from pathlib import Path

from callgrind import counted

COUNTS = Path(__file__).with_name("counts.json")
WORKLOADS = ("curve points", "scattered points", "pairs", "grid points", "normals", "adaptive mesh", "wide grid",
             "tall grid", "interpolation", "nearest points")
KERNELS = ("baseline", "x86-64-v3")
#: Above this the library has become slower; below it the committed figures would no longer notice that it does again.
MOST, LEAST = 1.05, 0.8
#: A grid with its sides exchanged costs at most this many times as much: each row has its sums of control points.
TURNED, TURNED_MOST = ("wide grid", "tall grid"), 1.5
SKIPPED = 77


def kernels_here():
    """Those that this machine can run."""
    flags = Path("/proc/cpuinfo").read_text().split()
    return KERNELS if {"avx2", "fma"} <= set(flags) else KERNELS[:1]


def verdict(name, count, committed):
    """What is wrong with a count; nothing if it is near what was committed."""
    if committed is None:
        return f"{name}: {count:,} instructions, and no figure is committed"
    ratio = count / committed
    if ratio > MOST:
        return f"{name}: {count:,} instructions, {100 * (ratio - 1):.1f} % more than the {committed:,} committed"
    if ratio < LEAST:
        return f"{name}: {count:,} instructions instead of {committed:,}: commit what was won"
    return None


def unlike(name, found):
    """What is wrong where a grid lying down does not cost what it costs standing."""
    low, high = sorted(found.get(workload, 1) for workload in TURNED)
    return f"{name}: {' and '.join(TURNED)} cost {low:,} and {high:,} instructions" if high > TURNED_MOST * low else None


def troubles(counts, committed):
    said = [unlike(kernels, found) for kernels, found in counts.items()]
    said += [verdict(f"{workload}, {kernels}", count, committed.get(kernels, {}).get(workload))
             for kernels, found in counts.items() for workload, count in found.items()]
    return [trouble for trouble in said if trouble]


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--build", required=True)
    parser.add_argument("--write", action="store_true", help="commit what is found")
    return parser.parse_args()


def main():
    given = arguments()
    known = json.loads(COUNTS.read_text())
    if given.build != "Release" or (given.compiler not in known and not given.write):
        print(f"counts are committed of Release builds by {', '.join(known)}; this is {given.build} by {given.compiler}")
        return SKIPPED
    if not shutil.which("valgrind"):
        sys.exit("valgrind is missing: apt-get install valgrind")
    counts = {kernels: {workload: counted([given.program, workload], SPLINECORE_KERNELS=kernels) for workload in WORKLOADS}
              for kernels in kernels_here()}
    print(json.dumps(counts, indent=1))
    if given.write:
        COUNTS.write_text(json.dumps({**known, given.compiler: counts}, indent=1) + "\n")
        return 0
    found = troubles(counts, known[given.compiler])
    for trouble in found:
        print(trouble)
    if found:
        print(f"If that is meant: {shlex.join([sys.executable, *sys.argv])} --write")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
