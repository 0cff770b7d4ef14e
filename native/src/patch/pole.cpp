#include "pole.hpp"

#include "base/given_points.hpp"
#include "clamped_end.hpp"
#include "lines.hpp"
#include "settled.hpp"

namespace splinecore {

namespace {

/// Where S_u x S_v and C x C' have the same sense.
double sense_of(Border side) { return side == Border::u_start || side == Border::v_end ? 1.0 : -1.0; }

}  // namespace

std::optional<Pole> Pole::at(const NurbsPatch& patch, Border side) {
  const Axis axis = axis_of(side);
  const KnotVector& knots = patch.knot_vector(axis);
  const bool at_end = is_at_end(side);
  if (!is_clamped_at(knots, at_end)) return std::nullopt;
  const Lines lines = lines_of(patch, axis);
  const auto place = [&](std::size_t line, std::size_t row) {
    return lines.at(line, at_end ? lines.size - 1 - row : row);
  };
  const glm::dvec4& first = patch.points()[place(0, 0)];
  for (std::size_t line = 0; line < lines.count; ++line) {
    const glm::dvec4& p = patch.points()[place(line, 0)];
    if (p.w == 0.0 || glm::dvec3(p) != glm::dvec3(first)) return std::nullopt;
  }
  const KnotVector& along = patch.knot_vector(across(axis));
  Pole pole(side, at_end ? knots.domain().end : knots.domain().start, along.degree());
  for (std::size_t i = 0; i < static_cast<std::size_t>(along.unrolled_count()); ++i) {
    pole.points_.push_back(patch.points()[place(i % lines.count, 1)]);
  }
  pole.points_ = with_weights_divided(pole.points_, patch.weight_exponent());
  for (glm::dvec4& p : pole.points_) {
    if (p.w != 0.0) p = glm::dvec4(p.w * (glm::dvec3(p) - glm::dvec3(first)), p.w);
  }
  return pole;
}

std::pmr::vector<double> Pole::normals(const GridColumns& along, const NormalRounding& rounding,
                                       std::pmr::memory_resource* memory) const {
  const GridBlocks blocks = along.blocks(0);
  const GridForm form{&points_.data()->x, points_.size(), 0, degree_, false};
  const double one = 1.0;
  const double sense = sense_of(side_);
  const GridRow row{0, &one, &sense, 1.0, rounding};
  std::pmr::vector<double> scratch(along.scratch_size(2), memory);
  std::pmr::vector<double> points(3 * blocks.columns, memory);
  std::pmr::vector<double> normals(3 * blocks.columns, memory);
  kernels().grid_normals(form, row, blocks, scratch.data(), points.data(), normals.data());
  return normals;
}

std::vector<Pole> poles_of(const NurbsPatch& patch) {
  std::vector<Pole> poles;
  for (const Border side : {Border::u_start, Border::u_end, Border::v_start, Border::v_end}) {
    if (auto pole = Pole::at(patch, side)) poles.push_back(std::move(*pole));
  }
  return poles;
}

PoleNormals::PoleNormals(std::span<const Pole> poles, const NormalRounding& rounding, const GridPlan& plan,
                         std::pmr::memory_resource* memory)
    : plan_(plan), rows_(memory) {
  rows_.reserve(poles.size());
  for (const Pole& pole : poles) {
    const Samples& across = pole.axis() == Axis::u ? plan.u : plan.v;
    bool is_met = false;
    for (std::size_t i = 0; i < across.size() && !is_met; ++i) is_met = across.parameter(i) == pole.parameter();
    if (!is_met) continue;
    const GridColumns& along = pole.axis() == Axis::u ? plan.columns : plan.rows->turned();
    rows_.push_back({&pole, pole.normals(along, rounding, memory)});
  }
}

glm::dvec3 PoleNormals::at(std::size_t i, std::size_t j) const {
  for (const Row& row : rows_) {
    const bool is_along_v = row.pole->axis() == Axis::u;
    const double parameter = is_along_v ? plan_.u.parameter(i) : plan_.v.parameter(j);
    const double* const normal = &row.normals[3 * (is_along_v ? j : i)];
    if (parameter == row.pole->parameter() && is_number(normal)) return {normal[0], normal[1], normal[2]};
  }
  return glm::dvec3(kNan);
}

}  // namespace splinecore
