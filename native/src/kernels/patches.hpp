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
    if (blocks.is_far) ask_ahead<3 * kWide * sizeof(Real)>(out);
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
    if (blocks.is_far) {
      ask_ahead<3 * kWide * sizeof(Real)>(out);
      ask_ahead<3 * kWide * sizeof(Real)>(normals);
    }
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
