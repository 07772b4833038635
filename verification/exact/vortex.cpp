#include "verification/exact/vortex.hpp"

#include <cmath>

namespace g27 {

PlaneState Vortex::at(double x, double y, double t) const {
  double const dx = (x - x0 - u0 * t) / radius, dy = (y - y0 - v0 * t) / radius;
  double const turn = strength * std::exp(0.5 * (1 - dx * dx - dy * dy));  // v/(r/a)
  double const c0_squared = gamma * p0 / rho0;
  double const ratio = 1 - 0.5 * (gamma - 1) * turn * turn / c0_squared;  // of c^2
  return {rho0 * std::pow(ratio, 1 / (gamma - 1)), u0 - turn * dy, v0 + turn * dx,
          p0 * std::pow(ratio, gamma / (gamma - 1))};
}

}  // namespace g27
