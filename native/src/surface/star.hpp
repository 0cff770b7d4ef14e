#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "splinecore/base/axis.hpp"
#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Knots of one degree along u and along v, over [0, 1].
using KnotPair = std::array<KnotVector, 2>;

/// Nets of four-sided patches round a point, over [0, 1]², all of one degree.
///
/// u of patch k runs from its outer corner along its first side, v along its second one; both sides end where a spoke
/// begins. Spoke k is where u of patch k ends, and where v of the next patch does; all spokes end in the middle. Control
/// points along spokes are those of both patches, and so are the knots. Of an open star the last patch has no next one: its spoke and the one at
/// which v of the first patch ends are borders.
struct Star {
  std::vector<KnotPair> knots;  ///< of each patch; v of one has those of u of the next
  bool is_open = false;
  int power = 2;                ///< of the place along a spoke, see solved_star()

  std::size_t count() const { return knots.size(); }
  const KnotVector& along(std::size_t patch, Axis axis) const { return knots[patch][static_cast<std::size_t>(axis)]; }
  std::size_t width(std::size_t patch, Axis axis) const { return static_cast<std::size_t>(along(patch, axis).count()); }
  std::size_t last(std::size_t patch, Axis axis) const { return width(patch, axis) - 1; }
  std::size_t after(std::size_t patch) const { return (patch + 1) % count(); }

  /// Spokes between two patches.
  std::size_t inner_spokes() const { return count() - (is_open ? 1 : 0); }

  /// Number of a control point, the same for those that patches share; below size().
  std::size_t at(std::size_t patch, std::size_t i, std::size_t j) const;
  std::size_t size() const { return first_of(count()); }

 private:
  /// How many numbers the patches before have.
  std::size_t first_of(std::size_t patch) const;
};

/// The derivative at the end of clamped knots by the way there from the last control point but one.
double end_slope(const KnotVector& knots);

/// The points of a star of which some are given: tangent planes of neighbors agree along the spokes, as exactly as the
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
