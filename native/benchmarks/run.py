"""./run bench: every workload, ours and the rivals' in turn, on one core; the table, the plot, the errors.

run.py BUILD [--rounds N] [WORKLOAD...]
"""

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
from pathlib import Path

import numpy as np

import deviations
import exact
import plot
import table
import workloads

HERE = Path(__file__).parent
EARLIER = HERE / "earlier.json"


def arguments():
    parser = argparse.ArgumentParser(prog="./run bench", description="Times splinecore beside SISL, OCCT and scipy.")
    parser.add_argument("build", type=Path, help=argparse.SUPPRESS)
    parser.add_argument("workloads", nargs="*", metavar="WORKLOAD", help=", ".join(workloads.WORKLOADS))
    parser.add_argument("--rounds", type=int, default=3)
    given = parser.parse_intermixed_args()
    kinds = {name.split()[0] for name in workloads.WORKLOADS}
    unknown = set(given.workloads) - set(workloads.WORKLOADS) - kinds
    given.workloads = [name for name in workloads.WORKLOADS if {name, name.split()[0]} & set(given.workloads)]
    if unknown:
        parser.error(f"no workload {', '.join(sorted(unknown))}; there are {', '.join(workloads.WORKLOADS)}")
    if given.rounds < 1:
        parser.error("one round at least")
    return given


def said(command):
    """The JSON lines that a program prints."""
    made = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    return [json.loads(line) for line in made.stdout.splitlines()]


def version_of(package):
    made = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], stdout=subprocess.PIPE, text=True)
    return made.stdout if made.returncode == 0 else "of unknown version"


def processor():
    lines = subprocess.run(["lscpu"], stdout=subprocess.PIPE, text=True, env={**os.environ, "LC_ALL": "C"}).stdout
    facts = dict(line.split(":", 1) for line in lines.splitlines() if ":" in line)
    found = {name.strip(): value.strip() for name, value in facts.items()}
    kind = " ".join(f"{word} {found[word]}" for word in ("CPU family", "Model", "Stepping") if word in found)
    return f"{found.get('Model name', platform.machine())} ({kind})"


def machine_of(rates, rounds):
    rivals = f"SISL {version_of('libsisl-dev')}, OCCT {version_of('libocct-foundation-dev')}, " \
             f"scipy {version_of('python3-scipy')}"
    return {"name": processor(), "versions": f"{rivals}, Python {platform.python_version()}",
            "rounds": rounds, **{key: statistics.median(rate[key] for rate in rates) for key in rates[0]}}


def errors_of(kept, wanted):
    """{workload: {"who, call": error}} against exact arithmetic."""
    errors = {}
    for workload, reference in exact.references().items():
        if workload not in wanted:
            continue
        rows = reference()
        for path in sorted(kept.glob(f"{workload}.*.f64")):
            who, call = path.stem[len(workload) + 1:].split(".", 1)
            errors.setdefault(workload, {})[f"{who}, {call}"] = exact.error(np.fromfile(path), rows)
    return errors


def earlier_on(name):
    """{workload: ns an item} of the library at an earlier commit, if that was measured on such a machine."""
    known = json.loads(EARLIER.read_text())
    return known["ns"] if known["machine"] == name else None


def main():
    given = arguments()
    wanted = given.workloads or list(workloads.WORKLOADS)
    folder = given.build / "bench"
    data, kept, programs = folder / "data", folder / "kept", given.build / "native/benchmarks"
    workloads.write(data)
    kept.mkdir(parents=True, exist_ok=True)
    for old in kept.glob("*.f64"):
        old.unlink()
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    os.environ["PYTHONPATH"] = str(given.build / "python")
    ours = [sys.executable, HERE / "ours.py"]
    programs_in_turn = [ours, [programs / "benchmark_sisl"], [programs / "benchmark_occt"],
                         [sys.executable, HERE / "scipy_splines.py"]]
    lines, rates = [], []
    for turn in range(given.rounds):
        rates += said([programs / "benchmark_machine"])
        for workload in wanted:
            for program in programs_in_turn:
                lines += said([*program, data, kept, workload])
        print(f"round {turn + 1} of {given.rounds}", file=sys.stderr)
    machine = machine_of(rates, given.rounds)
    rows = table.rows_of(lines, errors_of(kept, wanted), machine, earlier_on(machine["name"]),
                         deviations.measured(kept, wanted))
    rows = [row for row in rows if row.workload in wanted]
    (folder / "table.md").write_text(table.markdown(rows, machine))
    (folder / "brief.md").write_text(table.brief(rows, machine))
    (folder / "table.json").write_text(table.as_json(rows, machine))
    plot.draw(rows, machine, folder / "table.png")
    print(table.markdown(rows, machine))
    print(f"{folder}/table.md, table.json, table.png")


if __name__ == "__main__":
    main()
