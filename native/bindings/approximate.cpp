#include "splinecore/fit/approximate.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "approximation.hpp"
#include "arguments.hpp"
#include "every_kind.hpp"
#include "fit_arguments.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rooms.hpp"
#include "splinecore/fit/fair.hpp"
#include "splinecore/fit/project.hpp"
#include "splinecore/fit/rebuild.hpp"

namespace bindings {

using splinecore::ApproximationOptions;
using splinecore::Closing;
using splinecore::InvalidShape;
using splinecore::KeptEnds;
using splinecore::KnotVector;
using splinecore::Parameterization;

namespace {

constexpr std::size_t kMostControlPoints = 100000;

KeptEnds kept_ends_of(const py::object& value) {
  return chosen<KeptEnds>(value, "ends", {{"points", KeptEnds::points}, {"tangents", KeptEnds::tangents}});
}

AnyApproximation approximate(const py::object& points, const py::object& count, const py::object& degree,
                             const py::object& parameters, const py::object& tolerance, const py::object& knots,
                             const py::object& weights, const py::object& fixed_ends, const py::object& start,
                             const py::object& end, const py::object& closed, const py::object& smoothing,
                             const py::object& corrections, const py::object& residual, const py::object& cancel) {
  const GivenPoints given(points, "points", 1);
  const std::span<const glm::dvec3> rows = given.points();
  ApproximationOptions options;
  options.weights = optional_numbers(weights, "weights");
  const std::optional<double> left = optional_real(residual, "residual");
  options.fixed_ends = optional_boolean(fixed_ends, "fixed_ends").value_or(!left);
  options.start = derivatives_of(start, "start");
  options.end = derivatives_of(end, "end");
  options.smoothing = real(smoothing, "smoothing");
  options.corrections = integer(corrections, "corrections");
  const int order = integer(degree, "degree");
  const Closing closing = boolean(closed, "closed") ? Closing::closed : Closing::open;
  const std::vector<double> chain = optional_numbers(knots, "knots");
  const std::optional<double> within = positive(tolerance, "tolerance");
  const std::optional<std::size_t> number = count.is_none() ? std::nullopt : std::optional(count_of(count, "count"));
  if (!knots.is_none() && (number || within)) throw InvalidShape("knots are given, and so neither count nor tolerance");
  if (left && within) throw InvalidShape("residual is given, and so no tolerance");
  if (knots.is_none() && !number && !within && !left) throw InvalidShape("count, knots, tolerance or residual is needed");
  const bool are_chosen = parameters.is_none();
  const std::vector<double> at = are_chosen ? splinecore::parameters_of(rows, Parameterization::chordal, closing)
                                            : curve_parameters(rows, parameters, order, closing);
  return wrap(unlocked([&] {
    if (within) {
      const std::size_t most = number.value_or(rows.size() + options.start.size() + options.end.size());
      if (are_chosen) return splinecore::approximate_within(rows, order, closing, *within, most, options);
      return splinecore::approximate_within(rows, at, order, closing, *within, most, options);
    }
    if (number && !left) return splinecore::approximate(rows, at, order, *number, closing, options);
    const bool chooses = left && chain.empty();
    const KnotVector on = chooses ? splinecore::approximating_knots(at, order, number.value_or(rows.size()), closing)
                                           : KnotVector::make(order, chain, closing == Closing::closed);
    return left ? splinecore::approximate_smoothly(rows, at, on, *left, options)
                : splinecore::approximate(rows, at, on, options);
  }, cancel));
}

/// Calls the function with an array (n,) and takes its points, (n, 2 or 3).
splinecore::CurveFunction called(const py::object& function) {
  if (PyCallable_Check(function.ptr()) == 0) {
    throw py::type_error("function = " + std::string(py::repr(function)) + " is not callable");
  }
  return [&function](std::span<const double> parameters, std::span<glm::dvec3> points) {
    const py::gil_scoped_acquire locked;
    // pybind11 before 2.12 reads the size of an item in the wrong place from NumPy 2: the stride says it.
    const py::array_t<double> at({parameters.size()}, {sizeof(double)}, parameters.data());
    const GivenPoints given(function(at), "the values of function", 1);
    if (given.points().size() != points.size()) {
      throw InvalidShape("function has " + std::to_string(given.points().size()) + " points for " +
                         std::to_string(points.size()) + " parameters");
    }
    std::ranges::copy(given.points(), points.begin());
  };
}

AnyApproximation project(const py::object& function, const py::object& knots, const py::object& degree,
                         const py::object& fixed_ends, const py::object& closed, const py::object& cancel) {
  const splinecore::CurveFunction wanted = called(function);
  const std::vector<double> chain = numbers(knots, "knots");
  const int order = integer(degree, "degree");
  const bool is_fixed = boolean(fixed_ends, "fixed_ends");
  const bool is_closed = boolean(closed, "closed");
  return wrap(unlocked([&] {
    const KnotVector on = KnotVector::make(order, chain, is_closed);
    return splinecore::project(wanted, on, is_fixed);
  }, cancel));
}

AnyApproximation rebuild(const AnyCurve& self, const py::object& count, const py::object& degree,
                         const py::object& tolerance, const py::object& ends, const py::object& cancel) {
  const splinecore::NurbsCurve& curve = form(self);
  const int order = degree.is_none() ? curve.degree() : integer(degree, "degree");
  const KeptEnds kept = kept_ends_of(ends);
  const std::optional<double> within = positive(tolerance, "tolerance");
  if (count.is_none() && !within) throw InvalidShape("count or tolerance is needed");
  const std::size_t number = count.is_none() ? kMostControlPoints : count_of(count, "count");
  return wrap(unlocked([&] {
    return within ? splinecore::rebuild_within(curve, order, *within, number, kept)
                  : splinecore::rebuild(curve, order, number, kept);
  }, cancel));
}

AnyApproximation fair(const AnyCurve& self, const py::object& tolerance, const py::object& ends, const py::object& cancel) {
  const double within = real(tolerance, "tolerance");
  const KeptEnds kept = kept_ends_of(ends);
  return wrap(unlocked([&] { return splinecore::fair(form(self), within, kept); }, cancel));
}

AnyApproximation rebuild_patch(const AnyPatch& self, const py::object& counts, const py::object& degrees,
                               const py::object& cancel) {
  const splinecore::NurbsPatch& patch = patch_form(self);
  const auto number = both(counts, "counts");
  splinecore::RebuiltDirection u{patch.knot_vector(splinecore::Axis::u).degree(), count_of(number.first, "counts")};
  splinecore::RebuiltDirection v{patch.knot_vector(splinecore::Axis::v).degree(), count_of(number.second, "counts")};
  if (!degrees.is_none()) {
    const auto order = both(degrees, "degrees");
    u.degree = integer(order.first, "degrees");
    v.degree = integer(order.second, "degrees");
  }
  return wrap(unlocked([&] { return splinecore::rebuild(patch, u, v); }, cancel));
}

AnyApproximation fair_patch(const AnyPatch& self, const py::object& tolerance, const py::object& ends,
                            const py::object& cancel) {
  const splinecore::NurbsPatch& patch = patch_form(self);
  const double within = real(tolerance, "tolerance");
  const auto each = both(ends, "ends");
  const KeptEnds u = kept_ends_of(each.first);
  const KeptEnds v = kept_ends_of(each.second);
  return wrap(unlocked([&] { return splinecore::fair(patch, within, u, v); }, cancel));
}

void bind_functions(py::module_& fit) {
  fit.def("approximate", &approximate, py::arg("points"), py::arg("count") = py::none(), py::arg("degree") = 3,
          py::arg("parameters") = py::none(), py::kw_only(), py::arg("tolerance") = py::none(),
          py::arg("knots") = py::none(), py::arg("weights") = py::none(), py::arg("fixed_ends") = py::none(),
          py::arg("start") = py::none(), py::arg("end") = py::none(), py::arg("closed") = false,
          py::arg("smoothing") = 0.0, py::arg("corrections") = 0, py::arg("residual") = py::none(),
          py::arg("cancel") = py::none());
  fit.def("project", &project, py::arg("function"), py::arg("knots"), py::arg("degree") = 3, py::kw_only(),
          py::arg("fixed_ends") = false, py::arg("closed") = false, py::arg("cancel") = py::none());
}

void bind_curves_nearby(const CurveClasses& cls) {
  cls.def("rebuild", &rebuild, py::arg("count") = py::none(), py::arg("degree") = py::none(), py::kw_only(),
          py::arg("tolerance") = py::none(), py::arg("ends") = "points", py::arg("cancel") = py::none());
  cls.def("fair", &fair, py::arg("tolerance"), py::kw_only(), py::arg("ends") = "points",
          py::arg("cancel") = py::none());
}

void bind_patches_nearby(const PatchClasses& cls) {
  cls.def("rebuild", &rebuild_patch, py::arg("counts"), py::arg("degrees") = py::none(), py::kw_only(),
          py::arg("cancel") = py::none());
  cls.def("fair", &fair_patch, py::arg("tolerance"), py::kw_only(), py::arg("ends") = "points",
          py::arg("cancel") = py::none());
}

}  // namespace

void bind_approximate(py::module_& module) {
  py::module_ fit = module.attr("fit");
  bind_functions(fit);
  bind_curves_nearby(CurveClasses(module));
  bind_patches_nearby(PatchClasses(module));
}

}  // namespace bindings
