#include "splinecore/tessellate/tessellation.hpp"

#include <map>
#include <numbers>
#include <tuple>

#include "mesh.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

PatchSet bilinear(std::vector<glm::dvec4> pool, const std::vector<std::vector<int>>& quads) {
  std::vector<IndexedPatch> patches;
  for (const auto& quad : quads) {
    patches.push_back(
        {.kind = PatchKind::bezier, .count_u = 2, .count_v = 2, .indices = quad, .knots_u = {}, .knots_v = {}});
  }
  return PatchSet::make(std::move(pool), std::move(patches));
}

/// Six sides; corner i has the coordinates of its three bits. Normals point outwards.
PatchSet cube() {
  std::vector<glm::dvec4> pool;
  for (int i = 0; i < 8; ++i) pool.emplace_back(i & 1, i >> 1 & 1, i >> 2, 1);
  return bilinear(pool, {{0, 1, 2, 3}, {4, 6, 5, 7}, {0, 4, 1, 5}, {2, 3, 6, 7}, {0, 2, 4, 6}, {1, 5, 3, 7}});
}

/// Eight octants of the unit sphere, or the four of the northern half.
PatchSet sphere(int octants) {
  const double h = std::numbers::sqrt2 / 2;
  std::vector<AnyPatch> patches;
  for (int octant = 0; octant < octants; ++octant) {
    const double x[] = {1, 0, -1, 0, 1}, y[] = {0, 1, 0, -1, 0};
    const int q = octant % 4;
    std::vector<glm::dvec4> net;
    const double up = octant < 4 ? 1 : -1;
    for (const auto& [r, z, w] : {std::tuple{1.0, 0.0, 1.0}, {1.0, up, h}, {0.0, up, 1.0}}) {
      net.insert(net.end(), {{r * x[q], r * y[q], z, w},
                             {r * (x[q] + x[q + 1]), r * (y[q] + y[q + 1]), z, w * h},
                             {r * x[q + 1], r * y[q + 1], z, w}});
    }
    const BezierPatch patch = BezierPatch::make(3, 3, net);
    patches.push_back(octant < 4 ? swapped(patch) : patch);
  }
  return PatchSet::of(patches, true);
}

TEST(Tessellation, OfOneSpanHasTheAskedGrid) {
  const PatchSet square = bilinear({{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}}, {{0, 1, 2, 3}});
  const Mesh mesh(square, 3, 5);
  EXPECT_EQ(mesh.topology.vertex_count(), 4u * 6);
  EXPECT_EQ(mesh.faces(), 15u);
  EXPECT_EQ(mesh.euler(), 1);
  expect_faces_along_normals(mesh);
  const auto uvs = mesh.topology.corner_uvs();
  for (std::size_t k = 0; k < mesh.topology.corner_vertices().size(); ++k) {
    const glm::dvec3 p = mesh.position(mesh.topology.corner_vertices()[k]);
    EXPECT_FLOAT_EQ(uvs[2 * k], static_cast<float>(p.x));
    EXPECT_FLOAT_EQ(uvs[2 * k + 1], static_cast<float>(p.y));
  }
}

TEST(Tessellation, OfACubeIsClosedAndSharpAtItsTwelveEdges) {
  for (const int resolution : {1, 2, 5}) {
    const Mesh mesh(cube(), resolution, resolution);
    EXPECT_TRUE(mesh.is_closed());
    EXPECT_EQ(mesh.euler(), 2);
    EXPECT_EQ(mesh.topology.sharp_edges(mesh.normals, 1.0).size(), 2u * 12 * resolution);
    EXPECT_TRUE(mesh.topology.sharp_edges(mesh.normals, 1.6).empty());
    expect_faces_along_normals(mesh);
    for (std::size_t i = 0; i < mesh.faces(); ++i) {
      const glm::dvec3 outwards = mesh.position(mesh.face(i)[0]) - glm::dvec3(0.5);
      EXPECT_GT(glm::dot(face_normal(mesh, i), outwards), 0.0);
    }
  }
}

TEST(Tessellation, OfASphereOfOctantsIsClosedRoundAndSmooth) {
  const Mesh mesh(sphere(8), 6, 6);
  EXPECT_TRUE(mesh.is_closed());
  EXPECT_EQ(mesh.euler(), 2);
  EXPECT_EQ(mesh.topology.vertex_count(), 2u + 24 * 11);
  EXPECT_TRUE(mesh.topology.sharp_edges(mesh.normals, 0.01).empty());
  expect_faces_along_normals(mesh);
  const auto corners = mesh.topology.corner_vertices();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    EXPECT_LE(largest(mesh.normal(k) - mesh.position(corners[k])), 1e-6);
  }
}

TEST(Tessellation, PutsTrianglesAroundAPole) {
  const Mesh mesh(sphere(4), 3, 3);
  std::map<std::size_t, int> sizes;
  for (std::size_t i = 0; i < mesh.faces(); ++i) ++sizes[mesh.face(i).size()];
  EXPECT_EQ(sizes, (std::map<std::size_t, int>{{3, 12}, {4, 24}}));
  EXPECT_EQ(mesh.euler(), 1);
}

TEST(Tessellation, MarksACreaseThatRunsIntoAPole) {
  // A pyramid of four bilinear sides, whose far edges have shrunk to the tip.
  const PatchSet pyramid = bilinear({{1, 0, 0, 1}, {0, 1, 0, 1}, {-1, 0, 0, 1}, {0, -1, 0, 1}, {0, 0, 1, 1}},
                                    {{0, 4, 1, 4}, {1, 4, 2, 4}, {2, 4, 3, 4}, {3, 4, 0, 4}});
  const Mesh mesh(pyramid, 3, 4);
  EXPECT_EQ(mesh.topology.vertex_count(), 1u + 4 * 12);
  const auto sharp = mesh.topology.sharp_edges(mesh.normals, 0.5);
  EXPECT_EQ(sharp.size(), 2u * 4 * 4);
}

TEST(Tessellation, OfATorusClosesBothPeriods) {
  Random random(160);
  const KnotVector ring = KnotVector::periodic_uniform(3, 5);
  const PatchSet torus = PatchSet::of(
      std::vector<AnyPatch>{NurbsPatch::make(ring, ring, random_points(random, 25, Weights::positive))}, true);
  const Mesh mesh(torus, 2, 3);
  EXPECT_EQ(mesh.topology.vertex_count(), 150u);
  EXPECT_EQ(mesh.faces(), 150u);
  EXPECT_TRUE(mesh.is_closed());
  EXPECT_EQ(mesh.euler(), 0);
}

TEST(Tessellation, MarksTheCreaseOfAPeriodAtItsSeamAndInside) {
  // A square tube of degree 1 around its period: four creases of `resolution_v` edges.
  std::vector<glm::dvec4> points;
  for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}})
    points.insert(points.end(), {{x, y, 0, 1}, {x, y, 1, 1}});
  const PatchSet tube = PatchSet::of(
      std::vector<AnyPatch>{NurbsPatch::make(KnotVector::periodic_uniform(1, 4), KnotVector::bezier(1), points)}, true);
  const Mesh mesh(tube, 3, 2);
  EXPECT_EQ(mesh.topology.vertex_count(), 36u);
  EXPECT_EQ(mesh.euler(), 0);
  EXPECT_EQ(mesh.topology.sharp_edges(mesh.normals, 1.0).size(), 2u * 4 * 2);
}

TEST(Tessellation, LeavesAGapOpen) {
  Random random(161);
  const KnotVector knots = KnotVector::make(1, {0, 0, 1, 1, 2, 2});
  const PatchSet set = PatchSet::of(
      std::vector<AnyPatch>{NurbsPatch::make(knots, KnotVector::bezier(1), random_points(random, 8, Weights::one))},
      true);
  const Mesh mesh(set, 2, 2);
  EXPECT_EQ(mesh.topology.vertex_count(), 18u);
  EXPECT_EQ(mesh.faces(), 8u);
  EXPECT_EQ(mesh.euler(), 2);
}

/// How many edges have one face.
std::size_t border_edge_count(const Mesh& mesh) {
  const auto corners = mesh.topology.corner_vertices();
  std::map<std::pair<int, int>, int> faces;
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    const std::size_t start = mesh.topology.face_starts()[i];
    const std::size_t end = i + 1 < mesh.faces() ? mesh.topology.face_starts()[i + 1] : corners.size();
    for (std::size_t k = start; k < end; ++k) {
      const int next = corners[k + 1 < end ? k + 1 : start];
      ++faces[std::minmax(static_cast<int>(corners[k]), next)];
    }
  }
  return std::ranges::count_if(faces, [](const auto& edge) { return edge.second == 1; });
}

TEST(Tessellation, HasNoCrackWhereAnEdgeHasTwoResolutions) {
  // The edge 2-3 is a v side of the first patch and a u side of the second, which has its places then.
  const PatchSet set = bilinear({{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {2, 0, 0, 1}, {2, 1, 0, 1}},
                                {{0, 1, 2, 3}, {3, 5, 2, 4}});
  EXPECT_EQ(Mesh(set, 3, 3).topology.vertex_count(), 28u);
  EXPECT_EQ(border_edge_count(Mesh(set, 3, 3)), 18u);
  for (const auto& [u, v] : {std::pair{2, 5}, {5, 2}, {3, 8}}) {
    const Mesh mesh(set, u, v);
    EXPECT_EQ(mesh.topology.vertex_count(), 2u * (u + 1) * (v + 1) - 1 - std::min(u, v));
    EXPECT_EQ(border_edge_count(mesh), 3u * (u + v));
  }
}

TEST(Tessellation, GivesAPatchOfOneStripASecondBesideAnEdgeOfMore) {
  const PatchSet set = bilinear({{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {2, 0, 0, 1}, {2, 1, 0, 1}},
                                {{0, 1, 2, 3}, {3, 5, 2, 4}});
  const Mesh mesh(set, 1, 7);
  // 2 x 8 of the first, and 3 x 8 of the second without the edge.
  EXPECT_EQ(mesh.topology.vertex_count(), 16u + 21u);
  EXPECT_EQ(border_edge_count(mesh), 1u + 7 + 1 + 7 + 2 + 7);
}

TEST(Tessellation, PutsVerticesOnThePatchesAndCornersOnTheirVertices) {
  Random random(162);
  for (int round = 0; round < 50; ++round) {
    const NurbsPatch patch = random_patch(random, Weights::positive);
    const PatchSet set = PatchSet::of(std::vector<AnyPatch>{patch}, true);
    const Mesh mesh(set, 2, 3);
    const Interval range_u = patch.knot_vector(Axis::u).domain(), range_v = patch.knot_vector(Axis::v).domain();
    const auto uvs = mesh.topology.corner_uvs();
    const auto corners = mesh.topology.corner_vertices();
    for (std::size_t i = 0; i < mesh.faces(); ++i) {
      // The middle of a face lies inside one span, so no side needs to be told.
      const std::size_t start = mesh.topology.face_starts()[i];
      if (mesh.face(i).size() != 4) continue;
      const double eps = 1e-4;
      for (std::size_t k = start; k < start + 4; ++k) {
        const auto inward = [&](int axis) {
          return 0.25 * (uvs[2 * start + axis] + uvs[2 * start + 2 + axis] + uvs[2 * start + 4 + axis] +
                         uvs[2 * start + 6 + axis]);
        };
        const double u = (1 - eps) * uvs[2 * k] + eps * inward(0), v = (1 - eps) * uvs[2 * k + 1] + eps * inward(1);
        const glm::dvec3 near =
            point_at(patch, range_u.start + u * range_u.length(), range_v.start + v * range_v.length());
        EXPECT_LE(largest(near - mesh.position(corners[k])), 0.1) << round;
      }
    }
  }
}

TEST(Tessellation, FitsSetsWithTheSamePatchesOnly) {
  const PatchSet set = cube();
  const Tessellation mesh = Tessellation::make(set, 2, 2);
  std::vector<glm::dvec4> moved(set.points().begin(), set.points().end());
  for (glm::dvec4& p : moved) p.x += 1;
  EXPECT_TRUE(mesh.fits(set.with_points(moved)));
  EXPECT_FALSE(mesh.fits(flipped(set)));
  EXPECT_FALSE(mesh.fits(sphere(8)));
}

TEST(Tessellation, RefusesAbsurdResolutions) {
  EXPECT_EQ(refusal([] { Tessellation::make(cube(), 0, 1); }), "resolution_u = 0 is outside [1, 4096]");
  EXPECT_EQ(refusal([] { Tessellation::make(cube(), 1, 5000); }), "resolution_v = 5000 is outside [1, 4096]");
  const KnotVector knots = KnotVector::clamped(1, 20);
  const PatchSet large = PatchSet::of(
      std::vector<AnyPatch>{NurbsPatch::make(knots, knots, std::vector<glm::dvec4>(400, glm::dvec4(1)))}, false);
  EXPECT_EQ(refusal([&] { Tessellation::make(large, 4096, 4096); }),
            "the mesh would have more than 2^22 vertices: lower the resolution");
}

}  // namespace
}  // namespace splinecore
