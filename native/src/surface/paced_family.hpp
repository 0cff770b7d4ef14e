#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

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
  bool is_there;  ///< all given are as wanted
};

PacedFamily paced(const NetworkFamily& family);

/// Points of a curve as it is given, at parameters at which the family meets the others.
std::vector<glm::dvec3> given_points(const PacedFamily& family, std::size_t i, std::span<const double> at);

/// How many of the others a family meets.
inline std::size_t count_of_others(const PacedFamily& family) { return family.wanted.size() - (family.is_closed ? 1 : 0); }

/// Multiplies the weights of curves so that they are one where curves meet. @returns whether that can be done
bool reconcile_weights(PacedFamily& u, PacedFamily& v);

/// The curves of a family as polynomials that meet the others where they are to.
void repace(PacedFamily& family, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
