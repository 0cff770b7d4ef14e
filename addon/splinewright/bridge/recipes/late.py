"""Followers that show an earlier state for a while, so that a drag of what they follow stays quick: which they are, and what may be
done within one step of it.

A follower that is late has a mark in its recipe: undo steps, and files that Blender saves by itself, may hold it as it was, and by its
mark it is brought up to date when it comes back.
"""

import math
import time
from dataclasses import dataclass

from ..data import problems, settings, store
from ..data.file_state import block_of, ended_operators, key, state
from . import recipes

_MARK = 'late'
#: Seconds that followers may take within one step.
BUDGET = 0.03
#: Seconds without a step after which a drag of which Blender does not tell when it ends is over.
RELEASED = 1.0
#: What takes longer than so many seconds is not made in the middle of a drag either, and with Esc at hand.
SLOW = 0.5
_STOPPED = "Esc stopped its update: Update Now makes it as its inputs are now"
clock = time.perf_counter


@dataclass(eq=False)
class Delay:
    """That a follower is late, since its inputs changed last."""

    is_stopped: bool = False            # whether a user stopped what brought it up to date


class Budget:
    """The time that followers may take within one step. is_awaited: whether a script waits for the result, which takes as long
    as it takes."""

    def __init__(self, is_awaited=False):
        self._end = math.inf if is_awaited else clock() + BUDGET
        self._allowed = {settings.ALWAYS, settings.ON_RELEASE} if is_awaited else {settings.ALWAYS}

    def allows(self, data):
        """Whether a follower may be brought up to date in this step, by what that took before."""
        return settings.of(data).update_mode in self._allowed and clock() + expected(data) <= self._end

    def is_over(self):
        """A `cancel` as the library takes it."""
        return clock() > self._end


def note(data, seconds):
    """How long it took to bring a follower up to date; infinity where it was called off, until it is made in peace."""
    before = state.costs.get(key(data), ())[:1] if seconds < math.inf else ()
    state.costs[key(data)] = seconds, *before


def expected(data):
    """The seconds that a follower will take: the less of the last two, for once in a while the machine does something else."""
    return min(state.costs.get(key(data), (0.0,)))


def put_off(data):
    """A follower is to be brought up to date later."""
    if is_stopped(data):
        problems.set_problem(data, problems.FOLLOWING, "")
    _delay(key(data))
    data[recipes.KEY][_MARK] = True


def put_off_again(name):
    """Whether a follower, by its key, is late already, and not because a user stopped it: then it waits longer."""
    if name not in state.late or state.late[name].is_stopped:
        return False
    _delay(name)
    return True


def _delay(name):
    """Have a follower wait. Each time it is another Delay, so that what makes it of earlier inputs is called off."""
    state.late[name] = Delay()
    state.put_off_at, state.put_off_by = clock(), ended_operators()


def is_done(data):
    """A follower is up to date, or it is known why it is not."""
    state.late.pop(key(data), None)
    if has_mark(data):
        del data[recipes.KEY][_MARK]


def is_late(data):
    """Whether a data-block is a follower that is to be brought up to date yet."""
    return key(data) in state.late


def stop(data, seconds):
    """A user stopped what brought a follower up to date, after a number of seconds: it waits until its inputs change again or somebody
    asks for it."""
    state.late[key(data)].is_stopped = True
    note(data, max(seconds, state.costs.get(key(data), (0.0,))[0] if expected(data) < math.inf else 0.0))
    problems.set_problem(data, problems.FOLLOWING, _STOPPED)


def is_stopped(data):
    """Whether a user stopped what brought a late follower up to date."""
    return is_late(data) and state.late[key(data)].is_stopped


def has_mark(data):
    """Whether a follower is late, or was in the file or undo step that it comes from."""
    return recipes.has(data) and store.is_group(data[recipes.KEY]) and _MARK in data[recipes.KEY].keys()


def take_back(data):
    """A follower that has a mark came back. Whether it is to be brought up to date at once."""
    if settings.of(data).update_mode == settings.MANUAL:
        state.late[key(data)] = Delay()
        return False
    return True


def blocks():
    """The data-blocks of all that are late; None among them for one that was renamed or removed."""
    found = {name: block_of(name) for name in state.late}
    for name, data in found.items():
        if data is not None and not has_mark(data):
            del state.late[name]        # it follows nothing any more
    return [found[name] for name in state.late]


def forget_lost():
    """Those of which blocks() has None are known by their names no more."""
    for name in [name for name in state.late if block_of(name) is None]:
        del state.late[name]


def waiting(is_released=True):
    """Those of blocks() that a rest of the mouse brings up to date. is_released: whether nothing is dragged any more."""
    is_over = is_released or rests_long()
    return [data for data in blocks() if data is None or _is_due(data, is_over)]


def rests_long():
    """Whether no input of late shapes has changed for so long that a drag counts as over."""
    return clock() - state.put_off_at > RELEASED


def _is_due(data, is_over):
    mode, is_slow = settings.of(data).update_mode, SLOW < expected(data) < math.inf
    return not is_stopped(data) and mode != settings.MANUAL and (is_over or mode == settings.ALWAYS and not is_slow)
