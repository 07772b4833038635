#include "scheme/step/solid_state.hpp"

#include <algorithm>
#include <cmath>

namespace g27 {

SolidPoint primitive_of(AnySolidEos const& any, SolidVector const& q) noexcept {
  SolidPoint s{.rho = q[0], .u = {q[1] / q[0], q[2] / q[0], q[3] / q[0]}, .p = 0, .S = {}, .ep = q[11] / q[0]};
  for (std::size_t k = 0; k < 6; ++k) s.S[k] = q[5 + k] / q[0];
  s.p = std::visit([&](auto const& eos) { return eos.pressure(q[0], internal_energy(q)); }, any);
  return s;
}

SolidVector conserved_of(AnySolidEos const& any, SolidPoint const& s) noexcept {
  double const e = std::visit([&](auto const& eos) { return eos.energy(s.rho, s.p); }, any);
  double kinetic = 0;
  for (double u : s.u) kinetic += 0.5 * s.rho * u * u;
  SolidVector q{s.rho, s.rho * s.u[0], s.rho * s.u[1], s.rho * s.u[2], s.rho * e + kinetic};
  for (std::size_t k = 0; k < 6; ++k) q[5 + k] = s.rho * s.S[k];
  q[11] = s.rho * s.ep;
  return q;
}

double solid_field(SolidGrid::Field which, SolidPoint const& s, double energy) noexcept {
  if (which == SolidGrid::Field::mises) return std::sqrt(mises_squared(s.S.data()));
  std::array<double, 13> const all{s.rho,  s.u[0], s.u[1], s.u[2], s.p,  s.S[0], s.S[1],
                                   s.S[2], s.S[3], s.S[4], s.S[5], s.ep, energy};
  return all[static_cast<std::size_t>(which)];
}

SolidLedger solid_ledger(std::array<Accumulator, 5> const& initial, std::array<Accumulator, 5> const& total,
                         std::array<Accumulator, 5> const& boundary, std::array<Accumulator, 5> const& source,
                         std::array<double, 5> const& scale, std::array<double, 5> const& magnitude,
                         Accumulator const& plastic_work) noexcept {
  auto const entry = [&](std::size_t d) {
    return LedgerEntry{.initial = initial[d].value(),
                       .current = total[d].value(),
                       .through_boundary = boundary[d].value(),
                       .from_source = source[d].value(),
                       .from_floor = 0,
                       .scale = std::max(scale[d], magnitude[d])};
  };
  return {.mass = entry(0),
          .energy = entry(4),
          .momentum = {entry(1), entry(2), entry(3)},
          .plastic_work = plastic_work.value()};
}

}  // namespace g27
