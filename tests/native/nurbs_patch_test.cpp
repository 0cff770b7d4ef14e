#include "splinecore/patch/nurbs_patch.hpp"

#include <limits>

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

constexpr Axis kAxes[] = {Axis::u, Axis::v};

/// A pair of parameters of a domain each, given as what the axis of a verb has and the other one.
struct Pair {
  double along;
  double across;
};

glm::dvec4 at(const NurbsPatch& patch, Axis axis, Pair pair) {
  return axis == Axis::u ? homogeneous_at(patch, pair.along, pair.across)
                         : homogeneous_at(patch, pair.across, pair.along);
}

Interval domain(const NurbsPatch& patch, Axis axis) { return patch.knot_vector(axis).domain(); }

double across(Random& random, const NurbsPatch& patch, Axis axis) {
  const Interval range = domain(patch, axis == Axis::u ? Axis::v : Axis::u);
  return real(random, range.start, range.end);
}

TEST(RefinePatch, KeepsRandomPatchesInEitherDirection) {
  Random random(120);
  for (int round = 0; round < 500; ++round) {
    const NurbsPatch patch = random_patch(random);
    for (const Axis axis : kAxes) {
      const std::vector<double> inserted = random_parameters(random, domain(patch, axis), 3);
      const NurbsPatch refined = refine(patch, axis, inserted);
      EXPECT_EQ(refined.count(axis), patch.count(axis) + 3);
      for (const double along : random_parameters(random, domain(patch, axis), 3)) {
        const Pair pair{along, across(random, patch, axis)};
        EXPECT_LE(largest(at(patch, axis, pair) - at(refined, axis, pair)), 1e-12 * size_of(patch));
      }
    }
  }
}

TEST(InsertKnotIntoPatch, CopiesUntouchedPointsBitForBit) {
  Random random(121);
  const NurbsPatch patch = NurbsPatch::make(KnotVector::clamped(2, 6), KnotVector::clamped(3, 7),
                                            random_points(random, 42, Weights::positive));
  const NurbsPatch refined = insert_knot(patch, Axis::v, 0.5);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(refined.points()[i * 8], patch.points()[i * 7]);
    for (int j = 4; j < 8; ++j) EXPECT_EQ(refined.points()[i * 8 + j], patch.points()[i * 7 + j - 1]) << i << " " << j;
  }
}

TEST(SplitPatch, GivesBothPartsInEitherDirection) {
  Random random(122);
  for (int round = 0; round < 500; ++round) {
    const auto kind = [&] {
      return Kind{integer(random, 1, 5), integer(random, 1, 3), static_cast<Ends>(integer(random, 0, 1)),
                  Weights::positive};
    };
    const Kind u = kind();
    const NurbsPatch patch = random_patch(random, u, kind());
    for (const Axis axis : kAxes) {
      const Interval range = domain(patch, axis);
      const double cut = range.start + range.length() * real(random, 0.01, 0.99);
      const auto [before, after] = split(patch, axis, cut);
      EXPECT_EQ(domain(before, axis), (Interval{range.start, cut}));
      EXPECT_EQ(domain(after, axis), (Interval{cut, range.end}));
      for (const NurbsPatch& part : {before, after}) {
        const Pair pair{domain(part, axis).middle(), across(random, patch, axis)};
        EXPECT_LE(largest(at(patch, axis, pair) - at(part, axis, pair)), 1e-12 * size_of(patch));
      }
    }
  }
}

TEST(ReversedPatch, RunsBackwardsInOneDirection) {
  Random random(123);
  for (int round = 0; round < 500; ++round) {
    const NurbsPatch patch = random_patch(random);
    for (const Axis axis : kAxes) {
      const NurbsPatch back = reversed(patch, axis);
      const Interval range = domain(patch, axis);
      EXPECT_EQ(domain(back, axis), range);
      const Pair pair{real(random, range.start, range.end), across(random, patch, axis)};
      const Pair mirrored{range.start + (range.end - pair.along), pair.across};
      EXPECT_LE(largest(at(patch, axis, pair) - at(back, axis, mirrored)), 1e-12 * size_of(patch));
    }
  }
}

TEST(OpenedPatch, IsThePeriodicPatchFromThereOn) {
  Random random(124);
  for (int round = 0; round < 300; ++round) {
    const Kind ring{integer(random, 1, 5), integer(random, 1, 4), Ends::periodic, Weights::any};
    const NurbsPatch patch = random_patch(random, ring, ring);
    for (const Axis axis : kAxes) {
      const Interval range = domain(patch, axis);
      const NurbsPatch open = opened(patch, axis, real(random, range.start, range.end));
      EXPECT_FALSE(open.knot_vector(axis).periodic());
      const Interval part = domain(open, axis);
      const Pair pair{real(random, part.start, part.end), across(random, patch, axis)};
      EXPECT_LE(largest(at(patch, axis, pair) - at(open, axis, pair)), 1e-12 * size_of(patch));
    }
  }
}

TEST(UnrolledPatch, IsTheSameOnPlainKnots) {
  Random random(125);
  for (int round = 0; round < 300; ++round) {
    const NurbsPatch patch = random_patch(random);
    const NurbsPatch plain = unrolled(patch);
    EXPECT_FALSE(plain.knot_vector(Axis::u).periodic() || plain.knot_vector(Axis::v).periodic());
    const double u = random_parameters(random, domain(patch, Axis::u), 1)[0];
    const double v = random_parameters(random, domain(patch, Axis::v), 1)[0];
    EXPECT_EQ(homogeneous_at(patch, u, v), homogeneous_at(plain, u, v));
  }
}

TEST(SwappedPatch, ExchangesItsParametersAndKeepsItsPoints) {
  Random random(126);
  for (int round = 0; round < 300; ++round) {
    const NurbsPatch patch = random_patch(random);
    const double u = random_parameters(random, domain(patch, Axis::u), 1)[0];
    const double v = random_parameters(random, domain(patch, Axis::v), 1)[0];
    EXPECT_LE(largest(homogeneous_at(patch, u, v) - homogeneous_at(swapped(patch), v, u)), 1e-14 * size_of(patch));
    EXPECT_EQ(swapped(swapped(patch)), patch);
  }
}

TEST(NurbsPatchMake, NamesWhatIsWrong) {
  const KnotVector line = KnotVector::bezier(1);
  const KnotVector flat = KnotVector::make(0, {0, 1});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const KnotVector& u, const KnotVector& v, std::vector<glm::dvec4> points) {
    return refusal([&] { NurbsPatch::make(u, v, points); });
  };
  const std::vector<glm::dvec4> good(4, glm::dvec4(1));
  EXPECT_EQ(refused(line, flat, good), "degree in v = 0: a patch needs degree 1 or more");
  EXPECT_EQ(refused(flat, line, good), "degree in u = 0: a patch needs degree 1 or more");
  EXPECT_EQ(refused(line, KnotVector::bezier(2), good), "points has 4 entries, but the knots belong to 2 x 3");
  EXPECT_EQ(refused(line, line, {{0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}, {0, nan, 0, 1}}),
            "points[1, 1].y = nan is not finite");
  EXPECT_EQ(refused(line, line, {{0, 0, 0, 1}, {0, 0, 0, -nan}, {0, 0, 0, 1}, {0, 0, 0, 1}}).substr(0, 13),
            "weights[0, 1]");
  EXPECT_EQ(refused(line, line, std::vector<glm::dvec4>(4, glm::dvec4(1, 2, 3, 0))),
            "weights are all zero: no point of the shape is finite");
  EXPECT_EQ(refused(KnotVector::make(2, {0, 1, 2, 3}), line, {{0, 0, 0, 1}, {0, 0, 0, 1}}),
            "knots leave no domain: for degree 2 the knots u_2 and u_1 must differ");
}

TEST(NurbsPatch, RefusesWhatItsDirectionDoesNotAllow) {
  const NurbsPatch patch = NurbsPatch::make(KnotVector::periodic_uniform(1, 2), KnotVector::bezier(1),
                                            std::vector<glm::dvec4>(4, glm::dvec4(1)));
  EXPECT_EQ(refusal([&] { opened(patch, Axis::v, 0.5); }), "only a periodic direction can be opened");
  EXPECT_EQ(refusal([&] { split(patch, Axis::u, 0.5); }),
            "a periodic shape is not cut in two at one parameter: open it there first");
  EXPECT_EQ(refusal([&] { split(patch, Axis::v, 1); }), "u = 1 is not inside the domain (0, 1)");
  EXPECT_EQ(refusal([&] { insert_knot(patch, Axis::v, 0.5, 3); }), "times = 3 is outside [1, 2]");
}

}  // namespace
}  // namespace splinecore
