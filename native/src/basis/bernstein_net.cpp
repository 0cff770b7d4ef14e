#include "bernstein_net.hpp"

#include "splinecore/base/pause.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

/// Parallel lines of a net: how many, of how many points, and the ways from one line and one point to the next.
struct Strides {
  std::size_t lines;
  std::size_t size;
  std::size_t next;
  std::size_t step;
};

template <class Value>
Strides strides_along(const BernsteinNet<Value>& net, Axis axis) {
  if (axis == Axis::u) return {net.columns, net.rows, 1, net.columns};
  return {net.rows, net.columns, net.columns, 1};
}

}  // namespace

template <class Value>
void BernsteinNet<Value>::cut(Axis axis, double t, BernsteinNet& after) {
  const Strides along = strides_along(*this, axis);
  breathe(2 * along.lines * along.size * along.size);
  after.rows = rows;
  after.columns = columns;
  after.values.resize(values.size());
  const double s = 1.0 - t;
  const std::size_t last = along.size - 1;
  // Each line becomes the first points of all levels of the triangle; the last ones go behind.
  const auto copy_end = [&](std::size_t level, std::size_t first, std::size_t count) {
    for (std::size_t line = first; line < first + count; ++line) {
      after.values[line * along.next + (last - level) * along.step] = values[line * along.next + last * along.step];
    }
  };
  const auto mix = [&](std::size_t i, std::size_t first, std::size_t count) {
    const Value* const above = values.data() + (i - 1) * along.step;
    Value* const own = values.data() + i * along.step;
    for (std::size_t line = first; line < first + count; ++line) {
      own[line * along.next] = s * above[line * along.next] + t * own[line * along.next];
    }
  };
  // Lines side by side in memory are cut together, others one by one.
  const std::size_t together = along.next == 1 ? along.lines : 1;
  for (std::size_t first = 0; first < along.lines; first += together) {
    copy_end(0, first, together);
    for (std::size_t level = 1; level <= last; ++level) {
      for (std::size_t i = last; i >= level; --i) mix(i, first, together);
      copy_end(level, first, together);
    }
  }
}

template <class Value>
BernsteinNet<Value> BernsteinNet<Value>::derivative(Axis axis) const {
  const bool is_u = axis == Axis::u;
  BernsteinNet found{is_u ? rows - 1 : rows, is_u ? columns : columns - 1, {}};
  found.values.reserve(found.rows * found.columns);
  const double factor = degree(axis);
  for (std::size_t i = 0; i < found.rows; ++i) {
    for (std::size_t j = 0; j < found.columns; ++j) {
      found.values.push_back(factor * ((is_u ? at(i + 1, j) : at(i, j + 1)) - at(i, j)));
    }
  }
  return found;
}

template struct BernsteinNet<double>;
template struct BernsteinNet<glm::dvec2>;
template struct BernsteinNet<glm::dvec3>;
template struct BernsteinNet<glm::dvec4>;

BernsteinNet<double> weights_of(const BernsteinNet<glm::dvec4>& piece) {
  BernsteinNet<double> weights{piece.rows, piece.columns, std::vector<double>(piece.values.size())};
  std::ranges::transform(piece.values, weights.values.begin(), &glm::dvec4::w);
  return weights;
}

void write_bezier_piece(const KnotVector& knots, int span, const glm::dvec4* points, glm::dvec4* out) {
  write_bezier_piece(knots.bezier_matrix(span), points + knots.spans()[span] - knots.degree(), out);
}

void write_bezier_piece(const SquareRows& matrix, const glm::dvec4* points, glm::dvec4* out) {
  breathe(4 * matrix.size() * matrix.size());
  for (std::size_t j = 0; j < matrix.size(); ++j) out[j] = weighted_sum(matrix[j], points);
}

BernsteinNet<glm::dvec4> bezier_piece(const KnotVector& knots, int span, const glm::dvec4* points) {
  const std::size_t order = knots.degree() + 1;
  BernsteinNet<glm::dvec4> piece{order, 1, std::vector<glm::dvec4>(order)};
  write_bezier_piece(knots, span, points, piece.values.data());
  return piece;
}

BernsteinNet<glm::dvec4> bezier_piece(const KnotVector& knots_u, int span_u, const KnotVector& knots_v, int span_v,
                                      const glm::dvec4* points) {
  const auto width = static_cast<std::size_t>(knots_v.unrolled_count());
  const glm::dvec4* corner =
      points + (knots_u.spans()[span_u] - knots_u.degree()) * width + (knots_v.spans()[span_v] - knots_v.degree());
  return bezier_piece(knots_u.bezier_matrix(span_u), knots_v.bezier_matrix(span_v), corner, width);
}

BernsteinNet<glm::dvec4> bezier_piece(const SquareRows& matrix_u, const SquareRows& matrix_v, const glm::dvec4* points,
                                      std::size_t width) {
  const std::size_t rows = matrix_u.size();
  const std::size_t columns = matrix_v.size();
  std::vector<glm::dvec4> half(rows * columns);
  for (std::size_t i = 0; i < rows; ++i) {
    breathe(4 * columns * columns);
    for (std::size_t j = 0; j < columns; ++j) {
      half[i * columns + j] = weighted_sum(matrix_v[j], points + i * width);
    }
  }
  BernsteinNet<glm::dvec4> piece{rows, columns, std::vector<glm::dvec4>(rows * columns, glm::dvec4(0.0))};
  for (std::size_t i = 0; i < rows; ++i) {
    breathe(4 * rows * columns);
    for (std::size_t k = 0; k < rows; ++k) {
      const double weight = matrix_u[i][k];
      if (weight == 0.0) continue;
      for (std::size_t j = 0; j < columns; ++j) piece.values[i * columns + j] += weight * half[k * columns + j];
    }
  }
  return piece;
}

}  // namespace splinecore
