#include "border_loop.hpp"

#include <algorithm>
#include <string>

#include "base/length.hpp"
#include "base/rounding.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/ends.hpp"

namespace splinecore {

namespace {

glm::dvec3 start_of(const NurbsCurve& curve) { return glm::dvec3(curve.points().front()); }
glm::dvec3 end_of(const NurbsCurve& curve) { return glm::dvec3(curve.points().back()); }

/// The nearer one of a curve's ends.
double distance_to(const glm::dvec3& point, const NurbsCurve& curve) {
  return std::min(distance_of(point, start_of(curve)), distance_of(point, end_of(curve)));
}

std::vector<NurbsCurve> clamped_curves(std::span<const NurbsCurve> curves) {
  std::vector<NurbsCurve> made;
  for (const NurbsCurve& curve : curves) {
    const std::string name = "sides" + index_text(made.size());
    if (curve.periodic()) throw InvalidShape(name + " is closed: a side begins and ends at its neighbors");
    made.push_back(clamped(curve));
    if (made.back().points().front().w == 0.0 || made.back().points().back().w == 0.0) {
      throw InvalidShape(name + " ends at infinity");
    }
  }
  return made;
}

/// Each begins where the one before it ends. @returns which were turned for that
std::vector<bool> turn(std::vector<NurbsCurve>& loop) {
  std::vector<bool> is_turned(loop.size());
  const auto turn_one = [&](std::size_t i) {
    loop[i] = reversed(loop[i]);
    is_turned[i] = true;
  };
  if (distance_to(start_of(loop[0]), loop[1]) < distance_to(end_of(loop[0]), loop[1])) turn_one(0);
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const glm::dvec3 from = end_of(loop[i - 1]);
    const double kept = distance_of(from, start_of(loop[i]));
    const double other = distance_of(from, end_of(loop[i]));
    const glm::dvec3 back = start_of(loop[0]);
    const bool is_last = i + 1 == loop.size();
    const double kept_back = is_last ? distance_of(back, end_of(loop[i])) : 0.0;
    const double other_back = is_last ? distance_of(back, start_of(loop[i])) : 0.0;
    if (other + other_back < kept + kept_back) turn_one(i);
  }
  return is_turned;
}

NurbsCurve with_ends(const NurbsCurve& curve, const glm::dvec3& start, const glm::dvec3& end) {
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  points.front() = glm::dvec4(start, points.front().w);
  points.back() = glm::dvec4(end, points.back().w);
  return curve.with_points(std::move(points));
}

}  // namespace

BorderLoop border_loop(std::span<const NurbsCurve> curves, std::optional<double> tolerance) {
  std::vector<NurbsCurve> loop = clamped_curves(curves);
  std::vector<bool> is_turned = turn(loop);
  std::vector<glm::dvec4> all;
  for (const NurbsCurve& curve : loop) all.insert(all.end(), curve.points().begin(), curve.points().end());
  const double most = tolerance.value_or(kRoundingOfTouch * extent(all));
  const std::size_t count = loop.size();
  std::vector<glm::dvec3> corners(count);  // corner i is where side i begins
  double error = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    const glm::dvec3 end = end_of(loop[before]);
    const glm::dvec3 start = start_of(loop[i]);
    const double gap = distance_of(end, start);
    if (!(gap <= most)) {
      throw ToleranceNotReached("sides" + index_text(before) + " and sides" + index_text(i) + " do not meet: there is a gap",
                                most, gap);
    }
    corners[i] = end == start ? start : 0.5 * end + 0.5 * start;
    error = std::max(error, 0.5 * gap);
  }
  for (std::size_t i = 0; i < count; ++i) loop[i] = with_ends(loop[i], corners[i], corners[(i + 1) % count]);
  return {std::move(loop), std::move(is_turned), most, error};
}

}  // namespace splinecore
