#pragma once

#include <glm/vec4.hpp>
#include <memory_resource>
#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

namespace splinecore {

/// Where one parameter falls and with which weights: derivative k of the curve there is the sum
/// of weights(k)[j] times control point first + j (unrolled, homogeneous).
///
/// The memory is kept from one parameter to the next, so a loop allocates once.
class Stencil {
 public:
  /// @param order  highest derivative wanted
  /// @param memory  where weights are kept
  Stencil(const KnotVector& knots, int order,
          std::pmr::memory_resource* memory = std::pmr::get_default_resource());

  /// Moves to a parameter that KnotVector::admit() let through.
  void move_to(double u, Side side);

  int first() const noexcept { return first_; }
  std::span<const double> weights(int order) const noexcept {
    return {weights_.data() + order * width_, size_};
  }

  /// The weights of all orders; those of each are followed by zeros up to a multiple of four numbers.
  std::span<const double> all_weights() const noexcept { return weights_; }

 private:
  KnotVector knots_;
  int order_;
  std::size_t size_;
  std::size_t width_;
  int first_ = 0;
  std::pmr::vector<double> weights_;
};

/// Where a batch of parameters falls, and with which weights.
///
/// Computed once, applied to any control points on the same knots: a grid, a patch whose
/// points move, colors beside positions.
class Samples {
 public:
  /// @param sides  one for all parameters, or one for each
  /// @param memory  where they are kept
  /// @throws InvalidShape if a parameter is outside the domain; where periodic they are taken modulo the period.
  static Samples make(const KnotVector& knots, std::span<const double> parameters, int order,
                      std::span<const Side> sides, const char* name = "u",
                      std::pmr::memory_resource* memory = std::pmr::get_default_resource());
  static Samples make(const KnotVector& knots, std::span<const double> parameters, int order = 0,
                      Side side = Side::right, const char* name = "u",
                      std::pmr::memory_resource* memory = std::pmr::get_default_resource()) {
    return make(knots, parameters, order, std::span(&side, 1), name, memory);
  }

  Samples() = default;

  std::size_t size() const noexcept { return places_.size(); }
  int order() const noexcept { return order_; }

  /// Parameter i, moved into the domain, and its side.
  double parameter(std::size_t i) const noexcept { return places_[i].parameter; }
  Side side(std::size_t i) const noexcept { return places_[i].side; }

  /// Index of the first of the degree + 1 control points (unrolled) that sample i depends on.
  int first(std::size_t i) const noexcept { return places_[i].first; }

  /// Their weights in derivative k at sample i.
  std::span<const double> weights(std::size_t i, int k = 0) const noexcept {
    return {weights_.data() + (i * (order_ + 1) + k) * width_, size_of_weights_};
  }

 private:
  explicit Samples(std::pmr::memory_resource* memory) : places_(memory), weights_(memory) {}

  struct Place {
    double parameter;
    Side side;
    int first;
  };
  std::size_t size_of_weights_ = 0;
  std::size_t width_ = 0;  ///< filled up to a multiple of four numbers
  int order_ = 0;
  std::pmr::vector<Place> places_;
  std::pmr::vector<double> weights_;
};

/// The sum of weights times points[first + j].
inline glm::dvec4 weighted_sum(std::span<const double> weights, const glm::dvec4* points) noexcept {
  glm::dvec4 sum = weights[0] * points[0];
  for (std::size_t j = 1; j < weights.size(); ++j) sum += weights[j] * points[j];
  return sum;
}

}  // namespace splinecore
