#pragma once

#include "splinecore/curve/ends.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// reversed(), over the same domain also where short spans are rounded for it.
inline NurbsCurve run_back(const NurbsCurve& curve) {
  const NurbsCurve back = reversed(curve);
  return back.domain() == curve.domain() ? back : with_domain(back, curve.domain());
}

}  // namespace splinecore
#pragma GCC visibility pop
