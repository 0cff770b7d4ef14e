#include <glm/mat4x4.hpp>

#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/distance.hpp"
#include "splinecore/patch/ends.hpp"
#include "splinecore/patch/removal.hpp"
#include "splinecore/patch/transform.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

constexpr int kRounds = 1000;

Axis random_axis(Random& random) { return integer(random, 0, 1) == 0 ? Axis::u : Axis::v; }

/// Degrees 1 to 9 in each direction, one to three spans, multiple knots, any ends and any weights.
NurbsPatch any_patch(Random& random, int least_degree = 1) {
  const auto kind = [&] {
    return Kind{integer(random, least_degree, 9), integer(random, 1, 3), static_cast<Ends>(integer(random, 0, 2)),
                static_cast<Weights>(integer(random, 0, 2))};
  };
  const Kind u = kind();
  return random_patch(random, u, kind());
}

double inside(Random& random, Interval range) { return range.start + range.length() * real(random, 0.0, 1.0); }

/// Largest distance of homogeneous points, relative to the largest of them.
double farthest(Random& random, const NurbsPatch& before, const NurbsPatch& after) {
  double far = 0.0;
  for (int i = 0; i < 6; ++i) {
    const double u = inside(random, before.knot_vector(Axis::u).domain());
    const double v = inside(random, before.knot_vector(Axis::v).domain());
    far = worse(far, largest(homogeneous_at(before, u, v) - homogeneous_at(after, u, v)));
  }
  return far / size_of(before);
}

TEST(PatchElevation, KeepsAThousandPatchesAndIsUndoneByReduction) {
  Random random(301);
  for (int round = 0; round < kRounds; ++round) {
    const NurbsPatch patch = any_patch(random);
    const Axis axis = random_axis(random);
    const NurbsPatch raised = elevated(patch, axis);
    EXPECT_EQ(raised.knot_vector(axis).degree(), patch.knot_vector(axis).degree() + 1);
    EXPECT_EQ(raised.rational(), patch.rational());
    EXPECT_LE(farthest(random, patch, raised), 1e-14) << round;
    const NurbsPatch back = reduced(raised, axis).value;
    EXPECT_EQ(back.knot_vector(axis).degree(), patch.knot_vector(axis).degree());
    EXPECT_LE(farthest(random, patch, back), 1e-12) << round;
  }
}

TEST(PatchRemoval, UndoesInsertionInAThousandPatches) {
  Random random(302);
  for (int round = 0; round < kRounds; ++round) {
    const NurbsPatch patch = any_patch(random);
    const Axis axis = random_axis(random);
    const double at = inside(random, patch.knot_vector(axis).domain());
    const int times = integer(random, 1, patch.knot_vector(axis).degree());
    const NurbsPatch back = remove_knot(insert_knot(patch, axis, at, times), axis, at, times).value;
    EXPECT_EQ(back.count(axis), patch.count(axis));
    EXPECT_LE(farthest(random, patch, back), 1e-12) << round;
  }
}

TEST(PatchEnds, AreClampedAndUnclampedWithoutAChangeInAThousandPatches) {
  Random random(303);
  for (int round = 0; round < kRounds; ++round) {
    const NurbsPatch patch = any_patch(random);
    const Axis axis = random_axis(random);
    const NurbsPatch whole = clamped(patch, axis);
    EXPECT_FALSE(whole.knot_vector(axis).periodic());
    EXPECT_LE(farthest(random, patch, whole), 1e-13) << round;
    const NurbsPatch open = unclamped(whole, axis);
    EXPECT_LE(farthest(random, patch, open), 1e-12) << round;
    EXPECT_LE(farthest(random, patch, clamped(open, axis)), 1e-12) << round;
  }
}

TEST(PatchEnds, OfAnOpenedOrUnrolledPeriodicPatchCloseAgain) {
  Random random(304);
  for (int round = 0; round < 200; ++round) {
    const Axis axis = random_axis(random);
    const int degree = integer(random, 1, 9);
    const KnotVector ring = KnotVector::periodic_uniform(degree, degree + integer(random, 2, 5));
    const KnotVector other = random_knots(random, integer(random, 1, 9), 2, Ends::clamped);
    auto points = random_points(random, ring.count() * other.count(), Weights::positive);
    const NurbsPatch patch = axis == Axis::u ? NurbsPatch::make(ring, other, std::move(points))
                                             : NurbsPatch::make(other, ring, std::move(points));
    for (const NurbsPatch& plain : {clamped(patch, axis), unrolled(patch)}) {
      const Approximation<NurbsPatch> closed = made_periodic(plain, axis, 1e-9);
      EXPECT_EQ(closed.value.count(axis), patch.count(axis)) << round;
      EXPECT_LE(closed.error, 1e-9);
      EXPECT_LE(farthest(random, patch, closed.value), 1e-11) << round;
    }
  }
}

TEST(PatchDomain, IsMappedWithoutMovingAPoint) {
  Random random(305);
  for (int round = 0; round < kRounds; ++round) {
    const NurbsPatch patch = any_patch(random);
    const Axis axis = random_axis(random);
    const Interval domain{real(random, -4.0, 0.0), real(random, 1.0, 20.0)};
    const NurbsPatch mapped = with_domain(patch, axis, domain);
    EXPECT_EQ(mapped.knot_vector(axis).domain(), domain);
    EXPECT_TRUE(std::ranges::equal(mapped.points(), patch.points()));
    const NurbsPatch back = with_domain(mapped, axis, patch.knot_vector(axis).domain());
    EXPECT_LE(farthest(random, patch, back), 1e-12) << round;
  }
}

/// The largest sine of the angle between homogeneous points of four coordinates, relative to their size.
double misfit(const glm::dvec4& a, const glm::dvec4& b) {
  double far = 0.0;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < i; ++k) far = worse(far, std::abs(a[i] * b[k] - a[k] * b[i]));
  }
  return far / (largest(a) * largest(b));
}

TEST(PatchMoebius, KeepsTheSurfaceUnderTheMapOfItsParameter) {
  Random random(306);
  for (int round = 0; round < kRounds; ++round) {
    const NurbsPatch patch = any_patch(random);
    const Axis axis = random_axis(random);
    const double rho = std::exp2(real(random, -1.5, 1.5));
    const NurbsPatch mapped = moebius(patch, axis, rho);
    const Interval domain = patch.knot_vector(axis).domain();
    EXPECT_EQ(mapped.knot_vector(axis).domain(), domain);
    for (int i = 0; i < 4; ++i) {
      const double t = real(random, 0.0, 1.0);
      const double s = rho * t / (1.0 - t + rho * t);
      const double old_at = domain.start + s * domain.length();
      const double at = domain.start + t * domain.length();
      const double other = inside(random, patch.knot_vector(axis == Axis::u ? Axis::v : Axis::u).domain());
      const auto point = [&](const NurbsPatch& on, double u) {
        return axis == Axis::u ? homogeneous_at(on, u, other) : homogeneous_at(on, other, u);
      };
      const glm::dvec4 expected = point(patch, old_at);
      const glm::dvec4 found = point(mapped, at);
      const bool is_clear = largest(expected) > 0.05 * size_of(patch);
      EXPECT_TRUE(!is_clear || misfit(expected, found) <= 1e-12) << round;
    }
  }
}

TEST(PatchTransformed, IsTheSurfaceMapped) {
  Random random(307);
  for (int round = 0; round < kRounds; ++round) {
    const NurbsPatch patch = any_patch(random);
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 4; ++k) matrix[i][k] += real(random, -0.5, 0.5);
    }
    const bool is_affine = round % 2 == 0;
    if (is_affine) matrix[0][3] = matrix[1][3] = matrix[2][3] = 0.0, matrix[3][3] = 1.0;
    const NurbsPatch image = transformed(patch, matrix);
    EXPECT_TRUE(!is_affine || image.rational() == patch.rational());
    const double u = inside(random, patch.knot_vector(Axis::u).domain());
    const double v = inside(random, patch.knot_vector(Axis::v).domain());
    const glm::dvec4 expected = matrix * homogeneous_at(patch, u, v);
    EXPECT_LE(largest(expected - homogeneous_at(image, u, v)), 1e-13 * size_of(patch)) << round;
  }
}

/// Expects that a verb along u is, bit for bit, the verb along v of the swapped patch.
template <class Verb>
void expect_symmetry(const NurbsPatch& patch, Verb verb) {
  EXPECT_EQ(verb(patch, Axis::u), swapped(verb(swapped(patch), Axis::v)));
  EXPECT_EQ(verb(patch, Axis::v), swapped(verb(swapped(patch), Axis::u)));
}

TEST(PatchVerbs, AlongOneAxisAreThoseAlongTheOtherOfTheSwappedPatch) {
  Random random(308);
  for (int round = 0; round < 150; ++round) {
    const NurbsPatch patch = any_patch(random, 2);
    expect_symmetry(patch, [](const auto& p, Axis axis) { return elevated(p, axis, 2); });
    expect_symmetry(patch, [](const auto& p, Axis axis) { return reduced(p, axis).value; });
    expect_symmetry(patch, [](const auto& p, Axis axis) { return clamped(p, axis); });
    expect_symmetry(patch, [](const auto& p, Axis axis) { return unclamped(p, axis); });
    expect_symmetry(patch, [](const auto& p, Axis axis) { return with_domain(p, axis, {-1.0, 7.0}); });
    expect_symmetry(patch, [](const auto& p, Axis axis) { return moebius(p, axis, 0.75); });
    expect_symmetry(patch, [](const auto& p, Axis axis) {
      const double at = p.knot_vector(axis).domain().middle();
      return remove_knot(insert_knot(p, axis, at, 2), axis, at).value;
    });
  }
}

TEST(PatchVerbs, KeepEveryDigitOfPointsThatStay) {
  Random random(309);
  for (int round = 0; round < 200; ++round) {
    const Kind kind{3, 4, Ends::clamped, Weights::any};
    const NurbsPatch patch = random_patch(random, kind, kind);
    const NurbsPatch open = unclamped(patch, Axis::u);
    const int count_v = patch.count(Axis::v);
    for (int i = 2; i < patch.count(Axis::u) - 2; ++i) {
      for (int j = 0; j < count_v; ++j) EXPECT_EQ(open.points()[i * count_v + j], patch.points()[i * count_v + j]);
    }
    const NurbsPatch raised = elevated(patch, Axis::v);
    const int raised_v = raised.count(Axis::v);
    for (int i = 0; i < patch.count(Axis::u); ++i) {
      EXPECT_EQ(raised.points()[i * raised_v], patch.points()[i * count_v]);
      EXPECT_EQ(raised.points()[(i + 1) * raised_v - 1], patch.points()[(i + 1) * count_v - 1]);
    }
  }
}

TEST(PatchVerbs, ActOnLinesThatLieAtInfinityAltogether) {
  std::vector<glm::dvec4> points{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 0}, {0, 2, 0, 0}, {0, 3, 0, 1}, {1, 3, 0, 1}};
  const NurbsPatch patch = NurbsPatch::make(KnotVector::bezier(2), KnotVector::bezier(1), points);
  Random random(310);
  EXPECT_LE(farthest(random, patch, elevated(patch, Axis::v)), 1e-15);
  EXPECT_LE(farthest(random, patch, reduced(elevated(patch, Axis::v), Axis::v).value), 1e-15);
  EXPECT_LE(farthest(random, patch, unclamped(patch, Axis::v)), 1e-15);
  EXPECT_EQ(with_domain(patch, Axis::v, {0.0, 1.0}), patch);
}

TEST(BezierPatchDegree, IsRaisedAndLoweredInEachDirection) {
  Random random(311);
  for (int round = 0; round < 200; ++round) {
    const int rows = integer(random, 2, 8);
    const int columns = integer(random, 2, 8);
    const BezierPatch patch = BezierPatch::make(rows, columns, random_points(random, rows * columns, Weights::any));
    for (const Axis axis : {Axis::u, Axis::v}) {
      const BezierPatch raised = elevated(patch, axis, 2);
      EXPECT_EQ(raised.degree(axis), patch.degree(axis) + 2);
      EXPECT_LE(farthest(random, patch.nurbs(), raised.nurbs()), 1e-15);
      EXPECT_LE(farthest(random, patch.nurbs(), reduced(raised, axis, 2).value.nurbs()), 1e-12);
    }
  }
}

TEST(PatchVerbs, RefuseWhatCannotBe) {
  std::vector<glm::dvec4> arch{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 1, 1}, {1, 1, 1, 1}, {0, 2, 0, 1}, {1, 2, 0, 1}};
  const NurbsPatch patch = NurbsPatch::make(KnotVector::bezier(2), KnotVector::bezier(1), arch);
  EXPECT_EQ(refusal([&] { elevated(patch, Axis::u, -1); }), "times = -1 is outside [0, 253]");
  EXPECT_EQ(refusal([&] { elevated(patch, Axis::v, 255); }), "times = 255 is outside [0, 254]");
  EXPECT_EQ(refusal([&] { reduced(patch, Axis::v); }), "times = 1 is outside [1, 0]: a patch needs degree 1 or more");
  EXPECT_EQ(refusal([&] { reduced(patch, Axis::u, 1, -1.0); }), "tolerance = -1 is not 0 or more");
  EXPECT_EQ(refusal([&] { remove_knot(patch, Axis::u, 0.0); }), "u = 0 is not a knot that can be removed");
  EXPECT_EQ(refusal([&] { remove_knots(patch, Axis::u, std::nan("")); }), "tolerance = nan is not 0 or more");
  EXPECT_EQ(refusal([&] { with_domain(patch, Axis::u, {1.0, 1.0}); }), "the domain from 1 to 1 is empty");
  EXPECT_NE(refusal([&] { moebius(patch, Axis::u, 0.0); }).find("rho = 0 is not positive"), std::string::npos);
  EXPECT_THROW(made_periodic(patch, Axis::u), ToleranceNotReached);
  EXPECT_THROW(reduced(patch, Axis::u, 1, 0.1), ToleranceNotReached);
  EXPECT_EQ(refusal([&] { largest_distance(patch, with_domain(patch, Axis::u, {0.0, 2.0})); }), "the domains differ");
}

}  // namespace
}  // namespace splinecore
