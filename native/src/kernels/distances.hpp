// Kernels of distances and their squares. Included in the namespace of each set of instructions: see set.hpp.

inline constexpr int kMostOrder = 256;

/// De Casteljau's triangle as far as its last three points, which stay at the start.
SPLINECORE_INLINE void shorten(Lanes* line, int count, double t) {
  const Lanes after = all(t);
  const Lanes before = all(1.0 - t);
  for (; count > 3; --count) {
    for (int i = 0; i + 1 < count; ++i) line[i] = mul_add(after, line[i + 1], before * line[i]);
  }
}

/// The weights of the last points in a value and its derivatives.
struct LastSteps {
  double value[3], first[3], second[3];
};

SPLINECORE_INLINE LastSteps last_steps(int order, double t) {
  const double s = 1.0 - t;
  if (order == 2) return {{s, t, 0.0}, {-1.0, 1.0, 0.0}, {0.0, 0.0, 0.0}};
  const double degree = order - 1;
  const double twice = degree * (degree - 1.0);
  return {{s * s, 2.0 * s * t, t * t}, {-degree * s, degree * (s - t), degree * t}, {twice, -2.0 * twice, twice}};
}

SPLINECORE_INLINE Lanes sum_of_last(const double* weights, const Lanes* points, int count) {
  const Lanes sum = mul_add(all(weights[1]), points[1], all(weights[0]) * points[0]);
  return count == 2 ? sum : mul_add(all(weights[2]), points[2], sum);
}

SPLINECORE_INLINE void load_line(const double* from, int count, Lanes* line) {
  for (int i = 0; i < count; ++i) line[i] = load(from + 4 * i);
}

/// kRows and kColumns are numbers of control points, or 0 for any.
template <int kRows, int kColumns>
void piece_slopes_of(const PieceNet& net, const double* at, double* out) {
  const int rows = kRows > 0 ? kRows : net.rows;
  const int columns = kColumns > 0 ? kColumns : net.columns;
  const int last = rows == 2 ? 2 : 3;
  const LastSteps u = last_steps(rows, at[0]);
  Lanes line[kMostOrder];
  if (columns == 1) {
    load_line(net.points, rows, line);
    shorten(line, rows, at[0]);
    store(sum_of_last(u.value, line, last), out);
    store(sum_of_last(u.first, line, last), out + 4);
    store(sum_of_last(u.second, line, last), out + 8);
    return;
  }
  const int last_v = columns == 2 ? 2 : 3;
  const LastSteps v = last_steps(columns, at[1]);
  Lanes values[kMostOrder], slopes[kMostOrder], bends[kMostOrder];
  for (int i = 0; i < rows; ++i) {
    load_line(net.points + 4 * i * columns, columns, line);
    shorten(line, columns, at[1]);
    values[i] = sum_of_last(v.value, line, last_v);
    slopes[i] = sum_of_last(v.first, line, last_v);
    bends[i] = sum_of_last(v.second, line, last_v);
  }
  shorten(values, rows, at[0]);
  shorten(slopes, rows, at[0]);
  shorten(bends, rows, at[0]);
  store(sum_of_last(u.value, values, last), out);
  store(sum_of_last(u.first, values, last), out + 4);
  store(sum_of_last(u.second, values, last), out + 8);
  store(sum_of_last(u.value, slopes, last), out + 12);
  store(sum_of_last(u.first, slopes, last), out + 16);
  store(sum_of_last(u.value, bends, last), out + 20);
}

void piece_slopes(const PieceNet& net, const double* at, double* out) {
  if (net.rows == 4 && net.columns == 1) return piece_slopes_of<4, 1>(net, at, out);
  if (net.rows == 4 && net.columns == 4) return piece_slopes_of<4, 4>(net, at, out);
  piece_slopes_of<0, 0>(net, at, out);
}

/// kRows is the number of rows, or 0 for any.
template <int kRows>
void square_sums_of(const SquareForm& form, const double* scaled, double* squares, double* weights) {
  const int rows = kRows > 0 ? kRows : form.rows;
  const std::size_t stride = form.stride;
  const std::size_t plane = static_cast<std::size_t>(rows) * stride;
  // Of one column with all the others: sums that lie apart by less than four numbers would wait for each other.
  Lanes square[2 * kMostOrder];
  Lanes weight[2 * kMostOrder];
  for (int j = 0; j < form.columns; ++j) {
    for (std::size_t l = 0; l < stride; l += 4) {
      for (int i = 0; i < 2 * rows - 1; ++i) square[i] = weight[i] = all(0.0);
      for (int i = 0; i < rows; ++i) {
        const double* const own = scaled + i * stride + j;
        for (int k = i; k < rows; ++k) {
          const double factor = i == k ? 1.0 : 2.0;
          const double* const other = scaled + k * stride + l;
          Lanes sum = square[i + k];
          sum = mul_add(all(factor * own[0]), load(other), sum);
          sum = mul_add(all(factor * own[plane]), load(other + plane), sum);
          square[i + k] = mul_add(all(factor * own[2 * plane]), load(other + 2 * plane), sum);
          weight[i + k] = mul_add(all(factor * own[3 * plane]), load(other + 3 * plane), weight[i + k]);
        }
      }
      for (int i = 0; i < 2 * rows - 1; ++i) {
        const std::size_t at = i * form.width + j + l;
        store(load(squares + at) + square[i], squares + at);
        store(load(weights + at) + weight[i], weights + at);
      }
    }
  }
}

void square_sums(const SquareForm& form, const double* scaled, double* squares, double* weights) {
  if (form.rows == 4) return square_sums_of<4>(form, scaled, squares, weights);
  square_sums_of<0>(form, scaled, squares, weights);
}

void box_distances(const BoxGroup& group, const double* from, double* squares) {
  for (std::size_t i = 0; i < kBoxGroup; i += kWide) {
    WideLanes sum{};
    for (int axis = 0; axis < 3; ++axis) {
      const WideLanes between = all<WideLanes>(from[axis]) - load<WideLanes>(group.middle[axis] + i);
      const WideLanes apart = (between < -between ? -between : between) - load<WideLanes>(group.half[axis] + i);
      const WideLanes outside = apart > WideLanes{} ? apart : WideLanes{};
      sum = mul_add(outside, outside, sum);
    }
    store(sum, squares + i);
  }
}

void turned_box_distances(const TurnedBoxGroup& group, const double* from, double* squares) {
  for (std::size_t i = 0; i < kBoxGroup; i += kWide) {
    const auto coordinate = [&](const double* numbers) { return load<WideLanes>(numbers + i); };
    WideLanes offset[3];
    for (int c = 0; c < 3; ++c) offset[c] = all<WideLanes>(from[c]) - coordinate(group.center[c]);
    WideLanes sum{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto& direction = group.axes[axis];
      const WideLanes along = mul_add(coordinate(direction[0]), offset[0],
                                      mul_add(coordinate(direction[1]), offset[1], coordinate(direction[2]) * offset[2]));
      const WideLanes apart = (along < -along ? -along : along) - coordinate(group.half[axis]);
      const WideLanes outside = apart > WideLanes{} ? apart : WideLanes{};
      sum = mul_add(outside, outside, sum);
    }
    store(sum, squares + i);
  }
}

/// From each of four points to the next one.
SPLINECORE_INLINE Lanes four_chord_squares(const double* points) {
  const Lanes first = load(points + 3) - load(points);
  const Lanes second = load(points + 7) - load(points + 4);
  const Lanes third = load(points + 11) - load(points + 8);
  const Lanes a = first * first;   // x0 y0 z0 x1
  const Lanes b = second * second; // y1 z1 x2 y2
  const Lanes c = third * third;   // z2 x3 y3 z3
  const Lanes x = __builtin_shufflevector(__builtin_shufflevector(a, b, 0, -1, 6, 3), c, 0, 3, 2, 5);
  const Lanes y = __builtin_shufflevector(__builtin_shufflevector(a, b, 4, 1, -1, 7), c, 1, 0, 3, 6);
  const Lanes z = __builtin_shufflevector(__builtin_shufflevector(a, b, -1, 5, 2, -1), c, 2, 1, 4, 7);
  return x + y + z;
}

bool chords(const double* points, std::size_t count, double least, double most, double* out) {
  bool are_in_range = true;
  for (std::size_t i = 0; i < count; i += 4) {
    // The last ones are written once more.
    const std::size_t first = i < count - 4 ? i : count - 4;
    const Lanes squares = four_chord_squares(points + 3 * first);
    are_in_range &= is_between(least, most, squares);
    store(square_root(squares), out + first);
  }
  return are_in_range;
}
