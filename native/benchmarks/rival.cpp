#include "rival.hpp"

#include <sisl.h>

#include <stdexcept>

namespace benchmarks {

namespace {

constexpr int kRational = 2;
constexpr int kCopy = 1;

Numbers numbers_of(std::span<const double> knots) { return {knots.begin(), knots.end()}; }

void require(int status) {
  if (status < 0) throw std::runtime_error("SISL failed with status " + std::to_string(status));
}

}  // namespace

RivalCurve::RivalCurve(const splinecore::NurbsCurve& curve) {
  Numbers knots = numbers_of(curve.knot_vector().knots());
  Numbers coefficients;
  for (const glm::dvec4& p : curve.homogeneous_points()) coefficients.insert(coefficients.end(), {p.x, p.y, p.z, p.w});
  curve_ = newCurve(static_cast<int>(curve.points().size()), curve.degree() + 1, knots.data(), coefficients.data(),
                    kRational, 3, kCopy);
}

RivalCurve::~RivalCurve() { freeCurve(curve_); }

void RivalCurve::evaluate_batch(Numbers& parameters, Numbers& out) {
  int status = 0;
  s1542(curve_, static_cast<int>(parameters.size()), parameters.data(), out.data(), &status);
  require(status);
}

void RivalCurve::evaluate_each(const Numbers& parameters, Numbers& out) {
  int left = 0;
  int status = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i) s1221(curve_, 0, parameters[i], &left, &out[3 * i], &status);
  require(status);
}

RivalSurface::RivalSurface(const splinecore::NurbsPatch& patch) {
  using splinecore::Axis;
  Numbers knots_u = numbers_of(patch.knot_vector(Axis::u).knots());
  Numbers knots_v = numbers_of(patch.knot_vector(Axis::v).knots());
  const int count_u = patch.count(Axis::u);
  const int count_v = patch.count(Axis::v);
  Numbers coefficients;
  for (int j = 0; j < count_v; ++j) {
    for (int i = 0; i < count_u; ++i) {
      const glm::dvec4& p = patch.homogeneous_points()[i * count_v + j];
      coefficients.insert(coefficients.end(), {p.x, p.y, p.z, p.w});
    }
  }
  surface_ = newSurf(count_u, count_v, patch.knot_vector(Axis::u).degree() + 1, patch.knot_vector(Axis::v).degree() + 1,
                     knots_u.data(), knots_v.data(), coefficients.data(), kRational, 3, kCopy);
}

RivalSurface::~RivalSurface() { freeSurf(surface_); }

void RivalSurface::evaluate_grid(Numbers& u, Numbers& v, Numbers& out) {
  int status = 0;
  s1506(surface_, 0, static_cast<int>(u.size()), u.data(), static_cast<int>(v.size()), v.data(), out.data(), nullptr, &status);
  require(status);
}

void RivalSurface::evaluate_grid_with_normals(Numbers& u, Numbers& v, Numbers& derivatives, Numbers& normals) {
  int status = 0;
  s1506(surface_, 1, static_cast<int>(u.size()), u.data(), static_cast<int>(v.size()), v.data(), derivatives.data(),
        normals.data(), &status);
  require(status);
}

}  // namespace benchmarks
