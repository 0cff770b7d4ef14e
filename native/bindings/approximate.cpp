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
          py::arg("cancel") = py::none(),
          "The polynomial NurbsCurve near points (n, 2 or 3), as an Approximation: its error is the largest distance of\n"
          "a point from the curve's point at its parameter, and so no less than from the curve. Least sum of squares, in\n"
          "time linear in n (The NURBS Book, §9.4.1). Lecture row S17.\n\n"
          "count: of control points, with knots by eq. 9.68, 9.69, or averaged ones (eq. 9.8) where spans have fewer points\n"
          "than degree + 1. knots: all of them, of a closed curve one period. tolerance: knots are put where points are\n"
          "farther away, and taken away where they are not missed; count is then the most control points. A curve that\n"
          "leaves its points in between by more than the size of a place's neighborhood, degree points on each side, is\n"
          "not taken, or where no other is found by four times as much. parameters: as of interpolate(); None takes\n"
          "'chordal' ones, and with a tolerance 'calm' ones where curves would swing at those.\n\n"
          "residual: the curve with the least integral of the squared second derivative whose sum of squares, of distances at\n"
          "parameters times weights, is no more (Reinsch 1967): for noise of the deviation d about n * d**2, as s of SciPy's\n"
          "splprep. Without count and knots it may have a control point for each point.\n\n"
          "weights: (n,) positive, of the squares. fixed_ends: an open curve begins at the first point and ends at the\n"
          "last, by default but with a residual. Of noisy points say False: else noise of these two bends the ends.\n"
          "start, end: its derivatives 1, 2, … by the parameter there (k, 2 or 3), or the first (2 or 3,).\n"
          "smoothing: weight of the integral of the squared second derivative beside the sum of squares (Reinsch 1967).\n"
          "corrections: so often, while the error falls, parameters move towards the nearest points (Hoschek 1988).\n"
          "cancel: a callable without arguments that ends the call by returning true.\n\n"
          "Raises ToleranceNotReached, and InvalidShape where the points do not determine the curve.");
  fit.def("project", &project, py::arg("function"), py::arg("knots"), py::arg("degree") = 3, py::kw_only(),
          py::arg("fixed_ends") = false, py::arg("closed") = false, py::arg("cancel") = py::none(),
          "The orthogonal projection of a function on the splines with these knots, as an Approximation of a NurbsCurve:\n"
          "the integral of what is left times a basis function is zero. Lecture row S17.\n\n"
          "function: takes parameters (m,) and gives points (m, 2 or 3). Integrals are taken by 16 nodes of Gauss and\n"
          "Legendre, or degree + 8, on 16ths of spans and on ever smaller parts until these tell the function, so that\n"
          "kinks and jumps count; what is narrower than the distances of 512 nodes in a span may be missed. fixed_ends: the\n"
          "curve begins and ends where the function does; the knots are clamped then. The error is the largest distance\n"
          "that is found, from all nodes and 64 even parameters of each span uphill. cancel: a callable that ends the call\n"
          "by returning true.\n\n"
          "Raises InvalidShape where a value is not finite, for noise, and for knots that belong to no curve.");
}

void bind_curves_nearby(const CurveClasses& cls) {
  cls.def("rebuild", &rebuild, py::arg("count") = py::none(), py::arg("degree") = py::none(), py::kw_only(),
          py::arg("tolerance") = py::none(), py::arg("ends") = "points", py::arg("cancel") = py::none(),
          "The polynomial NurbsCurve with even knots over the same domain that is nearest in the integral of the\n"
          "squared distance at equal parameters, as an Approximation: its error is the largest such distance, at most\n"
          "1 % above the truth. Periodic if the curve is. Lecture row S17.\n\n"
          "count: of control points; degree + 1 make one Bezier piece. tolerance: as few as come within it, count at\n"
          "most. ends: 'points' of an open curve stay, or 'tangents', too. cancel: ends the call by returning true.\n\n"
          "Raises ToleranceNotReached, and InvalidShape for counts below what the degree needs.");
  cls.def("fair", &fair, py::arg("tolerance"), py::kw_only(), py::arg("ends") = "points",
          py::arg("cancel") = py::none(),
          "A curve on the same knots, with the same weights, that bends less and stays within the tolerance, as an\n"
          "Approximation: its error is the largest distance at equal parameters, at most 1 % above the truth. Least\n"
          "integral of the squared second derivative of the spline without weights (Reinsch 1967).\n\n"
          "ends: 'points' of an open curve stay, or 'tangents', too. cancel: ends the call by returning true.\n\n"
          "Raises InvalidShape unless the tolerance is positive and the degree is 2 at least.");
}

void bind_patches_nearby(const PatchClasses& cls) {
  cls.def("rebuild", &rebuild_patch, py::arg("counts"), py::arg("degrees") = py::none(), py::kw_only(),
          py::arg("cancel") = py::none(),
          "The polynomial NurbsPatch with even knots over the same domain that is nearest first along u, then along v,\n"
          "as an Approximation: its error is the largest distance at equal parameters, at most 2 % above the truth.\n"
          "Corners stay; periodic directions stay periodic. Lecture rows S17, S20.\n\n"
          "counts: of control points, (u, v) or one for both. degrees: the same; None keeps them. cancel: ends the\n"
          "call by returning true. Raises InvalidShape for counts below what the degree needs.");
  cls.def("fair", &fair_patch, py::arg("tolerance"), py::kw_only(), py::arg("ends") = "points",
          py::arg("cancel") = py::none(),
          "A patch on the same knots, with the same weights, that bends less and stays within the tolerance, as an\n"
          "Approximation: its error is the largest distance at equal parameters, at most 2 % above the truth. Least\n"
          "energy of a thin plate as long and wide as the net, the integral of S_uu² + 2 S_uv² + S_vv², of the spline\n"
          "without weights (Greiner 1994).\n\n"
          "Borders stay; ends: 'points', or 'tangents': the derivatives across them, too; a pair for u and v. cancel:\n"
          "ends the call by returning true.\n\n"
          "Raises InvalidShape unless the tolerance is positive and a degree is 2 at least, and for degrees too high.");
}

}  // namespace

void bind_approximate(py::module_& module) {
  py::module_ fit = module.attr("fit");
  bind_functions(fit);
  bind_curves_nearby(CurveClasses(module));
  bind_patches_nearby(PatchClasses(module));
}

}  // namespace bindings
