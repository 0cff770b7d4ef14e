// BRepMesh without the headers of triangulations: Debian 12 does not ship one that they include
// (NCollection_AliasedArray.hxx), so the mesh's size is read from the text that BRepTools writes.
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <Geom_BezierSurface.hxx>

#include <sstream>
#include <stdexcept>

#include "occt.hpp"

namespace benchmarks {

namespace {

constexpr double kDeflection = 1e-3;
constexpr double kAngle = 10.0;  // radians: no bound, the deflection alone decides
constexpr double kNear = 1e-6;

TopoDS_Shape sewn_patches(const Numbers& nets) {
  BRepBuilderAPI_Sewing sewing(kNear);
  for (const double* net = nets.data(); net != nets.data() + nets.size(); net += 48) {
    TColgp_Array2OfPnt points(1, 4, 1, 4);
    for (int k = 0; k < 16; ++k) points(k / 4 + 1, k % 4 + 1) = gp_Pnt(net[3 * k], net[3 * k + 1], net[3 * k + 2]);
    sewing.Add(BRepBuilderAPI_MakeFace(new Geom_BezierSurface(points), kNear).Shape());
  }
  sewing.Perform();
  return sewing.SewedShape();
}

/// "V vertices, T triangles", each face's own.
std::string size_of_mesh(const TopoDS_Shape& shape) {
  std::stringstream text;
  BRepTools::Write(shape, text);
  std::string line;
  while (std::getline(text, line) && line.rfind("Triangulations ", 0) != 0) {
  }
  int faces = std::stoi(line.substr(line.find(' ')));
  long vertices = 0;
  long triangles = 0;
  while (faces-- > 0) {
    int nodes = 0;
    int corners = 0;
    int has_uvs = 0;
    int has_normals = 0;
    std::string number;
    text >> nodes >> corners >> has_uvs >> has_normals >> number;
    for (int k = 0; k < 3 * nodes + 2 * nodes * has_uvs + 3 * corners + 3 * nodes * has_normals; ++k) text >> number;
    vertices += nodes;
    triangles += corners;
  }
  if (!text) throw std::runtime_error("the triangulations cannot be read");
  return std::to_string(vertices) + " vertices, " + std::to_string(triangles) + " triangles";
}

}  // namespace

void mesh_teapot(const Run& run) {
  const TopoDS_Shape shape = sewn_patches(run.input("teapot"));
  const auto mesh = [&] { BRepMesh_IncrementalMesh(shape, kDeflection, false, kAngle, false); };
  mesh();
  const std::string size = size_of_mesh(shape);
  run.time("BRepMesh", 1, [&] { BRepTools::Clean(shape); }, mesh, size);
}

}  // namespace benchmarks
