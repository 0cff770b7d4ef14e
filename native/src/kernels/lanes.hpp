// Four doubles at once. Included in the namespace of each set of instructions: see set.hpp.

typedef double Lanes __attribute__((vector_size(32)));
typedef float SingleLanes __attribute__((vector_size(16)));
typedef std::int64_t MaskLanes __attribute__((vector_size(32)));

// As many doubles at once as a register holds: neighbors in a row or in a span are computed so.
#if defined(__AVX512F__) && defined(__AVX512VL__) && defined(__AVX512DQ__)
typedef double WideLanes __attribute__((vector_size(64)));
typedef std::int64_t WideMask __attribute__((vector_size(64)));
#define SPLINECORE_WIDE_LANES
typedef WideMask WideBits;
#else
typedef Lanes WideLanes;
typedef MaskLanes WideBits;
#endif
inline constexpr int kWide = sizeof(WideLanes) / sizeof(double);

template <class V = Lanes>
SPLINECORE_INLINE V all(double value) {
  return value - V{};
}
template <class V = Lanes>
SPLINECORE_INLINE V load(const double* from) {
  V value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}
SPLINECORE_INLINE void store(Lanes value, double* to) { __builtin_memcpy(to, &value, sizeof value); }
SPLINECORE_INLINE void store(Lanes value, float* to) {
  const SingleLanes single = __builtin_convertvector(value, SingleLanes);
  __builtin_memcpy(to, &single, sizeof single);
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

#if defined(__FMA__) || defined(__aarch64__)
SPLINECORE_INLINE double mul_add(double a, double b, double c) { return __builtin_fma(a, b, c); }
#else
SPLINECORE_INLINE double mul_add(double a, double b, double c) { return a * b + c; }
#endif

// No more doubles than a register holds: of longer vectors compilers keep sums in memory. ARM has two registers for four, so
// that sums are in the same order, and have the same bits, as those of processors with AVX2.
#if (defined(__FMA__) && defined(__AVX2__)) || defined(__aarch64__)
#define SPLINECORE_FOUR_LANES
typedef Lanes OwnLanes;
#else
typedef double OwnLanes __attribute__((vector_size(16)));
SPLINECORE_INLINE OwnLanes mul_add(OwnLanes a, OwnLanes b, OwnLanes c) { return a * b + c; }
#if defined(__SSE2__)
SPLINECORE_INLINE OwnLanes square_root(OwnLanes a) { return _mm_sqrt_pd(a); }
#else
SPLINECORE_INLINE OwnLanes square_root(OwnLanes a) { return OwnLanes{__builtin_sqrt(a[0]), __builtin_sqrt(a[1])}; }
#endif
#endif
inline constexpr std::size_t kOwn = sizeof(OwnLanes) / sizeof(double);

#if defined(SPLINECORE_WIDE_LANES)
SPLINECORE_INLINE WideLanes mul_add(WideLanes a, WideLanes b, WideLanes c) { return _mm512_fmadd_pd(a, b, c); }
SPLINECORE_INLINE bool any(WideMask mask) { return _mm512_movepi64_mask(reinterpret_cast<__m512i>(mask)) != 0; }
SPLINECORE_INLINE Lanes lower(WideLanes a) { return __builtin_shufflevector(a, a, 0, 1, 2, 3); }
SPLINECORE_INLINE Lanes upper(WideLanes a) { return __builtin_shufflevector(a, a, 4, 5, 6, 7); }
#endif

template <class V>
SPLINECORE_INLINE bool is_any_at_most(V a, V most) {
#if defined(SPLINECORE_WIDE_LANES)
  if constexpr (sizeof(V) == sizeof(WideLanes)) return _mm512_cmp_pd_mask(a, most, _CMP_LE_OQ) != 0;
#endif
  return any(a <= most);
}

template <class V>
SPLINECORE_INLINE bool are_below(V a, V most) {
#if defined(SPLINECORE_WIDE_LANES)
  if constexpr (sizeof(V) == sizeof(WideLanes)) return _mm512_cmp_pd_mask(a, most, _CMP_LT_OQ) == 0xff;
#endif
  return !any(!(a < most));
}

/// Whether all lie strictly between the two.
template <class V>
SPLINECORE_INLINE bool is_between(double low, double high, V a) {
#if defined(SPLINECORE_WIDE_LANES)
  if constexpr (sizeof(V) == sizeof(WideLanes)) {
    const __mmask8 above = _mm512_cmp_pd_mask(a, all<V>(low), _CMP_GT_OQ);
    return _mm512_mask_cmp_pd_mask(above, a, all<V>(high), _CMP_LT_OQ) == 0xff;
  }
#endif
  return !any(!((a > all<V>(low)) & (a < all<V>(high))));
}

/// Two times four doubles.
#if defined(SPLINECORE_WIDE_LANES)
typedef WideLanes Twice;
SPLINECORE_INLINE Twice twice(Lanes low, Lanes high) { return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7); }
SPLINECORE_INLINE Twice load_twice(const double* both) { return _mm512_maskz_broadcast_f64x4(0xff, _mm256_loadu_pd(both)); }
/// A lane of each four everywhere in these.
template <int kLane>
SPLINECORE_INLINE Twice spread(Twice a) {
  return _mm512_maskz_permutex_pd(0xff, a, 0x55 * kLane);
}
#else
struct Twice {
  Lanes low, high;
};
SPLINECORE_INLINE Twice twice(Lanes low, Lanes high) { return {low, high}; }
SPLINECORE_INLINE Twice load_twice(const double* both) { return {load(both), load(both)}; }
template <int kLane>
SPLINECORE_INLINE Twice spread(Twice a) {
  return {all(a.low[kLane]), all(a.high[kLane])};
}
SPLINECORE_INLINE Twice operator*(Twice a, Twice b) { return {a.low * b.low, a.high * b.high}; }
SPLINECORE_INLINE Twice mul_add(Twice a, Twice b, Twice c) {
  return {mul_add(a.low, b.low, c.low), mul_add(a.high, b.high, c.high)};
}
SPLINECORE_INLINE Lanes lower(Twice a) { return a.low; }
SPLINECORE_INLINE Lanes upper(Twice a) { return a.high; }
#endif
SPLINECORE_INLINE Twice spread(Twice a, int lane) {
  return lane == 0 ? spread<0>(a) : lane == 1 ? spread<1>(a) : lane == 2 ? spread<2>(a) : spread<3>(a);
}

/// 1 / a and 1 / sqrt(a), within two roundings; of numbers near the least and the largest perhaps not a number. The
/// only divider is slower than steps from a first guess, where there is one: the same steps for
/// lanes of every width, so that they give the same bits.
#if defined(SPLINECORE_WIDE_LANES)
SPLINECORE_INLINE Lanes guessed_reciprocal(Lanes a) { return _mm256_maskz_rcp14_pd(0xf, a); }
SPLINECORE_INLINE WideLanes guessed_reciprocal(WideLanes a) { return _mm512_maskz_rcp14_pd(0xff, a); }
SPLINECORE_INLINE Lanes guessed_reciprocal_root(Lanes a) { return _mm256_maskz_rsqrt14_pd(0xf, a); }
SPLINECORE_INLINE WideLanes guessed_reciprocal_root(WideLanes a) { return _mm512_maskz_rsqrt14_pd(0xff, a); }

template <class V>
SPLINECORE_INLINE V nearer_reciprocal(V a, V r) {
  return mul_add(r, mul_add(-a, r, all<V>(1.0)), r);
}
template <class V>
SPLINECORE_INLINE V rough_reciprocal(V a) {
  return nearer_reciprocal(a, guessed_reciprocal(a));
}
template <class V>
SPLINECORE_INLINE V reciprocal(V a) {
  return nearer_reciprocal(a, rough_reciprocal(a));
}
template <class V>
SPLINECORE_INLINE V reciprocal_root(V a) {
  V r = guessed_reciprocal_root(a);
  const V error = mul_add(-(a * r), r, all<V>(1.0));
  // 1 / sqrt(1 - error) with |error| < 2^-13: the second term takes what the fourth amounts to there.
  constexpr double kSecond = 0.375 + 0.2734375 * 0x1p-26;
  const V terms = mul_add(mul_add(all<V>(0.3125), error, all<V>(kSecond)), error, all<V>(0.5));
  return mul_add(r * error, terms, r);
}
#else
SPLINECORE_INLINE Lanes reciprocal(Lanes a) { return all(1.0) / a; }
SPLINECORE_INLINE Lanes rough_reciprocal(Lanes a) { return reciprocal(a); }
SPLINECORE_INLINE Lanes nearer_reciprocal(Lanes, Lanes r) { return r; }
SPLINECORE_INLINE Lanes reciprocal_root(Lanes a) { return all(1.0) / square_root(a); }
#endif

/// x, y, z and w of as many points.
template <class V>
struct PointsOf {
  V x, y, z, w;
};
using Points = PointsOf<Lanes>;

typedef double Pair __attribute__((vector_size(16)));
SPLINECORE_INLINE Pair load_pair(const double* from) {
  Pair value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}

/// Four pairs as two of their columns.
struct Columns {
  Lanes first, second;
};
SPLINECORE_INLINE Columns columns(Pair a, Pair b, Pair c, Pair d) {
  const Lanes ac = __builtin_shufflevector(a, c, 0, 1, 2, 3);
  const Lanes bd = __builtin_shufflevector(b, d, 0, 1, 2, 3);
  return {__builtin_shufflevector(ac, bd, 0, 4, 2, 6), __builtin_shufflevector(ac, bd, 1, 5, 3, 7)};
}

/// Four vectors of four as four of their columns.
SPLINECORE_INLINE Points transposed(Lanes a, Lanes b, Lanes c, Lanes d) {
  const Lanes ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Lanes ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {__builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5), __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5),
          __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7), __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7)};
}

/// Asks for the memory some way behind, as much as is written here, so that stores there need not wait for it.
template <std::size_t kBytes>
SPLINECORE_INLINE void ask_ahead(const void* out) {
  constexpr std::size_t kAhead = 4096;
  constexpr std::size_t kLine = 64;
  const auto from = reinterpret_cast<std::uintptr_t>(out) + kAhead;
  for (std::size_t i = 0; i < kBytes; i += kLine) __builtin_prefetch(reinterpret_cast<const void*>(from + i), 1);
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

#if defined(SPLINECORE_WIDE_LANES)
SPLINECORE_INLINE void store(WideLanes value, double* to) { __builtin_memcpy(to, &value, sizeof value); }
SPLINECORE_INLINE void store(WideLanes value, float* to) {
  store(lower(value), to);
  store(upper(value), to + 4);
}

template <class Real>
SPLINECORE_INLINE void store_triples(WideLanes x, WideLanes y, WideLanes z, Real* out) {
  const WideLanes first = __builtin_shufflevector(x, y, 0, 8, 0, 1, 9, 0, 2, 10);
  const WideLanes second = __builtin_shufflevector(y, z, 10, 0, 3, 11, 0, 4, 12, 0);
  const WideLanes third = __builtin_shufflevector(z, x, 5, 14, 0, 6, 15, 7, 0, 0);
  store(__builtin_shufflevector(first, z, 0, 1, 8, 3, 4, 9, 6, 7), out);
  store(__builtin_shufflevector(second, x, 0, 11, 2, 3, 12, 5, 6, 13), out + 8);
  store(__builtin_shufflevector(third, y, 13, 0, 1, 14, 3, 4, 15, 5), out + 16);
}

template <class Real>
SPLINECORE_INLINE void store_triples(WideLanes x, WideLanes y, WideLanes z, int count, std::size_t apart, Real* out) {
  store_triples(lower(x), lower(y), lower(z), count < 4 ? count : 4, apart, out);
  if (count > 4) store_triples(upper(x), upper(y), upper(z), count - 4, apart, out + 4 * apart);
}
#endif

/// a / b where r is 1 / b: with fused operations as if divided (Markstein 1990).
#if defined(__FMA__) || defined(__aarch64__)
template <class V>
SPLINECORE_INLINE V quotient(V a, V b, V r) {
  const V first = a * r;
  return mul_add(mul_add(-first, b, a), r, first);
}
#else
SPLINECORE_INLINE Lanes quotient(Lanes a, Lanes b, Lanes) { return a / b; }
#endif

/// NaN in every lane where a point is no number, or so large that it may be one; else what was there.
template <class V>
SPLINECORE_INLINE V doubt(V before, V x, V y, V z) {
  return mul_add(x + (y + z), all<V>(0.0), before);
}
template <class V>
SPLINECORE_INLINE bool is_certain(V doubts) {
  return !any(doubts != doubts);
}
