#include "splinecore/measure/seam.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "placement.hpp"
#include "splinecore/base/quotient.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/measure/patch_curvature.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "splinecore/patch/join.hpp"

namespace splinecore {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Within this part of the side two knots are the same.
constexpr double kSameShare = 1e-12;

/// A place along the seam; at a knot Side says whether what comes after or before.
struct Place {
  double share;
  Side side;
};

/// What a patch is at a place.
struct Jet {
  glm::dvec3 point;
  glm::dvec3 along;
  glm::dvec3 across;
  glm::dvec3 second_across;
  glm::dvec3 normal;  ///< of the way to b and of a's side; NaN where there is none
  double curvature;   ///< at right angles to the seam, towards the normal
  bool is_regular;    ///< the derivatives across and along are not parallel
};

/// One patch, near the origin, seen along its side.
class Flank {
 public:
  /// @param is_first  the way across leads out of it
  Flank(NurbsPatch patch, Border side, bool is_first, bool is_reversed)
      : patch_(std::move(patch)), side_(side), is_reversed_(is_reversed),
        direction_(is_at_end(side) == is_first ? 1.0 : -1.0) {
    constexpr double kRounding = 1e-12;
    const double size = extent(patch_.points());
    negligible_ = kRounding * (size / along().domain().length()) * (size / across().domain().length());
  }

  const KnotVector& along() const { return patch_.knot_vector(axis_of(side_) == Axis::u ? Axis::v : Axis::u); }
  const KnotVector& across() const { return patch_.knot_vector(axis_of(side_)); }

  double share_of(double knot) const {
    const Interval domain = along().domain();
    return (is_reversed_ ? domain.end - knot : knot - domain.start) / domain.length();
  }

  Jet at(const Place& place) const;

  /// How far it is from a place to the end of its span.
  double room(const Place& place) const;

  /// How far rounding may move a point and the first two derivatives across.
  std::array<double, 3> rounding(double fastest) const;

 private:
  double parameter_at(double share) const;
  double curvature_across(const glm::dvec3& along, const glm::dvec3& normal, double sign, double u, double v,
                          PatchOptions options) const;

  NurbsPatch patch_;
  Border side_;
  bool is_reversed_;
  double direction_;
  double negligible_;
};

double Flank::room(const Place& place) const {
  double room = 1.0;
  for (int i = 0; i <= static_cast<int>(along().spans().size()); ++i) {
    const bool is_last = i == static_cast<int>(along().spans().size());
    const double knot = share_of(is_last ? along().domain().end : along().span_interval(i).start);
    const double way = place.side == Side::right ? knot - place.share : place.share - knot;
    if (way > kSameShare) room = std::min(room, way);
  }
  return room;
}

double Flank::parameter_at(double share) const {
  const Interval domain = along().domain();
  // A knot is met exactly, or the other side of it would be looked at.
  for (int i = 0; i < static_cast<int>(along().spans().size()); ++i) {
    const double knot = along().span_interval(i).start;
    if (std::abs(share_of(knot) - share) <= kSameShare) return knot;
  }
  const double from_start = is_reversed_ ? 1.0 - share : share;
  return from_start >= 1.0 ? domain.end : std::clamp(domain.start + from_start * domain.length(), domain.start, domain.end);
}

double Flank::curvature_across(const glm::dvec3& along, const glm::dvec3& normal, double sign, double u, double v,
                               PatchOptions options) const {
  SurfaceCurvature found;
  curvatures(patch_, {&u, 1}, {&v, 1}, {&found, 1}, options);
  const glm::dvec3 way = glm::normalize(glm::cross(normal, along));
  const double x = glm::dot(way, found.directions[0]);
  const double y = glm::dot(way, found.directions[1]);
  return sign * (found.principal[0] * x * x + found.principal[1] * y * y);
}

Jet Flank::at(const Place& place) const {
  const bool is_u = axis_of(side_) == Axis::u;
  const double edge = is_at_end(side_) ? across().domain().end : across().domain().start;
  const double there = parameter_at(place.share);
  const double u = is_u ? edge : there;
  const double v = is_u ? there : edge;
  const Side inward = is_at_end(side_) ? Side::left : Side::right;
  const Side onward = (place.side == Side::right) == is_reversed_ ? Side::left : Side::right;
  const PatchOptions options{is_u ? inward : onward, is_u ? onward : inward, AtInfinity::nan};
  std::array<glm::dvec3, 9> values;
  derivatives(patch_, {&u, 1}, {&v, 1}, 2, std::span(&values[0].x, 27), options);
  const double turn = is_reversed_ ? -1.0 : 1.0;
  Jet jet{values[0], turn * values[is_u ? 1 : 3], direction_ * values[is_u ? 3 : 1], values[is_u ? 6 : 2],
          glm::dvec3(kNan), kNan, false};
  if (!is_finite(jet.point)) return jet;
  jet.is_regular = glm::length(glm::cross(jet.across, jet.along)) > negligible_;
  glm::dvec3 point;
  glm::dvec3 normal;
  evaluate_with_normals(patch_, {&u, 1}, {&v, 1}, std::span(&point.x, 3), std::span(&normal.x, 3), options);
  if (normal == glm::dvec3(0.0) || !is_finite(normal)) return jet;
  const double sign = (is_u ? 1.0 : -1.0) * turn * direction_;
  jet.normal = sign * normal;
  if (glm::length(jet.along) > 0.0) jet.curvature = curvature_across(jet.along, jet.normal, sign, u, v, options);
  return jet;
}

std::array<double, 3> Flank::rounding(double fastest) const {
  constexpr double kRounding = 0x1p-46;
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const glm::dvec4& p : patch_.points()) {
    if (p.w != 0.0) least = std::min(least, std::abs(p.w));
    most = std::max(most, std::abs(p.w));
  }
  const Interval domain = along().domain();
  const double farthest = std::max(std::abs(domain.start), std::abs(domain.end));
  Stencil stencil(across(), 2);
  stencil.move_to(is_at_end(side_) ? across().domain().end : across().domain().start,
                  is_at_end(side_) ? Side::left : Side::right);
  std::array<double, 3> found{kRounding * farthest * fastest, 0.0, 0.0};
  for (int k = 0; k < 3; ++k) {
    double sum = 0.0;
    for (const double weight : stencil.weights(k)) sum += std::abs(weight);
    found[k] += kRounding * sum * std::max(1.0, largest_coordinate(patch_.points())) * most / least;
  }
  return found;
}

/// Evenly spaced in each span of either, its ends from within it.
std::vector<Place> dense_places(const Flank& a, const Flank& b) {
  std::vector<double> knots{0.0, 1.0};
  int count = 3;
  for (const Flank* flank : {&a, &b}) {
    for (int i = 1; i < static_cast<int>(flank->along().spans().size()); ++i) {
      knots.push_back(flank->share_of(flank->along().span_interval(i).start));
    }
    count += 2 * flank->along().degree();
  }
  std::ranges::sort(knots);
  std::vector<Place> places;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double length = knots[i + 1] - knots[i];
    if (length <= kSameShare) continue;
    places.push_back({knots[i], Side::right});
    for (int k = 1; k < count; ++k) places.push_back({knots[i] + length * k / count, Side::right});
    places.push_back({knots[i + 1], Side::left});
  }
  return places;
}

std::vector<Place> given_places(std::span<const double> shares) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (!(shares[i] >= 0.0 && shares[i] <= 1.0)) {
      throw InvalidShape("parameters" + index_text(i) + " = " + text_of(shares[i]) + " is outside [0, 1]");
    }
    places.push_back({shares[i], shares[i] < 1.0 ? Side::right : Side::left});
  }
  return places;
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// The larger number; one that is none does not count.
void raise(double& largest, double value) {
  if (value > largest) largest = value;
}

/// Both patches at a place. Where a normal is the limit of many, as at the end of a meridian, both are those a
/// little way on along the seam, if there are such: the limit along it, nearly.
std::pair<Jet, Jet> jets(const Flank& a, const Flank& b, const Place& place) {
  constexpr double kWay = 1e-3;
  std::pair<Jet, Jet> here{a.at(place), b.at(place)};
  if (here.first.is_regular && here.second.is_regular) return here;
  const double way = kWay * std::min(a.room(place), b.room(place));
  const double next = place.side == Side::right ? place.share + way : place.share - way;
  const std::pair<Jet, Jet> there{a.at({next, place.side}), b.at({next, place.side})};
  if (!there.first.is_regular || !there.second.is_regular) return here;
  here.first.normal = there.first.normal;
  here.second.normal = there.second.normal;
  here.first.curvature = there.first.curvature;
  here.second.curvature = there.second.curvature;
  return here;
}

/// What the classes are decided by.
struct Extremes {
  double fastest = 0.0;  ///< along the seam
  std::array<double, 2> derivatives{};
  std::array<double, 2> differences{};
  double curvature = 0.0;
  int places = 0;
  int normals = 0;  ///< places with an angle
};

void add(const Jet& a, const Jet& b, SeamContinuity& found, Extremes& extremes) {
  const double gap = glm::length(b.point - a.point);
  const double angle = angle_between(a.normal, b.normal);
  const double bend = std::abs(b.curvature - a.curvature);
  found.points.push_back(is_finite(a.point) ? a.point : glm::dvec3(kNan));
  found.gaps.push_back(gap);
  found.angles.push_back(angle);
  found.curvature_differences.push_back(bend);
  raise(found.gap, gap);
  raise(found.angle, angle);
  raise(found.curvature_difference, bend);
  if (!std::isnan(gap)) ++extremes.places;
  if (!std::isnan(angle)) ++extremes.normals;
  for (const Jet* jet : {&a, &b}) {
    raise(extremes.fastest, glm::length(jet->along));
    raise(extremes.derivatives[0], glm::length(jet->across));
    raise(extremes.derivatives[1], glm::length(jet->second_across));
    raise(extremes.curvature, std::abs(jet->curvature));
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
  if (extremes.normals == 0 || found.angle > std::sqrt(tolerance)) return;
  found.g = 1;
  const double slack = std::max(std::sqrt(tolerance) * extremes.curvature, tolerance / size);
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

}  // namespace

SeamContinuity seam_continuity(const NurbsPatch& a, Border side_a, const NurbsPatch& b, Border side_b,
                               double tolerance, std::optional<std::span<const double>> places) {
  if (!(tolerance >= 0.0)) throw InvalidShape("tolerance = " + text_of(tolerance) + " is below 0");
  require_side(a, side_a, "first");
  require_side(b, side_b, "second");
  std::vector<glm::dvec4> all(a.points().begin(), a.points().end());
  all.insert(all.end(), b.points().begin(), b.points().end());
  const Placement placement = placement_of(all);
  const NurbsPatch first = placed(a, placement);
  const NurbsPatch second = placed(b, placement);
  SeamContinuity found;
  found.reversed = run_against(first, side_a, second, side_b);
  const Flank on_a(first, side_a, true, false);
  const Flank on_b(second, side_b, false, found.reversed);
  Extremes extremes;
  for (const Place& place : places ? given_places(*places) : dense_places(on_a, on_b)) {
    found.parameters.push_back(place.share);
    const auto [first_jet, second_jet] = jets(on_a, on_b, place);
    add(first_jet, second_jet, found, extremes);
  }
  std::array<double, 3> rounding = on_a.rounding(extremes.fastest);
  const std::array<double, 3> of_b = on_b.rounding(extremes.fastest);
  for (int k = 0; k < 3; ++k) rounding[k] = std::max(rounding[k], of_b[k]);
  const double size = std::max(extent(first.points()), extent(second.points()));
  classify(found, extremes, rounding, size, tolerance);
  const auto in_units = [&](double value, int dimension) { return given_size(value, dimension, placement); };
  found.gap = in_units(found.gap, 1);
  found.curvature_difference = in_units(found.curvature_difference, -1);
  for (double& gap : found.gaps) gap = in_units(gap, 1);
  for (double& bend : found.curvature_differences) bend = in_units(bend, -1);
  for (glm::dvec3& point : found.points) {
    for (int axis = 0; axis < 3; ++axis) point[axis] = in_units(point[axis], 1) + placement.origin[axis];
  }
  return found;
}

}  // namespace splinecore
