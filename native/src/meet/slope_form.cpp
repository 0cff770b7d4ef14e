#include "slope_form.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/one_sign.hpp"
#include "base/rounding.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {


using Net = BernsteinNet<glm::dvec4>;

/// What the products of two Bernstein polynomials, one of each degree, are of those of the sum of the degrees.
class ProductShares {
 public:
  ProductShares(std::size_t first, std::size_t second) : width_(second) {
    const int p = static_cast<int>(first) - 1;
    const int q = static_cast<int>(second) - 1;
    for (int i = 0; i <= p; ++i) {
      for (int j = 0; j <= q; ++j) values_.push_back(binomial(p, i) / binomial(p + q, i + j) * binomial(q, j));
    }
  }

  double at(std::size_t i, std::size_t j) const noexcept { return values_[i * width_ + j]; }

 private:
  std::size_t width_;
  std::vector<double> values_;
};

template <class A, class B, class Times>
auto product(const BernsteinNet<A>& a, const BernsteinNet<B>& b, Times times) {
  using Value = decltype(times(a.values[0], b.values[0]));
  const ProductShares along(a.rows, b.rows);
  const ProductShares across(a.columns, b.columns);
  BernsteinNet<Value> out{a.rows + b.rows - 1, a.columns + b.columns - 1, {}};
  out.values.assign(out.rows * out.columns, Value(0.0));
  for (std::size_t i = 0; i < a.rows; ++i) {
    for (std::size_t j = 0; j < a.columns; ++j) {
      breathe(4 * b.values.size());
      for (std::size_t k = 0; k < b.rows; ++k) {
        for (std::size_t l = 0; l < b.columns; ++l) {
          out.at(i + k, j + l) += along.at(i, k) * across.at(j, l) * times(a.at(i, j), b.at(k, l));
        }
      }
    }
  }
  return out;
}

template <class Value>
BernsteinNet<Value> transposed(const BernsteinNet<Value>& net) {
  BernsteinNet<Value> out{net.columns, net.rows, {}};
  out.values.reserve(net.values.size());
  for (std::size_t j = 0; j < net.columns; ++j) {
    for (std::size_t i = 0; i < net.rows; ++i) out.values.push_back(net.at(i, j));
  }
  return out;
}

bool is_plain(const Net& piece) noexcept {
  const double w = piece.values.front().w;
  return std::ranges::all_of(piece.values, [w](const glm::dvec4& h) { return h.w == w; });
}

/// X' along u.
BernsteinNet<glm::dvec3> plain_direction(const Net& piece) {
  BernsteinNet<glm::dvec3> out{piece.rows - 1, piece.columns, {}};
  const auto degree = static_cast<double>(out.rows);
  for (std::size_t i = 0; i + piece.columns < piece.values.size(); ++i) {
    out.values.push_back(degree * glm::dvec3(piece.values[i + piece.columns] - piece.values[i]));
  }
  return out;
}

/// W X' - W' X along u: the degree is two less than that of a product, not one, as the leading terms cancel.
BernsteinNet<glm::dvec3> direction(const Net& piece) {
  if (is_plain(piece)) return plain_direction(piece);
  const ProductShares across(piece.columns, piece.columns);
  const int p = static_cast<int>(piece.rows) - 1;
  BernsteinNet<glm::dvec3> out{2 * piece.rows - 3, 2 * piece.columns - 1, {}};
  out.values.assign(out.rows * out.columns, glm::dvec3(0.0));
  for (int i = 0; i < p; ++i) {
    for (int k = i + 1; k <= p; ++k) {
      breathe(8 * piece.columns * piece.columns);
      const double share = (k - i) * (binomial(p, i) / binomial(2 * p - 2, i + k - 1) * binomial(p, k));
      for (std::size_t j = 0; j < piece.columns; ++j) {
        for (std::size_t l = 0; l < piece.columns; ++l) {
          const glm::dvec4& a = piece.at(i, j);
          const glm::dvec4& b = piece.at(k, l);
          out.at(i + k - 1, j + l) += share * across.at(j, l) * (a.w * glm::dvec3(b) - b.w * glm::dvec3(a));
        }
      }
    }
  }
  return out;
}

template <class Values, class Size>
double largest(const Values& values, Size size) {
  double found = 0.0;
  for (const auto& value : values) found = std::max(found, size(value));
  return found;
}

SlopeForm slope_along_u(const Net& piece, const glm::dvec3& point, double rounding) {
  BernsteinNet<glm::dvec3> offsets{piece.rows, piece.columns, {}};
  for (const glm::dvec4& h : piece.values) offsets.values.push_back(glm::dvec3(h) - h.w * point);
  const BernsteinNet<glm::dvec3> ways = direction(piece);
  const auto length = [](const glm::dvec3& v) { return glm::length(v); };
  const double weight = largest(piece.values, [](const glm::dvec4& h) { return std::abs(h.w); });
  const double size = largest(piece.values, [](const glm::dvec4& h) { return glm::length(glm::dvec3(h)); });
  const double offset = largest(offsets.values, length);
  const double way = largest(ways.values, length);
  const double wrong = kRoundingOfStep * size + rounding * weight;
  const double wrong_way = 4.0 * static_cast<double>(piece.rows) * weight * wrong;
  return {product(offsets, ways, [](const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a, b); }),
          offset * wrong_way + way * wrong + kRoundingOfStep * offset * way};
}

}  // namespace

bool scale_weights(BernsteinNet<glm::dvec4>& piece) noexcept {
  const double weight = largest(piece.values, [](const glm::dvec4& h) { return std::abs(h.w); });
  if (!(weight > 0.0)) return false;
  const int exponent = -std::ilogb(weight);
  for (glm::dvec4& h : piece.values) {
    for (int i = 0; i < 4; ++i) h[i] = std::ldexp(h[i], exponent);
  }
  return true;
}

bool is_uneven(const BernsteinNet<glm::dvec4>& piece) noexcept {
  constexpr double kUneven = 16.0;
  if (!has_one_sign(piece.values, &glm::dvec4::w)) return false;
  const auto [low, high] = piece.range([](const glm::dvec4& h) { return std::abs(h.w); });
  return high > kUneven * low;
}

SlopeForm slope_form(const BernsteinNet<glm::dvec4>& piece, Axis axis, const glm::dvec3& point, double rounding) {
  if (axis == Axis::u) return slope_along_u(piece, point, rounding);
  SlopeForm form = slope_along_u(transposed(piece), point, rounding);
  form.net = transposed(form.net);
  return form;
}

SlopeForm times_weights(const SlopeForm& form, const BernsteinNet<glm::dvec4>& piece) {
  const BernsteinNet<double> weights = weights_of(piece);
  const auto size = [](double x) { return std::abs(x); };
  const double weight = largest(weights.values, size);
  return {product(form.net, weights, [](double a, double b) { return a * b; }),
          weight * (form.noise + kRoundingOfStep * largest(form.net.values, size))};
}

BernsteinNet<double> elevated(const BernsteinNet<double>& net, std::size_t rows, std::size_t columns) {
  if (rows == net.rows && columns == net.columns) return net;
  BernsteinNet<double> ones{rows - net.rows + 1, columns - net.columns + 1, {}};
  ones.values.assign(ones.rows * ones.columns, 1.0);
  return product(net, ones, [](double a, double b) { return a * b; });
}

}  // namespace splinecore
