#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "splinecore/surface/loft.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A side of a hole at a place, by s from 0 to 1 along it; and the patch beyond it, by t out of that.
struct HolePlace {
  glm::dvec3 point;
  glm::dvec3 along;      ///< derivatives by s
  glm::dvec3 along_2;
  glm::dvec3 out;        ///< by t; 0 without a neighbor, as those that follow
  glm::dvec3 out_along;  ///< by s and t
  glm::dvec3 out_2;      ///< by t twice
};

/// Derivatives by s, of orders 0 to 2, of those across a side.
struct AcrossJet {
  std::array<glm::dvec3, 3> first;   ///< of D
  std::array<glm::dvec3, 3> second;  ///< of D2
};

/// A side of a hole, or a piece of one that goes on into the next, along one curve or one patch; and how what fills the hole
/// leaves from there: derivatives across, into the hole, are
///   D = a N + b T,   D2 = a² N_t + 2 a b N_s + b² T_s + c N + d T
/// with N and T the neighbor's derivatives out of it and along it: as far as a, b, c, d are functions of s, tangent planes
/// and curvatures are the neighbor's (Farin 2002, 22; row S21).
class SidePiece {
 public:
  /// @param curve   clamped, from the corner where it begins; over any domain
  /// @param number  of the side that was given
  SidePiece(const NurbsCurve& curve, const std::optional<LoftNeighbor>& neighbor, std::size_t number);

  /// As sentences name it.
  std::string name() const;

  /// 0 without a neighbor
  int continuity() const noexcept { return neighbor_ ? neighbor_->continuity : 0; }

  /// Of two pieces along parts of one patch the piece along both; none if their neighbors are not as parts of one.
  static std::optional<SidePiece> of_one_patch(const SidePiece& first, const SidePiece& second);

  /// The side with its ends in the corners.
  NurbsCurve curve() const;

  std::vector<HolePlace> places(std::span<const double> s) const;
  std::vector<glm::dvec3> points(std::span<const double> s) const;
  HolePlace place(double s) const { return places(std::span(&s, 1)).front(); }

  /// Sets D and D2 at an end as nearly as the neighbor's plane allows, and lets a, b, c, d be linear.
  /// @throws InvalidShape where the neighbor has no plane there
  void set_end(bool is_end, const glm::dvec3& across, const glm::dvec3& across_2);

  /// c and d at an end.
  std::array<double, 2> second_parts(bool is_end) const { return {c_.values[is_end], d_.values[is_end]}; }

  /// Adds to D, or to D2, what brings it as near as may be to vectors at places, in the neighbor's plane, and what changes
  /// nothing at the ends of either, nor of as many derivatives as the power, less one. D goes on into the hole nowhere slower
  /// than by a part of what it did.
  void bulge_towards(std::span<const double> s, std::span<const glm::dvec3> wanted, int order, int power);

  /// Bends a and b as much less as lets it nowhere leave back over the neighbor. @returns what is left; 0 where it does at an end
  double bend_onward();

  /// Whether D goes on into the hole at an end.
  bool leaves_onward(bool is_end) const { return a_.values[is_end] > 0.0; }

  AcrossJet jet(bool is_end) const;

  /// N and T at an end.
  std::array<glm::dvec3, 2> directions(bool is_end) const;

  /// Adds to the first derivatives of a and b at an end, and so N and T times as much to D'.
  void bend_first(bool is_end, double a, double b);

  /// Adds to derivatives of order 1 or 2 of c and d, and so N and T times as much to those of D2.
  void bend_second(bool is_end, int order, double c, double d);

  /// The part of the neighbor along a part of the side, which is v_end of it; none without one.
  std::optional<NurbsPatch> neighbor_part(double from, double to) const;

  /// D or D2 at places.
  std::vector<glm::dvec3> across(std::span<const double> s, int order) const;

 private:
  /// A function of s: a line by its values at both ends, and what is added to its derivatives there: to the first ones by cubics;
  /// and a bulge between these.
  struct Factor {
    std::array<double, 2> values{};
    std::array<double, 2> slopes{};   ///< added
    std::array<double, 2> seconds{};
    std::array<double, 5> bulges{};   ///< factors of the bulge, times powers of 2 s - 1
    int power = 2;                    ///< of the bulge

    double at(double s) const;
    std::array<double, 3> derivatives(bool is_end) const;
  };

  NurbsCurve curve_;                        ///< with a neighbor its side
  std::optional<LoftNeighbor> neighbor_;  ///< along its side over [0, 1], as the curve runs
  std::size_t number_;
  std::array<glm::dvec3, 2> moved_{};       ///< the curve's ends by what they lie off those of the neighbor's side
  Factor a_, b_, c_, d_;
};

}  // namespace splinecore
#pragma GCC visibility pop
