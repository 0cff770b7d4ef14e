#include "blossom.hpp"

namespace splinecore {

void blossom_weights(const double* t, int degree, std::span<const double> arguments, double* row) {
  const int levels = static_cast<int>(arguments.size());
  row[0] = 1.0;
  // From the tip of the pyramid down: the weights of `level` points become those of one more.
  for (int level = 1; level <= levels; ++level) {
    const double u = arguments[level - 1];
    double carried = 0.0;
    for (int r = 0; r < level; ++r) {
      const double low = t[levels - level + 1 + r];
      const double high = t[degree + 1 + r];
      const double weight = row[r];
      row[r] = carried + weight * ((high - u) / (high - low));
      carried = weight * ((u - low) / (high - low));
    }
    row[level] = carried;
  }
}

}  // namespace splinecore
