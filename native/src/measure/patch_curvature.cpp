#include "splinecore/measure/patch_curvature.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>

#include "base/placement.hpp"
#include "base/quotient.hpp"
#include "patch/rescale.hpp"
#include "splinecore/base/pause.hpp"
#include "tangent_rounding.hpp"

namespace splinecore {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
/// Below this share of the patch's size a derivative, over its whole domain, is rounding.
constexpr double kNegligible = 1e-12;

/// S and its derivatives up to the second at one pair of parameters.
struct SurfaceJet {
  std::array<glm::dvec3, 9> values;

  const glm::dvec3& at(int k, int l) const { return values[3 * k + l]; }
  const glm::dvec3& u() const { return at(1, 0); }
  const glm::dvec3& v() const { return at(0, 1); }
};

/// A symmetric form on the plane of two orthonormal vectors: a x² + 2 b x y + c y².
struct PlaneForm {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
};

/// An orthonormal frame of the tangent plane, right-handed about the normal.
struct TangentFrame {
  glm::dvec3 x;
  glm::dvec3 y;
  glm::dvec3 normal;
};

/// A patch near the origin, of size 1 or so, on domains whose length is no number that a square takes out of range.
class Surface {
 public:
  explicit Surface(const NurbsPatch& patch)
      : placement_(exact_placement(patch.points())), scales_(parameter_scales(patch)),
        patch_(divided(placed(patch, placement_), scales_)), size_(extent(patch_.points())),
        lengths_{patch_.knot_vector(Axis::u).domain().length(), patch_.knot_vector(Axis::v).domain().length()} {}

  const Placement& placement() const { return placement_; }

  /// The parameter here of one that was given.
  double parameter(Axis axis, double given) const { return std::scalbn(given, -scales_[static_cast<int>(axis)]); }

  /// A measure by the parameters that were given, `u` and `v` times derived by them.
  double by_given(double value, int u, int v) const {
    return std::isnan(value) ? value : std::scalbn(value, -u * scales_[0] - v * scales_[1]);
  }

  SurfaceJet jet(double u, double v, PatchOptions options) const {
    SurfaceJet jet;
    jet.values.fill(glm::dvec3(kNan));
    evaluate(patch_, {&u, 1}, {&v, 1}, std::span(&jet.values[0].x, 3), options);
    if (is_finite(jet.values[0])) add_derivatives(u, v, options, jet);
    return jet;
  }

  bool is_regular(double u, double v, const SurfaceJet& jet, PatchOptions options) const {
    const double area = glm::length(glm::cross(jet.u(), jet.v()));
    return area > kNegligible * (size_ / lengths_[0]) * (size_ / lengths_[1]) ||
           (area > 0.0 && is_product_known(patch_, u, v, {jet.at(0, 0), jet.u(), jet.v()}, options));
  }

  /// Whether the derivative along an axis is zero.
  bool vanishes(const glm::dvec3& derivative, Axis axis) const {
    return glm::length(derivative) <= kNegligible * size_ / lengths_[static_cast<int>(axis)];
  }

  /// The unit normal, at a pole its limit; NaN where there is none.
  glm::dvec3 normal(double u, double v, const SurfaceJet& jet, PatchOptions options) const {
    if (is_regular(u, v, jet, options)) return glm::normalize(glm::cross(jet.u(), jet.v()));
    glm::dvec3 point;
    glm::dvec3 normal;
    evaluate_grid_with_normals(patch_, {&u, 1}, {&v, 1}, std::span(&point.x, 3), std::span(&normal.x, 3), options);
    return normal == glm::dvec3(0.0) ? glm::dvec3(kNan) : normal;
  }

  SurfaceCurvature curvature(double u, double v, PatchOptions options) const;

 private:
  void add_derivatives(double u, double v, PatchOptions options, SurfaceJet& jet) const;
  std::optional<PlaneForm> form_at_pole(Axis along, double u, double v, const TangentFrame& frame,
                                        PatchOptions options) const;

  Placement placement_;
  std::array<int, 2> scales_;
  NurbsPatch patch_;
  double size_;
  std::array<double, 2> lengths_;
};

/// A point or direction seen from an origin, its weight divided by a power of two, so that slopes of the functions may
/// multiply it.
glm::dvec4 seen_from(const glm::dvec3& origin, const glm::dvec4& p, int weight_exponent) {
  const double w = std::ldexp(p.w, -weight_exponent);
  if (p.w != 0.0) return glm::dvec4(w * (glm::dvec3(p) - origin), w);
  return {std::ldexp(p.x, -weight_exponent), std::ldexp(p.y, -weight_exponent), std::ldexp(p.z, -weight_exponent), 0.0};
}

/// From control points relative to the point itself: near a pole, where the derivatives fall to zero, their
/// rounding does so, too.
void Surface::add_derivatives(double u, double v, PatchOptions options, SurfaceJet& jet) const {
  const Samples at_u = Samples::make(patch_.knot_vector(Axis::u), {&u, 1}, 2, options.side_u);
  const Samples at_v = Samples::make(patch_.knot_vector(Axis::v), {&v, 1}, 2, options.side_v);
  const glm::dvec3 origin = jet.at(0, 0);
  const int count_u = patch_.count(Axis::u);
  const int count_v = patch_.count(Axis::v);
  std::array<glm::dvec4, 9> sums;
  sums.fill(glm::dvec4(0.0));
  for (std::size_t i = 0; i < at_u.weights(0).size(); ++i) {
    const std::size_t row = (at_u.first(0) + i) % count_u * count_v;
    breathe(40 * at_v.weights(0).size());
    for (std::size_t j = 0; j < at_v.weights(0).size(); ++j) {
      const glm::dvec4& p = patch_.points()[row + (at_v.first(0) + j) % count_v];
      const glm::dvec4 moved = seen_from(origin, p, patch_.weight_exponent());
      for (int kl = 0; kl < 9; ++kl) sums[kl] += at_u.weights(0, kl / 3)[i] * at_v.weights(0, kl % 3)[j] * moved;
    }
  }
  quotient_derivatives(sums, 2, jet.values);
  jet.values[0] = origin;
}

/// The second form in the frame, from that in S_u and S_v: S_u = p x and S_v = q x + r y.
PlaneForm regular_form(const SurfaceJet& jet, const TangentFrame& frame) {
  const double p = glm::dot(jet.u(), frame.x);
  const double q = glm::dot(jet.v(), frame.x);
  const double r = glm::dot(jet.v(), frame.y);
  const double l = glm::dot(jet.at(2, 0), frame.normal) / (p * p);
  const double m = glm::dot(jet.at(1, 1), frame.normal) / p;
  const double n = glm::dot(jet.at(0, 2), frame.normal);
  return {l, (m - q * l) / r, (n - 2.0 * q * m + q * q * l) / (r * r)};
}

/// Curvatures of the form, turned into the frame's space.
SurfaceCurvature curvature_of(const PlaneForm& form, const TangentFrame& frame) {
  constexpr double kUmbilic = 1e-12;
  const double half = 0.5 * (form.a - form.c);
  const double radius = std::hypot(half, form.b);
  SurfaceCurvature found;
  found.gauss = form.a * form.c - form.b * form.b;
  found.mean = 0.5 * (form.a + form.c);
  found.principal = {found.mean + radius, found.mean - radius};
  const bool is_umbilic = radius <= kUmbilic * std::abs(found.mean);
  const double angle = is_umbilic ? 0.0 : 0.5 * std::atan2(form.b, half);
  found.directions[0] = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
  found.directions[1] = glm::cross(frame.normal, found.directions[0]);
  return found;
}

SurfaceCurvature nothing() {
  return {kNan, kNan, {kNan, kNan}, {glm::dvec3(kNan), glm::dvec3(kNan)}};
}

TangentFrame frame_along(const glm::dvec3& vector, const glm::dvec3& normal) {
  const glm::dvec3 x = glm::normalize(vector - glm::dot(vector, normal) * normal);
  return {x, glm::cross(normal, x), normal};
}

/// Normal curvatures in directions of the tangent plane, and the form that fits them all.
class EulerFit {
 public:
  void add(double x, double y, double curvature) {
    const glm::dvec3 row(x * x, 2.0 * x * y, y * y);
    matrix_ += glm::outerProduct(row, row);
    right_ += curvature * row;
    rows_.push_back({row, curvature});
  }

  /// Nothing if the directions are too few or no form fits.
  std::optional<PlaneForm> form() const {
    constexpr double kLeastDeterminant = 1e-6;
    constexpr double kLargestMiss = 1e-8;
    if (std::abs(glm::determinant(matrix_)) <= kLeastDeterminant) return std::nullopt;
    const glm::dvec3 found = glm::inverse(matrix_) * right_;
    double miss = 0.0;
    double largest = 0.0;
    for (const auto& [row, curvature] : rows_) {
      miss = std::max(miss, std::abs(glm::dot(row, found) - curvature));
      largest = std::max(largest, std::abs(curvature));
    }
    if (!(miss <= kLargestMiss * largest)) return std::nullopt;
    return PlaneForm{found.x, found.y, found.z};
  }

 private:
  struct Row {
    glm::dvec3 row;
    double curvature;
  };
  glm::dmat3 matrix_{0.0};
  glm::dvec3 right_{0.0};
  std::vector<Row> rows_;
};

/// The edge along which the axis runs is one point: the lines that leave it are looked at.
std::optional<PlaneForm> Surface::form_at_pole(Axis along, double u, double v, const TangentFrame& frame,
                                               PatchOptions options) const {
  constexpr int kLines = 9;
  constexpr double kTangent = 1e-9;
  const bool is_u = along == Axis::u;
  const Interval domain = patch_.knot_vector(along).domain();
  EulerFit fit;
  for (int i = 0; i < kLines; ++i) {
    const double other = domain.start + domain.length() * (i + 0.5) / kLines;
    const SurfaceJet there = is_u ? jet(other, v, options) : jet(u, other, options);
    const glm::dvec3& slope = is_u ? there.v() : there.u();
    const double speed = glm::length(slope);
    if (!vanishes(is_u ? there.u() : there.v(), along)) return std::nullopt;
    if (vanishes(slope, is_u ? Axis::v : Axis::u)) return std::nullopt;
    if (std::abs(glm::dot(slope, frame.normal)) > kTangent * speed) return std::nullopt;
    const double bend = glm::dot(is_u ? there.at(0, 2) : there.at(2, 0), frame.normal);
    fit.add(glm::dot(slope, frame.x) / speed, glm::dot(slope, frame.y) / speed, bend / (speed * speed));
  }
  return fit.form();
}

SurfaceCurvature Surface::curvature(double u, double v, PatchOptions options) const {
  const SurfaceJet here = jet(u, v, options);
  const glm::dvec3 normal_here = normal(u, v, here, options);
  if (!is_finite(normal_here)) return nothing();
  if (is_regular(u, v, here, options)) {
    const TangentFrame frame = frame_along(here.u(), normal_here);
    return curvature_of(regular_form(here, frame), frame);
  }
  const bool is_u = vanishes(here.u(), Axis::u);
  if (is_u == vanishes(here.v(), Axis::v)) return nothing();
  const TangentFrame frame = frame_along(is_u ? here.v() : here.u(), normal_here);
  const auto form = form_at_pole(is_u ? Axis::u : Axis::v, u, v, frame, options);
  return form ? curvature_of(*form, frame) : nothing();
}

/// The parameters of one place, as the surface has them.
std::array<double, 2> place_of(const Surface& surface, const NurbsPatch& patch, std::span<const double> u,
                               std::span<const double> v, std::size_t i, PatchOptions options) {
  return {surface.parameter(Axis::u, patch.knot_vector(Axis::u).admit(u[i], options.side_u, i, "u")),
          surface.parameter(Axis::v, patch.knot_vector(Axis::v).admit(v[i], options.side_v, i, "v"))};
}

}  // namespace

void fundamental_forms(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                       std::span<FundamentalForms> out, PatchOptions options) {
  const Surface surface(patch);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const auto [at_u, at_v] = place_of(surface, patch, u, v, i, options);
    const SurfaceJet jet = surface.jet(at_u, at_v, options);
    const glm::dvec3 normal = is_finite(jet.at(0, 0)) ? surface.normal(at_u, at_v, jet, options) : glm::dvec3(kNan);
    const auto form = [&](double value, int dimension, int by_u, int by_v, const char* name) {
      return finite_size(surface.by_given(value, by_u, by_v), dimension, surface.placement(), name);
    };
    const auto first = [&](double value, int by_u, int by_v) { return form(value, 2, by_u, by_v, "first form"); };
    const auto second = [&](double value, int by_u, int by_v) { return form(value, 1, by_u, by_v, "second form"); };
    out[i] = {.e = first(glm::dot(jet.u(), jet.u()), 2, 0),
              .f = first(glm::dot(jet.u(), jet.v()), 1, 1),
              .g = first(glm::dot(jet.v(), jet.v()), 0, 2),
              .l = second(glm::dot(jet.at(2, 0), normal), 2, 0),
              .m = second(glm::dot(jet.at(1, 1), normal), 1, 1),
              .n = second(glm::dot(jet.at(0, 2), normal), 0, 2)};
  }
}

void curvatures(const NurbsPatch& patch, std::span<const double> u, std::span<const double> v,
                std::span<SurfaceCurvature> out, PatchOptions options) {
  const Surface surface(patch);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const auto [at_u, at_v] = place_of(surface, patch, u, v, i, options);
    const auto bent = [&](double value) { return finite_size(value, -1, surface.placement(), "curvature"); };
    SurfaceCurvature found = surface.curvature(at_u, at_v, options);
    found.gauss = finite_size(found.gauss, -2, surface.placement(), "Gaussian curvature");
    found.mean = bent(found.mean);
    found.principal = {bent(found.principal[0]), bent(found.principal[1])};
    out[i] = found;
  }
}

}  // namespace splinecore
