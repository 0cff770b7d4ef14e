#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "splinecore/fit/interpolate_patch.hpp"

namespace bindings {

/// A number of control points: a whole one above 0.
std::size_t count_of(const py::object& value, const char* name);

/// A number above 0; None for none.
std::optional<double> positive(const py::object& value, const char* name);

/// A word, 'calm' for the parameters that suit the degree, or the parameters themselves.
std::vector<double> curve_parameters(std::span<const glm::dvec3> points, const py::object& parameters, int degree,
                                     splinecore::Closing closing);

/// The same of a grid's rows; none for None.
std::vector<double> grid_parameters(const splinecore::PointGrid& grid, const py::object& parameters,
                                    splinecore::Axis axis, int degree, splinecore::Closing closing);

/// What all fits of a grid take: one value for both directions or a pair.
class GridArguments {
 public:
  GridArguments(const splinecore::PointGrid& grid, const py::object& degrees, const py::object& parameters,
                const py::object& knots, const py::object& closed);

  /// A direction with its degree, its closing, its knots if there are some, and its parameters.
  template <class Direction>
  Direction direction(splinecore::Axis axis) const {
    Direction made;
    made.degree = integer(of(degrees_, axis), "degrees");
    made.closing = boolean(of(closed_, axis), "closed") ? splinecore::Closing::closed : splinecore::Closing::open;
    made.knots = optional_numbers(of(knots_, axis), "knots");
    made.parameters = grid_parameters(grid_, of(parameters_, axis), axis, made.degree, made.closing);
    return made;
  }

  bool has_knots() const { return !knots_.first.is_none() || !knots_.second.is_none(); }

  static const py::object& of(const std::pair<py::object, py::object>& pair, splinecore::Axis axis) {
    return axis == splinecore::Axis::u ? pair.first : pair.second;
  }

 private:
  splinecore::PointGrid grid_;
  std::pair<py::object, py::object> degrees_;
  std::pair<py::object, py::object> parameters_;
  std::pair<py::object, py::object> knots_;
  std::pair<py::object, py::object> closed_;
};

}  // namespace bindings
