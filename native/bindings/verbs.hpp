#pragma once

#include <pybind11/pybind11.h>

#include "classes.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace bindings {

/// What changes the knots, degree, ends or place of a NURBS curve, and measures it.
void bind_verbs(Class<splinecore::NurbsCurve>& cls);

/// What shapes of every kind can: to be called when all their classes are there.
void bind_every_kind(pybind11::module_& module);

}  // namespace bindings
