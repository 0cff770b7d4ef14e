"""What shapes are made of is the same at every call. numpy's functions of angles, roots and powers of e are not to the last digit:
they take another way where a result happens to lie right behind its argument in memory. Those of `math` are."""

import re

from addon_core import ADDON

FUNCTIONS = re.compile(r"np\.(sin|cos|tan|arc(sin|cos|tan2?)|sinh|cosh|tanh|exp2?|expm1|log(2|10|1p)?|cbrt)\(")
#: What is only shown, told or compared.
SHOWN = {"core/analysis/frames.py", "core/surfaces/neighbors.py", "core/deform/pulling.py", "bridge/analysis/deviation_targets.py"}


def test_numpy_makes_no_shapes_by_functions_that_may_round_otherwise():
    found = {str(path.relative_to(ADDON)) for room in ("core", "bridge") for path in (ADDON / room).rglob("*.py")
             if FUNCTIONS.search(path.read_text())}
    assert found == SHOWN
