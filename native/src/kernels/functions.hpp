// Kernels of B-spline functions. Included in the namespace of each set of instructions: see set.hpp.

/// The Bernstein polynomials of a degree where t and s are the parts before and behind.
SPLINECORE_INLINE void bernstein(int degree, double t, double s, const double* choose, double* out) {
  double power = 1.0;
  for (int i = 0; i <= degree; ++i, power *= t) out[i] = choose[i] * power;
  power = s;
  for (int i = degree - 1; i >= 0; --i, power *= s) out[i] *= power;
}

/// Binomials, those of low degrees without a call.
SPLINECORE_INLINE const double* choices(int degree) {
  static constexpr double kFew[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
  return degree < 4 ? kFew[degree] : binomials(degree);
}

/// Up to four functions of a place, one lane each.
SPLINECORE_INLINE Lanes function_lanes(const double* rows, std::size_t width, int degree, const double* bernstein) {
  Lanes sum = all(bernstein[0]) * load(rows);
  for (int k = 1; k <= degree; ++k) sum = mul_add(all(bernstein[k]), load(rows + k * width), sum);
  return sum;
}

inline constexpr int kMostDegree = 255;

/// table_width(degree) numbers of one derivative.
SPLINECORE_INLINE void functions_of(int degree, int order, const BasisPlace& place, double* out) {
  const std::size_t width = table_width(degree);
  if (order > degree) {
    for (std::size_t i = 0; i < width; i += 4) store(all(0.0), out + i);
    return;
  }
  double values[kMostDegree + 1];
  const double* rows = place.rows;
  for (int k = 0; k < order; ++k) rows += static_cast<std::size_t>(degree + 1 - k) * width;
  bernstein(degree - order, place.t, place.s, choices(degree - order), values);
  for (std::size_t i = 0; i < width; i += 4) {
    store(function_lanes(rows + i, width, degree - order, values), out + i);
  }
}

void functions(int degree, int order, const BasisPlace* places, std::size_t count, double* out) {
  const std::size_t width = table_width(degree);
  for (std::size_t i = 0; i < count; ++i) {
    for (int k = 0; k <= order; ++k, out += width) functions_of(degree, k, places[i], out);
  }
}
