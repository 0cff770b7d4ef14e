"""Random steps of a careless user with patches: verbs, faces, paint, joins, undo; nothing breaks or is lost."""

import bpy

from patches import MORE, value_of
from shapes import OF_PATCHES, activate, add, names_of, require_exact
from support import part, vertices
from test_random_walk import LARGEST, MOST_OBJECTS, SEED, Walk, run

mesh_layers, overlay, shape, store, surveys = (part(name) for name in (
    'bridge.mesh.mesh_layers', 'ui.seams_overlay', 'bridge.shape.shape', 'bridge.data.store', 'bridge.analysis.surveys'))
VERBS = names_of(OF_PATCHES)
KINDS = (*MORE, 'bezier patch', 'hermite patch', 'nurbs patch', 'mixed set')
STEPS = 400


class PatchWalk(Walk):
    """Of the steps of a Walk those that matter to patches come more often."""

    ODDS = {**Walk.ODDS, 'verb': 12, 'fineness': 5, 'undo': 5, 'add': 4, 'paint': 3, 'join_patches': 4, 'delete': 2,
            'extract': 1, 'material': 2, 'tolerance_from_render': 1, 'size': 0.5, 'remesh': 0.5, 'add_native': 0.1}

    def check(self):
        """Every shape that no hand has changed, and whose settings can be shown, is what its definition says."""
        for ob in self.shapes():
            data = ob.data
            if ob.mode == 'OBJECT' and not (ob.library or data.library or data.shape_keys or data.splinewright.problem):
                if not shape.is_touched(data) and not store.is_draft(data):
                    require_exact(ob)
                    self.checked += 1

    def object_add(self):
        if len(bpy.data.objects) < MOST_OBJECTS:
            add(value_of(self.any(KINDS)))

    def patches(self, most=1):
        """Make some patch shapes selected; the active one, or None."""
        chosen = [ob for ob in self.shapes() if ob.type == 'MESH' and ob.visible_get()]
        if not chosen:
            return None
        activate(*dict.fromkeys(self.any(chosen) for _ in range(most)))
        return bpy.context.object

    def object_verb(self):
        ob = self.patches(int(self.random.integers(1, 3)))
        if ob and store.has_definition(ob.data) and store.read(ob.data).pool.shape[0] < LARGEST:
            name = self.any(VERBS)
            operator = getattr(bpy.ops.splinewright, name)
            known = operator.get_rna_type().properties.keys()
            wanted = {'direction': self.any(('U', 'V', 'BOTH')), 'piece': int(self.random.integers(0, 3)),
                      'parameter_u': self.random.uniform(-0.1, 1.1), 'parameter_v': self.random.uniform(0, 1),
                      'rho': self.random.uniform(0.3, 3), 'tolerance': self.any((0.0, 1e-3, 10.0))}
            self.op(operator, **{key: value for key, value in wanted.items() if key in known})

    def object_join_patches(self):
        ob = self.patches(int(self.random.integers(1, 3)))
        if ob and bpy.ops.splinewright.join_patches.poll() and len(store.read(ob.data).pieces) < 12:
            self.op(bpy.ops.splinewright.join_patches, continuity=self.any(('C0', 'G1', 'C1', 'G2', 'C2')),
                    moves=self.any(('first', 'second', 'both')))

    def object_extract(self):
        if self.patches() and len(bpy.data.objects) < MOST_OBJECTS:
            self.op(self.any((bpy.ops.splinewright.extract_isocurve, bpy.ops.splinewright.extract_boundary)))

    def any_fineness(self):
        ob = self.any([ob for ob in self.shapes() if ob.type == 'MESH'])
        if ob:
            settings = ob.data.splinewright
            settings.tolerance = self.any((0.5, 0.2, 0.05))
            settings.mode = self.any(('COUNT', 'TOLERANCE', 'ANGLE', 'BOTH'))
            settings.set_resolution(*self.random.integers(1, 6, 2).tolist())
            self.push("fineness")

    def object_tolerance_from_render(self):
        if self.patches(2):
            scene = bpy.context.scene
            camera = bpy.data.objects.get("camera") or bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
            if camera.name not in scene.collection.objects:
                scene.collection.objects.link(camera)
            camera.location, scene.camera = self.random.uniform(-20, 20, 3), camera
            self.op(bpy.ops.splinewright.tolerance_from_render, pixels=20.0)

    def object_material(self):
        ob = self.patches()
        if ob and not ob.data.library:
            if len(ob.data.materials) < 4:
                ob.data.materials.append(bpy.data.materials.new("any"))
            self.op(bpy.ops.splinewright.set_patch_material, piece=int(self.random.integers(0, 4)),
                    slot=int(self.random.integers(0, 4)))

    def object_paint(self):
        ob = self.patches()
        if ob and not ob.library and not ob.data.library:
            kind = self.any(tuple(mesh_layers.ATTRIBUTES))
            if kind in bpy.types.Attribute.bl_rna.properties['data_type'].enum_items and len(ob.data.attributes) < 20:
                ob.data.attributes.new(kind, kind, self.any(('POINT', 'FACE', 'CORNER', 'EDGE')))
            group = ob.vertex_groups.get("group") or ob.vertex_groups.new(name="group")
            group.add(list(range(len(vertices(ob.data)) // 2)), 0.5, 'REPLACE')
            if ob.data.uv_layers and len(ob.data.uv_layers) < 8:
                ob.data.uv_layers.new(name="any")
            self.push("paint")

    def object_size(self):
        ob = self.patches()
        if ob:
            ob.scale = (float(self.any((1e-3, 1e3, 0.0, -1.0))),) * 3
            self.push("size")

    def any_look_at_the_seams(self):
        for ob in self.shapes():
            surveys.survey_of(ob.data)
            if ob.type == 'MESH':
                overlay.colored_lines(ob.data)


def test_random_steps_with_patches(tmp_path):
    walk = PatchWalk(SEED, tmp_path)
    run(walk, STEPS)
    walk.check()
    print(f"{walk.done['object_verb']} verbs, {walk.done['object_join_patches']} joins, {walk.checked} shapes compared")
    assert walk.done['object_verb'] > 8 and walk.checked > 20
