#include "matched_nets.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "base/quotient.hpp"
#include "slopes.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

using PlaceNet = BernsteinNet<glm::dvec3>;

std::optional<PlaceNet> polynomial(const BernsteinNet<glm::dvec4>& net) {
  constexpr double kRounding = 0x1p-44;
  const double w = net.values.front().w;
  const double rounded = kRounding * std::abs(w);
  if (!std::ranges::all_of(net.values, [&](const glm::dvec4& h) { return std::abs(h.w - w) <= rounded; })) return {};
  PlaceNet found{net.rows, net.columns, {}};
  found.values.reserve(net.values.size());
  for (const glm::dvec4& h : net.values) found.values.push_back(project(h));
  return found;
}

PlaceNet exchanged(const PlaceNet& net) {
  PlaceNet found{net.columns, net.rows, {}};
  found.values.reserve(net.values.size());
  for (std::size_t j = 0; j < net.columns; ++j) {
    for (std::size_t i = 0; i < net.rows; ++i) found.values.push_back(net.at(i, j));
  }
  return found;
}

void reverse(PlaceNet& net, Axis axis) {
  for (std::size_t i = 0; i < net.rows; ++i) {
    for (std::size_t j = 0; j < net.columns; ++j) {
      const std::size_t row = axis == Axis::u ? net.rows - 1 - i : i;
      const std::size_t column = axis == Axis::v ? net.columns - 1 - j : j;
      if (std::pair(i, j) < std::pair(row, column)) std::swap(net.at(i, j), net.at(row, column));
    }
  }
}

/// Over a range along an axis, which may run backward or go beyond the ends.
void take(PlaceNet& net, Axis axis, double start, double end) {
  if (start > end) {
    take(net, axis, end, start);
    return reverse(net, axis);
  }
  PlaceNet other;
  const auto keep_before = [&](double t) { net.cut(axis, t, other); };
  const auto keep_after = [&](double t) {
    net.cut(axis, t, other);
    std::swap(net, other);
  };
  if (std::abs(end) >= std::abs(1.0 - start)) {
    keep_before(end);
    keep_after(start / end);
  } else {
    keep_after(start);
    keep_before((end - start) / (1.0 - start));
  }
}

void raise(PlaceNet& net, Axis axis, std::size_t count) {
  while (net.count(axis) < count) {
    const std::size_t n = net.count(axis);
    const bool is_u = axis == Axis::u;
    PlaceNet raised{net.rows + (is_u ? 1 : 0), net.columns + (is_u ? 0 : 1), {}};
    for (std::size_t i = 0; i < raised.rows; ++i) {
      for (std::size_t j = 0; j < raised.columns; ++j) {
        const std::size_t k = is_u ? i : j;
        const auto at = [&](std::size_t l) { return is_u ? net.at(l, j) : net.at(i, l); };
        const double share = static_cast<double>(k) / static_cast<double>(n);
        const glm::dvec3 before = k > 0 ? share * at(k - 1) : glm::dvec3(0.0);
        raised.values.push_back(k < n ? before + (1.0 - share) * at(k) : before);
      }
    }
    net = std::move(raised);
  }
}

Slopes<2> slopes_at(const PatchPart& part, const std::array<double, 2>& at, const glm::dvec3& from) {
  return slopes_of<2>(kernels(), part.net.values.data(), part.net.rows, part.net.columns, at, from);
}

/// Where a part, on from its sides, is nearest to a point, or nearly.
std::optional<std::array<double, 2>> foot(const PatchPart& part, const glm::dvec3& point) {
  constexpr int kRounds = 5;
  constexpr double kFar = 8.0;
  std::array<double, 2> at{0.5, 0.5};
  for (int round = 0; round < kRounds; ++round) {
    const Slopes<2> s = slopes_at(part, at, point);
    const double uu = glm::dot(s.first[0], s.first[0]);
    const double uv = glm::dot(s.first[0], s.first[1]);
    const double vv = glm::dot(s.first[1], s.first[1]);
    const double u = glm::dot(s.offset, s.first[0]);
    const double v = glm::dot(s.offset, s.first[1]);
    const double area = uu * vv - uv * uv;
    if (!(area > 0.0)) return {};
    at[0] -= (u * vv - v * uv) / area;
    at[1] -= (v * uu - u * uv) / area;
    if (!(std::max(std::abs(at[0] - 0.5), std::abs(at[1] - 0.5)) < kFar)) return {};
  }
  return at;
}

template <class Value, class Product>
BernsteinNet<Value> product(const PlaceNet& a, const PlaceNet& b, Product multiply) {
  const int p = a.degree(Axis::u);
  const int q = a.degree(Axis::v);
  const int r = b.degree(Axis::u);
  const int s = b.degree(Axis::v);
  breathe(8 * a.values.size() * b.values.size());
  const auto scaled = [](const PlaceNet& net) {
    std::vector<glm::dvec3> values;
    values.reserve(net.values.size());
    for (std::size_t i = 0; i < net.rows; ++i) {
      const double row = binomial(net.degree(Axis::u), static_cast<int>(i));
      for (std::size_t j = 0; j < net.columns; ++j) {
        values.push_back(row * binomial(net.degree(Axis::v), static_cast<int>(j)) * net.at(i, j));
      }
    }
    return values;
  };
  const std::vector<glm::dvec3> of_a = scaled(a);
  const std::vector<glm::dvec3> of_b = scaled(b);
  BernsteinNet<Value> found{a.rows + b.rows - 1, a.columns + b.columns - 1, {}};
  found.values.assign(found.rows * found.columns, Value(0.0));
  for (std::size_t i = 0; i < a.rows; ++i) {
    for (std::size_t j = 0; j < a.columns; ++j) {
      for (std::size_t k = 0; k < b.rows; ++k) {
        Value* const sums = &found.at(i + k, j);
        for (std::size_t l = 0; l < b.columns; ++l) sums[l] += multiply(of_a[i * a.columns + j], of_b[k * b.columns + l]);
      }
    }
  }
  for (int i = 0; i <= p + r; ++i) {
    for (int j = 0; j <= q + s; ++j) {
      found.at(static_cast<std::size_t>(i), static_cast<std::size_t>(j)) /= binomial(p + r, i) * binomial(q + s, j);
    }
  }
  return found;
}

}  // namespace

MatchedNets::MatchedNets(const PatchPart& a, const PatchPart& b, PlaceNet net_a, PlaceNet net_b, bool is_exchanged,
                         const std::array<Ends, 2>& ends)
    : range_a_(a.range), range_b_(b.range), a_(std::move(net_a)), b_(std::move(net_b)), is_exchanged_(is_exchanged),
      ends_(ends) {}

std::optional<MatchedNets> MatchedNets::of(const PatchPart& a, const PatchPart& b) {
  constexpr double kLeast = 0x1p-4;
  constexpr double kMost = 0x1p4;
  std::optional<PlaceNet> net_a = polynomial(a.net);
  std::optional<PlaceNet> net_b = net_a ? polynomial(b.net) : std::nullopt;
  if (!net_b) return {};
  const Slopes<2> middle = slopes_at(a, {0.5, 0.5}, glm::dvec3(0.0));
  const auto at = foot(b, middle.point);
  if (!at) return {};
  const Slopes<2> there = slopes_at(b, *at, middle.point);
  const glm::dvec3 normal = glm::cross(there.first[0], there.first[1]);
  const double square = glm::dot(normal, normal);
  // By how much parameters of the second part go with each of the first one.
  std::array<std::array<double, 2>, 2> turn{};
  for (std::size_t k = 0; k < 2; ++k) {
    turn[k] = {glm::dot(glm::cross(middle.first[k], there.first[1]), normal) / square,
               glm::dot(glm::cross(there.first[0], middle.first[k]), normal) / square};
  }
  const bool is_exchanged = std::abs(turn[0][1] * turn[1][0]) > std::abs(turn[0][0] * turn[1][1]);
  std::array<Ends, 2> ends{};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t own = is_exchanged ? 1 - k : k;
    const double length = turn[k][own];
    if (!(std::abs(length) > kLeast && std::abs(length) < kMost)) return {};
    ends[k] = {(*at)[own] - 0.5 * length, (*at)[own] + 0.5 * length};
  }
  return MatchedNets(a, b, std::move(*net_a), is_exchanged ? exchanged(*net_b) : std::move(*net_b), is_exchanged, ends);
}

RangesOfTwo MatchedNets::range_of_b() const {
  RangesOfTwo found;
  for (std::size_t k = 0; k < 2; ++k) {
    const double start = ends_[k].inverse(0.0);
    const double end = ends_[k].inverse(1.0);
    found[k] = {std::min(start, end), std::max(start, end)};
  }
  return found;
}

namespace {

/// A parameter of a range by its share; beside an end by a rounding it is that.
double within(const Interval& range, double share) {
  constexpr double kRounding = 0x1p-40;
  if (share <= kRounding) return range.start;
  return share >= 1.0 - kRounding ? range.end : range.start + share * range.length();
}

}  // namespace

RangesOfTwo MatchedNets::of_a(const RangesOfTwo& box) const {
  RangesOfTwo found;
  for (std::size_t k = 0; k < 2; ++k) {
    const Interval& own = range_a_[k];
    found[k] = {within(own, box[k].start), within(own, box[k].end)};
  }
  return found;
}

RangesOfTwo MatchedNets::of_b(const RangesOfTwo& box) const {
  RangesOfTwo found;
  for (std::size_t k = 0; k < 2; ++k) {
    const Interval& own = range_b_[is_exchanged_ ? 1 - k : k];
    double start = ends_[k].at(box[k].start);
    double end = ends_[k].at(box[k].end);
    if (start > end) std::swap(start, end);
    found[is_exchanged_ ? 1 - k : k] = {within(own, start), within(own, end)};
  }
  return found;
}

namespace {

/// By how much rounding grows where a polynomial is taken beyond its ends.
double growth(double start, double end, int degree) {
  const double far = std::max({std::abs(start - 0.5), std::abs(end - 0.5), 0.5});
  return std::pow(2.0 * far, degree);
}

}  // namespace

MatchedNets::Nets MatchedNets::over(const RangesOfTwo& box) const {
  constexpr double kRounding = 0x1p-52;
  double of_a = 1.0;
  double of_b = 1.0;
  for (const Axis axis : {Axis::u, Axis::v}) {
    const std::size_t k = axis == Axis::u ? 0 : 1;
    of_a *= growth(box[k].start, box[k].end, a_.degree(axis));
    of_b *= growth(ends_[k].at(box[k].start), ends_[k].at(box[k].end), b_.degree(axis));
  }
  Nets found{a_, b_, kRounding * (of_a + of_b)};
  for (const Axis axis : {Axis::u, Axis::v}) {
    const std::size_t k = axis == Axis::u ? 0 : 1;
    take(found.a, axis, box[k].start, box[k].end);
    take(found.gap, axis, ends_[k].at(box[k].start), ends_[k].at(box[k].end));
    const std::size_t count = std::max(found.a.count(axis), found.gap.count(axis));
    raise(found.a, axis, count);
    raise(found.gap, axis, count);
  }
  for (std::size_t i = 0; i < found.a.values.size(); ++i) found.gap.values[i] -= found.a.values[i];
  return found;
}

std::array<int, 2> MatchedNets::ways() const {
  return {ends_[0].end > ends_[0].start ? 1 : -1, ends_[1].end > ends_[1].start ? 1 : -1};
}

PlaceNet cross_product(const PlaceNet& a, const PlaceNet& b) {
  return product<glm::dvec3>(a, b, [](const glm::dvec3& p, const glm::dvec3& q) { return glm::cross(p, q); });
}

BernsteinNet<double> scalar_product(const PlaceNet& a, const PlaceNet& b) {
  return product<double>(a, b, [](const glm::dvec3& p, const glm::dvec3& q) { return glm::dot(p, q); });
}

}  // namespace splinecore
