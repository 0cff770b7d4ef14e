#include "splinecore/patch/nurbs_patch.hpp"

#include <string>

#include "basis/refinement.hpp"
#include "basis/selection.hpp"
#include "lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

std::vector<glm::dvec4> unrolled_net(std::span<const glm::dvec4> points, const KnotVector& knots_u,
                                     const KnotVector& knots_v) {
  std::vector<glm::dvec4> net;
  net.reserve(static_cast<std::size_t>(knots_u.unrolled_count()) * knots_v.unrolled_count());
  for (int i = 0; i < knots_u.unrolled_count(); ++i) {
    for (int j = 0; j < knots_v.unrolled_count(); ++j) {
      net.push_back(points[(i % knots_u.count()) * knots_v.count() + j % knots_v.count()]);
    }
  }
  return net;
}

void require_axis(const KnotVector& knots, const char* name) {
  if (knots.degree() < 1) {
    throw InvalidShape(std::string("degree in ") + name + " = 0: a patch needs degree 1 or more");
  }
  static_cast<void>(knots.domain());
}

}  // namespace

NurbsPatch::NurbsPatch(KnotVector knots_u, KnotVector knots_v, std::vector<glm::dvec4> points)
    : knots_u_(std::move(knots_u)), knots_v_(std::move(knots_v)), points_(std::move(points)),
      rational_(is_rational(points_)), weight_exponent_(rational_ ? splinecore::weight_exponent(points_) : 0),
      homogeneous_(rational_ ? homogeneous(points_, weight_exponent_) : std::vector<glm::dvec4>{}) {
  if (knots_u_.periodic() || knots_v_.periodic()) homogeneous_ = unrolled_net(homogeneous_points(), knots_u_, knots_v_);
}

NurbsPatch NurbsPatch::make(KnotVector knots_u, KnotVector knots_v, std::vector<glm::dvec4> points) {
  require_axis(knots_u, "u");
  require_axis(knots_v, "v");
  const std::size_t count_u = knots_u.count();
  const std::size_t count_v = knots_v.count();
  if (points.size() != count_u * count_v) {
    throw InvalidShape("points has " + std::to_string(points.size()) + " entries, but the knots belong to " +
                       std::to_string(count_u) + " x " + std::to_string(count_v));
  }
  require_points(points, count_v);
  return {std::move(knots_u), std::move(knots_v), std::move(points)};
}

NurbsPatch NurbsPatch::from_homogeneous(KnotVector knots_u, KnotVector knots_v,
                                        std::span<const glm::dvec4> points) {
  return make(std::move(knots_u), std::move(knots_v), as_given(points));
}

NurbsPatch refine(const NurbsPatch& patch, Axis axis, std::span<const double> inserted) {
  return applied(refinement(patch.knot_vector(axis), inserted), patch, axis);
}

NurbsPatch insert_knot(const NurbsPatch& patch, Axis axis, double u, int times) {
  return refine(patch, axis, knot_copies(patch.knot_vector(axis), u, times));
}

std::pair<NurbsPatch, NurbsPatch> split(const NurbsPatch& patch, Axis axis, double u) {
  require_inside(patch.knot_vector(axis), u);
  const NurbsPatch whole = cut(patch, axis, u);
  return {selected(whole, axis, part_before(whole.knot_vector(axis), u)),
          selected(whole, axis, part_after(whole.knot_vector(axis), u))};
}

NurbsPatch opened(const NurbsPatch& patch, Axis axis, double u) {
  if (!patch.knot_vector(axis).periodic()) throw InvalidShape("only a periodic direction can be opened");
  const double start = patch.knot_vector(axis).admit(u, Side::right);
  const NurbsPatch whole = cut(patch, axis, start);
  return selected(whole, axis, opened_at(whole.knot_vector(axis), start));
}

NurbsPatch reversed(const NurbsPatch& patch, Axis axis) {
  return selected(patch, axis, reversed(patch.knot_vector(axis)));
}

NurbsPatch swapped(const NurbsPatch& patch) {
  const int count_u = patch.count(Axis::u);
  const int count_v = patch.count(Axis::v);
  std::vector<glm::dvec4> points;
  points.reserve(patch.points().size());
  for (int j = 0; j < count_v; ++j) {
    for (int i = 0; i < count_u; ++i) points.push_back(patch.points()[i * count_v + j]);
  }
  return NurbsPatch::make(patch.knot_vector(Axis::v), patch.knot_vector(Axis::u), std::move(points));
}

NurbsPatch unrolled(const NurbsPatch& patch) {
  NurbsPatch plain = patch;
  for (const Axis axis : {Axis::u, Axis::v}) {
    if (plain.knot_vector(axis).periodic()) plain = selected(plain, axis, unrolled(plain.knot_vector(axis)));
  }
  return plain;
}

}  // namespace splinecore
