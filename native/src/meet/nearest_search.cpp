#include "nearest_search.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// Halving ends where a parameter has no more digits.
constexpr double kShortest = 0x1p-50;
constexpr std::size_t kDeepest = 110;
/// What rounding may do to a distance, by the size of the shape, which is 1, and of the distance.
constexpr double kSearchRounding = 0x1p-48;
/// From so many parts on that were looked at for one point, the order of places and what is below rounding count less.
constexpr std::size_t kMany = 1 << 14;

/// Where a quadratic with these slopes and second derivatives is least in an interval of steps.
double best_step(double slope, double bend, double low, double high) noexcept {
  if (bend > 0.0) return std::clamp(-slope / bend, low, high);
  return slope > 0.0 ? low : high;
}

/// Half the squared distance up to second order.
template <int kAxes>
struct Model {
  std::array<double, kAxes> slope;
  std::array<double, 3> bend{};     ///< uu, vv, uv
  std::array<double, 3> squares{};  ///< the part of it that never points down

  explicit Model(const Slopes<kAxes>& at) noexcept {
    for (int a = 0; a < kAxes; ++a) {
      slope[a] = glm::dot(at.offset, at.first[a]);
      squares[a] = glm::dot(at.first[a], at.first[a]);
      bend[a] = squares[a] + glm::dot(at.offset, at.second[a]);
    }
    if constexpr (kAxes == 2) {
      squares[2] = glm::dot(at.first[0], at.first[1]);
      bend[2] = squares[2] + glm::dot(at.offset, at.second[2]);
    }
  }

  /// The step along one axis.
  double step_along(int axis, double at) const noexcept {
    return best_step(slope[axis], bend[axis] > 0.0 ? bend[axis] : squares[axis], -at, 1.0 - at);
  }
};

/// The step from a place to the least value of a model among those in [0, 1]; of one that has none, of its squares.
std::array<double, 1> step_of(const Model<1>& model, const std::array<double, 1>& at) noexcept {
  return {model.step_along(0, at[0])};
}

std::array<double, 2> step_of(const Model<2>& model, const std::array<double, 2>& at) noexcept {
  const auto& slope = model.slope;
  // On a side towards which the distance falls the other parameter is alone.
  const auto stays = [&](int axis) {
    return (at[axis] == 0.0 && slope[axis] >= 0.0) || (at[axis] == 1.0 && slope[axis] <= 0.0);
  };
  if (stays(0)) return {0.0, stays(1) ? 0.0 : model.step_along(1, at[1])};
  if (stays(1)) return {model.step_along(0, at[0]), 0.0};
  const auto determinant_of = [](const std::array<double, 3>& m) { return m[0] * m[1] - m[2] * m[2]; };
  const bool is_up = model.bend[0] > 0.0 && determinant_of(model.bend) > 0.0;
  const std::array<double, 3>& bend = is_up ? model.bend : model.squares;
  const double determinant = determinant_of(bend);
  if (determinant > 0.0) {
    const double u = (bend[2] * slope[1] - bend[1] * slope[0]) / determinant;
    const double v = (bend[2] * slope[0] - bend[0] * slope[1]) / determinant;
    if (at[0] + u >= 0.0 && at[0] + u <= 1.0 && at[1] + v >= 0.0 && at[1] + v <= 1.0) return {u, v};
  }
  // Then it is least on a side.
  std::array<double, 2> found{};
  double least = 0.0;
  const auto attempt = [&](double u, double v) {
    const double value = u * (slope[0] + 0.5 * bend[0] * u + bend[2] * v) + v * (slope[1] + 0.5 * bend[1] * v);
    if (!(value < least)) return;
    least = value;
    found = {u, v};
  };
  for (const double u : {-at[0], 1.0 - at[0]}) {
    attempt(u, best_step(slope[1] + bend[2] * u, bend[1], -at[1], 1.0 - at[1]));
  }
  for (const double v : {-at[1], 1.0 - at[1]}) {
    attempt(best_step(slope[0] + bend[2] * v, bend[0], -at[0], 1.0 - at[0]), v);
  }
  return found;
}

/// Whether the sides of a net along v are longer than those along u; of weights as these are.
bool is_longer_across(const glm::dvec4* net, std::size_t rows, std::size_t columns) noexcept {
  const auto last_row = static_cast<double>(rows - 1);
  const auto last_column = static_cast<double>(columns - 1);
  double along = 0.0;
  double across = 0.0;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const glm::dvec4& h = net[i * columns + j];
      if (i > 0) along = std::max(along, glm::length(h - net[(i - 1) * columns + j]) * last_row);
      if (j > 0) across = std::max(across, glm::length(h - net[i * columns + j - 1]) * last_column);
    }
  }
  return across > along;
}

}  // namespace

template <int kAxes>
NearestSearch<kAxes>::NearestSearch(const BoxedPieces& pieces)
    : pieces_(pieces), rows_(pieces.rows()), columns_(pieces.columns()),
      waiting_((pieces.tree().levels() + 1) * BoxTree::kGroup), nets_(kDeepest + 2), form_(rows_, columns_) {
  constexpr double kApart = 0x1p-20;
  std::array<Interval, 2> whole = pieces.parts().front().domain;
  for (const PiecePart& part : pieces.parts()) {
    for (int a = 0; a < kAxes; ++a) {
      whole[a] = {std::min(whole[a].start, part.domain[a].start), std::max(whole[a].end, part.domain[a].end)};
    }
  }
  for (int a = 0; a < kAxes; ++a) apart_[a] = kApart * whole[a].end - kApart * whole[a].start;
}

template <int kAxes>
NearestPlace NearestSearch<kAxes>::nearest(const glm::dvec3& point, double within) {
  point_ = point;
  best_ = {};
  looks_ = 0;
  rounding_ = kSearchRounding;
  const double most = within + rounding_ * (1.0 + within);
  least_ = below_ = above_ = most * most;
  waiting_count_ = 0;
  push_boxes(pieces_.tree().levels() - 1, 0);
  while (waiting_count_ > 0) {
    const Waiting next = waiting_[--waiting_count_];
    if (next.squared > above_) continue;
    if (next.level == 0) {
      look_at(next);
      continue;
    }
    breathe(1024);
    next.level == 1 ? push_parts(next.index) : push_boxes(next.level - 2, next.index);
  }
  return best_;
}

/// Groups of a level of the tree.
template <int kAxes>
void NearestSearch<kAxes>::push_boxes(std::size_t level, std::size_t group) {
  const std::size_t first = group * BoxTree::kGroup;
  std::array<double, BoxTree::kGroup> squared;
  kernels_.box_distances(pieces_.tree().group(level, group), &point_.x, squared.data());
  push(squared.data(), std::min(BoxTree::kGroup, pieces_.tree().count(level) - first), level + 1, first);
}

template <int kAxes>
void NearestSearch<kAxes>::push_parts(std::size_t group) {
  const std::size_t first = group * BoxedPieces::kGroup;
  std::array<double, BoxedPieces::kGroup> squared;
  kernels_.turned_box_distances(pieces_.groups()[group], &point_.x, squared.data());
  push(squared.data(), std::min(BoxedPieces::kGroup, pieces_.parts().size() - first), 0, first);
}

/// Those that may hold the nearest place, of which the nearest is looked at first.
template <int kAxes>
void NearestSearch<kAxes>::push(const double* squared, std::size_t count, std::size_t level, std::size_t first) {
  const std::size_t before = waiting_count_;
  std::size_t end = before;
  std::size_t nearest = before;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    waiting_[end] = {squared[i], static_cast<std::uint32_t>(level), static_cast<std::uint32_t>(first + i)};
    nearest = squared[i] < least ? end : nearest;
    least = std::min(squared[i], least);
    end += squared[i] <= above_ ? 1 : 0;
  }
  waiting_count_ = end;
  if (end > before) std::swap(waiting_[nearest], waiting_[end - 1]);
}

template <int kAxes>
bool NearestSearch<kAxes>::may_hold(double squared, const PiecePart& part, const Range& range) const noexcept {
  if (squared < below_) return true;
  if (squared > above_) return false;
  for (int a = 0; a < kAxes; ++a) {
    const double start = part.domain[a].at(range[a].start);
    if (start != best_.parameters[a]) return start < best_.parameters[a];
  }
  return false;
}

template <int kAxes>
void NearestSearch<kAxes>::look_at(const Waiting& waiting) {
  const PiecePart& part = pieces_.parts()[waiting.index];
  if (!may_hold(waiting.squared, part, part.range)) return;
  Place start;
  start.fill(0.5);
  const PieceBox& box = part.box;
  if (kAxes == 1 && part.is_boxed && box.half.x > 0.0) {
    start[0] += std::clamp(glm::dot(box.axes[0], point_ - box.center) / (2.0 * box.half.x), -0.5, 0.5);
  }
  look_into(part, pieces_.points(waiting.index), part.range, start, 0);
}

template <int kAxes>
void NearestSearch<kAxes>::set_limits() noexcept {
  const double distance = std::sqrt(least_);
  const double rounding = rounding_ * (1.0 + distance);
  const double below = std::max(distance - rounding, 0.0);
  below_ = below * below;
  above_ = (distance + rounding) * (distance + rounding);
}

/// Many parts are looked at where places at the least distance are a curve: no end of halving tells them apart.
template <int kAxes>
void NearestSearch<kAxes>::count_look() {
  constexpr std::size_t kMore = kMany / 4;
  constexpr std::size_t kMost = 16 * kMany;
  constexpr double kMostRounding = 0x1p-24;
  if (++looks_ < kMany || looks_ % kMore != 0) return;
  if (looks_ == kMost) {
    throw InvalidShape("the nearest point cannot be told: more than 2^18 parts of the shape may hold it");
  }
  if (rounding_ >= kMostRounding) return;
  rounding_ *= 16.0;
  if (best_.found()) set_limits();
}

template <int kAxes>
void NearestSearch<kAxes>::look_into(const PiecePart& part, const glm::dvec4* net, const Range& range, Place start,
                                     std::size_t depth) {
  breathe(4 * rows_ * rows_ * columns_ * columns_);
  count_look();
  bool is_short = true;
  bool is_narrow = true;
  for (int a = 0; a < kAxes; ++a) {
    is_short = is_short && range[a].length() <= kShortest;
    const double width = part.domain[a].at(range[a].end) - part.domain[a].at(range[a].start);
    is_narrow = is_narrow && width <= apart_[a];
  }
  form_.set(net, point_);
  if (above_ < std::numeric_limits<double>::infinity()) {
    // An earlier place of a part as narrow as that is the same one.
    const double limit = looks_ < kMany && !is_narrow && may_hold(below_, part, range) ? above_ : below_;
    if (limit == 0.0 || form_.is_farther(limit)) return;
  }
  const double least = go_down(part, net, range, start);
  if (least >= 0.0 && form_.is_least(least, start[0], start[kAxes - 1])) return;
  // Of many places at one distance the first is found so.
  Place corner{};
  offer(part, range, corner, slopes(net, corner).offset);
  if (is_short || depth == kDeepest) return;
  const bool across = kAxes == 2 && (range[0].length() <= kShortest || is_longer_across(net, rows_, columns_));
  Net& first = nets_[depth][0];
  Net& second = nets_[depth][1];
  first.rows = rows_;
  first.columns = columns_;
  first.values.assign(net, net + rows_ * columns_);
  first.halve(across ? Axis::v : Axis::u, second);
  const int axis = across ? 1 : 0;
  Range half = range;
  half[axis].end = range[axis].middle();
  start.fill(0.5);
  look_into(part, first.values.data(), half, start, depth + 1);
  half[axis] = {range[axis].middle(), range[axis].end};
  look_into(part, second.values.data(), half, start, depth + 1);
}

template <int kAxes>
double NearestSearch<kAxes>::go_down(const PiecePart& part, const glm::dvec4* net, const Range& range, Place& at) {
  // After a step as short the next one would be rounding.
  constexpr double kLastStep = 0x1p-27;
  constexpr double kNoGain = 0x1p-50;
  constexpr double kUnseen = 0x1p-44;
  constexpr int kMostSteps = 60;
  Slopes<kAxes> here = slopes(net, at);
  double squared = glm::dot(here.offset, here.offset);
  for (int steps = 0; steps < kMostSteps && squared < std::numeric_limits<double>::infinity(); ++steps) {
    const Model<kAxes> model(here);
    const Place& slope = model.slope;
    Place step = step_of(model, at);
    double length = 0.0;
    double gain = 0.0;
    for (int a = 0; a < kAxes; ++a) {
      length = std::max(length, std::abs(step[a]));
      gain += std::max(slope[a] * at[a], slope[a] * (at[a] - 1.0));
    }
    if (length <= kLastStep) {
      for (int a = 0; a < kAxes; ++a) {
        at[a] = std::clamp(at[a] + step[a], 0.0, 1.0);
        here.offset += step[a] * here.first[a] + 0.5 * step[a] * step[a] * here.second[a];
      }
      if constexpr (kAxes == 2) here.offset += step[0] * step[1] * here.second[2];
      offer(part, range, at, here.offset);
      return glm::dot(here.offset, here.offset);
    }
    // A gain below rounding cannot be seen.
    double promised = 0.0;
    for (int a = 0; a < kAxes; ++a) promised -= slope[a] * step[a];
    const bool is_blind = promised <= kUnseen * squared;
    bool is_lower = false;
    for (; !is_lower && length > kLastStep; length *= 0.5) {
      Place to;
      for (int a = 0; a < kAxes; ++a) {
        to[a] = std::clamp(at[a] + step[a], 0.0, 1.0);
        step[a] *= 0.5;
      }
      const Slopes<kAxes> there = slopes(net, to);
      const double value = glm::dot(there.offset, there.offset);
      if (!(value < squared) && !is_blind) continue;
      is_lower = true;
      here = there;
      at = to;
      squared = value;
    }
    if (is_lower) continue;
    offer(part, range, at, here.offset);
    return gain <= kNoGain * squared ? squared : -1.0;
  }
  offer(part, range, at, here.offset);
  return -1.0;
}

template <int kAxes>
Slopes<kAxes> NearestSearch<kAxes>::slopes(const glm::dvec4* net, const Place& at) noexcept {
  return slopes_of<kAxes>(kernels_, net, rows_, columns_, at, point_);
}

template <int kAxes>
void NearestSearch<kAxes>::offer(const PiecePart& part, const Range& range, const Place& at,
                                 const glm::dvec3& offset) noexcept {
  const double squared = glm::dot(offset, offset);
  if (!(squared <= above_) || !(squared < std::numeric_limits<double>::infinity())) return;
  if (squared < least_) {
    least_ = squared;
    set_limits();
  }
  NearestPlace place{{}, squared, point_ + offset};
  for (int a = 0; a < kAxes; ++a) {
    const double t = (1.0 - at[a]) * range[a].start + at[a] * range[a].end;
    place.parameters[a] = part.domain[a].at(t);
  }
  bool is_before = best_.squared > above_ || squared < best_.squared;
  for (int a = 0; a < kAxes && best_.squared <= above_; ++a) {
    const double step = place.parameters[a] - best_.parameters[a];
    if (std::abs(step) <= apart_[a]) continue;
    is_before = step < 0.0;
    break;
  }
  if (is_before) best_ = place;
}

template class NearestSearch<1>;
template class NearestSearch<2>;

}  // namespace splinecore
