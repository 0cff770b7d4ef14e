// Four doubles at once. Included in the namespace of each set of instructions: see set.hpp.

typedef double Lanes __attribute__((vector_size(32)));
typedef float SingleLanes __attribute__((vector_size(16)));
typedef double LooseLanes __attribute__((vector_size(32), aligned(8), may_alias));
typedef float LooseSingle __attribute__((vector_size(16), aligned(4), may_alias));
typedef std::int64_t MaskLanes __attribute__((vector_size(32)));

SPLINECORE_INLINE Lanes all(double value) { return Lanes{value, value, value, value}; }
SPLINECORE_INLINE Lanes load(const double* from) { return *reinterpret_cast<const LooseLanes*>(from); }
SPLINECORE_INLINE void store(Lanes value, double* to) { *reinterpret_cast<LooseLanes*>(to) = value; }
SPLINECORE_INLINE void store(Lanes value, float* to) {
  *reinterpret_cast<LooseSingle*>(to) = __builtin_convertvector(value, SingleLanes);
}

/// a b + c, rounded once where the instructions can.
#if defined(__FMA__) && defined(__AVX2__)
SPLINECORE_INLINE Lanes mul_add(Lanes a, Lanes b, Lanes c) { return _mm256_fmadd_pd(a, b, c); }
SPLINECORE_INLINE Lanes square_root(Lanes a) { return _mm256_sqrt_pd(a); }
SPLINECORE_INLINE bool any(MaskLanes mask) { return _mm256_movemask_pd(reinterpret_cast<__m256d>(mask)) != 0; }
#elif defined(__aarch64__)
SPLINECORE_INLINE Lanes mul_add(Lanes a, Lanes b, Lanes c) {
  return Lanes{__builtin_fma(a[0], b[0], c[0]), __builtin_fma(a[1], b[1], c[1]), __builtin_fma(a[2], b[2], c[2]),
               __builtin_fma(a[3], b[3], c[3])};
}
#define SPLINECORE_PLAIN_LANES
#else
SPLINECORE_INLINE Lanes mul_add(Lanes a, Lanes b, Lanes c) { return a * b + c; }
#define SPLINECORE_PLAIN_LANES
#endif
#ifdef SPLINECORE_PLAIN_LANES
#undef SPLINECORE_PLAIN_LANES
SPLINECORE_INLINE Lanes square_root(Lanes a) {
  return Lanes{__builtin_sqrt(a[0]), __builtin_sqrt(a[1]), __builtin_sqrt(a[2]), __builtin_sqrt(a[3])};
}
SPLINECORE_INLINE bool any(MaskLanes mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }
#endif

/// x, y, z and w of four points.
struct Points {
  Lanes x, y, z, w;
};

/// Four vectors of four as four of their columns.
SPLINECORE_INLINE Points transposed(Lanes a, Lanes b, Lanes c, Lanes d) {
  const Lanes ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Lanes ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {__builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5), __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5),
          __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7), __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7)};
}

/// Writes x, y, z after x, y, z of four points.
template <class Real>
SPLINECORE_INLINE void store_triples(Lanes x, Lanes y, Lanes z, Real* out) {
  const Lanes xy_low = __builtin_shufflevector(x, y, 0, 4, 2, 6);   // x0 y0 x2 y2
  const Lanes yz_high = __builtin_shufflevector(y, z, 1, 5, 3, 7);  // y1 z1 y3 z3
  const Lanes zx = __builtin_shufflevector(z, x, 0, 5, 2, 7);       // z0 x1 z2 x3
  store(__builtin_shufflevector(xy_low, zx, 0, 1, 4, 5), out);
  store(__builtin_shufflevector(yz_high, xy_low, 0, 1, 6, 7), out + 4);
  store(__builtin_shufflevector(zx, yz_high, 2, 3, 6, 7), out + 8);
}

/// Writes the first three.
template <class Real>
SPLINECORE_INLINE void store_triple(Lanes xyz, Real* out) {
  out[0] = static_cast<Real>(xyz[0]);
  out[1] = static_cast<Real>(xyz[1]);
  out[2] = static_cast<Real>(xyz[2]);
}

/// Writes those of `count` points, so many numbers apart.
template <class Real>
SPLINECORE_INLINE void store_triples(Lanes x, Lanes y, Lanes z, int count, std::size_t apart, Real* out) {
  const Points p = transposed(x, y, z, z);
  const Lanes rows[4] = {p.x, p.y, p.z, p.w};
  for (int i = 0; i < count; ++i, out += apart) store_triple(rows[i], out);
}

/// a / b where r is 1 / b: with fused operations as if divided (Markstein 1990).
#if defined(__FMA__) || defined(__aarch64__)
SPLINECORE_INLINE Lanes quotient(Lanes a, Lanes b, Lanes r) {
  const Lanes first = a * r;
  return mul_add(mul_add(-first, b, a), r, first);
}
#else
SPLINECORE_INLINE Lanes quotient(Lanes a, Lanes b, Lanes) { return a / b; }
#endif

/// NaN in every lane where a point is no number, or so large that it may be one; else what was there.
SPLINECORE_INLINE Lanes doubt(Lanes before, Lanes x, Lanes y, Lanes z) { return mul_add(x + (y + z), all(0.0), before); }
SPLINECORE_INLINE bool is_certain(Lanes doubts) { return !any(doubts != doubts); }
