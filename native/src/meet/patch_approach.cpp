#include "patch_approach.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>


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

using RangesOfFour = std::array<Interval, 4>;

constexpr Interval kWide{-kBeyond, 1.0 + kBeyond};
constexpr RangesOfFour kAround{kWide, kWide, kWide, kWide};

/// @returns the largest step, none if it leads out of the box
std::optional<double> advance(PatchSpots& at, const Four& steps, const RangesOfFour& box = kAround) {
  double most = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    at[i] += steps[i];
    most = std::max(most, std::abs(steps[i]));
    if (!(at[i] >= box[i].start && at[i] <= box[i].end)) return {};
  }
  return most;
}

/// Newton's method with a fourth equation: its row, and how far it is from being satisfied. Where normals are nearly
/// parallel rounding keeps it from coming to rest.
template <class Fourth>
std::optional<PatchSpots> newton(const TwoPatches& patches, PatchSpots at, Fourth fourth, const RangesOfFour& box = kAround) {
  constexpr int kMost = 24;
  constexpr double kStill = 0x1p-44;
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kMost; ++round) {
    const PatchMeeting now = meeting_at(patches, at);
    FourByFour rows = gap_rows(now);
    const glm::dvec3 gap = now.b.offset;
    const auto [row, off] = fourth(now, at);
    rows[3] = row;
    const std::optional<Four> steps = solved(rows, {-gap.x, -gap.y, -gap.z, -off});
    if (!steps) return {};
    const std::optional<double> most = advance(at, *steps, box);
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

PatchMeeting meeting_at(const TwoPatches& patches, const PatchSpots& at) {
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
  return place_near(patches, at, face, kAround);
}

std::optional<PatchSpots> place_near(const TwoPatches& patches, PatchSpots at, const OnFace& face, const RangesOfFour& box) {
  at[face.parameter] = face.value;
  const auto on_face = [&](const PatchMeeting&, const PatchSpots& now) {
    Four row{};
    row[face.parameter] = 1.0;
    return std::pair(row, now[face.parameter] - face.value);
  };
  return newton(patches, at, on_face, box);
}

namespace {

/// An equation for steps of the parameters: its row, and how far it is from being satisfied.
struct StepEquation {
  Four row{};
  double off = 0.0;
};

/// The gap has no part along a tangent of the second patch.
StepEquation gap_along(const PatchMeeting& at, std::size_t k) {
  const glm::dvec3& tangent = at.b.first[k];
  const auto& [bss, btt, bst] = at.b.second;
  const glm::dvec3& by_s = k == 0 ? bss : bst;
  const glm::dvec3& by_t = k == 0 ? bst : btt;
  const glm::dvec3& gap = at.b.offset;
  return {{-glm::dot(at.a.first[0], tangent), -glm::dot(at.a.first[1], tangent),
           glm::dot(at.b.first[0], tangent) + glm::dot(gap, by_s), glm::dot(at.b.first[1], tangent) + glm::dot(gap, by_t)},
          glm::dot(gap, tangent)};
}

/// The tangent of the first patch across a way is a tangent of the second one.
StepEquation tangent_across(const PatchMeeting& at, const glm::dvec3& way) {
  const auto& [au, av] = at.a.first;
  const auto& [auu, avv, auv] = at.a.second;
  const auto& [bs, bt] = at.b.first;
  const auto& [bss, btt, bst] = at.b.second;
  const glm::dvec3 of_a = glm::cross(au, av);
  const glm::dvec3 of_b = glm::cross(bs, bt);
  const double scale = 1.0 / std::max(glm::length(of_a) * glm::length(of_b), 1e-300);
  const glm::dvec3 across = scale * glm::cross(of_a, way);
  const auto by_a = [&](const glm::dvec3& change) { return scale * glm::dot(of_b, glm::cross(change, way)); };
  return {{by_a(glm::cross(auu, av) + glm::cross(au, auv)), by_a(glm::cross(auv, av) + glm::cross(au, avv)),
           glm::dot(glm::cross(bss, bt) + glm::cross(bs, bst), across),
           glm::dot(glm::cross(bst, bt) + glm::cross(bs, btt), across)},
          glm::dot(of_b, across)};
}

StepEquation on_face(const PatchSpots& at, const OnFace& face) {
  StepEquation found;
  found.row[face.parameter] = 1.0;
  found.off = at[face.parameter] - face.value;
  return found;
}

/// Newton's method for two equations beside those of a foot on the second patch.
template <class Equations>
std::optional<PatchSpots> newton_on_foot(const TwoPatches& patches, PatchSpots at, Equations equations) {
  constexpr int kMost = 24;
  constexpr double kStill = 0x1p-42;
  constexpr double kNoise = 0x1p-28;
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kMost; ++round) {
    const PatchMeeting now = meeting_at(patches, at);
    const std::array<StepEquation, 2> more = equations(now, at);
    const std::array<StepEquation, 4> all{gap_along(now, 0), gap_along(now, 1), more[0], more[1]};
    const std::optional<Four> steps = solved({all[0].row, all[1].row, all[2].row, all[3].row},
                                             {-all[0].off, -all[1].off, -all[2].off, -all[3].off});
    if (!steps) return {};
    const std::optional<double> most = advance(at, *steps);
    if (!most) return {};
    if (*most <= kStill || (*most >= 0.25 * before && before <= kNoise)) return at;
    before = *most;
  }
  return {};
}

/// What a place of a contact that is no crossing satisfies, whatever else is asked.
StepEquation of_contact(const PatchMeeting& now, const PatchSpots& at, const PatchContact& contact, const glm::dvec3& way) {
  return contact.kind == PatchContact::Kind::grazing ? tangent_across(now, way) : on_face(at, contact.border);
}

}  // namespace

std::optional<PatchSpots> contact_near(const TwoPatches& patches, PatchSpots at, const PatchContact& contact,
                                       const glm::dvec3& way, const InPlane& plane) {
  if (contact.kind == PatchContact::Kind::crossing) return place_near(patches, at, plane);
  return newton_on_foot(patches, at, [&](const PatchMeeting& now, const PatchSpots& there) -> std::array<StepEquation, 2> {
    const StepEquation in_plane{{glm::dot(now.a.first[0], plane.normal), glm::dot(now.a.first[1], plane.normal), 0.0, 0.0},
                                glm::dot(now.a.point - plane.origin, plane.normal)};
    return {of_contact(now, there, contact, way), in_plane};
  });
}

std::optional<PatchSpots> contact_near(const TwoPatches& patches, PatchSpots at, const PatchContact& contact,
                                       const glm::dvec3& way, const OnFace& face) {
  if (contact.kind == PatchContact::Kind::crossing) return place_near(patches, at, face);
  at[face.parameter] = face.value;
  return newton_on_foot(patches, at, [&](const PatchMeeting& now, const PatchSpots& there) -> std::array<StepEquation, 2> {
    return {of_contact(now, there, contact, way), on_face(there, face)};
  });
}

std::optional<PatchSpots> foot_near(const TwoPatches& patches, PatchSpots at) {
  constexpr int kMost = 24;
  constexpr double kStill = 0x1p-42;
  constexpr double kNoise = 0x1p-28;
  const glm::dvec3 point = patches.a.at(at.a).point;
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kMost; ++round) {
    const Slopes<2> b = patches.b.at(at.b, point);
    const auto& [bs, bt] = b.first;
    const double ss = glm::dot(bs, bs) + glm::dot(b.offset, b.second[0]);
    const double tt = glm::dot(bt, bt) + glm::dot(b.offset, b.second[1]);
    const double st = glm::dot(bs, bt) + glm::dot(b.offset, b.second[2]);
    const double s = glm::dot(b.offset, bs);
    const double t = glm::dot(b.offset, bt);
    const double area = ss * tt - st * st;
    if (!(std::abs(area) > 0.0)) return {};
    const std::optional<double> most = advance(at, {0.0, 0.0, (st * t - tt * s) / area, (st * s - ss * t) / area});
    if (!most) return {};
    if (*most <= kStill || (*most >= 0.25 * before && before <= kNoise)) return at;
    before = *most;
  }
  return {};
}

std::optional<PatchSpots> touch_near(const TwoPatches& patches, PatchSpots at) {
  return touch_near(patches, at, kAround);
}

/// Both tangents of the first patch are at right angles to the gap, those of the second one to the first one's normal;
/// Levenberg and Marquardt's method, for where such places are a curve no one of them is best.
std::optional<PatchSpots> touch_near(const TwoPatches& patches, PatchSpots at, const std::array<Interval, 4>& box) {
  constexpr int kMost = 40;
  constexpr double kStill = 0x1p-46;
  constexpr double kNoise = 0x1p-28;
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kMost; ++round) {
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
    const std::optional<double> most = advance(at, *steps, box);
    if (!most) return {};
    if (*most <= kStill || (*most >= 0.25 * before && before <= kNoise)) return at;
    before = *most;
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
