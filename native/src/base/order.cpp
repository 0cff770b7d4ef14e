#include "splinecore/base/order.hpp"

#include <string>

#include "splinecore/base/errors.hpp"

namespace splinecore {

void require_order(int order) {
  if (order >= 0 && order <= kMaxOrder) return;
  throw InvalidShape("order = " + std::to_string(order) + " is outside [0, " +
                     std::to_string(kMaxOrder) + "]");
}

}  // namespace splinecore
