#include "finite_weights.hpp"

#include <algorithm>
#include <vector>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// The weight on a box of parameters in Bernstein's form: rows of count_v coefficients.
struct WeightNet {
  int count_u;
  int count_v;
  std::vector<double> values;
  Interval u;
  Interval v;

  double at(int i, int j) const { return values[i * count_v + j]; }
};

WeightNet net_on_spans(const NurbsPatch& patch, int span_u, int span_v) {
  const KnotVector& knots_u = patch.knot_vector(Axis::u);
  const KnotVector& knots_v = patch.knot_vector(Axis::v);
  const int count_u = knots_u.degree() + 1;
  const int count_v = knots_v.degree() + 1;
  const auto matrix_u = knots_u.bezier_matrix(span_u);
  const auto matrix_v = knots_v.bezier_matrix(span_v);
  const int width = knots_v.unrolled_count();
  const glm::dvec4* first = patch.homogeneous_points().data() + (knots_u.spans()[span_u] - knots_u.degree()) * width +
                            knots_v.spans()[span_v] - knots_v.degree();
  WeightNet net{count_u, count_v, std::vector<double>(count_u * count_v, 0.0), knots_u.span_interval(span_u),
                knots_v.span_interval(span_v)};
  std::vector<double> row(count_v);
  for (int i = 0; i < count_u; ++i) {
    std::ranges::fill(row, 0.0);
    breathe(static_cast<std::size_t>(count_u) * count_v + static_cast<std::size_t>(count_v) * count_v);
    for (int k = 0; k < count_u; ++k) {
      for (int l = 0; l < count_v; ++l) row[l] += matrix_u[i * count_u + k] * first[k * width + l].w;
    }
    for (int j = 0; j < count_v; ++j) {
      for (int l = 0; l < count_v; ++l) net.values[i * count_v + j] += matrix_v[j * count_v + l] * row[l];
    }
  }
  return net;
}

/// De Casteljau at the middle of `count` values, `step` apart.
void halve(const double* values, double* first, double* second, int count, int step) {
  std::vector<double> row(count);
  breathe(row.size() * row.size());
  for (int k = 0; k < count; ++k) row[k] = values[k * step];
  for (int n = 0; n < count; ++n) {
    first[n * step] = row[0];
    second[(count - 1 - n) * step] = row[count - 1 - n];
    for (int k = 0; k + n + 1 < count; ++k) row[k] = 0.5 * (row[k] + row[k + 1]);
  }
}

std::pair<WeightNet, WeightNet> halves_along(const WeightNet& net, Axis axis) {
  std::pair<WeightNet, WeightNet> halves{net, net};
  const bool is_u = axis == Axis::u;
  const int lines = is_u ? net.count_v : net.count_u;
  for (int line = 0; line < lines; ++line) {
    const int start = is_u ? line : line * net.count_v;
    halve(net.values.data() + start, halves.first.values.data() + start, halves.second.values.data() + start,
          is_u ? net.count_u : net.count_v, is_u ? net.count_v : 1);
  }
  Interval WeightNet::*side = is_u ? &WeightNet::u : &WeightNet::v;
  (halves.first.*side).end = (halves.second.*side).start = (net.*side).middle();
  return halves;
}

/// Not zero at the corners and nowhere of another sign: then zero nowhere.
bool has_one_sign(const WeightNet& net, double sign) {
  const int last_u = net.count_u - 1;
  const int last_v = net.count_v - 1;
  for (const double corner : {net.at(0, 0), net.at(0, last_v), net.at(last_u, 0), net.at(last_u, last_v)}) {
    if (!(corner * sign > 0.0)) throw PointAtInfinity(net.u.middle(), net.v.middle());
  }
  return std::ranges::all_of(net.values, [&](double w) { return w * sign >= 0.0; });
}

void require_sign(const WeightNet& net, double sign, int depth) {
  if (has_one_sign(net, sign)) return;
  if (depth == 0) throw PointAtInfinity(net.u.middle(), net.v.middle());
  const auto [low, high] = halves_along(net, Axis::u);
  for (const WeightNet* half : {&low, &high}) {
    const auto [before, after] = halves_along(*half, Axis::v);
    require_sign(before, sign, depth - 1);
    require_sign(after, sign, depth - 1);
  }
}

}  // namespace

void require_finite_points(const NurbsPatch& patch) {
  constexpr int kDepth = 12;
  if (!patch.rational()) return;
  for (std::size_t i = 0; i < patch.knot_vector(Axis::u).spans().size(); ++i) {
    for (std::size_t j = 0; j < patch.knot_vector(Axis::v).spans().size(); ++j) {
      const WeightNet net = net_on_spans(patch, static_cast<int>(i), static_cast<int>(j));
      require_sign(net, net.at(0, 0) < 0.0 ? -1.0 : 1.0, kDepth);
    }
  }
}

}  // namespace splinecore
