"""Numbers in messages are as Blender's fields show them."""

import pytest

from addon_core import core

decimals = core("base.decimals")


@pytest.mark.parametrize('number, digits, text', (
    (1e-6, 4, "0.000001"), (1.23456e-5, 4, "0.00001235"), (0.05, 2, "0.05"), (0.1 + 0.2, 4, "0.3"), (9.99e-7, 4, "9.99e-07"),
    (9.99999e-7, 4, "0.000001"), (0.99999, 2, "1"), (1234.5678, 4, "1235"), (0.0, 4, "0"), (-0.00012, 2, "-0.00012"),
    (1e-150, 2, "1e-150"), (float('inf'), 4, "inf"), (float('nan'), 4, "nan")))
def test_a_length_in_a_message_is_as_fields_show_it(number, digits, text):
    assert decimals.text_of(number, digits) == text
