// Kernels of curves. Included in the namespace of each set of instructions: see set.hpp.

/// Derivatives 0 … order of homogeneous points; derivative k without the factor f^(degree - k).
template <class V, int kOrder>
struct Derivatives {
  PointsOf<V> at[kOrder + 1];
};

SPLINECORE_INLINE std::ptrdiff_t rows_of(int degree, int k) { return degree - k < 0 ? 0 : degree + 1 - k; }

/// The first row of derivative k.
SPLINECORE_INLINE const double* first_row(const double* rows, int degree, int k) {
  for (int i = 0; i < k; ++i) rows += 4 * rows_of(degree, i);
  return rows;
}

SPLINECORE_INLINE Lanes horner(const double* rows, int degree, double x) {
  Lanes sum = load(rows + 4 * degree);
  for (int i = degree; i-- > 0;) sum = mul_add(sum, all(x), load(rows + 4 * i));
  return sum;
}

template <class V>
SPLINECORE_INLINE PointsOf<V> horner(const double* rows, int degree, V x, bool with_weight) {
  const double* row = rows + 4 * degree;
  PointsOf<V> sum{all<V>(row[0]), all<V>(row[1]), all<V>(row[2]), all<V>(row[3])};
  for (int i = degree; i-- > 0;) {
    row -= 4;
    sum.x = mul_add(sum.x, x, all<V>(row[0]));
    sum.y = mul_add(sum.y, x, all<V>(row[1]));
    sum.z = mul_add(sum.z, x, all<V>(row[2]));
    if (with_weight) sum.w = mul_add(sum.w, x, all<V>(row[3]));
  }
  return sum;
}

template <class V>
SPLINECORE_INLINE V power(V base, int exponent) {
  V result = all<V>(1.0);
  for (; exponent > 0; exponent >>= 1) {
    if (exponent & 1) result = result * base;
    base = base * base;
  }
  return result;
}

/// Points and derivatives from homogeneous ones (The NURBS Book, A4.2). @param x, f  of the place in the span
template <bool kRational, class V, int kOrder>
SPLINECORE_INLINE void project(Derivatives<V, kOrder>& d, V x, V f, int degree) {
  if constexpr (!kRational) {
    for (int k = 0; k <= kOrder; ++k) {
      const V factor = power(f, degree - k);
      d.at[k].x *= factor;
      d.at[k].y *= factor;
      d.at[k].z *= factor;
    }
  } else {
    const V weight = d.at[0].w;
    const V rough = rough_reciprocal(weight);
    PointsOf<V>& p = d.at[0];
    p.x = quotient(p.x, weight, rough);
    p.y = quotient(p.y, weight, rough);
    p.z = quotient(p.z, weight, rough);
    if constexpr (kOrder > 0) {
      const V r = nearer_reciprocal(weight, rough);
      // 1 / f is 1 + x.
      const V g = all<V>(1.0) + x;
      PointsOf<V>& q = d.at[1];
      const V slope_w = q.w;
      const PointsOf<V> t{mul_add(-slope_w, p.x, q.x) * r, mul_add(-slope_w, p.y, q.y) * r,
                     mul_add(-slope_w, p.z, q.z) * r, slope_w};
      q.x = t.x * g;
      q.y = t.y * g;
      q.z = t.z * g;
      if constexpr (kOrder > 1) {
        PointsOf<V>& c = d.at[2];
        const V double_slope = slope_w + slope_w;
        const V scale = r * (g * g);
        c.x = mul_add(-double_slope, t.x, mul_add(-c.w, p.x, c.x)) * scale;
        c.y = mul_add(-double_slope, t.y, mul_add(-c.w, p.y, c.y)) * scale;
        c.z = mul_add(-double_slope, t.z, mul_add(-c.w, p.z, c.z)) * scale;
      }
    }
  }
}

template <class V, int kOrder>
SPLINECORE_INLINE V doubt(V before, const Derivatives<V, kOrder>& d) {
  for (int k = 0; k <= kOrder; ++k) before = doubt(before, d.at[k].x, d.at[k].y, d.at[k].z);
  return before;
}

/// Writes four points with their derivatives: four numbers at once, of which the next three overwrite the last.
template <int kOrder, class Real>
SPLINECORE_INLINE void store_all(const Derivatives<Lanes, kOrder>& d, Real* out) {
  if constexpr (kOrder == 0) {
    store_triples(d.at[0].x, d.at[0].y, d.at[0].z, out);
  } else {
    Points rows[kOrder + 1];
    for (int k = 0; k <= kOrder; ++k) rows[k] = transposed(d.at[k].x, d.at[k].y, d.at[k].z, d.at[k].z);
    for (int k = 0; k <= kOrder; ++k) store(rows[k].x, out + 3 * k);
    out += 3 * (kOrder + 1);
    for (int k = 0; k <= kOrder; ++k) store(rows[k].y, out + 3 * k);
    out += 3 * (kOrder + 1);
    for (int k = 0; k <= kOrder; ++k) store(rows[k].z, out + 3 * k);
    out += 3 * (kOrder + 1);
    for (int k = 0; k < kOrder; ++k) store(rows[k].w, out + 3 * k);
    store_triple(rows[kOrder].w, out + 3 * kOrder);
  }
}

#if defined(SPLINECORE_WIDE_LANES)
template <int kOrder, class Real>
SPLINECORE_INLINE void store_all(const Derivatives<WideLanes, kOrder>& d, Real* out) {
  if constexpr (kOrder == 0) {
    store_triples(d.at[0].x, d.at[0].y, d.at[0].z, out);
  } else {
    Derivatives<Lanes, kOrder> low;
    Derivatives<Lanes, kOrder> high;
    for (int k = 0; k <= kOrder; ++k) {
      low.at[k] = {lower(d.at[k].x), lower(d.at[k].y), lower(d.at[k].z), Lanes{}};
      high.at[k] = {upper(d.at[k].x), upper(d.at[k].y), upper(d.at[k].z), Lanes{}};
    }
    store_all(low, out);
    store_all(high, out + 12 * (kOrder + 1));
  }
}
#endif

/// The part of the span that is left, as a factor. @param far  the way to the far end
template <bool kRational, class V>
SPLINECORE_INLINE V factor_left(V far, V whole) {
  return kRational ? far : far / whole;
}

/// Where parameters lie in their half, and what is left of the span before the far end.
template <class V>
struct Place {
  V x;
  V left;
  bool is_inside;
};

/// How many points are written, lanes at most, until the next one begins where a register may be stored without crossing
/// a line of the cache.
SPLINECORE_INLINE std::size_t points_to_line(const double* out) {
  const std::size_t behind = reinterpret_cast<std::uintptr_t>(out) / sizeof(double) % kWide;
  const std::size_t points = (kWide - behind) * 3 % kWide;  // 3 numbers each, and 3 · 3 is 1 modulo 4 and 8
  return points == 0 ? kWide : points;
}

template <int kDegree, bool kRational, int kOrder, class Real>
std::size_t run(const CurveForm& form, const CurveHalf& half, double low, double high, const double* u,
                std::size_t count, Real* out, int* found) {
  using V = WideLanes;
  const int degree = kDegree > 0 ? kDegree : form.degree;
  const V near = all<V>(half.near);
  const V far = all<V>(half.far);
  const double* rows[kOrder + 1];
  for (int k = 0; k <= kOrder; ++k) rows[k] = first_row(half.rows, degree, k);
  V doubts = all<V>(0.0);
  constexpr std::size_t kLong = 64;
  std::size_t i = 0;
  // Each place is found while the points before it are still on their way.
  const auto place = [&](std::size_t first) -> Place<V> {
    if (first + kWide > count) return {V{}, V{}, false};
    const V at = load<V>(u + first);
    const V left = far - at;
    return {(at - near) / left, left, is_between(low, high, at)};
  };
  std::size_t step = kWide;
  if constexpr (kOrder == 0 && sizeof(Real) == sizeof(double)) {
    // The first of many overlap the next ones.
    if (count > kLong && is_between(low, high, all<V>(u[kLong]))) step = points_to_line(out);
  }
  for (Place<V> next = place(0); next.is_inside; i += step, step = kWide) {
    const auto [x, left, is_inside] = next;
    next = place(i + step);
    Derivatives<V, kOrder> d;
    for (int k = 0; k <= kOrder; ++k) {
      d.at[k] = degree < k ? PointsOf<V>{} : horner(rows[k], degree - k, x, kRational);
    }
    project<kRational>(d, x, factor_left<kRational>(left, far - near), degree);
    doubts = doubt(doubts, d);
    ask_ahead<3 * (kOrder + 1) * kWide * sizeof(Real)>(out + 3 * (kOrder + 1) * i);
    store_all(d, out + 3 * (kOrder + 1) * i);
  }
  if (!is_certain(doubts)) *found |= kNotFinite;
  return i;
}

/// Up to four points from number i on; lanes without one repeat the first.
template <int kDegree, bool kRational, int kOrder>
SPLINECORE_INLINE Derivatives<Lanes, kOrder> four_scattered(int given, const ScatteredHalves& halves, std::size_t i,
                                                            int count) {
  const int degree = kDegree > 0 ? kDegree : given;
  const auto number = [&](int lane) { return count == 4 ? i + lane : i; };
  const auto half_of = [&](int lane) { return static_cast<std::size_t>(halves.half[number(lane)]); };
  const auto ends_of = [&](int lane) { return load_pair(halves.ends + 2 * half_of(lane)); };
  const auto [near, far] = columns(ends_of(0), ends_of(1), ends_of(2), ends_of(3));
  const Lanes at = count == 4 ? load(halves.u + i) : all(halves.u[i]);
  const Lanes left = far - at;
  const Lanes x = (at - near) / left;
  const double* rows[4];
  for (int lane = 0; lane < 4; ++lane) {
    rows[lane] = halves.table != nullptr ? halves.table + halves.size * half_of(lane) : halves.rows[number(lane)];
  }
  Derivatives<Lanes, kOrder> d;
  for (int k = 0; k <= kOrder; ++k) {
    if (degree < k) {
      d.at[k] = Points{};
      continue;
    }
    Lanes sums[4];
    for (int lane = 0; lane < 4; ++lane) sums[lane] = horner(first_row(rows[lane], degree, k), degree - k, x[lane]);
    d.at[k] = transposed(sums[0], sums[1], sums[2], sums[3]);
  }
  project<kRational>(d, x, factor_left<kRational>(left, far - near), degree);
  return d;
}

template <int kDegree, bool kRational, int kOrder, class Real>
int scattered(const CurveForm& form, const ScatteredHalves& halves, std::size_t begin, std::size_t end, Real* out) {
  Lanes doubts = all(0.0);
  std::size_t i = begin;
  for (; i + 4 <= end; i += 4, out += 12 * (kOrder + 1)) {
    const auto d = four_scattered<kDegree, kRational, kOrder>(form.degree, halves, i, 4);
    doubts = doubt(doubts, d);
    store_all(d, out);
  }
  for (; i < end; ++i, out += 3 * (kOrder + 1)) {
    const auto d = four_scattered<kDegree, kRational, kOrder>(form.degree, halves, i, 1);
    doubts = doubt(doubts, d);
    for (int k = 0; k <= kOrder; ++k) store_triples(d.at[k].x, d.at[k].y, d.at[k].z, 1, 0, out + 3 * k);
  }
  return is_certain(doubts) ? 0 : kNotFinite;
}

template <int kDegree, class Real>
std::size_t run_of_degree(const CurveForm& form, const CurveHalf& half, double low, double high, const double* u,
                          std::size_t count, Real* out, int* found) {
  const auto with = [&](auto work) { return work(form, half, low, high, u, count, out, found); };
  if (form.order == 0) return with(form.rational ? run<kDegree, true, 0, Real> : run<kDegree, false, 0, Real>);
  if (form.order == 1) return with(form.rational ? run<kDegree, true, 1, Real> : run<kDegree, false, 1, Real>);
  return with(form.rational ? run<kDegree, true, 2, Real> : run<kDegree, false, 2, Real>);
}

/// Cubics, which are most, have kernels of their own.
template <class Real>
std::size_t curve_run(const CurveForm& form, const CurveHalf& half, double low, double high, const double* u,
                      std::size_t count, Real* out, int* found) {
  return form.degree == 3 ? run_of_degree<3>(form, half, low, high, u, count, out, found)
                          : run_of_degree<0>(form, half, low, high, u, count, out, found);
}

template <int kDegree, class Real>
int scattered_of_degree(const CurveForm& form, const ScatteredHalves& halves, std::size_t begin, std::size_t end,
                        Real* out) {
  const auto with = [&](auto work) { return work(form, halves, begin, end, out); };
  if (form.order == 0) return with(form.rational ? scattered<kDegree, true, 0, Real> : scattered<kDegree, false, 0, Real>);
  if (form.order == 1) return with(form.rational ? scattered<kDegree, true, 1, Real> : scattered<kDegree, false, 1, Real>);
  return with(form.rational ? scattered<kDegree, true, 2, Real> : scattered<kDegree, false, 2, Real>);
}

template <class Real>
int curve_scattered(const CurveForm& form, const ScatteredHalves& halves, std::size_t begin, std::size_t end,
                    Real* out) {
  return form.degree == 3 ? scattered_of_degree<3>(form, halves, begin, end, out)
                          : scattered_of_degree<0>(form, halves, begin, end, out);
}
