// Kernels of tridiagonal systems. Included in the namespace of each set of instructions: see set.hpp.

/// Cubic functions at knots, by quotients of lengths, so that no product of knots leaves the numbers.
void knot_rows(const double* knots, std::size_t count, const TridiagonalRows& rows) {
  for (std::size_t i = 0; i < count; i += kWide) {
    // The last ones are written once more.
    const std::size_t first = i < count - kWide ? i : count - kWide;
    const auto knot = [&](std::ptrdiff_t k) { return load<WideLanes>(knots + static_cast<std::ptrdiff_t>(first) + k); };
    const WideLanes before = knot(0) - knot(-1);
    const WideLanes behind = knot(1) - knot(0);
    const WideLanes both = knot(1) - knot(-1);
    const WideLanes low = behind / both;
    const WideLanes high = before / both;
    const WideLanes three_low = knot(1) - knot(-2);
    const WideLanes three_high = knot(2) - knot(-1);
    const WideLanes at = low * ((knot(0) - knot(-2)) / three_low) + high * ((knot(2) - knot(0)) / three_high);
    store(low * (behind / three_low), rows.before + first);
    store(at, rows.at + first);
    store(high * (before / three_high), rows.after + first);
  }
}

/// Pivot i is the quotient of determinant i + 1 and determinant i: these follow from each other by products alone, and
/// no division waits for another. Every block begins with 1, lest they leave the numbers.
void eliminate(const TridiagonalRows& rows, std::size_t count, const double* right, double* factors, double* points) {
  constexpr std::size_t kBlock = 32;
  double minors[kBlock + 1];
  double inverses[kBlock];
  double shares[kBlock];
  Lanes value = load(points - 4);
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    const std::size_t some = count - begin < kBlock ? count - begin : kBlock;
    const double* const before = rows.before + begin;
    const double* const at = rows.at + begin;
    const double* const after = rows.after + begin;
    minors[0] = 1.0;
    minors[1] = at[0] - before[0] * factors[static_cast<std::ptrdiff_t>(begin) - 1];
    for (std::size_t i = 1; i < some; ++i) minors[i + 1] = at[i] * minors[i] - before[i] * after[i - 1] * minors[i - 1];
    for (std::size_t i = 0; i < some; ++i) inverses[i] = minors[i] / minors[i + 1];
    for (std::size_t i = 0; i < some; ++i) shares[i] = before[i] * inverses[i];
    for (std::size_t i = 0; i < some; ++i) factors[begin + i] = after[i] * inverses[i];
    for (std::size_t i = 0; i < some; ++i) {
      value = mul_add(all(-shares[i]), value, all(inverses[i]) * load(right + 3 * (begin + i)));
      store(value, points + 4 * (begin + i));
    }
  }
}

void substitute(const double* factors, std::size_t count, double* points) {
  Lanes value = load(points + 4 * count);
  for (std::size_t i = count; i-- > 0;) {
    value = mul_add(all(-factors[i]), value, load(points + 4 * i));
    store(__builtin_shufflevector(value, all(1.0), 0, 1, 2, 4), points + 4 * i);
  }
}

/// What is left of four rows' right sides, x, y and z.
SPLINECORE_INLINE Points four_left(const TridiagonalRows& rows, std::size_t i, const double* points, const double* right) {
  Lanes left[4];
  for (std::size_t k = 0; k < 4; ++k) {
    const double* const at = points + 4 * (i + k);
    const Lanes sum = mul_add(all(-rows.before[i + k]), load(at - 4), load(right + 3 * (i + k)));
    left[k] = mul_add(all(-rows.after[i + k]), load(at + 4), mul_add(all(-rows.at[i + k]), load(at), sum));
  }
  return transposed(left[0], left[1], left[2], left[3]);
}

double largest_left(const TridiagonalRows& rows, std::size_t count, const double* points, const double* right,
                    double scale) {
  Lanes largest = all(0.0);
  Lanes doubts = all(0.0);
  for (std::size_t i = 0; i < count; i += 4) {
    const Points left = four_left(rows, i < count - 4 ? i : count - 4, points, right);
    const Lanes x = all(scale) * left.x;
    const Lanes y = all(scale) * left.y;
    const Lanes z = all(scale) * left.z;
    const Lanes square = mul_add(x, x, mul_add(y, y, z * z));
    largest = square > largest ? square : largest;
    doubts = mul_add(square, all(0.0), doubts);
  }
  if (!is_certain(doubts)) return __builtin_inf();
  double most = largest[0];
  for (int lane = 1; lane < 4; ++lane) most = largest[lane] > most ? largest[lane] : most;
  return most;
}
