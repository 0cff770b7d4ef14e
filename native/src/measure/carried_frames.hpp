#pragma once

#include <memory>
#include <span>

#include "splinecore/measure/moving_frame.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Frames that are carried along a curve once, as far as they are asked for.
class CarriedFrames {
 public:
  /// @throws as rotation_minimizing_frames()
  CarriedFrames(const NurbsCurve& curve, const CarriedFrame& how);
  ~CarriedFrames();

  /// rotation_minimizing_frames()
  void write(std::span<const double> parameters, std::span<MovingFrame> out, Side side);

 private:
  class Carried;
  std::unique_ptr<Carried> carried_;
};

}  // namespace splinecore
#pragma GCC visibility pop
