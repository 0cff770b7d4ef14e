// Kernels of B-spline functions. Included in the namespace of each set of instructions: see set.hpp.

inline constexpr int kMostDegree = 255;

/// What parts of the spans of four parameters lie before and behind them.
struct FourPlaces {
  Lanes t;
  Lanes s;
};

/// Numbers of up to four neighbors, of which lanes without one repeat the last.
struct FourNumbers {
  std::size_t of[4];

  SPLINECORE_INLINE FourNumbers(std::size_t first, std::size_t end) {
    for (std::size_t lane = 0; lane < 4; ++lane) of[lane] = first + lane < end ? first + lane : end - 1;
  }
};

/// @param rows  of the spans
SPLINECORE_INLINE FourPlaces four_places(const ScatteredSpans& at, const FourNumbers& numbers, const double** rows) {
  const std::size_t* const i = numbers.of;
  const auto ends_of = [&](int lane) { return load_pair(at.bounds + at.span[i[lane]]); };
  const auto [start, end] = columns(ends_of(0), ends_of(1), ends_of(2), ends_of(3));
  const Lanes u{at.u[i[0]], at.u[i[1]], at.u[i[2]], at.u[i[3]]};
  const Lanes length = end - start;
  for (int lane = 0; lane < 4; ++lane) {
    rows[lane] = at.table != nullptr ? at.table + at.size * static_cast<std::size_t>(at.span[i[lane]]) : at.rows[i[lane]];
  }
  return {(u - start) / length, (end - u) / length};
}

/// The Bernstein polynomials of a degree where t and s are the parts before and behind.
SPLINECORE_INLINE void bernstein(int degree, Lanes t, Lanes s, const double* choose, Lanes* out) {
  Lanes power = all(1.0);
  for (int i = 0; i <= degree; ++i, power *= t) out[i] = all(choose[i]) * power;
  power = s;
  for (int i = degree - 1; i >= 0; --i, power *= s) out[i] *= power;
}

/// Binomials, those of low degrees without a call.
SPLINECORE_INLINE const double* choices(int degree) {
  static constexpr double kFew[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
  return degree < 4 ? kFew[degree] : binomials(degree);
}

/// Of four parameters the Bernstein polynomials of degree - k, of which derivative k of the functions is a sum.
/// @param kDegree  0 for any
template <int kDegree, int kOrder>
struct FourBernstein {
  Lanes values[kOrder + 1][(kDegree > 0 ? kDegree : kMostDegree) + 1];
};

template <int kDegree, int kOrder>
SPLINECORE_INLINE void bernstein(int degree, const FourPlaces& places, FourBernstein<kDegree, kOrder>& out) {
  for (int k = 0; k <= kOrder && k <= degree; ++k) {
    bernstein(degree - k, places.t, places.s, choices(degree - k), out.values[k]);
  }
}

/// table_width(degree) numbers of derivative `order` in one of the lanes.
SPLINECORE_INLINE void functions_of(int degree, int order, const double* rows, const Lanes* values, int lane, double* out) {
  const std::size_t width = table_width(degree);
  for (int k = 0; k < order; ++k) rows += static_cast<std::size_t>(degree + 1 - k) * width;
  for (std::size_t i = 0; i < width; i += 4) {
    Lanes sum = all(0.0);
    if (order <= degree) sum = all(values[0][lane]) * load(rows + i);
    for (int k = 1; k <= degree - order; ++k) sum = mul_add(all(values[k][lane]), load(rows + i + k * width), sum);
    store(sum, out + i);
  }
}

template <int kOrder>
SPLINECORE_INLINE void functions_to(int degree, const ScatteredSpans& places, std::size_t count, double* out) {
  const std::size_t width = table_width(degree);
  FourBernstein<0, kOrder> values;
  for (std::size_t i = 0; i < count; i += 4) {
    const int lanes = count - i < 4 ? static_cast<int>(count - i) : 4;
    const double* rows[4];
    bernstein(degree, four_places(places, {i, count}, rows), values);
    for (int lane = 0; lane < lanes; ++lane) {
      for (int k = 0; k <= kOrder; ++k, out += width) {
        functions_of(degree, k, rows[lane], values.values[k], lane, out);
      }
    }
  }
}

void functions(int degree, int order, const ScatteredSpans& places, std::size_t count, double* out) {
  if (order == 0) return functions_to<0>(degree, places, count, out);
  if (order == 1) return functions_to<1>(degree, places, count, out);
  functions_to<2>(degree, places, count, out);
}
