#include "splinecore/patch/distance.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "difference.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// The search for the largest length, in the piece first that may have it.
class Search {
 public:
  void add(DifferencePiece piece) {
    if (piece.is_left_out()) return;
    known_ = std::max(known_, piece.known());
    const double bound = piece.bound();
    const bool tells_nothing_new = bound <= kSlack * known_ || piece.is_rounding();
    if (tells_nothing_new && std::isfinite(bound)) {
      settled_ = std::max(settled_, bound);
    } else {
      open_.push({bound, std::move(piece)});
    }
  }

  void run() {
    constexpr double kMaxWork = 1e8;  // multiplications: less than a second, which no patch of modelling needs
    for (double work = 0.0; !is_done() && work < kMaxWork;) {
      const DifferencePiece worst = open_.top().piece;
      open_.pop();
      work += worst.work();
      for (DifferencePiece& quarter : worst.quarters()) add(std::move(quarter));
    }
  }

  double result() const { return std::max({known_, settled_, open_.empty() ? 0.0 : open_.top().bound}); }

 private:
  static constexpr double kSlack = 1.02;

  struct Open {
    double bound;
    DifferencePiece piece;
    bool operator<(const Open& other) const { return bound < other.bound; }
  };

  bool is_done() const { return open_.empty() || open_.top().bound <= kSlack * std::max(known_, settled_); }

  double known_ = 0.0;
  double settled_ = 0.0;
  std::priority_queue<Open> open_;
};

}  // namespace

double largest_distance(const NurbsPatch& a, const NurbsPatch& b) {
  for (const Axis axis : {Axis::u, Axis::v}) {
    if (a.knot_vector(axis).domain() != b.knot_vector(axis).domain()) throw InvalidShape("the domains differ");
  }
  Search search;
  for (DifferencePiece& piece : difference_pieces(a, b)) search.add(std::move(piece));
  search.run();
  return search.result();
}

}  // namespace splinecore
