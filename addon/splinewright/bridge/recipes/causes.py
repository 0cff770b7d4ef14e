"""Which followers each data-block is a cause of, and the order that they are brought up to date in. To find that out takes as long as
there are followers, so it is kept from one change to the next, until a follower turns out to have other causes.

Data-blocks stand here by their addresses: whoever asks makes sure that a follower is there and has the causes that it had.
"""

import contextlib
import graphlib

from ..data.file_state import key
from . import recipes


class Index:
    """Of followers as they were when it was made."""

    def __init__(self, blocks):
        self.order, self.stuck = _in_order(blocks)      # the latter follow themselves, in a circle
        self._causes, self._followers = [], {}
        for number, data in enumerate(self.order):
            causes = addresses(data)
            self._causes.append(causes)
            for cause in causes:
                self._followers.setdefault(cause, []).append(number)
        self.order = [key(data) for data in self.order]

    def followers_of(self, block):
        """The numbers in its order of those that a data-block is a cause of."""
        return self._followers.get(block.as_pointer(), ())

    def knows(self, number, data):
        """Whether the follower of a number has the causes that it had."""
        return self._causes[number] == addresses(data)

    def knows_all(self, data):
        """Whether a data-block that may be a follower has the causes that it had."""
        name = key(data)
        return all(self.knows(number, data) for number in self.followers_of(data) if self.order[number] == name)


def of(data):
    """What a follower depends on; of an object that shows it its place, for which the follower itself stands here."""
    for source in recipes.pointers(data):
        yield from (source, source.data, getattr(source.data, 'shape_keys', None))
    yield from recipes.frames(data)
    yield data


def addresses(data):
    """Those of what a follower depends on, its own last."""
    return [block.as_pointer() for block in of(data) if block is not None]


def _in_order(blocks):
    """(the followers, each after the shape that it follows; those of a circle)."""
    left = {key(data): data for data in blocks}
    sorter = graphlib.TopologicalSorter({name: {key(source.data) for source in recipes.all_pointers(data) if source.data}
                                         for name, data in left.items()})
    with contextlib.suppress(graphlib.CycleError):
        sorter.prepare()
    order = []
    while sorter.is_active():
        ready = sorter.get_ready()
        order += [left.pop(name) for name in sorted(ready) if name in left]
        sorter.done(*ready)
    return order, list(left.values())
