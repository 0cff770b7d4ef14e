"""How instructions are judged; ctest counts them."""

import json
import sys
from pathlib import Path

COUNTS = Path(__file__).resolve().parents[1] / "counts"
sys.path.insert(0, str(COUNTS))

import judge  # noqa: E402
import judge_growth  # noqa: E402


def test_more_instructions_are_a_trouble():
    assert judge.verdict("W", 1_050, 1_000) is None and judge.verdict("W", 800, 1_000) is None
    assert judge.verdict("W", 1_051, 1_000) == "W: 1,051 instructions, 5.1 % more than the 1,000 committed"


def test_what_was_won_must_be_committed_or_it_is_lost_again():
    assert judge.verdict("W", 799, 1_000) == "W: 799 instructions instead of 1,000: commit what was won"


def test_a_workload_without_a_figure_is_a_trouble():
    assert judge.troubles({"baseline": {"W": 5}}, {"baseline": {"W": 5}}) == []
    assert judge.troubles({"baseline": {"W": 5}}, {}) == ["W, baseline: 5 instructions, and no figure is committed"]


def test_a_grid_that_costs_more_lying_down_than_standing_is_a_trouble():
    committed = {"baseline": {"wide grid": 1_000, "tall grid": 1_500}}
    assert judge.troubles(committed, committed) == []
    dearer = {"baseline": {"wide grid": 1_000, "tall grid": 1_501}}
    assert judge.troubles(dearer, dearer) == ["baseline: wide grid and tall grid cost 1,000 and 1,501 instructions"]


def test_every_workload_has_figures_and_a_program():
    known = json.loads((COUNTS / "counts.json").read_text())
    assert known
    for compiler, counts in known.items():
        assert set(counts) == set(judge.KERNELS), compiler
        assert all(set(found) == set(judge.WORKLOADS) for found in counts.values()), compiler
    program = (COUNTS / "counted.cpp").read_text()
    assert all(f'{{"{workload}", ' in program for workload in judge.WORKLOADS)


def test_what_grows_faster_than_its_input_is_a_trouble():
    assert judge_growth.verdict("W", 1_000, 12_000) is None
    assert judge_growth.verdict("W", 1_000, 64_000).startswith("W: 1,000 instructions for 250, 64,000 for 2000: 64.0 times")


def test_every_workload_of_growth_has_a_program():
    program = (COUNTS / "growth.cpp").read_text()
    assert all(f'{{"{workload}", ' in program for workload in judge_growth.WORKLOADS)
    assert program.count('{"') == len(judge_growth.WORKLOADS)
