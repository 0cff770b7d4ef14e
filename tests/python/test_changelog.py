"""The changelog has the form of Keep a Changelog, and the version that everything has."""

import re
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
TEXT = (PROJECT / "addon/splinewright/CHANGELOG.md").read_text()
KINDS = {"Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"}


def test_headings_are_versions_and_kinds_of_changes():
    levels = re.findall(r"^(#+) (.+)$", TEXT, re.M)
    assert levels[0] == ("#", "Changelog")
    for i, (level, title) in enumerate(levels[1:]):
        if level == "##":
            assert re.fullmatch(r"\[(?:Unreleased\]|\d+\.\d+\.\d+\] - (?:Unreleased|\d{4}-\d\d-\d\d))", title), title
        else:
            assert level == "###" and title in KINDS and i > 0, title


def test_the_first_version_is_that_of_the_library():
    version = re.search(r"project\(splinecore VERSION ([0-9.]+)", (PROJECT / "native/CMakeLists.txt").read_text())[1]
    assert re.findall(r"^## \[([0-9.]+)\]", TEXT, re.M)[0] == version


def test_every_line_of_changes_is_one_of_a_list():
    """Below a kind: items, what continues them, and subjects in bold."""
    for line in TEXT.partition("### ")[2].splitlines()[1:]:
        assert not line or re.match(r"- |  \S|\*\*.+\*\*$|##", line), line
