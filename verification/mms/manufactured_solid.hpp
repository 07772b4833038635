#pragma once
/// Manufactured solutions of elastic solids in one, two and three dimensions.
///
/// Any smooth fields solve the equations of hypoelastic solids,
///   rho_t + (rho u_j),j = 0,   (rho u_i)_t + (rho u_i u_j - s_ij),j = 0,   E_t + (E u_j - u_i s_ij),j = 0,
///   (rho S)_t + (rho S u_j),j = rho (W S - S W + 2 mu dev D),   s = -p I + S,
/// with sources on the right, which automatic differentiation gives to round-off (Roache, J. Fluids Eng. 124 (2002) 4).
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "scheme/step/gauss.hpp"
#include "verification/exact/solid.hpp"
#include "verification/mms/dual.hpp"

namespace g27 {

/// What fields return, of one number type: density, velocity, specific internal energy, deviator in the order of
/// Tensor6.
template <class T>
struct SolidFlow {
  T rho;
  std::array<T, 3> u;
  T e;
  std::array<T, 6> S;
};

/// D dimensions; the fields are taken at 0 in the others. Fields: callable as f(std::array<T, 3> x, T t) ->
/// SolidFlow<T> for double and for Dual; Law: one of verification/exact/solid.hpp.
template <std::size_t D, class Fields, class Law>
class ManufacturedSolid {
  static_assert(D >= 1 && D <= 3);

 public:
  ManufacturedSolid(Fields fields, Law law, double mu) : fields_(fields), law_(law), mu_(mu) {}

  [[nodiscard]] SolidPoint state(Vector3 const& x, double t) const {
    SolidFlow<double> const s = fields_(within(x), t);
    return {.rho = s.rho, .u = s.u, .p = law_.pressure(s.rho, s.e), .e = s.e, .S = s.S};
  }

  /// Mean of the conserved densities over the cell with centre x and widths h, at t.
  [[nodiscard]] SolidDensities average(Vector3 const& x, Vector3 const& h, double t) const {
    SolidDensities sum;
    each_point(x, h, average_points,
               [&](Vector3 const& at, double weight) { add(sum, weight, densities(state(at, t))); });
    return sum;
  }

  /// Source densities at a point [kg/(m^3 s), N/m^3, W/m^3, kg/m^3 Pa/s].
  [[nodiscard]] SolidDensities source(Vector3 const& x, double t) const {
    using T = Dual<D + 1>;
    std::array<T, 3> at{};
    for (std::size_t d = 0; d < D; ++d) at[d] = T::variable(x[d], d);
    SolidFlow<T> const s = fields_(at, T::variable(t, D));
    T const p = law_.pressure(s.rho, s.e);
    auto stress = [&](std::size_t i, std::size_t j) {
      return i == j ? s.S[tensor_place[i][j]] - p : s.S[tensor_place[i][j]];
    };
    T const total = s.rho * (s.e + 0.5 * (s.u[0] * s.u[0] + s.u[1] * s.u[1] + s.u[2] * s.u[2]));
    SolidDensities out;
    out.mass = s.rho.d[D];
    out.energy = total.d[D];
    for (std::size_t i = 0; i < 3; ++i) out.momentum[i] = (s.rho * s.u[i]).d[D];
    for (std::size_t c = 0; c < 6; ++c) out.rho_S[c] = (s.rho * s.S[c]).d[D];
    for (std::size_t d = 0; d < D; ++d) {
      T const mass_flux = s.rho * s.u[d];
      T energy_flux = total * s.u[d];
      for (std::size_t i = 0; i < 3; ++i) {
        energy_flux = energy_flux - s.u[i] * stress(i, d);
        out.momentum[i] += (mass_flux * s.u[i] - stress(i, d)).d[d];
      }
      out.mass += mass_flux.d[d];
      out.energy += energy_flux.d[d];
      for (std::size_t c = 0; c < 6; ++c) out.rho_S[c] += (mass_flux * s.S[c]).d[d];
    }
    Tensor6 const rate = deviator_rate(s);
    for (std::size_t c = 0; c < 6; ++c) out.rho_S[c] -= s.rho.value * rate[c];
    return out;
  }

  /// Mean source over the cell with centre x and widths h, and over the step [t, t + dt]: cubics in space and time
  /// exactly, from the two points on each of the n = D + 1 axes at sqrt(n/12) widths from the middle (as Stroud,
  /// Approximate Calculation of Multiple Integrals, 1971, C_n: 3-1, turned onto the axes). Off by O(h^4).
  [[nodiscard]] SolidDensities mean_source(Vector3 const& x, Vector3 const& h, double t, double dt) const {
    SolidDensities sum;
    double constexpr n = D + 1;
    double const weight = 0.5 / n, reach = std::sqrt(n / 12.0), middle = t + 0.5 * dt;
    for (double side : {-reach, reach}) {
      for (std::size_t d = 0; d < D; ++d) {
        Vector3 at = x;
        at[d] += side * h[d];
        add(sum, weight, source(at, middle));
      }
      add(sum, weight, source(x, middle + side * dt));
    }
    return sum;
  }

  /// d/dt of rho, u, p, e and S that the source alone causes: the chain rule through p(rho, e).
  [[nodiscard]] SolidPoint primitive_rate(Vector3 const& x, double t) const {
    using T = Dual<2>;
    SolidPoint const q = state(x, t);
    SolidDensities const s = source(x, t);
    SolidPoint rate;
    rate.rho = s.mass;
    double internal = s.energy;  // source of rho e
    for (std::size_t i = 0; i < 3; ++i) {
      rate.u[i] = (s.momentum[i] - q.u[i] * s.mass) / q.rho;
      internal += q.u[i] * (0.5 * q.u[i] * s.mass - s.momentum[i]);
    }
    rate.e = (internal - q.e * s.mass) / q.rho;
    T const p = law_.pressure(T::variable(q.rho, 0), T::variable(q.e, 1));
    rate.p = p.d[0] * rate.rho + p.d[1] * rate.e;
    for (std::size_t c = 0; c < 6; ++c) rate.S[c] = (s.rho_S[c] - q.S[c] * s.mass) / q.rho;
    return rate;
  }

 private:
  static Vector3 within(Vector3 const& x) { return {x[0], D > 1 ? x[1] : 0, D > 2 ? x[2] : 0}; }

  /// W S - S W + 2 mu dev D.
  template <class T>
  [[nodiscard]] Tensor6 deviator_rate(SolidFlow<T> const& s) const {
    double L[3][3] = {};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t d = 0; d < D; ++d) L[i][d] = s.u[i].d[d];
    double const expansion = (L[0][0] + L[1][1] + L[2][2]) / 3;
    Tensor6 out;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i; j < 3; ++j) {
        double rate = mu_ * (L[i][j] + L[j][i]) - (i == j ? 2 * mu_ * expansion : 0);
        for (std::size_t k = 0; k < 3; ++k) {
          rate += 0.5 * (L[i][k] - L[k][i]) * s.S[tensor_place[k][j]].value;
          rate -= 0.5 * s.S[tensor_place[i][k]].value * (L[k][j] - L[j][k]);
        }
        out[tensor_place[i][j]] = rate;
      }
    }
    return out;
  }

  static void add(SolidDensities& sum, double weight, SolidDensities const& q) {
    sum.mass += weight * q.mass, sum.energy += weight * q.energy;
    for (std::size_t i = 0; i < 3; ++i) sum.momentum[i] += weight * q.momentum[i];
    for (std::size_t c = 0; c < 6; ++c) sum.rho_S[c] += weight * q.rho_S[c];
  }

  /// f(point, weight) at `n` Gauss points a direction; the weights sum to 1.
  template <class F>
  static void each_point(Vector3 const& x, Vector3 const& h, int n, F const& f) {
    auto const gauss = gauss_points(n);
    auto const rule = std::span(gauss).first(static_cast<std::size_t>(n));
    GaussPoint const centre{0, 2};
    auto const rule_y = D > 1 ? rule : std::span(&centre, 1), rule_z = D > 2 ? rule : std::span(&centre, 1);
    for (GaussPoint const& c : rule_z) {
      for (GaussPoint const& b : rule_y) {
        for (GaussPoint const& a : rule) {
          f(Vector3{x[0] + 0.5 * h[0] * a.x, x[1] + 0.5 * h[1] * b.x, x[2] + 0.5 * h[2] * c.x},
            0.125 * a.weight * b.weight * c.weight);
        }
      }
    }
  }

  static constexpr int average_points = 4;  ///< Gauss points a direction

  Fields fields_;
  Law law_;
  double mu_;
};

/// Fields of period `length` along every axis, in which all components vary and move: waves of one wavelength a period,
/// one direction and phase each, around a uniform state.
struct PeriodicSolid {
  double length = 1, frequency = 1;       ///< [m], [Hz]
  double rho = 7800, density_wave = 0.1;  ///< the latter relative
  Vector3 u{};
  double velocity_wave = 100;       ///< [m/s]
  double e = 0, energy_wave = 1e5;  ///< [J/kg]
  Tensor6 S{};                      ///< its trace is left out: Szz = -Sxx - Syy
  double stress_wave = 1e9;         ///< [Pa]

  template <class T>
  SolidFlow<T> operator()(std::array<T, 3> const& x, T const& t) const {
    using std::cos, std::sin;
    double const k = 2 * std::numbers::pi / length, w = 2 * std::numbers::pi * frequency;
    T const X = k * x[0], Y = k * x[1], Z = k * x[2], time = w * t;
    SolidFlow<T> out;
    out.rho = rho * (1.0 + density_wave * sin(X + Y - Z - time + 0.3));
    out.u = {u[0] + velocity_wave * sin(X - Y + Z + time + 0.7), u[1] + 0.8 * velocity_wave * cos(X + Z - time - 0.4),
             u[2] - 0.6 * velocity_wave * sin(X + Y + time + 1.1)};
    out.e = e + energy_wave * cos(X - Z + time - 0.9);
    auto stress = [&](std::size_t c, T const& wave) { return S[c] + stress_wave * wave; };
    out.S[0] = stress(0, sin(X + Y + Z - time + 0.2));
    out.S[1] = stress(1, 0.7 * cos(X - Y + time + 0.5));
    out.S[2] = -(out.S[0] + out.S[1]);
    out.S[3] = stress(3, 0.9 * sin(X - Z - time - 0.8));
    out.S[4] = stress(4, -0.5 * cos(X + Y + time + 1.3));
    out.S[5] = stress(5, 0.6 * sin(X - Y - Z + time - 0.1));
    return out;
  }
};

}  // namespace g27
