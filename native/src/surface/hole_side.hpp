#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "side_piece.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Parts of a side between which there is no more than this are one place.
inline constexpr double kSamePlace = 1e-7;

/// A piece of a side and where along the side it lies.
struct PlacedPiece {
  SidePiece piece;
  double from;
  double to;

  double length() const { return to - from; }
};

/// Of the first and the last of those given that make a side.
struct SideNumbers {
  std::size_t first;
  std::size_t last;
};

/// One side of a hole, from corner to corner: of several pieces where these go on into each other, each with its neighbor.
/// Parameters s run from 0 to 1 along all of it, at one speed where pieces meet. See SidePiece.
class HoleSide {
 public:
  /// @param pieces  one after the other; all of several have neighbors
  HoleSide(std::vector<SidePiece> pieces, SideNumbers numbers);

  SideNumbers numbers() const noexcept { return numbers_; }

  /// The highest one of a piece.
  int continuity() const;

  /// Those along it.
  const KnotVector& knots() const noexcept { return curve_.knot_vector(); }

  /// The lowest degree of homogeneous points along it whose weights are 1 at both ends.
  int least_degree() const;

  const NurbsCurve& curve() const noexcept { return curve_; }

  /// Where pieces meet.
  std::vector<double> joints() const;

  std::vector<HolePlace> places(std::span<const double> s) const;
  std::vector<glm::dvec3> points(std::span<const double> s) const;
  HolePlace place(double s) const { return places(std::span(&s, 1)).front(); }

  void set_end(bool is_end, const glm::dvec3& across, const glm::dvec3& across_2);

  /// Lets pieces leave alike where they meet: along the line between their neighbors, as nearly as these have one. For sides
  /// whose ends are set.
  /// @param lengths  of what leaves joints; none: between those at the ends
  void agree_at_joints(std::span<const double> lengths);

  /// What leaves at places, given those.
  using Wanted = std::function<std::vector<glm::dvec3>(std::span<const double>)>;

  /// Lets each piece with a neighbor bulge towards that between its ends: see SidePiece.
  void bulge_towards(const Wanted& wanted, int order, int power);

  /// Bends as much less as lets it nowhere leave back over a neighbor.
  /// @param least  what is to be left
  /// @throws InvalidShape where less would be, or it does so at an end
  void bend_onward(double least = 0.0);

  AcrossJet jet(bool is_end) const;

  /// N and T by s, over the length of the piece: what bends takes effect along that.
  std::array<glm::dvec3, 2> directions(bool is_end) const;

  /// Adds directions() times as much to D' at an end, or to derivatives of order 1 or 2 of D2.
  void bend_first(bool is_end, double a, double b);
  void bend_second(bool is_end, int order, double c, double d);


  /// Of the one piece that a part of the side lies on: its continuity, and the part of its neighbor.
  int continuity_between(double from, double to) const { return piece_between(from, to).piece.continuity(); }
  std::optional<NurbsPatch> neighbor_part(double from, double to) const;

  std::vector<glm::dvec3> across(std::span<const double> s, int order) const;

 private:
  const PlacedPiece& piece_between(double from, double to) const;
  const PlacedPiece& piece_at(bool is_end) const { return is_end ? pieces_.back() : pieces_.front(); }
  PlacedPiece& piece_at(bool is_end) { return is_end ? pieces_.back() : pieces_.front(); }

  /// What each piece gives for its places among these.
  template <class Value, class Given>
  std::vector<Value> gathered(std::span<const double> s, const Given& given) const;

  std::vector<PlacedPiece> pieces_;
  SideNumbers numbers_;
  NurbsCurve curve_;
};

}  // namespace splinecore
#pragma GCC visibility pop
