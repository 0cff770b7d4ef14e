"""What a user sees and calls. register() here is the only one."""

import bpy

from ..core.base import library
from . import languages, manual, preferences


def _rooms():
    """Modules with CLASSES and, some, register() and unregister(); imported only with the library."""
    from . import (analysis_panel, analysis_props, construction_panel, continuity_panel, drawing, edit_mode_redirect,
                   formulas_panel, gizmos, handlers, hints, inputs_list, join_notice, keymaps, lesson_list_panel, lesson_maker_panel,
                   lessons_panel, measure_panel, menus, net_panel, net_props, net_toolbar, panels, pie, pieces_panel, point_keys_panel, point_props, props, recipe_props,
                   scene_tolerance, settings_panel, start_panel, toolbar)
    from .operators import (add_curve, add_patch, add_recipe, add_sample, along_here, at_sides, axis_from_edge, bake, cap, choose_function,
                            contour_through, curve_corners, curve_here, curve_join, curve_meeting, curve_through, divide,
                            draw_contour, draw_curve, edit, edit_linked, edit_source, exchange, extract, figure, fineness, fit_curve,
                            fit_patch, follow, form_verbs, formulas, from_objects, hold_joint, hold_seam, infinity, inputs,
                            insert_here, intersections, join, key_points, knot_verbs, lesson_answers, lesson_making,
                            lesson_questions, lesson_start, lessons, make_deformable, measure_here, measure_whole, move_knot, native, parting,
                            patch_join, pick_piece, project_points, pull_here, round_here, select_seen, self_test, set_knots,
                            shape_state, show_overlays, strip_keys, touching_circle, update_now, use_tool, weight_here)
    operators = (add_curve, add_recipe, add_patch, add_sample, exchange, figure, edit, edit_source, edit_linked, inputs,
                 set_knots, infinity, shape_state, join, follow, bake, from_objects, curve_through, contour_through,
                 fit_curve, draw_curve, draw_contour, fit_patch, divide, project_points, axis_from_edge, native,
                 knot_verbs, form_verbs, curve_join, curve_corners, curve_meeting, patch_join, parting, cap,
                 make_deformable, hold_joint, hold_seam, extract, fineness, formulas, pick_piece, insert_here,
                 curve_here, intersections, measure_here, choose_function, measure_whole, pull_here, weight_here, along_here,
                 key_points, move_knot, strip_keys, at_sides, touching_circle, round_here, select_seen, show_overlays,
                 update_now, use_tool, self_test, lesson_start, lessons, lesson_answers, lesson_making, lesson_questions)
    return (props, net_props, recipe_props, point_props, analysis_props, *operators, inputs_list, lessons_panel, lesson_list_panel, lesson_maker_panel, panels,
            pieces_panel, point_keys_panel, construction_panel, settings_panel, net_panel, continuity_panel, measure_panel,
            formulas_panel, analysis_panel, scene_tolerance, menus, start_panel, pie, keymaps, toolbar, net_toolbar,
            gizmos, hints, drawing, handlers, join_notice, edit_mode_redirect)


def _all_rooms():
    """Without the library only what helps to mend that."""
    return (languages, manual, preferences, *(() if library.problem else _rooms()))


def register():
    for room in _all_rooms():
        for cls in room.CLASSES:
            bpy.utils.register_class(cls)
        if hasattr(room, 'register'):
            room.register()


def unregister():
    for room in reversed(_all_rooms()):
        if hasattr(room, 'unregister'):
            room.unregister()
        for cls in reversed(room.CLASSES):
            bpy.utils.unregister_class(cls)
