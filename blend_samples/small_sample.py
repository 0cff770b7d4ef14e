"""Packs the shapes of an opened sample scene into a small file: their definitions, with few faces, as a collection.

    blender --background SAMPLE.blend --python small_sample.py -- OUTPUT
"""

import sys
from pathlib import Path

import bpy

#: Of each sample the objects that are taken if not all shapes are, and those that are assets.
TAKEN = {
    'vase': (("Vase: Cubic B-spline", "Profile: Cubic B-spline"), ("Vase: Cubic B-spline",)),
    'shampoo': ((), ("Bottle", "Cap", "Nozzle")),
    'mouse': ((), ("Mouse",)),
    'hull': ((), ("Half, both",))}
#: Faces in a span, of what is shown finely again when it is added.
_FEW = 2


def pack(output):
    path = Path(bpy.data.filepath)
    label, (names, assets) = label_of(path.stem), TAKEN[path.stem]
    collection = bpy.data.collections.new(label)
    for ob in bpy.context.scene.objects:
        if ob.name in names or not names and _is_ours(ob):
            collection.objects.link(ob)
    for name in assets:
        collection.objects[name].asset_mark()
        collection.objects[name].asset_data.description = f"Sample of Splinewright: {label}"
    if names:
        _to_origin(collection, names[0])
    for ob in collection.objects:
        if ob.type == 'MESH':
            ob.data.splinewright.set_resolution(_FEW, _FEW)
    target = Path(output) / path.name
    bpy.data.libraries.write(str(target), {collection}, compress=True)
    print(f"packed {target.name}: {len(collection.objects)} objects, {target.stat().st_size:,} bytes")


def label_of(name):
    """What the installed add-on calls a sample."""
    table = next(module for known, module in sys.modules.items() if known.endswith('splinewright.ui.operators.add_sample'))
    return {known: label for known, label, _ in table.SAMPLES}[name]


def _is_ours(ob):
    return ob.type in ('MESH', 'CURVE') and ob.data.splinewright.value is not None


def _to_origin(collection, name):
    """All objects without parents, so that the one of a name stands at the origin."""
    place = collection.objects[name].matrix_world.translation.copy()
    for ob in collection.objects:
        if ob.parent is None:
            ob.location -= place


pack(sys.argv[sys.argv.index("--") + 1])
