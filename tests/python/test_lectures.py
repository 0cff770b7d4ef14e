"""The list of the lectures' pictures, and the page of the manual that has them."""

import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "blend_samples/lectures"))

import page
import pictures


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
