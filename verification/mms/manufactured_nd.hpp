#pragma once
/// Manufactured solutions of gas dynamics in two and three dimensions.
///
/// Any smooth fields solve the Euler equations with the source S = U_t + div F(U), which automatic differentiation
/// gives to round-off (Roache, J. Fluids Eng. 124 (2002) 4).
#include <array>
#include <cmath>
#include <span>

#include "scheme/step/gas_grid_options.hpp"
#include "scheme/step/gauss.hpp"
#include "verification/mms/dual.hpp"

namespace g27 {

/// What fields return: density, velocity, pressure of one number type.
template <class T>
struct FlowOf {
  T rho;
  std::array<T, 3> u;
  T p;
};

/// D dimensions: 2 or 3; the fields are taken at z = 0 in two. Fields: callable as f(std::array<T, 3> x, T t) ->
/// FlowOf<T> for double and for Dual; Law: one of verification/exact/eos.hpp.
template <std::size_t D, class Fields, class Law>
class ManufacturedNd {
 public:
  ManufacturedNd(Fields fields, Law law) : fields_(fields), law_(law) {}

  [[nodiscard]] GasPoint state(Vec3 const& x, double t) const {
    FlowOf<double> const s = fields_(within(x), t);
    return {s.rho, s.u, s.p};
  }

  /// Mean of the conserved densities over the cell with centre x and widths h, at t.
  [[nodiscard]] GasDensities average(Vec3 const& x, Vec3 const& h, double t) const {
    GasDensities sum{};
    each_point(x, h, average_points, [&](Vec3 const& at, double weight) {
      GasPoint const s = state(at, t);
      double const kinetic = 0.5 * (s.u[0] * s.u[0] + s.u[1] * s.u[1] + s.u[2] * s.u[2]);
      add(sum, weight * s.rho, {1, s.u, law_.energy(s.rho, s.p) + kinetic});
    });
    return sum;
  }

  /// Source densities at a point [kg/(m^3 s), N/m^3, W/m^3].
  [[nodiscard]] GasDensities source(Vec3 const& x, double t) const {
    using T = Dual<D + 1>;
    std::array<T, 3> at{};
    for (std::size_t d = 0; d < D; ++d) at[d] = T::variable(x[d], d);
    FlowOf<T> const s = fields_(at, T::variable(t, D));
    T const energy = s.rho * (law_.energy(s.rho, s.p) + 0.5 * (s.u[0] * s.u[0] + s.u[1] * s.u[1] + s.u[2] * s.u[2]));
    GasDensities out{s.rho.d[D], {}, energy.d[D]};
    for (std::size_t k = 0; k < 3; ++k) out.momentum[k] = (s.rho * s.u[k]).d[D];
    for (std::size_t d = 0; d < D; ++d) {
      T const mass_flux = s.rho * s.u[d];
      out.mass += mass_flux.d[d];
      out.energy += ((energy + s.p) * s.u[d]).d[d];
      for (std::size_t k = 0; k < 3; ++k) out.momentum[k] += (mass_flux * s.u[k]).d[d];
      out.momentum[d] += s.p.d[d];
    }
    return out;
  }

  /// Mean source over the cell with centre x and widths h, and over the step [t, t + dt]: cubics in space and time
  /// exactly, from the two points on each of the n = D + 1 axes at sqrt(n/12) widths from the middle (as Stroud,
  /// Approximate Calculation of Multiple Integrals, 1971, C_n: 3-1, turned onto the axes). Off by O(h^4).
  [[nodiscard]] GasDensities mean_source(Vec3 const& x, Vec3 const& h, double t, double dt) const {
    GasDensities sum{};
    double constexpr n = D + 1;
    double const weight = 0.5 / n, reach = std::sqrt(n / 12.0), middle = t + 0.5 * dt;
    for (double side : {-reach, reach}) {
      for (std::size_t d = 0; d < D; ++d) {
        Vec3 at = x;
        at[d] += side * h[d];
        add(sum, weight, source(at, middle));
      }
      add(sum, weight, source(x, middle + side * dt));
    }
    return sum;
  }

  /// d/dt of the primitive variables that the source alone causes: the chain rule through e(rho, p).
  [[nodiscard]] GasPoint primitive_rate(Vec3 const& x, double t) const {
    using T = Dual<2>;
    GasPoint const q = state(x, t);
    GasDensities const s = source(x, t);
    T const e = law_.energy(T::variable(q.rho, 0), T::variable(q.p, 1));
    GasPoint rate{s.mass, {}, 0};
    double internal = s.energy;  // source of rho e
    for (std::size_t d = 0; d < 3; ++d) {
      rate.u[d] = (s.momentum[d] - q.u[d] * s.mass) / q.rho;
      internal += q.u[d] * (0.5 * q.u[d] * s.mass - s.momentum[d]);
    }
    double const e_rate = (internal - e.value * s.mass) / q.rho;
    rate.p = (e_rate - e.d[0] * s.mass) / e.d[1];
    return rate;
  }

  /// As the scheme takes it; holds a copy of the fields.
  [[nodiscard]] GridSource grid_source() const {
    return {.mean = [self = *this](Vec3 const& x, Vec3 const& h, double t,
                                   double dt) { return self.mean_source(x, h, t, dt); },
            .primitive_rate = [self = *this](Vec3 const& x, double t) { return self.primitive_rate(x, t); }};
  }

 private:
  static Vec3 within(Vec3 const& x) { return {x[0], x[1], D > 2 ? x[2] : 0}; }

  static void add(GasDensities& sum, double weight, GasDensities const& q) {
    sum.mass += weight * q.mass, sum.energy += weight * q.energy;
    for (std::size_t d = 0; d < 3; ++d) sum.momentum[d] += weight * q.momentum[d];
  }

  /// f(point, weight) at `n` Gauss points a direction; the weights sum to 1.
  template <class F>
  static void each_point(Vec3 const& x, Vec3 const& h, int n, F const& f) {
    auto const gauss = gauss_points(n);
    auto const rule = std::span(gauss).first(static_cast<std::size_t>(n));
    GaussPoint const centre{0, 2};
    auto const rule_z = D > 2 ? rule : std::span(&centre, 1);
    for (GaussPoint const& c : rule_z) {
      for (GaussPoint const& b : rule) {
        for (GaussPoint const& a : rule) {
          f(Vec3{x[0] + 0.5 * h[0] * a.x, x[1] + 0.5 * h[1] * b.x, x[2] + 0.5 * h[2] * c.x},
            0.125 * a.weight * b.weight * c.weight);
        }
      }
    }
  }

  static constexpr int average_points = 4;  ///< Gauss points a direction

  Fields fields_;
  Law law_;
};

}  // namespace g27
