#pragma once

#include <span>
#include <vector>

#include "aligned_sections.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Which corners of sections are matched.
enum class CornerLevel {
  all,   ///< every break of the tangent
  seen,  ///< those that one sees, and that imports do not make
};

/// The corners of each of some curves, in order.
struct SectionCorners {
  CornerLevel level;
  bool is_cyclic;  ///< the curves are all periodic, and their seams count as other places do
  std::vector<std::vector<double>> at;

  bool are_as_many() const;  ///< in each curve, and not none
};

/// By all corners, where the curves have equal numbers of these, else by those that are seen.
/// @param has_free_seams  periodic curves may be begun elsewhere; else seams are ends, and no corners
SectionCorners section_corners(std::span<const NurbsCurve> curves, bool has_free_seams);

/// turns_of() curves with as many corners: those that are periodic begin at one, and each runs as the one before does where
/// their pieces between corners lie beside each other.
std::vector<SectionTurn> turns_by_corners(const std::vector<NurbsCurve>& curves, const SectionCorners& corners);

/// The same curve at another pace: at `to` where it was at `from`, evenly between, over a domain, with all copies of a knot in
/// each. Ends that are periodic stay together.
NurbsCurve repaced(const NurbsCurve& curve, std::span<const double> from, std::span<const double> to, Interval domain);

/// The means of where curves have their corners, as parts of the domain, over that of the first; those of the first where all
/// have the same.
std::vector<double> mean_corners(std::span<const NurbsCurve> curves, const SectionCorners& corners);

}  // namespace splinecore
#pragma GCC visibility pop
