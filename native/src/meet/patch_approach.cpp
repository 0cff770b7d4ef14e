#include "patch_approach.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

using Four = std::array<double, 4>;
using FourByFour = std::array<Four, 4>;

/// So far beyond its piece a patch is looked at.
constexpr double kBeyond = 1.0;
/// What rounding may leave of a gap, in a space where the shapes are about 1 large.
constexpr double kNoGap = 0x1p-46;

glm::dvec3 unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : glm::dvec3(0.0);
}

/// Gauss's elimination with the largest pivots. @returns none if one is zero
std::optional<Four> solved(FourByFour m, Four right) {
  for (std::size_t k = 0; k < 4; ++k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < 4; ++i) {
      if (std::abs(m[i][k]) > std::abs(m[best][k])) best = i;
    }
    std::swap(m[k], m[best]);
    std::swap(right[k], right[best]);
    if (!(std::abs(m[k][k]) > 0.0)) return {};
    for (std::size_t i = k + 1; i < 4; ++i) {
      const double share = m[i][k] / m[k][k];
      for (std::size_t j = k; j < 4; ++j) m[i][j] -= share * m[k][j];
      right[i] -= share * right[k];
    }
  }
  for (std::size_t k = 4; k-- > 0;) {
    for (std::size_t j = k + 1; j < 4; ++j) right[k] -= m[k][j] * right[j];
    right[k] /= m[k][k];
  }
  return right;
}

/// Rows of what changes where the gap does: its derivatives.
FourByFour gap_rows(const PatchMeeting& at) {
  FourByFour rows{};
  for (int i = 0; i < 3; ++i) {
    rows[static_cast<std::size_t>(i)] = {-at.a.first[0][i], -at.a.first[1][i], at.b.first[0][i], at.b.first[1][i]};
  }
  return rows;
}

/// @returns the largest step, none if it leads too far out
std::optional<double> advance(PatchSpots& at, const Four& steps) {
  double most = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    at[i] += steps[i];
    most = std::max(most, std::abs(steps[i]));
    if (!(at[i] >= -kBeyond && at[i] <= 1.0 + kBeyond)) return {};
  }
  return most;
}

/// Newton's method with a fourth equation: its row, and how far it is from being satisfied. Where normals are nearly
/// parallel rounding keeps it from coming to rest.
template <class Fourth>
std::optional<PatchSpots> newton(const TwoPatches& patches, PatchSpots at, Fourth fourth) {
  constexpr int kMost = 24;
  constexpr double kStill = 0x1p-44;
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kMost; ++round) {
    breathe(256);
    const PatchMeeting now = meeting_at(patches, at);
    FourByFour rows = gap_rows(now);
    const glm::dvec3 gap = now.b.offset;
    const auto [row, off] = fourth(now, at);
    rows[3] = row;
    const std::optional<Four> steps = solved(rows, {-gap.x, -gap.y, -gap.z, -off});
    if (!steps) return {};
    const std::optional<double> most = advance(at, *steps);
    if (!most) return {};
    if (*most <= kStill || (*most >= 0.25 * before && glm::length(gap) <= kNoGap)) return at;
    before = *most;
  }
  return {};
}

}  // namespace

double PatchMeeting::distance() const noexcept { return glm::length(b.offset); }

bool enters(PatchSpots& at) noexcept {
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(at[i] >= -kOnSide && at[i] <= 1.0 + kOnSide)) return false;
  }
  for (std::size_t i = 0; i < 4; ++i) at[i] = std::clamp(at[i], 0.0, 1.0);
  return true;
}

PatchMeeting meeting_at(const TwoPatches& patches, const PatchSpots& at) noexcept {
  PatchMeeting found;
  found.a = patches.a.at(at.a);
  found.b = patches.b.at(at.b, found.a.point);
  found.normal_a = unit(glm::cross(found.a.first[0], found.a.first[1]));
  found.normal_b = unit(glm::cross(found.b.first[0], found.b.first[1]));
  found.along = glm::cross(found.normal_a, found.normal_b);
  return found;
}

std::optional<PatchSpots> place_near(const TwoPatches& patches, PatchSpots at, const InPlane& plane) {
  return newton(patches, at, [&](const PatchMeeting& now, const PatchSpots&) {
    const Four row{glm::dot(now.a.first[0], plane.normal), glm::dot(now.a.first[1], plane.normal), 0.0, 0.0};
    return std::pair(row, glm::dot(now.a.point - plane.origin, plane.normal));
  });
}

std::optional<PatchSpots> place_near(const TwoPatches& patches, PatchSpots at, const OnFace& face) {
  at[face.parameter] = face.value;
  return newton(patches, at, [&](const PatchMeeting&, const PatchSpots& now) {
    Four row{};
    row[face.parameter] = 1.0;
    return std::pair(row, now[face.parameter] - face.value);
  });
}

/// Both tangents of the first patch are at right angles to the gap, those of the second one to the first one's normal;
/// Levenberg and Marquardt's method, for where such places are a curve no one of them is best.
std::optional<PatchSpots> touch_near(const TwoPatches& patches, PatchSpots at) {
  constexpr int kMost = 40;
  constexpr double kStill = 0x1p-46;
  for (int round = 0; round < kMost; ++round) {
    breathe(256);
    const PatchMeeting now = meeting_at(patches, at);
    const auto& [au, av] = now.a.first;
    const auto& [auu, avv, auv] = now.a.second;
    const auto& [bu, bv] = now.b.first;
    const auto& [buu, bvv, buv] = now.b.second;
    const glm::dvec3 gap = now.b.offset;
    const glm::dvec3 n = glm::cross(au, av);
    const glm::dvec3 n_u = glm::cross(auu, av) + glm::cross(au, auv);
    const glm::dvec3 n_v = glm::cross(auv, av) + glm::cross(au, avv);
    const Four value{glm::dot(gap, au), glm::dot(gap, av), glm::dot(n, bu), glm::dot(n, bv)};
    const FourByFour j{Four{glm::dot(gap, auu) - glm::dot(au, au), glm::dot(gap, auv) - glm::dot(au, av), glm::dot(bu, au),
                       glm::dot(bv, au)},
                   Four{glm::dot(gap, auv) - glm::dot(au, av), glm::dot(gap, avv) - glm::dot(av, av), glm::dot(bu, av),
                       glm::dot(bv, av)},
                   Four{glm::dot(n_u, bu), glm::dot(n_v, bu), glm::dot(n, buu), glm::dot(n, buv)},
                   Four{glm::dot(n_u, bv), glm::dot(n_v, bv), glm::dot(n, buv), glm::dot(n, bvv)}};
    FourByFour normal{};
    Four right{};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t row = 0; row < 4; ++row) normal[i][k] += j[row][i] * j[row][k];
      }
      for (std::size_t row = 0; row < 4; ++row) right[i] -= j[row][i] * value[row];
    }
    for (std::size_t i = 0; i < 4; ++i) normal[i][i] *= 1.0 + 0x1p-30;
    const std::optional<Four> steps = solved(normal, right);
    if (!steps) return {};
    const std::optional<double> most = advance(at, *steps);
    if (!most) return {};
    if (*most <= kStill) return at;
  }
  return {};
}

std::array<double, 4> slopes_along(const PatchMeeting& at, const glm::dvec3& tangent) noexcept {
  const auto of = [&](const std::array<glm::dvec3, 2>& first) -> std::array<double, 2> {
    const glm::dvec3 normal = glm::cross(first[0], first[1]);
    const double square = glm::dot(normal, normal);
    if (!(square > 0.0)) return {0.0, 0.0};
    return {glm::dot(glm::cross(tangent, first[1]), normal) / square,
            glm::dot(glm::cross(first[0], tangent), normal) / square};
  };
  const auto a = of(at.a.first);
  const auto b = of(at.b.first);
  return {a[0], a[1], b[0], b[1]};
}

}  // namespace splinecore
