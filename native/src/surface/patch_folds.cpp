#include "patch_folds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>
#include <ranges>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "kink.hpp"
#include "patch/bezier_piece.hpp"
#include "span_places.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

using VectorNet = BernsteinNet<glm::dvec3>;

double greatest(const VectorNet& net) {
  double found = 0.0;
  for (const glm::dvec3& one : net.values) found = std::max(found, length_of(one));
  return found;
}

std::vector<double> binomials(std::size_t degree) {
  std::vector<double> row(degree + 1, 1.0);
  for (std::size_t k = 1; k <= degree; ++k) row[k] = row[k - 1] * static_cast<double>(degree + 1 - k) / static_cast<double>(k);
  return row;
}

/// Bernstein coefficients of a product.
template <class Value, class A, class B, class Multiply>
BernsteinNet<Value> product(const BernsteinNet<A>& a, const BernsteinNet<B>& b, const Multiply& multiply) {
  BernsteinNet<Value> made{a.rows + b.rows - 1, a.columns + b.columns - 1, {}};
  made.values.assign(made.rows * made.columns, Value(0.0));
  const auto scaled = [](const auto& net) {
    auto found = net;
    const std::vector<double> rows = binomials(net.rows - 1);
    const std::vector<double> columns = binomials(net.columns - 1);
    for (std::size_t i = 0; i < net.rows; ++i) {
      for (std::size_t j = 0; j < net.columns; ++j) found.at(i, j) *= rows[i] * columns[j];
    }
    return found;
  };
  const BernsteinNet<A> left = scaled(a);
  const BernsteinNet<B> right = scaled(b);
  breathe(left.values.size() * right.values.size());
  for (std::size_t i = 0; i < a.rows; ++i) {
    for (std::size_t j = 0; j < a.columns; ++j) {
      for (std::size_t k = 0; k < b.rows; ++k) {
        for (std::size_t l = 0; l < b.columns; ++l) made.at(i + k, j + l) += multiply(left.at(i, j), right.at(k, l));
      }
    }
  }
  const std::vector<double> rows = binomials(made.rows - 1);
  const std::vector<double> columns = binomials(made.columns - 1);
  for (std::size_t i = 0; i < made.rows; ++i) {
    for (std::size_t j = 0; j < made.columns; ++j) made.at(i, j) /= rows[i] * columns[j];
  }
  return made;
}

/// Divides by the distance from a border, as often as vectors are 0 all along it: directions stay what they are.
void divide_by_border(VectorNet& net, Axis across, bool is_at_end) {
  constexpr double kRounding = 1e-12;
  const double size = greatest(net);
  while (size > 0.0 && net.count(across) > 1) {
    const std::size_t count = net.count(across);
    const std::size_t along = net.values.size() / count;
    const auto value = [&](std::size_t row, std::size_t k) { return across == Axis::u ? net.at(row, k) : net.at(k, row); };
    const std::size_t border = is_at_end ? count - 1 : 0;
    for (std::size_t k = 0; k < along; ++k) {
      if (length_of(value(border, k)) > kRounding * size) return;
    }
    VectorNet less{across == Axis::u ? net.rows - 1 : net.rows, across == Axis::u ? net.columns : net.columns - 1, {}};
    less.values.resize(less.rows * less.columns);
    const auto degree = static_cast<double>(count - 1);
    for (std::size_t row = 0; row + 1 < count; ++row) {
      const double factor = degree / static_cast<double>(is_at_end ? count - 1 - row : row + 1);
      for (std::size_t k = 0; k < along; ++k) {
        (across == Axis::u ? less.at(row, k) : less.at(k, row)) = factor * value(is_at_end ? row : row + 1, k);
      }
    }
    net = std::move(less);
  }
}

/// Vectors along both derivatives of a part of a patch.
struct FoldCell {
  VectorNet along_u;
  VectorNet along_v;
  std::array<double, 2> u;
  std::array<double, 2> v;

  double middle_u() const { return 0.5 * (u[0] + u[1]); }
  double middle_v() const { return 0.5 * (v[0] + v[1]); }
};

/// P' w - P w' of homogeneous points, or P' where all have one weight.
VectorNet derivative_along(const BernsteinNet<glm::dvec4>& piece, Axis axis, bool is_rational) {
  const BernsteinNet<glm::dvec4> slopes = piece.derivative(axis);
  if (is_rational) {
    const auto turned = [](const glm::dvec4& d, const glm::dvec4& p) { return glm::dvec3(d) * p.w - glm::dvec3(p) * d.w; };
    return product<glm::dvec3>(slopes, piece, turned);
  }
  VectorNet made{slopes.rows, slopes.columns, {}};
  for (const glm::dvec4& d : slopes.values) made.values.emplace_back(d);
  return made;
}

FoldCell cell_of(const NurbsPatch& patch, int span_u, int span_v) {
  const BernsteinNet<glm::dvec4> piece = bezier_piece(patch, span_u, span_v);
  const bool is_rational = std::ranges::any_of(piece.values, [&](const glm::dvec4& p) { return p.w != piece.values.front().w; });
  FoldCell cell{derivative_along(piece, Axis::u, is_rational), derivative_along(piece, Axis::v, is_rational), {}, {}};
  for (VectorNet* const net : {&cell.along_u, &cell.along_v}) {
    for (const Axis across : {Axis::u, Axis::v}) {
      for (const bool is_at_end : {false, true}) divide_by_border(*net, across, is_at_end);
    }
  }
  const Interval in_u = patch.knot_vector(Axis::u).span_interval(span_u);
  const Interval in_v = patch.knot_vector(Axis::v).span_interval(span_v);
  cell.u = {in_u.start, in_u.end};
  cell.v = {in_v.start, in_v.end};
  return cell;
}

glm::dvec3 mean_of(const VectorNet& net) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& one : net.values) sum += one;
  return sum;
}

/// Between which angles vectors lie about a direction, seen along a normal; none where some lie back from it.
std::optional<std::array<double, 2>> angles_about(const VectorNet& net, const glm::dvec3& direction, const glm::dvec3& normal) {
  const glm::dvec3 side = glm::cross(normal, direction);
  double low = 0.0;
  double high = 0.0;
  for (const glm::dvec3& one : net.values) {
    const double forward = glm::dot(one, direction);
    const double aside = glm::dot(one, side);
    if (forward == 0.0 && aside == 0.0) continue;
    if (!(forward > 0.0)) return {};
    low = std::min(low, aside / forward);
    high = std::max(high, aside / forward);
  }
  return std::array{std::atan(low), std::atan(high)};
}

/// Whether the derivatives turn one way about the normal in the middle, seen by bounds of their directions.
bool turns_one_way(const FoldCell& cell, const glm::dvec3& normal) {
  const glm::dvec3 u = mean_of(cell.along_u);
  const glm::dvec3 v = mean_of(cell.along_v);
  const glm::dvec3 flat_u = glm::normalize(u - normal * glm::dot(normal, u));
  const glm::dvec3 flat_v = glm::normalize(v - normal * glm::dot(normal, v));
  const auto of_u = angles_about(cell.along_u, flat_u, normal);
  const auto of_v = angles_about(cell.along_v, flat_v, normal);
  if (!of_u || !of_v) return false;
  const double between = std::atan2(glm::dot(glm::cross(flat_u, flat_v), normal), glm::dot(flat_u, flat_v));
  return between + (*of_v)[0] - (*of_u)[1] > 0.0 && between + (*of_v)[1] - (*of_u)[0] < std::numbers::pi;
}

/// The same by Bernstein coefficients of the normals' parts along that in the middle: also where these are 0 in a corner.
bool is_upright(const FoldCell& cell, const glm::dvec3& normal) {
  constexpr double kRounding = 1e-12;
  const BernsteinNet<double> parts = product<double>(
      cell.along_u, cell.along_v, [&](const glm::dvec3& u, const glm::dvec3& v) { return glm::dot(glm::cross(u, v), normal); });
  const double noise = kRounding * greatest(cell.along_u) * greatest(cell.along_v);
  const auto [low, high] = parts.range();
  return low >= -noise && high > noise;
}

/// The least cosine between normals in the corners.
double corner_turn(const FoldCell& cell) {
  const std::array<glm::dvec3, 4> u = cell.along_u.corners();
  const std::array<glm::dvec3, 4> v = cell.along_v.corners();
  double least = 1.0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const glm::dvec3 one = glm::cross(u[i], v[i]);
      const glm::dvec3 other = glm::cross(u[k], v[k]);
      const double lengths = length_of(one) * length_of(other);
      if (lengths > 0.0) least = std::min(least, glm::dot(one, other) / lengths);
    }
  }
  return least;
}

std::pair<FoldCell, FoldCell> halves(FoldCell cell, Axis axis) {
  FoldCell second = cell;
  cell.along_u.halve(axis, second.along_u);
  cell.along_v.halve(axis, second.along_v);
  const double middle = axis == Axis::u ? cell.middle_u() : cell.middle_v();
  (axis == Axis::u ? cell.u : cell.v)[1] = middle;
  (axis == Axis::u ? second.u : second.v)[0] = middle;
  return {std::move(cell), std::move(second)};
}

struct DeepCell {
  FoldCell cell;
  int depth;
  int apart;        ///< halvings since it has no corner of the patch
  bool is_regular;  ///< both derivatives turn one way in it, as has been shown
};

/// The four quarters, the one that turns most last.
void add_quarters(std::vector<DeepCell>& left, const DeepCell& whole, bool has_corner) {
  std::array<std::pair<double, FoldCell>, 4> parts;
  auto [low, high] = halves(whole.cell, Axis::u);
  std::size_t next = 0;
  for (FoldCell* const half : {&low, &high}) {
    auto [first, second] = halves(std::move(*half), Axis::v);
    parts[next++].second = std::move(first);
    parts[next++].second = std::move(second);
  }
  for (auto& [turn, part] : parts) turn = corner_turn(part);
  std::ranges::stable_sort(parts, std::ranges::greater(), [](const auto& part) { return part.first; });
  const int apart = has_corner ? 0 : whole.apart + 1;
  for (auto& [turn, part] : parts) left.push_back({std::move(part), whole.depth + 1, apart, false});
}

glm::dvec3 point_at(const NurbsPatch& patch, double u, double v) {
  glm::dvec3 point;
  evaluate(patch, std::span(&u, 1), std::span(&v, 1), std::span(&point.x, 3));
  return point;
}

/// Which ends of the patch's domain a cell has, along u and v: 0 or 1; none unless it has one of both.
std::optional<std::array<std::size_t, 2>> corner_in(const NurbsPatch& patch, const FoldCell& cell) {
  const auto end_of = [&](Axis axis, const std::array<double, 2>& part) -> std::optional<std::size_t> {
    const Interval domain = patch.knot_vector(axis).domain();
    if (part[0] == domain.start) return 0;
    return part[1] == domain.end ? std::optional<std::size_t>(1) : std::nullopt;
  };
  const auto u = end_of(Axis::u, cell.u);
  const auto v = end_of(Axis::v, cell.v);
  return u && v ? std::optional(std::array{*u, *v}) : std::nullopt;
}

/// Whether a cell ends within a tolerance of its corner.
bool is_small(const NurbsPatch& patch, const FoldCell& cell, const std::array<std::size_t, 2>& corner, double tolerance) {
  const auto [u, v] = corner;
  const glm::dvec3 at = point_at(patch, cell.u[u], cell.v[v]);
  const auto is_near = [&](double x, double y) { return distance_of(point_at(patch, x, y), at) <= tolerance; };
  return is_near(cell.u[1 - u], cell.v[v]) && is_near(cell.u[u], cell.v[1 - v]) &&
         is_near(cell.u[1 - u], cell.v[1 - v]);
}

/// Whether both derivatives span no plane in one of its corners inside the patch: beside a line of such places normals may turn round
/// from one part to the next.
bool is_singular_inside(const NurbsPatch& patch, const FoldCell& cell) {
  constexpr double kNoise = 1e-9;
  const Interval in_u = patch.knot_vector(Axis::u).domain();
  const Interval in_v = patch.knot_vector(Axis::v).domain();
  const std::array<glm::dvec3, 4> u = cell.along_u.corners();
  const std::array<glm::dvec3, 4> v = cell.along_v.corners();
  const double noise = kNoise * greatest(cell.along_u) * greatest(cell.along_v);
  for (std::size_t i = 0; i < 4; ++i) {
    const double at_u = cell.u[i / 2];
    const double at_v = cell.v[i % 2];
    if (at_u == in_u.start || at_u == in_u.end || at_v == in_v.start || at_v == in_v.end) continue;
    if (length_of(glm::cross(u[i], v[i])) <= noise) return true;
  }
  return false;
}

/// The least cosine between normals in corners that lie along an axis from each other.
double turn_along(const FoldCell& cell, Axis axis) {
  constexpr double kNoise = 1e-9;
  const std::array<glm::dvec3, 4> u = cell.along_u.corners();
  const std::array<glm::dvec3, 4> v = cell.along_v.corners();
  const double noise = kNoise * greatest(cell.along_u) * greatest(cell.along_v);
  const std::size_t step = axis == Axis::u ? 2 : 1;
  double least = 1.0;
  for (std::size_t i = 0; i < 4; ++i) {
    if ((i & step) != 0) continue;
    const glm::dvec3 one = glm::cross(u[i], v[i]);
    const glm::dvec3 other = glm::cross(u[i + step], v[i + step]);
    if (length_of(one) <= noise || length_of(other) <= noise) continue;
    least = std::min(least, glm::dot(one, other) / (length_of(one) * length_of(other)));
  }
  return least;
}

/// Whether one of the borders along an axis turns far between two parameters: what bends there as sharply goes on from it.
bool borders_turn(const NurbsPatch& patch, Axis axis, const std::array<double, 2>& part) {
  constexpr double kFar = 0.5;
  const bool is_u = axis == Axis::u;
  for (const Border border : {is_u ? Border::v_start : Border::u_start, is_u ? Border::v_end : Border::u_end}) {
    std::array<glm::dvec3, 4> jets;
    derivatives(boundary(patch, border), part, 1, std::span(&jets.front().x, 12));
    const double lengths = length_of(jets[1]) * length_of(jets[3]);
    if (!(glm::dot(jets[1], jets[3]) > kFar * lengths)) return true;
  }
  return false;
}

/// The axis along which normals in a cell turn so far that they may turn round within a tolerance; none where borders do, too.
std::optional<Axis> axis_of_turn(const NurbsPatch& patch, const FoldCell& cell, int depth) {
  constexpr int kWide = 3;
  constexpr double kLittle = 0.5;  // in two of three parts of one that turns round
  const double of_u = turn_along(cell, Axis::u);
  const double of_v = turn_along(cell, Axis::v);
  if (of_u >= kLittle && of_v >= kLittle) return {};
  const Axis axis = of_u < of_v ? Axis::u : Axis::v;
  if (depth >= kWide && borders_turn(patch, axis, axis == Axis::u ? cell.u : cell.v)) return {};
  return axis;
}

/// A place within one span either way.
std::optional<std::array<double, 2>> fold_within(const NurbsPatch& patch, const FoldCell& whole, double tolerance) {
  constexpr int kMostHalvings = 12;
  constexpr int kMostInCorner = 48;
  constexpr int kCoarse = 2;
  constexpr double kHairpin = 2.0;  // normals that turn round within so many tolerances are a fold without a singular place
  constexpr std::size_t kMostCells = 0x1p14;
  std::vector<DeepCell> left{{whole, 0, 0, false}};
  for (std::size_t seen = 0; !left.empty(); ++seen) {
    const DeepCell one = std::move(left.back());
    left.pop_back();
    const glm::dvec3 normal = glm::cross(mean_of(one.cell.along_u), mean_of(one.cell.along_v));
    const double length = length_of(normal);
    const auto is_shown = [&] {
      if (!(length > 0.0) || is_singular_inside(patch, one.cell)) return false;
      return turns_one_way(one.cell, normal / length) || (one.depth >= kCoarse && is_upright(one.cell, normal / length));
    };
    const bool is_regular = one.is_regular || is_shown();
    if (is_regular) {
      const std::optional<Axis> axis = axis_of_turn(patch, one.cell, one.depth);
      if (!axis || one.depth >= kMostInCorner) continue;
      if (is_small(patch, one.cell, {0, 0}, kHairpin * tolerance)) {
        return std::array{one.cell.middle_u(), one.cell.middle_v()};
      }
      auto [low, high] = halves(one.cell, *axis);
      for (FoldCell* const half : {&low, &high}) left.push_back({std::move(*half), one.depth + 1, one.apart, true});
      continue;
    }
    const auto corner = corner_in(patch, one.cell);
    if (corner && is_small(patch, one.cell, *corner, tolerance)) continue;
    const bool is_deep = corner ? one.depth >= kMostInCorner : one.apart >= kMostHalvings;
    if (is_deep || seen >= kMostCells) return std::array{one.cell.middle_u(), one.cell.middle_v()};
    add_quarters(left, one, corner.has_value());
  }
  return {};
}

/// The least cosine between normals beside a corner of borders: a crease where these turn round as sharply is no fold.
double crease_limit(const NurbsPatch& patch, Axis axis, double knot) {
  constexpr double kSharper = 1.25;
  const bool is_u = axis == Axis::u;
  const NurbsCurve one = boundary(patch, is_u ? Border::v_start : Border::u_start);
  const NurbsCurve other = boundary(patch, is_u ? Border::v_end : Border::u_end);
  const double turn = kSharper * std::max(kink_angle(one, knot), kink_angle(other, knot));
  return std::cos(std::clamp(turn, 0.5 * std::numbers::pi, std::numbers::pi));
}

/// A corner of two cells, one behind the other along an axis, beside which normals turn round, at a crease more sharply than its
/// borders.
std::optional<std::array<double, 2>> fold_between(const NurbsPatch& patch, const FoldCell& one, const FoldCell& next,
                                                  Axis axis) {
  constexpr double kNoise = 1e-9;
  const KnotVector& knots = patch.knot_vector(axis);
  const bool is_u = axis == Axis::u;
  const double knot = is_u ? next.u[0] : next.v[0];
  const double limit = multiplicity(knots, knot) < knots.degree() ? 0.0 : crease_limit(patch, axis, knot);
  const auto normal_in = [](const FoldCell& cell, std::size_t corner) {
    const glm::dvec3 normal = glm::cross(cell.along_u.corners()[corner], cell.along_v.corners()[corner]);
    const double noise = kNoise * greatest(cell.along_u) * greatest(cell.along_v);
    return length_of(normal) > noise ? normal : glm::dvec3(0.0);
  };
  for (const std::size_t other : {std::size_t{0}, std::size_t{1}}) {
    const std::size_t ahead = is_u ? other : 2 * other;
    const std::size_t behind = ahead + (is_u ? 2 : 1);
    const glm::dvec3 left = normal_in(one, behind);
    const glm::dvec3 right = normal_in(next, ahead);
    if (glm::dot(left, right) < limit * length_of(left) * length_of(right)) {
      return std::array{next.u[ahead / 2], next.v[ahead % 2]};
    }
  }
  return {};
}

std::vector<glm::dvec3> normals_along(const NurbsPatch& patch, Axis axis, double knot, const std::vector<double>& along,
                                      Side side) {
  const std::vector<double> at(along.size(), knot);
  std::vector<glm::dvec3> values(3 * along.size());
  const bool is_u = axis == Axis::u;
  PatchOptions options;
  (is_u ? options.side_u : options.side_v) = side;
  first_derivatives(patch, is_u ? at : along, is_u ? along : at, std::span(&values.front().x, 3 * values.size()), options);
  std::vector<glm::dvec3> found;
  for (std::size_t k = 0; k < along.size(); ++k) found.push_back(glm::cross(values[3 * k + 1], values[3 * k + 2]));
  return found;
}

/// A place of a crease, among many in every span of it, beside which normals turn round more sharply than at its ends.
std::optional<std::array<double, 2>> fold_at_creases(const NurbsPatch& patch, Axis axis) {
  constexpr int kInSpan = 24;
  constexpr double kRounding = 1e-24;  // of the squares of lengths: less is no normal
  const KnotVector& knots = patch.knot_vector(axis);
  const KnotVector& other = patch.knot_vector(axis == Axis::u ? Axis::v : Axis::u);
  for (int i = 0; i + 1 < static_cast<int>(knots.spans().size()); ++i) {
    const double knot = knots.span_interval(i).end;
    if (multiplicity(knots, knot) < knots.degree()) continue;
    const std::vector<double> along = places_of_spans({other.knots().begin(), other.knots().end()}, kInSpan);
    const std::vector<glm::dvec3> before = normals_along(patch, axis, knot, along, Side::left);
    const std::vector<glm::dvec3> behind = normals_along(patch, axis, knot, along, Side::right);
    const double limit = crease_limit(patch, axis, knot);
    const auto greatest_of = [](const std::vector<glm::dvec3>& all) { return std::ranges::max(all | std::views::transform(length_of)); };
    const double noise = kRounding * greatest_of(before) * greatest_of(behind);
    for (std::size_t k = 0; k < along.size(); ++k) {
      const double lengths = length_of(before[k]) * length_of(behind[k]);
      if (lengths <= noise || !(glm::dot(before[k], behind[k]) < limit * lengths)) continue;
      return axis == Axis::u ? std::array{knot, along[k]} : std::array{along[k], knot};
    }
  }
  return {};
}

}  // namespace

std::optional<glm::dvec3> fold_of(const NurbsPatch& patch, double tolerance) {
  const int count_u = static_cast<int>(patch.knot_vector(Axis::u).spans().size());
  const int count_v = static_cast<int>(patch.knot_vector(Axis::v).spans().size());
  std::vector<FoldCell> before;
  for (int i = 0; i < count_u; ++i) {
    std::vector<FoldCell> row;
    for (int k = 0; k < count_v; ++k) {
      row.push_back(cell_of(patch, i, k));
      auto place = fold_within(patch, row.back(), tolerance);
      if (!place && k > 0) place = fold_between(patch, row[static_cast<std::size_t>(k) - 1], row.back(), Axis::v);
      if (!place && i > 0) place = fold_between(patch, before[static_cast<std::size_t>(k)], row.back(), Axis::u);
      if (place) return point_at(patch, (*place)[0], (*place)[1]);
    }
    before = std::move(row);
  }
  for (const Axis axis : {Axis::u, Axis::v}) {
    const auto place = fold_at_creases(patch, axis);
    if (place) return point_at(patch, (*place)[0], (*place)[1]);
  }
  return {};
}

}  // namespace splinecore
