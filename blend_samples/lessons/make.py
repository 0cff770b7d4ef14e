"""Makes the films of lessons inside Blender: blender --background --python make.py -- FOLDER [LESSON...]

A WebP with moving pictures for each lesson, or for those that are named.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from PIL import Image, ImageDraw, ImageFont                 # noqa: E402

import motion                                               # noqa: E402
import raster                                               # noqa: E402

shelf = motion.part('bridge.lessons.shelf')
#: In pixels: a picture, the line above it, and each line below it.
PIXELS, TITLE, LINE = 560, 34, 22
#: Debian's fonts-dejavu-core.
_FOLDER = Path("/usr/share/fonts/truetype/dejavu")
_QUALITY = 60


def make(lesson, path):
    """Write the film of a lesson; its seconds."""
    frames = list(motion.frames_of(lesson))
    lines = max(len(frame.lines) for frame in frames)
    images = [_image(lesson, frame, lines) for frame in frames]
    durations = [round(1000 * frame.seconds) for frame in frames]
    images[0].save(path, 'WEBP', save_all=True, append_images=images[1:], duration=durations, loop=0, quality=_QUALITY, method=4)
    return sum(durations) / 1000


def _image(lesson, frame, lines):
    drawn = raster.image(frame.figure, PIXELS)
    page = Image.new('RGB', (PIXELS, TITLE + drawn.height + LINE * lines + LINE // 2), 'white')
    page.paste(drawn, (0, TITLE))
    writing = ImageDraw.Draw(page)
    writing.text((12, 8), lesson.title, fill='black', font=_font("DejaVuSans-Bold.ttf"))
    writing.text((PIXELS - 12, 8), f"{frame.number + 1} / {len(lesson.steps)}", fill='gray', font=_font("DejaVuSans.ttf"), anchor='ra')
    for row, line in enumerate(frame.lines):
        writing.text((12, TITLE + drawn.height + LINE * row), line, fill='black', font=_font("DejaVuSans.ttf"))
    return page


def _font(name):
    return ImageFont.truetype(str(_FOLDER / name), 15)


def main(folder, named):
    folder.mkdir(parents=True, exist_ok=True)
    lessons = shelf.all_lessons()
    unknown = set(named) - set(lessons)
    if unknown:
        sys.exit(f"There are no lessons {', '.join(sorted(unknown))}: they are {', '.join(lessons)}")
    wanted = [lesson for name, lesson in lessons.items() if not named or name in named]
    for count, lesson in enumerate(wanted, 1):
        path = folder / f"{lesson.name}.webp"
        seconds = make(lesson, path)
        print(f"[{count} of {len(wanted)}] {path.name}: made, {seconds:.0f} s, {path.stat().st_size:,} bytes", flush=True)


if __name__ == '__main__':
    place, *names = sys.argv[sys.argv.index('--') + 1:]
    main(Path(place), names)
