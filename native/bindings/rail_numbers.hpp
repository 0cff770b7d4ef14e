#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "splinecore/base/interval.hpp"
#include "splinecore/surface/sweep.hpp"

// Numbers that change along a curve, as arguments.
namespace bindings {

/// (n, 2): parameters and numbers; none for None.
std::vector<splinecore::RailNumber> numbers_along(const pybind11::object& value, const char* name);

/// One number for all of a domain, or (n, 2).
std::vector<splinecore::RailNumber> radii_of(const pybind11::object& value, const char* name, const splinecore::Interval& domain);

}  // namespace bindings
