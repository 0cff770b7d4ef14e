#pragma once

#include <pybind11/pybind11.h>

// One function for each file of bindings, in the order in which the module calls them.
namespace bindings {

void bind_approximation(pybind11::module_& module);
void bind_continuity(pybind11::module_& module);
void bind_basis(pybind11::module_& module);
void bind_power(pybind11::module_& module);
void bind_curves(pybind11::module_& module);
void bind_curve_methods(pybind11::module_& module);
void bind_build(pybind11::module_& module);
void bind_fit(pybind11::module_& module);
void bind_conics(pybind11::module_& module);
void bind_patches(pybind11::module_& module);
void bind_patch_methods(pybind11::module_& module);
void bind_patch_set(pybind11::module_& module);
void bind_tessellation(pybind11::module_& module);
void bind_measure(pybind11::module_& module);
void bind_surface_integrals(pybind11::module_& module);
void bind_arc_lengths(pybind11::module_& module);
void bind_frames(pybind11::module_& module);
void bind_features(pybind11::module_& module);
void bind_plane_curves(pybind11::module_& module);
void bind_nearest(pybind11::module_& module);
void bind_stationary(pybind11::module_& module);
void bind_intersections(pybind11::module_& module);
void bind_rays(pybind11::module_& module);
void bind_sections(pybind11::module_& module);
void bind_offset(pybind11::module_& module);
void bind_curve_parts(pybind11::module_& module);
void bind_regions(pybind11::module_& module);
void bind_approximate(pybind11::module_& module);
void bind_approximate_patch(pybind11::module_& module);
void bind_drags(pybind11::module_& module);
void bind_primitives(pybind11::module_& module);
void bind_fillets(pybind11::module_& module);
void bind_corners(pybind11::module_& module);
void bind_made_curves(pybind11::module_& module);
void bind_lofts(pybind11::module_& module);
void bind_networks(pybind11::module_& module);
void bind_rails(pybind11::module_& module);
void bind_surface_verbs(pybind11::module_& module);
void bind_fills(pybind11::module_& module);
void bind_subdivisions(pybind11::module_& module);
void bind_patch_joins(pybind11::module_& module);
void bind_formula(pybind11::module_& module);
void bind_from_formulas(pybind11::module_& module);
void bind_exchange(pybind11::module_& module);

}  // namespace bindings
