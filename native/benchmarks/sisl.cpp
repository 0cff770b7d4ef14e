// SISL, SINTEF's spline library, as Debian packages it.
#include <sisl.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "driver.hpp"

namespace {

using benchmarks::Numbers;
using benchmarks::Run;

struct FreeCurve {
  void operator()(SISLCurve* curve) const { freeCurve(curve); }
};
struct FreeSurface {
  void operator()(SISLSurf* surface) const { freeSurf(surface); }
};
using Curve = std::unique_ptr<SISLCurve, FreeCurve>;
using Surface = std::unique_ptr<SISLSurf, FreeSurface>;

constexpr int kPolynomial = 1;
constexpr int kRational = 2;
constexpr int kCopy = 1;

void require(int status) {
  if (status < 0) throw std::runtime_error("status " + std::to_string(status));
}

/// x w, y w, z w, w of a row x, y, z, w.
void append_homogeneous(Numbers& out, const double* p) {
  out.insert(out.end(), {p[0] * p[3], p[1] * p[3], p[2] * p[3], p[3]});
}

Curve rational_curve(const Run& run) {
  Numbers knots = run.input("curve.knots");
  const Numbers rows = run.input("curve.points");
  Numbers points;
  for (std::size_t i = 0; i < rows.size(); i += 4) append_homogeneous(points, &rows[i]);
  const auto count = static_cast<int>(rows.size() / 4);
  return Curve(newCurve(count, 4, knots.data(), points.data(), kRational, 3, kCopy));
}

/// The first three columns only.
Curve long_curve(const Run& run) {
  Numbers knots = run.input("long.knots");
  const Numbers rows = run.input("long.points");
  Numbers points;
  for (std::size_t i = 0; i < rows.size(); i += 4) points.insert(points.end(), {rows[i], rows[i + 1], rows[i + 2]});
  const auto count = static_cast<int>(rows.size() / 4);
  return Curve(newCurve(count, 4, knots.data(), points.data(), kPolynomial, 3, kCopy));
}

Curve bezier_curve(const Run& run, int degree) {
  Numbers points = run.input("bezier" + std::to_string(degree) + ".points");
  Numbers knots(2 * (degree + 1), 0.0);
  std::fill(knots.begin() + degree + 1, knots.end(), 1.0);
  return Curve(newCurve(degree + 1, degree + 1, knots.data(), points.data(), kPolynomial, 3, kCopy));
}

Curve zigzag(const Run& run, const std::string& name) {
  Numbers knots = run.input("zigzag.knots");
  const Numbers rows = run.input(name);
  Numbers plane;
  for (std::size_t i = 0; i < rows.size(); i += 3) plane.insert(plane.end(), {rows[i], rows[i + 1]});
  return Curve(newCurve(static_cast<int>(rows.size() / 3), 4, knots.data(), plane.data(), kPolynomial, 2, kCopy));
}

Surface waves(const Run& run, const std::string& name) {
  Numbers knots = run.input("waves.knots");
  const Numbers rows = run.input(name);
  const std::size_t count = knots.size() - 4;
  Numbers points;
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t i = 0; i < count; ++i) {
      const double* p = &rows[3 * (i * count + j)];
      points.insert(points.end(), {p[0], p[1], p[2]});
    }
  }
  const auto size = static_cast<int>(count);
  return Surface(newSurf(size, size, 4, 4, knots.data(), knots.data(), points.data(), kPolynomial, 3, kCopy));
}

/// SISL runs along u fastest.
Surface rational_surface(const Run& run) {
  Numbers knots_u = run.input("surface.knots_u");
  Numbers knots_v = run.input("surface.knots_v");
  const Numbers rows = run.input("surface.points");
  const auto count_u = static_cast<int>(knots_u.size()) - 4;
  const auto count_v = static_cast<int>(knots_v.size()) - 4;
  Numbers points;
  for (int j = 0; j < count_v; ++j) {
    for (int i = 0; i < count_u; ++i) append_homogeneous(points, &rows[4 * (i * count_v + j)]);
  }
  return Surface(newSurf(count_u, count_v, 4, 4, knots_u.data(), knots_v.data(), points.data(), kRational, 3, kCopy));
}

std::vector<Surface> teapot(const Run& run) {
  const Numbers nets = run.input("teapot");
  Numbers knots = {0, 0, 0, 0, 1, 1, 1, 1};
  std::vector<Surface> patches;
  for (const double* net = nets.data(); net != nets.data() + nets.size(); net += 48) {
    Numbers points;
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) points.insert(points.end(), net + 12 * i + 3 * j, net + 12 * i + 3 * j + 3);
    }
    patches.emplace_back(newSurf(4, 4, 4, 4, knots.data(), knots.data(), points.data(), kPolynomial, 3, kCopy));
  }
  return patches;
}

void evaluate_each(const Run& run, const Curve& curve, const Numbers& parameters, int derivatives) {
  const std::size_t columns = 3 * (derivatives + 1);
  Numbers out(columns * parameters.size());
  run.time("s1221", parameters.size(), [&] {
    int left = 0;
    int status = 0;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      s1221(curve.get(), derivatives, parameters[i], &left, &out[columns * i], &status);
    }
    require(status);
  });
  run.keep("s1221", parameters.size(), columns, [&](std::size_t i) { return &out[columns * i]; });
}

void sorted_points(const Run& run) {
  const Curve curve = rational_curve(run);
  Numbers parameters = run.input("sorted");
  Numbers out(3 * parameters.size());
  run.time("s1542", parameters.size(), [&] {
    int status = 0;
    s1542(curve.get(), static_cast<int>(parameters.size()), parameters.data(), out.data(), &status);
    require(status);
  });
  run.keep("s1542", parameters.size(), 3, [&](std::size_t i) { return &out[3 * i]; });
}

void grid(const Run& run, bool with_normals) {
  const Surface surface = rational_surface(run);
  Numbers line = run.input("grid");
  const std::size_t n = line.size();
  const std::size_t stride = with_normals ? 9 : 3;
  Numbers points(stride * n * n);
  Numbers normals(3 * n * n);
  run.time("s1506", n * n, [&] {
    int status = 0;
    s1506(surface.get(), with_normals ? 1 : 0, static_cast<int>(n), line.data(), static_cast<int>(n), line.data(),
          points.data(), normals.data(), &status);
    require(status);
  });
  std::array<double, 6> row{};
  run.keep("s1506", n * n, with_normals ? 6 : 3, [&](std::size_t i) {
    const std::size_t at = i % n * n + i / n;
    std::copy_n(&points[stride * at], 3, row.data());
    std::copy_n(&normals[3 * at], 3, row.data() + 3);
    return row.data();
  });
}

void scattered_pairs(const Run& run) {
  const Surface surface = rational_surface(run);
  Numbers pairs = run.input("pairs");
  const std::size_t count = pairs.size() / 2;
  Numbers out(9 * count);
  run.time("s1421", count, [&] {
    int left_u = 0;
    int left_v = 0;
    int status = 0;
    std::array<double, 3> normal{};
    for (std::size_t i = 0; i < count; ++i) {
      s1421(surface.get(), 1, &pairs[2 * i], &left_u, &left_v, &out[9 * i], normal.data(), &status);
    }
    require(status);
  });
  run.keep("s1421", count, 9, [&](std::size_t i) { return &out[9 * i]; });
}

using Verb = std::function<void(SISLCurve*, SISLCurve**, int*)>;

/// A verb that gives another curve; every seventh of its points is kept.
void verb(const Run& run, const std::string& call, std::size_t items, const Verb& apply) {
  const Curve curve = long_curve(run);
  Curve result;
  run.time(call, items, [&] {
    SISLCurve* made = nullptr;
    int status = 0;
    apply(curve.get(), &made, &status);
    require(status);
    result.reset(made);
  });
  run.keep(call, static_cast<std::size_t>(result->in), 3, [&](std::size_t i) { return result->ecoef + 3 * i; }, 7);
}

struct Free {
  void operator()(double* numbers) const { free(numbers); }
};

void interpolated_curve(const Run& run, int count) {
  Numbers points = run.input("coil" + std::to_string(count));
  std::vector<int> kinds(static_cast<std::size_t>(count), 1);
  Curve result;
  std::unique_ptr<double, Free> parameters;
  run.time("s1356", static_cast<std::size_t>(count), [&] {
    SISLCurve* made = nullptr;
    double* found = nullptr;
    double end = 0;
    int number = 0;
    int status = 0;
    s1356(points.data(), count, 3, kinds.data(), 0, 0, 1, 4, 0.0, &end, &made, &found, &number, &status);
    require(status);
    result.reset(made);
    parameters.reset(found);
  });
  std::array<double, 3> row{};
  run.keep("s1356", static_cast<std::size_t>(count), 3, [&](std::size_t i) {
    int left = 0;
    int status = 0;
    s1221(result.get(), 0, parameters.get()[i], &left, row.data(), &status);
    return row.data();
  }, 7);
}

/// SISL runs along u fastest.
void interpolated_surface(const Run& run) {
  const Numbers rows = run.input("sheet300");
  Numbers line = run.input("line300");
  const auto n = static_cast<int>(line.size());
  Numbers points;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) points.insert(points.end(), &rows[3 * (i * n + j)], &rows[3 * (i * n + j)] + 3);
  }
  Surface result;
  run.time("s1537", line.size() * line.size(), [&] {
    SISLSurf* made = nullptr;
    int status = 0;
    s1537(points.data(), n, n, 3, line.data(), line.data(), 0, 0, 0, 0, 4, 4, 1, 1, &made, &status);
    require(status);
    result.reset(made);
  });
  std::array<double, 3> row{};
  std::array<double, 3> normal{};
  run.keep("s1537", line.size() * line.size(), 3, [&](std::size_t i) {
    std::array<double, 2> at = {line[i / line.size()], line[i % line.size()]};
    int left_u = 0;
    int left_v = 0;
    int status = 0;
    s1421(result.get(), 0, at.data(), &left_u, &left_v, row.data(), normal.data(), &status);
    return row.data();
  }, 7);
}

void many_patches(const Run& run) {
  const std::vector<Surface> patches = teapot(run);
  Numbers line = run.input("patch_grid");
  const std::size_t n = line.size();
  Numbers points(9 * n * n * patches.size());
  Numbers normals(3 * n * n * patches.size());
  run.time("s1506", n * n * patches.size(), [&] {
    for (std::size_t k = 0; k < patches.size(); ++k) {
      int status = 0;
      s1506(patches[k].get(), 1, static_cast<int>(n), line.data(), static_cast<int>(n), line.data(),
            &points[9 * n * n * k], &normals[3 * n * n * k], &status);
      require(status);
    }
  });
  std::array<double, 6> row{};
  run.keep("s1506", n * n * patches.size(), 6, [&](std::size_t i) {
    const std::size_t in_patch = i % (n * n);
    const std::size_t at = i - in_patch + in_patch % n * n + in_patch / n;
    std::copy_n(&points[9 * at], 3, row.data());
    std::copy_n(&normals[3 * at], 3, row.data() + 3);
    return row.data();
  });
}

void length(const Run& run) {
  const Curve curve = rational_curve(run);
  double result = 0;
  run.time("s1240", 1, [&] {
    int status = 0;
    s1240(curve.get(), 1e-9, &result, &status);
    require(status);
  });
  run.keep("s1240", 1, 1, [&](std::size_t) { return &result; });
}

void crossings(const Run& run) {
  const Curve a = zigzag(run, "zigzag_a");
  const Curve b = zigzag(run, "zigzag_b");
  int points = 0;
  int status = 0;
  Numbers found;
  const auto work = [&] {
    int curves = 0;
    double* of_a = nullptr;
    double* of_b = nullptr;
    SISLIntcurve** stretches = nullptr;
    s1857(a.get(), b.get(), 1e-12, 1e-9, &points, &of_a, &of_b, &curves, &stretches, &status);
    found.assign(of_a, of_a + points);
    std::free(of_a);
    std::free(of_b);
    if (stretches) freeIntcrvlist(stretches, curves);
  };
  work();
  run.time("s1857", 1, work, std::to_string(points) + " crossings");
  require(status);
  std::sort(found.begin(), found.end());
  run.keep("s1857", found.size(), 1, [&](std::size_t i) { return &found[i]; }, 1);
}

void sections(const Run& run) {
  const Surface a = waves(run, "waves_a");
  const Surface b = waves(run, "waves_b");
  int curves = 0;
  int made = 0;
  int status = 0;
  const auto work = [&] {
    int points = 0;
    double* of_a = nullptr;
    double* of_b = nullptr;
    SISLIntcurve** found = nullptr;
    s1859(a.get(), b.get(), 1e-12, 1e-6, &points, &of_a, &of_b, &curves, &found, &status);
    made = 0;
    for (int i = 0; i < curves; ++i) {
      s1310(a.get(), b.get(), found[i], 1e-5, 0.05, 3, 0, &status);
      if (found[i]->pgeom) made += found[i]->pgeom->in;
    }
    std::free(of_a);
    std::free(of_b);
    if (found) freeIntcrvlist(found, curves);
  };
  work();
  run.time("s1859, s1310", 1, work,
           std::to_string(curves) + " curves, " + std::to_string(made) + " control points, within 1e-5");
  require(status);
}

const benchmarks::Workloads kWorkloads = {
    {"W1 sorted", sorted_points},
    {"W1 random", [](const Run& run) { evaluate_each(run, rational_curve(run), run.input("random"), 0); }},
    {"W2", [](const Run& run) { evaluate_each(run, rational_curve(run), run.input("sorted"), 2); }},
    {"W3 points", [](const Run& run) { grid(run, false); }},
    {"W3 normals", [](const Run& run) { grid(run, true); }},
    {"W4", scattered_pairs},
    {"W5 degree 11", [](const Run& run) { evaluate_each(run, bezier_curve(run, 11), run.input("sorted"), 0); }},
    {"W5 degree 25", [](const Run& run) { evaluate_each(run, bezier_curve(run, 25), run.input("sorted"), 0); }},
    {"W6 refine",
     [](const Run& run) {
       Numbers knots = run.input("inserted");
       verb(run, "s1018", knots.size(), [&](SISLCurve* curve, SISLCurve** made, int* status) {
         s1018(curve, knots.data(), static_cast<int>(knots.size()), made, status);
       });
     }},
    {"W6 elevate",
     [](const Run& run) {
       verb(run, "s1750", 1000,
            [](SISLCurve* curve, SISLCurve** made, int* status) { s1750(curve, 6, made, status); });
     }},
    {"W6 Beziers",
     [](const Run& run) {
       verb(run, "s1730", 997, [](SISLCurve* curve, SISLCurve** made, int* status) { s1730(curve, made, status); });
     }},
    {"W7 curve 1e3", [](const Run& run) { interpolated_curve(run, 1000); }},
    {"W7 curve 1e4", [](const Run& run) { interpolated_curve(run, 10000); }},
    {"W7 curve 1e5", [](const Run& run) { interpolated_curve(run, 100000); }},
    {"W7 surface", interpolated_surface},
    {"W9 curves", crossings},
    {"W9 surfaces", sections},
    {"W10", many_patches},
    {"W11", length},
};

}  // namespace

int main(int argc, char** argv) { return benchmarks::drive(argc, argv, "SISL", kWorkloads); }
