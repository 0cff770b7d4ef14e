#include "splinecore/measure/seam.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "base/angle.hpp"
#include "base/placement.hpp"
#include "base/quotient.hpp"
#include "base/require.hpp"
#include "flank.hpp"
#include "patch/rescale.hpp"
#include "seam_angle.hpp"
#include "seam_jets.hpp"
#include "seam_start.hpp"
#include "splinecore/patch/join.hpp"

namespace splinecore {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<SeamPlace> given_places(std::span<const double> shares) {
  std::vector<SeamPlace> places;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (!(shares[i] >= 0.0 && shares[i] <= 1.0)) {
      throw InvalidShape("parameters" + index_text(i) + " = " + text_of(shares[i]) + " is outside [0, 1]");
    }
    places.push_back({shares[i], shares[i] < 1.0 ? Side::right : Side::left});
  }
  return places;
}

double gap_of(const SeamJet& a, const SeamJet& b) { return glm::length(b.point - a.point); }
double angle_of(const SeamJet& a, const SeamJet& b) { return angle_between(a.normal, b.normal); }
double bend_of(const SeamJet& a, const SeamJet& b) { return std::abs(b.curvature - a.curvature); }

/// The larger number; one that is none does not count.
void raise(double& largest, double value) {
  if (value > largest) largest = value;
}

/// What the classes are decided by.
struct Extremes {
  double pace = 0.0;  ///< along the seam
  std::array<double, 2> derivatives{};
  std::array<double, 2> differences{};
  double curvature = 0.0;
  double steepness = 0.0;  ///< one by the least rise of across over along, where there is a normal
  int places = 0;
  int normals = 0;  ///< places with an angle
};

void add(const SeamJet& a, const SeamJet& b, SeamContinuity& found, Extremes& extremes) {
  const double gap = gap_of(a, b);
  const double angle = angle_of(a, b);
  const double bend = bend_of(a, b);
  found.points.push_back(is_finite(a.point) ? a.point : glm::dvec3(kNan));
  found.gaps.push_back(gap);
  found.angles.push_back(angle);
  found.curvature_differences.push_back(bend);
  raise(found.gap, gap);
  raise(found.angle, angle);
  raise(found.curvature_difference, bend);
  if (!std::isnan(gap)) ++extremes.places;
  if (!std::isnan(angle)) ++extremes.normals;
  for (const SeamJet* jet : {&a, &b}) {
    raise(extremes.pace, glm::length(jet->along));
    raise(extremes.derivatives[0], glm::length(jet->across));
    raise(extremes.derivatives[1], glm::length(jet->second_across));
    raise(extremes.curvature, std::abs(jet->curvature));
    if (!std::isnan(angle)) raise(extremes.steepness, 1.0 / jet->rise);
  }
  raise(extremes.differences[0], glm::length(b.across - a.across));
  raise(extremes.differences[1], glm::length(b.second_across - a.second_across));
}

void classify(SeamContinuity& found, const Extremes& extremes, const std::array<double, 3>& rounding, double size,
              double tolerance) {
  const auto relative = [&](int k) {
    return extremes.derivatives[k] > 0.0 ? extremes.differences[k] / extremes.derivatives[k] : 0.0;
  };
  found.first_difference = relative(0);
  found.second_difference = relative(1);
  if (extremes.places == 0 || found.gap > rounding[0]) return;
  const auto agrees = [&](int k) {
    return extremes.differences[k] <= std::max(tolerance * extremes.derivatives[k], rounding[k + 1]);
  };
  found.c = !agrees(0) ? 0 : !agrees(1) ? 1 : 2;
  found.g = 0;
  const double turn = 2.0 * rounding[1] * extremes.steepness;
  if (extremes.normals == 0 || found.angle > std::max(tolerance, turn)) return;
  found.g = 1;
  const double bend = (2.0 * rounding[2] * extremes.steepness + extremes.curvature * turn) * extremes.steepness;
  const double slack = std::max(tolerance * std::max(extremes.curvature, 1.0 / size), bend);
  if (found.curvature_difference <= slack) found.g = 2;
}

void require_side(const NurbsPatch& patch, Border side, const char* which) {
  const std::string name = std::string("the side of the ") + which + " patch ";
  if (patch.knot_vector(axis_of(side)).periodic()) {
    throw InvalidShape(name + "is the seam of a periodic direction: nothing ends there");
  }
  try {
    static_cast<void>(boundary(patch, side));
  } catch (const InvalidShape&) {
    throw InvalidShape(name + "lies at infinity");
  }
}

/// Powers of two by which both patches' parameters are divided; those across the seam, whose derivatives are compared,
/// by the same.
std::pair<std::array<int, 2>, std::array<int, 2>> scales_along(const NurbsPatch& a, Border side_a, const NurbsPatch& b,
                                                               Border side_b) {
  std::array<int, 2> of_a = parameter_scales(a);
  std::array<int, 2> of_b = parameter_scales(b);
  int& across_a = of_a[static_cast<int>(axis_of(side_a))];
  int& across_b = of_b[static_cast<int>(axis_of(side_b))];
  across_a = across_b = (across_a + across_b) / 2;
  return {of_a, of_b};
}

void bring_back(SeamContinuity& found, const Placement& placement) {
  const auto length = [&](double value) { return finite_size(value, 1, placement, "gap"); };
  const auto bend = [&](double value) { return finite_size(value, -1, placement, "difference of the curvatures"); };
  found.gap = length(found.gap);
  found.curvature_difference = bend(found.curvature_difference);
  for (double& gap : found.gaps) gap = length(gap);
  for (double& difference : found.curvature_differences) difference = bend(difference);
  for (glm::dvec3& point : found.points) {
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = given_size(point[axis], 1, placement) + placement.origin[axis];
    }
  }
}

/// Two patches brought near the origin, with one pace across, beside their seam.
struct Seam {
  Placement placement;
  double size;
  bool is_reversed;
  Flank a;
  Flank b;
};

Seam seam_between(const NurbsPatch& a, Border side_a, const NurbsPatch& b, Border side_b, std::optional<bool> reversed) {
  std::vector<glm::dvec4> all(a.points().begin(), a.points().end());
  all.insert(all.end(), b.points().begin(), b.points().end());
  const Placement placement = exact_placement(all);
  const auto [scales_a, scales_b] = scales_along(a, side_a, b, side_b);
  const NurbsPatch first = divided(placed(a, placement), scales_a);
  const NurbsPatch second = begun_beside(first, side_a, divided(placed(b, placement), scales_b), side_b);
  const bool is_reversed = reversed ? *reversed : run_against(first, side_a, second, side_b);
  return {placement, std::max(extent(first.points()), extent(second.points())), is_reversed,
          Flank(first, side_a, Flank::Role::first, false), Flank(second, side_b, Flank::Role::second, is_reversed)};
}

}  // namespace

SeamContinuity seam_continuity(const NurbsPatch& a, Border side_a, const NurbsPatch& b, Border side_b,
                               double tolerance, std::optional<std::span<const double>> places,
                               std::optional<bool> reversed) {
  require_tolerance(tolerance);
  require_side(a, side_a, "first");
  require_side(b, side_b, "second");
  const Seam seam = seam_between(a, side_a, b, side_b, reversed);
  SeamContinuity found;
  found.reversed = seam.is_reversed;
  constexpr SeamMeasure kMeasures[] = {gap_of, angle_of, bend_of};
  const SeamJets jets = places ? seam_jets(seam.a, seam.b, given_places(*places), SeamDepth::curvatures)
                               : dense_seam_jets(seam.a, seam.b, SeamDepth::curvatures, kMeasures);
  Extremes extremes;
  for (std::size_t i = 0; i < jets.places.size(); ++i) {
    found.parameters.push_back(jets.places[i].share);
    add(jets.a[i], jets.b[i], found, extremes);
  }
  std::array<double, 3> rounding = seam.a.rounding(extremes.pace);
  const std::array<double, 3> of_b = seam.b.rounding(extremes.pace);
  for (int k = 0; k < 3; ++k) rounding[k] = std::max(rounding[k], of_b[k]);
  classify(found, extremes, rounding, seam.size, tolerance);
  bring_back(found, seam.placement);
  return found;
}

double seam_angle(const NurbsPatch& a, Border side_a, const NurbsPatch& b, Border side_b,
                  std::optional<bool> reversed) {
  require_side(a, side_a, "first");
  require_side(b, side_b, "second");
  const Seam seam = seam_between(a, side_a, b, side_b, reversed);
  return largest_along(seam.a, seam.b, SeamDepth::normals, angle_of);
}

}  // namespace splinecore
