#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "patch_part.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

using RangesOfTwo = std::array<Interval, 2>;

/// Two polynomial parts of patches by the same parameters: a place of the first one, and the place of the second one that is
/// about right across from it. Which these are need not be exact, nor unique.
class MatchedNets {
 public:
  /// @returns none where weights differ, where lines of one are not along lines of the other, or where no places are across
  static std::optional<MatchedNets> of(const PatchPart& a, const PatchPart& b);

  /// All of the second part, by the parameters of the first one, which is [0, 1]² of them.
  RangesOfTwo range_of_b() const;

  /// What a box of these parameters is of both pieces.
  RangesOfTwo of_a(const RangesOfTwo& box) const;
  RangesOfTwo of_b(const RangesOfTwo& box) const;

  /// Both over a box, beyond their ends, too, and of the same degrees.
  struct Nets {
    BernsteinNet<glm::dvec3> a;
    BernsteinNet<glm::dvec3> gap;  ///< what the second one is from there
    double rounding;               ///< what of that may be rounding
  };
  Nets over(const RangesOfTwo& box) const;

  /// Which way the own parameter of the second part goes where that of the first one rises, and whether both are exchanged.
  std::array<int, 2> ways() const;
  bool is_exchanged() const noexcept { return is_exchanged_; }

 private:
  /// A parameter of the second part where that of the first one is 0 and 1.
  struct Ends {
    double start;
    double end;

    double at(double t) const noexcept { return start + t * (end - start); }
    double inverse(double x) const noexcept { return (x - start) / (end - start); }
  };

  MatchedNets(const PatchPart& a, const PatchPart& b, BernsteinNet<glm::dvec3> net_a, BernsteinNet<glm::dvec3> net_b,
              bool is_exchanged, const std::array<Ends, 2>& ends);

  RangesOfTwo range_a_;
  RangesOfTwo range_b_;
  BernsteinNet<glm::dvec3> a_;
  BernsteinNet<glm::dvec3> b_;  ///< its parameters exchanged, if they are
  bool is_exchanged_;
  std::array<Ends, 2> ends_;  ///< of parameters of b_
};

/// The control points of a scalar or a cross product of polynomials.
BernsteinNet<glm::dvec3> cross_product(const BernsteinNet<glm::dvec3>& a, const BernsteinNet<glm::dvec3>& b);
BernsteinNet<double> scalar_product(const BernsteinNet<glm::dvec3>& a, const BernsteinNet<glm::dvec3>& b);

}  // namespace splinecore
#pragma GCC visibility pop
