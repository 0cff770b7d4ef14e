#include <array>
#include <map>
#include <numeric>
#include <string>

#include "base/require.hpp"
#include "influence.hpp"
#include "least_change.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/build/drag.hpp"

namespace splinecore {

namespace {

constexpr int kNoCorner = -1;
constexpr int kSeveral = -2;

using PointKey = std::array<double, 3>;

/// -0 and 0 are one place.
PointKey place_of(const glm::dvec4& point) { return {point.x + 0.0, point.y + 0.0, point.z + 0.0}; }

std::vector<double> products(const std::vector<double>& u, const std::vector<double>& v) {
  std::vector<double> net;
  net.reserve(u.size() * v.size());
  for (const double a : u) {
    for (const double b : v) net.push_back(a * b);
  }
  return net;
}

std::vector<double> sum(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

/// What each of the numbers of a patch counts at (u, v) in its point and its derivatives along u and v, in the order of
/// its indices, and by which length its motion is measured.
struct PatchInfluence {
  std::vector<double> values;
  std::vector<double> slopes_u;
  std::vector<double> slopes_v;
  std::vector<double> measures;
};

/// A tangent of a patch is both incoming and outgoing.
struct HermiteAxis {
  HermiteAxis(std::span<const double> parameters, double u, const char* name) {
    const HermiteInfluence at = HermiteInfluence::at(parameters, u, name);
    points = at.points.value;
    tangents = sum(at.incoming.value, at.outgoing.value);
    point_slopes = at.points.slope;
    tangent_slopes = sum(at.incoming.slope, at.outgoing.slope);
    for (std::size_t i = 0; i < at.before.size(); ++i) measures.push_back(0.5 * (at.before[i] + at.after[i]));
  }

  std::vector<double> points;
  std::vector<double> tangents;
  std::vector<double> point_slopes;
  std::vector<double> tangent_slopes;
  std::vector<double> measures;
};

PatchInfluence influence_of(const HermitePatch& patch, double u, double v) {
  const HermiteAxis along_u(patch.parameters(Axis::u), u, "u");
  const HermiteAxis along_v(patch.parameters(Axis::v), v, "v");
  const std::vector<double> ones_u(along_u.points.size(), 1.0);
  const std::vector<double> ones_v(along_v.points.size(), 1.0);
  PatchInfluence found;
  const auto add = [](std::vector<double>& all, const std::vector<double>& net) {
    all.insert(all.end(), net.begin(), net.end());
  };
  add(found.values, products(along_u.points, along_v.points));
  add(found.values, products(along_u.tangents, along_v.points));
  add(found.values, products(along_u.points, along_v.tangents));
  add(found.values, products(along_u.tangents, along_v.tangents));
  add(found.slopes_u, products(along_u.point_slopes, along_v.points));
  add(found.slopes_u, products(along_u.tangent_slopes, along_v.points));
  add(found.slopes_u, products(along_u.point_slopes, along_v.tangents));
  add(found.slopes_u, products(along_u.tangent_slopes, along_v.tangents));
  add(found.slopes_v, products(along_u.points, along_v.point_slopes));
  add(found.slopes_v, products(along_u.tangents, along_v.point_slopes));
  add(found.slopes_v, products(along_u.points, along_v.tangent_slopes));
  add(found.slopes_v, products(along_u.tangents, along_v.tangent_slopes));
  add(found.measures, products(ones_u, ones_v));
  add(found.measures, products(along_u.measures, ones_v));
  add(found.measures, products(ones_u, along_v.measures));
  add(found.measures, products(along_u.measures, along_v.measures));
  return found;
}

PatchInfluence influence_of(const NurbsPatch& patch, double u, double v) {
  const Influence along_u = Influence::at(patch.knot_vector(Axis::u), u, "u");
  const Influence along_v = Influence::at(patch.knot_vector(Axis::v), v, "v");
  const std::vector<double> values = products(along_u.value, along_v.value);
  Influence by_u{values, products(along_u.slope, along_v.value), std::vector<double>(values.size(), 0.0)};
  Influence by_v{values, products(along_u.value, along_v.slope), std::vector<double>(values.size(), 0.0)};
  if (!make_rational(by_u, patch.points()) || !make_rational(by_v, patch.points())) throw PointAtInfinity(u, v);
  return {std::move(by_u.value), std::move(by_u.slope), std::move(by_v.slope), std::vector<double>(values.size(), 1.0)};
}

PatchInfluence influence_of(const AnyPatch& patch, double u, double v) {
  if (const auto* hermite = std::get_if<HermitePatch>(&patch)) return influence_of(*hermite, u, v);
  return influence_of(nurbs_of(patch), u, v);
}

/// Points with weights, and patches that name them.
struct PointPool {
  std::span<const glm::dvec4> points;
  std::span<const IndexedPatch> patches;
};

/// Points of the pool that lie where one of the patch does move as one with it.
void tie_points(std::span<const glm::dvec4> points, const IndexedPatch& patch, Movable& movable) {
  std::map<PointKey, int> known;
  for (const int row : patch.indices) {
    if (points[row].w != 0.0) known.emplace(place_of(points[row]), row);
  }
  for (std::size_t row = 0; row < points.size(); ++row) {
    const auto found = points[row].w != 0.0 ? known.find(place_of(points[row])) : known.end();
    if (found != known.end()) movable.tie(found->second, static_cast<int>(row));
  }
}

/// What the directions of the pool belong to: the leader of the point whose tangents or twist they are.
struct Owners {
  explicit Owners(std::size_t count) : corner(count, kNoCorner), net(count, 0) {}

  void add(int row, int owner, int of_net) {
    net[row] = corner[row] == kNoCorner ? of_net : net[row];
    corner[row] = corner[row] == kNoCorner || corner[row] == owner ? owner : kSeveral;
  }

  std::vector<int> corner;
  std::vector<int> net;
};

Owners owners_of(const PointPool& pool, const Movable& movable) {
  Owners owners(pool.points.size());
  for (const IndexedPatch& patch : pool.patches) {
    const bool is_hermite = patch.kind == PatchKind::hermite;
    const std::size_t size = patch.indices.size() / (is_hermite ? 4 : 1);
    for (std::size_t i = 0; i < patch.indices.size(); ++i) {
      const int row = patch.indices[i];
      if (pool.points[row].w != 0.0) continue;
      owners.add(row, is_hermite ? movable.leader(patch.indices[i % size]) : kSeveral, static_cast<int>(i / size));
    }
  }
  return owners;
}

/// Tangents and twists that are equal at one corner move as one. Those of several, and points at infinity, stay.
void tie_directions(const PointPool& pool, Movable& movable) {
  const Owners owners = owners_of(pool, movable);
  std::map<std::pair<std::array<int, 2>, PointKey>, int> known;
  for (std::size_t row = 0; row < pool.points.size(); ++row) {
    if (pool.points[row].w != 0.0) continue;
    movable.is_fixed[row] = owners.corner[row] < 0;
    if (movable.is_fixed[row]) continue;
    const std::pair key(std::array{owners.corner[row], owners.net[row]}, place_of(pool.points[row]));
    movable.tie(known.emplace(key, static_cast<int>(row)).first->second, static_cast<int>(row));
  }
}

Movable movable_of(const PointPool& pool, const IndexedPatch& patch, const PatchInfluence& influence,
                   const PatchDrag& drag) {
  const std::vector<double>& first = drag.tangent_u_by ? influence.slopes_u : influence.slopes_v;
  Movable movable(pool.points.size());
  std::vector<int> uses(pool.points.size(), 0);
  for (std::size_t i = 0; i < patch.indices.size(); ++i) {
    const int row = patch.indices[i];
    movable.in_point[row] += influence.values[i];
    movable.in_first[row] += first[i];
    movable.in_second[row] += influence.slopes_v[i];
    movable.measure[row] += influence.measures[i];
    ++uses[row];
  }
  for (std::size_t row = 0; row < uses.size(); ++row) {
    if (uses[row] > 1) movable.measure[row] /= uses[row];
  }
  tie_points(pool.points, patch, movable);
  tie_directions(pool, movable);
  return movable;
}

struct At {
  double u;
  double v;
};

/// The points of the pool after a point of one of its patches, which is `value`, was dragged.
template <class Patch>
std::vector<glm::dvec4> dragged_points(const PointPool& pool, std::size_t number, const Patch& value, At at,
                                       const PatchDrag& drag, const Following& following) {
  require_finite(std::span(&drag.by, 1), "by");
  std::vector<const char*> chosen;
  std::vector<glm::dvec3> gains{drag.by};
  const auto choose = [&](const std::optional<glm::dvec3>& by, const char* argument, const char* name) {
    if (!by) return;
    require_finite(std::span(&*by, 1), argument);
    gains.push_back(*by);
    chosen.push_back(name);
  };
  choose(drag.tangent_u_by, "tangent_u_by", "the tangent along u");
  choose(drag.tangent_v_by, "tangent_v_by", "the tangent along v");
  const Movable movable = movable_of(pool, pool.patches[number], influence_of(value, at.u, at.v), drag);
  const Motion motion = least_change(movable, chosen, following, "u = " + text_of(at.u) + ", v = " + text_of(at.v));
  std::vector<glm::dvec4> points(pool.points.begin(), pool.points.end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    glm::dvec3 step(0.0);
    for (std::size_t k = 0; k < gains.size(); ++k) step += motion[k][i] * gains[k];
    if (step != glm::dvec3(0.0)) points[i] += glm::dvec4(step, 0.0);
  }
  return points;
}

/// The same of a patch that has its points alone.
template <class Patch>
std::vector<glm::dvec4> dragged_alone(std::span<const glm::dvec4> points, PatchKind kind, const Patch& value, At at,
                                      const PatchDrag& drag, const Following& following) {
  IndexedPatch patch;
  patch.kind = kind;
  patch.indices.resize(points.size());
  std::iota(patch.indices.begin(), patch.indices.end(), 0);
  return dragged_points({points, {&patch, 1}}, 0, value, at, drag, following);
}

std::vector<glm::dvec3> HermiteNet::* const kNets[] = {&HermiteNet::points, &HermiteNet::tangents_u,
                                                       &HermiteNet::tangents_v, &HermiteNet::twists};

}  // namespace

PatchSet dragged(const PatchSet& set, std::size_t patch, double u, double v, const PatchDrag& drag,
                 const Following& following) {
  if (patch >= set.patches().size()) {
    throw InvalidShape("patch = " + std::to_string(patch) + " is none of the " + std::to_string(set.patches().size()) +
                       " patches");
  }
  return set.with_points(
      dragged_points({set.points(), set.patches()}, patch, set.patch(patch), {u, v}, drag, following));
}

NurbsPatch dragged(const NurbsPatch& patch, double u, double v, const PatchDrag& drag, const Following& following) {
  return patch.with_points(dragged_alone(patch.points(), PatchKind::nurbs, patch, {u, v}, drag, following));
}

BezierPatch dragged(const BezierPatch& patch, double u, double v, const PatchDrag& drag, const Following& following) {
  return BezierPatch::make(patch.count(Axis::u), patch.count(Axis::v),
                           dragged_alone(patch.points(), PatchKind::bezier, patch.nurbs(), {u, v}, drag, following));
}

HermitePatch dragged(const HermitePatch& patch, double u, double v, const PatchDrag& drag, const Following& following) {
  std::vector<glm::dvec4> points;
  for (const auto net : kNets) {
    for (const glm::dvec3& row : patch.net().*net) points.emplace_back(row, net == kNets[0] ? 1.0 : 0.0);
  }
  points = dragged_alone(points, PatchKind::hermite, patch, {u, v}, drag, following);
  HermiteNet moved;
  auto next = points.begin();
  for (const auto net : kNets) {
    for (std::size_t i = 0; i < points.size() / 4; ++i) (moved.*net).emplace_back(*next++);
  }
  const auto u_parameters = patch.parameters(Axis::u);
  const auto v_parameters = patch.parameters(Axis::v);
  return HermitePatch::make(patch.count(Axis::u), patch.count(Axis::v), std::move(moved),
                            {u_parameters.begin(), u_parameters.end()}, {v_parameters.begin(), v_parameters.end()});
}

}  // namespace splinecore
