#include "moved_spans.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace splinecore {

namespace {

/// Which homogeneous points of two nets differ, row after row, unrolled.
class MovedPoints {
 public:
  MovedPoints(const NurbsPatch& patch, const NurbsPatch& before)
      : width_(patch.knot_vector(Axis::v).unrolled_count()), rows_(patch.knot_vector(Axis::u).unrolled_count(), 0),
        points_(rows_.size() * width_, 0) {
    const glm::dvec4* now = patch.homogeneous_points().data();
    const glm::dvec4* then = before.homogeneous_points().data();
    for (std::size_t i = 0; i < rows_.size(); ++i, now += width_, then += width_) {
      if (std::memcmp(now, then, width_ * sizeof(glm::dvec4)) == 0) continue;
      rows_[i] = 1;
      for (std::size_t j = 0; j < width_; ++j) {
        points_[i * width_ + j] = std::memcmp(now + j, then + j, sizeof(glm::dvec4)) != 0;
      }
    }
  }

  /// Of each column, whether one of the points in some rows moved; empty where none did.
  std::vector<char> columns(std::size_t begin, std::size_t end) const {
    std::vector<char> found;
    for (std::size_t i = begin; i < end; ++i) {
      if (!rows_[i]) continue;
      found.resize(width_, 0);
      for (std::size_t j = 0; j < width_; ++j) found[j] |= points_[i * width_ + j];
    }
    return found;
  }

 private:
  std::size_t width_;
  std::vector<char> rows_;
  std::vector<char> points_;
};

/// The spans that depend on some of the points.
std::vector<Range> spans_on(const KnotVector& knots, const std::vector<char>& points) {
  std::vector<Range> found;
  if (points.empty()) return found;
  const std::span<const int> spans = knots.spans();
  for (int k = 0; k < static_cast<int>(spans.size()); ++k) {
    const auto first = points.begin() + spans[k] - knots.degree();
    if (std::find(first, first + knots.degree() + 1, char{1}) == first + knots.degree() + 1) continue;
    if (!found.empty() && found.back().end == k) {
      ++found.back().end;
    } else {
      found.push_back({k, k + 1});
    }
  }
  return found;
}

}  // namespace

SpanRectangle all_spans(const NurbsPatch& patch) {
  const auto whole = [&](Axis axis) { return Range{0, static_cast<int>(patch.knot_vector(axis).spans().size())}; };
  return {whole(Axis::u), whole(Axis::v)};
}

std::vector<SpanRectangle> moved_spans(const NurbsPatch& patch, const NurbsPatch& before) {
  if (&patch == &before) return {};
  // A polynomial patch is not divided by w.
  if (patch.rational() != before.rational()) return {all_spans(patch)};
  const KnotVector& knots = patch.knot_vector(Axis::u);
  const MovedPoints moved(patch, before);
  std::vector<SpanRectangle> found;
  std::vector<Range> last;
  for (int k = 0; k < static_cast<int>(knots.spans().size()); ++k) {
    const int first = knots.spans()[k] - knots.degree();
    std::vector<Range> next = spans_on(patch.knot_vector(Axis::v), moved.columns(first, first + knots.degree() + 1));
    if (next == last) {
      for (std::size_t i = found.size() - next.size(); i < found.size(); ++i) ++found[i].u.end;
    } else {
      for (const Range& columns : next) found.push_back({{k, k + 1}, columns});
    }
    last = std::move(next);
  }
  return found;
}

}  // namespace splinecore
