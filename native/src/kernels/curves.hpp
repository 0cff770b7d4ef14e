// Kernels of curves. Included in the namespace of each set of instructions: see set.hpp.

/// Derivatives 0 … order of four homogeneous points; derivative k without the factor f^(degree - k).
template <int kOrder>
struct Derivatives {
  Points at[kOrder + 1];
};

inline std::ptrdiff_t rows_of(int degree, int k) { return degree - k < 0 ? 0 : degree + 1 - k; }

/// The first row of derivative k, counted from the near end.
inline const double* first_row(const double* rows, std::ptrdiff_t step, int degree, int k) {
  // Rows of all derivatives lie one after the other from the start of the span on.
  const std::ptrdiff_t forward = 4;
  if (step > 0) {
    for (int i = 0; i < k; ++i) rows += forward * rows_of(degree, i);
  } else {
    for (int i = 1; i <= k; ++i) rows += forward * rows_of(degree, i);
  }
  return rows;
}

inline Lanes horner(const double* row, std::ptrdiff_t step, int degree, double x) {
  row += step * degree;
  Lanes sum = load(row);
  for (int i = degree; i-- > 0;) {
    row -= step;
    sum = mul_add(sum, all(x), load(row));
  }
  return sum;
}

inline Points horner(const double* row, std::ptrdiff_t step, int degree, Lanes x, bool with_weight) {
  row += step * degree;
  Points sum{all(row[0]), all(row[1]), all(row[2]), all(row[3])};
  for (int i = degree; i-- > 0;) {
    row -= step;
    sum.x = mul_add(sum.x, x, all(row[0]));
    sum.y = mul_add(sum.y, x, all(row[1]));
    sum.z = mul_add(sum.z, x, all(row[2]));
    if (with_weight) sum.w = mul_add(sum.w, x, all(row[3]));
  }
  return sum;
}

inline Lanes power(Lanes base, int exponent) {
  Lanes result = all(1.0);
  for (; exponent > 0; exponent >>= 1) {
    if (exponent & 1) result = result * base;
    base = base * base;
  }
  return result;
}

/// Points and derivatives from homogeneous ones (The NURBS Book, A4.2). @param x, f  of the place in the span
template <bool kRational, int kOrder>
inline void project(Derivatives<kOrder>& d, Lanes x, Lanes f, int degree) {
  if constexpr (!kRational) {
    for (int k = 0; k <= kOrder; ++k) {
      const Lanes factor = power(f, degree - k);
      d.at[k].x *= factor;
      d.at[k].y *= factor;
      d.at[k].z *= factor;
    }
  } else {
    const Lanes weight = d.at[0].w;
    const Lanes r = all(1.0) / weight;
    Points& p = d.at[0];
    p.x = quotient(p.x, weight, r);
    p.y = quotient(p.y, weight, r);
    p.z = quotient(p.z, weight, r);
    if constexpr (kOrder > 0) {
      // 1 / f is 1 + x.
      const Lanes g = all(1.0) + x;
      Points& q = d.at[1];
      const Lanes slope_w = q.w;
      const Points t{mul_add(-slope_w, p.x, q.x) * r, mul_add(-slope_w, p.y, q.y) * r,
                     mul_add(-slope_w, p.z, q.z) * r, slope_w};
      q.x = t.x * g;
      q.y = t.y * g;
      q.z = t.z * g;
      if constexpr (kOrder > 1) {
        Points& c = d.at[2];
        const Lanes twice = slope_w + slope_w;
        const Lanes scale = r * (g * g);
        c.x = mul_add(-twice, t.x, mul_add(-c.w, p.x, c.x)) * scale;
        c.y = mul_add(-twice, t.y, mul_add(-c.w, p.y, c.y)) * scale;
        c.z = mul_add(-twice, t.z, mul_add(-c.w, p.z, c.z)) * scale;
      }
    }
  }
}

template <int kOrder>
inline Lanes doubt_of(const Derivatives<kOrder>& d) {
  Lanes sum = all(0.0);
  for (int k = 0; k <= kOrder; ++k) sum += doubt(d.at[k].x) + (doubt(d.at[k].y) + doubt(d.at[k].z));
  return sum;
}

template <int kOrder, class Real>
inline void store_points(const Derivatives<kOrder>& d, int count, Real* out) {
  if (kOrder == 0 && count == 4) return store_triples(d.at[0].x, d.at[0].y, d.at[0].z, out);
  for (int k = 0; k <= kOrder; ++k) {
    store_triples(d.at[k].x, d.at[k].y, d.at[k].z, count, 3 * (kOrder + 1), out + 3 * k);
  }
}

/// The part of the span that is left, as a factor. @param far  the way to the far end
template <bool kRational>
inline Lanes factor_left(Lanes far, Lanes whole) {
  return kRational ? far : far / whole;
}

template <int kDegree, bool kRational, int kOrder, class Real>
std::size_t run(const CurveForm& form, const CurveHalf& half, double low, double high, const double* u,
                std::size_t count, Real* out, int* found) {
  const int degree = kDegree > 0 ? kDegree : form.degree;
  const Lanes near = all(half.near);
  const Lanes far = all(half.far);
  const double* rows[kOrder + 1];
  for (int k = 0; k <= kOrder; ++k) rows[k] = first_row(half.rows, half.step, degree, k);
  Lanes doubts = all(0.0);
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) {
    const Lanes at = load(u + i);
    if (any(!((at > all(low)) & (at < all(high))))) break;
    const Lanes left = far - at;
    const Lanes x = (at - near) / left;
    Derivatives<kOrder> d;
    for (int k = 0; k <= kOrder; ++k) {
      d.at[k] = degree < k ? Points{} : horner(rows[k], half.step, degree - k, x, kRational);
    }
    project<kRational, kOrder>(d, x, factor_left<kRational>(left, far - near), degree);
    doubts += doubt_of(d);
    store_points(d, 4, out + 3 * (kOrder + 1) * i);
  }
  if (!is_certain(doubts)) *found |= kNotFinite;
  return i;
}

template <bool kRational, int kOrder, class Real>
int scattered(const CurveForm& form, const ScatteredHalves& halves, std::size_t count, Real* out) {
  Lanes doubts = all(0.0);
  for (std::size_t i = 0; i < count; i += 4) {
    const int lanes = count - i < 4 ? static_cast<int>(count - i) : 4;
    const Lanes near = load(halves.near + i);
    const Lanes far = load(halves.far + i);
    const Lanes at = load(halves.u + i);
    const Lanes left = far - at;
    const Lanes x = (at - near) / left;
    Derivatives<kOrder> d;
    for (int k = 0; k <= kOrder; ++k) {
      if (form.degree < k) {
        d.at[k] = Points{};
        continue;
      }
      Lanes sums[4];
      for (int lane = 0; lane < 4; ++lane) {
        const std::size_t j = lane < lanes ? i + lane : i;
        sums[lane] = horner(first_row(halves.rows[j], halves.step[j], form.degree, k), halves.step[j], form.degree - k,
                            x[lane < lanes ? lane : 0]);
      }
      d.at[k] = transposed(sums[0], sums[1], sums[2], sums[3]);
    }
    project<kRational, kOrder>(d, x, factor_left<kRational>(left, far - near), form.degree);
    const Lanes all_doubts = doubt_of(d);
    for (int lane = 0; lane < lanes; ++lane) doubts[lane] += all_doubts[lane];
    store_points(d, lanes, out + 3 * (kOrder + 1) * i);
  }
  return is_certain(doubts) ? 0 : kNotFinite;
}

template <class Real>
std::size_t curve_run(const CurveForm& form, const CurveHalf& half, double low, double high, const double* u,
                      std::size_t count, Real* out, int* found) {
  const auto with = [&](auto run_of) { return run_of(form, half, low, high, u, count, out, found); };
  if (form.order == 0 && form.degree == 3) return with(form.rational ? run<3, true, 0, Real> : run<3, false, 0, Real>);
  if (form.order == 0) return with(form.rational ? run<0, true, 0, Real> : run<0, false, 0, Real>);
  if (form.order == 1) return with(form.rational ? run<0, true, 1, Real> : run<0, false, 1, Real>);
  return with(form.rational ? run<0, true, 2, Real> : run<0, false, 2, Real>);
}

template <class Real>
int curve_scattered(const CurveForm& form, const ScatteredHalves& halves, std::size_t count, Real* out) {
  const auto with = [&](auto work) { return work(form, halves, count, out); };
  if (form.order == 0) return with(form.rational ? scattered<true, 0, Real> : scattered<false, 0, Real>);
  if (form.order == 1) return with(form.rational ? scattered<true, 1, Real> : scattered<false, 1, Real>);
  return with(form.rational ? scattered<true, 2, Real> : scattered<false, 2, Real>);
}

void curve_homogeneous(const CurveForm& form, const ScatteredHalves& halves, std::size_t count, double* out) {
  for (std::size_t i = 0; i < count; ++i) {
    const double left = halves.far[i] - halves.u[i];
    const double x = (halves.u[i] - halves.near[i]) / left;
    const Lanes sum = horner(first_row(halves.rows[i], halves.step[i], form.degree, 0), halves.step[i], form.degree, x);
    store(sum * power(all(left / (halves.far[i] - halves.near[i])), form.degree), out + 4 * i);
  }
}
