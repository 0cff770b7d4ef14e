#pragma once

#include <pybind11/pybind11.h>

#include <utility>

#include "splinecore/base/approximation.hpp"

namespace bindings {

namespace py = pybind11;

/// splinecore::Approximation with any value, as Python sees it.
struct AnyApproximation {
  py::object value;
  double error;
};

template <class Value>
AnyApproximation wrap(splinecore::Approximation<Value> approximation) {
  return {py::cast(std::move(approximation.value)), approximation.error};
}

}  // namespace bindings
