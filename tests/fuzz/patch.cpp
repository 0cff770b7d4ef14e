#include "finding.hpp"
#include "patch_steps.hpp"
#include "shapes.hpp"
#include "targets.hpp"

namespace splinecore::fuzz {

namespace {

constexpr int kMostSteps = 8;

std::vector<PatchStep> all_steps() {
  std::vector<PatchStep> steps;
  for (const auto& some : {patch_verbs(), patch_measures()}) steps.insert(steps.end(), some.begin(), some.end());
  return steps;
}

}  // namespace

void patch(Input data) {
  static const std::vector<PatchStep> steps = all_steps();
  Bytes bytes(data);
  std::vector<std::uint8_t> walk(bytes.integer(1, kMostSteps));
  for (std::uint8_t& step : walk) step = bytes.byte();
  attempt([&] {
    NurbsPatch walker = nurbs_patch(bytes);
    for (const std::uint8_t step : walk) {
      if (walker.points().size() > kManyPoints) return;
      attempt([&] { steps[step % steps.size()](bytes, walker); });
    }
  });
}

}  // namespace splinecore::fuzz
