"""The list of the lectures' pictures, and the page of the manual that has them."""

import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "blend_samples/lectures"))

import field_names
import page
import pictures
import steps


def order(number):
    lecture, _, item = number.partition(".")
    digits = item.rstrip("abcdf")
    return lecture, int(digits), item[len(digits):]


def test_there_are_75_in_the_order_of_the_lectures():
    numbers = [picture.number for picture in pictures.PICTURES]
    assert len(numbers) + len(pictures.MISSING) == 75 and len({*numbers, *pictures.MISSING}) == 75
    assert numbers == sorted(numbers, key=order)


def test_no_picture_states_more_steps_than_it_takes():
    for picture in pictures.PICTURES:
        assert 0 < len(picture.steps) <= picture.most <= 15, picture.number


def test_the_page_of_the_manual_is_the_list():
    assert page.PAGE.read_text() == page.page(), "write it again: /usr/bin/python3 blend_samples/lectures/page.py"


def named_steps():
    """Steps that are written as a command with its fields."""
    told = {steps.CLICK, steps.CHOOSE, 'transform.translate', 'transform.resize', 'splinewright.show_sight'}
    return [step for picture in pictures.PICTURES for step in picture.steps if step.operator not in told]


def test_every_field_has_its_label_and_no_label_is_left_over():
    used = {(step.operator, name) for step in named_steps() for name in step.settings}
    assert used == {(operator, name) for operator, labels in field_names.FIELDS.items() for name in labels}
    assert set(field_names.CHOICES) <= used


def test_the_page_names_no_field_as_scripts_do():
    written = page.PAGE.read_text()
    names = {name for step in named_steps() for name in step.settings}
    found = {name for name in names if "_" in name and (name in written or f"* {name.replace('_', ' ')} " in written)}
    assert not found
    values = {value for step in named_steps() for name, value in step.settings.items() if (step.operator, name) in field_names.CHOICES}
    assert not {value for value in values if f"`{value}`" in written}
