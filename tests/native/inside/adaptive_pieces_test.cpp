#include "measure/adaptive_pieces.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace splinecore {
namespace {

NurbsPatch square() {
  return NurbsPatch::make(KnotVector::clamped(1, 2), KnotVector::clamped(1, 2),
                          {{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}});
}

struct Seen {
  FoundIntegrals<1> found;
  std::size_t pieces = 0;
};

/// What is found by a rule whose error on a piece is what a function of its extent along u says.
template <class Error>
Seen found_with(const Error& error, double allowed) {
  Seen seen;
  AdaptivePieces<1> adaptive("the measure cannot be found", [&](std::span<MeasuredPiece<1>> pieces) {
    for (auto& piece : pieces) {
      const auto corners = piece.piece.net.corners();
      const double width = corners[3].x - corners[0].x;
      const double height = corners[3].y - corners[0].y;
      piece.found.values = {width * height};
      piece.found.errors = {Integrals<1>{error(width, height)}, Integrals<1>{0.0}};
      piece.found.terms = {width * height};
    }
    seen.pieces += pieces.size();
  });
  adaptive.add(square());
  seen.found = adaptive.found([&](const IntegralSums<1>&) { return Integrals<1>{allowed}; });
  return seen;
}

TEST(AdaptivePieces, HalvesUntilTheErrorIsAnEighthOfWhatIsAllowed) {
  const Seen seen = found_with([](double width, double height) { return width * width * width * height; }, 1e-4);
  EXPECT_EQ(seen.found.excess, 0.0);
  EXPECT_DOUBLE_EQ(seen.found.sums.values[0], 1.0);
  EXPECT_LE(seen.found.sums.error(0), 0.125e-4);
  EXPECT_LE(seen.pieces, 1024u);
}

TEST(AdaptivePieces, TellsHowOftenTheErrorIsTooLargeWhereHalvingDoesNotHelp) {
  const Seen seen = found_with([](double width, double height) { return 0.01 * width * height; }, 1e-4);
  EXPECT_NEAR(seen.found.excess, 100.0, 1e-6);
  EXPECT_DOUBLE_EQ(seen.found.sums.values[0], 1.0);
  EXPECT_LE(seen.pieces, 4u * 16'004u) << "it ends";
}

TEST(AdaptivePieces, HalvesNothingForWhatIsRounding) {
  const Seen seen = found_with([](double width, double height) { return 0x1p-51 * width * height; }, 1e-300);
  EXPECT_EQ(seen.found.excess, 0.0);
  EXPECT_EQ(seen.pieces, 1u);
}

TEST(AdaptivePieces, RefusesWhatIsNoNumber) {
  EXPECT_THROW(found_with([](double, double) { return std::numeric_limits<double>::quiet_NaN(); }, 1.0), InvalidShape);
  EXPECT_THROW(found_with([](double, double) { return std::numeric_limits<double>::infinity(); }, 1.0), InvalidShape);
}

}  // namespace
}  // namespace splinecore
