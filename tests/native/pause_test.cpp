#include "splinecore/base/pause.hpp"

#include <stdexcept>
#include <thread>

#include "splinecore/basis/bernstein.hpp"
#include "splinecore/curve/degree.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/measure/length.hpp"
#include "splinecore/tessellate/tessellation.hpp"
#include "support.hpp"

namespace splinecore {

namespace {

using namespace testing;

struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped") {}
};

constexpr std::size_t kMany = std::size_t{1} << 26;

/// How often work pauses.
template <class Work>
int pauses_of(Work work) {
  int count = 0;
  const Pause pause = [&] { ++count; };
  const Pausing pausing(pause);
  work();
  return count;
}

NurbsCurve curve_of_degree(int degree, int count) {
  Random random(degree);
  std::vector<glm::dvec4> points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(real(random, -1, 1), real(random, -1, 1), 0.0, real(random, 1, 2));
  }
  return NurbsCurve::make(KnotVector::uniform(degree, count), std::move(points));
}

}  // namespace

TEST(Breathe, PausesNowAndThenAndOnlyWhereAsked) {
  breathe(kMany);
  EXPECT_EQ(pauses_of([] {}), 0);
  EXPECT_EQ(pauses_of([] { breathe(1000); }), 0);
  EXPECT_EQ(pauses_of([] { breathe(kMany); }), 1);
  const int of_small_steps = pauses_of([] {
    for (std::size_t i = 0; i < kMany; i += 1000) breathe(1000);
  });
  EXPECT_GE(of_small_steps, 3);
  EXPECT_LE(of_small_steps, 5);
}

TEST(Breathe, HeedsTheInnermostPauseOfItsThread) {
  int outer = 0;
  int inner = 0;
  const Pause out = [&] { ++outer; };
  const Pausing pausing(out);
  {
    const Pause in = [&] { ++inner; };
    const Pausing nested(in);
    breathe(kMany);
  }
  {
    const Pause none;
    const Pausing nested(none);
    breathe(kMany);
  }
  std::thread([] { breathe(kMany); }).join();
  EXPECT_EQ(outer, 0);
  breathe(kMany);
  EXPECT_EQ(outer, 1);
  EXPECT_EQ(inner, 1);
}

TEST(Breathe, DoesNotPauseWithinAPause) {
  int count = 0;
  const Pause long_pause = [&] {
    ++count;
    breathe(kMany);
  };
  const Pausing pausing(long_pause);
  breathe(kMany);
  breathe(kMany);
  EXPECT_EQ(count, 2);
}

TEST(Breathe, IsAsItWasAfterAPauseThatThrows) {
  const Pause stop = [] { throw Stopped(); };
  {
    const Pausing pausing(stop);
    EXPECT_THROW(breathe(kMany), Stopped);
  }
  breathe(kMany);
}

TEST(Breathe, EndsLongWorkOfTheHighestDegree) {
  const NurbsCurve curve = curve_of_degree(kMaxDegree, 300);
  const Pause stop = [] { throw Stopped(); };
  const Pausing pausing(stop);
  EXPECT_THROW(pieces(curve), Stopped);
  EXPECT_THROW(length(curve), Stopped);
  EXPECT_THROW(reduced(curve, 1), Stopped);
  EXPECT_THROW(largest_distance(curve, reversed(curve)), Stopped);
}

TEST(Breathe, EndsAMeshThatGrows) {
  Random random(5);
  std::vector<glm::dvec4> points;
  for (int i = 0; i < 16; ++i) points.emplace_back(real(random, -1, 1), real(random, -1, 1), real(random, -1, 1), 1.0);
  const BezierPatch patch = BezierPatch::make(4, 4, points);
  const PatchSet set = PatchSet::of(std::vector<AnyPatch>{patch}, true);
  const auto mesh = [&] { return Tessellation::adaptive(set, {1e-5, HUGE_VAL}); };
  EXPECT_GE(pauses_of(mesh), 10);
  const Pause stop = [] { throw Stopped(); };
  const Pausing pausing(stop);
  EXPECT_THROW(mesh(), Stopped);
}

TEST(Breathe, LeavesAKnotVectorWhoseMatricesWereBegunUsable) {
  const NurbsCurve curve = curve_of_degree(100, 400);
  const std::size_t spans = curve.knot_vector().spans().size();
  ASSERT_GE(spans, 100u);
  {
    const Pause stop = [] { throw Stopped(); };
    const Pausing pausing(stop);
    EXPECT_THROW(pieces(curve), Stopped);
  }
  EXPECT_EQ(pieces(curve), pieces(curve_of_degree(100, 400)));
}

}  // namespace splinecore
