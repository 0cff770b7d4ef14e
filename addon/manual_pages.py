"""The pages of the manual as they are written: in English, and the first of them in other languages, in folders of these.

A translation begins with its title and, on a separate line,

    <!-- English: 0123456789ab -->   the fingerprint of the English text that it was made from

It links English pages as ../NAME.md; that they are in English is added, so a page that is translated later changes no words.
"""

import hashlib
import re
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
SOURCE = PROJECT / "addon/manual"
#: In the order in which they are read.
PAGES = ("index", "five-minutes", "workflows", "choosing", "tools", "keyboard", "nets", "curves", "surfaces", "modify", "continuity",
         "seeing", "following", "animation", "shapes", "teaching", "lectures", "files", "python", "preferences", "performance", "troubleshooting")
ENGLISH = "en"
#: What each language calls itself.
LANGUAGES = {"en": "English", "it": "Italiano", "pl": "Polski", "ru": "Русский"}
#: That a page is in English, for those who read another language.
IN_ENGLISH = {"it": "in inglese", "pl": "po angielsku", "ru": "на английском"}
_MADE_FROM = re.compile(r"^<!-- English: (\w*) -->\n", re.M)


class Broken(ValueError):
    """A page links a target that is not there."""


def path(name, language=ENGLISH):
    return (SOURCE if language == ENGLISH else SOURCE / language) / f"{name}.md"


def address(name, language=ENGLISH):
    """Of a page inside the manual, without its ending."""
    return name if language == ENGLISH else f"{language}/{name}"


def languages_of(name):
    """The languages that a page is there in, English first."""
    return [language for language in LANGUAGES if path(name, language).is_file()]


def source(name, language=ENGLISH):
    return path(name, language).read_text()


def title(name, language=ENGLISH):
    return re.match(r"# (.+)", source(name, language))[1]


def text(name, language=ENGLISH):
    """A page as it is read: parts of the README are put in, and a translation marks links to English pages."""
    if language == ENGLISH:
        readme = (PROJECT / "README.md").read_text()
        return re.sub(r"^<!-- README: (.+) -->$", lambda found: section(readme, found[1]), source(name), flags=re.M)
    return re.sub(r"(?<!!)\[[^\]]+\]\(\.\./[\w-]+\.md[^)]*\)", rf"\g<0> ({IN_ENGLISH[language]})", _MADE_FROM.sub("", source(name, language)))


def section(readme, heading):
    """The text below a heading of the README, up to the next one of its rank."""
    found = re.search(rf"^## {re.escape(heading)}\n(.*?)(?=^## |\Z)", readme, re.S | re.M)
    if not found:
        raise Broken(f"the README has no section {heading}")
    return found[1]


def fingerprint(name):
    """Of the English text, without what F1 leads to and without line breaks."""
    said = re.sub(r"<!-- F1: .*? -->", "", text(name), flags=re.S)
    return hashlib.sha256(" ".join(said.split()).encode()).hexdigest()[:12]


def made_from(name, language):
    """The fingerprint that a translation says it was made from, or None."""
    found = _MADE_FROM.search(source(name, language))
    return found and found[1]
