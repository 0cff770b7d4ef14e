#pragma once

#include <pybind11/pybind11.h>

#include "classes.hpp"
#include "splinecore/patch/bezier_patch.hpp"
#include "splinecore/patch/hermite_patch.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace bindings {

/// What changes the knots, degrees, ends or place of a patch, measures it, and takes curves from it.
void bind_patch_verbs(Class<splinecore::NurbsPatch>& cls);
void bind_patch_verbs(Class<splinecore::BezierPatch>& cls);
void bind_patch_verbs(Class<splinecore::HermitePatch>& cls);

}  // namespace bindings
