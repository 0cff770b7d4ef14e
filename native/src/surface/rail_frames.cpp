#include "rail_frames.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/length.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"

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

}  // namespace

void RailPlaces::write_frames(std::span<const double> parameters, Side side, std::span<MovingFrame> out) {
  frames_.write(parameters, out, side);
  if (options_.frame != RailFrame::upright) return;
  for (std::size_t i = 0; i < parameters.size(); ++i) out[i] = upright(out[i].tangent, options_.up, parameters[i]);
}

std::vector<RailPlace> RailPlaces::at(std::span<const double> parameters, const Interval& stretch) {
  const std::size_t count = parameters.size();
  std::vector<glm::dvec3> points(count);
  std::vector<MovingFrame> frames(count);
  for (std::size_t begin = 0; begin < count;) {
    const bool is_end = parameters[begin] == stretch.end;
    std::size_t end = begin;
    while (end < count && (parameters[end] == stretch.end) == is_end) ++end;
    const auto part = parameters.subspan(begin, end - begin);
    const Side side = is_end ? Side::left : Side::right;
    evaluate(rail_, part, std::span(&points[begin].x, 3 * part.size()), {.side = side});
    write_frames(part, side, std::span(frames).subspan(begin, part.size()));
    begin = end;
  }
  std::vector<RailPlace> places;
  for (std::size_t i = 0; i < count; ++i) places.push_back({points[i], frames[i]});
  return places;
}

}  // namespace splinecore
