// Holes among patches, by GeomPlate and GeomFill.
#include <Adaptor3d_CurveOnSurface.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomFill_BoundWithSurf.hxx>
#include <GeomFill_ConstrainedFilling.hxx>
#include <GeomPlate_BuildPlateSurface.hxx>
#include <GeomPlate_CurveConstraint.hxx>
#include <GeomPlate_MakeApprox.hxx>
#include <GeomPlate_Surface.hxx>
#include <Geom_BezierSurface.hxx>

#include "occt.hpp"
#include "occt_shapes.hpp"

namespace benchmarks {

namespace {

using Sides = std::vector<Handle(Adaptor3d_CurveOnSurface)>;

/// Of each neighbor of a hole the side at which v begins.
Sides sides_of(const Run& run, const std::string& workload) {
  const Numbers rows = run.input(workload + ".neighbors");
  Sides sides;
  for (const double* net = rows.data(); net != rows.data() + rows.size(); net += 36) {
    TColgp_Array2OfPnt points(1, 3, 1, 3);
    TColStd_Array2OfReal weights(1, 3, 1, 3);
    for (int k = 0; k < 9; ++k) {
      points(k / 3 + 1, k % 3 + 1) = point_at(net + 4 * k);
      weights(k / 3 + 1, k % 3 + 1) = net[4 * k + 3];
    }
    const Handle(Geom_BezierSurface) patch = new Geom_BezierSurface(points, weights);
    const Handle(Geom2d_Line) side = new Geom2d_Line(gp_Pnt2d(0.0, 0.0), gp_Dir2d(1.0, 0.0));
    sides.push_back(new Adaptor3d_CurveOnSurface(new Geom2dAdaptor_Curve(side, 0.0, 1.0), new GeomAdaptor_Surface(patch)));
  }
  return sides;
}

/// As BRepFill_Filling calls them, less the topology.
Surface plate(const Sides& sides, double tolerance, double angle) {
  constexpr int kPlaces = 15;
  constexpr int kMostSpans = 9;
  GeomPlate_BuildPlateSurface plate(3, kPlaces, 2, 1e-5, tolerance, angle);
  for (const auto& side : sides) plate.Add(new GeomPlate_CurveConstraint(side, 1, kPlaces, tolerance, angle));
  plate.Perform();
  return GeomPlate_MakeApprox(plate.Surface(), tolerance, kMostSpans, kHighestDegree, plate.G0Error()).Surface();
}

Surface constrained(const Sides& sides, double tolerance, double angle) {
  GeomFill_ConstrainedFilling filling(kHighestDegree, kMostSegments);
  const auto bound = [&](std::size_t k) -> Handle(GeomFill_Boundary) {
    return new GeomFill_BoundWithSurf(*sides[k], tolerance, angle);
  };
  filling.Init(bound(0), bound(1), bound(2), bound(3));
  return made(filling.Surface());
}

void fill(const Run& run, const std::string& workload) {
  const Sides sides = sides_of(run, workload.substr(4));
  const double tolerance = tolerance_of(run, workload);
  const double angle = run.input("angle")[0];
  surface(run, "GeomPlate", [&] { return plate(sides, tolerance, angle); });
  if (sides.size() == 4) surface(run, "GeomFill_ConstrainedFilling", [&] { return constrained(sides, tolerance, angle); });
}

}  // namespace

void fill_four(const Run& run) { fill(run, "W12 fill 4"); }
void fill_five(const Run& run) { fill(run, "W12 fill 5"); }

}  // namespace benchmarks
