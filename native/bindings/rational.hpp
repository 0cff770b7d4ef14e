#pragma once

#include <pybind11/pybind11.h>

#include "classes.hpp"
#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace bindings {

/// finite_arcs, moebius, standard_form; for a Bezier curve also de Casteljau's triangles.
void bind_rational_verbs(Class<splinecore::NurbsCurve>& cls);
void bind_rational_verbs(Class<splinecore::BezierCurve>& cls);

}  // namespace bindings
