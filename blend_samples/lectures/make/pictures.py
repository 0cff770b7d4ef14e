"""The 75 pictures of the five lectures, in the order of the lectures."""

import lecture_000
import lecture_001
import lecture_002_004

PICTURES = (*lecture_000.PICTURES, *lecture_001.PICTURES, *lecture_002_004.PICTURES)
#: Pictures that the add-on cannot make yet, with the reason.
MISSING = {}


def file_of(picture):
    """The name of the file of a picture."""
    return f"{picture.number}.{'png' if picture.rendered else 'svg'}"
