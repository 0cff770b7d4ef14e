#include "quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

constexpr double kRounding = 0x1p-52;
/// What rounding may leave of a change, in units of it.
constexpr double kNoise = 8.0;
/// The changes are no bound where a function has a corner between nodes.
constexpr double kCaution = 0.125;

/// What weights, of which the largest of a patch is about 1, are multiplied by so that products of wild ones stay.
double lift_of(double w) { return std::abs(w) < 0x1p-150 && w != 0.0 ? 0x1p440 : 1.0; }

/// A patch, from which pieces between knots are taken: each about an origin of its own, so that no digit is lost far
/// away, and over [0, 1]², however its parameters run.
class Source {
 public:
  Source(const NurbsPatch& patch, const Placement& placement, SurfaceIntegral& integral)
      : patch_(patch), placement_(placement), integral_(&integral) {}

  PieceIntegral integral(const SurfacePiece& piece, Integrand integrand) const {
    return (*integral_)(piece, integrand);
  }

  SurfacePiece piece(int i, int j) const {
    const KnotVector& u = patch_.knot_vector(Axis::u);
    const KnotVector& v = patch_.knot_vector(Axis::v);
    SurfacePiece found{near_points(u.spans()[i] - u.degree(), v.spans()[j] - v.degree())};
    found.net = bezier_piece(u.bezier_matrix(i), v.bezier_matrix(j), found.net.values.data(), found.net.columns);
    const auto [low, high] = found.net.range(&glm::dvec4::w);
    found.is_mixed = low <= 0.0 && high >= 0.0;
    found.normalize();
    return found;
  }

 private:
  const glm::dvec4& given(int i, int j) const {
    const int rows = patch_.count(Axis::u);
    const int columns = patch_.count(Axis::v);
    return patch_.points()[static_cast<std::size_t>(i % rows) * columns + j % columns];
  }

  double scaled(double x) const { return std::ldexp(x, -placement_.exponent); }
  glm::dvec3 scaled(const glm::dvec4& p) const { return {scaled(p.x), scaled(p.y), scaled(p.z)}; }

  /// The homogeneous points of a piece, about the first one of them that is no direction.
  SurfacePiece near_points(int first_u, int first_v) const {
    const auto rows = static_cast<std::size_t>(patch_.knot_vector(Axis::u).degree()) + 1;
    const auto columns = static_cast<std::size_t>(patch_.knot_vector(Axis::v).degree()) + 1;
    const std::size_t width = patch_.knot_vector(Axis::v).unrolled_count();
    const glm::dvec4* const corner = patch_.homogeneous_points().data() + first_u * width + first_v;
    SurfacePiece piece{{rows, columns, std::vector<glm::dvec4>(rows * columns)}};
    const glm::dvec4* origin = nullptr;
    double lift = 1.0;
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        const double w = corner[i * width + j].w;
        if (!origin && w != 0.0) origin = &given(first_u + static_cast<int>(i), first_v + static_cast<int>(j));
        lift = std::max(lift, lift_of(w));
      }
    }
    const glm::dvec3 o = origin ? scaled(*origin) : glm::dvec3(0.0);
    piece.origin = o - scaled(glm::dvec4(placement_.origin, 1.0));
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        const glm::dvec4& h = corner[i * width + j];
        const double w = lift * h.w;
        glm::dvec3 p = lift * scaled(h);
        if (w != 0.0) {
          p = scaled(given(first_u + static_cast<int>(i), first_v + static_cast<int>(j))) - o;
          piece.extent = glm::max(piece.extent, glm::abs(p));
          p *= w;
        }
        piece.net.at(i, j) = {p, w};
      }
    }
    return piece;
  }

  const NurbsPatch& patch_;
  const Placement& placement_;
  SurfaceIntegral* integral_;
};

/// A piece, or a part of one, that is measured.
struct SourceCell {
  const Source* source;
  int i;
  int j;
  SurfacePiece piece;  ///< with no points where it is all between its knots
  PieceIntegral found;
};

/// Adds up the parts of an integral, and finds where they are to be halved.
class Adaptive {
 public:
  Adaptive(Integrand integrand, double tolerance, const char* what)
      : integrand_(integrand), tolerance_(tolerance), what_(what) {}

  /// Takes the piece between two pairs of knots, cut where its weights differ much.
  void add(const Source& source, int i, int j) {
    constexpr double kMost = 16.0;
    std::vector<SurfacePiece> stack{source.piece(i, j)};
    for (std::size_t cuts = 0; !stack.empty();) {
      SurfacePiece piece = std::move(stack.back());
      stack.pop_back();
      const Unevenness u = piece.unevenness(Axis::u);
      const Unevenness v = piece.unevenness(Axis::v);
      if (std::max(u.ratio, v.ratio) <= kMost) {
        const PieceIntegral found = source.integral(piece, integrand_);
        if (cuts == 0) piece.net = {};
        cells_.push_back({&source, i, j, std::move(piece), found});
        continue;
      }
      const std::size_t points = piece.net.values.size();
      if (++cuts > kMostCells || (points_ += points) > kMostPoints) {
        throw InvalidShape(std::string(what_) + ": the weights of the patch differ too much in size for it");
      }
      stack.emplace_back();
      piece.halve(u > v ? Axis::u : Axis::v, stack.back());
      stack.push_back(std::move(piece));
    }
  }

  /// The integral and its error, both as large as given_size() says. @param dimension  of the measure
  Approximation<double> found(const Placement& placement, int dimension) {
    most_ = kMostCells + 4 * cells_.size();
    double before = HUGE_VAL;
    while (true) {
      add_up();
      const double wanted = tolerance_ * std::abs(sum_.value);
      const double rounding = kRounding * sum_.terms;
      const double error = sum_.error();
      const double target = std::max(kCaution * wanted, rounding);
      if (error <= target) break;
      // Where halving no longer helps only rounding is left.
      const bool is_steady = error > 0.5 * before && error <= std::max(wanted, kNoise * rounding);
      if (is_steady) break;
      before = error;
      if (has_room() && refine(target)) continue;
      // Without an error to blame, what is left is the noise of all cells together.
      const double allowed = std::max(wanted, has_room() ? kNoise * rounding : rounding);
      if (error <= allowed) break;
      throw ToleranceNotReached(what_, given_size(allowed, dimension, placement),
                                given_size(error, dimension, placement));
    }
    return {sum_.value, sum_.error() + kRounding * sum_.terms};
  }

 private:
  static constexpr std::size_t kMostCells = 16'000;
  static constexpr std::size_t kMostPoints = 4'000'000;

  void add_up() {
    sum_ = {};
    double lost = 0.0;  // of many cells: what a sum loses goes into the next one (Kahan 1965)
    for (const SourceCell& cell : cells_) {
      const double more = cell.found.value - lost;
      const double sum = sum_.value + more;
      lost = (sum - sum_.value) - more;
      sum_.value = sum;
      for (int axis = 0; axis < 2; ++axis) sum_.errors[axis] += cell.found.errors[axis];
      sum_.terms += cell.found.terms;
    }
    if (std::isfinite(sum_.value) && std::isfinite(sum_.terms) && std::isfinite(sum_.error())) return;
    throw InvalidShape(std::string(what_) + ": points and weights differ too much in size for it");
  }

  bool has_room() const { return cells_.size() <= most_ && points_ <= kMostPoints; }

  /// Halves the cells whose error is more than their share, along the directions where it is. False if there was none.
  bool refine(double target) {
    const double share = 0.5 * target / static_cast<double>(cells_.size());
    const auto is_wrong = [&](const SourceCell& cell) {
      return cell.found.error() > std::max(share, kRounding * cell.found.terms);
    };
    if (std::ranges::none_of(cells_, is_wrong)) return false;
    std::vector<SourceCell> next;
    next.reserve(cells_.size());
    for (SourceCell& cell : cells_) {
      if (is_wrong(cell)) {
        halve(std::move(cell), share, next);
      } else {
        next.push_back(std::move(cell));
      }
    }
    cells_ = std::move(next);
    return true;
  }

  void halve(SourceCell cell, double share, std::vector<SourceCell>& out) {
    if (cell.piece.net.values.empty()) cell.piece = cell.source->piece(cell.i, cell.j);
    const auto [u, v] = cell.found.errors;
    const bool is_both = std::min(u, v) > 0.5 * share;
    std::array<SurfacePiece, 4> parts;
    parts[0] = std::move(cell.piece);
    parts[0].halve(u > v ? Axis::u : Axis::v, parts[1]);
    if (is_both) {
      for (int i = 0; i < 2; ++i) parts[i].halve(u > v ? Axis::v : Axis::u, parts[i + 2]);
    }
    for (int i = 0; i < (is_both ? 4 : 2); ++i) {
      points_ += parts[i].net.values.size();
      const PieceIntegral found = cell.source->integral(parts[i], integrand_);
      out.push_back({cell.source, cell.i, cell.j, std::move(parts[i]), found});
    }
  }

  Integrand integrand_;
  double tolerance_;
  const char* what_;
  std::vector<SourceCell> cells_;
  PieceIntegral sum_;
  std::size_t most_ = 0;
  std::size_t points_ = 0;  ///< of all pieces that were cut
};

}  // namespace

Approximation<double> surface_integral(std::span<const NurbsPatch* const> patches, const Placement& placement,
                                       Integrand integrand, double tolerance, const char* what) {
  Adaptive adaptive(integrand, tolerance, what);
  std::map<std::pair<int, int>, SurfaceIntegral> integrals;
  std::vector<Source> sources;
  for (const NurbsPatch* patch : patches) {
    const int u = patch->knot_vector(Axis::u).degree();
    const int v = patch->knot_vector(Axis::v).degree();
    sources.emplace_back(*patch, placement, integrals.try_emplace({u, v}, u, v).first->second);
  }
  for (std::size_t part = 0; part < patches.size(); ++part) {
    const auto spans_u = static_cast<int>(patches[part]->knot_vector(Axis::u).spans().size());
    const auto spans_v = static_cast<int>(patches[part]->knot_vector(Axis::v).spans().size());
    for (int i = 0; i < spans_u; ++i) {
      for (int j = 0; j < spans_v; ++j) adaptive.add(sources[part], i, j);
    }
  }
  return adaptive.found(placement, integrand == Integrand::area ? 2 : 3);
}

void require_relative(double tolerance) {
  if (tolerance > 0.0 && std::isfinite(tolerance)) return;
  throw InvalidShape("tolerance = " + text_of(tolerance) + " is not a positive number");
}

}  // namespace splinecore
