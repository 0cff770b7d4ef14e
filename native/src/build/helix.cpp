#include "splinecore/build/helix.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "cubics_along.hpp"
#include "meet/near_space.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/measure/moving_frame.hpp"

namespace splinecore {

namespace {

class HelixAbout {
 public:
  HelixAbout(const NurbsCurve& axis, const HelixOptions& options, double unit)
      : axis_(axis), options_(options), radii_{options.radii[0] / unit, options.radii[1] / unit} {
    const double end = axis.domain().end;
    whole_ = lengths_at_parameters(axis, std::span(&end, 1)).front();
  }

  std::vector<PathPlace> places(const std::vector<PathParameter>& asked) const {
    std::vector<PathPlace> found(asked.size());
    for (const Side side : {Side::right, Side::left}) {
      std::vector<std::size_t> which;
      std::vector<double> at;
      for (std::size_t i = 0; i < asked.size(); ++i) {
        if ((asked[i].towards < asked[i].at) != (side == Side::left)) continue;
        which.push_back(i);
        at.push_back(asked[i].at);
      }
      const std::vector<PathPlace> of_side = places(at, side);
      for (std::size_t k = 0; k < which.size(); ++k) found[which[k]] = of_side[k];
    }
    return found;
  }

 private:
  std::vector<PathPlace> places(const std::vector<double>& at, Side side) const {
    std::vector<glm::dvec3> d(3 * at.size());
    std::vector<MovingFrame> frames(at.size());
    if (at.empty()) return {};
    derivatives(axis_, at, 2, std::span(&d[0].x, 3 * d.size()), {.side = side});
    rotation_minimizing_frames(axis_, at, frames, {.start = options_.start}, side);
    const std::vector<double> lengths = lengths_at_parameters(axis_, at);
    std::vector<PathPlace> found;
    for (std::size_t i = 0; i < at.size(); ++i) found.push_back(place(&d[3 * i], frames[i], lengths[i] / whole_));
    return found;
  }

  PathPlace place(const glm::dvec3* d, const MovingFrame& frame, double share) const {
    const double rate = 2.0 * std::numbers::pi * options_.turns;
    const double angle = options_.phase + rate * share;
    const double radius = radii_[0] + share * (radii_[1] - radii_[0]);
    const double speed = glm::length(d[1]);
    const double by_share = speed / whole_;
    const glm::dvec3 out = std::cos(angle) * frame.normal + std::sin(angle) * frame.binormal;
    const glm::dvec3 round = std::cos(angle) * frame.binormal - std::sin(angle) * frame.normal;
    // What is carried along turns about no tangent: it leans by the turn of the tangent alone.
    const glm::dvec3 bend = speed > 0.0 ? (d[2] - glm::dot(d[2], frame.tangent) * frame.tangent) / speed : glm::dvec3(0.0);
    const glm::dvec3 lean = -glm::dot(bend, out) * frame.tangent;
    return {d[0] + radius * out, d[1] + by_share * ((radii_[1] - radii_[0]) * out + radius * rate * round) + radius * lean};
  }

  const NurbsCurve& axis_;
  const HelixOptions& options_;
  std::array<double, 2> radii_;
  double whole_ = 0.0;
};

void require_numbers(const HelixOptions& options) {
  for (const double radius : options.radii) {
    if (!(radius >= 0.0) || !std::isfinite(radius)) throw InvalidShape("a radius is not 0 or more");
  }
  if (options.radii[0] == 0.0 && options.radii[1] == 0.0) throw InvalidShape("both radii are 0: that is the axis");
  constexpr double kMostTurns = 4096.0;
  if (!(std::abs(options.turns) > 0.0 && std::abs(options.turns) <= kMostTurns)) {
    throw InvalidShape("the turns are not above 0 and up to 4096, or below");
  }
  if (!std::isfinite(options.phase)) throw InvalidShape("the phase is not a finite number");
  if (options.tolerance && !(*options.tolerance > 0.0)) throw InvalidShape("the tolerance is not above 0");
}

/// Knots of the axis, and quarter turns.
std::vector<double> breaks_of(const NurbsCurve& axis, double turns) {
  const Interval domain = axis.domain();
  std::vector<double> found;
  for (const double knot : axis.knot_vector().knots()) {
    if (knot > domain.start && knot < domain.end) found.push_back(knot);
  }
  const int quarters = static_cast<int>(std::ceil(4.0 * std::abs(turns)));
  const std::vector<double> even = divide(axis, quarters);
  found.insert(found.end(), even.begin(), even.end());
  return distinct_breaks(std::move(found), domain);
}

}  // namespace

NurbsCurve helix(const NurbsCurve& given, const HelixOptions& options) {
  require_numbers(options);
  const NurbsCurve plain = unrolled(given);
  const NearSpace space(plain.points());
  const NurbsCurve axis = plain.with_points(space.enter(plain.points()));
  const double unit = space.length(1.0);
  const HelixAbout about(axis, options, unit);
  const double size = std::max({1.0, options.radii[0] / unit, options.radii[1] / unit});
  const double within = cubics_tolerance(space, options.tolerance, size);
  const Path path = [&](const std::vector<PathParameter>& asked) { return about.places(asked); };
  const NurbsCurve found = cubics_along(path, breaks_of(axis, options.turns), within);
  return found.with_points(space.leave(found.points()));
}

}  // namespace splinecore
