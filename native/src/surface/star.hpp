#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Nets of four-sided patches round a point, all on the same knots in both directions, over [0, 1]².
///
/// u of patch k runs from its outer corner along its first side, v along its second one; both sides end where a spoke
/// begins. Spoke k is where u of patch k ends, and where v of the next patch does; all spokes end in the middle. Control
/// points along spokes are those of both patches. Of an open star the last patch has no next one: its spoke and the one at
/// which v of the first patch ends are borders.
struct Star {
  KnotVector knots;
  std::size_t count;  ///< of patches
  bool is_open = false;
  int power = 2;      ///< of the place along a spoke, see solved_star()

  std::size_t width() const { return static_cast<std::size_t>(knots.count()); }

  /// Number of a control point, the same for those that patches share; below size().
  std::size_t at(std::size_t patch, std::size_t i, std::size_t j) const;
  std::size_t size() const { return count * width() * width(); }
};

/// The points of a star of which some are given: tangent planes of neighbours agree along the spokes, as exactly as the
/// knots allow, and the sum of the squared third derivatives of what lies between them and expected ones is least (Greiner
/// 1994).
///
/// Derivatives across a spoke, of both patches outwards, add up to f s^power times the one along it, where s goes from 0 at its
/// outer end to 1, and f is twice the cosine of the angle between spokes that all are as far apart: lecture row S21,
/// Chiyokura and Kimura 1983.
/// @param given     by number; none where they are sought
/// @param expected  by number; or none at all, which is 0
std::vector<glm::dvec3> solved_star(const Star& star, const std::vector<std::optional<glm::dvec3>>& given,
                                    const std::vector<glm::dvec3>& expected = {});

/// The points of a star of which some are given and whose spokes are as those of solved_star(), as near to others as that lets them be: the
/// sum of the squared changes is least.
/// @param points  by number
std::vector<glm::dvec3> nearest_star(const Star& star, const std::vector<std::optional<glm::dvec3>>& given,
                                     const std::vector<glm::dvec3>& points);

}  // namespace splinecore
#pragma GCC visibility pop
