#pragma once

#include "workloads.hpp"

struct SISLCurve;
struct SISLSurf;

// SISL, SINTEF's spline library, as Debian packages it.
namespace benchmarks {

class RivalCurve {
 public:
  explicit RivalCurve(const splinecore::NurbsCurve& curve);
  ~RivalCurve();
  RivalCurve(const RivalCurve&) = delete;
  RivalCurve& operator=(const RivalCurve&) = delete;

  void evaluate_batch(Numbers& parameters, Numbers& out);
  void evaluate_each(const Numbers& parameters, Numbers& out);

 private:
  SISLCurve* curve_;
};

class RivalSurface {
 public:
  explicit RivalSurface(const splinecore::NurbsPatch& patch);
  ~RivalSurface();
  RivalSurface(const RivalSurface&) = delete;
  RivalSurface& operator=(const RivalSurface&) = delete;

  void evaluate_grid(Numbers& u, Numbers& v, Numbers& out);
  void evaluate_grid_with_normals(Numbers& u, Numbers& v, Numbers& derivatives, Numbers& normals);

 private:
  SISLSurf* surface_;
};

}  // namespace benchmarks
