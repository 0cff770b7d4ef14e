#include "seen_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/length.hpp"
#include "measure/numerators.hpp"
#include "measure/signs.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// A line through a point of the border along it: what sees the border there lies to the left.
struct Tangent {
  glm::dvec2 at;
  glm::dvec2 along;

  double height(const glm::dvec2& p) const { return cross(along, p - at); }
};

/// Point and direction of a homogeneous Bezier piece.
Tangent tangent_at(const std::vector<glm::dvec3>& piece, double t) {
  std::vector<glm::dvec3> points = piece;
  for (std::size_t left = points.size(); left > 2; --left) {
    for (std::size_t i = 0; i + 1 < left; ++i) points[i] += t * (points[i + 1] - points[i]);
  }
  const glm::dvec3 p = points[0] + t * (points[1] - points[0]);
  const glm::dvec3 step = points[1] - points[0];
  const glm::dvec2 at = glm::dvec2(p) / p.z;
  const glm::dvec2 along = (glm::dvec2(step) - step.z * at) / p.z;
  const double length = std::hypot(along.x, along.y);
  return {at, length > 0.0 ? along / length : glm::dvec2(0.0)};
}

void add_tangent(std::vector<Tangent>& tangents, const std::vector<glm::dvec3>& piece, double t) {
  const Tangent tangent = tangent_at(piece, t);
  if (tangent.along != glm::dvec2(0.0)) tangents.push_back(tangent);
}

std::vector<Tangent> tangents_of(const std::vector<std::vector<glm::dvec3>>& pieces) {
  std::vector<Tangent> tangents;
  for (const auto& piece : pieces) {
    const int steps = piece.size() == 2 ? 1 : 4 * static_cast<int>(piece.size());
    for (int k = 0; k <= steps; ++k) add_tangent(tangents, piece, static_cast<double>(k) / steps);
  }
  return tangents;
}

using Polygon = std::vector<glm::dvec2>;

Polygon box_around(const std::vector<Tangent>& tangents) {
  glm::dvec2 low = tangents[0].at;
  glm::dvec2 high = low;
  for (const Tangent& tangent : tangents) {
    low = {std::min(low.x, tangent.at.x), std::min(low.y, tangent.at.y)};
    high = {std::max(high.x, tangent.at.x), std::max(high.y, tangent.at.y)};
  }
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

/// The part to the left of a line.
Polygon cut(const Polygon& polygon, const Tangent& line) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i];
    const glm::dvec2 b = polygon[(i + 1) % polygon.size()];
    const double height_a = line.height(a);
    const double height_b = line.height(b);
    if (height_a >= 0.0) kept.push_back(a);
    if ((height_a > 0.0 && height_b < 0.0) || (height_a < 0.0 && height_b > 0.0)) {
      kept.push_back(a + height_a / (height_a - height_b) * (b - a));
    }
  }
  return kept;
}

double area_of(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return 0.5 * sum;
}

glm::dvec2 middle_of(const Polygon& polygon) {
  glm::dvec2 sum(0.0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const double area = cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    sum += area * ((polygon[i] - polygon[0]) + (polygon[i + 1] - polygon[0]));
  }
  return polygon[0] + sum / (6.0 * area_of(polygon));
}

/// Adds tangents where a border runs to the right as seen from a point. @returns whether it does nowhere
bool is_seen(const std::vector<std::vector<glm::dvec3>>& pieces, const glm::dvec2& from, std::vector<Tangent>& tangents) {
  bool is_left = true;
  for (const auto& piece : pieces) {
    breathe(64);
    std::vector<glm::dvec2> about;
    for (const glm::dvec3& p : piece) about.emplace_back(p.x - p.z * from.x, p.y - p.z * from.y);
    const Signs signs(sweep_of(about));
    if (signs.is_zero()) return false;
    for (const Run& run : signs.runs) {
      if (run.sign > 0.0) continue;
      add_tangent(tangents, piece, run.part.middle());
      is_left = false;
    }
  }
  return is_left;
}

bool goes_round_once(const std::vector<std::vector<glm::dvec3>>& pieces, const glm::dvec2& from) {
  double angle = 0.0;
  for (const auto& piece : pieces) {
    const int steps = piece.size() == 2 ? 1 : 4 * static_cast<int>(piece.size());
    for (int k = 0; k < steps; ++k) {
      const glm::dvec2 a = place_on(piece, static_cast<double>(k) / steps) - from;
      const glm::dvec2 b = place_on(piece, static_cast<double>(k + 1) / steps) - from;
      angle += std::atan2(cross(a, b), a.x * b.x + a.y * b.y);
    }
  }
  return std::abs(angle - 2.0 * std::numbers::pi) < 0.1;
}

}  // namespace

glm::dvec2 place_on(const std::vector<glm::dvec3>& piece, double t) {
  if (t == 0.0 || t == 1.0) return glm::dvec2(t == 0.0 ? piece.front() : piece.back()) / (t == 0.0 ? piece.front() : piece.back()).z;
  return tangent_at(piece, t).at;
}

std::optional<glm::dvec2> point_seeing(const std::vector<std::vector<glm::dvec3>>& pieces) {
  constexpr double kNothing = 1e-12;
  constexpr int kRounds = 12;
  std::vector<Tangent> tangents = tangents_of(pieces);
  if (tangents.empty()) return {};
  Polygon seeing = box_around(tangents);
  const double whole = area_of(seeing);
  std::size_t done = 0;
  for (int round = 0; round < kRounds; ++round) {
    for (; done < tangents.size(); ++done) {
      seeing = cut(seeing, tangents[done]);
      if (seeing.size() < 3) return {};
    }
    if (!(area_of(seeing) > kNothing * whole)) return {};
    const glm::dvec2 from = middle_of(seeing);
    if (is_seen(pieces, from, tangents)) return goes_round_once(pieces, from) ? std::optional(from) : std::nullopt;
    if (tangents.size() == done) return {};
  }
  return {};
}

}  // namespace splinecore
