#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <sstream>

#include "mesh.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/build/primitives.hpp"
#include "splinecore/exchange/meshes.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

constexpr double kRadius = 2.0;
const double kVolume = 4.0 / 3.0 * std::numbers::pi * kRadius * kRadius * kRadius;

NurbsPatch ball() { return sphere({1.0, 2.0, 3.0}, kRadius); }
NurbsPatch square() { return plane({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}); }
BezierCurve arch() { return BezierCurve::make({{0.0, 0.0, 0.0, 1.0}, {1.0, 2.0, 0.0, 1.0}, {2.0, 0.0, 0.0, 1.0}}); }

/// A folder that is gone with the test.
struct Folder {
  std::filesystem::path path;

  Folder() : path(std::filesystem::temp_directory_path() / ("splinecore-meshes-" + std::to_string(std::random_device()()))) {
    std::filesystem::create_directory(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string text_of(const std::string& name) const {
    std::ifstream file(path / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path), {}));
  }
};

template <class Number>
Number number_at(const std::string& data, std::size_t at) {
  Number number;
  EXPECT_LE(at + sizeof(number), data.size());
  std::memcpy(&number, data.data() + at, sizeof(number));
  return number;
}

glm::dvec3 point_at(const std::string& data, std::size_t at) {
  return {number_at<float>(data, at), number_at<float>(data, at + 4), number_at<float>(data, at + 8)};
}

using Triangle = std::array<glm::dvec3, 3>;

double volume_of(const std::vector<Triangle>& triangles) {
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles) sum += glm::dot(a - glm::dvec3(1, 2, 3), glm::cross(b - glm::dvec3(1, 2, 3), c - glm::dvec3(1, 2, 3)));
  return sum / 6.0;
}

std::vector<Triangle> stl_triangles(const std::string& data) {
  const auto count = number_at<std::uint32_t>(data, 80);
  EXPECT_EQ(data.size(), 84 + 50 * std::size_t{count});
  std::vector<Triangle> found;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = 84 + 50 * i;
    found.push_back({point_at(data, at + 12), point_at(data, at + 24), point_at(data, at + 36)});
    const auto& [a, b, c] = found.back();
    const glm::dvec3 across = glm::cross(b - a, c - a);
    EXPECT_LT(glm::length(point_at(data, at) - across / glm::length(across)), 1e-6);
    EXPECT_EQ(number_at<std::uint16_t>(data, at + 48), 0);
  }
  return found;
}

struct Obj {
  std::vector<glm::dvec3> points, normals;
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> faces;
  std::vector<std::vector<std::size_t>> lines;

  explicit Obj(const std::string& text) {
    std::istringstream rows(text);
    for (std::string row; std::getline(rows, row);) {
      std::istringstream words(row);
      std::string word;
      words >> word;
      if (word == "v" || word == "vn") {
        glm::dvec3 point;
        EXPECT_TRUE(words >> point.x >> point.y >> point.z) << row;
        (word == "v" ? points : normals).push_back(point);
      } else if (word == "f") {
        faces.emplace_back();
        for (std::string corner; words >> corner;) {
          const std::size_t bar = corner.find("//");
          faces.back().emplace_back(std::stoul(corner), bar == std::string::npos ? 0 : std::stoul(corner.substr(bar + 2)));
        }
      } else {
        EXPECT_EQ(word, "l");
        lines.emplace_back();
        for (std::size_t place; words >> place;) lines.back().push_back(place);
      }
    }
  }
};

struct Glb {
  nlohmann::json top;
  std::string data;

  explicit Glb(const std::string& file) {
    EXPECT_EQ(file.substr(0, 4), "glTF");
    EXPECT_EQ(number_at<std::uint32_t>(file, 4), 2u);
    EXPECT_EQ(number_at<std::uint32_t>(file, 8), file.size());
    std::vector<std::pair<std::string, std::string>> chunks;
    for (std::size_t at = 12; at < file.size();) {
      const std::size_t size = number_at<std::uint32_t>(file, at);
      EXPECT_EQ(size % 4, 0u);
      chunks.emplace_back(file.substr(at + 4, 4), file.substr(at + 8, size));
      at += 8 + size;
    }
    EXPECT_EQ(chunks.at(0).first, "JSON");
    top = nlohmann::json::parse(chunks[0].second);
    if (chunks.size() < 2) return;
    EXPECT_EQ(chunks[1].first, std::string("BIN\0", 4));
    data = chunks[1].second;
    EXPECT_EQ(top["buffers"][0]["byteLength"], data.size());
    std::size_t end = 0;
    for (const auto& view : top["bufferViews"]) {
      EXPECT_EQ(view["byteOffset"], end) << "views follow each other";
      EXPECT_EQ(end % 4, 0u);
      end += view["byteLength"].get<std::size_t>();
    }
    EXPECT_EQ(end, data.size());
  }

  std::vector<glm::dvec3> points(int accessor) const {
    const auto& own = top["accessors"][static_cast<std::size_t>(accessor)];
    EXPECT_EQ(own["componentType"], 5126);
    EXPECT_EQ(own["type"], "VEC3");
    std::vector<glm::dvec3> found;
    glm::dvec3 lowest(HUGE_VAL), highest(-HUGE_VAL);
    for (std::size_t i = 0; i < own["count"]; ++i) {
      found.push_back(point_at(data, start(own) + 12 * i));
      lowest = glm::min(lowest, found.back());
      highest = glm::max(highest, found.back());
    }
    for (int k = 0; own.contains("min") && k < 3; ++k) {
      EXPECT_EQ(own["min"][static_cast<std::size_t>(k)].get<double>(), lowest[k]);
      EXPECT_EQ(own["max"][static_cast<std::size_t>(k)].get<double>(), highest[k]);
    }
    return found;
  }

  std::vector<std::size_t> indices(int accessor) const {
    const auto& own = top["accessors"][static_cast<std::size_t>(accessor)];
    EXPECT_EQ(own["componentType"], 5125);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < own["count"]; ++i) found.push_back(number_at<std::uint32_t>(data, start(own) + 4 * i));
    return found;
  }

 private:
  std::size_t start(const nlohmann::json& accessor) const {
    return top["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteOffset"];
  }
};

TEST(MeshFiles, BallsHaveTheirVolume) {
  const Folder folder;
  for (const auto& [fineness, allowed] : {std::pair{MeshFineness{40, {}, {}}, 0.01}, {MeshFineness{{}, 1e-3, {}}, 0.01},
                                          {MeshFineness{{}, {}, 0.05}, 0.01}, {MeshFineness{}, 0.03}}) {
    save_meshes(folder.path / "ball.STL", ball(), fineness);
    const auto triangles = stl_triangles(folder.text_of("ball.STL"));
    EXPECT_NEAR(volume_of(triangles) / kVolume, 1.0, allowed);
    save_meshes(folder.path / "ball.glb", ball(), fineness);
    const Glb glb(folder.text_of("ball.glb"));
    const auto& primitive = glb.top["meshes"][0]["primitives"][0];
    const auto points = glb.points(primitive["attributes"]["POSITION"]);
    const auto normals = glb.points(primitive["attributes"]["NORMAL"]);
    const auto indices = glb.indices(primitive["indices"]);
    ASSERT_EQ(points.size(), normals.size());
    ASSERT_EQ(indices.size(), 3 * triangles.size());
    std::vector<Triangle> same;
    for (std::size_t i = 0; i < indices.size(); i += 3) same.push_back({points.at(indices[i]), points.at(indices[i + 1]), points.at(indices[i + 2])});
    EXPECT_EQ(same, triangles);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(glm::length(normals[i]), 1.0, 2e-6);
      EXPECT_GT(glm::dot(normals[i], points[i] - glm::dvec3(1, 2, 3)), 1.9);
    }
  }
}

TEST(MeshFiles, ObjHasThePolygonsOfTheTessellation) {
  const NurbsPatch patch = ball();
  const AnyPatch any(patch);
  const Mesh mesh(PatchSet::of(std::span(&any, 1), true), 5, 3);
  const MeshArrays arrays{mesh.positions, mesh.normals, mesh.topology.face_starts(), mesh.topology.corner_vertices()};
  const Obj obj(to_obj(std::array{arrays, arrays}));
  ASSERT_EQ(obj.faces.size(), 2 * mesh.faces());
  ASSERT_EQ(obj.points.size(), 2 * mesh.topology.vertex_count());
  ASSERT_EQ(obj.normals.size(), 2 * mesh.normals.size() / 3);
  std::size_t corner = 0;
  for (std::size_t i = 0; i < obj.faces.size(); ++i) {
    const auto face = mesh.face(i % mesh.faces());
    ASSERT_EQ(obj.faces[i].size(), face.size());
    for (std::size_t k = 0; k < face.size(); ++k, ++corner) {
      const auto [vertex, normal] = obj.faces[i][k];
      EXPECT_EQ(vertex, static_cast<std::size_t>(face[k]) + 1 + (i < mesh.faces() ? 0 : mesh.topology.vertex_count()));
      EXPECT_EQ(normal, corner + 1);
      EXPECT_EQ(glm::vec3(obj.points[vertex - 1]), glm::vec3(mesh.position(face[k]))) << "nine digits tell floats apart";
    }
  }
}

TEST(MeshFiles, PlyHasVerticesFacesAndEdges) {
  const std::vector<double> corners{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const std::vector<std::int32_t> starts{0}, vertices{0, 1, 2, 3};
  const Polyline ring{{0, 0, 1, 1, 0, 1, 1, 1, 1}, true};
  const std::string file = to_ply(std::array{MeshArrays{corners, {}, starts, vertices}}, std::array{ring});
  const std::string header = file.substr(0, file.find("end_header\n") + 11);
  for (const char* line : {"ply\nformat binary_little_endian 1.0\n", "element vertex 7\n", "element face 1\n", "list uchar int", "element edge 3\n"}) {
    EXPECT_NE(header.find(line), std::string::npos) << line;
  }
  std::size_t at = header.size();
  EXPECT_EQ(point_at(file, at + 3 * 12), glm::dvec3(0, 1, 0));
  at += 7 * 12;
  EXPECT_EQ(file[at], 4);
  at += 1 + 4 * 4;
  EXPECT_EQ(file.size(), at + 3 * 8);
  EXPECT_EQ(number_at<std::int32_t>(file, at + 2 * 8), 6);
  EXPECT_EQ(number_at<std::int32_t>(file, at + 2 * 8 + 4), 4);
}

TEST(MeshFiles, PolygonsOfManyCornersAreCountedInFourBytes) {
  std::vector<double> corners;
  std::vector<std::int32_t> vertices;
  for (int i = 0; i < 300; ++i) {
    const double angle = 2 * std::numbers::pi * i / 300;
    corners.insert(corners.end(), {std::cos(angle), std::sin(angle), 0.0});
    vertices.push_back(i);
  }
  const std::vector<std::int32_t> starts{0, 300};
  const std::string file = to_ply(std::array{MeshArrays{corners, {}, starts, vertices}});
  EXPECT_NE(file.find("list uint int"), std::string::npos);
  EXPECT_EQ(number_at<std::uint32_t>(file, file.size() - 4 * 301), 300u);
  EXPECT_EQ(stl_triangles(to_stl(std::array{MeshArrays{corners, {}, starts, vertices}})).size(), 298u);
}

TEST(MeshFiles, EveryKindOfShapeIsWritten) {
  const Folder folder;
  const BezierPatch patch = BezierPatch::make(2, 2, {{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}, {1, 1, 1, 1}});
  const AnyPatch parts[] = {square(), patch};
  const std::vector<Value> shapes{arch(), arch().nurbs(), square(), patch, PatchSet::of(parts, true)};
  save_meshes(folder.path / "all.obj", shapes, {4, {}, {}});
  const Obj obj(folder.text_of("all.obj"));
  EXPECT_EQ(obj.faces.size(), 4 * 16u);
  ASSERT_EQ(obj.lines.size(), 2u);
  EXPECT_EQ(obj.lines[0].size(), 5u);
  EXPECT_EQ(obj.points[obj.lines[0][2] - 1], glm::dvec3(1, 1, 0));
  for (const char* ending : {"ply", "glb"}) save_meshes(folder.path / (std::string("all.") + ending), shapes);
  EXPECT_EQ(Glb(folder.text_of("all.glb")).top["meshes"][0]["primitives"].size(), 5u);
  EXPECT_EQ(folder.files(), 3u) << "nothing is left beside them";
}

TEST(MeshFiles, NormalsThatSurfacesLackAreThoseOfFaces) {
  const std::vector<float> corners{0, 0, 0, 3, 0, 0, 0, 3, 0}, normals{0, 0, 0, 0, 0, 5, 1, 0, 0};
  const std::vector<std::int32_t> starts{0}, vertices{0, 1, 2};
  const Glb glb(to_glb(std::array{MeshArrays{corners, normals, starts, vertices}}));
  EXPECT_EQ(glb.points(1), (std::vector<glm::dvec3>{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}}));
}

TEST(MeshFiles, NothingIsAFileOfNothing) {
  const Folder folder;
  for (const char* ending : {"obj", "ply", "stl", "glb"}) save_meshes(folder.path / (std::string("none.") + ending), std::vector<Value>{});
  EXPECT_EQ(folder.text_of("none.obj"), "");
  EXPECT_EQ(folder.text_of("none.stl").size(), 84u);
  EXPECT_EQ(Glb(folder.text_of("none.glb")).top.size(), 1u);
}

TEST(MeshFiles, WhatDoesNotFitIsRefused) {
  const std::vector<float> corners{0, 0, 0, 3, 0, 0, 0, 3, 0}, bad{0, 0, 0, 3, NAN, 0, 0, 3, 0};
  const std::vector<double> huge{0, 0, 0, 1e39, 0, 0, 0, 3, 0};
  const std::vector<std::int32_t> starts{0}, vertices{0, 1, 2}, outside{0, 1, 3}, below{0, -1, 2};
  const auto refused = [](const MeshArrays& mesh, const char* part) {
    const std::array meshes{mesh};
    for (const auto& write : {std::function([&] { return to_obj(meshes); }), std::function([&] { return to_ply(meshes); }),
                              std::function([&] { return to_stl(meshes); }), std::function([&] { return to_glb(meshes); })}) {
      EXPECT_NE(refusal(write).find(part), std::string::npos) << refusal(write);
    }
  };
  for (const auto& wrong : {std::vector<std::int32_t>{}, {1}, {0, 2}, {0, 3, 3}, {0, 4}, {3, 0}, {0, -1}}) {
    refused({corners, {}, wrong, vertices}, "meshes[0]: face starts");
  }
  refused({corners, {}, starts, outside}, "vertex 3 of corner 2 is not one of 3");
  refused({corners, {}, starts, below}, "vertex -1 of corner 1");
  refused({corners, std::span(corners).first(6), starts, vertices}, "2 normals for 3 corners");
  refused({bad, {}, starts, vertices}, "positions[1] must be finite");
  refused({corners, bad, starts, vertices}, "normals[1] must be finite");
  EXPECT_THROW(to_stl(std::array{MeshArrays{huge, {}, starts, vertices}}), InvalidShape);
  EXPECT_NE(to_obj(std::array{MeshArrays{huge, {}, starts, vertices}}).find("v 1e+39 0 0\n"), std::string::npos);
  EXPECT_THROW(to_obj({}, std::array{Polyline{{1, 2, 3}, false}}), InvalidShape);
}

TEST(MeshFiles, BadFilesAreRefusedAndNothingIsLeft) {
  const Folder folder;
  EXPECT_THROW(save_meshes(folder.path / "a.step", ball()), InvalidShape);
  EXPECT_THROW(save_meshes(folder.path / "a", ball()), InvalidShape);
  EXPECT_THROW(save_meshes(folder.path / "a.stl", arch()), InvalidShape);
  EXPECT_THROW(save_meshes(folder.path / "a.obj", ball(), {3, 0.1, {}}), InvalidShape);
  EXPECT_THROW(save_meshes(folder.path / "a.obj", ball(), {0, {}, {}}), InvalidShape);
  try {
    save_meshes(folder.path / "missing" / "a.obj", ball());
    FAIL() << "no folder";
  } catch (const std::filesystem::filesystem_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
    EXPECT_EQ(error.path1(), folder.path / "missing" / "a.obj");
  }
  std::filesystem::create_directory(folder.path / "taken.obj");
  std::ofstream(folder.path / "taken.obj" / "full") << "x";
  EXPECT_THROW(save_meshes(folder.path / "taken.obj", ball()), std::filesystem::filesystem_error);
  EXPECT_EQ(folder.files(), 1u);
}

}  // namespace
}  // namespace splinecore
