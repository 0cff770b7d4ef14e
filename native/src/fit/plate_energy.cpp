#include "plate_energy.hpp"

#include <utility>

#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// A net whose numbers are replaced by what is written of them, along one direction at a time.
class EnergyNet {
 public:
  EnergyNet(const PlateDirection& rows, const PlateDirection& columns, std::span<const glm::dvec3> points)
      : rows_(rows.count), row_size_(3 * columns.count), from_(3 * points.size()), to_(from_.size()) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (int c = 0; c < 3; ++c) from_[3 * i + static_cast<std::size_t>(c)] = points[i][c];
    }
  }

  /// @param write  has so many numbers at each place, and places to read and to write
  template <class Write>
  void along_rows(const Write& write) {
    write(row_size_, std::span<const double>(from_), std::span(to_));
    std::swap(from_, to_);
  }

  template <class Write>
  void along_columns(const Write& write) {
    for (std::size_t i = 0; i < rows_; ++i) {
      write(std::size_t{3}, std::span<const double>(from_).subspan(i * row_size_, row_size_),
            std::span(to_).subspan(i * row_size_, row_size_));
    }
    std::swap(from_, to_);
  }

  std::vector<glm::dvec3> points() const {
    std::vector<glm::dvec3> points;
    points.reserve(from_.size() / 3);
    for (std::size_t i = 0; i < from_.size(); i += 3) points.emplace_back(from_[i], from_[i + 1], from_[i + 2]);
    return points;
  }

 private:
  std::size_t rows_;
  std::size_t row_size_;
  std::vector<double> from_;
  std::vector<double> to_;
};

auto differences(const std::vector<double>& steps) {
  return [&steps](std::size_t columns, std::span<const double> from, std::span<double> to) {
    write_differences(steps, columns, from, to);
  };
}

auto sums_of_differences(const std::vector<double>& steps) {
  return [&steps](std::size_t columns, std::span<const double> from, std::span<double> to) {
    write_sums_of_differences(steps, columns, from, to);
  };
}

auto products(const ProductBand& band) {
  return [&band](std::size_t columns, std::span<const double> from, std::span<double> to) {
    write_products(band, columns, from, to);
  };
}

}  // namespace

std::vector<glm::dvec3> plate_product(const PlateDirection& rows, const PlateDirection& columns,
                                      std::array<std::size_t, 2> orders, std::span<const glm::dvec3> net) {
  breathe(3 * net.size() * (rows.bands[0].width + columns.bands[0].width));
  const auto [order, other] = orders;
  EnergyNet out(rows, columns, net);
  for (std::size_t k = 0; k < order; ++k) out.along_rows(differences(rows.steps[k]));
  for (std::size_t k = 0; k < other; ++k) out.along_columns(differences(columns.steps[k]));
  out.along_rows(products(rows.masses[order]));
  out.along_columns(products(columns.masses[other]));
  for (std::size_t k = other; k-- > 0;) out.along_columns(sums_of_differences(columns.steps[k]));
  for (std::size_t k = order; k-- > 0;) out.along_rows(sums_of_differences(rows.steps[k]));
  return out.points();
}

std::vector<glm::dvec3> plate_bending(const PlateDirection& rows, const PlateDirection& columns,
                                      std::span<const glm::dvec3> net) {
  std::vector<glm::dvec3> sum = plate_product(rows, columns, {2, 0}, net);
  const std::vector<glm::dvec3> mixed = plate_product(rows, columns, {1, 1}, net);
  const std::vector<glm::dvec3> other = plate_product(rows, columns, {0, 2}, net);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += 2.0 * mixed[i] + other[i];
  return sum;
}

}  // namespace splinecore
