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
    WidePoints p = row_sum<kRational>(scratch + first, degree, block.values);
    WidePoints su = row_sum<kRational>(slope_row + first, degree, block.values);
    WidePoints sv = row_sum<kRational>(scratch + first, degree, block.slopes);
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

/// The functions of a pair of parameters.
template <int kOrder>
struct PairFunctions {
  double u[kOrder + 1][kMostDegree + 4];
  double v[kOrder + 1][kMostDegree + 4];
};

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

/// Of up to four pairs: homogeneous points, derivatives along u and v, and what the slopes of the functions amount to.
struct FourPairs {
  Points point;
  Points along_u;
  Points along_v;
  Lanes size_u;
  Lanes size_v;
};

SPLINECORE_INLINE double size_of(const double* functions, int degree) {
  double sum = 0.0;
  for (int i = 0; i <= degree; ++i) sum += functions[i] < 0.0 ? -functions[i] : functions[i];
  return sum;
}

template <int kDegree, int kOrder>
SPLINECORE_INLINE FourPairs four_pairs(const GridForm& given, const PairPlace* pairs, int lanes) {
  GridForm form = given;
  if (kDegree > 0) form.degree_u = form.degree_v = kDegree;
  PairFunctions<kOrder> functions;
  Lanes columns[kMostDegree + 1];
  Lanes points[4];
  Lanes along_u[4];
  Lanes along_v[4];
  Lanes size_u = all(0.0);
  Lanes size_v = all(0.0);
  for (int lane = 0; lane < 4; ++lane) {
    // Lanes without a pair repeat the last one.
    const PairPlace& pair = pairs[lane < lanes ? lane : lanes - 1];
    for (int k = 0; k <= kOrder; ++k) {
      functions_of(form.degree_u, k, pair.u, functions.u[k]);
      functions_of(form.degree_v, k, pair.v, functions.v[k]);
    }
    column_sums(form, pair.corner, functions.u[0], columns);
    points[lane] = across_sum(columns, form.degree_v, functions.v[0]);
    if constexpr (kOrder > 0) {
      along_v[lane] = across_sum(columns, form.degree_v, functions.v[1]);
      column_sums(form, pair.corner, functions.u[1], columns);
      along_u[lane] = across_sum(columns, form.degree_v, functions.v[0]);
      size_u[lane] = size_of(functions.u[1], form.degree_u);
      size_v[lane] = size_of(functions.v[1], form.degree_v);
    }
  }
  const auto turned = [](const Lanes* sums) { return transposed(sums[0], sums[1], sums[2], sums[3]); };
  if constexpr (kOrder == 0) return {turned(points), Points{}, Points{}, size_u, size_v};
  return {turned(points), turned(along_u), turned(along_v), size_u, size_v};
}

template <int kDegree, bool kRational>
int pair_points_of(const GridForm& form, const PairPlace* pairs, std::size_t count, double* out) {
  Lanes doubts = all(0.0);
  for (std::size_t i = 0; i < count; i += 4) {
    const int lanes = count - i < 4 ? static_cast<int>(count - i) : 4;
    Points p = four_pairs<kDegree, 0>(form, pairs + i, lanes).point;
    project_point<kRational>(p);
    doubts = doubt(doubts, p);
    store_block(p, lanes, count - i, out + 3 * i);
  }
  return is_certain(doubts) ? 0 : kNotFinite;
}

template <int kDegree, bool kRational>
int pair_slopes_of(const GridForm& form, const PairPlace* pairs, std::size_t count, double* out) {
  Lanes doubts = all(0.0);
  for (std::size_t i = 0; i < count; i += 4) {
    const int lanes = count - i < 4 ? static_cast<int>(count - i) : 4;
    FourPairs d = four_pairs<kDegree, 1>(form, pairs + i, lanes);
    const Lanes r = reciprocal(d.point.w);
    project_point<kRational>(d.point);
    if (kRational) {
      d.along_u = times(beside(d.along_u, d.point), r);
      d.along_v = times(beside(d.along_v, d.point), r);
    }
    doubts = doubt(doubt(doubt(doubts, d.point), d.along_u), d.along_v);
    double* const to = out + 9 * i;
    store_triples(d.point.x, d.point.y, d.point.z, lanes, 9, to);
    store_triples(d.along_u.x, d.along_u.y, d.along_u.z, lanes, 9, to + 3);
    store_triples(d.along_v.x, d.along_v.y, d.along_v.z, lanes, 9, to + 6);
  }
  return is_certain(doubts) ? 0 : kNotFinite;
}

template <int kDegree, bool kRational>
int pair_normals_of(const GridForm& form, const NormalForm& normal, const PairPlace* pairs, std::size_t count, double* out,
                    double* normals) {
  Lanes doubts = all(0.0);
  Lanes weak = all(0.0);
  for (std::size_t i = 0; i < count; i += 4) {
    const int lanes = count - i < 4 ? static_cast<int>(count - i) : 4;
    FourPairs d = four_pairs<kDegree, 1>(form, pairs + i, lanes);
    project_point<kRational>(d.point);
    const Lanes scale_u = all(normal.scale_u);
    const Lanes scale_v = all(normal.scale_v);
    const Points su = times(kRational ? beside(d.along_u, d.point) : d.along_u, scale_u);
    const Points sv = times(kRational ? beside(d.along_v, d.point) : d.along_v, scale_v);
    const Lanes size_u = d.size_u * scale_u;
    const Lanes size_v = d.size_v * scale_v;
    const Lanes plain = all(normal.rounding.plain) * (size_u * size_u) * (size_v * size_v);
    const Points n = normal_of(su, sv, plain, normal.rounding.of_points, size_u, size_v);
    doubts = doubt(doubts, d.point);
    weak += n.x;
    store_block(d.point, lanes, count - i, out + 3 * i);
    store_block(n, lanes, count - i, normals + 3 * i);
  }
  return (is_certain(doubts) ? 0 : kNotFinite) | (is_certain(weak) ? 0 : kWeakNormal);
}

SPLINECORE_INLINE bool is_bicubic(const GridForm& form) { return form.degree_u == 3 && form.degree_v == 3; }

int pair_points(const GridForm& form, const PairPlace* pairs, std::size_t count, double* out) {
  const auto with = [&](auto work) { return work(form, pairs, count, out); };
  if (is_bicubic(form)) return with(form.rational ? pair_points_of<3, true> : pair_points_of<3, false>);
  return with(form.rational ? pair_points_of<0, true> : pair_points_of<0, false>);
}

int pair_slopes(const GridForm& form, const PairPlace* pairs, std::size_t count, double* out) {
  const auto with = [&](auto work) { return work(form, pairs, count, out); };
  if (is_bicubic(form)) return with(form.rational ? pair_slopes_of<3, true> : pair_slopes_of<3, false>);
  return with(form.rational ? pair_slopes_of<0, true> : pair_slopes_of<0, false>);
}

int pair_normals(const GridForm& form, const NormalForm& normal, const PairPlace* pairs, std::size_t count, double* out,
                 double* normals) {
  const auto with = [&](auto work) { return work(form, normal, pairs, count, out, normals); };
  if (is_bicubic(form)) return with(form.rational ? pair_normals_of<3, true> : pair_normals_of<3, false>);
  return with(form.rational ? pair_normals_of<0, true> : pair_normals_of<0, false>);
}
