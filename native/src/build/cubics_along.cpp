#include "base/sort_by.hpp"
#include "cubics_along.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <utility>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// Where cubics are compared with the path, and where those that were near once more.
constexpr std::array<double, 4> kLooks{0.125, 0.3125, 0.6875, 0.875};
constexpr std::array<double, 9> kMoreLooks{0.0625, 0.1875, 0.25, 0.375, 0.5, 0.625, 0.75, 0.8125, 0.9375};
constexpr std::size_t kMostCubics = 1U << 20U;

struct Stretch {
  double from;
  double to;
  PathPlace start;
  PathPlace end;

  double at(double s) const { return from + s * (to - from); }

  glm::dvec3 cubic(double s) const {
    const double r = 1.0 - s;
    const double third = (to - from) / 3.0;
    return r * r * (1.0 + 2.0 * s) * start.point + s * s * (1.0 + 2.0 * r) * end.point +
           3.0 * third * s * r * (r * start.slope - s * end.slope);
  }
};

std::vector<Stretch> stretches_of(const Path& path, const std::vector<double>& breaks) {
  std::vector<PathParameter> ends;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    ends.push_back({breaks[i], breaks[i + 1]});
    ends.push_back({breaks[i + 1], breaks[i]});
  }
  const std::vector<PathPlace> places = path(ends);
  std::vector<Stretch> found;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    found.push_back({breaks[i], breaks[i + 1], places[2 * i], places[2 * i + 1]});
  }
  return found;
}

/// Which of them are near the path at those places, and which are not.
void sort_out(const Path& path, const std::vector<Stretch>& all, std::span<const double> looks, double tolerance,
              std::vector<Stretch>& near, std::vector<Stretch>& far) {
  if (all.empty()) return;
  std::vector<PathParameter> places;
  for (const Stretch& one : all) {
    for (const double s : looks) places.push_back({one.at(s), one.to});
  }
  const std::vector<PathPlace> seen = path(places);
  for (std::size_t i = 0; i < all.size(); ++i) {
    bool is_near = true;
    for (std::size_t k = 0; k < looks.size(); ++k) {
      const glm::dvec3& point = seen[i * looks.size() + k].point;
      is_near = is_near && glm::distance(all[i].cubic(looks[k]), point) <= 0.5 * tolerance;
    }
    (is_near ? near : far).push_back(all[i]);
  }
}

[[noreturn]] void throw_too_small() {
  throw InvalidShape("the curve does not come within the tolerance: it is too small");
}

std::vector<Stretch> halves_of(const Path& path, const std::vector<Stretch>& all) {
  std::vector<PathParameter> middles;
  for (const Stretch& one : all) {
    middles.push_back({one.at(0.5), one.to});
    if (!(one.from < middles.back().at && middles.back().at < one.to)) throw_too_small();
  }
  if (all.empty()) return {};
  const std::vector<PathPlace> seen = path(middles);
  std::vector<Stretch> halves;
  for (std::size_t i = 0; i < all.size(); ++i) {
    halves.push_back({all[i].from, middles[i].at, all[i].start, seen[i]});
    halves.push_back({middles[i].at, all[i].to, seen[i], all[i].end});
  }
  return halves;
}

bool is_together(const Stretch& one, const Stretch& next) {
  constexpr double kSame = 0x1p-36;
  return glm::distance(one.end.point, next.start.point) <= kSame;
}

bool goes_on(const Stretch& one, const Stretch& next) {
  if (!is_together(one, next)) return false;
  constexpr double kSame = 0x1p-40;
  const glm::dvec3& in = one.end.slope;
  const glm::dvec3& out = next.start.slope;
  return glm::distance(in, out) <= kSame * std::max(glm::length(in), glm::length(out));
}

NurbsCurve chain_of(const std::vector<Stretch>& stretches) {
  std::vector<double> knots(4, stretches.front().from);
  std::vector<glm::dvec4> points{glm::dvec4(stretches.front().start.point, 1.0)};
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Stretch& one = stretches[i];
    const bool is_last = i + 1 == stretches.size();
    const bool is_smooth = !is_last && goes_on(one, stretches[i + 1]);
    const double third = (one.to - one.from) / 3.0;
    points.emplace_back(one.start.point + third * one.start.slope, 1.0);
    points.emplace_back(one.end.point - third * one.end.slope, 1.0);
    if (!is_smooth) points.emplace_back(one.end.point, 1.0);
    const bool is_gap = !is_last && !is_together(one, stretches[i + 1]);
    if (is_gap) points.emplace_back(stretches[i + 1].start.point, 1.0);
    knots.insert(knots.end(), is_last || is_gap ? 4U : is_smooth ? 2U : 3U, one.to);
  }
  return NurbsCurve::make(3, std::move(knots), std::move(points));
}

}  // namespace

double cubics_tolerance(const NearSpace& space, std::optional<double> tolerance, double size) {
  constexpr double kOfSize = 0x1p-20;
  constexpr double kLeast = 0x1p-40;
  return std::max(tolerance ? *tolerance / space.length(1.0) : size * kOfSize, size * kLeast);
}

std::vector<double> distinct_breaks(std::vector<double> breaks, const Interval& domain) {
  breaks.insert(breaks.end(), {domain.start, domain.end});
  std::ranges::sort(breaks);
  constexpr double kSame = 0x1p-36;
  const auto are_one = [&](double a, double b) { return b - a <= kSame * domain.length(); };
  breaks.erase(std::unique(breaks.begin(), breaks.end(), are_one), breaks.end());
  breaks.back() = domain.end;
  return breaks;
}

NurbsCurve cubics_along(const Path& path, const std::vector<double>& breaks, double tolerance) {
  std::vector<Stretch> open = stretches_of(path, breaks);
  std::vector<Stretch> done;
  while (!open.empty()) {
    breathe(1);
    std::vector<Stretch> near;
    std::vector<Stretch> far;
    sort_out(path, open, kLooks, tolerance, near, far);
    sort_out(path, std::exchange(near, {}), kMoreLooks, tolerance, near, far);
    done.insert(done.end(), near.begin(), near.end());
    if (done.size() + 2 * far.size() > kMostCubics) throw_too_small();
    open = halves_of(path, far);
  }
  sort_by(done, [](const Stretch& stretch) { return stretch.from; });
  return chain_of(done);
}

}  // namespace splinecore
