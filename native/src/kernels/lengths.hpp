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

void surface_row(const SurfaceRow& form, const double* row, const double* slope, double* out) {
  const std::size_t width = form.nodes;
  for (std::size_t i = 0; i < width; i += 4, out += 4) {
    const Points h = at_nodes(form.values + i, width, form.degree, row);
    const Lanes r = all(1.0) / h.w;
    const Points point{h.x * r, h.y * r, h.z * r, h.w};
    const Points u = slope_at(at_nodes(form.values + i, width, form.degree, slope), point, r);
    const Points v = slope_at(at_nodes(form.slopes + i, width, form.degree, row), point, r);
    store(point.x, out);
    store(point.y, out + width);
    store(point.z, out + 2 * width);
    store(mul_add(u.y, v.z, -(u.z * v.y)), out + 3 * width);
    store(mul_add(u.z, v.x, -(u.x * v.z)), out + 4 * width);
    store(mul_add(u.x, v.y, -(u.y * v.x)), out + 5 * width);
    store(length_of(u), out + 6 * width);
    store(length_of(v), out + 7 * width);
    store(h.w, out + 8 * width);
  }
}
