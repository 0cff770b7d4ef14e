// Which spans parameters lie in. Included in the namespace of each set of instructions: see set.hpp.

/// How many spans start before u, or at it.
template <bool kAt>
SPLINECORE_INLINE std::int32_t starts_before(const SpanParts& parts, double u) {
  const auto begins = [&](std::int32_t i) { return kAt ? parts.bounds[i] <= u : parts.bounds[i] < u; };
  const auto part = static_cast<std::size_t>(static_cast<std::int64_t>((u - parts.bounds[0]) * parts.scale));
  std::int32_t next = parts.first[part];
  if (parts.is_crowded) {
    for (std::int32_t end = parts.first[part + 1]; next < end;) {
      const std::int32_t middle = next + (end - next) / 2;
      if (begins(middle)) {
        next = middle + 1;
      } else {
        end = middle;
      }
    }
  }
  next += static_cast<std::int32_t>(begins(next));  // one start lies in every eighth part: no branch
  while (begins(next)) ++next;
  return next;
}

SPLINECORE_INLINE std::int32_t span_before(const SpanParts& parts, std::int32_t next) {
  return next < 1 ? 0 : next > parts.count ? parts.count - 1 : next - 1;
}

#if defined(SPLINECORE_WIDE_LANES)
/// The same for eight; false where a part has several starts that are before u.
template <bool kAt>
SPLINECORE_INLINE bool spans_of_eight(const SpanParts& parts, const double* u, std::int32_t* spans) {
  constexpr int kCompare = kAt ? _CMP_LE_OQ : _CMP_LT_OQ;
  const __m512d at = _mm512_loadu_pd(u);
  const __m512d place = _mm512_mul_pd(_mm512_sub_pd(at, _mm512_set1_pd(parts.bounds[0])), _mm512_set1_pd(parts.scale));
  const __m256i none = _mm256_setzero_si256();
  const __m256i one = _mm256_set1_epi32(1);
  const __m256i part = _mm512_maskz_cvttpd_epi32(0xff, place);
  __m256i next = _mm256_mmask_i32gather_epi32(none, 0xff, part, parts.first, 4);
  const auto begun = [&] {
    const __m512d bounds = _mm512_mask_i32gather_pd(at, 0xff, next, parts.bounds, 8);
    return _mm512_cmp_pd_mask(bounds, at, kCompare);
  };
  next = _mm256_mask_add_epi32(next, begun(), next, one);
  if (begun() != 0) return false;
  const __m256i before = _mm256_max_epi32(_mm256_sub_epi32(next, one), none);
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(spans), _mm256_min_epi32(before, _mm256_set1_epi32(parts.count - 1)));
  return true;
}
#endif

template <bool kAt>
SPLINECORE_INLINE void spans_of(const SpanParts& parts, const double* u, std::size_t count, std::int32_t* spans) {
  std::size_t i = 0;
#if defined(SPLINECORE_WIDE_LANES)
  for (; !parts.is_crowded && i + 8 <= count && spans_of_eight<kAt>(parts, u + i, spans + i); i += 8) {
  }
#endif
  for (; i < count; ++i) spans[i] = span_before(parts, starts_before<kAt>(parts, u[i]));
}

void find_spans(const SpanParts& parts, bool at, const double* u, std::size_t count, std::int32_t* spans) {
  return at ? spans_of<true>(parts, u, count, spans) : spans_of<false>(parts, u, count, spans);
}
