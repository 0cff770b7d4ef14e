// Kernels of lengths and areas. Included in the namespace of each set of instructions: see set.hpp.

SPLINECORE_INLINE double sum_of(Lanes a) { return (a[0] + a[1]) + (a[2] + a[3]); }

/// Four nodes of a polynomial in Bernstein's form.
SPLINECORE_INLINE Points at_nodes(const double* functions, std::size_t width, int degree, const double* rows) {
  Points sum{};
  for (int k = 0; k <= degree; ++k, functions += width, rows += 4) {
    const Lanes function = load(functions);
    sum.x = mul_add(function, all(rows[0]), sum.x);
    sum.y = mul_add(function, all(rows[1]), sum.y);
    sum.z = mul_add(function, all(rows[2]), sum.z);
    sum.w = mul_add(function, all(rows[3]), sum.w);
  }
  return sum;
}

SPLINECORE_INLINE Lanes at_nodes_of_weight(const double* functions, std::size_t width, int degree,
                                           const double* weights) {
  Lanes sum = all(0.0);
  for (int k = 0; k <= degree; ++k, functions += width) sum = mul_add(load(functions), all(weights[k]), sum);
  return sum;
}

/// kSlopes and kWeight are degrees, or -1 for any; a weight of degree 0 is 1.
template <int kSlopes, int kWeight>
void speed_sums_of(const SpeedRule& rule, const double* slopes, const double* weights, double* out) {
  const int slopes_degree = kSlopes < 0 ? rule.slopes_degree : kSlopes;
  const int weight_degree = kWeight < 0 ? rule.weight_degree : kWeight;
  const std::size_t width = rule.nodes;
  Lanes length = all(0.0);
  Lanes change = all(0.0);
  Lanes terms = all(0.0);
  for (std::size_t i = 0; i < width; i += 4) {
    const Points slope = at_nodes(rule.slope_functions + i, width, slopes_degree, slopes);
    Lanes speed = square_root(mul_add(slope.x, slope.x, mul_add(slope.y, slope.y, slope.z * slope.z)));
    Lanes size = slope.w;
    if (weight_degree > 0) {
      const Lanes w = at_nodes_of_weight(rule.weight_functions + i, width, weight_degree, weights);
      const Lanes factor = all(1.0) / (w * w);
      speed *= factor;
      size *= factor;
    }
    const Lanes share = load(rule.shares + i);
    length = mul_add(share, speed, length);
    change = mul_add(load(rule.differences + i), speed, change);
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

SPLINECORE_INLINE Lanes length_of(const Points& a) {
  return square_root(mul_add(a.x, a.x, mul_add(a.y, a.y, a.z * a.z)));
}

/// A derivative, from the homogeneous one and the point.
SPLINECORE_INLINE Points slope_at(const Points& h, const Points& point, Lanes r) {
  return {mul_add(-h.w, point.x, h.x) * r, mul_add(-h.w, point.y, h.y) * r, mul_add(-h.w, point.z, h.z) * r, h.w};
}

SPLINECORE_INLINE Lanes dot_of(const Points& a, const Points& b) {
  return mul_add(a.x, b.x, mul_add(a.y, b.y, a.z * b.z));
}

SPLINECORE_INLINE Points cross_of(const Points& a, const Points& b) {
  return {mul_add(a.y, b.z, -(a.z * b.y)), mul_add(a.z, b.x, -(a.x * b.z)), mul_add(a.x, b.y, -(a.y * b.x)), a.w};
}

SPLINECORE_INLINE Lanes size_of(Lanes a) { return a > -a ? a : -a; }

/// How large a product may be with a vector of which the sizes of the coordinates are known.
SPLINECORE_INLINE Lanes cross_size(const Points& a, const Points& most) {
  return mul_add(size_of(a.x), most.y + most.z,
                 mul_add(size_of(a.y), most.z + most.x, size_of(a.z) * (most.x + most.y)));
}

/// What a rule adds up: a function, the difference to a rule with fewer nodes and the size of the terms.
struct RuleSums {
  Lanes value, change, terms;

  SPLINECORE_INLINE void add(Lanes function, Lanes size, Lanes share, Lanes difference) {
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

SPLINECORE_INLINE double largest_of(Lanes a) {
  const double low = a[0] > a[1] ? a[0] : a[1];
  const double high = a[2] > a[3] ? a[2] : a[3];
  return low > high ? low : high;
}

/// kDegree is the degree, or -1 for any.
template <int kDegree>
void surface_sums_of(const SurfaceRule& rule, const SurfaceRow& row, SurfaceSums* out) {
  const int degree = kDegree < 0 ? rule.degree : kDegree;
  const std::size_t width = rule.nodes;
  const Points origin{all(row.origin[0]), all(row.origin[1]), all(row.origin[2]), all(0.0)};
  const Points direction{all(-row.direction[0]), all(-row.direction[1]), all(-row.direction[2]), all(0.0)};
  RuleSums area{};
  RuleSums volume{};
  Lanes against = all(0.0);
  for (std::size_t i = 0; i < width; i += 4) {
    const Points h = at_nodes(rule.values + i, width, degree, row.points);
    const Lanes r = all(1.0) / h.w;
    const Points point{h.x * r, h.y * r, h.z * r, h.w};
    const Points u = slope_at(at_nodes(rule.values + i, width, degree, row.slopes), point, r);
    const Points v = slope_at(at_nodes(rule.slopes + i, width, degree, row.points), point, r);
    const Points normal = cross_of(u, v);
    const Points place{point.x + origin.x, point.y + origin.y, point.z + origin.z, h.w};
    const Lanes reach = all(row.reach) * size_of(r);
    const Points extent{all(row.extent[0]) + reach, all(row.extent[1]) + reach, all(row.extent[2]) + reach, h.w};
    const Lanes terms = mul_add(cross_size(u, extent), load(rule.steps + i), cross_size(v, extent) * all(row.step));
    const Lanes share = load(rule.shares + i);
    const Lanes difference = load(rule.differences + i);
    area.add(length_of(normal), terms, share, difference);
    volume.add(dot_of(place, normal) * all(1.0 / 3.0), length_of(place) * terms, share, difference);
    const Lanes here = dot_of(direction, normal);
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
