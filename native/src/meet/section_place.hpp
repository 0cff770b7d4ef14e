#pragma once

#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "patch_approach.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A point of a curve that two patches have in common.
struct SectionPlace {
  PatchSpots at;
  glm::dvec3 point;
  glm::dvec3 tangent;            ///< a unit vector
  std::array<double, 4> slopes;  ///< by how much the parameters go by length

  /// The parameter, of a's and b's u and v, that goes on fastest.
  std::size_t fastest() const noexcept {
    std::size_t found = 0;
    for (std::size_t i = 1; i < 4; ++i) {
      if (std::abs(slopes[i]) > std::abs(slopes[found])) found = i;
    }
    return found;
  }

  /// Whether a parameter goes to a side, or along it.
  bool runs_out(std::size_t i, bool to_end) const noexcept {
    constexpr double kAlong = 1e-3;
    return (to_end ? slopes[i] : -slopes[i]) > -kAlong;
  }

  /// The same place of the curve run through the other way.
  SectionPlace backwards() const noexcept {
    SectionPlace turned = *this;
    turned.tangent = -tangent;
    for (double& slope : turned.slopes) slope = -slope;
    return turned;
  }

  bool has_pieces_of(const SectionPlace& other) const noexcept {
    return at.a.piece == other.at.a.piece && at.b.piece == other.at.b.piece;
  }
};

/// How two surfaces that touch part from each other there: the second derivative of their distance across the way along
/// which it is least, and that along it, which is 0 where they touch along a curve.
struct Parting {
  glm::dvec3 way;  ///< a unit vector
  double along;
  double across;
};

/// @returns none where one has no normal
std::optional<Parting> parting_at(const PatchMeeting& here);

/// Whether they touch along a curve there, rather than in a point.
bool is_curve(const Parting& parting);

/// Surfaces that part by less than so many tolerances on a way 1 long are one within the tolerance over a sixteenth of
/// their size; such that bend away from each other by less than so many, over an eighth.
inline constexpr double kOneSlope = 16.0;
inline constexpr double kOneBend = 128.0;

/// Of larger parts, in a space where the patches are about 1 large, nobody asks whether they touch.
inline constexpr double kLargestOfTouch = 0x1p-4;

/// Places of one such curve: from one to the next it is a cubic of Hermite within the tolerance of both patches. Where it
/// goes from one piece to another, two places are one point.
struct SectionTrace {
  std::vector<SectionPlace> places;
  bool is_closed;
  std::array<bool, 2> is_lost{};  ///< whether at its first and its last place it was lost rather than came to an end
};

/// The cubic between two places of the same pieces, and its images.
struct SectionStep {
  SectionStep(const SectionPlace& from, const SectionPlace& to) noexcept;

  glm::dvec3 point(double s) const noexcept;
  PatchSpots spots(double s) const noexcept;

  /// Whether it comes so near to a point.
  bool is_near(const glm::dvec3& place, double distance) const noexcept;

  /// Whether a place lies between its ends, seen along it and but for a distance, and the curve goes the same way there.
  /// @param cosine  of the largest angle between both ways
  bool passes(const SectionPlace& place, double distance, double cosine) const noexcept;

  const SectionPlace& from;
  const SectionPlace& to;
  double length;
};

/// A place of the curve through a pair of places. @returns none where normals are parallel
std::optional<SectionPlace> section_place(const TwoPatches& patches, const PatchSpots& at);

/// A place where normals are parallel, in one of the pieces that it is in.
struct SectionTouch {
  PatchSpots at;
  glm::dvec3 point;
};

}  // namespace splinecore
#pragma GCC visibility pop
