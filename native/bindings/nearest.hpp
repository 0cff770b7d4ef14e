#pragma once

#include <algorithm>
#include <vector>

#include "arrays.hpp"
#include "result_pickles.hpp"
#include "splinecore/meet/nearest.hpp"

namespace bindings {

/// What Python sees of the nearest points to many.
struct Nearest {
  py::array_t<double> parameters;
  py::array_t<double> points;
  py::array_t<double> distances;
};

template <>
struct StateOf<Nearest> : StateOfMembers<&Nearest::parameters, &Nearest::points, &Nearest::distances> {};

/// Arrays for as many points as a shape has, with parameters of another one.
Nearest arrays_for(const Shape& shape, const Shape& parameters);

inline std::size_t parameter_count(const auto& place) {
  if constexpr (requires { place.parameter; }) return 1;
  else return 2;
}

inline void write_parameters(const auto& place, double* out) {
  if constexpr (requires { place.parameter; }) {
    out[0] = place.parameter;
  } else {
    out[0] = place.u;
    out[1] = place.v;
  }
}

/// Writes what was found into arrays for as many.
template <class Place>
void write_places(const std::vector<Place>& found, Nearest& out) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    write_parameters(found[i], out.parameters.mutable_data() + parameter_count(found[i]) * i);
    std::copy_n(&found[i].point.x, 3, out.points.mutable_data() + 3 * i);
    out.distances.mutable_data()[i] = found[i].distance;
  }
}

/// What was found: parameters (n,) or (n, 2).
template <class Place>
Nearest arrays_of(const std::vector<Place>& found) {
  const Shape shape{static_cast<py::ssize_t>(found.size())};
  Shape parameters = shape;
  if constexpr (!requires(Place place) { place.parameter; }) parameters.push_back(2);
  Nearest out = arrays_for(shape, parameters);
  write_places(found, out);
  return out;
}

}  // namespace bindings
