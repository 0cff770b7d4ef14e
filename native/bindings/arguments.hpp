#pragma once

#include <pybind11/pybind11.h>

#include <glm/mat4x4.hpp>
#include <optional>

#include "splinecore/base/interval.hpp"
#include "splinecore/patch/isocurve.hpp"

// Arguments that verbs of several kinds take.
namespace bindings {

namespace py = pybind11;

/// A length, or none for None. @throws InvalidShape if it is below 0 or not finite.
std::optional<double> tolerance_of(const py::object& value, const char* name = "tolerance");

/// (start, end)
splinecore::Interval interval_of(const py::object& value, const char* name);

/// (3, 3), (3, 4) or (4, 4), which maps columns.
glm::dmat4 matrix_of(const py::object& value);

/// 'u' or 'v'
splinecore::Axis axis_of(const py::object& value);

/// 'u_start', 'u_end', 'v_start' or 'v_end'
splinecore::Border border_of(const py::object& value, const char* name);

}  // namespace bindings
