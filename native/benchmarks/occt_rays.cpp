#include <BRepBuilderAPI_MakeFace.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Lin.hxx>

#include <limits>

#include "occt.hpp"
#include "occt_shapes.hpp"

namespace benchmarks {

namespace {

constexpr double kNear = 1e-9;
constexpr double kFar = std::numeric_limits<double>::max();

struct Lens {
  Surface surfaces[2];
  TopoDS_Face faces[2];
  TopoDS_Compound shape;

  explicit Lens(const Run& run) : surfaces{waves(run, "lens_front"), waves(run, "lens_back")} {
    const TopoDS_Builder builder;
    builder.MakeCompound(shape);
    for (int i = 0; i < 2; ++i) {
      faces[i] = BRepBuilderAPI_MakeFace(surfaces[i], kNear);
      builder.Add(shape, faces[i]);
    }
  }
};

/// How far the place of the surface is from that on the ray, for each hit.
void keep_hits(const Lens& lens, const gp_Lin& ray, const IntCurvesFace_ShapeIntersector& found, Numbers& apart) {
  for (int i = 1; i <= found.NbPnt(); ++i) {
    const Surface& surface = lens.surfaces[found.Face(i).IsSame(lens.faces[0]) ? 0 : 1];
    const gp_Pnt on_ray(ray.Location().XYZ() + found.WParameter(i) * ray.Direction().XYZ());
    apart.push_back(surface->Value(found.UParameter(i), found.VParameter(i)).Distance(on_ray));
  }
}

void hits(const Run& run, const std::string& call, bool is_first) {
  const Lens lens(run);
  const Numbers rows = run.input("rays");
  IntCurvesFace_ShapeIntersector intersector;
  intersector.Load(lens.shape, kNear);
  Numbers apart;
  const auto each = [&](const std::function<void(const gp_Lin&)>& take) {
    for (std::size_t i = 0; i < rows.size(); i += 6) {
      const gp_Lin ray(point_at(&rows[i]), gp_Dir(rows[i + 3], rows[i + 4], rows[i + 5]));
      if (is_first) intersector.PerformNearest(ray, 0.0, kFar);
      else intersector.Perform(ray, 0.0, kFar);
      take(ray);
    }
  };
  each([&](const gp_Lin& ray) { keep_hits(lens, ray, intersector, apart); });
  run.time(call, rows.size() / 6, [&] { each([](const gp_Lin&) {}); }, std::to_string(apart.size()) + " hits");
  run.keep(call, apart.size(), 1, [&](std::size_t i) { return &apart[i]; }, 1);
}

}  // namespace

void first_hits(const Run& run) { hits(run, "PerformNearest", true); }

void all_hits(const Run& run) { hits(run, "Perform", false); }

}  // namespace benchmarks
