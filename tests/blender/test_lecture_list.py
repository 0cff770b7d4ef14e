"""The 75 pictures of the lectures: each is made from an empty scene by operators, in no more steps than are stated, and shows what is true."""

import sys
from pathlib import Path

import bpy
import numpy as np
import pytest

import lecture_checks_of_curves  # noqa: F401  what is true of the others
from lecture_checks import CHECKS
from support import part

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "blend_samples/lectures/make"))
import draw
import field_names
import making
import page
import pictures

figure, shape = part('core.figures.figure'), part('bridge.shape.shape')
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


@pytest.mark.parametrize('number', ('000.9', '000.72', '001.20', '001.29', '001.43', '002.14f', '004.32', '004.45'))
def test_a_picture_is_drawn_on_its_page(number):
    drawing = draw.draw(PICTURES[number])
    assert not drawing.left_out
    strokes = [item for group in drawing.figure.groups for item in group.items if isinstance(item, figure.Stroke)]
    places = np.vstack([np.vstack([path.start, *path.steps]) for stroke in strokes for path in stroke.paths])
    inside = ((places > 0.0) & (places < (drawing.figure.width, drawing.figure.height))).all(axis=1)
    assert np.ptp(places[inside], axis=0).max() > 30.0
    assert inside.all() or number == '001.20', "only a line goes on beyond its page"


def test_a_picture_of_light_on_faces_is_rendered(tmp_path, monkeypatch):
    monkeypatch.setattr(draw, '_SAMPLES', 1)
    (picture,) = (picture for picture in pictures.PICTURES if picture.rendered)
    draw.main(tmp_path, [picture.number])
    image = bpy.data.images.load(str(tmp_path / f"{picture.number}.png"))
    rows = np.array(image.pixels[:]).reshape(image.size[1], image.size[0], 4)
    assert image.size[0] == draw._PIXELS and np.ptp(rows[:, :, 0]) > 0.3
    border = np.concatenate([rows[0], rows[-1], rows[:, 0], rows[:, -1]])
    assert np.ptp(border[:, 0]) < 0.05, "what it shows lies within its border"


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
