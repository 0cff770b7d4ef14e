#pragma once

#include <algorithm>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "fitted_together.hpp"
#include "network_curves.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A family over one domain, where it is to meet the others, and whether it does.
struct PacedFamily {
  std::vector<NurbsCurve> curves;
  std::vector<NurbsCurve> own;             ///< as they are given, over that domain
  std::vector<std::vector<double>> given;  ///< crossings of these
  std::vector<double> wanted;
  bool is_closed;
  std::vector<bool> there;  ///< whether the given ones of a curve are as wanted

  bool is_there() const { return std::ranges::find(there, false) == there.end(); }
};

/// Outermost curves keep their pace, the one that is given first where they are at different ones; without outermost ones, in
/// between others that are closed, all go to their mean.
PacedFamily paced(const NetworkFamily& family, bool has_outermost);

/// Points of a curve as it is given, at parameters at which the family meets the others.
std::vector<glm::dvec3> given_points(const PacedFamily& family, std::size_t i, std::span<const double> at);

/// How many of the others a family meets.
inline std::size_t count_of_others(const PacedFamily& family) { return family.wanted.size() - (family.is_closed ? 1 : 0); }

/// Multiplies the weights of curves so that they are one where curves meet. @returns whether that can be done
bool reconcile_weights(PacedFamily& u, PacedFamily& v);

/// Those curves of a family that do not meet the others where they are to, or are rational, as polynomials that do.
void repace(PacedFamily& family, double tolerance);

/// Parameters, among those at which the family meets the others, of the corners of a curve.
std::vector<double> paced_corners(const PacedFamily& family, std::size_t i);

/// And its creases, as of a cubic.
std::vector<Crease> paced_creases(const PacedFamily& family, std::size_t i);

}  // namespace splinecore
#pragma GCC visibility pop
