#include "curve/rescale.hpp"

#include "splinecore/curve/transform.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

TEST(Rescaling, IsUndoneToTheDigit) {
  Random random(73);
  for (const double size : {1e-300, 1e-150, 1.0, 1e150, 1e290}) {
    glm::dmat4 matrix(size);
    matrix[3][3] = 1.0;
    const NurbsCurve curve = transformed(random_curve(random, {3, 4, Ends::unclamped, Weights::any}), matrix);
    const Scales scales = scales_of(curve);
    const NurbsCurve near_one = divided(curve, scales);
    EXPECT_LT(size_of(near_one), 0x1p110);
    EXPECT_GT(size_of(near_one), 0x1p-110);
    EXPECT_EQ(divided(near_one, {-scales.coordinates, -scales.weights, -scales.parameters}), curve);
  }
}

}  // namespace
}  // namespace splinecore
