#pragma once

#include <glm/geometric.hpp>
#include <optional>

#include "edge_rows.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// B(t) is (1 + g t + e t² / 2) A(k t + m t² / 2) up to the second order.
struct Constants {
  double k = 1.0;
  double m = 0.0;
  double g = 0.0;
  double e = 0.0;
};

/// Homogeneous rows about the points of an edge: (w (P - O), w). Far from the origin no digit is lost, and where
/// the edge is in sight its own row has nothing but weights.
struct LocalRows {
  std::array<EdgeRow, kMostRows> rows;
  const EdgeRows* source;

  double coefficient(int k, int i) const { return source->coefficients[k][i]; }

  /// Derivative k of the column, of the rows before `end` alone.
  glm::dvec4 derivative(int k, std::size_t column, int end = kMostRows) const {
    glm::dvec4 sum(0.0);
    for (int i = 0; i < end; ++i) {
      if (coefficient(k, i) != 0.0) sum += coefficient(k, i) * rows[i][column];
    }
    return sum;
  }
};

inline std::vector<glm::dvec3> origins_of(const EdgeRow& edge) {
  std::vector<glm::dvec3> origins;
  for (const glm::dvec4& p : edge) origins.push_back(p.w == 0.0 ? glm::dvec3(0.0) : glm::dvec3(p));
  return origins;
}

inline LocalRows local_rows(const EdgeRows& given, const std::vector<glm::dvec3>& origins) {
  LocalRows local{given.rows, &given};
  for (EdgeRow& row : local.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i].w != 0.0) row[i] = glm::dvec4(row[i].w * (glm::dvec3(row[i]) - origins[i]), row[i].w);
    }
  }
  return local;
}

/// Rows from the first to before the last in the form in which points are given.
void write_back(const LocalRows& local, const std::vector<glm::dvec3>& origins, int first, int last, EdgeRows& to);

/// Products of places, summed over the edge.
template <class One, class Other>
double product(std::size_t count, One one, Other other) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += glm::dot(glm::dvec3(one(i)), glm::dvec3(other(i)));
  return sum;
}

/// A k below this share of what keeps the mean length of the legs would fold them back, or nearly.
inline constexpr double kLeastShare = 0.1;

bool is_geometric(PatchSmoothness smoothness) noexcept;

/// @throws InvalidShape if the row beside the edge lies on it.
void require_legs(const LocalRows& on);

/// Constants that were found before.
struct KnownRatios {
  std::optional<double> k;
  std::optional<double> m;
};

/// Brings the rows of b, about the edge of a, to those of a.
Constants follow_locally(const LocalRows& a, LocalRows& b, PatchSmoothness smoothness, bool is_rational,
                         KnownRatios known = {});

/// The same on rows as given.
void follow(const EdgeRows& a, EdgeRows& b, PatchSmoothness smoothness, bool is_rational, KnownRatios known);

}  // namespace splinecore
#pragma GCC visibility pop
