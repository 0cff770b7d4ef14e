"""Every run tries the same random numbers and examples; `--seed N` tries others."""

import os

import numpy as np
import pytest
from hypothesis import HealthCheck, settings

SLOW_IS_WELL = [HealthCheck.too_slow, HealthCheck.filter_too_much]
settings.register_profile("same", derandomize=True, database=None, deadline=None, max_examples=100,
                          suppress_health_check=SLOW_IS_WELL)
settings.register_profile("other", database=None, deadline=None, max_examples=100, suppress_health_check=SLOW_IS_WELL)


def pytest_addoption(parser):
    parser.addoption("--seed", type=int, default=0, metavar="N", help="other random numbers than those of every run")
    parser.addoption("--inputs", type=int, default=0, metavar="N", help="so many random inputs of each kind where a tolerance is promised")


def pytest_configure(config):
    seed = config.getoption("seed")
    settings.load_profile("other" if seed else "same")
    if seed:
        of_every_run = np.random.default_rng
        np.random.default_rng = lambda given: of_every_run([seed, *np.atleast_1d(given)])


@pytest.fixture
def inputs(request):
    """How many random inputs of a kind are drawn: what a test takes for that, unless --inputs says another number, or
    SPLINECORE_TESTS_FEWER by how much it is divided."""
    fewer = int(os.environ.get("SPLINECORE_TESTS_FEWER", "1"))
    return lambda usual: request.config.getoption("inputs") or -(-usual // fewer)
