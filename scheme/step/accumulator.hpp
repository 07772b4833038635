#pragma once
/// Sums over millions of steps.
#include <cmath>

namespace g27 {

/// Sum that loses nothing to round-off over millions of steps (Neumaier).
struct Accumulator {
  double sum = 0, lost = 0;
  void add(double v) noexcept {
    double const t = sum + v;
    lost += std::fabs(sum) >= std::fabs(v) ? (sum - t) + v : (v - t) + sum;
    sum = t;
  }
  [[nodiscard]] double value() const noexcept { return sum + lost; }
};
struct Accumulators {
  Accumulator mass, momentum, energy;
  void add(double m, double q, double e) noexcept { mass.add(m), momentum.add(q), energy.add(e); }
};

}  // namespace g27
