#pragma once

#include <optional>
#include <vector>

#include "hole.hpp"
#include "splinecore/surface/fill.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Which part of a side is one of a patch of the filling: u or v of it runs from one place of the side to the other.
struct PartOfSide {
  std::size_t side;
  double from;
  double to;
  std::size_t patch;
  Border border;
};

/// What a filling is to come within.
struct FillLimits {
  double gap;
  double angle;

  bool are_met(const Filling& filling) const {
    return filling.gap <= gap && filling.angle <= angle && filling.inner_angle <= angle;
  }
};

/// A filling as its sides see it, by the control points that they decide.
/// @param limits  where there are any, what does not meet them is not measured to the end
Filling seen_along_sides(const Hole& hole, const std::vector<PartOfSide>& parts, const std::vector<NurbsPatch>& patches,
                         const std::optional<FillLimits>& limits = {});

/// The largest angle between the tangent planes of patches and of the next ones round.
/// @param next  the border of the next one that is u_end of a patch
double angle_between_patches(const std::vector<NurbsPatch>& patches, Border next);

}  // namespace splinecore
#pragma GCC visibility pop
