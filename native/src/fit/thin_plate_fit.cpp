#include "thin_plate_fit.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <string>
#include <utility>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "straight.hpp"

namespace splinecore {

namespace {

Samples samples_of(const KnotVector& knots, std::span<const glm::dvec2> parameters, int axis) {
  std::vector<double> along;
  along.reserve(parameters.size());
  for (const glm::dvec2& place : parameters) along.push_back(place[axis]);
  return Samples::make(knots, along, 0, Side::right, axis == 0 ? "u" : "v");
}

/// How long a row of the system is. @throws InvalidShape where all rows are a gigabyte or more.
std::size_t width_of(const KnotVector& u, const KnotVector& v, bool is_turned) {
  constexpr double kMost = 0x1p27;
  const auto along = static_cast<std::size_t>(v.count());
  const std::size_t width = static_cast<std::size_t>(u.degree()) * along + static_cast<std::size_t>(v.degree()) + 1;
  if (static_cast<double>(u.count()) * static_cast<double>(v.count()) * static_cast<double>(width) <= kMost) return width;
  const auto counts = is_turned ? std::pair(v.count(), u.count()) : std::pair(u.count(), v.count());
  throw InvalidShape("a net of " + std::to_string(counts.first) + " x " + std::to_string(counts.second) +
                     " control points is too large for scattered points: fewer are needed, or a lower degree");
}

/// The weighted sums of products of functions at the parameters, added to rows.
std::vector<double> with_products(std::vector<double> rows, std::size_t count, std::size_t width, std::size_t count_v,
                                  const Samples& u, const Samples& v, std::span<const double> weights) {
  rows.resize(count * width, 0.0);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const auto of_u = u.weights(i);
    const auto of_v = v.weights(i);
    breathe(2 * of_u.size() * of_u.size() * of_v.size() * of_v.size());
    const std::size_t first = static_cast<std::size_t>(u.first(i)) * count_v + static_cast<std::size_t>(v.first(i));
    for (std::size_t a = 0; a < of_u.size(); ++a) {
      for (std::size_t b = 0; b < of_v.size(); ++b) {
        const double factor = (weights.empty() ? 1.0 : weights[i]) * of_u[a] * of_v[b];
        double* const row = &rows[(first + a * count_v + b) * width];
        for (std::size_t l = b; l < of_v.size(); ++l) row[l - b] += factor * of_u[a] * of_v[l];
        for (std::size_t k = a + 1; k < of_u.size(); ++k) {
          double* const to = row + (k - a) * count_v - b;
          const double product = factor * of_u[k];
          for (std::size_t l = 0; l < of_v.size(); ++l) to[l] += product * of_v[l];
        }
      }
    }
  }
  return rows;
}

double largest_of(std::span<const glm::dvec3> vectors) {
  double largest = 0.0;
  for (const glm::dvec3& v : vectors) largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest;
}

InvalidShape hidden_by_energy() {
  return InvalidShape("the points do not determine the shape beside the energy of its shortest spans: less smoothing, "
                      "fewer control points or knots farther from each other, or points whose parameters lie in more than "
                      "one line are needed");
}

}  // namespace

ThinPlateFit::Plate ThinPlateFit::plate_of(const KnotVector& u, const KnotVector& v, double energy) {
  const double length_u = u.domain().length();
  const double length_v = v.domain().length();
  return {PlateDirection({u, length_u, {}}, false), PlateDirection({v, length_v, {}}, false),
          energy * length_u * length_v};
}

/// The energy's matrix on the net: products of both directions' means. None where it has no weight.
std::vector<double> ThinPlateFit::energy_rows() const {
  if (!plate_) return {};
  const auto& [u, v, factor] = *plate_;
  const std::size_t p = u.bands[0].degree;
  const std::size_t q = v.bands[0].degree;
  std::vector<double> rows(count_u_ * count_v_ * width_, 0.0);
  for (std::size_t k = 0; k <= 2; ++k) {
    const double share = factor * (k == 1 ? 2.0 : 1.0);
    for (std::size_t i = 0; i < count_u_; ++i) {
      for (std::size_t j = 0; j < count_v_; ++j) {
        double* const row = &rows[(i * count_v_ + j) * width_];
        breathe(8 * (p + 1) * (q + 1));
        for (std::size_t a = i; a < std::min(count_u_, i + p + 1); ++a) {
          const double of_u = share * u.bands[k].at(i, p + a - i);
          const std::size_t first = a == i ? j : j > q ? j - q : 0;
          for (std::size_t b = first; b < std::min(count_v_, j + q + 1); ++b) {
            row[(a - i) * count_v_ + b - j] += of_u * v.bands[2 - k].at(j, q + b - j);
          }
        }
      }
    }
  }
  return rows;
}

ThinPlateFit::ThinPlateFit(const KnotVector& u, const KnotVector& v, std::span<const glm::dvec2> parameters,
                           std::span<const double> weights, double energy, bool is_turned)
    : count_u_(static_cast<std::size_t>(u.count())), count_v_(static_cast<std::size_t>(v.count())),
      is_turned_(is_turned), width_(width_of(u, v, is_turned)),
      u_(samples_of(u, parameters, 0)), v_(samples_of(v, parameters, 1)), weights_(weights),
      plate_(energy > 0.0 ? std::optional<Plate>(plate_of(u, v, energy)) : std::nullopt),
      system_(with_products(energy_rows(), count_u_ * count_v_, width_, count_v_, u_, v_, weights_), width_) {
  const auto dependent = system_.dependent_row();
  if (plate_) {
    if (dependent) throw hidden_by_energy();
    require_energy_leaves_points(u, v);
  }
  if (dependent) throw undetermined(*dependent);
}

std::string ThinPlateFit::name_of(std::size_t control) const {
  const std::size_t i = control / count_v_;
  const std::size_t j = control % count_v_;
  return "control point (" + std::to_string(is_turned_ ? j : i) + ", " + std::to_string(is_turned_ ? i : j) + ")";
}

InvalidShape ThinPlateFit::undetermined(std::size_t control) const {
  return InvalidShape("the points do not determine " + name_of(control) +
                      ": fewer control points or smoothing are needed");
}

/// Beside a control point a million times as far away as the points are from each other, rounding takes 1e-10 of the
/// shape, and points decide so little about it that the sum of squares is not the least any more.
void ThinPlateFit::require_near(std::span<const glm::dvec3> net) const {
  constexpr double kFarthest = 0x1p20;
  const auto size_of = [](const glm::dvec3& point) {
    return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  };
  const auto farthest = std::ranges::max_element(net, {}, size_of);
  if (size_of(*farthest) <= kFarthest) return;
  throw InvalidShape("the points hardly determine " + name_of(static_cast<std::size_t>(farthest - net.begin())) +
                     ", which would lie more than a million times as far away as they do: fewer control points or " +
                     (plate_ ? "more " : "") + "smoothing are needed");
}

glm::dvec3 ThinPlateFit::at(std::size_t i, std::span<const glm::dvec3> net) const {
  glm::dvec3 sum(0.0);
  for (std::size_t a = 0; a < u_.weights(i).size(); ++a) {
    const glm::dvec3* const row =
        &net[(static_cast<std::size_t>(u_.first(i)) + a) * count_v_ + static_cast<std::size_t>(v_.first(i))];
    glm::dvec3 along_v(0.0);
    for (std::size_t b = 0; b < v_.weights(i).size(); ++b) along_v += v_.weights(i)[b] * row[b];
    sum += u_.weights(i)[a] * along_v;
  }
  return sum;
}

/// Half the gradient, downhill.
void ThinPlateFit::add_residuals(std::span<const glm::dvec3> points, std::span<const glm::dvec3> net,
                                 std::span<glm::dvec3> right) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    breathe(4 * u_.weights(i).size() * v_.weights(i).size());
    const glm::dvec3 left = weight(i) * (points[i] - at(i, net));
    for (std::size_t a = 0; a < u_.weights(i).size(); ++a) {
      glm::dvec3* const row =
          &right[(static_cast<std::size_t>(u_.first(i)) + a) * count_v_ + static_cast<std::size_t>(v_.first(i))];
      for (std::size_t b = 0; b < v_.weights(i).size(); ++b) row[b] += u_.weights(i)[a] * v_.weights(i)[b] * left;
    }
  }
  if (!plate_) return;
  const std::vector<glm::dvec3> bent = plate_bending(plate_->u, plate_->v, net);
  for (std::size_t i = 0; i < net.size(); ++i) right[i] -= plate_->factor * bent[i];
}

/// What bends nowhere is to come out of the system as it went in.
/// @throws InvalidShape if it does not.
void ThinPlateFit::require_energy_leaves_points(const KnotVector& u, const KnotVector& v) const {
  std::vector<glm::dvec3> flat;
  flat.reserve(count_u_ * count_v_);
  const std::vector<double> along_v = straight_controls(v);
  for (const double at_u : straight_controls(u)) {
    for (const double at_v : along_v) flat.emplace_back(1.0, at_u, at_v);
  }
  const std::vector<glm::dvec3> nothing(u_.size(), glm::dvec3(0.0));
  std::vector<glm::dvec3> found(flat.size(), glm::dvec3(0.0));
  add_residuals(nothing, flat, found);
  system_.solve({&found.front().x, 3 * found.size()}, 3);
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const glm::dvec3 lost = flat[i] + found[i];
    if (glm::all(glm::lessThanEqual(glm::abs(lost), glm::dvec3(kMostLost)))) continue;
    throw hidden_by_energy();
  }
}

std::vector<glm::dvec3> ThinPlateFit::net(std::span<const glm::dvec3> points) const {
  constexpr int kMostRounds = 12;
  constexpr double kDone = 1e-12;
  std::vector<glm::dvec3> net(count_u_ * count_v_, glm::dvec3(0.0));
  std::vector<glm::dvec3> right(net.size());
  for (int round = 0; round < kMostRounds; ++round) {
    std::ranges::fill(right, glm::dvec3(0.0));
    add_residuals(points, net, right);
    system_.solve({&right.front().x, 3 * right.size()}, 3);
    for (std::size_t i = 0; i < net.size(); ++i) net[i] += right[i];
    if (round > 0 && largest_of(right) <= kDone * largest_of(net)) break;
  }
  require_near(net);
  return net;
}

}  // namespace splinecore
