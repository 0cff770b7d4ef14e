#include "part_heights.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "slopes.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

constexpr double kMargin = 1.25;

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// The polynomial with the part's derivatives, up to the second ones, in its middle.
std::optional<QuadraticHeights> heights_in_middle(const PatchPart& part, const HeightFrame& frame) {
  const BernsteinNet<glm::dvec4>& net = part.net;
  const Slopes<2> s = slopes_of<2>(kernels(), net.values.data(), net.rows, net.columns, {0.5, 0.5}, frame.origin);
  const glm::dvec3& up = frame.axes[2];
  const glm::dvec2 a = frame.flat(s.first[0]);
  const glm::dvec2 b = frame.flat(s.first[1]);
  const double area = cross(a, b);
  if (!(std::abs(area) > 0.0)) return {};
  const glm::dvec2 by_x(b.y / area, -a.y / area);  // how the parameters change
  const glm::dvec2 by_y(-b.x / area, a.x / area);
  const glm::dvec2 rise(glm::dot(s.first[0], up), glm::dot(s.first[1], up));
  QuadraticHeights found{frame.flat(s.offset), glm::dot(s.offset, up), {glm::dot(rise, by_x), glm::dot(rise, by_y)}, {}};
  const auto bent = [&](const glm::dvec3& second) {
    return glm::dot(second, up) - glm::dot(found.slope, frame.flat(second));
  };
  const std::array<double, 3> own{bent(s.second[0]), bent(s.second[2]), bent(s.second[1])};
  const auto along = [&](const glm::dvec2& p, const glm::dvec2& q) {
    return own[0] * p.x * q.x + own[1] * (p.x * q.y + p.y * q.x) + own[2] * p.y * q.y;
  };
  found.bend = {along(by_x, by_x), along(by_x, by_y), along(by_y, by_y)};
  return found;
}

/// Products of two nets of one degree, by their control points times their binomials.
class Remainder {
 public:
  Remainder(const PatchPart& part, const HeightFrame& frame, const QuadraticHeights& nearly)
      : rows_(part.net.rows), columns_(part.net.columns), width_(2 * columns_ - 1), values_((2 * rows_ - 1) * width_, 0.0) {
    const double sign = part.net.values.front().w < 0.0 ? -1.0 : 1.0;
    const glm::dvec3 middle = frame.origin + nearly.at.x * frame.axes[0] + nearly.at.y * frame.axes[1] +
                              nearly.height * frame.axes[2];
    const int p = static_cast<int>(rows_) - 1;
    const int q = static_cast<int>(columns_) - 1;
    for (int i = 0; i <= p; ++i) {
      for (int j = 0; j <= q; ++j) {
        const glm::dvec4 h = sign * part.net.values[static_cast<std::size_t>(i) * columns_ + static_cast<std::size_t>(j)];
        const glm::dvec3 from = glm::dvec3(h) - h.w * middle;
        const glm::dvec2 flat = frame.flat(from);
        const double choices = binomial(p, i) * binomial(q, j);
        const double x = choices * flat.x;
        const double y = choices * flat.y;
        first_.push_back({choices * h.w, x, y});
        second_.push_back({choices * (glm::dot(frame.axes[2], from) - glm::dot(nearly.slope, flat)),
                           -0.5 * (nearly.bend[0] * x + 2.0 * nearly.bend[1] * y), -0.5 * nearly.bend[2] * y});
      }
    }
    multiply();
    for (int i = 0; i <= 2 * p; ++i) {
      for (int j = 0; j <= 2 * q; ++j) {
        values_[static_cast<std::size_t>(i) * width_ + static_cast<std::size_t>(j)] /= binomial(2 * p, i) * binomial(2 * q, j);
      }
    }
  }

  double largest() const {
    double most = 0.0;
    for (const double value : values_) most = std::max(most, std::abs(value));
    return most;
  }

  double largest_slope(Axis axis) const {
    const std::size_t step = axis == Axis::u ? width_ : 1;
    const std::size_t rows = 2 * rows_ - (axis == Axis::u ? 2 : 1);
    const std::size_t columns = width_ - (axis == Axis::v ? 1 : 0);
    double most = 0.0;
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        const std::size_t k = i * width_ + j;
        most = std::max(most, std::abs(values_[k + step] - values_[k]));
      }
    }
    return 2.0 * static_cast<double>((axis == Axis::u ? rows_ : columns_) - 1) * most;
  }

 private:
  void multiply() {
    breathe(8 * first_.size() * first_.size());
    for (std::size_t i = 0; i < rows_; ++i) {
      for (std::size_t j = 0; j < columns_; ++j) {
        const glm::dvec3& one = first_[i * columns_ + j];
        for (std::size_t k = 0; k < rows_; ++k) {
          double* const sums = values_.data() + (i + k) * width_ + j;
          const glm::dvec3* const others = second_.data() + k * columns_;
          for (std::size_t l = 0; l < columns_; ++l) {
            sums[l] += one.x * others[l].x + one.y * others[l].y + one.z * others[l].z;
          }
        }
      }
    }
  }

  std::size_t rows_;
  std::size_t columns_;
  std::size_t width_;
  std::vector<double> values_;
  std::vector<glm::dvec3> first_;
  std::vector<glm::dvec3> second_;
};

/// How long derivatives along an axis are at least, along a direction in the plane; `reach` is how far the part goes from
/// the middle.
double least_tangent(const PatchPart& part, const HeightFrame& frame, Axis axis, const glm::dvec3& along, double reach,
                     double most_weight) {
  const BernsteinNet<glm::dvec4>& net = part.net;
  const std::size_t step = axis == Axis::u ? net.columns : 1;
  const std::size_t rows = net.rows - (axis == Axis::u ? 1 : 0);
  const std::size_t columns = net.columns - (axis == Axis::v ? 1 : 0);
  const double sign = net.values.front().w < 0.0 ? -1.0 : 1.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t k = i * net.columns + j;
      const glm::dvec4 way = sign * (net.values[k + step] - net.values[k]);
      least = std::min(least, glm::dot(along, glm::dvec3(way) - way.w * frame.origin) - reach * std::abs(way.w));
    }
  }
  return static_cast<double>((axis == Axis::u ? net.rows : net.columns) - 1) * least / most_weight;
}

double largest_weight_slope(const BernsteinNet<glm::dvec4>& net, Axis axis) {
  const std::size_t step = axis == Axis::u ? net.columns : 1;
  double most = 0.0;
  for (std::size_t i = 0; i + (axis == Axis::u ? 1 : 0) < net.rows; ++i) {
    for (std::size_t j = 0; j + (axis == Axis::v ? 1 : 0) < net.columns; ++j) {
      const std::size_t k = i * net.columns + j;
      most = std::max(most, std::abs(net.values[k + step].w - net.values[k].w));
    }
  }
  return static_cast<double>((axis == Axis::u ? net.rows : net.columns) - 1) * most;
}

}  // namespace

glm::dvec2 QuadraticHeights::slope_at(const glm::dvec2& place) const noexcept {
  const glm::dvec2 far = place - at;
  return slope + glm::dvec2(bend[0] * far.x + bend[1] * far.y, bend[1] * far.x + bend[2] * far.y);
}

double QuadraticHeights::height_at(const glm::dvec2& place) const noexcept {
  return height + 0.5 * glm::dot(slope + slope_at(place), place - at);
}

FlatCone flat_cone(const HeightFrame& frame, const VectorCone& cone) {
  const glm::dvec2 flat = frame.flat(cone.along);
  const double length = glm::length(flat);
  const double spread = kMargin * cone.spread;
  if (!(spread < 1.0) || !(std::sin(spread) < length)) return {{1.0, 0.0}, std::numbers::pi};
  return {flat / length, std::asin(std::sin(spread) / length)};
}

double least_cross(const FlatCone& a, const FlatCone& b) {
  const double sine = cross(a.along, b.along);
  const double angle = std::atan2(std::abs(sine), std::abs(glm::dot(a.along, b.along)));
  const double least = angle - a.spread - b.spread;
  return least > 0.0 ? std::copysign(std::sin(least), sine) : 0.0;
}

std::optional<PartHeights> nearly_heights(const PatchPart& part, const HeightFrame& frame) {
  PartHeights found;
  found.tangents = {flat_cone(frame, part.tangents(Axis::u)), flat_cone(frame, part.tangents(Axis::v))};
  if (least_cross(found.tangents[0], found.tangents[1]) == 0.0) return {};
  const std::optional<QuadraticHeights> nearly = heights_in_middle(part, frame);
  if (!nearly) return {};
  found.nearly = *nearly;
  found.low = glm::dvec2(std::numeric_limits<double>::infinity());
  found.high = -found.low;
  for (const glm::dvec3& p : part.points) {
    const glm::dvec2 flat = frame.flat(p - frame.origin);
    found.low = glm::min(found.low, flat);
    found.high = glm::max(found.high, flat);
  }
  return found;
}

bool add_bounds(PartHeights& heights, const PatchPart& part, const HeightFrame& frame) {
  const auto [low, high] = part.net.range([](const glm::dvec4& h) { return std::abs(h.w); });
  const Remainder remainder(part, frame, heights.nearly);
  const double most = remainder.largest();
  heights.off = most / (low * low);
  const double sine = std::abs(least_cross(heights.tangents[0], heights.tangents[1]));
  const glm::dvec2 far = glm::max(heights.high, -heights.low);
  for (const Axis axis : {Axis::u, Axis::v}) {
    const glm::dvec2& flat = heights.tangents[axis == Axis::u ? 0 : 1].along;
    const glm::dvec3 along = flat.x * frame.axes[0] + flat.y * frame.axes[1];
    const double length = least_tangent(part, frame, axis, along, glm::length(glm::max(far, glm::dvec2(0.0))), high);
    if (!(length > 0.0)) return false;
    const double by_weight = 2.0 * most * largest_weight_slope(part.net, axis) / (low * low * low);
    heights.steep += (remainder.largest_slope(axis) / (low * low) + by_weight) / (length * sine);
  }
  return true;
}

}  // namespace splinecore
