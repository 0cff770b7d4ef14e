#pragma once

#include <vector>

#include "going_on.hpp"
#include "meet/near_space.hpp"
#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/surface/loft.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A row of control points along a loft, as given, and their homogeneous form in a space where they are about 1 large.
struct SectionRow {
  std::vector<glm::dvec4> points;
  std::vector<glm::dvec4> near;
};

/// Derivatives 1, 2, … out of a neighbor at its side, homogeneous in that space.
using LeavingRows = std::vector<std::vector<glm::dvec4>>;

/// The sections of a loft, those of neighbors and poles among them, on one knot vector.
struct LoftSections {
  NearSpace space;
  KnotVector knots;
  std::vector<SectionRow> rows;
  LeavingRows leaving_start;   ///< none without a neighbor
  LeavingRows leaving_end;
  double error;                ///< how far sections were moved
};

/// @throws InvalidShape and ToleranceNotReached as loft()
LoftSections loft_sections(std::span<const LoftSection> sections, const LoftOptions& options);

}  // namespace splinecore
#pragma GCC visibility pop
