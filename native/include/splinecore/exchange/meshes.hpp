#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "splinecore/exchange/json.hpp"
#include "splinecore/tessellate/polyline.hpp"

namespace splinecore {

/// Coordinates of points or vectors: x, y, z after x, y, z.
using Coordinates = std::variant<std::span<const float>, std::span<const double>>;

/// A mesh of polygons in arrays of the caller, as a Tessellation has and evaluates them.
struct MeshArrays {
  Coordinates positions;
  Coordinates corner_normals;                  ///< empty for none
  std::span<const std::int32_t> face_starts;   ///< with or without their end, the number of corners
  std::span<const std::int32_t> corner_vertices;
};

/// An OBJ file: polygons, with a normal for each corner, and lines, with 9 significant digits.
/// @throws InvalidShape if face starts, vertices or normals do not fit the mesh, a line has less than two points, or a
///         coordinate is not finite. The message says of which mesh or line.
std::string to_obj(std::span<const MeshArrays> meshes, std::span<const Polyline> lines = {});

/// A binary PLY file, little endian, in single precision: vertices, polygons, and edges of lines.
/// @throws InvalidShape as to_obj(), or if there are more than 2^31 - 1 vertices.
std::string to_ply(std::span<const MeshArrays> meshes, std::span<const Polyline> lines = {});

/// A binary STL file in single precision: polygons as fans of triangles about their first corners.
/// @throws InvalidShape as to_obj(), or if there are more than 2^32 - 1 triangles.
std::string to_stl(std::span<const MeshArrays> meshes);

/// A binary glTF 2.0 file (GLB): fans of triangles, with a vertex for each corner where there are normals, and lines.
/// Normals are given their length of 1; where the surface has none it is that of the polygon.
/// @throws InvalidShape as to_obj(), or if the file would have 2^32 bytes or more.
std::string to_glb(std::span<const MeshArrays> meshes, std::span<const Polyline> lines = {});

/// How finely shapes are shown in a file.
struct MeshFineness {
  std::optional<int> resolution;    ///< faces in each span along u and v, pieces in each of a curve; none: 8 and 32
  std::optional<double> tolerance;  ///< a length: no point of a surface lies farther from the mesh
  std::optional<double> angle;      ///< radians: normals on one face are no farther apart
};

/// Writes the meshes of surfaces, and the polylines of curves, to a file whose name ends with .obj, .ply, .stl or .glb, in
/// capitals or not. It is written whole or not at all.
/// @throws InvalidShape if the name ends otherwise, a curve is to be written to STL, a resolution is given beside a tolerance
///         or an angle, or as Tessellation, polylines() and to_obj(); std::filesystem::filesystem_error if the file cannot be
///         written.
void save_meshes(const std::filesystem::path& path, const Document& shapes, const MeshFineness& fineness = {});

}  // namespace splinecore
