#include "rail_frames.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/length.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/moving_frame.hpp"

namespace splinecore {

namespace {

MovingFrame upright(const glm::dvec3& tangent, const glm::dvec3& up, double at) {
  constexpr double kAlong = 1e-7;
  const glm::dvec3 high = up - glm::dot(up, tangent) * tangent;
  if (!(length_of(high) > kAlong * length_of(up))) {
    throw InvalidShape("the rail runs along the upright direction at " + text_of(at) + ": nothing is upright there");
  }
  const glm::dvec3 binormal = high / length_of(high);
  return {tangent, glm::cross(binormal, tangent), binormal};
}

bool closes_smoothly(const NurbsCurve& rail) { return rail.periodic(); }

void write_frames(const NurbsCurve& rail, std::span<const double> at, Side side, const SweepOptions& options,
                  std::span<MovingFrame> out) {
  rotation_minimising_frames(rail, at, out, {options.start, closes_smoothly(rail)}, side);
  if (options.frame == RailFrame::upright) {
    for (std::size_t i = 0; i < at.size(); ++i) out[i] = upright(out[i].tangent, options.up, at[i]);
  }
}

}  // namespace

std::vector<RailPlace> rail_places(const NurbsCurve& rail, std::span<const double> at, const Interval& stretch,
                                   const SweepOptions& options) {
  std::vector<glm::dvec3> points(at.size());
  std::vector<MovingFrame> frames(at.size());
  for (std::size_t begin = 0; begin < at.size();) {
    const bool is_end = at[begin] == stretch.end;
    std::size_t end = begin;
    while (end < at.size() && (at[end] == stretch.end) == is_end) ++end;
    const auto part = at.subspan(begin, end - begin);
    const Side side = is_end ? Side::left : Side::right;
    evaluate(rail, part, std::span(&points[begin].x, 3 * part.size()), {.side = side});
    write_frames(rail, part, side, options, std::span(frames).subspan(begin, part.size()));
    begin = end;
  }
  std::vector<RailPlace> places;
  for (std::size_t i = 0; i < at.size(); ++i) places.push_back({points[i], frames[i]});
  return places;
}

}  // namespace splinecore
