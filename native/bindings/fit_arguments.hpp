#pragma once

#include <optional>
#include <vector>

#include "arrays.hpp"
#include "splinecore/fit/interpolate_patch.hpp"

namespace bindings {

/// A number of control points: a whole one above 0.
std::size_t count_of(const py::object& value, const char* name);

/// A number above 0; None for none.
std::optional<double> positive(const py::object& value, const char* name);

/// A word, or the parameters of a grid's rows themselves.
std::vector<double> grid_parameters(const splinecore::PointGrid& grid, const py::object& parameters,
                                    splinecore::Axis axis, splinecore::Closing closing);

}  // namespace bindings
