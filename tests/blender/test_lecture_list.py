"""The 75 pictures of the lectures: each is made from an empty scene by operators, in no more steps than are stated, and shows what is true."""

import sys
from pathlib import Path

import bpy
import pytest

import lecture_checks_of_curves  # noqa: F401  what is true of the others
from lecture_checks import CHECKS
from support import part

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "blend_samples/lectures"))
import field_names
import making
import page
import pictures

shape = part('bridge.shape.shape')
#: Of 75 pictures so many cannot be made. It only falls.
MISSING = 0
PICTURES = {picture.number: picture for picture in pictures.PICTURES}


def test_all_pictures_are_there_and_each_has_its_truth():
    assert len(PICTURES) == len(pictures.PICTURES) and len(PICTURES) + len(pictures.MISSING) == 75
    assert len(pictures.MISSING) <= MISSING and all(pictures.MISSING.values())
    assert set(CHECKS) == set(PICTURES)


@pytest.mark.parametrize('number', PICTURES)
def test_a_picture_is_made_in_its_steps_and_is_true(number, capfd):
    picture = PICTURES[number]
    assert 0 < len(picture.steps) <= picture.most, f"{len(picture.steps)} steps"
    made = making.make(picture)
    assert "Error:" not in capfd.readouterr().out
    assert bpy.context.mode == 'OBJECT' and made and all(shape.has_shape(ob) for ob in made)
    CHECKS[number](made)


def test_the_page_calls_commands_by_their_names():
    for operator, words in page._WORDS.items():
        room, _, name = operator.partition(".")
        label = getattr(getattr(bpy.ops, room), name).get_rna_type().name
        assert words == "**Tab**" or words.strip("*") in (label, label.removeprefix("Add ")), (operator, label)


def test_the_page_calls_fields_and_choices_by_their_names():
    for operator, labels in field_names.FIELDS.items():
        room, _, name = operator.partition(".")
        properties = getattr(getattr(bpy.ops, room), name).get_rna_type().properties
        for field, label in labels.items():
            assert properties[field].name == label, (operator, field)
            known = field_names.CHOICES.get((operator, field))
            if properties[field].type == 'ENUM':
                items = {item.identifier: item.name for item in properties[field].enum_items}
                assert known and known.items() <= items.items(), (operator, field, items)
            else:
                assert known is None, (operator, field)
