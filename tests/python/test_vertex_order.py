"""In which order vertices follow one another: along edges, or as they were chosen."""

import numpy as np
import pytest

from addon_core import core

in_order, Refusal = core('base.vertex_order').in_order, core('base.failures').Refusal


def test_an_open_chain_of_edges_is_followed_from_its_first_end():
    assert in_order([7, 3, 5, 1], [(5, 7), (3, 5), (7, 1)], []) == [([1, 7, 5, 3], False)]


def test_a_loop_closes():
    (chain, closed), = in_order([4, 9, 2, 6], [(4, 9), (9, 2), (2, 6), (6, 4)], [])
    assert closed and chain == [2, 9, 4, 6]


def test_chains_and_loops_are_each_one():
    found = in_order(range(8), [(0, 1), (1, 2), (2, 0), (3, 4), (6, 5), (6, 7)], [])
    assert [(sorted(chain), closed) for chain, closed in found] == [([3, 4], False), ([5, 6, 7], False), ([0, 1, 2], True)]


def test_vertices_without_edges_and_where_edges_branch_follow_as_they_were_chosen():
    assert in_order([1, 2, 3], [], [3, 1, 2]) == [([3, 1, 2], False)]
    assert in_order([1, 2, 3, 4], [(1, 2), (1, 3), (1, 4)], [4, 2, 4, 9, 1, 3]) == [([4, 2, 1, 3], False)]


@pytest.mark.parametrize('edges, history', (([], []), ([], [1, 2]), ([(1, 2)], [1]), ([(1, 2), (1, 3), (1, 4)], [])))
def test_an_order_that_nothing_tells_is_refused(edges, history):
    with pytest.raises(Refusal, match="one after another"):
        in_order([1, 2, 3, 4], edges, history)


def test_a_long_chain_in_random_numbers_keeps_its_neighbors():
    names = np.random.default_rng(1).permutation(100_000).tolist()
    (chain, closed), = in_order(sorted(names), list(zip(names, names[1:])), [])
    assert not closed and chain in (names, names[::-1])


def test_two_vertices_of_one_edge_are_an_open_chain():
    assert in_order([8, 5], [(8, 5)], []) == [([5, 8], False)]
