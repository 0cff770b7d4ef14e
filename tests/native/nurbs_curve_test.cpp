#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "splinecore/curve/evaluate.hpp"

namespace splinecore {
namespace {

TEST(NurbsCurveEvaluate, SemicircleWithAPointAtInfinityStaysOnTheCircle) {
  const NurbsCurve curve = NurbsCurve::make(2, {0, 0, 0, 1, 1, 1}, {{1, 0, 0, 1}, {0, 1, 0, 0}, {-1, 0, 0, 1}});
  std::vector<double> parameters(101);
  for (int i = 0; i <= 100; ++i) parameters[i] = i / 100.0;
  std::vector<double> points(303);
  evaluate(curve, parameters, std::span(points));
  for (int i = 0; i <= 100; ++i) {
    EXPECT_NEAR(std::hypot(points[3 * i], points[3 * i + 1]), 1.0, 4e-16) << "u = " << parameters[i];
  }
}

}  // namespace
}  // namespace splinecore
