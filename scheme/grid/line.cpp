#include "scheme/grid/line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace g27 {

double measure_between(Symmetry symmetry, double x0, double x1) noexcept {
  return swept_area(symmetry, x0, x1) * (x1 - x0);
}

double centroid_between(Symmetry symmetry, double x0, double x1) noexcept {
  double const centre = 0.5 * (x0 + x1), h = x1 - x0;
  if (symmetry == Symmetry::planar) return centre;
  double const bend = symmetry == Symmetry::cylindrical ? 1.0 : 2.0 * centre;  // of the area at a face, by its position
  return centre + bend * h * h / (12.0 * swept_area(symmetry, x0, x1));
}

double swept_area(Symmetry symmetry, double x0, double x1) noexcept {
  switch (symmetry) {
    case Symmetry::planar:
      return 1.0;
    case Symmetry::cylindrical:
      return 0.5 * (x0 + x1);
    case Symmetry::spherical:
      return (x0 * x0 + x0 * x1 + x1 * x1) / 3.0;
  }
  return 1.0;
}

Line::Line(std::vector<double> faces, Symmetry symmetry_in, bool periodic, bool fixed)
    : x(std::move(faces)), x_initial(x), symmetry(symmetry_in), periodic_(periodic) {
  std::size_t const n = cells();
  for (Padded* a : {&h, &inv_h, &inv_pair, &inv_triple, &center_, &w, &area, &measure, &inv_measure_new}) {
    *a = Padded(n + 1, 1.0);
  }
  for (std::size_t f = 0; f <= n; ++f) w[static_cast<std::ptrdiff_t>(f)] = 0.0;
  double const mean = (x.back() - x.front()) / static_cast<double>(n);
  uniform_ = fixed;
  for (std::size_t i = 0; i < n && uniform_; ++i) uniform_ = std::fabs(x[i + 1] - x[i] - mean) <= 1e-9 * mean;
  refresh();
  if (uniform_) {
    // one width for all, so that the uniform kernels and everything else see the same number
    for (std::ptrdiff_t i = -2; i < static_cast<std::ptrdiff_t>(n) + 2; ++i) {
      h[i] = mean, inv_h[i] = 1.0 / mean, inv_pair[i] = 0.5 / mean, inv_triple[i] = 1.0 / (3.0 * mean);
    }
  }
  sweep(0.0);
}

void Line::refresh() {
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(cells());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    std::size_t const k = static_cast<std::size_t>(i);
    h[i] = x[k + 1] - x[k];
    center_[i] = 0.5 * (x[k + 1] + x[k]);
    measure[i] = measure_between(symmetry, x[k], x[k + 1]);
  }
  for (std::ptrdiff_t g = 0; g < 2; ++g) {
    h[-1 - g] = periodic_ ? h[n - 1 - g] : h[g];
    h[n + g] = periodic_ ? h[g] : h[n - 1 - g];
  }
  center_[-1] = x.front() - 0.5 * h[-1], center_[-2] = x.front() - h[-1] - 0.5 * h[-2];
  center_[n] = x.back() + 0.5 * h[n], center_[n + 1] = x.back() + h[n] + 0.5 * h[n + 1];
  for (std::ptrdiff_t i = -2; i < n + 2; ++i) {
    inv_h[i] = 1.0 / h[i];
    if (i < n + 1) inv_pair[i] = 1.0 / (h[i] + h[i + 1]);
    if (i > -2 && i < n + 1) inv_triple[i] = 1.0 / (h[i - 1] + h[i] + h[i + 1]);
  }
}

bool Line::sweep(double dt) {
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(cells());
  for (std::ptrdiff_t f = 0; f <= n; ++f) {
    double const x0 = x[static_cast<std::size_t>(f)];
    area[f] = swept_area(symmetry, x0, x0 + dt * w[f]);
  }
  bool sound = true;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    double const change = dt * (area[i + 1] * w[i + 1] - area[i] * w[i]);
    sound = sound && dt * (w[i + 1] - w[i]) > -0.5 * h[i];
    inv_measure_new[i] = 1.0 / (measure[i] + change);
  }
  return sound;
}

void Line::advance(double dt) {
  for (std::size_t f = 0; f < x.size(); ++f) x[f] += dt * w[static_cast<std::ptrdiff_t>(f)];
  refresh();
}

void Line::set_cell_feet(bool printed) {
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(cells());
  for (int side = 0; side < 2; ++side) {
    foot_shift[side] = Padded(cells() + 1, 0.0);
    foot_factor[side] = Padded(cells() + 1, 1.0);
    for (std::ptrdiff_t f = 0; f <= n; ++f) {
      std::ptrdiff_t const i = f - 1 + side;
      double const first = h[i + 1] - h[i - 1], second = h[i + 1] + h[i - 1] - 2.0 * h[i];
      // as printed: the differences halved and the quotient's q as a factor; re-derived: OG (3.7) + (3.9)
      foot_shift[side][f] = printed ? 0.5 * first + 0.125 * second : first / 6.0;
      foot_factor[side][f] = printed ? 1.0 + second / (4.0 * h[i]) : 1.0 / (1.0 + second / (3.0 * h[i]));
    }
  }
}

}  // namespace g27
