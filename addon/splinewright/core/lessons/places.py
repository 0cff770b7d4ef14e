"""Parts of a lesson's file, which say where they are when they are refused."""

from ..base.failures import Refusal
from ..base.words import phrase

#: Most entries of a list, characters of a text, and characters of a refusal.
MOST_ENTRIES, MOST_TEXT, _MOST_SAID = 40, 2000, 1000


class Place:
    """A part of a file, and where it is."""

    def __init__(self, where, found):
        self.where, self.found = where, found

    def fail(self, pattern, /, **arguments):
        what = phrase(pattern, **arguments)
        raise Refusal("{where}: {what}", where=self.where, what=what if len(what) <= _MOST_SAID else what[:_MOST_SAID] + "…")

    def fields(self, needed, optional=()):
        """Of an object: {name: Place} of the fields that are there."""
        if not isinstance(self.found, dict):
            self.fail("an object is expected")
        for name in self.found:
            if name not in needed and name not in optional:
                self.fail("{name!r} is not known; there may be {names}", name=name, names=', '.join((*needed, *optional)))
        for name in needed:
            if name not in self.found:
                self.fail("{name!r} is missing", name=name)
        return {name: Place(f"{self.where}, {name}", value) for name, value in self.found.items()}

    def entries(self):
        """Of a list: a Place each."""
        if not isinstance(self.found, list):
            self.fail("a list is expected")
        if len(self.found) > MOST_ENTRIES:
            self.fail("there are {count} entries: {most_entries} are the most", count=len(self.found), most_entries=MOST_ENTRIES)
        return [Place(f"{self.where} {i + 1}", value) for i, value in enumerate(self.found)]

    def text(self, choices=()):
        if not isinstance(self.found, str) or not self.found or len(self.found) > MOST_TEXT:
            self.fail("a text of at most {count:,} characters is expected", count=MOST_TEXT)
        self.has_characters()
        if choices and self.found not in choices:
            self.fail("{found!r} must be one of {choices}", found=self.found, choices=', '.join(choices))
        return self.found

    def has_characters(self):
        """Refuse texts that Blender cannot keep."""
        if "\0" in self.found or any("\ud800" <= one <= "\udfff" for one in self.found):
            self.fail("it has characters that cannot be kept")

    def number(self):
        if isinstance(self.found, bool) or not isinstance(self.found, (int, float)) or not abs(self.found) < 1e12:
            self.fail("a number below 1e12 is expected")
        return float(self.found)

    def whole(self, least=0):
        if isinstance(self.found, bool) or not isinstance(self.found, int) or not least <= self.found < 10**6:
            self.fail("a whole number from {least} is expected", least=least)
        return self.found
