#include "nine_places.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "base/angle.hpp"
#include "base/length.hpp"
#include "base/quotient.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

/// Squared, so that a root is drawn of the largest alone.
double size_of(const glm::dvec3& difference) { return glm::dot(difference, difference); }

/// The derivatives of a point by both parameters, times its weight.
struct WeightedSlopes {
  glm::dvec3 u;
  glm::dvec3 v;
};

WeightedSlopes slopes_of(const glm::dvec4& h, const glm::dvec4& hu, const glm::dvec4& hv) {
  if (hu.w == 0.0 && hv.w == 0.0) return {glm::dvec3(hu), glm::dvec3(hv)};
  return {glm::dvec3(hu) - hu.w / h.w * glm::dvec3(h), glm::dvec3(hv) - hv.w / h.w * glm::dvec3(h)};
}

/// Their unit normal, or (0, 0, 0) where one of them is no more than rounding.
glm::dvec3 unit_normal(const WeightedSlopes& slopes, double magnitude) {
  const glm::dvec3 normal = glm::cross(slopes.u, slopes.v);
  const double size = size_of(normal);
  const double size_u = size_of(slopes.u);
  const double size_v = size_of(slopes.v);
  constexpr double kNothing = 0x1p-80;  // squared, as the sizes are
  const double least = kNothing * magnitude;
  const bool is_noise = !(size_u > least) || !(size_v > least) || !(size > kNothing * size_u * size_v);
  return is_noise ? glm::dvec3(0.0) : normal / std::sqrt(size);
}

glm::dvec3 unit_normal(const glm::dvec4& h, const glm::dvec4& hu, const glm::dvec4& hv, double magnitude) {
  return unit_normal(slopes_of(h, hu, hv), magnitude);
}

/// The sum of the net with these factors along u and v.
glm::dvec4 blended(const BernsteinNet<glm::dvec4>& net, std::span<const double> along_u,
                   std::span<const double> along_v) {
  glm::dvec4 sum(0.0);
  for (std::size_t i = 0; i < net.rows; ++i) {
    sum += along_u[i] * weighted_sum(along_v, net.values.data() + i * net.columns);
  }
  return sum;
}

/// Largest coordinate times the weight, squared: what rounding is relative to.
double magnitude_of(const BernsteinNet<glm::dvec4>& net) {
  double found = 0.0;
  for (const glm::dvec4& p : net.values) found = std::max(found, size_of(glm::dvec3(p)));
  return found;
}

std::array<BernsteinRow, 3> rows_of(int degree, double margin) {
  return {BernsteinRow(degree, margin), BernsteinRow(degree, 0.5), BernsteinRow(degree, 1.0 - margin)};
}

/// The place on a line along a direction.
std::size_t place_on(Axis axis, int line, int k) { return axis == Axis::u ? 3 * k + line : 3 * line + k; }

constexpr double kInside = 0x1p-10;

}  // namespace

NinePlaces::NinePlaces(int degree_u, int degree_v, bool rational)
    : rational_(rational), u_(rows_of(degree_u, 0.0)), v_(rows_of(degree_v, 0.0)), inner_u_(rows_of(degree_u, kInside)),
      inner_v_(rows_of(degree_v, kInside)), row_values_(3 * (degree_u + 1)), row_slopes_(3 * (degree_u + 1)) {}

void NinePlaces::take(const BernsteinNet<glm::dvec4>& piece) {
  piece_ = &piece;
  has_values_ = has_points_ = has_normals_ = has_pairs_ = false;
  middle_slopes_ = {};
}

/// The homogeneous points at the nine places.
void NinePlaces::blend_values() {
  if (has_values_) return;
  has_values_ = true;
  const std::size_t rows = piece_->rows;
  const std::size_t columns = piece_->columns;
  const double* const middle_u = u_[1].values.data();
  glm::dvec4 first(0.0);
  glm::dvec4 half(0.0);
  glm::dvec4 last(0.0);
  for (std::size_t i = 0; i < rows; ++i) {
    const glm::dvec4* row = piece_->values.data() + i * columns;
    const glm::dvec4 sum = weighted_sum(v_[1].values, row);
    row_values_[3 * i] = row[0];
    row_values_[3 * i + 1] = sum;
    row_values_[3 * i + 2] = row[columns - 1];
    first += middle_u[i] * row[0];
    half += middle_u[i] * sum;
    last += middle_u[i] * row[columns - 1];
  }
  std::copy_n(row_values_.begin(), 3, values_.begin());
  values_[3] = first;
  values_[4] = half;
  values_[5] = last;
  std::copy_n(row_values_.begin() + 3 * (rows - 1), 3, values_.begin() + 6);
}

/// The slopes of each row at the three places along v.
void NinePlaces::blend_slopes() {
  const std::size_t columns = piece_->columns;
  const double degree = piece_->degree(Axis::v);
  for (std::size_t i = 0; i < piece_->rows; ++i) {
    const glm::dvec4* row = piece_->values.data() + i * columns;
    row_slopes_[3 * i] = degree * row[1] - degree * row[0];
    row_slopes_[3 * i + 1] = weighted_sum(v_[1].slopes, row);
    row_slopes_[3 * i + 2] = degree * row[columns - 1] - degree * row[columns - 2];
  }
}

const std::array<glm::dvec3, 9>& NinePlaces::points() {
  if (has_points_) return points_;
  has_points_ = true;
  blend_values();
  for (std::size_t k = 0; k < 9; ++k) points_[k] = rational_ ? project(values_[k]) : glm::dvec3(values_[k]);
  return points_;
}

/// The normal a little inside, for places where it vanishes, as at a pole.
glm::dvec3 NinePlaces::normal_near(int place, double magnitude) const {
  const BernsteinRow& u = inner_u_[place / 3];
  const BernsteinRow& v = inner_v_[place % 3];
  return unit_normal(blended(*piece_, u.values, v.values), blended(*piece_, u.slopes, v.values),
                     blended(*piece_, u.values, v.slopes), magnitude);
}

glm::dvec3 NinePlaces::middle_normal() {
  if (has_normals_) return normals_[4];
  blend_values();
  glm::dvec4 slope_u(0.0);
  glm::dvec4 slope_v(0.0);
  for (std::size_t i = 0; i < piece_->rows; ++i) {
    const glm::dvec4* row = piece_->values.data() + i * piece_->columns;
    slope_u += u_[1].slopes[i] * row_values_[3 * i + 1];
    slope_v += u_[1].values[i] * weighted_sum(v_[1].slopes, row);
  }
  const double magnitude = magnitude_of(*piece_);
  const WeightedSlopes slopes = slopes_of(values_[4], slope_u, slope_v);
  const glm::dvec3 normal = unit_normal(slopes, magnitude);
  if (normal == glm::dvec3(0.0)) return normal_near(4, magnitude);
  middle_slopes_ = {slopes.u / values_[4].w, slopes.v / values_[4].w};
  return normal;
}

double NinePlaces::sine_bound(const SecondDerivativeBounds& bounds) const {
  // No derivative differs from that in the middle by more, nor then does their product, the normal.
  const double apart_u = 0.5 * (bounds.uu + bounds.uv);
  const double apart_v = 0.5 * (bounds.uv + bounds.vv);
  const double length_u = glm::length(middle_slopes_[0]);
  const double length_v = glm::length(middle_slopes_[1]);
  const double apart = length_u * apart_v + length_v * apart_u + apart_u * apart_v;
  const double part = apart / glm::length(glm::cross(middle_slopes_[0], middle_slopes_[1]));
  constexpr double kLargestPart = 0.5;  // twice its arc is below a right angle
  return part < kLargestPart ? 2.0 * part : 1.0;
}

const std::array<glm::dvec3, 9>& NinePlaces::normals() {
  if (has_normals_) return normals_;
  has_normals_ = true;
  blend_values();
  blend_slopes();
  const double magnitude = magnitude_of(*piece_);
  const std::size_t rows = piece_->rows;
  const double degree = piece_->degree(Axis::u);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto value = [&](std::size_t row) -> const glm::dvec4& { return row_values_[3 * row + k]; };
    glm::dvec4 slope_u(0.0);
    glm::dvec4 slope_v(0.0);
    for (std::size_t i = 0; i < rows; ++i) {
      slope_u += u_[1].slopes[i] * value(i);
      slope_v += u_[1].values[i] * row_slopes_[3 * i + k];
    }
    normals_[k] = unit_normal(values_[k], degree * value(1) - degree * value(0), row_slopes_[k], magnitude);
    normals_[3 + k] = unit_normal(values_[3 + k], slope_u, slope_v, magnitude);
    normals_[6 + k] = unit_normal(values_[6 + k], degree * value(rows - 1) - degree * value(rows - 2),
                                  row_slopes_[3 * (rows - 1) + k], magnitude);
  }
  for (int k = 0; k < 9; ++k) {
    if (normals_[k] == glm::dvec3(0.0)) normals_[k] = normal_near(k, magnitude);
  }
  return normals_;
}

const NinePlaces::Pairs& NinePlaces::farthest_normals() {
  if (has_pairs_) return pairs_;
  has_pairs_ = true;
  pairs_ = {};
  const std::array<glm::dvec3, 9>& all = normals();
  for (int i = 1; i < 9; ++i) {
    if (all[i] == glm::dvec3(0.0)) continue;
    for (int j = 0; j < i; ++j) {
      const double chord = size_of(all[i] - all[j]);
      const auto take = [&](Pair& pair) {
        if (chord > pair.chord && all[j] != glm::dvec3(0.0)) pair = {i, j, chord};
      };
      take(pairs_.all);
      if (i % 3 == j % 3) take(pairs_.u);
      if (i / 3 == j / 3) take(pairs_.v);
    }
  }
  return pairs_;
}

NormalAngles NinePlaces::normal_angles() {
  const Pairs& pairs = farthest_normals();
  const auto angle = [&](const Pair& pair) {
    return pair.chord > 0.0 ? angle_between(normals_[pair.a], normals_[pair.b]) : 0.0;
  };
  return {angle(pairs.u), angle(pairs.v), angle(pairs.all)};
}

double NinePlaces::largest_sine() {
  const Pair& pair = farthest_normals().all;
  if (!(pair.chord > 0.0)) return 0.0;
  const glm::dvec3& a = normals_[pair.a];
  const glm::dvec3& b = normals_[pair.b];
  return glm::dot(a, b) > 0.0 ? glm::length(glm::cross(a, b)) : 1.0;
}

double NinePlaces::length(Axis axis, int line) {
  const auto at = [&](int k) { return points()[place_on(axis, line, k)]; };
  return glm::length(at(1) - at(0)) + glm::length(at(2) - at(1));
}

std::pair<double, double> NinePlaces::lengths(Axis axis) { return std::minmax({length(axis, 0), length(axis, 2)}); }

double NinePlaces::longest(Axis axis) { return std::max({length(axis, 0), length(axis, 1), length(axis, 2)}); }

double NinePlaces::sagitta(Axis axis) {
  double found = 0.0;
  for (int line = 0; line < 3; ++line) {
    const auto at = [&](int k) { return points()[place_on(axis, line, k)]; };
    found = std::max(found, distance_to_segment(at(1), at(0), at(2)));
  }
  return found;
}

}  // namespace splinecore
