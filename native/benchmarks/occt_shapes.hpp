#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>

#include "driver.hpp"

namespace benchmarks {

using Surface = Handle(Geom_BSplineSurface);

inline constexpr int kHighestDegree = 8;
inline constexpr int kMostSegments = 300;

inline gp_Pnt point_at(const double* p) { return {p[0], p[1], p[2]}; }

/// @throws runtime_error if it is none
Surface made(const Handle(Geom_Surface)& surface);

double tolerance_of(const Run& run, const std::string& workload);

/// Times what makes a surface, says how many control points it has, and keeps it.
void surface(const Run& run, const std::string& call, const std::function<Surface()>& work);

/// Clamped knots of a cubic: the distinct ones, and how often each occurs.
struct CubicKnots {
  explicit CubicKnots(const Numbers& flat)
      : values(1, static_cast<int>(flat.size()) - 6), times(1, static_cast<int>(flat.size()) - 6) {
    for (int i = 1; i <= values.Length(); ++i) {
      values(i) = flat[static_cast<std::size_t>(i) + 2];
      times(i) = i == 1 || i == values.Length() ? 4 : 1;
    }
  }

  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger times;
};

/// A bicubic over the unit square.
Surface waves(const Run& run, const std::string& name);

}  // namespace benchmarks
