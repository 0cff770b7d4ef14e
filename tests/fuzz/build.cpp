#include "build_steps.hpp"
#include "finding.hpp"
#include "targets.hpp"

namespace splinecore::fuzz {

void build(Input data) {
  Bytes bytes(data);
  const std::size_t which = bytes.byte();
  const auto some = which % 2 == 0 ? shape_builders() : conic_builders();
  attempt([&] { some[which / 2 % some.size()](bytes); });
}

}  // namespace splinecore::fuzz
