// The kernel of lengths. Included in the namespace of each set of instructions: see set.hpp.

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
