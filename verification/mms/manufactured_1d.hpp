#pragma once
/// Manufactured solutions of one-dimensional gas dynamics, planar, cylindrical or spherical.
///
/// Any smooth fields solve the Euler equations with the source S = U_t + F(U)_x + (symmetry/x) (rho u, rho u^2,
/// (E + p) u), which automatic differentiation gives to round-off (Roache, J. Fluids Eng. 124 (2002) 4).
#include <cmath>

#include "scheme/step/gas_options.hpp"
#include "verification/exact/cell_average.hpp"
#include "verification/mms/dual.hpp"
#include "verification/mms/gauss.hpp"

namespace g27 {

/// Density, Velocity, Pressure: callable as f(x, t) for double and for Dual; Law: one of verification/exact/eos.hpp.
template <class Density, class Velocity, class Pressure, class Law>
class Manufactured1d {
 public:
  Manufactured1d(Density rho, Velocity u, Pressure p, Law law, Symmetry symmetry = Symmetry::planar)
      : rho_(rho), u_(u), p_(p), law_(law), symmetry_(symmetry) {}

  [[nodiscard]] GasState<> state(double x, double t) const { return {rho_(x, t), u_(x, t), p_(x, t)}; }

  /// Mean of the conserved densities over [x0, x1] at t, weighted with the cell's measure.
  [[nodiscard]] GasConserved<> average(double x0, double x1, double t) const {
    return cell_average(
        law_, [&](double x) { return state(x, t); }, x0, x1, static_cast<int>(symmetry_));
  }

  /// Source densities at a point, x > 0 in curved symmetry [kg/(m^3 s), N/m^3, W/m^3].
  [[nodiscard]] GasConserved<> source(double x, double t) const {
    using D = Dual<2>;
    D const X = D::variable(x, 0), T = D::variable(t, 1);
    D const rho = rho_(X, T), u = u_(X, T), p = p_(X, T);
    D const energy = rho * (law_.energy(rho, p) + 0.5 * u * u);
    D const mass_flux = rho * u, momentum_flux = mass_flux * u, energy_flux = (energy + p) * u;
    int const n = static_cast<int>(symmetry_);
    double const spread = n == 0 ? 0 : n / x;
    return {rho.d[1] + mass_flux.d[0] + spread * mass_flux.value,
            mass_flux.d[1] + momentum_flux.d[0] + p.d[0] + spread * momentum_flux.value,
            energy.d[1] + energy_flux.d[0] + spread * energy_flux.value};
  }

  /// Mean source over the cell [x0, x1], weighted with its measure, and over the step [t, t + dt]: five Gauss points in
  /// space and in time.
  [[nodiscard]] GasConserved<> mean_source(double x0, double x1, double t, double dt) const {
    GasConserved<> sum{0, 0, 0};
    double measure = 0;
    for (std::size_t i = 0; i < gauss5_node.size(); ++i) {
      double const x = x0 + (x1 - x0) * gauss5_node[i];
      double const w = gauss5_weight[i] * std::pow(x, static_cast<int>(symmetry_));
      measure += w;
      for (std::size_t j = 0; j < gauss5_node.size(); ++j) {
        GasConserved<> const s = source(x, t + dt * gauss5_node[j]);
        sum.mass += w * gauss5_weight[j] * s.mass;
        sum.momentum += w * gauss5_weight[j] * s.momentum;
        sum.energy += w * gauss5_weight[j] * s.energy;
      }
    }
    return {sum.mass / measure, sum.momentum / measure, sum.energy / measure};
  }

  /// d/dt of (rho, u, p) that the source alone causes: the chain rule through e(rho, p).
  [[nodiscard]] GasState<> primitive_rate(double x, double t) const {
    using D = Dual<2>;
    GasState<> const q = state(x, t);
    GasConserved<> const s = source(x, t);
    D const e = law_.energy(D::variable(q.rho, 0), D::variable(q.p, 1));
    double const internal = s.energy - q.u * s.momentum + 0.5 * q.u * q.u * s.mass;  // of rho e
    double const e_rate = (internal - e.value * s.mass) / q.rho;
    return {s.mass, (s.momentum - q.u * s.mass) / q.rho, (e_rate - e.d[0] * s.mass) / e.d[1]};
  }

  /// As the scheme takes it; holds a copy of the fields.
  [[nodiscard]] GasSource gas_source() const {
    return {
        .mean = [self = *this](double x0, double x1, double t, double dt) { return self.mean_source(x0, x1, t, dt); },
        .primitive_rate = [self = *this](double x, double t) { return self.primitive_rate(x, t); }};
  }

 private:
  Density rho_;
  Velocity u_;
  Pressure p_;
  Law law_;
  Symmetry symmetry_;
};

}  // namespace g27
