// Kernels of pairs of parameters on patches. Included in the namespace of each set of instructions: see set.hpp.

/// The sum over a row of columns, each of them summed.
SPLINECORE_INLINE Lanes across_sum(const Lanes* columns, int degree, const double* functions) {
  Lanes sum = all(functions[0]) * columns[0];
  for (int j = 1; j <= degree; ++j) sum = mul_add(all(functions[j]), columns[j], sum);
  return sum;
}

SPLINECORE_INLINE void column_sums(const GridForm& form, const double* corner, const double* functions, Lanes* columns) {
  for (int j = 0; j <= form.degree_v; ++j) {
    columns[j] = column_sum(corner + 4 * j, 4 * form.width, form.degree_u, functions);
  }
}

void pair_sums(const GridForm& form, int order, const double* corner, const double* u, const double* v, double* out) {
  Lanes columns[kMostDegree + 1];
  for (int k = 0; k <= order; ++k) {
    column_sums(form, corner, u + k * table_width(form.degree_u), columns);
    for (int l = 0; l <= order; ++l, out += 4) {
      store(across_sum(columns, form.degree_v, v + l * table_width(form.degree_v)), out);
    }
  }
}

SPLINECORE_INLINE double size_of(const double* functions, int degree) {
  double sum = 0.0;
  for (int i = 0; i <= degree; ++i) sum += functions[i] < 0.0 ? -functions[i] : functions[i];
  return sum;
}

/// Functions and their derivatives 0 … kOrder at one parameter. @param kDegree  0 for any
template <int kDegree, int kOrder>
struct PairFunctions {
  double values[kOrder + 1][kDegree > 0 ? table_width(kDegree) : kMostDegree + 4];
};

/// Of up to four pairs: homogeneous points, derivatives along u and v, and what the slopes of the functions amount to.
struct FourPairs {
  Lanes point[4];
  Lanes along_u[4];
  Lanes along_v[4];
  double size_u[4];
  double size_v[4];
};

SPLINECORE_INLINE const double* corner_of(const GridForm& form, const ScatteredPairs& pairs, std::size_t i) {
  const auto first = [i](const ScatteredSpans& at, int degree) {
    return static_cast<std::size_t>(at.first_knots[at.span[i]] - degree);
  };
  return form.points + 4 * (first(pairs.u, form.degree_u) * form.width + first(pairs.v, form.degree_v));
}

SPLINECORE_INLINE Lanes sum_point(const GridForm& form, const double* corner, const double* u, const double* v) {
  const auto column = [&](int j) { return column_sum(corner + 4 * j, 4 * form.width, form.degree_u, u); };
  Lanes sum = all(v[0]) * column(0);
  for (int j = 1; j <= form.degree_v; ++j) sum = mul_add(all(v[j]), column(j), sum);
  return sum;
}

/// Two rows of functions, one for the low four numbers and one for the high. @param kDegree  3 at most, or 0 for any
template <int kDegree>
struct FunctionsTwice {
  const double* low;
  const double* high;
  Twice few;

  SPLINECORE_INLINE FunctionsTwice(const double* for_low, const double* for_high)
      : low(for_low), high(for_high), few(twice(load(for_low), load(for_high))) {}

  SPLINECORE_INLINE Twice at(int i) const { return kDegree > 0 ? spread(few, i) : twice(all(low[i]), all(high[i])); }
};

/// A column of points, and one of derivatives along u.
template <int kDegree>
SPLINECORE_INLINE Twice column_twice(const double* points, std::size_t stride, int degree, const FunctionsTwice<kDegree>& u) {
  Twice sum = u.at(0) * load_twice(points);
  for (int i = 1; i <= degree; ++i) sum = mul_add(u.at(i), load_twice(points + i * stride), sum);
  return sum;
}

template <int kDegree>
SPLINECORE_INLINE void sum_slopes(const GridForm& form, const double* corner, const PairFunctions<kDegree, 1>& at_u,
                                  const PairFunctions<kDegree, 1>& at_v, int lane, FourPairs& out) {
  const FunctionsTwice<kDegree> u(at_u.values[0], at_u.values[1]);
  const FunctionsTwice<kDegree> v(at_v.values[0], at_v.values[0]);
  const auto column = [&](int j) { return column_twice(corner + 4 * j, 4 * form.width, form.degree_u, u); };
  const Twice first = column(0);
  Twice sum = v.at(0) * first;
  Lanes along_v = all(at_v.values[1][0]) * lower(first);
  for (int j = 1; j <= form.degree_v; ++j) {
    const Twice next = column(j);
    sum = mul_add(v.at(j), next, sum);
    along_v = mul_add(all(at_v.values[1][j]), lower(next), along_v);
  }
  out.point[lane] = lower(sum);
  out.along_u[lane] = upper(sum);
  out.along_v[lane] = along_v;
}

/// What four pairs begin with.
template <int kDegree, int kOrder>
struct FourStarts {
  FourBernstein<kDegree, kOrder> u;
  FourBernstein<kDegree, kOrder> v;
  const double* rows_u[4];
  const double* rows_v[4];
  const double* corners[4];
};

/// Sums of pairs, four at once. The next ones are begun before, so that nothing waits for their divisions.
template <int kDegree, int kOrder>
class SumsOfPairs {
 public:
  SPLINECORE_INLINE SumsOfPairs(const GridForm& form, const ScatteredPairs& pairs, std::size_t count)
      : form_(form), pairs_(pairs), count_(count) {
    if (kDegree > 0) form_.degree_u = form_.degree_v = kDegree;
    if (count > 0) begin(0);
  }

  /// Of pairs from number i on, a multiple of four: each after the one before. Lanes without one repeat the last.
  SPLINECORE_INLINE void find(std::size_t i, FourPairs& out) {
    if (i + 4 < count_) begin(i + 4);
    const FourStarts<kDegree, kOrder>& at = starts_[i / 4 % 2];
    for (int lane = 0; lane < 4; ++lane) {
      PairFunctions<kDegree, kOrder> u;
      PairFunctions<kDegree, kOrder> v;
      for (int k = 0; k <= kOrder; ++k) {
        functions_of(form_.degree_u, k, at.rows_u[lane], at.u.values[k], lane, u.values[k]);
        functions_of(form_.degree_v, k, at.rows_v[lane], at.v.values[k], lane, v.values[k]);
      }
      if constexpr (kOrder == 0) {
        out.point[lane] = sum_point(form_, at.corners[lane], u.values[0], v.values[0]);
      } else {
        sum_slopes<kDegree>(form_, at.corners[lane], u, v, lane, out);
        out.size_u[lane] = size_of(u.values[1], form_.degree_u);
        out.size_v[lane] = size_of(v.values[1], form_.degree_v);
      }
    }
  }

 private:
  SPLINECORE_INLINE void begin(std::size_t i) {
    FourStarts<kDegree, kOrder>& at = starts_[i / 4 % 2];
    const FourNumbers numbers(i, count_);
    bernstein(form_.degree_u, four_places(pairs_.u, numbers, at.rows_u), at.u);
    bernstein(form_.degree_v, four_places(pairs_.v, numbers, at.rows_v), at.v);
    for (int lane = 0; lane < 4; ++lane) at.corners[lane] = corner_of(form_, pairs_, numbers.of[lane]);
  }

  GridForm form_;
  const ScatteredPairs& pairs_;
  std::size_t count_;
  FourStarts<kDegree, kOrder> starts_[2];
};

SPLINECORE_INLINE Points turned(const Lanes* sums) { return transposed(sums[0], sums[1], sums[2], sums[3]); }

template <int kDegree, bool kRational>
int pair_points_of(const GridForm& form, const ScatteredPairs& pairs, std::size_t count, double* out) {
  Lanes doubts = all(0.0);
  SumsOfPairs<kDegree, 0> sums(form, pairs, count);
  FourPairs d;
  for (std::size_t i = 0; i < count; i += 4) {
    const int lanes = count - i < 4 ? static_cast<int>(count - i) : 4;
    sums.find(i, d);
    Points p = turned(d.point);
    project_point<kRational>(p);
    doubts = doubt(doubts, p);
    store_block(p, lanes, count - i, out + 3 * i);
  }
  return is_certain(doubts) ? 0 : kNotFinite;
}

/// Three of four numbers; the fourth, too, where there is a place for it.
SPLINECORE_INLINE void store_triple(Lanes xyz, bool is_last, double* out) {
  if (is_last) return store_triple(xyz, out);
  store(xyz, out);
}

template <int kDegree, bool kRational>
int pair_slopes_of(const GridForm& form, const ScatteredPairs& pairs, std::size_t count, double* out) {
  Lanes doubts = all(0.0);
  SumsOfPairs<kDegree, 1> sums(form, pairs, count);
  FourPairs d;
  for (std::size_t i = 0; i < count; i += 4) {
    const int lanes = count - i < 4 ? static_cast<int>(count - i) : 4;
    sums.find(i, d);
    const Lanes weights = turned(d.point).w;
    const Lanes rough = rough_reciprocal(weights);
    const Lanes near = nearer_reciprocal(weights, rough);
    for (int lane = 0; lane < lanes; ++lane, out += 9) {
      Lanes point = d.point[lane];
      Lanes along_u = d.along_u[lane];
      Lanes along_v = d.along_v[lane];
      if (kRational) {
        point = quotient(point, all(weights[lane]), all(rough[lane]));
        along_u = mul_add(-all(along_u[3]), point, along_u) * all(near[lane]);
        along_v = mul_add(-all(along_v[3]), point, along_v) * all(near[lane]);
      }
      doubts = mul_add(point + (along_u + along_v), all(0.0), doubts);
      store(point, out);
      store(along_u, out + 3);
      store_triple(along_v, i + static_cast<std::size_t>(lane) + 1 == count, out + 6);
    }
  }
  return is_certain(doubts) ? 0 : kNotFinite;
}

template <int kDegree, bool kRational>
int pair_normals_of(const GridForm& form, const NormalForm& normal, const ScatteredPairs& pairs, std::size_t count,
                    double* out, double* normals) {
  Lanes doubts = all(0.0);
  Lanes weak = all(0.0);
  SumsOfPairs<kDegree, 1> sums(form, pairs, count);
  FourPairs d;
  for (std::size_t i = 0; i < count; i += 4) {
    const int lanes = count - i < 4 ? static_cast<int>(count - i) : 4;
    sums.find(i, d);
    Points point = turned(d.point);
    const Points along_u = turned(d.along_u);
    const Points along_v = turned(d.along_v);
    project_point<kRational>(point);
    const Lanes scale_u = all(normal.scale_u);
    const Lanes scale_v = all(normal.scale_v);
    const Points su = times(kRational ? beside(along_u, point) : along_u, scale_u);
    const Points sv = times(kRational ? beside(along_v, point) : along_v, scale_v);
    const Lanes size_u = load(d.size_u) * scale_u;
    const Lanes size_v = load(d.size_v) * scale_v;
    const Lanes plain = all(normal.rounding.plain) * (size_u * size_u) * (size_v * size_v);
    const Points n = normal_of(su, sv, plain, normal.rounding.of_points, size_u, size_v);
    doubts = doubt(doubts, point);
    weak += n.x;
    store_block(point, lanes, count - i, out + 3 * i);
    store_block(n, lanes, count - i, normals + 3 * i);
  }
  return (is_certain(doubts) ? 0 : kNotFinite) | (is_certain(weak) ? 0 : kWeakNormal);
}

SPLINECORE_INLINE bool is_bicubic(const GridForm& form) { return form.degree_u == 3 && form.degree_v == 3; }

int pair_points(const GridForm& form, const ScatteredPairs& pairs, std::size_t count, double* out) {
  const auto with = [&](auto work) { return work(form, pairs, count, out); };
  if (is_bicubic(form)) return with(form.rational ? pair_points_of<3, true> : pair_points_of<3, false>);
  return with(form.rational ? pair_points_of<0, true> : pair_points_of<0, false>);
}

int pair_slopes(const GridForm& form, const ScatteredPairs& pairs, std::size_t count, double* out) {
  const auto with = [&](auto work) { return work(form, pairs, count, out); };
  if (is_bicubic(form)) return with(form.rational ? pair_slopes_of<3, true> : pair_slopes_of<3, false>);
  return with(form.rational ? pair_slopes_of<0, true> : pair_slopes_of<0, false>);
}

int pair_normals(const GridForm& form, const NormalForm& normal, const ScatteredPairs& pairs, std::size_t count, double* out,
                 double* normals) {
  const auto with = [&](auto work) { return work(form, normal, pairs, count, out, normals); };
  if (is_bicubic(form)) return with(form.rational ? pair_normals_of<3, true> : pair_normals_of<3, false>);
  return with(form.rational ? pair_normals_of<0, true> : pair_normals_of<0, false>);
}
