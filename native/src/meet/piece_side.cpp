#include "piece_side.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/quotient.hpp"
#include "basis/bernstein_roots.hpp"

namespace splinecore {

namespace {

constexpr PieceSide kSides[] = {{Axis::u, false}, {Axis::u, true}, {Axis::v, false}, {Axis::v, true}};

bool is_zero_on(const SlopeForm& form, const PieceSide& side) {
  const std::vector<double> values = side_of(form.net, side).values;
  return std::ranges::all_of(values, [&](double value) { return std::abs(value) <= form.noise; });
}

/// So often a form is divided at most.
constexpr int kMostTimes = 3;

void divide_out(SlopeForm& form, const PieceSide& side) {
  for (int i = 0; i < kMostTimes && form.net.degree(side.axis) > 0 && is_zero_on(form, side); ++i) {
    form = divided(form, side);
  }
}

}  // namespace

bool are_one(const glm::dvec4& a, const glm::dvec4& b, double rounding) {
  constexpr double kSame = 0x1p-46;
  return a.w != 0.0 && b.w != 0.0 && glm::length(project(a) - project(b)) <= kSame + 4.0 * rounding;
}

bool is_point(const BernsteinNet<glm::dvec4>& piece, const PieceSide& side, double rounding) {
  const std::vector<glm::dvec4> points = side_of(piece, side).values;
  return std::ranges::all_of(points, [&](const glm::dvec4& h) { return are_one(h, points.front(), rounding); });
}

SlopeForm divided(const SlopeForm& form, const PieceSide& side) {
  const bool is_u = side.axis == Axis::u;
  const std::size_t degree = form.net.count(side.axis) - 1;
  SlopeForm out{{is_u ? degree : form.net.rows, is_u ? form.net.columns : degree, {}},
                form.noise * static_cast<double>(degree)};
  for (std::size_t i = 0; i < out.net.rows; ++i) {
    for (std::size_t j = 0; j < out.net.columns; ++j) {
      const std::size_t k = is_u ? i : j;
      const std::size_t shift = side.is_end ? 0 : 1;
      const double share = static_cast<double>(degree) / static_cast<double>(side.is_end ? degree - k : k + 1);
      out.net.values.push_back(share * (is_u ? form.net.at(i + shift, j) : form.net.at(i, j + shift)));
    }
  }
  return out;
}

PieceForms forms_of(const BernsteinNet<glm::dvec4>& piece, const std::array<Interval, 2>& part, const glm::dvec3& point,
                    double rounding) {
  PieceForms forms{slope_form(piece, Axis::u, point, rounding), slope_form(piece, Axis::v, point, rounding)};
  for (const PieceSide& side : kSides) {
    const Interval& along = part[static_cast<std::size_t>(side.axis)];
    const bool is_whole = side.is_end ? along.end == 1.0 : along.start == 0.0;
    if (!is_whole || !is_point(piece, side, rounding)) continue;
    divide_out(forms.u, side);
    divide_out(forms.v, side);
  }
  return forms;
}

PoleSigns pole_signs(const BernsteinNet<glm::dvec4>& piece, const PieceSide& side, const glm::dvec3& point,
                     double rounding) {
  SlopeForm form = slope_form(piece, side.axis, point, rounding);
  PoleSigns signs;
  signs.is_stationary = is_zero_on(form, side);
  if (signs.is_stationary && form.net.degree(side.axis) > 0) form = divided(form, side);
  const std::vector<double> values = side_of(form.net, side).values;
  const double way = (side.is_end ? -1.0 : 1.0) * (side_of(piece, side).values.front().w < 0.0 ? -1.0 : 1.0);
  std::vector<double> marks{0.0};
  for (const Interval& zero : bernstein_zeros(values, form.noise)) marks.push_back(zero.start);
  marks.push_back(1.0);
  for (std::size_t i = 1; i < marks.size(); ++i) {
    const double value = way * bernstein_value(values, Interval{marks[i - 1], marks[i]}.middle());
    signs.rises = signs.rises || value > form.noise;
    signs.falls = signs.falls || value < -form.noise;
  }
  return signs;
}

}  // namespace splinecore
