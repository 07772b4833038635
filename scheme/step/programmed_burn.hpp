#pragma once
/// Detonation by programmed burn: the front runs ahead at a given speed whatever the flow does, and a cell releases its
/// energy while the front crosses it.
///
/// e = e_th + (1 - lambda) q with p = p(rho, e_th): the scheme computes e_th, the flux of (1 - lambda) q rides with the
/// mass, and what a cell loses of it becomes e_th. With lambda = clamp(1/2 + D (t - t_l)/(2 h)), t_l the time at which
/// the front reaches the cell's centre, the front is two cells wide. Faces whose stencil holds unburnt explosive are of
/// first order.
#include <algorithm>
#include <array>
#include <functional>
#include <limits>

namespace g27 {

struct ProgrammedBurn {
  double energy = 0;  ///< q, released by the unit of mass [J/kg]
  double speed = 0;   ///< D [m/s]
  /// Time at which the front reaches a point [s], of a line (x, 0, 0); `no_explosive` where there is none. Called from
  /// many threads at once.
  std::function<double(std::array<double, 3> const& x)> lighting{};

  static constexpr double no_explosive = -std::numeric_limits<double>::infinity();

  [[nodiscard]] bool there() const noexcept { return static_cast<bool>(lighting); }
  /// Unburnt fraction at t of a cell of width h that the front reaches at `lit`. At ignition, t = 0, it is 1.
  [[nodiscard]] double unburnt(double lit, double t, double h) const noexcept {
    if (t <= 0 && lit >= 0) return 1.0;
    return std::clamp(0.5 - 0.5 * speed * (t - lit) / h, 0.0, 1.0);
  }
  /// Half of the time in which the front crosses such a cell [s].
  [[nodiscard]] double crossing(double h) const noexcept { return h / speed; }
};

}  // namespace g27
