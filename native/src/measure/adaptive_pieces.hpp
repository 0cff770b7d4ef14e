#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "kronrod_grid.hpp"
#include "patch/bezier_piece.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "surface_rule.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A piece, or a part of one, that is measured.
template <std::size_t kCount>
struct MeasuredPiece {
  SurfacePiece piece;
  std::size_t patch;  ///< the number of the one that it belongs to
  IntegralSums<kCount> found;
};

/// The integrals over all pieces, and how often the worst is off by what it may, by the rule, where that is more than
/// rounding.
template <std::size_t kCount>
struct FoundIntegrals {
  IntegralSums<kCount> sums;
  double excess = 0.0;
};

/// Adds up integrals over the pieces of patches between knots, and halves them until none is off by more than it may,
/// or until there are too many.
template <std::size_t kCount>
class AdaptivePieces {
 public:
  using Piece = MeasuredPiece<kCount>;
  /// Works out what was found, of some pieces at once.
  using Measure = std::function<void(std::span<Piece>)>;
  /// What each integral may be off by, given those found so far: infinity where any error will do.
  using Targets = std::function<Integrals<kCount>(const IntegralSums<kCount>&)>;

  /// @param what  the beginning of sentences: "the volume cannot be found"
  AdaptivePieces(const char* what, Measure measure) : what_(what), measure_(std::move(measure)) {}

  /// @throws InvalidShape where its weights differ too much.
  void add(const NurbsPatch& patch) {
    const auto spans_u = static_cast<int>(patch.knot_vector(Axis::u).spans().size());
    const auto spans_v = static_cast<int>(patch.knot_vector(Axis::v).spans().size());
    for (int i = 0; i < spans_u; ++i) {
      for (int j = 0; j < spans_v; ++j) add_piece({.net = bezier_piece(patch, i, j)});
    }
    ++patches_;
  }

  /// @throws InvalidShape where sums are no numbers.
  FoundIntegrals<kCount> found(const Targets& targets) {
    measure_(pieces_);
    const std::size_t most = kMostPieces + 4 * pieces_.size();
    Integrals<kCount> before;
    before.fill(std::numeric_limits<double>::infinity());
    while (true) {
      const IntegralSums<kCount> sums = sum();
      const Integrals<kCount> allowed = targets(sums);
      double excess = 0.0;
      for (std::size_t k = 0; k < kCount; ++k) {
        const double error = sums.error(k);
        // Where halving no longer helps only rounding is left.
        const bool is_steady = error > 0.5 * before[k] && error <= kNoise * sums.rounding(k);
        const bool is_wrong = error > std::max(kCaution * allowed[k], 2.0 * sums.rounding(k)) && !is_steady;
        before[k] = error;
        if (is_wrong) excess = std::max(excess, error / allowed[k]);
      }
      if (excess == 0.0 || pieces_.size() > most || !refine(allowed)) return {sums, excess};
    }
  }

 private:
  /// The changes of a rule are no bound; to be sure they are kept so much smaller.
  static constexpr double kCaution = 0.125;
  static constexpr double kNoise = 8.0;
  static constexpr std::size_t kMostPieces = 16'000;

  void add_piece(SurfacePiece first) {
    constexpr double kMost = 16.0;
    first.normalize();
    std::vector<SurfacePiece> stack{std::move(first)};
    for (std::size_t cuts = 0; !stack.empty();) {
      SurfacePiece piece = std::move(stack.back());
      stack.pop_back();
      const Unevenness u = piece.unevenness(Axis::u);
      const Unevenness v = piece.unevenness(Axis::v);
      if (std::max(u.ratio, v.ratio) <= kMost) {
        pieces_.push_back({std::move(piece), patches_, {}});
        continue;
      }
      if (++cuts > kMostPieces) throw InvalidShape(too_different("weights of the patch"));
      stack.emplace_back();
      piece.halve(u > v ? Axis::u : Axis::v, stack.back());
      stack.push_back(std::move(piece));
    }
  }

  std::string too_different(const char* which) const {
    return std::string(what_) + ": the " + which + " differ too much in size for it";
  }

  IntegralSums<kCount> sum() const {
    IntegralSums<kCount> sums;
    for (std::size_t k = 0; k < kCount; ++k) {
      double lost = 0.0;  // of many pieces: what a sum loses goes into the next one (Kahan 1965)
      for (const Piece& piece : pieces_) {
        const double more = piece.found.values[k] - lost;
        const double total = sums.values[k] + more;
        lost = (total - sums.values[k]) - more;
        sums.values[k] = total;
        for (int axis = 0; axis < 2; ++axis) sums.errors[axis][k] += piece.found.errors[axis][k];
        sums.terms[k] += piece.found.terms[k];
      }
      if (!std::isfinite(sums.values[k]) || !std::isfinite(sums.terms[k]) || !std::isfinite(sums.error(k))) {
        throw InvalidShape(too_different("points and weights"));
      }
    }
    return sums;
  }

  /// How many times a piece is off along a direction by its share, where that is more than rounding.
  static double wrongness(const Piece& piece, int axis, const Integrals<kCount>& shares) {
    double most = 0.0;
    for (std::size_t k = 0; k < kCount; ++k) {
      const double error = piece.found.errors[axis][k];
      if (error > piece.found.rounding(k)) most = std::max(most, error / shares[k]);
    }
    return most;
  }

  /// Halves the pieces that are off by more than their share. False if there was none.
  bool refine(const Integrals<kCount>& allowed) {
    Integrals<kCount> shares = allowed;
    for (double& share : shares) share *= 0.25 * kCaution / static_cast<double>(pieces_.size());
    std::vector<Piece> kept;
    std::vector<Piece> halves;
    kept.reserve(pieces_.size());
    for (Piece& piece : pieces_) {
      const double u = wrongness(piece, 0, shares);
      const double v = wrongness(piece, 1, shares);
      if (std::max(u, v) <= 1.0) {
        kept.push_back(std::move(piece));
        continue;
      }
      SurfacePiece second;
      piece.piece.halve(u > v ? Axis::u : Axis::v, second);
      halves.push_back({std::move(piece.piece), piece.patch, {}});
      halves.push_back({std::move(second), piece.patch, {}});
    }
    pieces_ = std::move(kept);
    if (halves.empty()) return false;
    measure_(halves);
    std::ranges::move(halves, std::back_inserter(pieces_));
    return true;
  }

  const char* what_;
  Measure measure_;
  std::size_t patches_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace splinecore
#pragma GCC visibility pop
