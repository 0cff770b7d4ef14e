#include "fitted_patch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/length.hpp"
#include "build/fit_options.hpp"
#include "fit/row_spline.hpp"
#include "greville.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/ends.hpp"

namespace splinecore {

namespace {

constexpr std::array<Axis, 2> kBoth{Axis::u, Axis::v};
/// Below the tolerance, for what lies between the places that are looked at; so is what is said above what was found.
constexpr double kSeen = 0.8;
/// How many places of each span are looked at first.
constexpr std::size_t kFew = 4;

void require_no_gap(const KnotVector& knots, Axis axis) {
  const Interval domain = knots.domain();
  for (const double knot : knots.knots()) {
    const bool is_inside = knot > domain.start && knot < domain.end;
    if ((is_inside || knots.periodic()) && multiplicity(knots, knot) > knots.degree()) {
      throw InvalidShape(std::string("the patch falls apart at ") + (axis == Axis::u ? "u = " : "v = ") + text_of(knot));
    }
  }
}

NurbsPatch ready(const NurbsPatch& model) {
  NurbsPatch made = model;
  for (const Axis axis : kBoth) {
    if (!made.knot_vector(axis).periodic()) made = clamped(made, axis);
    require_no_gap(made.knot_vector(axis), axis);
  }
  return made;
}

/// Homogeneous points on a grid of both directions' samples, v fastest.
std::vector<glm::dvec4> homogeneous_grid(const NurbsPatch& patch, const Samples& u, const Samples& v) {
  const auto net = patch.homogeneous_points();
  const auto width = static_cast<std::size_t>(patch.knot_vector(Axis::v).unrolled_count());
  std::vector<glm::dvec4> points;
  points.reserve(u.size() * v.size());
  std::vector<glm::dvec4> row(width);
  for (std::size_t i = 0; i < u.size(); ++i) {
    std::ranges::fill(row, glm::dvec4(0.0));
    auto line = static_cast<std::size_t>(u.first(i));
    for (const double weight : u.weights(i)) {
      for (std::size_t j = 0; j < width; ++j) row[j] += weight * net[line * width + j];
      ++line;
    }
    for (std::size_t j = 0; j < v.size(); ++j) points.push_back(weighted_sum(v.weights(j), &row[static_cast<std::size_t>(v.first(j))]));
  }
  return points;
}

/// Control points of a direction from rows of numbers at its Greville places.
std::vector<double> solved(const KnotVector& knots, const std::vector<double>& places, std::vector<std::vector<double>> rows) {
  RowConditions given{places, std::move(rows), {}, {}};
  if (knots.periodic()) given.parameters.push_back(places.front() + knots.domain().length());
  const Closing closing = knots.periodic() ? Closing::closed : Closing::open;
  return spline_through(given, knots.degree(), closing, {knots.knots().begin(), knots.knots().end()}).controls;
}

class SurfaceFit {
 public:
  SurfaceFit(const NurbsPatch& model, const SurfaceFunction& surface) : model_(ready(model)), surface_(surface) { meet(); }

  Approximation<NurbsPatch> within(double tolerance, std::size_t most) {
    Round before;
    for (;;) {
      Missed missed = missed_places(kSeen * tolerance);
      if (missed.u.empty() && missed.v.empty()) {
        missed = looked_at_closely(missed, tolerance);
        if (missed.u.empty()) return {*made_, std::min(tolerance, missed.error / kSeen)};
      }
      const Round now{static_cast<double>(made_->points().size()), missed.error};
      if (now.count > static_cast<double>(most) || is_hopeless(before, now, kSeen * tolerance, static_cast<double>(most))) {
        const std::string what = "the surface cannot be fitted with " + std::to_string(made_->points().size()) + " control points: most is " +
                                 "missed at u = " + text_of(missed.at[0]) + ", v = " + text_of(missed.at[1]);
        throw SurfaceMissed(what, tolerance, missed.error / kSeen, missed.at[0], missed.at[1]);
      }
      before = now;
      if (!raised()) {
        if (!missed.u.empty()) model_ = refine(model_, Axis::u, missed.u);
        if (!missed.v.empty()) model_ = refine(model_, Axis::v, missed.v);
      }
      meet();
    }
  }

 private:
  /// So many control points, and what they miss.
  struct Round {
    double count = 0.0;
    double error = 0.0;
  };

  /// Whether points up to the most, by which the error falls as from one round to the next, would miss the surface by far.
  static bool is_hopeless(const Round& before, const Round& now, double tolerance, double most) {
    constexpr double kLate = 8.0;
    constexpr double kFar = 2.0;
    if (before.count == 0.0 || now.count * kLate < most || !(now.count > before.count)) return false;
    const double rounds = 1.0 + std::log(most / now.count) / std::log(now.count / before.count);
    return now.error * std::pow(std::min(1.0, now.error / before.error), rounds) > kFar * tolerance;
  }

  /// Middles of spans in which the surface was missed.
  struct Missed {
    std::vector<double> u;
    std::vector<double> v;
    double error = 0.0;
    std::array<double, 2> at{};  ///< where that is
  };

  bool raised() {
    constexpr int kLeast = 3;
    bool is_raised = false;
    for (const Axis axis : kBoth) {
      const int degree = model_.knot_vector(axis).degree();
      if (degree >= kLeast) continue;
      model_ = elevated(model_, axis, kLeast - degree);
      is_raised = true;
    }
    return is_raised;
  }

  /// The patch that meets the surface at all pairs of Greville places.
  void meet() {
    const KnotVector& knots_u = model_.knot_vector(Axis::u);
    const KnotVector& knots_v = model_.knot_vector(Axis::v);
    places_u_ = greville_places(knots_u);
    places_v_ = greville_places(knots_v);
    const std::vector<glm::dvec4> wanted = on_surface(places_u_, places_v_);
    const std::size_t count_u = places_u_.size();
    const std::size_t count_v = places_v_.size();
    std::vector<std::vector<double>> rows(count_u);
    for (std::size_t i = 0; i < count_u; ++i) {
      for (std::size_t j = 0; j < count_v; ++j) {
        const glm::dvec4& p = wanted[i * count_v + j];
        rows[i].insert(rows[i].end(), {p.x, p.y, p.z});
      }
    }
    const std::vector<double> along_u = solved(knots_u, places_u_, std::move(rows));
    std::vector<std::vector<double>> columns(count_v);
    for (std::size_t j = 0; j < count_v; ++j) {
      for (std::size_t i = 0; i < count_u; ++i) {
        const double* const p = &along_u[3 * (i * count_v + j)];
        columns[j].insert(columns[j].end(), p, p + 3);
      }
    }
    const std::vector<double> controls = solved(knots_v, places_v_, std::move(columns));
    write(controls);
  }

  void write(const std::vector<double>& controls) {
    const std::size_t count_u = places_u_.size();
    const std::size_t count_v = places_v_.size();
    const auto weights = model_.homogeneous_points();
    const auto width = static_cast<std::size_t>(model_.knot_vector(Axis::v).unrolled_count());
    std::vector<glm::dvec4> net(count_u * count_v);
    for (std::size_t i = 0; i < count_u; ++i) {
      for (std::size_t j = 0; j < count_v; ++j) {
        const double* const p = &controls[3 * (j * count_u + i)];
        net[i * count_v + j] = {p[0], p[1], p[2], weights[i * width + j].w};
      }
    }
    made_ = NurbsPatch::from_homogeneous(model_.knot_vector(Axis::u), model_.knot_vector(Axis::v), net);
  }

  Samples samples(Axis axis, std::span<const double> places) const {
    return Samples::make(model_.knot_vector(axis), places, 0, Side::right, axis == Axis::u ? "u" : "v");
  }

  /// The surface's points, times the weights there.
  std::vector<glm::dvec4> on_surface(const std::vector<double>& u, const std::vector<double>& v) const {
    std::vector<glm::dvec3> points(u.size() * v.size());
    surface_(u, v, points);
    std::vector<glm::dvec4> found = homogeneous_grid(model_, samples(Axis::u, u), samples(Axis::v, v));
    for (std::size_t i = 0; i < points.size(); ++i) found[i] = glm::dvec4(found[i].w * points[i], found[i].w);
    return found;
  }

  std::vector<double> distances(const std::vector<double>& u, const std::vector<double>& v) const {
    const std::vector<glm::dvec4> wanted = on_surface(u, v);
    const std::vector<glm::dvec4> found = homogeneous_grid(*made_, samples(Axis::u, u), samples(Axis::v, v));
    std::vector<double> distances;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double weight = wanted[i].w;
      distances.push_back(weight == 0.0 ? 0.0 : length_of(glm::dvec3(wanted[i]) - glm::dvec3(found[i])) / std::abs(weight));
    }
    return distances;
  }

  std::vector<double> middles(Axis axis) const {
    const KnotVector& knots = model_.knot_vector(axis);
    std::vector<double> found;
    for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
      const Interval span = knots.span_interval(i);
      found.push_back(span.start + 0.5 * span.length());
    }
    return found;
  }

  /// So many places of each span, its start and others that are denser towards both ends: at knots, where it is less smooth, and
  /// beside them, where functions of high degrees go astray, much may be missed.
  std::vector<double> inner_places(Axis axis, std::size_t count) const {
    const KnotVector& knots = model_.knot_vector(axis);
    std::vector<double> found;
    for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
      const Interval span = knots.span_interval(i);
      for (std::size_t k = 0; k < count; ++k) {
        const double share = 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(count));
        found.push_back(span.start + share * span.length());
      }
    }
    return found;
  }

  /// How many places of a span are looked at before a fit is taken: of a long one more.
  std::size_t many_places(Axis axis) const {
    constexpr std::size_t kAlong = 32;
    constexpr std::size_t kMost = 13;
    const KnotVector& knots = model_.knot_vector(axis);
    const auto most = std::max(kMost, static_cast<std::size_t>(knots.degree()) + 4);
    return std::min(most, kFew + kAlong / knots.spans().size());
  }

  /// By one direction at the Greville places of the other, where that is met; and by both between them.
  Missed missed_places(double tolerance) const {
    std::vector<char> misses_u(model_.knot_vector(Axis::u).spans().size(), 0);
    std::vector<char> misses_v(model_.knot_vector(Axis::v).spans().size(), 0);
    Missed missed;
    const auto look = [&](const std::vector<double>& u, const std::vector<double>& v, std::size_t each_u, std::size_t each_v) {
      const std::vector<double> off = distances(u, v);
      for (std::size_t k = 0; k < off.size(); ++k) {
        if (off[k] > missed.error) {
          missed.error = off[k];
          missed.at = {u[k / v.size()], v[k % v.size()]};
        }
        if (off[k] <= tolerance) continue;
        if (each_u > 0) misses_u[k / v.size() / each_u] = 1;
        if (each_v > 0) misses_v[k % v.size() / each_v] = 1;
      }
      return std::ranges::count(misses_u, 1) + std::ranges::count(misses_v, 1) > 0;
    };
    const auto is_missed_by = [&](std::size_t each_u, std::size_t each_v) {
      const std::vector<double> inside_u = inner_places(Axis::u, each_u);
      const std::vector<double> inside_v = inner_places(Axis::v, each_v);
      const bool misses_along_u = look(inside_u, places_v_, each_u, 0);
      return look(places_u_, inside_v, 0, each_v) || misses_along_u || look(inside_u, inside_v, each_u, each_v);
    };
    const std::array<std::size_t, 2> many{many_places(Axis::u), many_places(Axis::v)};
    if (!is_missed_by(kFew, kFew) && many != std::array{kFew, kFew}) is_missed_by(many[0], many[1]);
    const std::vector<double> middles_u = middles(Axis::u);
    const std::vector<double> middles_v = middles(Axis::v);
    for (std::size_t i = 0; i < misses_u.size(); ++i) {
      if (misses_u[i]) missed.u.push_back(middles_u[i]);
    }
    for (std::size_t j = 0; j < misses_v.size(); ++j) {
      if (misses_v[j]) missed.v.push_back(middles_v[j]);
    }
    return missed;
  }

  /// Between the places that were looked at, beside those where most is missed.
  Missed looked_at_closely(Missed missed, double tolerance) const {
    constexpr double kMuch = 0.7;
    constexpr std::size_t kMost = 48;
    const std::vector<double> u = inner_places(Axis::u, many_places(Axis::u));
    const std::vector<double> v = inner_places(Axis::v, many_places(Axis::v));
    const std::vector<double> off = distances(u, v);
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < off.size(); ++k) {
      if (off[k] > kMuch * missed.error) places.push_back(k);
    }
    std::ranges::stable_sort(places, std::greater{}, [&](std::size_t k) { return off[k]; });
    places.resize(std::min(places.size(), kMost));
    for (const std::size_t k : places) {
      const std::vector<double> beside_u = beside(u, k / v.size(), model_.knot_vector(Axis::u).domain());
      const std::vector<double> beside_v = beside(v, k % v.size(), model_.knot_vector(Axis::v).domain());
      const double most = std::ranges::max(distances(beside_u, beside_v));
      missed.error = std::max(missed.error, most);
      if (most <= tolerance) continue;
      missed.u = {middle_at(Axis::u, u[k / v.size()])};
      missed.v = {middle_at(Axis::v, v[k % v.size()])};
      break;
    }
    return missed;
  }

  /// From the place before one to that behind it.
  static std::vector<double> beside(const std::vector<double>& places, std::size_t i, const Interval& domain) {
    constexpr int kSteps = 4;
    const double before = i > 0 ? places[i - 1] : domain.start;
    const double behind = i + 1 < places.size() ? places[i + 1] : domain.end;
    std::vector<double> found;
    for (int k = 0; k < kSteps && i > 0; ++k) found.push_back(before + (places[i] - before) * k / kSteps);
    for (int k = 0; k <= kSteps; ++k) found.push_back(places[i] + (behind - places[i]) * k / kSteps);
    return found;
  }

  /// Of the span that a place is in.
  double middle_at(Axis axis, double at) const {
    const KnotVector& knots = model_.knot_vector(axis);
    const Interval span = knots.span_interval(knots.span_of(at, Side::right));
    return span.start + 0.5 * span.length();
  }

  NurbsPatch model_;
  const SurfaceFunction& surface_;
  std::vector<double> places_u_;
  std::vector<double> places_v_;
  std::optional<NurbsPatch> made_;
};

}  // namespace

SurfaceMissed::SurfaceMissed(const std::string& what, double tolerance, double error, double at_u, double at_v)
    : ToleranceNotReached(what, tolerance, error), u(at_u), v(at_v) {}

Approximation<NurbsPatch> fitted_patch(const NurbsPatch& model, const SurfaceFunction& surface, double tolerance,
                                       std::size_t most) {
  return SurfaceFit(model, surface).within(tolerance, most);
}

}  // namespace splinecore
