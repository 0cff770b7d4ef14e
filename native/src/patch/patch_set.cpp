#include "splinecore/patch/patch_set.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>

#include "flip.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

std::size_t nets_of(const IndexedPatch& patch) { return patch.kind == PatchKind::hermite ? 4 : 1; }

void require_indices(const IndexedPatch& patch, std::size_t pool) {
  if (patch.count_u < 2 || patch.count_v < 2) {
    throw InvalidShape("indices is " + std::to_string(patch.count_u) + " x " +
                       std::to_string(patch.count_v) + ", a patch needs 2 x 2 or more");
  }
  const std::size_t wanted = nets_of(patch) * patch.count_u * patch.count_v;
  if (patch.indices.size() != wanted) {
    throw InvalidShape("indices has " + std::to_string(patch.indices.size()) + " values for " +
                       std::to_string(wanted));
  }
  for (std::size_t i = 0; i < patch.indices.size(); ++i) {
    if (patch.indices[i] >= 0 && static_cast<std::size_t>(patch.indices[i]) < pool) continue;
    throw InvalidShape("indices" + index_text(i, patch.count_v) + " = " + std::to_string(patch.indices[i]) +
                       " is outside the pool of " + std::to_string(pool) + " points");
  }
}

/// @throws InvalidShape for what the kind of patch has not: two sets of one shape would differ, and no text keeps it.
void require_own_fields(const IndexedPatch& patch) {
  const bool has_degrees = patch.degree_u != 0 || patch.degree_v != 0 || patch.periodic_u || patch.periodic_v;
  const bool has_knots = !patch.knots_u.empty() || !patch.knots_v.empty();
  if (patch.kind != PatchKind::nurbs && has_degrees) {
    throw InvalidShape("degree and periodic belong to NURBS patches, not to one of another kind");
  }
  if (patch.kind == PatchKind::bezier && has_knots) throw InvalidShape("knots belong to no Bezier patch");
}

/// One of the nets of a Hermite patch, whose rows must have the given w.
std::vector<glm::dvec3> hermite_net(const std::vector<glm::dvec4>& pool, const IndexedPatch& patch,
                                    std::size_t net, double w) {
  const std::size_t size = patch.indices.size() / 4;
  std::vector<glm::dvec3> vectors;
  for (std::size_t i = net * size; i < (net + 1) * size; ++i) {
    const glm::dvec4& row = pool[patch.indices[i]];
    if (row.w != w) {
      throw InvalidShape("points" + index_text(patch.indices[i]) + " has w = " + text_of(row.w) + ", a Hermite " +
                         (w == 1.0 ? "point needs w = 1" : "tangent or twist needs w = 0"));
    }
    vectors.emplace_back(row);
  }
  return vectors;
}

HermiteNet hermite_net(const std::vector<glm::dvec4>& pool, const IndexedPatch& patch) {
  return {hermite_net(pool, patch, 0, 1.0), hermite_net(pool, patch, 1, 0.0), hermite_net(pool, patch, 2, 0.0),
          hermite_net(pool, patch, 3, 0.0)};
}

std::vector<glm::dvec4> rows_of(const std::vector<glm::dvec4>& pool, const IndexedPatch& patch) {
  std::vector<glm::dvec4> points;
  points.reserve(patch.indices.size());
  for (const int i : patch.indices) points.push_back(pool[i]);
  return points;
}

AnyPatch value_of(const std::vector<glm::dvec4>& pool, const IndexedPatch& patch) {
  require_indices(patch, pool.size());
  require_own_fields(patch);
  if (patch.kind == PatchKind::hermite) {
    return HermitePatch::make(patch.count_u, patch.count_v, hermite_net(pool, patch), patch.knots_u, patch.knots_v);
  }
  std::vector<glm::dvec4> points = rows_of(pool, patch);
  if (patch.kind == PatchKind::bezier) return BezierPatch::make(patch.count_u, patch.count_v, std::move(points));
  KnotVector knots_u = KnotVector::make(patch.degree_u, patch.knots_u, patch.periodic_u);
  KnotVector knots_v = KnotVector::make(patch.degree_v, patch.knots_v, patch.periodic_v);
  if (knots_u.count() != patch.count_u || knots_v.count() != patch.count_v) {
    throw InvalidShape("count is " + std::to_string(patch.count_u) + " x " + std::to_string(patch.count_v) +
                       ", but the knots belong to " + std::to_string(knots_u.count()) + " x " +
                       std::to_string(knots_v.count()));
  }
  return NurbsPatch::make(std::move(knots_u), std::move(knots_v), std::move(points));
}

/// The value of a patch on another pool, on the knot vectors that it has.
AnyPatch moved(const AnyPatch& value, const IndexedPatch& patch, const std::vector<glm::dvec4>& pool) {
  if (const auto* hermite = std::get_if<HermitePatch>(&value)) return hermite->with_net(hermite_net(pool, patch));
  std::vector<glm::dvec4> points = rows_of(pool, patch);
  if (const auto* bezier = std::get_if<BezierPatch>(&value)) return bezier->with_points(std::move(points));
  return nurbs_of(value).with_points(std::move(points));
}

/// Whether two pools agree in every bit of the rows of a patch.
bool has_equal_rows(const IndexedPatch& patch, const std::vector<glm::dvec4>& pool,
                    const std::vector<glm::dvec4>& other) {
  return std::ranges::all_of(patch.indices, [&](int i) {
    return static_cast<std::size_t>(i) < other.size() && std::memcmp(&pool[i], &other[i], sizeof(glm::dvec4)) == 0;
  });
}

InvalidShape of_patch(std::size_t i, const InvalidShape& error) {
  return InvalidShape("patches" + index_text(i) + ": " + error.what());
}

/// Parameters that were left out: two sets of one shape are equal however they were made.
void fill_parameters(IndexedPatch& patch, const AnyPatch& value) {
  const auto* hermite = std::get_if<HermitePatch>(&value);
  if (hermite == nullptr) return;
  const auto fill = [&](std::vector<double>& knots, Axis axis) {
    const auto parameters = hermite->parameters(axis);
    if (knots.empty()) knots.assign(parameters.begin(), parameters.end());
  };
  fill(patch.knots_u, Axis::u);
  fill(patch.knots_v, Axis::v);
}

/// Collects points, each once where merging.
class PoolBuilder {
 public:
  explicit PoolBuilder(bool merged) : merged_(merged) {}

  int index_of(const glm::dvec4& point) {
    const auto next = static_cast<int>(points.size());
    breathe(kStepsOfPoint);
    if (merged_) {
      Bits bits;
      std::memcpy(bits.data(), &point, sizeof(point));
      const auto [found, is_new] = known_.emplace(bits, next);
      if (!is_new) return found->second;
    }
    points.push_back(point);
    return next;
  }

  std::vector<glm::dvec4> points;

 private:
  static constexpr std::size_t kStepsOfPoint = 200;
  using Bits = std::array<std::uint64_t, 4>;
  bool merged_;
  std::map<Bits, int> known_;
};

IndexedPatch indexed(const BezierPatch& patch, PoolBuilder& pool) {
  IndexedPatch indexed;
  indexed.kind = PatchKind::bezier;
  indexed.count_u = patch.count(Axis::u);
  indexed.count_v = patch.count(Axis::v);
  for (const glm::dvec4& p : patch.points()) indexed.indices.push_back(pool.index_of(p));
  return indexed;
}

IndexedPatch indexed(const HermitePatch& patch, PoolBuilder& pool) {
  IndexedPatch indexed;
  indexed.kind = PatchKind::hermite;
  indexed.count_u = patch.count(Axis::u);
  indexed.count_v = patch.count(Axis::v);
  const auto add = [&](const std::vector<glm::dvec3>& net, double w) {
    for (const glm::dvec3& vector : net) indexed.indices.push_back(pool.index_of({vector, w}));
  };
  add(patch.net().points, 1.0);
  add(patch.net().tangents_u, 0.0);
  add(patch.net().tangents_v, 0.0);
  add(patch.net().twists, 0.0);
  indexed.knots_u.assign(patch.parameters(Axis::u).begin(), patch.parameters(Axis::u).end());
  indexed.knots_v.assign(patch.parameters(Axis::v).begin(), patch.parameters(Axis::v).end());
  return indexed;
}

IndexedPatch indexed(const NurbsPatch& patch, PoolBuilder& pool) {
  const KnotVector& u = patch.knot_vector(Axis::u);
  const KnotVector& v = patch.knot_vector(Axis::v);
  IndexedPatch indexed{.kind = PatchKind::nurbs, .count_u = u.count(), .count_v = v.count(),
                       .indices = {}, .degree_u = u.degree(), .degree_v = v.degree(),
                       .periodic_u = u.periodic(), .periodic_v = v.periodic(),
                       .knots_u = {u.knots().begin(), u.knots().end()},
                       .knots_v = {v.knots().begin(), v.knots().end()}};
  for (const glm::dvec4& p : patch.points()) indexed.indices.push_back(pool.index_of(p));
  return indexed;
}

std::vector<int> transposed(const IndexedPatch& patch, std::size_t net) {
  const int* first = patch.indices.data() + net * patch.count_u * patch.count_v;
  std::vector<int> turned;
  for (int j = 0; j < patch.count_v; ++j) {
    for (int i = 0; i < patch.count_u; ++i) turned.push_back(first[i * patch.count_v + j]);
  }
  return turned;
}

}  // namespace

const NurbsPatch& nurbs_of(const AnyPatch& patch) noexcept {
  if (const auto* bezier = std::get_if<BezierPatch>(&patch)) return bezier->nurbs();
  if (const auto* hermite = std::get_if<HermitePatch>(&patch)) return hermite->nurbs();
  return *std::get_if<NurbsPatch>(&patch);
}

PatchSet PatchSet::make(std::vector<glm::dvec4> points, std::vector<IndexedPatch> patches) {
  require_points(points);
  if (patches.empty()) throw InvalidShape("patches is empty: a patch set needs one or more");
  PatchSet set;
  set.values_.reserve(patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    try {
      set.values_.push_back(std::make_shared<const AnyPatch>(value_of(points, patches[i])));
      fill_parameters(patches[i], *set.values_.back());
    } catch (const InvalidShape& error) {
      throw of_patch(i, error);
    }
  }
  set.points_ = std::move(points);
  set.patches_ = std::make_shared<const std::vector<IndexedPatch>>(std::move(patches));
  return set;
}

PatchSet PatchSet::with_points(std::vector<glm::dvec4> points) const {
  require_points(points);
  PatchSet set;
  set.values_.reserve(values_.size());
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const IndexedPatch& patch = (*patches_)[i];
    try {
      if (points.size() < points_.size()) require_indices(patch, points.size());
      const bool is_kept = has_equal_rows(patch, points_, points);
      set.values_.push_back(is_kept ? values_[i] : std::make_shared<const AnyPatch>(moved(*values_[i], patch, points)));
    } catch (const InvalidShape& error) {
      throw of_patch(i, error);
    }
  }
  set.points_ = std::move(points);
  set.patches_ = patches_;
  return set;
}

PatchSet PatchSet::of(std::span<const AnyPatch> patches, bool merged) {
  PoolBuilder pool(merged);
  std::vector<IndexedPatch> all;
  for (const AnyPatch& patch : patches) {
    all.push_back(std::visit([&](const auto& value) { return indexed(value, pool); }, patch));
  }
  return make(std::move(pool.points), std::move(all));
}

PatchSet flipped(const PatchSet& set) { return flipped(set, std::vector<bool>(set.patches().size(), true)); }

PatchSet flipped(const PatchSet& set, const std::vector<bool>& which) {
  if (which.size() != set.patches().size()) throw InvalidShape("which has not one answer for each patch");
  std::vector<IndexedPatch> patches(set.patches().begin(), set.patches().end());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (!which[i]) continue;
    IndexedPatch& patch = patches[i];
    std::vector<int> indices;
    // Of a Hermite patch the tangents along u become those along v.
    const std::array<std::size_t, 4> order{0, 2, 1, 3};
    for (std::size_t net = 0; net < nets_of(patch); ++net) {
      const std::vector<int> turned = transposed(patch, order[net]);
      indices.insert(indices.end(), turned.begin(), turned.end());
    }
    patch.indices = std::move(indices);
    std::swap(patch.count_u, patch.count_v);
    std::swap(patch.degree_u, patch.degree_v);
    std::swap(patch.periodic_u, patch.periodic_v);
    std::swap(patch.knots_u, patch.knots_v);
  }
  return PatchSet::make({set.points().begin(), set.points().end()}, std::move(patches));
}

}  // namespace splinecore
