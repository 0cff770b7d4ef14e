// Kernels of patches. Included in the namespace of each set of instructions: see set.hpp.

using WidePoints = PointsOf<WideLanes>;

/// The point of a row that one column of points is summed to. Terms are added in one order everywhere, so that a pair
/// of parameters gives the same bits alone and in any grid.
SPLINECORE_INLINE Lanes column_sum(const double* points, std::size_t stride, int degree, const double* functions) {
  Lanes sum = all(functions[0]) * load(points);
  for (int i = 1; i <= degree; ++i) sum = mul_add(all(functions[i]), load(points + i * stride), sum);
  return sum;
}

/// The sum of a row's points for the parameters of a block.
template <bool kRational>
SPLINECORE_INLINE WidePoints row_sum(const double* row, int degree, const double* functions) {
  const auto everywhere = [](double value) { return all<WideLanes>(value); };
  WideLanes f = load<WideLanes>(functions);
  WidePoints sum{f * everywhere(row[0]), f * everywhere(row[1]), f * everywhere(row[2]),
                 kRational ? f * everywhere(row[3]) : everywhere(1.0)};
  for (int j = 1; j <= degree; ++j) {
    row += 4;
    f = load<WideLanes>(functions + kWide * j);
    sum.x = mul_add(f, everywhere(row[0]), sum.x);
    sum.y = mul_add(f, everywhere(row[1]), sum.y);
    sum.z = mul_add(f, everywhere(row[2]), sum.z);
    if (kRational) sum.w = mul_add(f, everywhere(row[3]), sum.w);
  }
  return sum;
}

/// And the one of other functions, which agree with the row's points.
template <bool kRational>
SPLINECORE_INLINE void row_sums(const double* row, int degree, const double* values, const double* slopes, WidePoints& p,
                                WidePoints& d) {
  const auto everywhere = [](double value) { return all<WideLanes>(value); };
  WidePoints point{everywhere(row[0]), everywhere(row[1]), everywhere(row[2]), everywhere(row[3])};
  WideLanes f = load<WideLanes>(values);
  WideLanes g = load<WideLanes>(slopes);
  p = {f * point.x, f * point.y, f * point.z, kRational ? f * point.w : everywhere(1.0)};
  d = {g * point.x, g * point.y, g * point.z, kRational ? g * point.w : everywhere(1.0)};
  for (int j = 1; j <= degree; ++j) {
    row += 4;
    point = {everywhere(row[0]), everywhere(row[1]), everywhere(row[2]), everywhere(row[3])};
    f = load<WideLanes>(values + kWide * j);
    g = load<WideLanes>(slopes + kWide * j);
    p.x = mul_add(f, point.x, p.x);
    p.y = mul_add(f, point.y, p.y);
    p.z = mul_add(f, point.z, p.z);
    d.x = mul_add(g, point.x, d.x);
    d.y = mul_add(g, point.y, d.y);
    d.z = mul_add(g, point.z, d.z);
    if (kRational) p.w = mul_add(f, point.w, p.w);
    if (kRational) d.w = mul_add(g, point.w, d.w);
  }
}

template <int kDegree, bool kSlopes>
SPLINECORE_INLINE void collapse_of(const GridForm& form, const GridRow& row, const GridBlocks& blocks,
                                   double* scratch) {
  const int degree = kDegree > 0 ? kDegree : form.degree_u;
  const std::size_t stride = 4 * form.width;
  for (std::size_t r = 0; r < blocks.range_count; ++r) {
    const double* points = form.points + row.first * stride + 4 * blocks.ranges[r].first;
    for (std::size_t j = 0; j < blocks.ranges[r].count; ++j, points += 4, scratch += 4) {
      const Lanes value = column_sum(points, stride, degree, row.values);
      if (kSlopes) store(column_sum(points, stride, degree, row.slopes), scratch + 4 * blocks.width);
      store(value, scratch);
    }
  }
}

/// The points of a row that blocks need, x, y, z, w each, and behind them those of the slopes.
template <bool kSlopes>
SPLINECORE_INLINE void collapse(const GridForm& form, const GridRow& row, const GridBlocks& blocks, double* scratch) {
  if (form.degree_u == 3) return collapse_of<3, kSlopes>(form, row, blocks, scratch);
  collapse_of<0, kSlopes>(form, row, blocks, scratch);
}

template <bool kRational, class V>
SPLINECORE_INLINE void project_point(PointsOf<V>& p) {
  if (!kRational) return;
  const V r = rough_reciprocal(p.w);
  p.x = quotient(p.x, p.w, r);
  p.y = quotient(p.y, p.w, r);
  p.z = quotient(p.z, p.w, r);
}

template <class V>
SPLINECORE_INLINE V doubt(V before, const PointsOf<V>& p) {
  return doubt(before, p.x, p.y, p.z);
}

/// Writes the first of the points, and perhaps what the next block overwrites. @param left  points that have a place
template <class V, class Real>
SPLINECORE_INLINE void store_block(const PointsOf<V>& p, int count, std::size_t left, Real* out) {
  if (left * sizeof(double) >= sizeof(V)) {
    store_triples(p.x, p.y, p.z, out);
  } else {
    store_triples(p.x, p.y, p.z, count, 3, out);
  }
}

template <int kDegree, bool kRational, class Real>
int grid_points_of(const GridForm& form, const GridRow& row, const GridBlocks& blocks, double* scratch, Real* out) {
  const int degree = kDegree > 0 ? kDegree : form.degree_v;
  collapse<false>(form, row, blocks, scratch);
  WideLanes doubts = all<WideLanes>(0.0);
  std::size_t left = blocks.columns;
  for (std::size_t b = 0; b < blocks.count; ++b) {
    const GridBlock& block = blocks.blocks[b];
    WidePoints p = row_sum<kRational>(scratch + 4 * block.first, degree, block.values);
    project_point<kRational>(p);
    doubts = doubt(doubts, p);
    store_block(p, block.count, left, out);
    left -= block.count;
    out += 3 * block.count;
  }
  return is_certain(doubts) ? 0 : kNotFinite;
}

/// What is left of a derivative where the part along the point itself is taken away.
template <class V>
SPLINECORE_INLINE PointsOf<V> beside(const PointsOf<V>& slope, const PointsOf<V>& point) {
  return {mul_add(-slope.w, point.x, slope.x), mul_add(-slope.w, point.y, slope.y), mul_add(-slope.w, point.z, slope.z),
          slope.w};
}

template <class V>
SPLINECORE_INLINE PointsOf<V> times(const PointsOf<V>& p, V factor) {
  return {p.x * factor, p.y * factor, p.z * factor, p.w};
}

/// The unit vector across two derivatives, NaN where their rounding may have made it.
/// @param plain  so large is its square where it cannot be rounding
/// @param rounding  of a point @param size_a  of the slopes
template <class V>
SPLINECORE_INLINE PointsOf<V> normal_of(const PointsOf<V>& a, const PointsOf<V>& b, V plain, double rounding, V size_a,
                                        V size_b) {
  PointsOf<V> n{mul_add(a.y, b.z, -(a.z * b.y)), mul_add(a.z, b.x, -(a.x * b.z)), mul_add(a.x, b.y, -(a.y * b.x)),
                all<V>(0.0)};
  const auto square = [](const PointsOf<V>& p) { return mul_add(p.x, p.x, mul_add(p.y, p.y, p.z * p.z)); };
  const V length = square(n);
  V scale = reciprocal_root(length);
  if (is_any_at_most(length, plain)) {
    const V noise_a = all<V>(rounding) * size_a;
    const V noise_b = all<V>(rounding) * size_b;
    const V noise = mul_add(square(a), noise_b * noise_b, square(b) * (noise_a * noise_a));
    constexpr double kClear = 0x1p48;
    scale = length > all<V>(kClear) * noise ? scale : all<V>(__builtin_nan(""));
  }
  n.x *= scale;
  n.y *= scale;
  n.z *= scale;
  return n;
}

template <int kDegree, bool kRational, class Real>
int grid_normals_of(const GridForm& form, const GridRow& row, const GridBlocks& blocks, double* scratch, Real* out,
                    Real* normals) {
  const int degree = kDegree > 0 ? kDegree : form.degree_v;
  double* const slope_row = scratch + 4 * blocks.width;
  collapse<true>(form, row, blocks, scratch);
  WideLanes doubts = all<WideLanes>(0.0);
  WideLanes weak = all<WideLanes>(0.0);
  const WideLanes plain = all<WideLanes>(row.rounding.plain * (row.size * row.size));
  std::size_t left = blocks.columns;
  for (std::size_t b = 0; b < blocks.count; ++b) {
    const GridBlock& block = blocks.blocks[b];
    const std::size_t first = 4 * block.first;
    WidePoints p;
    WidePoints sv;
    row_sums<kRational>(scratch + first, degree, block.values, block.slopes, p, sv);
    WidePoints su = row_sum<kRational>(slope_row + first, degree, block.values);
    project_point<kRational>(p);
    if (kRational) {
      su = beside(su, p);
      sv = beside(sv, p);
    }
    const WideLanes sizes = load<WideLanes>(block.sizes);
    const WidePoints n =
        normal_of(su, sv, plain * (sizes * sizes), row.rounding.of_points, all<WideLanes>(row.size), sizes);
    doubts = doubt(doubts, p);
    weak += n.x;
    store_block(p, block.count, left, out);
    store_block(n, block.count, left, normals);
    left -= block.count;
    out += 3 * block.count;
    normals += 3 * block.count;
  }
  return (is_certain(doubts) ? 0 : kNotFinite) | (is_certain(weak) ? 0 : kWeakNormal);
}

template <class Real>
int grid_points(const GridForm& form, const GridRow& row, const GridBlocks& blocks, double* scratch, Real* out) {
  const auto with = [&](auto work) { return work(form, row, blocks, scratch, out); };
  if (form.degree_v == 3) return with(form.rational ? grid_points_of<3, true, Real> : grid_points_of<3, false, Real>);
  return with(form.rational ? grid_points_of<0, true, Real> : grid_points_of<0, false, Real>);
}

template <class Real>
int grid_normals(const GridForm& form, const GridRow& row, const GridBlocks& blocks, double* scratch, Real* out,
                 Real* normals) {
  const auto with = [&](auto work) { return work(form, row, blocks, scratch, out, normals); };
  if (form.degree_v == 3) return with(form.rational ? grid_normals_of<3, true, Real> : grid_normals_of<3, false, Real>);
  return with(form.rational ? grid_normals_of<0, true, Real> : grid_normals_of<0, false, Real>);
}

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

/// Functions and their derivatives 0 … kOrder at one parameter.
template <int kOrder>
struct PairFunctions {
  double values[kOrder + 1][kMostDegree + 4];
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
    return static_cast<std::size_t>(at.knots[at.span[i]] - degree);
  };
  return form.points + 4 * (first(pairs.u, form.degree_u) * form.width + first(pairs.v, form.degree_v));
}

SPLINECORE_INLINE Lanes sum_point(const GridForm& form, const double* corner, const double* u, const double* v) {
  const auto column = [&](int j) { return column_sum(corner + 4 * j, 4 * form.width, form.degree_u, u); };
  Lanes sum = all(v[0]) * column(0);
  for (int j = 1; j <= form.degree_v; ++j) sum = mul_add(all(v[j]), column(j), sum);
  return sum;
}

/// Functions of a parameter and their derivatives, in the two halves. @param kDegree  3 at most, or 0 for any
template <int kDegree>
struct FunctionsTwice {
  const double* values;
  const double* slopes;
  Twice few;

  SPLINECORE_INLINE FunctionsTwice(const double* low, const double* high)
      : values(low), slopes(high), few(twice(load(low), load(high))) {}

  SPLINECORE_INLINE Twice at(int i) const {
    return kDegree > 0 ? spread(few, i) : twice(all(values[i]), all(slopes[i]));
  }
};

/// A column of points, and one of derivatives along u.
template <int kDegree>
SPLINECORE_INLINE Twice column_sums(const double* points, std::size_t stride, int degree, const FunctionsTwice<kDegree>& u) {
  Twice sum = u.at(0) * load_twice(points);
  for (int i = 1; i <= degree; ++i) sum = mul_add(u.at(i), load_twice(points + i * stride), sum);
  return sum;
}

template <int kDegree>
SPLINECORE_INLINE void sum_slopes(const GridForm& form, const double* corner, const PairFunctions<1>& at_u,
                                  const PairFunctions<1>& at_v, int lane, FourPairs& out) {
  const FunctionsTwice<kDegree> u(at_u.values[0], at_u.values[1]);
  const FunctionsTwice<kDegree> v(at_v.values[0], at_v.values[0]);
  const auto column = [&](int j) { return column_sums(corner + 4 * j, 4 * form.width, form.degree_u, u); };
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
template <int kOrder>
struct FourStarts {
  FourBernstein<kOrder> u;
  FourBernstein<kOrder> v;
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
    const FourStarts<kOrder>& at = starts_[i / 4 % 2];
    for (int lane = 0; lane < 4; ++lane) {
      PairFunctions<kOrder> u;
      PairFunctions<kOrder> v;
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
    FourStarts<kOrder>& at = starts_[i / 4 % 2];
    const FourNumbers numbers(i, count_);
    bernstein(form_.degree_u, four_places(pairs_.u, numbers, at.rows_u), at.u);
    bernstein(form_.degree_v, four_places(pairs_.v, numbers, at.rows_v), at.v);
    for (int lane = 0; lane < 4; ++lane) at.corners[lane] = corner_of(form_, pairs_, numbers.of[lane]);
  }

  GridForm form_;
  const ScatteredPairs& pairs_;
  std::size_t count_;
  FourStarts<kOrder> starts_[2];
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
