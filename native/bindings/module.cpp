#include <pybind11/pybind11.h>

#include "documentation.hpp"
#include "long_calls.hpp"
#include "rooms.hpp"
#include "splinecore/base/approximation.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/instruction_set.hpp"
#include "verbs.hpp"
#include "wrong_calls.hpp"

namespace py = pybind11;

namespace {

/// Raised for What; an Error and one of Python's own kinds.
template <class What>
void bind_error(py::module_& module, const char* name, PyObject* kind) {
  const py::tuple bases = py::make_tuple(module.attr("Error"), py::handle(kind));
  py::register_local_exception<What>(module, name, bases);
}

void bind_errors(py::module_& module) {
  module.attr("Error") =
      py::reinterpret_steal<py::object>(PyErr_NewException("_splinecore.Error", PyExc_Exception, nullptr));
  bind_error<splinecore::InvalidShape>(module, "InvalidShape", PyExc_ValueError);
  bind_error<splinecore::PointAtInfinity>(module, "PointAtInfinity", PyExc_ArithmeticError);
  bind_error<splinecore::ToleranceNotReached>(module, "ToleranceNotReached", PyExc_ArithmeticError);
  bind_error<bindings::Cancelled>(module, "Cancelled", PyExc_RuntimeError);
}

}  // namespace

PYBIND11_MODULE(_splinecore, module) {
  module.doc() = "Exact NURBS, Bezier and Hermite curves and patches.";
  module.attr("__version__") = SPLINECORE_VERSION;
  module.attr("__instruction_set__") = splinecore::instruction_set();

  bind_errors(module);

  bindings::bind_approximation(module);
  bindings::bind_continuity(module);
  bindings::bind_basis(module);
  bindings::bind_power(module);
  bindings::bind_curves(module);
  bindings::bind_curve_methods(module);
  bindings::bind_build(module);
  bindings::bind_fit(module);
  bindings::bind_conics(module);
  bindings::bind_patches(module);
  bindings::bind_patch_methods(module);
  bindings::bind_patch_set(module);
  bindings::bind_tessellation(module);
  bindings::bind_measure(module);
  bindings::bind_surface_integrals(module);
  bindings::bind_arc_lengths(module);
  bindings::bind_frames(module);
  bindings::bind_features(module);
  bindings::bind_plane_curves(module);
  bindings::bind_nearest(module);
  bindings::bind_stationary(module);
  bindings::bind_intersections(module);
  bindings::bind_rays(module);
  bindings::bind_regions(module);
  bindings::bind_every_kind(module);
  bindings::bind_sections(module);
  bindings::bind_offset(module);
  bindings::bind_curve_parts(module);
  bindings::bind_approximate(module);
  bindings::bind_approximate_patch(module);
  bindings::bind_drags(module);
  bindings::bind_primitives(module);
  bindings::bind_fillets(module);
  bindings::bind_corners(module);
  bindings::bind_made_curves(module);
  bindings::bind_lofts(module);
  bindings::bind_networks(module);
  bindings::bind_rails(module);
  bindings::bind_surface_verbs(module);
  bindings::bind_fills(module);
  bindings::bind_subdivisions(module);
  bindings::bind_patch_joins(module);
  bindings::bind_formula(module);
  bindings::bind_from_formulas(module);
  bindings::bind_exchange(module);

  bindings::explain_wrong_calls(module);
  bindings::document(module);
}
