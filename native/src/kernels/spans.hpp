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
SPLINECORE_INLINE __m512d gathered(__m256i places, const double* from) {
  return _mm512_mask_i32gather_pd(_mm512_setzero_pd(), 0xff, places, from, 8);
}

/// Spans of eight parameters, and where they start and end.
struct EightSpans {
  __m256i spans;
  __m512d start;
  __m512d end;
};

/// False where a part has several starts that are before one of them, or one lies at an end of the domain.
template <bool kAt>
SPLINECORE_INLINE bool spans_of_eight(const SpanParts& parts, __m512d at, EightSpans* found) {
  constexpr int kCompare = kAt ? _CMP_LE_OQ : _CMP_LT_OQ;
  const __m512d place = _mm512_mul_pd(_mm512_sub_pd(at, _mm512_set1_pd(parts.bounds[0])), _mm512_set1_pd(parts.scale));
  const __m256i none = _mm256_setzero_si256();
  const __m256i one = _mm256_set1_epi32(1);
  const __m256i part = _mm512_maskz_cvttpd_epi32(0xff, place);
  __m256i next = _mm256_mmask_i32gather_epi32(none, 0xff, part, parts.first, 4);
  const __m512d first = gathered(next, parts.bounds);
  const __mmask8 begun = _mm512_cmp_pd_mask(first, at, kCompare);
  next = _mm256_mask_add_epi32(next, begun, next, one);
  found->end = gathered(next, parts.bounds);
  found->spans = _mm256_sub_epi32(next, one);
  const __mmask8 is_beyond = _mm256_cmp_epu32_mask(found->spans, _mm256_set1_epi32(parts.count), _MM_CMPINT_NLT);
  if ((_mm512_cmp_pd_mask(found->end, at, kCompare) | is_beyond) != 0) return false;
  found->start = gathered(found->spans, parts.bounds);
  return true;
}

/// Eight halves, from the spans.
SPLINECORE_INLINE void write_eight(const HalfTable& table, __m512d at, const EightSpans& found, std::size_t i,
                                   ScatteredHalves& halves) {
  const __mmask8 is_second = _mm512_cmp_pd_mask(at, gathered(found.spans, table.middles), _CMP_GT_OQ);
  const __m256i one = _mm256_set1_epi32(1);
  const __m256i half = _mm256_add_epi32(found.spans, found.spans);
  _mm512_storeu_pd(halves.u + i, at);
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(halves.half + i), _mm256_mask_add_epi32(half, is_second, half, one));
  _mm512_storeu_pd(halves.near + i, _mm512_mask_mov_pd(found.start, is_second, found.end));
  _mm512_storeu_pd(halves.far + i, _mm512_mask_mov_pd(found.end, is_second, found.start));
  const __m512i forth = _mm512_set1_epi64(4);
  _mm512_storeu_si512(halves.step + i, _mm512_mask_sub_epi64(forth, is_second, _mm512_setzero_si512(), forth));
  const __m512i start = _mm512_maskz_mul_epu32(0xff, _mm512_maskz_cvtepi32_epi64(0xff, found.spans),
                                               _mm512_set1_epi64(8 * static_cast<std::int64_t>(table.size)));
  const __m512i row = _mm512_mask_add_epi64(start, is_second, start, _mm512_set1_epi64(8 * table.last_row));
  const __m512i rows = _mm512_set1_epi64(reinterpret_cast<std::int64_t>(table.rows));
  _mm512_storeu_si512(halves.rows + i, _mm512_add_epi64(row, rows));
}
#endif

template <bool kAt>
SPLINECORE_INLINE void spans_of(const SpanParts& parts, const double* u, std::size_t count, std::int32_t* spans) {
  std::size_t i = 0;
#if defined(SPLINECORE_WIDE_LANES)
  EightSpans found;
  for (; !parts.is_crowded && i + 8 <= count && spans_of_eight<kAt>(parts, _mm512_loadu_pd(u + i), &found); i += 8) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(spans + i), found.spans);
  }
#endif
  for (; i < count; ++i) spans[i] = span_before(parts, starts_before<kAt>(parts, u[i]));
}

template <bool kAt>
SPLINECORE_INLINE bool halves_of(const HalfTable& table, const double* u, std::size_t count, ScatteredHalves& halves) {
  const SpanParts& parts = table.parts;
  std::size_t i = 0;
#if defined(SPLINECORE_WIDE_LANES)
  EightSpans found;
  const __m512d low = _mm512_set1_pd(table.low);
  const __m512d high = _mm512_set1_pd(table.high);
  for (; !parts.is_crowded && i + 8 <= count; i += 8) {
    const __m512d at = _mm512_loadu_pd(u + i);
    if ((_mm512_cmp_pd_mask(at, low, _CMP_GE_OQ) & _mm512_cmp_pd_mask(at, high, _CMP_LE_OQ)) != 0xff) return false;
    if (!spans_of_eight<kAt>(parts, at, &found)) break;
    write_eight(table, at, found, i, halves);
  }
#endif
  for (; i < count; ++i) {
    if (!(u[i] >= table.low && u[i] <= table.high)) return false;
    const std::int32_t span = span_before(parts, starts_before<kAt>(parts, u[i]));
    const auto second = static_cast<std::int32_t>(u[i] > table.middles[span]);
    halves.u[i] = u[i];
    halves.half[i] = 2 * span + second;
    halves.near[i] = parts.bounds[span + second];
    halves.far[i] = parts.bounds[span + 1 - second];
    halves.step[i] = 4 - 8 * second;
    if (table.rows == nullptr) continue;
    halves.rows[i] = table.rows + static_cast<std::size_t>(span) * table.size + second * table.last_row;
  }
  return true;
}

void find_spans(const SpanParts& parts, bool at, const double* u, std::size_t count, std::int32_t* spans) {
  return at ? spans_of<true>(parts, u, count, spans) : spans_of<false>(parts, u, count, spans);
}

bool find_halves(const HalfTable& table, bool at, const double* u, std::size_t count, ScatteredHalves& halves) {
  return at ? halves_of<true>(table, u, count, halves) : halves_of<false>(table, u, count, halves);
}
