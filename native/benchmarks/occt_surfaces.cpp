// Surfaces from curves, and offsets, by GeomFill and GeomConvert.
#include <BSplCLib.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomConvert_ApproxSurface.hxx>
#include <GeomFill_AppSurf.hxx>
#include <GeomFill_BSplineCurves.hxx>
#include <GeomFill_CorrectedFrenet.hxx>
#include <GeomFill_CurveAndTrihedron.hxx>
#include <GeomFill_DiscreteTrihedron.hxx>
#include <GeomFill_Line.hxx>
#include <GeomFill_Pipe.hxx>
#include <GeomFill_SectionGenerator.hxx>
#include <GeomFill_Sweep.hxx>
#include <GeomFill_UniformSection.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Precision.hxx>

#include <algorithm>
#include <stdexcept>

#include "occt.hpp"
#include "occt_shapes.hpp"

namespace benchmarks {

namespace {

using Curve = Handle(Geom_BSplineCurve);

Curve cubic(const double* rows, const Numbers& flat) {
  const CubicKnots knots(flat);
  TColgp_Array1OfPnt points(1, static_cast<int>(flat.size()) - 4);
  for (int i = 1; i <= points.Length(); ++i) points(i) = point_at(rows + 3 * (i - 1));
  return new Geom_BSplineCurve(points, knots.values, knots.times, 3);
}

Curve cubic(const Run& run, const std::string& name) {
  return cubic(run.input(name + ".points").data(), run.input(name + ".knots"));
}

/// Degrees, counts, knots along u and along v, rows x, y, z, w: what deviations.py reads.
Numbers numbers_of(const Surface& surface) {
  Numbers numbers;
  for (const int n : {surface->UDegree(), surface->VDegree(), surface->NbUPoles(), surface->NbVPoles()}) numbers.push_back(n);
  for (const double u : surface->UKnotSequence()) numbers.push_back(u);
  for (const double v : surface->VKnotSequence()) numbers.push_back(v);
  for (int i = 1; i <= surface->NbUPoles(); ++i) {
    for (int j = 1; j <= surface->NbVPoles(); ++j) {
      const gp_Pnt p = surface->Pole(i, j);
      numbers.insert(numbers.end(), {p.X(), p.Y(), p.Z(), surface->Weight(i, j)});
    }
  }
  return numbers;
}

void keep_surface(const Run& run, const std::string& call, const Surface& surface) {
  const auto open = Surface::DownCast(surface->Copy());
  open->SetUNotPeriodic();
  open->SetVNotPeriodic();
  const Numbers numbers = numbers_of(open);
  run.keep(call, numbers.size(), 1, [&](std::size_t i) { return &numbers[i]; }, 1);
}

std::vector<Curve> loft_sections(const Run& run) {
  const Numbers rows = run.input("loft.sections");
  const Numbers knots = run.input("loft.knots");
  std::vector<Curve> sections;
  for (std::size_t at = 0; at < rows.size(); at += 3 * (knots.size() - 4)) sections.push_back(cubic(&rows[at], knots));
  return sections;
}

/// As BRepOffsetAPI_ThruSections calls it, less the topology.
Surface lofted(const std::vector<Curve>& curves, const Handle(TColStd_HArray1OfReal)& parameters, double tolerance) {
  GeomFill_SectionGenerator sections;
  for (const Curve& curve : curves) sections.AddCurve(curve);
  if (!parameters.IsNull()) sections.SetParam(parameters);
  sections.Perform(Precision::PConfusion());
  GeomFill_AppSurf loft(2, kHighestDegree, tolerance, tolerance, 0, !parameters.IsNull());
  loft.SetContinuity(GeomAbs_C2);
  loft.SetParType(Approx_ChordLength);
  loft.Perform(new GeomFill_Line(static_cast<int>(curves.size())), sections, true);
  return new Geom_BSplineSurface(loft.SurfPoles(), loft.SurfWeights(), loft.SurfUKnots(), loft.SurfVKnots(),
                                 loft.SurfUMults(), loft.SurfVMults(), loft.UDegree(), loft.VDegree());
}

/// No loft of OCCT, but what its own solver says of the one through sections at these parameters, with these knots.
Surface interpolated(const Run& run, const Handle(TColStd_HArray1OfReal)& parameters) {
  Numbers rows = run.input("loft.sections");
  const Numbers knots_u = run.input("loft.knots");
  const Numbers knots_v = run.input("loft.knots_v");
  TColStd_Array1OfReal flat(1, static_cast<int>(knots_v.size()));
  std::ranges::copy(knots_v, flat.begin());
  TColStd_Array1OfInteger orders(1, parameters->Length());
  orders.Init(0);
  const auto size = static_cast<int>(knots_u.size()) - 4;
  int problem = 0;
  BSplCLib::Interpolate(3, flat, parameters->Array1(), orders, 3 * size, rows.front(), problem);
  if (problem != 0) throw std::runtime_error("BSplCLib::Interpolate fails");
  TColgp_Array2OfPnt points(1, size, 1, parameters->Length());
  for (int i = 0; i < size; ++i) {
    for (int k = 0; k < parameters->Length(); ++k) points(i + 1, k + 1) = point_at(&rows[3 * static_cast<std::size_t>(k * size + i)]);
  }
  const CubicKnots u(knots_u);
  const CubicKnots v(knots_v);
  return new Geom_BSplineSurface(points, u.values, v.values, u.times, v.times, 3, 3);
}

struct Rail {
  Curve curve;
  gp_Vec start;  ///< where x of a section points there
};

/// By frames of a law, turned about the rail so that they begin as they should.
template <class Law>
Surface swept(const Rail& rail, const Curve& section, double tolerance, GeomAbs_Shape continuity) {
  const Handle(GeomFill_CurveAndTrihedron) location = new GeomFill_CurveAndTrihedron(new Law);
  location->SetCurve(new GeomAdaptor_Curve(rail.curve));
  gp_Mat frame;
  gp_Vec at;
  location->D0(0.0, frame, at);
  const gp_Vec tangent = rail.curve->DN(0.0, 1).Normalized();
  const gp_Mat wanted(rail.start.XYZ(), tangent.Crossed(rail.start).XYZ(), tangent.XYZ());
  location->SetTrsf(frame.Inverted() * wanted);
  GeomFill_Sweep sweep(location, false);
  sweep.SetTolerance(tolerance, tolerance);
  sweep.Build(new GeomFill_UniformSection(section), GeomFill_Location, continuity, kHighestDegree, kMostSegments);
  return made(sweep.Surface());
}

}  // namespace

double tolerance_of(const Run& run, const std::string& workload) { return run.input(workload + ".tolerance")[0]; }

Surface made(const Handle(Geom_Surface)& surface) {
  const auto spline = Surface::DownCast(surface);
  if (spline.IsNull()) throw std::runtime_error("no spline surface was made");
  return spline;
}

void surface(const Run& run, const std::string& call, const std::function<Surface()>& work) {
  const Surface found = work();
  run.time(call, 1, [&] { work(); },
           std::to_string(found->NbUPoles() * found->NbVPoles()) + " control points, degrees " +
               std::to_string(found->UDegree()) + " and " + std::to_string(found->VDegree()) +
               (found->IsCNu(2) && found->IsCNv(2) ? ", C2" : found->IsCNu(1) && found->IsCNv(1) ? ", C1" : ", C0"));
  keep_surface(run, call, found);
}

void loft(const Run& run) {
  const Numbers given = run.input("loft.parameters");
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, static_cast<int>(given.size()));
  std::ranges::copy(given, parameters->ChangeArray1().begin());
  const double tolerance = tolerance_of(run, "W12 loft");
  const std::vector<Curve> sections = loft_sections(run);
  surface(run, "GeomFill_AppSurf", [&] { return lofted(sections, {}, tolerance); });
  surface(run, "GeomFill_AppSurf at parameters", [&] { return lofted(sections, parameters, tolerance); });
  keep_surface(run, "BSplCLib Interpolate", interpolated(run, parameters));
}

void sweep(const Run& run) {
  const Numbers x = run.input("rail.start");
  const Rail rail{cubic(run, "rail"), gp_Vec(x[0], x[1], x[2])};
  const Curve section = cubic(run, "gutter");
  const double tolerance = tolerance_of(run, "W12 sweep");
  surface(run, "GeomFill_Sweep, CorrectedFrenet",
          [&] { return swept<GeomFill_CorrectedFrenet>(rail, section, tolerance, GeomAbs_C2); });
  surface(run, "GeomFill_Sweep, CorrectedFrenet, C1",
          [&] { return swept<GeomFill_CorrectedFrenet>(rail, section, tolerance, GeomAbs_C1); });
  surface(run, "GeomFill_Sweep, DiscreteTrihedron",
          [&] { return swept<GeomFill_DiscreteTrihedron>(rail, section, tolerance, GeomAbs_C0); });
}

void pipe(const Run& run) {
  const Curve rail = cubic(run, "rail");
  const double radius = run.input("pipe_radius")[0];
  const double tolerance = tolerance_of(run, "W12 pipe");
  const auto piped = [&](GeomAbs_Shape continuity) {
    GeomFill_Pipe pipe(rail, radius);
    pipe.Perform(tolerance, false, continuity, kHighestDegree, kMostSegments);
    return made(pipe.Surface());
  };
  surface(run, "GeomFill_Pipe", [&] { return piped(GeomAbs_C2); });
  surface(run, "GeomFill_Pipe, C1", [&] { return piped(GeomAbs_C1); });
}

void coons(const Run& run) {
  std::vector<Curve> sides;
  for (int k = 0; k < 4; ++k) sides.push_back(cubic(run, "coons" + std::to_string(k)));
  for (const auto& [call, style] : {std::pair("GeomFill_BSplineCurves, Coons", GeomFill_CoonsStyle),
                                    std::pair("GeomFill_BSplineCurves, Stretch", GeomFill_StretchStyle)}) {
    surface(run, call, [&] { return GeomFill_BSplineCurves(sides[0], sides[1], sides[2], sides[3], style).Surface(); });
  }
}

void offset(const Run& run) {
  const Handle(Geom_OffsetSurface) wanted = new Geom_OffsetSurface(waves(run, "waves_a"), run.input("offset")[0]);
  const double tolerance = tolerance_of(run, "W12 offset");
  const auto approximate = [&](GeomAbs_Shape continuity) {
    return GeomConvert_ApproxSurface(wanted, tolerance, continuity, continuity, kHighestDegree, kHighestDegree, kMostSegments, 0).Surface();
  };
  surface(run, "GeomConvert_ApproxSurface", [&] { return approximate(GeomAbs_C1); });
  surface(run, "GeomConvert_ApproxSurface, C2", [&] { return approximate(GeomAbs_C2); });
}

}  // namespace benchmarks
