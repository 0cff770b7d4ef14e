"""Small numbers of the library: those of rounding stand in one header, and others get fewer."""

import re
from pathlib import Path

NATIVE = Path(__file__).resolve().parents[2] / "native"
SMALL = re.compile(r"\b(?:0x1(?:\.[0-9a-f]+)?p-\d{2,}|\d+(?:\.\d*)?e-\d+)\b")
#: To be lowered with each that goes; never raised.
LITERALS = 399
ROUNDINGS = 37


def lines(*folders):
    for folder in folders:
        for path in sorted((NATIVE / folder).rglob("*.?pp")):
            if path.name == "rounding.hpp":
                continue
            for number, line in enumerate(path.read_text("utf-8").splitlines(), 1):
                yield path.relative_to(NATIVE), number, line.split("//")[0]


def test_small_literals_get_fewer():
    found = [f"{path}:{number}" for path, number, line in lines("src", "include") for _ in SMALL.findall(line)]
    assert len(found) == LITERALS, f"{len(found)} small literals: use base/rounding.hpp or another named one, and lower the number"


def test_roundings_of_files_get_fewer():
    found = [f"{path}:{number}" for path, number, line in lines("src") if re.search(r"double kRounding\b", line)]
    assert len(found) == ROUNDINGS, found


def test_levels_of_rounding_have_their_reasons():
    text = (NATIVE / "src/base/rounding.hpp").read_text("utf-8")
    levels = re.findall(r"/// [^\n]+\ninline constexpr double (kRoundingOf\w+) = 0x1p-(\d+);", text)
    assert len(levels) == text.count("inline constexpr") and [int(bits) for _, bits in levels] == sorted((int(bits) for _, bits in levels), reverse=True)
