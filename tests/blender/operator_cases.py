"""Every operator at work, for tests that look at what it makes: something to work on, settings, and which ones make no shape."""

import tempfile
from pathlib import Path

import bpy
import numpy as np

import natives
from blender_objects import grease_pencil
from curves import run
from shapes import activate, add, by_hand, enter, first_point, leave, move, op, select
from support import splinecore as sc
from test_curve_through import empties
from test_fit_patch import grid, mesh_in_edit_mode, quads, scan


def wave(shift=0.0, count=6, z=0.0):
    t = np.linspace(0, 3, count)
    knots = np.r_[[0.0] * 3, np.arange(count - 2.0), [count - 3.0] * 3]
    return sc.NurbsCurve(3, knots, np.stack([t, np.sin(t + shift) + 2, np.full(count, z)], -1))


def sheet(x=0.0, bend=0.3):
    u, v = np.meshgrid(np.linspace(0, 2, 5), np.linspace(0, 2, 5), indexing='ij')
    return sc.NurbsPatch((3, 3), ([0, 0, 0, 0, 1, 2, 2, 2, 2],) * 2, np.stack([u + x, v, bend * np.cos(2 * u * v) + 0.0], -1))


def frame():
    """Four curves, two each way, that cross at their ends."""
    sides = [((0, 0), (2, 0)), ((0, 2), (2, 2)), ((0, 0), (0, 2)), ((2, 0), (2, 2))]
    return [sc.BezierCurve([(*start, 0), (*np.mean([start, end], 0), 1), (*end, 0)]) for start, end in sides]


def bottle():
    return sc.PatchSet.from_patches([sc.build.extrude(sc.conics.circle((0, 0, 0), 1.0), (0, 0, 2))])


def box():
    square = sc.build.contour([(0, 0, 0), (3, 0, 0), (3, 2, 0), (0, 2, 0)], closed=True)
    return sc.PatchSet.from_patches(sc.build.cap([sc.build.extrude(square, (0, 0, 1))], None).value)


def cube():
    bpy.ops.mesh.primitive_cube_add()
    return bpy.context.object


def shapes_of(*values):
    return lambda: [add(value, f"shape {i}") for i, value in enumerate(values)]


LINE, CORNER = sc.BezierCurve([(0, 0, 0), (2, 0, 0)]), sc.build.contour([(0, 0, 0), (2, 0, 0), (2, 2, 0)])
AFTER = sc.BezierCurve([(2, 0, 0), (3, 1, 0)])
INSIDE = sc.BezierCurve([(0.2, 0.3, 0), (0.5, 0.9, 0), (0.9, 0.6, 0)])
ACROSS = sc.BezierCurve([(1, -1, 0), (1, 1, 0)])
UPRIGHT = sheet(bend=0.5).rotated(1.4, axis=(1, 0, 0), about=(1, 1, 0))
CLOUD = np.stack([np.linspace(0, 4, 40), np.sin(np.linspace(0, 6, 40)), np.linspace(0, 0.2, 40)], -1)
STROKE = " ".join(map(repr, CLOUD.ravel().tolist()))

#: What recipes follow.
FOLLOWED = {
    'revolve': shapes_of(wave()), 'extrude': shapes_of(wave()), 'ruled': shapes_of(wave(), wave(1, z=1)), 'pipe': shapes_of(wave()),
    'loft': shapes_of(wave(), wave(0.5, z=1), wave(1, z=2)), 'sweep': shapes_of(wave(), sc.conics.circle((0, 2, 0), 0.3)),
    'two_rails': shapes_of(wave(), wave(z=1), sc.BezierCurve([(0, 2, 0), (0, 2.5, 0.5), (0, 2, 1)])),
    'network': shapes_of(*frame()), 'filling': shapes_of(*frame()), 'surface_blend': shapes_of(sheet(), sheet(3)),
    'matched': shapes_of(sheet(), sheet(2.01)), 'rounded_edge': shapes_of(box()), 'offset_surface': shapes_of(sheet(bend=0.05)),
    'thickened': shapes_of(sheet(bend=0.05)), 'extended_surface': shapes_of(sheet()), 'of_mesh': lambda: [cube()],
    'mirror': shapes_of(sheet(1)), 'offset': shapes_of(wave()), 'about': shapes_of(wave()),
    'blend': shapes_of(wave(), sc.BezierCurve([(5, 2, 1), (6, 2, 2)])), 'section': shapes_of(sheet(), UPRIGHT),
    'planes': shapes_of(bottle()), 'on_patch': shapes_of(sheet(), INSIDE), 'basis': shapes_of(wave()),
    **{kind: shapes_of(wave()) for kind in ('basis_triangle', 'halving', 'hulls', 'chain_points', 'marks', 'discs', 'orders', 'influence', 'labels', 'lift', 'perspective')},
    'basis_products': shapes_of(sheet()),
    'construction': shapes_of(wave()), 'projected': shapes_of(INSIDE.translated((0, 0, 2)), sheet(bend=0.1)),
}
#: Of these recipes the operators have names of their own, among the others.
ELSEWHERE = {'follow': 'follow_object', 'through_objects': 'curve_through_points'}
#: Other operators: what is selected for them, and settings.
OTHERS = {
    'follow_object': (shapes_of(wave()), {}), 'fillet_corners': (shapes_of(CORNER), {'size': 0.5}), 'chamfer_corners': (shapes_of(CORNER), {'size': 0.5}),
    'fillet_curves': (shapes_of(LINE, ACROSS), {'radius': 0.3}), 'chamfer_curves': (shapes_of(LINE, ACROSS), {}),
    'trim_curve': (shapes_of(LINE, ACROSS), {'parameter': 0.8}), 'extend_curve': (shapes_of(wave()), {'to': 'LENGTH', 'by': 0.5, 'how': 'natural'}),
    'split_where_met': (shapes_of(LINE, ACROSS), {}), 'join_curves': (shapes_of(LINE, AFTER), {}),
    'join': (shapes_of(LINE, ACROSS), {}), 'join_patches': (shapes_of(sheet(bend=0), sheet(2, bend=0)), {}),
    'join_pieces': (shapes_of([LINE, AFTER]), {}), 'join_ends': (shapes_of(LINE, sc.BezierCurve([(3, 0, 0), (3, 1, 0)])), {}),
    'explode': (shapes_of([LINE, ACROSS]), {}), 'separate_pieces': (shapes_of([LINE, ACROSS]), {'piece': 2}),
    'delete_pieces': (shapes_of([LINE, ACROSS]), {'piece': 2}), 'extract_boundary': (shapes_of(sheet()), {}),
    'extract_isocurve': (shapes_of(sheet()), {}), 'cap': (shapes_of(bottle()), {}), 'make_deformable': (shapes_of(bottle()), {}),
    'set_knots': (shapes_of(wave()), {'knots': "0 0 0 0 1 1.5 3 3 3 3"}), 'move_knot': (shapes_of(wave()), {'knot': 5, 'parameter': 1.25}),
    'intersections': (shapes_of(sheet(), UPRIGHT), {}),
    'add_touching_circle': (shapes_of(LINE, ACROSS, sc.BezierCurve([(0, 1, 0), (2, 2, 0)])), {}),
    'draw_contour': (lambda: [], {'contour': "0 0 0; segment 4 0 0; arc 4 2 0; segment 0 2 0; closed"}),
    'draw_curve': (lambda: [], {'stroke': STROKE, 'tolerance': 0.0625}), 'draw_on_surface': (lambda: [], {'stroke': STROKE, 'tolerance': 0.0625}),
    'curve_through_points': (empties, {}), 'contour_through_points': (lambda: [grease_pencil(CLOUD[::8])], {}),
    'fit_curve': (lambda: [grease_pencil(CLOUD)], {'tolerance': 0.0625}),
    'fit_patch': (lambda: mesh_in_edit_mode(scan()), {'count_u': 6, 'count_v': 5}),
    'patch_through_grid': (lambda: mesh_in_edit_mode(grid(6, 5).reshape(-1, 3), quads(6, 5)), {}),
    'pull_here': (shapes_of(sheet()), {'piece': 1, 'parameter_u': 0.7, 'parameter_v': 1.2, 'vector': (0, 0, 1)}),
    'hold_joint': (shapes_of([LINE.elevate(2), AFTER.elevate(3)]), {
        'continuity': 'G1', 'moves': 'second', 'first': 1, 'first_end': 'end', 'second': 2, 'second_end': 'start'}),
    'hold_seam': (shapes_of(sc.PatchSet.from_patches([sheet(bend=0), sheet(2, bend=0)])), {
        'continuity': 'G1', 'moves': 'second', 'first': 1, 'first_side': 'u_end', 'second': 2, 'second_side': 'u_start'}),
    **{f"add_{name}": (lambda: [], {}) for name in (
        'line', 'bezier_chain', 'bezier_curve', 'hermite_curve', 'nurbs_curve', 'bezier_patch', 'hermite_patch', 'nurbs_patch', 'teapot')},
}


def in_net(value, do):
    """Do something to the second point of a curve in its net."""
    add(value)
    held = enter()
    select(held, first_point(held) + 1)
    do()
    leave()


def edited():
    in_net(wave(), lambda: move(0, 0.3, 0.5))


def back_from_infinity():
    def there_and_back():
        run('point_to_infinity')
        run('point_from_infinity')
    in_net(sc.BezierCurve([(0, 0, 0), (1, 1, 0), (2, 0, 0)]), there_and_back)


def moved_whole(name):
    ob = add(sheet())
    ob.rotation_euler, ob.scale = (0.3, 0.2, 0.1), (1, 2, 1)
    bpy.context.view_layer.update()
    if name == 'adopt_transform':
        ob.data.transform(ob.matrix_world)
    run(name)


def loft_with(name, **settings):
    """The inputs of a loft are changed."""
    activate(*FOLLOWED['loft']())
    run('add_loft')
    if name == 'add_inputs':
        add_to = bpy.context.object
        more = add(wave(0.7, z=3), "more")
        activate(add_to, more)
    run(name, **settings)
    activate(bpy.context.object)


def axis_from_edge():
    activate(*FOLLOWED['revolve']())
    run('add_revolve')
    run('axis_from_edge', start=(0, -1, 0), end=(0, -1, 3))


def made_editable():
    activate(*FOLLOWED['revolve']())
    run('add_revolve')
    run('make_editable')


def sampled():
    """Shapes from a file, which are shown thick."""
    known = set(bpy.data.objects)
    run('add_sample', sample='vase')
    activate(*(set(bpy.data.objects) - known))


def restored():
    by_hand(add(sheet()))
    run('restore')


def taken_over():
    natives.exact(natives.native_curve('primitive_bezier_circle_add'), natives.native_surface())


def imported(name):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "file"
        value = sc.BezierPatch(np.random.default_rng(3).uniform(size=(4, 4, 3)))
        path.write_text(sc.dumps([wave(), value]) if name == 'import_json' else sc.bpt.dumps(sc.PatchSet.from_patches([value])))
        assert op(getattr(bpy.ops.splinewright, name), filepath=str(path)) == {'FINISHED'}


#: Operators that take more than one step.
STAGED = {
    'edit_net': edited, 'leave_net': edited, 'weight_here': lambda: in_net(wave(), lambda: run('weight_here', weight=0.7)),
    'point_from_infinity': back_from_infinity, 'apply_transform': lambda: moved_whole('apply_transform'),
    'adopt_transform': lambda: moved_whole('adopt_transform'), 'axis_from_edge': axis_from_edge, 'make_editable': made_editable,
    'restore': restored, 'add_sample': sampled, 'make_exact': taken_over,
    'import_json': lambda: imported('import_json'), 'import_bpt': lambda: imported('import_bpt'),
    'add_inputs': lambda: loft_with('add_inputs'), 'remove_input': lambda: loft_with('remove_input', index=1),
    'move_input': lambda: loft_with('move_input', index=0, way='DOWN'), 'turn_input': lambda: loft_with('turn_input', index=1),
    'reverse_inputs': lambda: loft_with('reverse_inputs'), 'sort_inputs': lambda: loft_with('sort_inputs'),
}

#: Operators of the mouse that end in another operator, which has its case.
CALLING = {
    'chamfer_here': 'chamfer_curves', 'fillet_here': 'fillet_curves', 'extend_here': 'extend_curve', 'trim_here': 'trim_curve',
    'insert_here': 'insert_knot', 'split_here': 'split', 'extract_here': 'extract_isocurve', 'extract_side_here': 'extract_boundary',
    'join_here': 'join_patches', 'round_here': 'add_rounded_edge', 'insert_on_strip': 'insert_knot', 'remove_on_strip': 'remove_knot',
}
#: Operators that make and change no curve or patch, and which test_others_leave_every_shape calls.
LEAVING = ('measure_whole', 'set_moving', 'show_inputs', 'show_sight', 'export_json', 'divide_equally', 'write_formulas', 'detach',
           'key_points', 'to_native')
#: Those that cannot be called there, and why they have no case.
BECAUSE = {
    'add_asset_library': "adds a folder to Blender's list", 'edit_linked': "opens another file", 'manual': "opens a page",
    'pick_for_operator': "fills in a number", 'pie': "opens a menu", 'select_seen': "selects", 'use_tool': "changes the tool",
    'self_test': "works in scenes of its own, which it removes", 'measure_here': "shows numbers",
    'choose_function': "sets numbers of a recipe", 'pick_piece': "says which piece is active", 'edit_source': "selects a source and opens it", 'leave_result': "leaves Edit Mode",
    'renew_net': "the net comes again, the shape stays", 'release_joint': "what was held stays where it was",
    'release_seam': "what was held stays where it was", 'clear_point_keys': "removes keyframes",
    'set_patch_material': "gives faces a material", 'tolerance_from_render': "sets how fine the mesh is",
    'update_now': "makes again what recipes make, which have cases", 'update_late': "the same, beside Blender", 'export_bpt': "writes a file",
    'export_figure': "writes a file",
    'project_points': "makes meshes of points", 'radius_here': "changes the radius, which lies along a curve",
    'tilt_here': "changes the tilt, which lies along a curve", 'bake_animation': "leaves keys, and no shape",
    'unbake': "brings back the shapes of before",
    **dict.fromkeys(('start_lesson', 'start_lesson_file', 'lesson_step', 'show_solution'), "makes the shapes of lessons, which recipes make"),
    'check_answer': "says whether an answer is right", 'leave_lesson': "removes a scene, or keeps it", 'pick_answer': "opens a net",
    'show_lesson_folder': "opens a folder", 'collect_answers': "reads other files", 'check_lesson': "works in a scene that it removes",
    **dict.fromkeys(('new_lesson', 'add_lesson_step', 'ask_question', 'export_lesson'), "write what a lesson says"),
}
