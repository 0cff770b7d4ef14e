#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAPI_IntSS.hxx>
#include <Geom_BSplineCurve.hxx>

#include "occt.hpp"
#include "occt_shapes.hpp"

namespace benchmarks {

namespace {

Handle(Geom2d_BSplineCurve) zigzag(const Run& run, const std::string& name) {
  const Numbers rows = run.input(name);
  TColgp_Array1OfPnt2d points(1, static_cast<int>(rows.size() / 3));
  for (int i = 1; i <= points.Length(); ++i) {
    const double* p = &rows[3 * static_cast<std::size_t>(i - 1)];
    points(i) = gp_Pnt2d(p[0], p[1]);
  }
  const CubicKnots knots(run.input("zigzag.knots"));
  return new Geom2d_BSplineCurve(points, knots.values, knots.times, 3);
}

}  // namespace

Surface waves(const Run& run, const std::string& name) {
  const CubicKnots knots(run.input("waves.knots"));
  const Numbers rows = run.input(name);
  const auto count = static_cast<int>(run.input("waves.knots").size()) - 4;
  TColgp_Array2OfPnt points(1, count, 1, count);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const double* p = &rows[3 * static_cast<std::size_t>(i * count + j)];
      points(i + 1, j + 1) = gp_Pnt(p[0], p[1], p[2]);
    }
  }
  return new Geom_BSplineSurface(points, knots.values, knots.values, knots.times, knots.times, 3, 3);
}

void cross_zigzags(const Run& run) {
  const auto a = zigzag(run, "zigzag_a");
  const auto b = zigzag(run, "zigzag_b");
  int found = 0;
  const auto work = [&] { found = Geom2dAPI_InterCurveCurve(a, b, 1e-9).NbPoints(); };
  work();
  run.time("InterCurveCurve", 1, work, std::to_string(found) + " crossings");
}

void cross_waves(const Run& run) {
  const auto a = waves(run, "waves_a");
  const auto b = waves(run, "waves_b");
  int curves = 0;
  int made = 0;
  const auto work = [&] {
    const GeomAPI_IntSS found(a, b, 1e-5);
    curves = found.NbLines();
    made = 0;
    for (int i = 1; i <= curves; ++i) {
      if (const auto line = Handle(Geom_BSplineCurve)::DownCast(found.Line(i))) made += line->NbPoles();
    }
  };
  work();
  run.time("IntSS", 1, work, std::to_string(curves) + " curves, " + std::to_string(made) + " control points, tolerance 1e-5");
}

}  // namespace benchmarks
