"""One report a call: Blender's status bar shows only the last one, which must tell of everything, the worst last."""

from typing import NamedTuple

from ...bridge.data.file_state import state
from ...core.base.failures import FAILURES, blenders_refusals, sentence
from ...core.base.words import phrase, say

#: Texts of one kind that are said; of others only how many there are.
_MOST = 3


class Report(NamedTuple):
    """A report on finished work."""

    done: str = ""
    notes: tuple = ()                   # what else is good to know
    warnings: tuple = ()                # what was not done, or was lost


def finished(operator, said):
    """Report what was done, if there is anything to tell. Returns what the operator's execute() returns."""
    said = said._replace(warnings=(*said.warnings, *state.lost_keys))
    state.lost_keys.clear()
    _report(operator, 'WARNING' if said.warnings else 'INFO', _parts(said))
    return {'FINISHED'}


def in_words(said):
    return "; ".join(_parts(said))


def _parts(said):
    return [*filter(None, [said.done, *_few(said.notes), *_few(said.warnings)])]


def cancelled(operator, *reasons):
    """Report why nothing was done and nothing changed. Returns what the operator's execute() returns."""
    _report(operator, 'ERROR', _few(reasons))
    return {'CANCELLED'}


def stopped(operator, text):
    """Report that a user stopped it and nothing changed. Returns what the operator's modal() returns."""
    _report(operator, 'INFO', [text])
    return {'CANCELLED'}


def failed(operator, error, name=""):
    """cancelled() for an exception, of the object of this name if it is one object's."""
    return cancelled(operator, named(name, sentence(error)) if name else sentence(error))


def called(operator, other, **settings):
    """Call another operator as a part of one, with an undo step. What it refuses is reported. Returns what the operator's execute()
    returns."""
    try:
        with blenders_refusals():
            return other('EXEC_DEFAULT', True, **settings)
    except FAILURES as error:
        return failed(operator, error)


def named(name, text):
    """A sentence about an object that names it."""
    return text if text.startswith(name) else phrase("{name}: {text}", name=name, text=text)


def by_name(texts):
    """Sentences of {name: text}, each said once for all whom it concerns."""
    names = {}
    for name, text in texts.items():
        names.setdefault(text, []).append(name)
    return tuple(named(listed(of_text), text) for text, of_text in names.items())


def listed(names):
    """A, B, C and 4 more, of a list."""
    shown, more = names[:_MOST], len(names) - _MOST
    return ", ".join(shown) + (phrase(" and {count} more", count=more) if more > 0 else "")


def _few(texts):
    shown, more = list(texts[:_MOST]), len(texts) - _MOST
    return shown + ([phrase("and {count} more", count=more)] if more > 0 else [])


def _report(operator, kind, texts):
    text = "; ".join(map(say, filter(None, texts)))
    if text:
        operator.report({kind}, text)
