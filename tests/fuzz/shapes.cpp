#include "shapes.hpp"

#include "splinecore/basis/bernstein.hpp"

namespace splinecore::fuzz {

namespace {

/// So many are read one by one; the rest is small and from behind the end of the input.
std::size_t explicit_count(Bytes& bytes, std::size_t count) {
  return std::min<std::size_t>(count, bytes.integer(0, 40));
}

double filler(std::size_t i) { return static_cast<double>((i * 37 + 11) % 41) / 4.0 - 5.0; }

std::vector<double> stepped(Bytes& bytes, std::size_t count) {
  std::vector<double> values;
  double u = bytes.number();
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(u);
    const int tag = bytes.byte();
    u += tag < 0x60 ? 0.0 : tag < 0xf0 ? (tag - 0x5f) / 32.0 : bytes.number();
  }
  return values;
}

}  // namespace

int degree(Bytes& bytes, int most) {
  const int tag = bytes.byte();
  if (tag < 0xf0) return std::min(most, 1 + tag % 8);
  return std::min(most, 1 + (tag < 0xff ? bytes.integer(0, 31) : bytes.byte()));
}

KnotVector knots(Bytes& bytes, int most_degree) {
  const int p = degree(bytes, std::min(most_degree, kMaxDegree));
  const int kind = bytes.integer(0, 7);
  const int spans = bytes.integer(1, 9);
  if (kind == 0) return KnotVector::bezier(p);
  if (kind == 1) return KnotVector::clamped(p, p + spans);
  if (kind == 2) return KnotVector::uniform(p, p + spans);
  if (kind == 3) return KnotVector::periodic_uniform(p, spans);
  if (kind == 4) return KnotVector::make(p, stepped(bytes, spans + 1), true);
  if (kind == 5) return KnotVector::make(p, stepped(bytes, 2 * p + 1 + spans));
  std::vector<double> inner = stepped(bytes, spans + 1);
  const std::size_t ends = static_cast<std::size_t>(p);
  inner.insert(inner.begin(), ends, inner.front());
  inner.insert(inner.end(), kind == 6 ? ends : 0, inner.back());
  while (inner.size() < 2 * ends + 2) inner.push_back(inner.back() + 1.0);
  return KnotVector::make(p, std::move(inner));
}

glm::dvec3 vector(Bytes& bytes) {
  const double x = bytes.number();
  const double y = bytes.number();
  return {x, y, bytes.number()};
}

std::vector<glm::dvec3> vectors(Bytes& bytes, std::size_t count) {
  std::vector<glm::dvec3> result(count);
  const std::size_t read = explicit_count(bytes, count);
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = i < read ? vector(bytes) : glm::dvec3(filler(i), filler(i + 7), filler(2 * i));
  }
  return result;
}

std::vector<glm::dvec4> points(Bytes& bytes, std::size_t count) {
  std::vector<glm::dvec4> result;
  const int kind = bytes.integer(0, 3);
  for (const glm::dvec3& p : vectors(bytes, count)) result.emplace_back(p, 1.0);
  if (kind == 0) return result;
  const std::size_t read = explicit_count(bytes, count);
  for (std::size_t i = 0; i < read; ++i) result[i].w = kind == 1 ? std::abs(bytes.number()) : bytes.number();
  return result;
}

std::vector<double> numbers(Bytes& bytes, std::size_t count) {
  std::vector<double> values(count);
  for (double& value : values) value = bytes.number();
  return values;
}

std::vector<double> increasing(Bytes& bytes, std::size_t count) {
  std::vector<double> values(count);
  double u = bytes.number();
  for (double& value : values) {
    value = u;
    const int tag = bytes.byte();
    u += tag < 0xf0 ? (tag + 1) / 32.0 : bytes.number();
  }
  return values;
}

std::vector<double> parameters(Bytes& bytes, Interval range, std::size_t count) {
  std::vector<double> values(count);
  for (double& value : values) value = bytes.within(range);
  return values;
}

double parameter(Bytes& bytes, const KnotVector& knots) {
  const int tag = bytes.byte();
  if (tag % 2 != 0) return bytes.within(knots.domain());
  return knots.knots()[static_cast<std::size_t>(tag / 2) % knots.knots().size()];
}

NurbsCurve nurbs_curve(Bytes& bytes) {
  KnotVector vector = knots(bytes, kMaxDegree);
  const auto count = static_cast<std::size_t>(vector.count());
  return NurbsCurve::make(std::move(vector), points(bytes, count));
}

NurbsPatch nurbs_patch(Bytes& bytes) {
  KnotVector u = knots(bytes, kMaxDegree);
  KnotVector v = knots(bytes, std::max(1, static_cast<int>(kManyPoints) / (u.count() + 8)));
  const auto count = static_cast<std::size_t>(u.count()) * static_cast<std::size_t>(v.count());
  return NurbsPatch::make(std::move(u), std::move(v), points(bytes, count));
}

glm::dmat4 matrix(Bytes& bytes) {
  glm::dmat4 result(1.0);
  const bool affine = bytes.integer(0, 3) != 0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < (affine ? 3 : 4); ++row) result[column][row] = bytes.number();
  }
  return result;
}

}  // namespace splinecore::fuzz
