"""What may go wrong at a door of Splinewright, and how it is said.

A Refusal, an error of the library, a file that cannot be reached and memory that is not there are told to the modeler
as sentences. Anything else is a mistake of the add-on: its traceback is shown.
"""

import re
import traceback
from contextlib import contextmanager

from .library import sc
from .words import Phrase, phrase


class Refusal(ValueError):
    """Something is not done, for a reason that a modeler understands; nothing has changed: a phrase, see words.py."""

    def __init__(self, pattern="", /, one="", **arguments):
        super().__init__(phrase(pattern, one, **arguments))


class WrongKind(Refusal, TypeError):
    """Something of another kind was given than is taken."""


class AboutInputs(Refusal):
    """Something is not made for a reason that lies in some of its inputs: a sentence with {} for each, and their numbers from 0;
    arguments fill the rest of it."""

    def __init__(self, text, *numbers, **arguments):
        self.text, self.numbers, self.arguments = text, numbers, arguments
        super().__init__(*self._filled(phrase("input {number}", number=number + 1) for number in numbers))

    def named(self, names):
        """The Refusal with the names of the inputs."""
        return Refusal(*self._filled(names[number] for number in self.numbers))

    def _filled(self, names):
        """A phrase with {a}, {b} ... for the inputs, as it stands in the catalog."""
        letters = iter("abcdefghij")
        pattern = re.sub(r"(?<!\{)\{\}(?!\})", lambda _: f"{{{next(letters)}}}", self.text)
        return (phrase(pattern, **dict(zip("abcdefghij", names)), **self.arguments),)


@contextmanager
def about_input(number):
    """A refusal in here concerns the input of a number, from 0."""
    try:
        yield
    except AboutInputs:
        raise
    except Refusal as error:
        raise AboutInputs("{}: {reason}", number, reason=error.args[0]) from error


@contextmanager
def about_items(**numbers):
    """What the library refuses in here of items that it counts, such as sections[2], or side 2, lies in inputs: for the name of what
    it counts their numbers from 0."""
    try:
        yield
    except (sc.InvalidShape, sc.ToleranceNotReached) as error:
        found = []

        def put(match):
            name, index = match.group(1), int(match.group(2))
            if index >= len(numbers[name]):
                return match.group(0)
            found.append(numbers[name][index])
            return "{}"
        text = re.sub(rf"\b({'|'.join(numbers)})(?:\[| )(\d+)\b\]?", put, str(error).replace("{", "{{").replace("}", "}}"))
        if not found:
            raise
        raise AboutInputs(text, *found) from error


#: What a modeler is told of; where the library is missing, nothing of its own.
FAILURES = (Refusal, OSError, MemoryError, *([sc.Error] if sc else []))


def sentence(error):
    """One of the FAILURES in words."""
    if isinstance(error, MemoryError):
        return "there is not enough memory"
    if isinstance(error, Refusal) and isinstance(error.args[0], Phrase):
        return error.args[0]
    return getattr(error, 'strerror', None) or str(error)


def text_of(error):
    """Any exception in words, for places that must continue whatever happens. A mistake of the add-on shows its traceback, too."""
    if isinstance(error, FAILURES):
        return sentence(error)
    traceback.print_exception(type(error), error, error.__traceback__)
    return phrase("an error in Splinewright, shown in the console ({kind}: {error})", kind=type(error).__name__, error=error)


@contextmanager
def blenders_refusals():
    """What Blender's own operators refuse is refused in their words."""
    try:
        yield
    except RuntimeError as error:
        raise Refusal(str(error).strip().removeprefix("Error: ")) from error
