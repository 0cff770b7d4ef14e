// Kernels of rows of functions near the diagonal. Included in the namespace of each set of instructions: see set.hpp.

/// Four rows. The knots about each parameter, and where its row begins, are taken by masks: branches would be as good as
/// random. The functions are those of The NURBS Book, A2.2. @returns lanes of zeros where the parameter lies elsewhere
template <int kDegree>
SPLINECORE_INLINE MaskLanes four_near_rows(const double* near, const double* parameters, double* out) {
  constexpr int kWidth = 2 * kDegree - 1;
  const Lanes u = load(parameters);
  Lanes knots[2 * kDegree];  // from the one kDegree - 1 before the span's on
  for (int k = 0; k < 2 * kDegree; ++k) knots[k] = load(near + 2 - kDegree + k);
  MaskLanes later[kDegree] = {};
  for (int step = 2; step < kDegree; ++step) {
    later[step] = u >= load(near + step);
    for (int k = 0; k < 2 * kDegree; ++k) knots[k] = later[step] ? load(near + 1 - kDegree + step + k) : knots[k];
  }
  Lanes row[kWidth];
  for (int k = 1; k < kWidth; ++k) row[k] = all(0.0);
  row[0] = all(1.0);
  for (int level = 1; level <= kDegree; ++level) {
    Lanes carried = all(0.0);
    for (int r = 0; r < level; ++r) {
      const Lanes low = knots[kDegree - level + r];
      const Lanes high = knots[kDegree + r];
      const Lanes share = row[r] / (high - low);
      row[r] = mul_add(share, high - u, carried);
      carried = share * (u - low);
    }
    row[level] = carried;
  }
  for (int step = 2; step < kDegree; ++step) {
    for (int k = kDegree + step - 1; k > 0; --k) row[k] = later[step] ? row[k - 1] : row[k];
    row[0] = later[step] ? all(0.0) : row[0];
  }
  for (int k = 0; k < kWidth; ++k) store(row[k], out + k * kNearRows);
  return (load(near + 1) <= u) & (u < load(near + kDegree));
}

template <int kDegree>
bool near_rows(const double* near, const double* parameters, std::size_t count, double* out) {
  MaskLanes fit = four_near_rows<kDegree>(near, parameters, out);
  for (std::size_t i = 4; i < count; i += 4) {
    const std::size_t at = i < count - 4 ? i : count - 4;
    fit &= four_near_rows<kDegree>(near + at, parameters + at, out + at);
  }
  return !any(~fit);
}
