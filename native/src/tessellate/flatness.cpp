#include "flatness.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "base/angle.hpp"
#include "base/quotient.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

/// Squared, so that a root is drawn of the largest alone.
double size_of(const glm::dvec3& difference) { return glm::dot(difference, difference); }
double size_of(double difference) { return difference * difference; }

/// The largest of the differences of a net, first and second ones, as those of the polynomial's derivatives.
struct Differences {
  double u = 0.0;
  double v = 0.0;
  double uu = 0.0;
  double uv = 0.0;
  double vv = 0.0;
};

/// The size that is largest of `count` values.
template <class At>
double largest_of(std::size_t count, At at) {
  double found = 0.0;
  for (std::size_t k = 0; k < count; ++k) found = std::max(found, size_of(at(k)));
  return std::sqrt(found);
}

/// The same over a lattice of rows.
template <class At>
double largest_of(std::size_t rows, std::size_t columns, At at) {
  double found = 0.0;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) found = std::max(found, size_of(at(i, j)));
  }
  return std::sqrt(found);
}

template <class Value>
void add_second_differences(const Value* p, std::size_t rows, std::size_t columns, Differences& found) {
  const auto m = static_cast<double>(rows - 1);
  const auto n = static_cast<double>(columns - 1);
  if (rows > 2) {
    found.uu = m * (m - 1) * largest_of((rows - 2) * columns, [&](std::size_t k) {
                 return p[k + 2 * columns] - 2.0 * p[k + columns] + p[k];
               });
  }
  if (rows > 1 && columns > 1) {
    found.uv = m * n * largest_of(rows - 1, columns - 1, [&](std::size_t i, std::size_t j) {
                 const Value* at = p + i * columns + j;
                 return at[columns + 1] - at[columns] - at[1] + at[0];
               });
  }
  if (columns > 2) {
    found.vv = n * (n - 1) * largest_of(rows, columns - 2, [&](std::size_t i, std::size_t j) {
                 const Value* at = p + i * columns + j;
                 return at[2] - 2.0 * at[1] + at[0];
               });
  }
}

template <class Value>
void add_first_differences(const Value* p, std::size_t rows, std::size_t columns, Differences& found) {
  const auto m = static_cast<double>(rows - 1);
  const auto n = static_cast<double>(columns - 1);
  if (rows > 1) found.u = m * largest_of((rows - 1) * columns, [&](std::size_t k) { return p[k + columns] - p[k]; });
  if (columns > 1) {
    found.v = n * largest_of(rows, columns - 1, [&](std::size_t i, std::size_t j) {
                const Value* at = p + i * columns + j;
                return at[1] - at[0];
              });
  }
}

/// The derivatives of a point by both parameters, times its weight.
struct Slopes {
  glm::dvec3 u;
  glm::dvec3 v;
};

Slopes slopes_of(const glm::dvec4& h, const glm::dvec4& hu, const glm::dvec4& hv) {
  if (hu.w == 0.0 && hv.w == 0.0) return {glm::dvec3(hu), glm::dvec3(hv)};
  return {glm::dvec3(hu) - hu.w / h.w * glm::dvec3(h), glm::dvec3(hv) - hv.w / h.w * glm::dvec3(h)};
}

/// Their unit normal, or (0, 0, 0) where one of them is no more than rounding.
glm::dvec3 unit_normal(const Slopes& slopes, double magnitude) {
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
    glm::dvec4 row(0.0);
    for (std::size_t j = 0; j < net.columns; ++j) row += along_v[j] * net.at(i, j);
    sum += along_u[i] * row;
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
/// What bounds are at most where all weights are above 0: four of them have a sum.
constexpr double kLargestBound = 1e300;

}  // namespace

BernsteinRow::BernsteinRow(int degree, double t) : values(degree + 1), slopes(degree + 1, 0.0) {
  bernstein(degree, t, 1.0 - t, values);
  std::vector<double> lower(degree);
  bernstein(degree - 1, t, 1.0 - t, lower);
  for (int i = 0; i < degree; ++i) {
    slopes[i] -= degree * lower[i];
    slopes[i + 1] += degree * lower[i];
  }
}

FlatnessProbe::FlatnessProbe(int degree_u, int degree_v, bool rational)
    : rational_(rational), u_(rows_of(degree_u, 0.0)), v_(rows_of(degree_v, 0.0)), inner_u_(rows_of(degree_u, kInside)),
      inner_v_(rows_of(degree_v, kInside)), row_values_(3 * (degree_u + 1)), row_slopes_(3 * (degree_u + 1)) {}

void FlatnessProbe::take(const BernsteinNet<glm::dvec4>& piece) {
  piece_ = &piece;
  has_values_ = has_points_ = has_normals_ = has_pairs_ = false;
  middle_slopes_ = {};
}

void FlatnessProbe::centre(const glm::dvec4* points, std::size_t count, std::size_t middle, Centred& seen) const {
  seen.points.resize(count);
  const glm::dvec3 origin = project(points[middle]);
  if (!rational_) {
    for (std::size_t k = 0; k < count; ++k) seen.points[k] = glm::dvec3(points[k]) - origin;
    return;
  }
  seen.weights.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    seen.points[k] = glm::dvec3(points[k]) - points[k].w * origin;
    seen.weights[k] = points[k].w;
  }
  seen.least = std::ranges::min(seen.weights);
}

/// Bounds for coordinates, or for heights, with the weights of a piece.
template <class Value>
SecondDerivativeBounds FlatnessProbe::bounds_of(const Value* values, const Centred& seen, std::size_t rows,
                                                std::size_t columns) {
  Differences point;
  add_second_differences(values, rows, columns, point);
  if (!rational_) return {point.uu, point.uv, point.vv};
  const double least = seen.least;
  Differences weight;
  add_first_differences(values, rows, columns, point);
  add_first_differences(seen.weights.data(), rows, columns, weight);
  add_second_differences(seen.weights.data(), rows, columns, weight);
  double reach = 0.0;
  for (std::size_t k = 0; k < rows * columns; ++k) {
    reach = std::max(reach, size_of(values[k] / seen.weights[k]));
  }
  reach = std::sqrt(reach);
  // The quotient rule, term by term: S_uu = (A_uu - 2 W_u S_u - W_uu S) / W.
  const double su = (point.u + weight.u * reach) / least;
  const double sv = (point.v + weight.v * reach) / least;
  const auto finite = [](double bound) { return std::min(bound, kLargestBound); };
  return {finite((point.uu + 2.0 * weight.u * su + weight.uu * reach) / least),
          finite((point.uv + weight.u * sv + weight.v * su + weight.uv * reach) / least),
          finite((point.vv + 2.0 * weight.v * sv + weight.vv * reach) / least)};
}

SecondDerivativeBounds FlatnessProbe::bounds() {
  const std::size_t middle = piece_->rows / 2 * piece_->columns + piece_->columns / 2;
  centre(piece_->values.data(), piece_->values.size(), middle, seen_);
  if (!(seen_.least > 0.0)) return {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  return bounds_of(seen_.points.data(), seen_, piece_->rows, piece_->columns);
}

SecondDerivativeBounds FlatnessProbe::bounds_along(const glm::dvec3& normal) {
  heights_.resize(seen_.points.size());
  for (std::size_t k = 0; k < heights_.size(); ++k) heights_[k] = glm::dot(normal, seen_.points[k]);
  return bounds_of(heights_.data(), seen_, piece_->rows, piece_->columns);
}

double FlatnessProbe::side_distance(int side) {
  const std::size_t count = side < 2 ? piece_->columns : piece_->rows;
  const std::size_t at = side % 2 == 0 ? 0 : (side < 2 ? piece_->rows : piece_->columns) - 1;
  side_points_.resize(count);
  for (std::size_t k = 0; k < count; ++k) side_points_[k] = side < 2 ? piece_->at(at, k) : piece_->at(k, at);
  centre(side_points_.data(), count, count / 2, side_);
  return bounds_of(side_.points.data(), side_, side < 2 ? 1 : count, side < 2 ? count : 1).distance();
}

/// The homogeneous points at the nine places.
void FlatnessProbe::blend_values() {
  if (has_values_) return;
  has_values_ = true;
  const std::size_t rows = piece_->rows;
  const std::size_t columns = piece_->columns;
  const double* const middle = v_[1].values.data();
  const double* const middle_u = u_[1].values.data();
  glm::dvec4 first(0.0);
  glm::dvec4 half(0.0);
  glm::dvec4 last(0.0);
  for (std::size_t i = 0; i < rows; ++i) {
    const glm::dvec4* row = piece_->values.data() + i * columns;
    glm::dvec4 sum(0.0);
    for (std::size_t j = 0; j < columns; ++j) sum += middle[j] * row[j];
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
void FlatnessProbe::blend_slopes() {
  const std::size_t columns = piece_->columns;
  const double degree = piece_->degree(Axis::v);
  const double* const middle = v_[1].slopes.data();
  for (std::size_t i = 0; i < piece_->rows; ++i) {
    const glm::dvec4* row = piece_->values.data() + i * columns;
    glm::dvec4 sum(0.0);
    for (std::size_t j = 0; j < columns; ++j) sum += middle[j] * row[j];
    row_slopes_[3 * i] = degree * row[1] - degree * row[0];
    row_slopes_[3 * i + 1] = sum;
    row_slopes_[3 * i + 2] = degree * row[columns - 1] - degree * row[columns - 2];
  }
}

const std::array<glm::dvec3, 9>& FlatnessProbe::points() {
  if (has_points_) return points_;
  has_points_ = true;
  blend_values();
  for (std::size_t k = 0; k < 9; ++k) points_[k] = rational_ ? project(values_[k]) : glm::dvec3(values_[k]);
  return points_;
}

/// The normal a little inside, for places where it vanishes, as at a pole.
glm::dvec3 FlatnessProbe::normal_near(int place, double magnitude) const {
  const BernsteinRow& u = inner_u_[place / 3];
  const BernsteinRow& v = inner_v_[place % 3];
  return unit_normal(blended(*piece_, u.values, v.values), blended(*piece_, u.slopes, v.values),
                     blended(*piece_, u.values, v.slopes), magnitude);
}

glm::dvec3 FlatnessProbe::middle_normal() {
  if (has_normals_) return normals_[4];
  blend_values();
  glm::dvec4 slope_u(0.0);
  glm::dvec4 slope_v(0.0);
  for (std::size_t i = 0; i < piece_->rows; ++i) {
    const glm::dvec4* row = piece_->values.data() + i * piece_->columns;
    glm::dvec4 sum(0.0);
    for (std::size_t j = 0; j < piece_->columns; ++j) sum += v_[1].slopes[j] * row[j];
    slope_u += u_[1].slopes[i] * row_values_[3 * i + 1];
    slope_v += u_[1].values[i] * sum;
  }
  const double magnitude = magnitude_of(*piece_);
  const Slopes slopes = slopes_of(values_[4], slope_u, slope_v);
  const glm::dvec3 normal = unit_normal(slopes, magnitude);
  if (normal == glm::dvec3(0.0)) return normal_near(4, magnitude);
  middle_slopes_ = {slopes.u / values_[4].w, slopes.v / values_[4].w};
  return normal;
}

double FlatnessProbe::sine_bound(const SecondDerivativeBounds& bounds) const {
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

const std::array<glm::dvec3, 9>& FlatnessProbe::normals() {
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

const FlatnessProbe::Pairs& FlatnessProbe::farthest_normals() {
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

NormalAngles FlatnessProbe::normal_angles() {
  const Pairs& pairs = farthest_normals();
  const auto angle = [&](const Pair& pair) {
    return pair.chord > 0.0 ? angle_between(normals_[pair.a], normals_[pair.b]) : 0.0;
  };
  return {angle(pairs.u), angle(pairs.v), angle(pairs.all)};
}

double FlatnessProbe::largest_sine() {
  const Pair& pair = farthest_normals().all;
  if (!(pair.chord > 0.0)) return 0.0;
  const glm::dvec3& a = normals_[pair.a];
  const glm::dvec3& b = normals_[pair.b];
  return glm::dot(a, b) > 0.0 ? glm::length(glm::cross(a, b)) : 1.0;
}

std::pair<double, double> FlatnessProbe::lengths(Axis axis) {
  const std::array<glm::dvec3, 9>& all = points();
  const auto along = [&](int line) {
    const glm::dvec3& middle = all[place_on(axis, line, 1)];
    return glm::length(middle - all[place_on(axis, line, 0)]) + glm::length(all[place_on(axis, line, 2)] - middle);
  };
  return std::minmax({along(0), along(2)});
}

double FlatnessProbe::sagitta(Axis axis) {
  const std::array<glm::dvec3, 9>& all = points();
  double found = 0.0;
  for (int line = 0; line < 3; ++line) {
    const auto at = [&](int k) { return all[place_on(axis, line, k)]; };
    found = std::max(found, size_of(at(1) - 0.5 * (at(0) + at(2))));
  }
  return std::sqrt(found);
}

}  // namespace splinecore
