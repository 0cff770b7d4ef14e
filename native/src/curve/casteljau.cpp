#include "splinecore/curve/casteljau.hpp"

#include <cmath>
#include <limits>

#include "base/quotient.hpp"
#include "base/rounding.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

void require_number(double u) {
  if (!std::isfinite(u)) throw InvalidShape("u = " + text_of(u) + " is not finite");
}

std::string place(std::size_t row, std::size_t i) {
  return "point " + std::to_string(i) + " of row " + std::to_string(row);
}

std::optional<Breakdown> direction_among(std::span<const glm::dvec4> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].w != 0.0) continue;
    return Breakdown{0, static_cast<int>(i),
                     "weights" + index_text(i) + " = 0: control point " + std::to_string(i) + " is a direction"};
  }
  return std::nullopt;
}

/// Whether the sum of two numbers is zero, or no more than what their rounding leaves.
bool cancels(double a, double b) {
  return std::abs(a + b) <= kRoundingOfStep * (std::abs(a) + std::abs(b));
}

}  // namespace

Triangle casteljau_triangle(const BezierCurve& curve, double u) {
  require_number(u);
  Triangle rows{finite_homogeneous(curve.points())};
  while (rows.back().size() > 1) {
    const auto& above = rows.back();
    std::vector<glm::dvec4> row(above.size() - 1);
    for (std::size_t i = 0; i < row.size(); ++i) {
      row[i] = (1.0 - u) * above[i] + u * above[i + 1];
      if (is_finite(glm::dvec3(row[i])) && std::isfinite(row[i].w)) continue;
      throw InvalidShape("u = " + text_of(u) + ": " + place(rows.size(), i) + " is too large for a number");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

RationalTriangle rational_casteljau_triangle(const BezierCurve& curve, double u) {
  require_number(u);
  RationalTriangle triangle{{{curve.points().begin(), curve.points().end()}}, direction_among(curve.points())};
  if (triangle.breakdown) return {{}, triangle.breakdown};
  while (triangle.rows.back().size() > 1) {
    const auto& above = triangle.rows.back();
    std::vector<glm::dvec4> row(above.size() - 1);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const double before = (1.0 - u) * above[i].w;
      const double after = u * above[i + 1].w;
      if (cancels(before, after)) {
        const int number = static_cast<int>(triangle.rows.size());
        triangle.breakdown = Breakdown{number, static_cast<int>(i),
                                       "the weights " + text_of(before) + " and " + text_of(after) + " cancel in row " +
                                           std::to_string(number) + ", point " + std::to_string(i)};
        return triangle;
      }
      const double s = after / (before + after);
      row[i] = {(1.0 - s) * glm::dvec3(above[i]) + s * glm::dvec3(above[i + 1]), before + after};
      if (!is_finite(glm::dvec3(row[i])) || !std::isfinite(row[i].w)) {
        const int number = static_cast<int>(triangle.rows.size());
        triangle.breakdown = Breakdown{number, static_cast<int>(i),
                                       place(triangle.rows.size(), i) + " is too large for a number"};
        return triangle;
      }
    }
    triangle.rows.push_back(std::move(row));
  }
  return triangle;
}

}  // namespace splinecore
