#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "patch_pieces.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A place of each of two patches.
struct PatchSpots {
  PatchSpot a;
  PatchSpot b;

  /// u and v of the first one, then of the second one.
  double& operator[](std::size_t i) noexcept { return i < 2 ? a.at[i] : b.at[i - 2]; }
  double operator[](std::size_t i) const noexcept { return i < 2 ? a.at[i] : b.at[i - 2]; }
};

/// So much of a parameter in [0, 1] is rounding.
inline constexpr double kOnSide = 0x1p-40;

/// Whether a pair of places is in its pieces, up to rounding, which is taken off.
bool enters(PatchSpots& at) noexcept;

/// Two patches in one space.
struct TwoPatches {
  const PatchPieces& a;
  const PatchPieces& b;
};

/// How two patches lie at a pair of places.
struct PatchMeeting {
  Slopes<2> a;
  Slopes<2> b;          ///< its offset is from the first one's point
  glm::dvec3 normal_a;  ///< unit vectors, or zero
  glm::dvec3 normal_b;
  glm::dvec3 along;     ///< the cross product of both

  double distance() const noexcept;
};

PatchMeeting meeting_at(const TwoPatches& patches, const PatchSpots& at);

/// What a place must satisfy beside being one of both patches.
struct InPlane {
  glm::dvec3 origin;
  glm::dvec3 normal;
};
struct OnFace {
  std::size_t parameter;
  double value;
};

/// The place that Newton's method finds from a pair of places, up to rounding; on patches that go on beyond their pieces.
std::optional<PatchSpots> place_near(const TwoPatches& patches, PatchSpots at, const InPlane& plane);
std::optional<PatchSpots> place_near(const TwoPatches& patches, PatchSpots at, const OnFace& face);

/// The same as long as Newton's method stays in a box.
std::optional<PatchSpots> place_near(const TwoPatches& patches, PatchSpots at, const OnFace& face,
                                     const std::array<Interval, 4>& box);

/// How two patches meet along a curve.
struct PatchContact {
  enum class Kind {
    crossing,  ///< they go through each other
    grazing,   ///< they touch, and their normals are parallel
    border,    ///< they are one surface on one side of it: the border of one lies on the other
  };
  Kind kind = Kind::crossing;
  OnFace border{0, 0.0};  ///< where they are one
};

/// The place of a curve along which they meet so, from a pair of places near it. Of places that touch none is across `way`,
/// the tangent there or nearly.
std::optional<PatchSpots> contact_near(const TwoPatches& patches, PatchSpots at, const PatchContact& contact,
                                       const glm::dvec3& way, const InPlane& plane);
std::optional<PatchSpots> contact_near(const TwoPatches& patches, PatchSpots at, const PatchContact& contact,
                                       const glm::dvec3& way, const OnFace& face);

/// The place of the second patch, on from its piece, that is right across from a place of the first one: a pair of places.
std::optional<PatchSpots> foot_near(const TwoPatches& patches, PatchSpots at);

/// Where near a pair of places normals are parallel, and right across the gap between both.
std::optional<PatchSpots> touch_near(const TwoPatches& patches, PatchSpots at);
std::optional<PatchSpots> touch_near(const TwoPatches& patches, PatchSpots at, const std::array<Interval, 4>& box);

/// By how much the parameters go along a unit vector that is a tangent of both.
std::array<double, 4> slopes_along(const PatchMeeting& at, const glm::dvec3& tangent) noexcept;

}  // namespace splinecore
#pragma GCC visibility pop
