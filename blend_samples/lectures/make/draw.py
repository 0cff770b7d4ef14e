"""Draws the pictures of the lectures inside Blender: blender --background --python draw.py -- FOLDER [NUMBER...]

An SVG for each picture, or for those that are named; a PNG where light on faces is what it shows.
"""

import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Matrix

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1])]

import figures                                              # noqa: E402
import making                                               # noqa: E402
import pictures                                             # noqa: E402
import stage                                                # noqa: E402

svg = making.part('core.figures.svg')
#: In mm. A picture is as high as what it shows, within limits.
WIDTH, MARGIN, LOW, HIGH = 130.0, 9.0, 40.0, 110.0
#: Of a picture that is rendered: its width in pixels, and its samples.
_PIXELS, _SAMPLES = 960, 32


def draw(picture):
    """The drawn.Drawing of a picture, made in an empty scene."""
    view, points, turn = _made(picture)
    across, up, _ = np.ptp(points @ turn.T, axis=0)
    height = np.clip((WIDTH - 2.0 * MARGIN) * up / max(across, 1e-9 * up) + 2.0 * MARGIN, LOW, HIGH)
    return figures.draw(view, points, turn, WIDTH, float(height), MARGIN)


def render(picture, path):
    """A picture, made in a scene with a sun, rendered to a PNG."""
    _view, points, turn = _made(picture, stage.begin)
    low, high = (points @ turn.T).min(axis=0), (points @ turn.T).max(axis=0)
    across, up, deep = high - low
    stage.camera((0, 0, 0), (0, 0, -1))
    seeing = bpy.context.scene.camera
    seeing.data.type, seeing.data.ortho_scale = 'ORTHO', across * WIDTH / (WIDTH - 2.0 * MARGIN)
    eye = (low + high) / 2.0 + (0.0, 0.0, 2.0 * deep)
    seeing.matrix_world = Matrix.Translation(eye @ turn) @ Matrix(turn.T.tolist()).to_4x4()
    stage.render(path, _SAMPLES, (_PIXELS, round(_PIXELS * (up / across + 2.0 * MARGIN / WIDTH))))


def _made(picture, begin=lambda: bpy.ops.wm.read_homefile(use_empty=True)):
    begin()
    making.make(picture)
    view, points = figures.seen(bpy.context.scene)
    return view, points, figures.TURNS['FREE' if picture.view == 'SPACE' else picture.view]


def main(folder, named):
    folder.mkdir(parents=True, exist_ok=True)
    unknown = set(named) - {picture.number for picture in pictures.PICTURES}
    if unknown:
        sys.exit(f"There are no pictures {', '.join(sorted(unknown))}")
    wanted = [picture for picture in pictures.PICTURES if not named or picture.number in named]
    for count, picture in enumerate(wanted, 1):
        path = folder / pictures.file_of(picture)
        if picture.rendered:
            render(picture, path)
        else:
            drawing = draw(picture)
            if drawing.left_out:
                sys.exit(f"{picture.number}: {drawing.left_out}")
            path.write_text(svg.text_of(drawing.figure))
        print(f"[{count} of {len(wanted)}] {path.name}: made, {path.stat().st_size:,} bytes", flush=True)


if __name__ == '__main__':
    place, *numbers = sys.argv[sys.argv.index('--') + 1:]
    main(Path(place), numbers)
