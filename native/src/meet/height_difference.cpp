#include "height_difference.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "part_heights.hpp"

namespace splinecore {

namespace {

/// The plane right between both parts, if they lie along it. Its first axis is along one of a's parameters.
std::optional<HeightFrame> frame_between(const PatchPart& a, const PatchPart& b) {
  constexpr double kMostSpread = 0.6;
  constexpr double kParallel = 0.8;
  const VectorCone& of_a = a.normals();
  const VectorCone& of_b = b.normals();
  if (!(of_a.spread < kMostSpread && of_b.spread < kMostSpread)) return {};
  const double cosine = glm::dot(of_a.along, of_b.along);
  if (std::abs(cosine) < kParallel) return {};
  const glm::dvec3 up = glm::normalize(of_a.along + std::copysign(1.0, cosine) * of_b.along);
  const glm::dvec3& u = a.tangents(Axis::u).along;
  const glm::dvec3 across = glm::cross(up, u);
  if (!(glm::length(across) > 0.0)) return {};
  const glm::dvec3 y = glm::normalize(across);
  return HeightFrame{0.5 * (a.points.front() + a.points.back()), {glm::cross(y, up), y, up}};
}

/// The difference of two polynomials over a box.
struct DifferenceOverBox {
  double middle;
  double half;
  glm::dvec2 slope;
  double spread;  ///< how far slopes are from that
  double bend;    ///< the largest size of a second derivative, nearly

  DifferenceOverBox(const QuadraticHeights& a, const QuadraticHeights& b, const glm::dvec2& low, const glm::dvec2& high) {
    const glm::dvec2 at = 0.5 * (low + high);
    const glm::dvec2 far = 0.5 * (high - low);
    const double xx = std::abs(a.bend[0] - b.bend[0]);
    const double xy = std::abs(a.bend[1] - b.bend[1]);
    const double yy = std::abs(a.bend[2] - b.bend[2]);
    middle = a.height_at(at) - b.height_at(at);
    slope = a.slope_at(at) - b.slope_at(at);
    half = std::abs(slope.x) * far.x + std::abs(slope.y) * far.y +
           0.5 * (xx * far.x * far.x + 2.0 * xy * far.x * far.y + yy * far.y * far.y);
    bend = std::max({xx, xy, yy});
    spread = glm::length(glm::dvec2(xx * far.x + xy * far.y, xy * far.x + yy * far.y));
  }
};

std::array<double, 4> leads_along(const std::array<PartHeights, 2>& parts, const FlatCone& way) {
  std::array<double, 4> leads{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [u, v] = parts[i].tangents;
    const double turn = least_cross(u, v) < 0.0 ? -1.0 : 1.0;
    leads[2 * i] = turn * least_cross(way, v);
    leads[2 * i + 1] = turn * least_cross(u, way);
  }
  return leads;
}

}  // namespace

std::optional<HeightDifference> height_difference(const PatchPart& a, const PatchPart& b, double rounding) {
  constexpr double kMostRoundings = 4.0;
  constexpr std::size_t kMostPoints = 100;  // products of nets grow with the square
  if (!a.is_boxed || !b.is_boxed || std::max(a.points.size(), b.points.size()) > kMostPoints) return {};
  const std::optional<HeightFrame> frame = frame_between(a, b);
  if (!frame) return {};
  const auto of_a = nearly_heights(a, *frame);
  const auto of_b = of_a ? nearly_heights(b, *frame) : std::nullopt;
  if (!of_b) return {};
  const glm::dvec2 low = glm::max(of_a->low, of_b->low);
  const glm::dvec2 high = glm::max(low, glm::min(of_a->high, of_b->high));
  if (glm::any(glm::greaterThan(low - rounding, glm::min(of_a->high, of_b->high)))) {
    return HeightDifference{{}, 0.0, 0.0, {}, true};
  }
  const DifferenceOverBox nearly(of_a->nearly, of_b->nearly, low, high);
  const double slope = glm::length(nearly.slope);
  const bool may_be_zero = std::abs(nearly.middle) <= nearly.half && slope <= nearly.spread;
  if (may_be_zero && nearly.half > kMostRoundings * rounding) return {};
  std::array<PartHeights, 2> parts{*of_a, *of_b};
  if (!add_bounds(parts[0], a, *frame) || !add_bounds(parts[1], b, *frame)) return {};
  const double off = nearly.half + parts[0].off + parts[1].off;
  HeightDifference found{{nearly.middle - off, nearly.middle + off}, 0.0, nearly.bend, {}, false};
  const double size = std::min({a.size[0], a.size[1], b.size[0], b.size[1]});
  const double spread = nearly.spread + parts[0].steep + parts[1].steep + rounding / size;
  if (!(slope - spread > 0.0)) return found;
  found.least_slope = slope - spread;
  const double turn = least_cross(parts[0].tangents[0], parts[0].tangents[1]) *
                              least_cross(parts[1].tangents[0], parts[1].tangents[1]) < 0.0 ? -1.0 : 1.0;
  const glm::dvec2 way = turn / slope * glm::dvec2(-nearly.slope.y, nearly.slope.x);
  found.leads = leads_along(parts, {way, std::asin(std::min(1.0, spread / slope))});
  return found;
}

}  // namespace splinecore
