#include <pybind11/pybind11.h>

#include "long_calls.hpp"
#include "rooms.hpp"
#include "splinecore/base/approximation.hpp"
#include "splinecore/base/errors.hpp"

namespace py = pybind11;

PYBIND11_MODULE(_splinecore, module) {
  module.doc() = "Exact NURBS, Bezier and Hermite curves and patches.";
  module.attr("__version__") = SPLINECORE_VERSION;

  py::register_local_exception<splinecore::InvalidShape>(module, "InvalidShape", PyExc_ValueError).doc() =
      "Bad input: the message names the argument, the first offending index and its value.";
  py::register_local_exception<splinecore::PointAtInfinity>(module, "PointAtInfinity", PyExc_ArithmeticError).doc() =
      "A point was asked for where the homogeneous weight is zero.";
  py::register_local_exception<splinecore::ToleranceNotReached>(module, "ToleranceNotReached", PyExc_ArithmeticError)
      .doc() = "What was asked for cannot be had within the tolerance: the message says with which error it could.";
  py::register_local_exception<bindings::Cancelled>(module, "Cancelled", PyExc_RuntimeError).doc() =
      "A long call was ended by its cancel argument.";

  bindings::bind_approximation(module);
  bindings::bind_continuity(module);
  bindings::bind_basis(module);
  bindings::bind_power(module);
  bindings::bind_curves(module);
  bindings::bind_build(module);
  bindings::bind_conics(module);
  bindings::bind_patches(module);
  bindings::bind_patch_set(module);
  bindings::bind_measure(module);
  bindings::bind_primitives(module);
  bindings::bind_patch_joins(module);
  bindings::bind_formula(module);
  bindings::bind_from_formulas(module);
  bindings::bind_exchange(module);
}
