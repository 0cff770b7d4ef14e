// Open CASCADE Technology, as Debian packages it.
#include "occt.hpp"

#include <GCPnts_AbscissaPoint.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomConvert_BSplineCurveToBezierCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <NCollection_Sequence.hxx>

#include <algorithm>
#include <cmath>

namespace {

using benchmarks::Numbers;
using benchmarks::Run;
using Curve = Handle(Geom_BSplineCurve);

static_assert(sizeof(gp_Pnt) == 3 * sizeof(double) && sizeof(gp_Vec) == sizeof(gp_Pnt));

const double* numbers_of(const gp_Pnt& point) { return point.XYZ().GetData(); }

/// Distinct knots and how often each occurs.
struct Knots {
  explicit Knots(const Numbers& flat) {
    for (const double u : flat) {
      if (distinct.IsEmpty() || distinct.Last() != u) {
        distinct.Append(u);
        times.Append(1);
      } else {
        ++times.ChangeLast();
      }
    }
  }

  [[nodiscard]] TColStd_Array1OfReal values() const { return array<TColStd_Array1OfReal>(distinct); }
  [[nodiscard]] TColStd_Array1OfInteger multiplicities() const { return array<TColStd_Array1OfInteger>(times); }

 private:
  template <class Array, class Sequence>
  static Array array(const Sequence& sequence) {
    Array result(1, sequence.Length());
    for (int i = 1; i <= sequence.Length(); ++i) result(i) = sequence(i);
    return result;
  }

  NCollection_Sequence<double> distinct;
  NCollection_Sequence<int> times;
};

Curve cubic(const Run& run, const std::string& name, bool rational) {
  const Numbers rows = run.input(name + ".points");
  const Knots knots(run.input(name + ".knots"));
  const auto count = static_cast<int>(rows.size() / 4);
  TColgp_Array1OfPnt points(1, count);
  TColStd_Array1OfReal weights(1, count);
  for (int i = 0; i < count; ++i) {
    points(i + 1) = gp_Pnt(rows[4 * i], rows[4 * i + 1], rows[4 * i + 2]);
    weights(i + 1) = rows[4 * i + 3];
  }
  if (rational) return new Geom_BSplineCurve(points, weights, knots.values(), knots.multiplicities(), 3);
  return new Geom_BSplineCurve(points, knots.values(), knots.multiplicities(), 3);
}

Handle(Geom_BSplineSurface) bicubic(const Run& run) {
  const Numbers rows = run.input("surface.points");
  const Knots u(run.input("surface.knots_u"));
  const Knots v(run.input("surface.knots_v"));
  constexpr int kCount = 32;
  TColgp_Array2OfPnt points(1, kCount, 1, kCount);
  TColStd_Array2OfReal weights(1, kCount, 1, kCount);
  for (int i = 0; i < kCount; ++i) {
    for (int j = 0; j < kCount; ++j) {
      const double* row = &rows[4 * (i * kCount + j)];
      points(i + 1, j + 1) = gp_Pnt(row[0], row[1], row[2]);
      weights(i + 1, j + 1) = row[3];
    }
  }
  return new Geom_BSplineSurface(points, weights, u.values(), v.values(), u.multiplicities(), v.multiplicities(), 3, 3);
}

Handle(Geom_BezierCurve) bezier(const Run& run, int degree) {
  const Numbers rows = run.input("bezier" + std::to_string(degree) + ".points");
  TColgp_Array1OfPnt points(1, degree + 1);
  for (int i = 0; i <= degree; ++i) points(i + 1) = gp_Pnt(rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]);
  return new Geom_BezierCurve(points);
}

template <class Shape>
void points_of(const Run& run, const std::string& call, const Shape& curve, const Numbers& parameters) {
  std::vector<gp_Pnt> out(parameters.size());
  run.time(call, parameters.size(), [&] {
    for (std::size_t i = 0; i < parameters.size(); ++i) curve.D0(parameters[i], out[i]);
  });
  run.keep(call, parameters.size(), 3, [&](std::size_t i) { return numbers_of(out[i]); });
}

/// With and without OCCT's cache of the span.
template <class Shape>
void both_ways(const Run& run, const Shape& curve, const Numbers& parameters) {
  points_of(run, "D0", *curve, parameters);
  points_of(run, "D0, cache", GeomAdaptor_Curve(curve), parameters);
}

template <class Shape>
void second_derivatives(const Run& run, const std::string& call, const Shape& curve, const Numbers& parameters) {
  std::vector<gp_Vec> out(3 * parameters.size());
  run.time(call, parameters.size(), [&] {
    gp_Pnt point;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      curve.D2(parameters[i], point, out[3 * i + 1], out[3 * i + 2]);
      out[3 * i] = gp_Vec(point.XYZ());
    }
  });
  run.keep(call, parameters.size(), 9, [&](std::size_t i) { return out[3 * i].XYZ().GetData(); });
}

void curve_derivatives(const Run& run) {
  const Curve curve = cubic(run, "curve", true);
  const Numbers parameters = run.input("sorted");
  second_derivatives(run, "D2", *curve, parameters);
  second_derivatives(run, "D2, cache", GeomAdaptor_Curve(curve), parameters);
}

void grid_points(const Run& run) {
  const GeomAdaptor_Surface surface(bicubic(run));
  const Numbers line = run.input("grid");
  const std::size_t n = line.size();
  std::vector<gp_Pnt> out(n * n);
  run.time("D0, cache", n * n, [&] {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) surface.D0(line[i], line[j], out[i * n + j]);
    }
  });
  run.keep("D0, cache", n * n, 3, [&](std::size_t i) { return numbers_of(out[i]); });
}

/// Points and unit normals of a grid, in pairs.
void grid_normals(const GeomAdaptor_Surface& surface, const Numbers& line, gp_Vec* out) {
  for (const double u : line) {
    for (const double v : line) {
      gp_Pnt point;
      gp_Vec along_u;
      gp_Vec along_v;
      surface.D1(u, v, point, along_u, along_v);
      const gp_Vec normal = along_u.Crossed(along_v);
      const double size = normal.Magnitude();
      *out++ = gp_Vec(point.XYZ());
      *out++ = size > 0 ? normal / size : normal;
    }
  }
}

void keep_normals(const Run& run, const std::vector<gp_Vec>& out) {
  run.keep("D1, cache", out.size() / 2, 6, [&](std::size_t i) { return out[2 * i].XYZ().GetData(); });
}

void one_grid_with_normals(const Run& run) {
  const GeomAdaptor_Surface surface(bicubic(run));
  const Numbers line = run.input("grid");
  std::vector<gp_Vec> out(2 * line.size() * line.size());
  run.time("D1, cache", out.size() / 2, [&] { grid_normals(surface, line, out.data()); });
  keep_normals(run, out);
}

void many_patches(const Run& run) {
  const Numbers nets = run.input("teapot");
  const Numbers line = run.input("patch_grid");
  std::vector<GeomAdaptor_Surface> patches;
  for (const double* net = nets.data(); net != nets.data() + nets.size(); net += 48) {
    TColgp_Array2OfPnt points(1, 4, 1, 4);
    for (int k = 0; k < 16; ++k) points(k / 4 + 1, k % 4 + 1) = gp_Pnt(net[3 * k], net[3 * k + 1], net[3 * k + 2]);
    patches.emplace_back(new Geom_BezierSurface(points));
  }
  const std::size_t each = 2 * line.size() * line.size();
  std::vector<gp_Vec> out(each * patches.size());
  run.time("D1, cache", out.size() / 2, [&] {
    for (std::size_t k = 0; k < patches.size(); ++k) grid_normals(patches[k], line, &out[each * k]);
  });
  keep_normals(run, out);
}

template <class Surface>
void first_derivatives(const Run& run, const std::string& call, const Surface& surface, const Numbers& pairs) {
  const std::size_t count = pairs.size() / 2;
  std::vector<gp_Vec> out(3 * count);
  run.time(call, count, [&] {
    gp_Pnt point;
    for (std::size_t i = 0; i < count; ++i) {
      surface.D1(pairs[2 * i], pairs[2 * i + 1], point, out[3 * i + 1], out[3 * i + 2]);
      out[3 * i] = gp_Vec(point.XYZ());
    }
  });
  run.keep(call, count, 9, [&](std::size_t i) { return out[3 * i].XYZ().GetData(); });
}

void scattered_pairs(const Run& run) {
  const Handle(Geom_BSplineSurface) surface = bicubic(run);
  const Numbers pairs = run.input("pairs");
  first_derivatives(run, "D1", *surface, pairs);
  first_derivatives(run, "D1, cache", GeomAdaptor_Surface(surface), pairs);
}

void keep_poles(const Run& run, const std::string& call, const Curve& curve) {
  run.keep(call, static_cast<std::size_t>(curve->NbPoles()), 3,
           [&](std::size_t i) { return numbers_of(curve->Poles()(static_cast<int>(i) + 1)); }, 7);
}

/// A verb that changes a curve: the copy it needs is in the clock.
void verb(const Run& run, const std::string& call, const std::function<void(Geom_BSplineCurve&)>& apply) {
  const Curve curve = cubic(run, "long", false);
  Curve made;
  run.time(call, 1000, [&] {
    made = Curve::DownCast(curve->Copy());
    apply(*made);
  });
  keep_poles(run, call, made);
}

void refine(const Run& run) {
  const Numbers inserted = run.input("inserted");
  TColStd_Array1OfReal knots(1, static_cast<int>(inserted.size()));
  TColStd_Array1OfInteger times(1, static_cast<int>(inserted.size()));
  times.Init(1);
  for (std::size_t i = 0; i < inserted.size(); ++i) knots(static_cast<int>(i) + 1) = inserted[i];
  verb(run, "InsertKnots", [&](Geom_BSplineCurve& curve) { curve.InsertKnots(knots, times, 0.0, true); });
}

void to_beziers(const Run& run) {
  const Curve curve = cubic(run, "long", false);
  std::vector<Handle(Geom_BezierCurve)> arcs;
  const std::string call = "GeomConvert_BSplineCurveToBezierCurve";
  run.time(call, 997, [&] {
    arcs.clear();
    GeomConvert_BSplineCurveToBezierCurve pieces(curve);
    for (int i = 1; i <= pieces.NbArcs(); ++i) arcs.push_back(pieces.Arc(i));
  });
  gp_Pnt pole;
  run.keep(call, 4 * arcs.size(), 3, [&](std::size_t i) {
    pole = arcs[i / 4]->Pole(static_cast<int>(i % 4) + 1);
    return numbers_of(pole);
  }, 7);
}

constexpr std::size_t kNearestStep = 37;

/// The least distance from each point, by a projector that has been given the shape.
template <class Projector, class Ends>
void nearest(const Run& run, const std::string& call, const std::string& points, Projector& projector, Ends ends) {
  const Numbers rows = run.input(points);
  std::vector<double> out(rows.size() / 3);
  run.time(call, out.size(), [&] {
    for (std::size_t i = 0; i < out.size(); ++i) {
      const gp_Pnt at(rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]);
      projector.Perform(at);
      out[i] = projector.NbPoints() > 0 ? std::min(projector.LowerDistance(), ends(at)) : ends(at);
    }
  });
  run.keep(call, out.size(), 1, [&](std::size_t i) { return &out[i]; }, kNearestStep);
}

/// Ends are no projections: they are looked at besides.
void nearest_on_curve(const Run& run) {
  const Curve curve = cubic(run, "curve", true);
  GeomAPI_ProjectPointOnCurve projector;
  projector.Init(curve, 0.0, 1.0);
  nearest(run, "GeomAPI_ProjectPointOnCurve", "near_curve", projector, [&](const gp_Pnt& at) {
    return std::min(at.Distance(curve->StartPoint()), at.Distance(curve->EndPoint()));
  });
}

/// Of feet on the border it finds none.
void nearest_on_patch(const Run& run) {
  GeomAPI_ProjectPointOnSurf projector;
  projector.Init(bicubic(run), 0.0, 1.0, 0.0, 1.0);
  nearest(run, "GeomAPI_ProjectPointOnSurf", "near_surface", projector, [](const gp_Pnt&) { return HUGE_VAL; });
}

void lengths(const Run& run) {
  const GeomAdaptor_Curve curve(cubic(run, "curve", true));
  double result = 0;
  const auto measured = [&](const std::string& call, const std::function<double()>& length) {
    run.time(call, 1, [&] { result = length(); });
    run.keep(call, 1, 1, [&](std::size_t) { return &result; });
  };
  measured("Length", [&] { return GCPnts_AbscissaPoint::Length(curve); });
  measured("Length to 1e-9", [&] { return GCPnts_AbscissaPoint::Length(curve, 1e-9); });
}

const benchmarks::Workloads kWorkloads = {
    {"W1 sorted", [](const Run& run) { both_ways(run, cubic(run, "curve", true), run.input("sorted")); }},
    {"W1 random", [](const Run& run) { both_ways(run, cubic(run, "curve", true), run.input("random")); }},
    {"W2", curve_derivatives},
    {"W3 points", grid_points},
    {"W3 normals", one_grid_with_normals},
    {"W4", scattered_pairs},
    {"W5 degree 11", [](const Run& run) { both_ways(run, bezier(run, 11), run.input("sorted")); }},
    {"W5 degree 25", [](const Run& run) { both_ways(run, bezier(run, 25), run.input("sorted")); }},
    {"W6 refine", refine},
    {"W6 elevate", [](const Run& run) {
       verb(run, "IncreaseDegree", [](Geom_BSplineCurve& curve) { curve.IncreaseDegree(5); });
     }},
    {"W6 Beziers", to_beziers},
    {"W8 curve", nearest_on_curve},
    {"W8 patch", nearest_on_patch},
    {"W9 curves", benchmarks::cross_zigzags},
    {"W9 surfaces", benchmarks::cross_waves},
    {"W10", many_patches},
    {"W11", lengths},
    {"W12 loft", benchmarks::loft},
    {"W12 sweep", benchmarks::sweep},
    {"W12 pipe", benchmarks::pipe},
    {"W12 coons", benchmarks::coons},
    {"W12 fill 4", benchmarks::fill_four},
    {"W12 fill 5", benchmarks::fill_five},
    {"W12 offset", benchmarks::offset},
    {"W13 first", benchmarks::first_hits},
    {"W13 all", benchmarks::all_hits},
    {"adaptive", benchmarks::mesh_teapot},
};

}  // namespace

int main(int argc, char** argv) { return benchmarks::drive(argc, argv, "OCCT", kWorkloads); }
