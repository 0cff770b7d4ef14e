#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "near_patch.hpp"
#include "splinecore/meet/stationary.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The places of a patch where the distance from a point is stationary, each once.
class PatchPlaces {
 public:
  /// @param limit  parts of the patch that are surely farther are left out
  PatchPlaces(const NearPatch& patch, double limit);

  const NearPatch& patch() const noexcept { return patch_; }
  double near_limit() const noexcept { return near_limit_; }

  /// Where both derivatives of the distance are zero. The same place in a neighbor is one.
  /// @param reach  in the piece's own parameters, within which other places are this one
  void add_inner(const PiecePlace& place, double reach);

  /// A line all of which is one point, and what the distance is there, if it is stationary.
  void add_pole(Axis axis, const PiecePlace& place, std::optional<Stationary> kind);

  /// On a border or in a corner: unless an inner one is there, or a pole.
  void add_outer(const PiecePlace& place, Stationary kind);

  /// In the order of u, then v.
  std::vector<StationaryOnPatch> found() const;

  bool is_too_far(const PiecePlace& place) const;

  /// @throws InvalidShape
  [[noreturn]] void refuse_curve(const PiecePlace& near) const;

 private:
  struct Place {
    std::array<double, 2> parameters;
    std::array<double, 2> reach;
    glm::dvec3 point;
    Stationary kind;
    bool is_inner;
  };

  struct Pole {
    Axis axis;
    Place place;
    bool counts;
  };

  Place place_of(const PiecePlace& place, double reach, Stationary kind, bool is_inner) const;
  void add(const Place& made);
  bool is_in_pole(const Place& made);
  bool are_one(const Place& a, const Place& b) const noexcept;

  const NearPatch& patch_;
  double limit_;
  double near_limit_;
  std::vector<Place> places_;
  std::vector<Pole> poles_;
};

/// Adds lines that are one point. To be called first.
void add_poles(PatchPlaces& places);

/// Adds those inside pieces and on their sides. @throws InvalidShape where they are a curve.
void add_inner_places(PatchPlaces& places);

/// Adds those of borders and of knots at which the patch has an edge. To be called last.
void add_outer_places(PatchPlaces& places);

}  // namespace splinecore
#pragma GCC visibility pop
