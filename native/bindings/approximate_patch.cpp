#include "splinecore/fit/approximate_patch.hpp"

#include <optional>

#include "approximation.hpp"
#include "arguments.hpp"
#include "fit_arguments.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rooms.hpp"

namespace bindings {

using splinecore::Axis;
using splinecore::Closing;
using splinecore::InvalidShape;
using splinecore::KnotVector;
using splinecore::NearDirection;
using splinecore::PointGrid;
using Pair = std::pair<py::object, py::object>;

namespace {

/// Whether neither direction has one.
bool is_none(const Pair& pair) { return pair.first.is_none() && pair.second.is_none(); }

AnyApproximation approximate_patch(const py::object& points, const py::object& counts, const py::object& degrees,
                                   const py::object& parameters, const py::object& tolerance, const py::object& knots,
                                   const py::object& weights, const py::object& fixed_ends, const py::object& closed,
                                   const py::object& smoothing, const py::object& cancel) {
  const GivenPoints given(points, "points", 2);
  const PointGrid grid{given.points(), given.count(0), given.count(1)};
  const GridArguments arguments(grid, degrees, parameters, knots, closed);
  const Pair count = both(counts, "counts");
  const Pair smooth = both(smoothing, "smoothing");
  const Pair weighed = both(weights, "weights");
  const std::optional<double> within = positive(tolerance, "tolerance");
  if (within && arguments.has_knots()) throw InvalidShape("knots are given, and so no tolerance");
  const auto direction = [&](Axis axis) {
    auto made = arguments.direction<NearDirection>(axis);
    made.smoothing = real(GridArguments::of(smooth, axis), "smoothing");
    made.weights = optional_numbers(GridArguments::of(weighed, axis), "weights");
    if (made.parameters.empty() && !within) {
      made.parameters = splinecore::parameters_of(grid, axis, splinecore::Parameterization::chordal, made.closing);
    }
    const py::object& wanted = GridArguments::of(count, axis);
    if (!wanted.is_none() && !made.knots.empty()) throw InvalidShape("knots are given, and so no counts");
    if (wanted.is_none() && made.knots.empty() && !within) throw InvalidShape("counts, knots or tolerance are needed");
    made.count = wanted.is_none() ? grid.count(axis) : count_of(wanted, "counts");
    return made;
  };
  const NearDirection u = direction(Axis::u);
  const NearDirection v = direction(Axis::v);
  const bool is_fixed = boolean(fixed_ends, "fixed_ends");
  return wrap(unlocked([&] {
    return within ? splinecore::approximate_within(grid, u, v, *within, is_fixed)
                  : splinecore::approximate(grid, u, v, is_fixed);
  }, cancel));
}

std::vector<glm::dvec2> places_of(const py::object& value) {
  if (value.is_none()) return {};
  const Doubles given = real_array(value, "parameters");
  if (given.ndim() != 2 || given.shape(1) != 2) {
    throw InvalidShape("parameters has shape " + shape_text(given) + ", (n, 2) is expected");
  }
  std::vector<glm::dvec2> places;
  for (const double* row = given.data(); row != given.data() + given.size(); row += 2) {
    places.emplace_back(row[0], row[1]);
  }
  return places;
}

AnyApproximation approximate_scattered(const py::object& points, const py::object& counts, const py::object& degrees,
                                       const py::object& parameters, const py::object& tolerance,
                                       const py::object& knots, const py::object& weights, const py::object& smoothing,
                                       const py::object& corrections, const py::object& cancel) {
  constexpr std::size_t kMost = 100;
  const GivenPoints given(points, "points", 1);
  const std::vector<glm::dvec2> places = places_of(parameters);
  const Pair degree = both(degrees, "degrees");
  splinecore::ScatteredOptions options;
  options.weights = optional_numbers(weights, "weights");
  options.smoothing = real(smoothing, "smoothing");
  options.corrections = integer(corrections, "corrections");
  const std::optional<double> within = positive(tolerance, "tolerance");
  splinecore::NetSize size{integer(degree.first, "degrees"), integer(degree.second, "degrees"), kMost, kMost};
  const Pair chain = both(knots, "knots");
  if (!is_none(chain)) {
    if (!counts.is_none() || within) throw InvalidShape("knots are given, and so neither counts nor tolerance");
    if (parameters.is_none()) throw InvalidShape("knots belong to parameters, which are not given");
    const std::vector<double> u = numbers(chain.first, "knots");
    const std::vector<double> v = numbers(chain.second, "knots");
    return wrap(unlocked([&] {
      return splinecore::approximate(given.points(), places, KnotVector::make(size.degree_u, u),
                                     KnotVector::make(size.degree_v, v), options);
    }, cancel));
  }
  if (counts.is_none() && !within) throw InvalidShape("counts, knots or tolerance are needed");
  if (!counts.is_none()) {
    const Pair count = both(counts, "counts");
    size.count_u = count_of(count.first, "counts");
    size.count_v = count_of(count.second, "counts");
  }
  return wrap(unlocked([&] {
    return within ? splinecore::approximate_within(given.points(), places, size, *within, options)
                  : splinecore::approximate(given.points(), places, size, options);
  }, cancel));
}

}  // namespace

void bind_approximate_patch(py::module_& module) {
  py::module_ fit = module.attr("fit");
  fit.def("approximate_patch", &approximate_patch, py::arg("points"), py::arg("counts") = py::none(),
          py::arg("degrees") = 3, py::arg("parameters") = py::none(), py::kw_only(), py::arg("tolerance") = py::none(),
          py::arg("knots") = py::none(), py::arg("weights") = py::none(), py::arg("fixed_ends") = true,
          py::arg("closed") = false, py::arg("smoothing") = 0.0, py::arg("cancel") = py::none());
  fit.def("approximate_scattered", &approximate_scattered, py::arg("points"), py::arg("counts") = py::none(),
          py::arg("degrees") = 3, py::kw_only(), py::arg("parameters") = py::none(), py::arg("tolerance") = py::none(),
          py::arg("knots") = py::none(), py::arg("weights") = py::none(), py::arg("smoothing") = 0.0,
          py::arg("corrections") = 8, py::arg("cancel") = py::none());
}

}  // namespace bindings
