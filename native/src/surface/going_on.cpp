#include "going_on.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

#include "base/length.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

std::vector<glm::dvec4> scaled(double factor, std::vector<glm::dvec4> row) {
  for (glm::dvec4& p : row) p *= factor;
  return row;
}

void add_row(std::vector<glm::dvec4>& row, double factor, const std::vector<glm::dvec4>& other) {
  for (std::size_t i = 0; i < row.size(); ++i) row[i] += factor * other[i];
}

double speed_of(std::span<const glm::dvec4> row, std::span<const glm::dvec4> derivative) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const double w = row[i].w;
    if (w == 0.0) continue;
    sum += length_of((glm::dvec3(derivative[i]) - derivative[i].w / w * glm::dvec3(row[i])) / w);
    count += 1.0;
  }
  return count == 0.0 ? 0.0 : sum / count;
}

namespace {

/// Derivatives of orders 1 to 3 of the point that homogeneous ones are of; 0 at infinity.
std::array<glm::dvec3, 3> point_derivatives(const glm::dvec4& row, const std::array<glm::dvec4, 3>& by) {
  const double w = row.w;
  if (w == 0.0) return {};
  const glm::dvec3 point = glm::dvec3(row) / w;
  const glm::dvec3 first = (glm::dvec3(by[0]) - by[0].w * point) / w;
  const glm::dvec3 second = (glm::dvec3(by[1]) - by[1].w * point - 2.0 * by[0].w * first) / w;
  const glm::dvec3 third = (glm::dvec3(by[2]) - by[2].w * point - 3.0 * by[1].w * first - 3.0 * by[0].w * second) / w;
  return {first, second, third};
}

/// The mean part of second or third derivatives along the first ones, by how long these are on average.
double gain_of(std::span<const glm::dvec4> edge, const LeavingRows& rows, std::size_t order) {
  double along = 0.0;
  double speed = 0.0;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    std::array<glm::dvec4, 3> by{};
    for (std::size_t k = 0; k < order; ++k) by[k] = rows[k][i];
    const auto points = point_derivatives(edge[i], by);
    const double length = length_of(points[0]);
    if (!(length > 0.0)) continue;
    along += glm::dot(points[order - 1], points[0] / length);
    speed += length;
  }
  return speed > 0.0 ? along / speed : 0.0;
}

/// Derivatives of A(k t + m t² / 2 + n t³ / 6).
LeavingRows paced_rows(std::span<const glm::dvec4> edge, const LeavingRows& out, double k, double room) {
  constexpr double kMostOfSecond = 1e9;  // beyond these, what is left of such gains would be rounding
  constexpr double kMostOfThird = 1e5;
  const auto taken = [&](double gain, double most, double too_much) {
    if (std::abs(gain) > too_much * most) {
      throw InvalidShape("a patch has a nearly zero derivative across its side: its curvature cannot be continued there");
    }
    return std::clamp(gain, -most, most) - gain;
  };
  LeavingRows made{scaled(k, out[0])};
  if (out.size() < 2) return made;
  made.push_back(scaled(k * k, out[1]));
  const double m = k * taken(gain_of(edge, made, 2), 1.0 / room, kMostOfSecond);
  add_row(made[1], m, out[0]);
  if (out.size() < 3) return made;
  made.push_back(scaled(k * k * k, out[2]));
  add_row(made[2], 3.0 * k * m, out[1]);
  add_row(made[2], k * taken(gain_of(edge, made, 3), 1.0 / (room * room), kMostOfThird), out[0]);
  return made;
}

}  // namespace

LeavingRows going_on(std::span<const glm::dvec4> edge, const LeavingRows& out, double k, double room) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    if (edge[i].w == 0.0) continue;
    sum += out[0][i].w / edge[i].w;
    count += 1.0;
  }
  const double level = -k * sum / count;
  const LeavingRows paced = paced_rows(edge, out, k, room);
  LeavingRows found;
  for (std::size_t order = 1; order <= paced.size(); ++order) {
    std::vector<glm::dvec4> row = scaled(std::pow(level, order), {edge.begin(), edge.end()});
    double choose = 1.0;
    for (std::size_t m = 1; m <= order; ++m) {
      choose *= static_cast<double>(order - m + 1) / static_cast<double>(m);
      add_row(row, choose * std::pow(level, order - m), paced[m - 1]);
    }
    found.push_back(std::move(row));
  }
  return found;
}

}  // namespace splinecore
