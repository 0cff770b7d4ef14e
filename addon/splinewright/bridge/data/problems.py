"""Why a shape does not show what it should: the one place where that is kept, for panel, viewport and status bar.

A problem is about one thing, so that what mends that takes it away and nothing else.
"""

from .file_state import key, state

#: The last change of a setting or of a recipe's number.
SETTING = "setting"
#: What keys and drivers give its settings and its recipe's parameters.
KEYED = "keyed"
#: What the shape is made from.
FOLLOWING = "following"
#: What of that was deleted, or is in no scene.
INPUTS = "inputs"
#: Of a net's data-block: what the shape does not take.
NET = "net"
#: Of a net's data-block: what the shape passes over, which is no trouble.
STRAYS = "strays"
#: Of a net's data-block: where the last file has what the shape does not take.
SAVED = "saved"


def set_problem(data, about, sentence):
    """Keep a sentence; "" takes the one about the same thing away."""
    name = key(data)
    if sentence:
        state.problems.setdefault(name, {})[about] = sentence
    elif name in state.problems:
        state.problems[name].pop(about, None)


def of(data, about):
    """The sentence about one thing, or ""."""
    return state.problems.get(key(data), {}).get(about, "")


def told_of(*abouts):
    """The file_state.key() of data-blocks of which something is told about one of these things."""
    return {name for name, of_data in state.problems.items() if not of_data.keys().isdisjoint(abouts)}


def clear(data):
    """Nothing is said of a data-block any more."""
    state.problems.pop(key(data), None)


def forget(about):
    """Remove problems of one kind from all data-blocks: those that remain will be reported again."""
    for of_data in state.problems.values():
        of_data.pop(about, None)
