"""Counts the instructions of growth.cpp's workloads for COUNT and for TIMES as many, under callgrind: what is linear, or
takes a sorted search more, stays below MOST times as many; what is quadratic takes TIMES squared.

judge_growth.py PROGRAM
"""

import shutil
import sys

from callgrind import counted

WORKLOADS = ("remove knots", "insert knots", "to Beziers", "pieces of gaps", "compatible knots", "multiplicities",
             "points interpolated", "points shared", "panels", "mesh")
COUNT, TIMES, MOST = 250, 8, 12


def verdict(workload, few, many):
    """What is wrong with two counts; nothing if the second is few times the first."""
    if many <= MOST * few:
        return None
    return (f"{workload}: {few:,} instructions for {COUNT}, {many:,} for {TIMES * COUNT}: {many / few:.1f} times as many "
            f"where {MOST} are allowed")


def main(program):
    if not shutil.which("valgrind"):
        sys.exit("valgrind is missing: apt-get install valgrind")
    troubles = []
    for workload in WORKLOADS:
        few, many = (counted([program, workload, str(count)]) for count in (COUNT, TIMES * COUNT))
        print(f"{workload}: {few:,}, {many:,}: {many / few:.1f}")
        troubles.append(verdict(workload, few, many))
    for trouble in filter(None, troubles):
        print(trouble)
    return 1 if any(troubles) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
