// Kernels of lengths and areas. Included in the namespace of each set of instructions: see set.hpp.

using OwnPoints = PointsOf<OwnLanes>;

SPLINECORE_INLINE OwnLanes same(double value) { return all<OwnLanes>(value); }
SPLINECORE_INLINE OwnLanes loaded(const double* from) { return load<OwnLanes>(from); }

SPLINECORE_INLINE double sum_of(OwnLanes a) {
  double sum = a[0] + a[1];
  for (std::size_t i = 2; i < kOwn; i += 2) sum += a[i] + a[i + 1];
  return sum;
}

/// Nodes of a polynomial in Bernstein's form.
SPLINECORE_INLINE OwnPoints at_nodes(const double* functions, std::size_t width, int degree, const double* rows) {
  OwnPoints sum{};
  for (int k = 0; k <= degree; ++k, functions += width, rows += 4) {
    const OwnLanes function = loaded(functions);
    sum.x = mul_add(function, same(rows[0]), sum.x);
    sum.y = mul_add(function, same(rows[1]), sum.y);
    sum.z = mul_add(function, same(rows[2]), sum.z);
    sum.w = mul_add(function, same(rows[3]), sum.w);
  }
  return sum;
}

SPLINECORE_INLINE OwnLanes at_nodes_of_weight(const double* functions, std::size_t width, int degree,
                                           const double* weights) {
  OwnLanes sum = same(0.0);
  for (int k = 0; k <= degree; ++k, functions += width) sum = mul_add(loaded(functions), same(weights[k]), sum);
  return sum;
}

/// kSlopes and kWeight are degrees, or -1 for any; a weight of degree 0 is 1.
template <int kSlopes, int kWeight>
void speed_sums_of(const SpeedRule& rule, const double* slopes, const double* weights, double* out) {
  const int slopes_degree = kSlopes < 0 ? rule.slopes_degree : kSlopes;
  const int weight_degree = kWeight < 0 ? rule.weight_degree : kWeight;
  const std::size_t width = rule.nodes;
  OwnLanes length = same(0.0);
  OwnLanes change = same(0.0);
  OwnLanes terms = same(0.0);
  for (std::size_t i = 0; i < width; i += kOwn) {
    const OwnPoints slope = at_nodes(rule.slope_functions + i, width, slopes_degree, slopes);
    OwnLanes speed = square_root(mul_add(slope.x, slope.x, mul_add(slope.y, slope.y, slope.z * slope.z)));
    OwnLanes size = slope.w;
    if (weight_degree > 0) {
      const OwnLanes w = at_nodes_of_weight(rule.weight_functions + i, width, weight_degree, weights);
      const OwnLanes factor = same(1.0) / (w * w);
      speed *= factor;
      size *= factor;
    }
    const OwnLanes share = loaded(rule.shares + i);
    length = mul_add(share, speed, length);
    change = mul_add(loaded(rule.differences + i), speed, change);
    terms = mul_add(share, size, terms);
  }
  out[0] = sum_of(length);
  out[1] = sum_of(change);
  out[2] = sum_of(terms);
}

void speed_sums(const SpeedRule& rule, const double* slopes, const double* weights, double* out) {
  if (rule.slopes_degree == 2 && rule.weight_degree == 0) return speed_sums_of<2, 0>(rule, slopes, weights, out);
  if (rule.slopes_degree == 4 && rule.weight_degree == 3) return speed_sums_of<4, 3>(rule, slopes, weights, out);
  speed_sums_of<-1, -1>(rule, slopes, weights, out);
}

SPLINECORE_INLINE OwnPoints same_point(const double* p) { return {same(p[0]), same(p[1]), same(p[2]), same(0.0)}; }

SPLINECORE_INLINE OwnLanes length_of(const OwnPoints& a) {
  return square_root(mul_add(a.x, a.x, mul_add(a.y, a.y, a.z * a.z)));
}

/// A derivative, from the homogeneous one and the point.
SPLINECORE_INLINE OwnPoints slope_at(const OwnPoints& h, const OwnPoints& point, OwnLanes r) {
  return {mul_add(-h.w, point.x, h.x) * r, mul_add(-h.w, point.y, h.y) * r, mul_add(-h.w, point.z, h.z) * r, h.w};
}

SPLINECORE_INLINE OwnLanes dot_of(const OwnPoints& a, const OwnPoints& b) {
  return mul_add(a.x, b.x, mul_add(a.y, b.y, a.z * b.z));
}

SPLINECORE_INLINE OwnPoints cross_of(const OwnPoints& a, const OwnPoints& b) {
  return {mul_add(a.y, b.z, -(a.z * b.y)), mul_add(a.z, b.x, -(a.x * b.z)), mul_add(a.x, b.y, -(a.y * b.x)), a.w};
}

SPLINECORE_INLINE OwnLanes size_of(OwnLanes a) { return a > -a ? a : -a; }

/// How large a product may be with a vector of which the sizes of the coordinates are known.
SPLINECORE_INLINE OwnLanes cross_size(const OwnPoints& a, const OwnPoints& most) {
  return mul_add(size_of(a.x), most.y + most.z,
                 mul_add(size_of(a.y), most.z + most.x, size_of(a.z) * (most.x + most.y)));
}

/// What a rule adds up: a function, the difference to a rule with fewer nodes and the size of the terms.
struct RuleSums {
  OwnLanes value, change, terms;

  SPLINECORE_INLINE void add(OwnLanes function, OwnLanes size, OwnLanes share, OwnLanes difference) {
    value = mul_add(share, function, value);
    change = mul_add(difference, function, change);
    terms = mul_add(share, size, terms);
  }
  SPLINECORE_INLINE void write(double* out) const {
    out[0] = sum_of(value);
    out[1] = sum_of(change);
    out[2] = sum_of(terms);
  }
};

SPLINECORE_INLINE double largest_of(OwnLanes a) {
  double most = a[0];
  for (std::size_t i = 1; i < kOwn; ++i) most = a[i] > most ? a[i] : most;
  return most;
}

/// kDegree is the degree, or -1 for any.
template <int kDegree>
void surface_sums_of(const SurfaceRule& rule, const SurfaceRow& row, SurfaceSums* out) {
  const int degree = kDegree < 0 ? rule.degree : kDegree;
  const std::size_t width = rule.nodes;
  const OwnPoints origin = same_point(row.origin);
  const OwnPoints direction = same_point(row.direction);
  const OwnPoints most = same_point(row.extent);
  RuleSums area{};
  RuleSums volume{};
  OwnLanes against = same(0.0);
  for (std::size_t i = 0; i < width; i += kOwn) {
    const OwnPoints h = at_nodes(rule.values + i, width, degree, row.points);
    const OwnLanes r = same(1.0) / h.w;
    const OwnPoints point{h.x * r, h.y * r, h.z * r, h.w};
    const OwnPoints u = slope_at(at_nodes(rule.values + i, width, degree, row.slopes), point, r);
    const OwnPoints v = slope_at(at_nodes(rule.slopes + i, width, degree, row.points), point, r);
    const OwnPoints normal = cross_of(u, v);
    const OwnPoints place{point.x + origin.x, point.y + origin.y, point.z + origin.z, h.w};
    const OwnLanes reach = same(row.reach) * size_of(r);
    const OwnPoints extent{most.x + reach, most.y + reach, most.z + reach, h.w};
    const OwnLanes step = loaded(rule.steps + i);
    const OwnLanes terms = mul_add(cross_size(u, extent), step, cross_size(v, extent) * same(row.step));
    const OwnLanes share = loaded(rule.shares + i);
    const OwnLanes difference = loaded(rule.differences + i);
    area.add(length_of(normal), terms, share, difference);
    volume.add(dot_of(place, normal) * same(1.0 / 3.0), length_of(place) * terms, share, difference);
    const OwnLanes here = -dot_of(direction, normal);
    against = here > against ? here : against;
    if (i == 0) out->against_at_ends = largest_of(against);
  }
  area.write(out->area);
  volume.write(out->volume);
  out->against = largest_of(against);
}

void surface_sums(const SurfaceRule& rule, const SurfaceRow& row, SurfaceSums* out) {
  if (rule.degree == 3) return surface_sums_of<3>(rule, row, out);
  surface_sums_of<-1>(rule, row, out);
}
