// Kernels of least squares. Included in the namespace of each set of instructions: see set.hpp.

// Sums are kept in registers, as many at once as one holds.
#if defined(SPLINECORE_WIDE_LANES)
typedef WideLanes SumLanes;
#else
typedef OwnLanes SumLanes;
#endif
inline constexpr std::size_t kSums = sizeof(SumLanes) / sizeof(double);

/// x, y, z of neighboring points, one lane each.
#if defined(SPLINECORE_WIDE_LANES)
SPLINECORE_INLINE void load_triples(const double* from, SumLanes* xyz) {
  const WideLanes a = load<WideLanes>(from);
  const WideLanes b = load<WideLanes>(from + 8);
  const WideLanes c = load<WideLanes>(from + 16);
  const WideLanes x = __builtin_shufflevector(a, b, 0, 3, 6, 9, 12, 15, 0, 0);
  const WideLanes y = __builtin_shufflevector(a, b, 1, 4, 7, 10, 13, 0, 0, 0);
  const WideLanes z = __builtin_shufflevector(a, b, 2, 5, 8, 11, 14, 0, 0, 0);
  xyz[0] = __builtin_shufflevector(x, c, 0, 1, 2, 3, 4, 5, 10, 13);
  xyz[1] = __builtin_shufflevector(y, c, 0, 1, 2, 3, 4, 8, 11, 14);
  xyz[2] = __builtin_shufflevector(z, c, 0, 1, 2, 3, 4, 9, 12, 15);
}
#elif defined(SPLINECORE_FOUR_LANES)
SPLINECORE_INLINE void load_triples(const double* from, SumLanes* xyz) {
  const Lanes a = load(from);                                      // x0 y0 z0 x1
  const Lanes b = load(from + 4);                                  // y1 z1 x2 y2
  const Lanes c = load(from + 8);                                  // z2 x3 y3 z3
  const Lanes first = __builtin_shufflevector(a, b, 0, 1, 6, 7);   // x0 y0 x2 y2
  const Lanes second = __builtin_shufflevector(a, c, 2, 3, 4, 5);  // z0 x1 z2 x3
  const Lanes third = __builtin_shufflevector(b, c, 0, 1, 6, 7);   // y1 z1 y3 z3
  xyz[0] = __builtin_shufflevector(first, second, 0, 5, 2, 7);
  xyz[1] = __builtin_shufflevector(first, third, 1, 4, 3, 6);
  xyz[2] = __builtin_shufflevector(second, third, 0, 5, 2, 7);
}
#else
SPLINECORE_INLINE void load_triples(const double* from, SumLanes* xyz) {
  for (int c = 0; c < 3; ++c) xyz[c] = SumLanes{from[c], from[c + 3]};
}
#endif

#if defined(SPLINECORE_WIDE_LANES)
SPLINECORE_INLINE double sum_of(SumLanes a) { return sum_of(lower(a) + upper(a)); }
#endif

/// t^j s^(degree - j), where t and s are the parts of a span before and behind a place.
template <int kDegree>
SPLINECORE_INLINE void power_products(SumLanes t, SumLanes s, SumLanes* out) {
  out[kDegree] = t;
  for (int j = 1; j <= kDegree; ++j) out[j] = j == 1 ? t : out[j - 1] * t;
  SumLanes power = s;
  for (int j = kDegree - 1; j > 0; --j, power *= s) out[j] *= power;
  out[0] = power;
}

/// The weight of points that have none.
struct NoWeight {};

SPLINECORE_INLINE SumLanes weighted(SumLanes weight, SumLanes value) { return weight * value; }
SPLINECORE_INLINE SumLanes weighted(NoWeight, SumLanes value) { return value; }
SPLINECORE_INLINE SumLanes weighted_sum(SumLanes weight, SumLanes value, SumLanes sum) { return mul_add(weight, value, sum); }
SPLINECORE_INLINE SumLanes weighted_sum(NoWeight, SumLanes value, SumLanes sum) { return value + sum; }

/// Calls `take` with t and s of kSums parameters, their weights and points.
template <class Weight, class Take>
SPLINECORE_INLINE void take_few(const SpanPoints& span, const double* u, Weight weight, const double* points, Take& take) {
  const SumLanes places = load<SumLanes>(u);
  const SumLanes share = all<SumLanes>(span.share);
  take((places - all<SumLanes>(span.start)) * share, (all<SumLanes>(span.end) - places) * share, weight, points);
}

/// Takes kSums points at a time of a span; those that the last ones are filled up with have the weight 0.
template <class Take>
SPLINECORE_INLINE void each_few(const SpanPoints& span, Take&& take) {
  const bool has_points = span.points != nullptr;
  const auto points_from = [&](std::size_t i) { return has_points ? span.points + 3 * i : nullptr; };
  const std::size_t whole = span.count - span.count % kSums;
  if (span.weights == nullptr) {
    for (std::size_t i = 0; i < whole; i += kSums) take_few(span, span.parameters + i, NoWeight{}, points_from(i), take);
  } else {
    for (std::size_t i = 0; i < whole; i += kSums) {
      const SumLanes weights = load<SumLanes>(span.weights + i) * all<SumLanes>(span.weight_scale);
      take_few(span, span.parameters + i, weights, points_from(i), take);
    }
  }
  if (whole == span.count) return;
  double parameters[kSums];
  double points[3 * kSums] = {};
  SumLanes weights{};
  for (std::size_t k = 0; k < kSums; ++k) {
    const bool is_there = whole + k < span.count;
    const std::size_t from = is_there ? whole + k : whole;
    parameters[k] = span.parameters[from];
    for (std::size_t c = 0; has_points && c < 3; ++c) points[3 * k + c] = span.points[3 * from + c];
    if (is_there) weights[k] = span.weights != nullptr ? span.weights[from] * span.weight_scale : 1.0;
  }
  take_few(span, parameters, weights, points, take);
}

template <int kDegree>
void power_sums(const SpanPoints& span, double* sums) {
  constexpr int kCount = 2 * kDegree + 1;
  SumLanes lanes[kCount] = {};
  each_few(span, [&](SumLanes t, SumLanes s, auto weight, const double*)
                     __attribute__((always_inline)) {
    SumLanes row[kCount];
    power_products<kCount - 1>(t, s, row);
    for (int k = 0; k < kCount; ++k) lanes[k] = weighted_sum(weight, row[k], lanes[k]);
  });
  for (int k = 0; k < kCount; ++k) sums[k] = sum_of(lanes[k]);
}

template <int kDegree>
double residual_sums(const SpanPoints& span, const double* piece, double* sums) {
  constexpr int kCount = kDegree + 1;
  SumLanes lanes[kCount][3] = {};
  SumLanes most{};
  each_few(span, [&](SumLanes t, SumLanes s, auto weight, const double* points)
                     __attribute__((always_inline)) {
    SumLanes row[kCount];
    power_products<kDegree>(t, s, row);
    SumLanes left[3];
    load_triples(points, left);
    for (int j = 0; j < kCount; ++j) {
      for (int c = 0; c < 3; ++c) left[c] = mul_add(row[j], all<SumLanes>(piece[3 * j + c]), left[c]);
    }
    for (int j = 0; j < kCount; ++j) {
      const SumLanes factor = weighted(weight, row[j]);
      for (int c = 0; c < 3; ++c) lanes[j][c] = mul_add(factor, left[c], lanes[j][c]);
    }
    const SumLanes scale = all<SumLanes>(span.scale);
    SumLanes square = all<SumLanes>(0.0);
    for (int c = 0; c < 3; ++c) square = mul_add(left[c] * scale, left[c] * scale, square);
    most = square > most ? square : most;
  });
  for (int j = 0; j < kCount; ++j) {
    for (int c = 0; c < 3; ++c) sums[3 * j + c] = sum_of(lanes[j][c]);
  }
  double largest = most[0];
  for (std::size_t k = 1; k < kSums; ++k) largest = most[k] > largest ? most[k] : largest;
  return largest;
}
